//! Grids made, and read from files.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::Point3;

use super::{HEAD, MOST_HEIGHTS, Terrain};

/// Coordinates that differ by less than this part of the smallest step between columns are one column.
const SAME: f64 = 0.25;
/// Steps below this part of the whole are rounding in the file.
const ROUNDING: f64 = 1e-6;

/// The different values of sorted numbers, and the step between them.
fn steps(mut values: Vec<f64>) -> (Vec<f64>, f64) {
    values.sort_by(f64::total_cmp);
    values.dedup();
    let size = values.last().zip(values.first()).map_or(0.0, |(b, a)| b - a);
    let gaps = values.windows(2).map(|pair| pair.last().unwrap_or(&0.0) - pair.first().unwrap_or(&0.0));
    let step = gaps.filter(|gap| *gap > size * ROUNDING).fold(f64::INFINITY, f64::min);
    let step = if step.is_finite() { step } else { 1.0 };
    let mut distinct: Vec<f64> = Vec::new();
    for x in values {
        if distinct.last().is_none_or(|last| x - last > SAME * step) {
            distinct.push(x);
        }
    }
    (distinct, step)
}

/// The grid of points that stand on one, every n-th column and row of it.
fn of_points(context: &Context<'_>, points: &[Point3], every: usize) -> Result<Terrain, Message> {
    let (xs, cx) = steps(points.iter().map(|p| p.x).collect());
    let (ys, cy) = steps(points.iter().map(|p| p.y).collect());
    let count = |values: &[f64], step: f64| match (values.first(), values.last()) {
        (Some(a), Some(b)) => ((b - a) / step).round() + 1.0,
        _ => 0.0,
    };
    let (columns, rows) = (count(&xs, cx), count(&ys, cy));
    if !(columns * rows <= MOST_HEIGHTS as f64 && columns * rows >= 1.0) {
        return Err(Message::error("The points do not stand on a regular grid"));
    }
    let origin = [xs.first().copied().unwrap_or(0.0), ys.first().copied().unwrap_or(0.0)];
    let mut terrain = Terrain::flat(context, columns as usize, rows as usize, origin, [cx, cy])?;
    let mut set = vec![false; terrain.heights.len()];
    for p in points {
        let (column, row) =
            (((p.x - origin[0]) / cx).round() as usize, ((p.y - origin[1]) / cy).round() as usize);
        let place = column * terrain.rows + row;
        if let (Some(height), Some(set)) = (terrain.heights.get_mut(place), set.get_mut(place)) {
            (*height, *set) = (p.z, true);
        }
    }
    let missing = set.iter().filter(|set| !**set).count();
    if missing > 0 {
        context.warn(format!("{missing} places of the grid have no point: they are at height 0"));
    }
    terrain.filtered(context, every)
}

/// How many columns and rows to step, from a port.
pub(super) fn every(n: i32) -> Result<usize, Message> {
    usize::try_from(n).ok().filter(|n| *n > 0).ok_or_else(|| Message::error("n must be at least 1"))
}

/// A grid at height 0. Stands for Docofossor's Empty Grid.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a01",
    name = "Empty Grid",
    nick = "dfEmptyGrid",
    at = "Docofossor/I-O"
)]
#[output("df", "df", "The grid, as a list of numbers.")]
fn empty_grid(
    context: &Context<'_>,
    /// The number of columns.
    #[port("nc", "nc", default = 10)]
    columns: i32,
    /// The number of rows.
    #[port("nr", "nr", default = 10)]
    rows: i32,
    /// The x coordinate of the lower left corner.
    #[port("ox", "ox", default = 0.0)]
    x: f64,
    /// The y coordinate of the lower left corner.
    #[port("oy", "oy", default = 0.0)]
    y: f64,
    /// The size of a cell along x, in units.
    #[port("cx", "cx", default = 1.0)]
    cx: f64,
    /// The size of a cell along y, in units.
    #[port("cy", "cy", default = 1.0)]
    cy: f64,
) -> Result<Vec<f64>, Message> {
    let count = |n: i32| usize::try_from(n).unwrap_or(0);
    Ok(Terrain::flat(context, count(columns), count(rows), [x, y], [cx, cy])?.list())
}

