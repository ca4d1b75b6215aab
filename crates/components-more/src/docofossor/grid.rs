//! Grids moved, compared, added, thinned, refined, cropped and smoothed; meshes and points of them.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::text::plain_number;
use katydid_elementary::Elementary as _;
use katydid_geometry::{Curve, Mesh, Point3};

use super::Terrain;
use super::io::every;

/// The widest kernel of a smoothing, in cells.
const MOST_RADIUS: i32 = 1000;

impl Terrain {
    /// Every n-th column and row.
    pub(super) fn filtered(&self, context: &Context<'_>, n: usize) -> Result<Self, Message> {
        if n == 1 {
            return Ok(self.clone());
        }
        let count = |all: usize| all.div_ceil(n);
        let cell = self.cell.map(|c| c * n as f64);
        let mut thin = Self::flat(context, count(self.columns), count(self.rows), self.origin, cell)?;
        thin.world = self.world;
        for i in 0..thin.heights.len() {
            let (column, row) = (i / thin.rows * n, i % thin.rows * n);
            if let Some(height) = thin.heights.get_mut(i) {
                *height = self.height(column, row);
            }
        }
        Ok(thin)
    }

    /// A part of the columns and rows.
    fn part(&self, context: &Context<'_>, columns: [usize; 2], rows: [usize; 2]) -> Result<Self, Message> {
        let origin = self.at(columns[0], rows[0]);
        let size = [columns[1] - columns[0] + 1, rows[1] - rows[0] + 1];
        let mut part = Self::flat(context, size[0], size[1], origin, self.cell)?;
        let world = |axis: usize| self.world[axis] + origin[axis] - self.origin[axis];
        part.world = [world(0), world(1)];
        for i in 0..part.heights.len() {
            let (column, row) = (i / part.rows + columns[0], i % part.rows + rows[0]);
            if let Some(height) = part.heights.get_mut(i) {
                *height = self.height(column, row);
            }
        }
        Ok(part)
    }

    /// Whether another grid has the same columns and rows.
    fn check_like(&self, other: &Self) -> Result<(), Message> {
        if (self.columns, self.rows) == (other.columns, other.rows) {
            Ok(())
        } else {
            Err(Message::error("The grids have different numbers of columns or rows"))
        }
    }

    /// Heights weighed along columns or rows; at the ends the last height goes on.
    fn blurred(&self, context: &Context<'_>, weights: &[f64], along_rows: bool) -> Result<Vec<f64>, Message> {
        let reach = weights.len() / 2;
        let mut result = Vec::with_capacity(self.heights.len());
        for column in 0..self.columns {
            context.check()?;
            for row in 0..self.rows {
                let sum = weights.iter().enumerate().map(|(k, weight)| {
                    let shift = |x: usize, count: usize| (x + k).saturating_sub(reach).min(count - 1);
                    let height = if along_rows {
                        self.height(column, shift(row, self.rows))
                    } else {
                        self.height(shift(column, self.columns), row)
                    };
                    height * weight
                });
                result.push(sum.sum());
            }
        }
        Ok(result)
    }
}

/// A mesh of quads through the heights of a grid. Stands for Docofossor's Grid Mesh.
#[component(
    "91f2ea2c-4d1a-47d3-a478-13b5204c64de",
    name = "Grid Mesh",
    nick = "dfGridMesh",
    at = "Docofossor/Geometry"
)]
#[output("m", "m", "The mesh.")]
fn grid_mesh(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
) -> Result<Shared<Mesh>, Message> {
    Terrain::of(context, &grid)?.mesh(context)
}

/// The points of a grid, column by column. Stands for Docofossor's Grid Points.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a06",
    name = "Grid Points",
    nick = "dfGridPoints",
    at = "Docofossor/Geometry"
)]
#[output("pts", "pts", "The points.")]
fn grid_points(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
) -> Result<Vec<Point3>, Message> {
    let terrain = Terrain::of(context, &grid)?;
    Ok((0..terrain.heights.len()).map(|i| terrain.point(i)).collect())
}

/// Moves a grid back to where it lies in the world. Stands for Docofossor's Grid Global.
#[component(
    "f68f5792-dea3-4485-96f5-73bd9880858d",
    name = "Grid Global",
    nick = "dfGridGlobal",
    at = "Docofossor/Grid"
)]
#[output("df", "df", "The grid, as a list of numbers.")]
fn grid_global(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
) -> Result<Vec<f64>, Message> {
    let mut terrain = Terrain::of(context, &grid)?;
    terrain.origin = terrain.world;
    Ok(terrain.list())
}

