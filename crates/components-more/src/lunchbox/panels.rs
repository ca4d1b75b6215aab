//! LunchBox Panels: surfaces cut into panels by their parameters.

use katydid_component::{Context, Message, component};
use katydid_data::Value;
use katydid_geometry::{Curve, Point3, PolylineCurve, Surface};

use super::lists::Chance;
use super::{Lattice, panel};

/// A component whose panels are one list.
macro_rules! panels {
    ($(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal, $rule:expr) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "LunchBox/LunchBox Panels")]
        #[output("Panels", "Panels", "The panels: surfaces between their corners.")]
        fn $function(
            context: &Context<'_>,
            /// The surface.
            #[port("Srf", "Srf")]
            surface: &Surface,
            /// The number of divisions along u.
            #[port("U", "U", default = 10)]
            u: i32,
            /// The number of divisions along v.
            #[port("V", "V", default = 10)]
            v: i32,
        ) -> Result<Vec<Value>, Message> {
            let lattice = Lattice::new(context, surface, u, v)?;
            let [m, n] = lattice.cells;
            let mut panels = Vec::new();
            for i in 0..m {
                for j in 0..n {
                    let rule: fn(&Lattice<'_>, usize, usize) -> Vec<Vec<(usize, usize)>> = $rule;
                    for corners in rule(&lattice, i, j) {
                        panels.push(lattice.panel(&corners)?);
                    }
                }
            }
            Ok(panels)
        }
    };
}

/// The corners of a cell in halves of a division.
fn cell(i: usize, j: usize) -> [(usize, usize); 4] {
    let (a, b) = (2 * i, 2 * j);
    [(a, b), (a + 2, b), (a + 2, b + 2), (a, b + 2)]
}

panels!(
    /// Cuts a surface into quads. Stands for LunchBox's Quad Panels.
    quad_panels, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c01", "Quad Panels", "Quad",
    |_, i, j| vec![cell(i, j).to_vec()]
);
panels!(
    /// Cuts a surface into triangles, two in each cell. Stands for LunchBox's Triangular Panels A; which diagonal cuts a cell is
    /// our reading.
    triangle_panels_a, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c02", "Triangular Panels A", "TriA",
    |_, i, j| {
        let [a, b, c, d] = cell(i, j);
        vec![vec![a, b, c], vec![a, c, d]]
    }
);
panels!(
    /// Cuts a surface into triangles whose diagonals turn from cell to cell, so that six or four meet in a point by turns. Stands
    /// for LunchBox's Triangle Panels B; the pattern is our reading.
    triangle_panels_b, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c03", "Triangle Panels B", "TriB",
    |_, i, j| {
        let [a, b, c, d] = cell(i, j);
        if (i + j) % 2 == 0 { vec![vec![a, b, c], vec![a, c, d]] } else { vec![vec![a, b, d], vec![b, c, d]] }
    }
);
panels!(
    /// Cuts a surface into triangles, four in each cell about its middle. Stands for LunchBox's Triangle Panels C; the pattern is
    /// our reading.
    triangle_panels_c, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c04", "Triangle Panels C", "TriC",
    |_, i, j| {
        let [a, b, c, d] = cell(i, j);
        let middle = (2 * i + 1, 2 * j + 1);
        vec![vec![a, b, middle], vec![b, c, middle], vec![c, d, middle], vec![d, a, middle]]
    }
);
panels!(
    /// Cuts a surface into quads that are shifted by half of a division in every second row, as bricks are. Stands for LunchBox's
    /// Staggered Quad Panels.
    staggered_panels, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c05", "Staggered Quad Panels", "StagQuad",
    |lattice, i, j| {
        let m = lattice.cells[0];
        let (low, high) = (2 * j, 2 * j + 2);
        let quad = |from: usize, to: usize| vec![(from, low), (to, low), (to, high), (from, high)];
        match (j % 2, i) {
            (0, _) => vec![quad(2 * i, 2 * i + 2)],
            (_, 0) if m == 1 => vec![quad(0, 1), quad(1, 2)],
            (_, 0) => vec![quad(0, 1), quad(1, 3)],
            (_, i) if i + 1 == m => vec![quad(2 * i + 1, 2 * i + 2)],
            (_, i) => vec![quad(2 * i + 1, 2 * i + 3)],
        }
    }
);
panels!(
    /// Cuts a surface into quads that lean by a division along u from row to row, with triangles at the ends. Stands for
    /// LunchBox's Skewed Quads; that they lean by half of a division is our reading.
    skewed_quads, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c06", "Skewed Quads", "SkewQuad",
    |lattice, i, j| {
        let m = lattice.cells[0];
        let (low, high) = (2 * j, 2 * j + 2);
        let mut panels = Vec::new();
        if i == 0 {
            panels.push(vec![(0, low), (1, high), (0, high)]);
        }
        if i + 1 == m {
            panels.push(vec![(2 * i, low), (2 * i + 2, low), (2 * i + 2, high), (2 * i + 1, high)]);
        } else {
            panels.push(vec![(2 * i, low), (2 * i + 2, low), (2 * i + 3, high), (2 * i + 1, high)]);
        }
        panels
    }
);