/// The grid of points that stand on a regular one along x and y. Stands for Docofossor's Import Points.
#[component(
    "89ef2439-e2bf-4176-ab30-ab9db5b40a8e",
    name = "Import Points",
    nick = "dfImportPoints",
    at = "Docofossor/I-O"
)]
#[output("df", "df", "The grid, as a list of numbers.")]
fn import_points(
    context: &Context<'_>,
    /// The points, in any order.
    #[port("pts", "pts")]
    points: List<Point3>,
) -> Result<Vec<f64>, Message> {
    let points: Vec<Point3> = points.present().filter(|p| p.is_finite()).collect();
    Ok(of_points(context, &points, 1)?.list())
}

/// The text of a file.
fn text(context: &Context<'_>, path: &str) -> Result<String, Message> {
    Ok(String::from_utf8_lossy(&context.read_file(path)?).into_owned())
}

/// Reads a grid from a text file with x, y and z of a point on each line. Stands for Docofossor's Import XYZ.
#[component(
    "0cdb2f82-662b-4c9b-bd8c-59c1e2602b9b",
    name = "Import XYZ",
    nick = "dfImportXYZ",
    at = "Docofossor/I-O"
)]
#[output("df", "df", "The grid, as a list of numbers.")]
fn import_xyz(
    context: &Context<'_>,
    /// The path of the file.
    #[port("f", "f")]
    path: Shared<str>,
    /// Every n-th column and row is kept.
    #[port("n", "n", default = 1)]
    n: i32,
    /// The x coordinate of the lower left corner in the model; that of the file when nothing is given.
    #[port("sx", "sx", optional)]
    x: Option<f64>,
    /// The y coordinate of the lower left corner in the model.
    #[port("sy", "sy", optional)]
    y: Option<f64>,
) -> Result<Vec<f64>, Message> {
    let text = text(context, &path)?;
    let mut points = Vec::new();
    let mut strange = 0_usize;
    for line in text.lines() {
        let numbers = line.split([' ', '\t', ',', ';']).filter(|word| !word.is_empty());
        let numbers: Vec<f64> = numbers.filter_map(|word| word.parse().ok()).collect();
        match numbers.as_slice() {
            [x, y, z, ..] if [x, y, z].iter().all(|x| x.is_finite()) => points.push(Point3::new(*x, *y, *z)),
            _ if line.trim().is_empty() => {}
            _ => strange += 1,
        }
    }
    if strange > 0 {
        context.warn(format!("{strange} lines have no three numbers, and were passed over"));
    }
    context.items(points.len())?;
    let mut terrain = of_points(context, &points, every(n)?)?;
    terrain.origin = [x.unwrap_or(terrain.origin[0]), y.unwrap_or(terrain.origin[1])];
    Ok(terrain.list())
}

/// Reads a grid from a file of Docofossor: its list of numbers, one on each line. Stands for Docofossor's Import DF; that numbers
/// may also stand beside each other is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a02",
    name = "Import DF",
    nick = "dfImportDF",
    at = "Docofossor/I-O"
)]
#[output("df", "df", "The grid, as a list of numbers.")]
fn import_df(
    context: &Context<'_>,
    /// The path of the file.
    #[port("f", "f")]
    path: Shared<str>,
    /// Every n-th column and row is kept.
    #[port("n", "n", default = 1)]
    n: i32,
) -> Result<Vec<f64>, Message> {
    let text = text(context, &path)?;
    let numbers: Vec<f64> =
        text.split([' ', '\t', ',', ';', '\n', '\r']).filter_map(|word| word.parse().ok()).collect();
    let [columns, rows, ox, oy, cx, cy, _, _, gx, gy, heights @ ..] = numbers.as_slice() else {
        return Err(Message::error("The file holds no terrain grid"));
    };
    let count = |x: f64| if x >= 1.0 && x <= MOST_HEIGHTS as f64 { x as usize } else { 0 };
    let mut terrain = Terrain::flat(context, count(*columns), count(*rows), [*ox, *oy], [*cx, *cy])?;
    if heights.len() != terrain.heights.len() || !heights.iter().all(|z| z.is_finite()) {
        let (found, needed) = (numbers.len().saturating_sub(HEAD), terrain.heights.len());
        return Err(Message::error(format!("The file has {found} heights for {needed} places")));
    }
    terrain.heights = heights.to_vec();
    terrain.world = [*gx, *gy];
    Ok(terrain.filtered(context, every(n)?)?.list())
}