/// Moves the lower left corner of a grid; where it lies in the world is kept. Stands for Docofossor's Grid Shift.
#[component(
    "1cfe9c44-19d9-4568-ac34-dd2f6cb2887a",
    name = "Grid Shift",
    nick = "dfGridShift",
    at = "Docofossor/Grid"
)]
#[output("df", "df", "The grid, as a list of numbers.")]
fn grid_shift(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// The x coordinate of the corner.
    #[port("sx", "sx", default = 0.0)]
    x: f64,
    /// The y coordinate of the corner.
    #[port("sy", "sy", default = 0.0)]
    y: f64,
) -> Result<Vec<f64>, Message> {
    if !(x.is_finite() && y.is_finite()) {
        return Err(Message::error("The new corner is not finite"));
    }
    let mut terrain = Terrain::of(context, &grid)?;
    terrain.origin = [x, y];
    Ok(terrain.list())
}

/// What is cut and filled from one terrain to another on the same columns and rows. Stands for Docofossor's Grid Compare.
#[component(
    "c8dea669-caab-4710-97f0-010f55f27479",
    name = "Grid Compare",
    nick = "dfGridCompare",
    at = "Docofossor/Grid"
)]
#[output("cut", "cut", "The volume that is taken away, in cubic units.")]
#[output("fill", "fill", "The volume that is added.")]
#[output("balance", "balance", "What is added less what is taken away.")]
#[output("df", "df", "The grid of the differences, as a list of numbers.")]
fn grid_compare(
    context: &Context<'_>,
    /// The first grid.
    #[port("df1", "df1")]
    before: List<f64>,
    /// The second grid.
    #[port("df2", "df2")]
    after: List<f64>,
) -> Result<(f64, f64, f64, Vec<f64>), Message> {
    let (mut before, after) = (Terrain::of(context, &before)?, Terrain::of(context, &after)?);
    before.check_like(&after)?;
    let (mut cut, mut fill) = (0.0, 0.0);
    for (z, new) in before.heights.iter_mut().zip(&after.heights) {
        let change = new - *z;
        *(if change < 0.0 { &mut cut } else { &mut fill }) += change.abs() * after.cell[0] * after.cell[1];
        *z = change;
    }
    Ok((cut, fill, fill - cut, before.list()))
}

/// What a grid is: columns, rows, corners, sides of a cell, and heights from and to. Stands for Docofossor's Grid Info; the words
/// are our own.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a07",
    name = "Grid Info",
    nick = "dfGridInfo",
    at = "Docofossor/Grid"
)]
#[output("info", "info", "Lines of text.")]
fn grid_info(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
) -> Result<Vec<Shared<str>>, Message> {
    let terrain = Terrain::of(context, &grid)?;
    let least = terrain.heights.iter().copied().fold(f64::INFINITY, f64::min);
    let most = terrain.heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // Rounded as numbers are shown everywhere.
    let two = |[x, y]: [f64; 2]| format!("{}, {}", plain_number(x), plain_number(y));
    let lines = [
        format!("columns: {}", terrain.columns),
        format!("rows: {}", terrain.rows),
        format!("local origin: {}", two(terrain.origin)),
        format!("cell size: {}", two(terrain.cell)),
        format!("global origin: {}", two(terrain.world)),
        format!("heights: {} to {}", plain_number(least), plain_number(most)),
    ];
    Ok(lines.into_iter().map(Shared::from).collect())
}

/// Adds the heights of two grids on the same columns and rows. Stands for Docofossor's Grid Addition.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a08",
    name = "Grid Addition",
    nick = "dfGridAddition",
    at = "Docofossor/Grid"
)]
#[output("df", "df", "The grid, as a list of numbers.")]
fn grid_addition(
    context: &Context<'_>,
    /// The grid.
    #[port("df", "df")]
    grid: List<f64>,
    /// The grid to add.
    #[port("df_add", "df_add")]
    other: List<f64>,
) -> Result<Vec<f64>, Message> {
    let (mut terrain, other) = (Terrain::of(context, &grid)?, Terrain::of(context, &other)?);
    terrain.check_like(&other)?;
    for (z, add) in terrain.heights.iter_mut().zip(&other.heights) {
        *z += add;
    }
    Ok(terrain.list())
}