/// Cuts a surface into diamonds on its diagonals, with triangles along the edges. Stands for LunchBox's Diamond Panels.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c07",
    name = "Diamond Panels",
    nick = "Diamond",
    at = "LunchBox/LunchBox Panels"
)]
#[output("Diamonds", "Diamonds", "The diamonds.")]
#[output("Triangles", "Triangles", "The triangles along the edges.")]
fn diamond_panels(
    context: &Context<'_>,
    /// The surface.
    #[port("Srf", "Srf")]
    surface: &Surface,
    /// The number of divisions along u.
    #[port("U", "U", default = 10)]
    u: i32,
    /// The number of divisions along v.
    #[port("V", "V", default = 10)]
    v: i32,
) -> Result<(Vec<Value>, Vec<Value>), Message> {
    let lattice = Lattice::new(context, surface, u, v)?;
    let [m, n] = lattice.cells;
    let (mut diamonds, mut triangles) = (Vec::new(), Vec::new());
    // Middles of diamonds stand at the corners of cells and in the middles of cells: a diamond reaches half a cell each way.
    for i in 0..=2 * m {
        for j in (0..=2 * n).filter(|j| (i + j) % 2 == 0) {
            let corners: Vec<(usize, usize)> =
                [(i, j.wrapping_sub(1)), (i + 1, j), (i, j + 1), (i.wrapping_sub(1), j)]
                    .into_iter()
                    .filter(|(a, b)| *a <= 2 * m && *b <= 2 * n)
                    .collect();
            match corners.len() {
                4 => diamonds.push(lattice.panel(&corners)?),
                3 => triangles.push(lattice.panel(&corners)?),
                // A corner of the surface: the triangle between it and its two neighbours.
                2 => triangles.push(lattice.panel(&[(i, j), corners[0], corners[1]])?),
                _ => {}
            }
        }
    }
    Ok((diamonds, triangles))
}

/// Cuts a surface into quads whose widths along u are by chance. Stands for LunchBox's Random Quad Panels; the chance is our own,
/// so that the widths are others for the same seed.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c08",
    name = "Random Quad Panels",
    nick = "RandQuad",
    at = "LunchBox/LunchBox Panels"
)]
#[output("Panels", "Panels", "The panels: surfaces between their corners.")]
fn random_panels(
    context: &Context<'_>,
    /// The surface.
    #[port("Srf", "Srf")]
    surface: &Surface,
    /// The number of divisions along u.
    #[port("U", "U", default = 10)]
    u: i32,
    /// The number of divisions along v.
    #[port("V", "V", default = 10)]
    v: i32,
    /// The seed.
    #[port("S", "S", default = 1)]
    seed: i32,
) -> Result<Vec<Value>, Message> {
    context
        .tell(Message::remark("The random widths are Katydid's own: LunchBox has others for the same seed"));
    let lattice = Lattice::new(context, surface, u, v)?;
    let [m, n] = lattice.cells;
    let mut chance = Chance::new(seed);
    let mut panels = Vec::new();
    for j in 0..n {
        let widths: Vec<f64> = (0..m).map(|_| 0.25 + chance.draw()).collect();
        let whole: f64 = widths.iter().sum();
        let (low, high) = (j as f64 / n as f64, (j + 1) as f64 / n as f64);
        let mut from = 0.0;
        for (i, width) in widths.iter().enumerate() {
            let to = if i + 1 == m { 1.0 } else { from + width / whole };
            let corners = [(from, low), (to, low), (to, high), (from, high)];
            panels.push(panel(&corners.map(|(s, t)| lattice.at_parts(s, t)))?);
            from = to;
        }
    }
    Ok(panels)
}

/// Cuts a surface into hexagons. Stands for LunchBox's Hexagon Cells; how the cells lie, and that those at the edges are left out
/// where they are not whole, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c09",
    name = "Hexagon Cells",
    nick = "Hex",
    at = "LunchBox/LunchBox Panels"
)]
#[output("Cells", "Cells", "The cells: closed polylines.")]
#[output("Centers", "Centers", "The middles of the cells.")]
fn hexagon_cells(
    context: &Context<'_>,
    /// The surface.
    #[port("Srf", "Srf")]
    surface: &Surface,
    /// The number of cells along u.
    #[port("U", "U", default = 10)]
    u: i32,
    /// The number of cells along v.
    #[port("V", "V", default = 10)]
    v: i32,
    /// How pointed the cells are: the part of a division along v that a tip takes, from 0 (rectangles) to 1.
    #[port("t", "t", default = 0.5)]
    tip: f64,
) -> Result<(Vec<Value>, Vec<Point3>), Message> {
    if !(0.0..=1.0).contains(&tip) {
        return Err(Message::error(format!("t is {tip}: it must be from 0 to 1")));
    }
    let lattice = Lattice::new(context, surface, u, v)?;
    let [m, n] = lattice.cells;
    let (mut cells, mut centers) = (Vec::new(), Vec::new());
    // Rows overlap by the tips, so that all of v is n rows and one tip.
    let row = 1.0 / (n as f64 + 0.5 * tip);
    let reach = 0.5 * tip * row;
    for j in 0..n {
        let shift = if j % 2 == 1 { 0.5 } else { 0.0 };
        for i in 0..m - usize::from(j % 2 == 1) {
            let (left, right) = ((i as f64 + shift) / m as f64, (i as f64 + shift + 1.0) / m as f64);
            let middle = 0.5 * (left + right);
            let (low, high) = (j as f64 * row, (j + 1) as f64 * row + reach);
            let corners = [
                (middle, low),
                (right, low + reach),
                (right, high - reach),
                (middle, high),
                (left, high - reach),
                (left, low + reach),
                (middle, low),
            ];
            let points = corners.map(|(s, t)| lattice.at_parts(s, t)).to_vec();
            cells.push(Value::from(Curve::Polyline(PolylineCurve::new(points)?)));
            centers.push(lattice.at_parts(middle, 0.5 * (low + high)));
        }
    }
    Ok((cells, centers))
}