/// Reads an ASCII grid of Esri: a head of names and numbers, then the heights row by row from the top. Places without a height
/// get the least one. Stands for Docofossor's Import ASC.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a03",
    name = "Import ASC",
    nick = "dfImportASC",
    at = "Docofossor/I-O"
)]
#[output("df", "df", "The grid, as a list of numbers.")]
fn import_asc(
    context: &Context<'_>,
    /// The path of the file.
    #[port("f", "f")]
    path: Shared<str>,
    /// Every n-th column and row is kept.
    #[port("n", "n", default = 1)]
    n: i32,
) -> Result<Vec<f64>, Message> {
    let text = text(context, &path)?;
    let mut words = text.split_ascii_whitespace().peekable();
    let mut head: std::collections::HashMap<String, f64> = std::collections::HashMap::new();
    while words.peek().is_some_and(|word| word.starts_with(|c: char| c.is_ascii_alphabetic())) {
        let name = words.next().unwrap_or_default().to_ascii_lowercase();
        let value = words.next().and_then(|word| word.parse().ok());
        head.insert(name, value.ok_or_else(|| Message::error("The head of the file is broken"))?);
    }
    let get = |name: &str| head.get(name).copied();
    let count =
        |name: &str| get(name).filter(|x| *x >= 1.0 && *x <= MOST_HEIGHTS as f64).map_or(0, |x| x as usize);
    let cell = get("cellsize").unwrap_or(0.0);
    let corner =
        |centre: &str, corner: &str| get(centre).or(get(corner).map(|x| x + cell / 2.0)).unwrap_or(0.0);
    let origin = [corner("xllcenter", "xllcorner"), corner("yllcenter", "yllcorner")];
    let mut terrain = Terrain::flat(context, count("ncols"), count("nrows"), origin, [cell, cell])?;
    let none = get("nodata_value").unwrap_or(-9999.0);
    let heights: Vec<f64> =
        words.filter_map(|word| word.parse().ok()).filter(|z: &f64| z.is_finite()).collect();
    if heights.len() != terrain.heights.len() {
        return Err(Message::error("The file has not as many heights as its head says"));
    }
    let least = heights.iter().copied().filter(|z| *z != none).fold(f64::INFINITY, f64::min);
    let least = if least.is_finite() { least } else { 0.0 };
    let (columns, rows) = (terrain.columns, terrain.rows);
    for (i, z) in heights.iter().enumerate() {
        let (column, row) = (i % columns, rows - 1 - i / columns);
        if let Some(height) = terrain.heights.get_mut(column * rows + row) {
            *height = if *z == none { least } else { *z };
        }
    }
    Ok(terrain.filtered(context, every(n)?)?.list())
}

/// Says that files are not written.
fn no_writing(context: &Context<'_>, write: Option<bool>) {
    if write == Some(true) {
        context.warn("Definitions write no files here: export the mesh of the grid instead");
    }
}

macro_rules! exports {
    ($($function:ident $guid:tt $name:tt $nick:tt;)*) => {$(
        /// Would write a grid to a file, which is not supported: definitions write no files. Stands for Docofossor's exports.
        #[component($guid, name = $name, nick = $nick, at = "Docofossor/I-O")]
        fn $function(
            context: &Context<'_>,
            /// The grid, as a list of numbers.
            #[port("df", "df")]
            _grid: List<f64>,
            /// The path of the file.
            #[port("f", "f", optional)]
            _path: Option<Shared<str>>,
            /// Whether to write; nothing is written.
            #[port("w", "w", optional)]
            write: Option<bool>,
        ) {
            no_writing(context, write);
        }
    )*};
}

exports! {
    export_xyz "024cda9a-5ff2-4e3f-861c-c73cc72c7979" "Export XYZ" "dfExportXYZ";
    export_df "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a04" "Export DF" "dfExportDF";
    export_asc "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a05" "Export ASC" "dfExportASC";
}