/// Every n-th column and row of a grid. Stands for Docofossor's Grid Filter.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a09",
    name = "Grid Filter",
    nick = "dfGridFilter",
    at = "Docofossor/Grid"
)]
#[output("df", "df", "The grid, as a list of numbers.")]
fn grid_filter(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// The step, at least 1.
    #[port("n", "n", default = 2)]
    n: i32,
) -> Result<Vec<f64>, Message> {
    Ok(Terrain::of(context, &grid)?.filtered(context, every(n)?)?.list())
}

/// A grid with a height between each two: twice as fine, linear between the heights. Stands for Docofossor's Grid Interpolation.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a0a",
    name = "Grid Interpolation",
    nick = "dfGridInterpolation",
    at = "Docofossor/Grid"
)]
#[output("df", "df", "The grid, as a list of numbers.")]
fn grid_interpolation(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
) -> Result<Vec<f64>, Message> {
    let terrain = Terrain::of(context, &grid)?;
    let (columns, rows) = (2 * terrain.columns - 1, 2 * terrain.rows - 1);
    let mut fine = Terrain::flat(context, columns, rows, terrain.origin, terrain.cell.map(|c| c / 2.0))?;
    fine.world = terrain.world;
    for (i, z) in fine.heights.iter_mut().enumerate() {
        let (column, row) = (i / rows, i % rows);
        let (c, r) = ([column / 2, column.div_ceil(2)], [row / 2, row.div_ceil(2)]);
        let corners = c.iter().flat_map(|c| r.iter().map(|r| terrain.height(*c, *r)));
        *z = corners.sum::<f64>() / 4.0;
    }
    Ok(fine.list())
}

/// The part of a grid inside the box round a curve. Stands for Docofossor's Grid Region.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a0b",
    name = "Grid Region",
    nick = "dfGridRegion",
    at = "Docofossor/Grid"
)]
#[output("df", "df", "The grid, as a list of numbers.")]
fn grid_region(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// The curve.
    #[port("crv", "crv")]
    curve: &Curve,
) -> Result<Vec<f64>, Message> {
    let terrain = Terrain::of(context, &grid)?;
    let bounds = curve.bounding_box();
    let range = |low: f64, high: f64, axis: usize, count: usize| {
        let number = |x: f64| (x - terrain.origin[axis]) / terrain.cell[axis];
        let (first, last) = (number(low).ceil().max(0.0), number(high).floor().min(count as f64 - 1.0));
        (first <= last).then_some([first as usize, last as usize])
    };
    let columns = range(bounds.min.x, bounds.max.x, 0, terrain.columns);
    let rows = range(bounds.min.y, bounds.max.y, 1, terrain.rows);
    match (columns, rows) {
        (Some(columns), Some(rows)) => Ok(terrain.part(context, columns, rows)?.list()),
        _ => Err(Message::error("No height of the grid lies inside the box round the curve")),
    }
}

/// Smooths a grid by weights of Gauss. Stands for Docofossor's Grid Smooth; that the deviation is half the radius is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f2a0c",
    name = "Grid Smooth",
    nick = "dfGridSmooth",
    at = "Docofossor/Grid"
)]
#[output("df", "df", "The grid, as a list of numbers.")]
fn grid_smooth(
    context: &Context<'_>,
    /// The grid, as a list of numbers.
    #[port("df", "df")]
    grid: List<f64>,
    /// How many cells the weights reach.
    #[port("rad", "rad", default = 5)]
    radius: i32,
) -> Result<Vec<f64>, Message> {
    let mut terrain = Terrain::of(context, &grid)?;
    if !(0..=MOST_RADIUS).contains(&radius) {
        return Err(Message::error(format!("The radius must be from 0 to {MOST_RADIUS}")));
    }
    if radius > 0 {
        let deviation = f64::from(radius) / 2.0;
        let raw: Vec<f64> =
            (-radius..=radius).map(|k| (-0.5 * (f64::from(k) / deviation).powi(2)).exponential()).collect();
        let sum: f64 = raw.iter().sum();
        let weights: Vec<f64> = raw.iter().map(|weight| weight / sum).collect();
        terrain.heights = terrain.blurred(context, &weights, true)?;
        terrain.heights = terrain.blurred(context, &weights, false)?;
    }
    Ok(terrain.list())
}
