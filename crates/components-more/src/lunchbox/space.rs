//! LunchBox Structure: trusses of two layers, and nets of hexagons.

use std::collections::{HashMap, HashSet};

use katydid_component::{Context, Message, component};
use katydid_geometry::{Direction, Line, Point3, Surface};

use super::Lattice;
use super::structures::grid;

/// What a truss of two layers consists of: the lines of both, the web between them, and all nodes.
type Truss = (Vec<Line>, Vec<Line>, Vec<Line>, Vec<Point3>);

/// The truss between a grid and a second layer with a node for each of its cells, the cells along v first.
fn two_layers(context: &Context<'_>, lattice: &Lattice<'_>, second: &[Point3]) -> Result<Truss, Message> {
    let [m, n] = lattice.cells;
    context.items(m.saturating_mul(n).saturating_mul(10))?;
    let (first_lines, mut nodes) = grid(lattice);
    let node = |i: usize, j: usize| second.get(i * n + j).copied().unwrap_or(Point3::ORIGIN);
    let (mut second_lines, mut web) = (Vec::new(), Vec::new());
    for i in 0..m {
        for j in 0..n {
            let here = node(i, j);
            if i + 1 < m {
                second_lines.push(Line::new(here, node(i + 1, j)));
            }
            if j + 1 < n {
                second_lines.push(Line::new(here, node(i, j + 1)));
            }
            let (a, b) = (2 * i, 2 * j);
            let corners = [(a, b), (a + 2, b), (a + 2, b + 2), (a, b + 2)];
            web.extend(corners.map(|(i, j)| Line::new(lattice.at(i, j), here)));
        }
    }
    nodes.extend(second);
    Ok((first_lines, second_lines, web, nodes))
}

/// The places of the middles of cells in halves of a division, those along v first.
fn middles(cells: [usize; 2]) -> impl Iterator<Item = (usize, usize)> {
    (0..cells[0]).flat_map(move |i| (0..cells[1]).map(move |j| (2 * i + 1, 2 * j + 1)))
}

/// A space truss: a grid on a surface, a second one at a distance with its nodes over the middles of the cells, and four struts
/// from each of those to the corners of its cell. Stands for LunchBox's Space Truss Structure 1; that the second layer lies in the
/// direction of the surface's normal is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c15",
    name = "Space Truss Structure 1",
    nick = "SpaceTruss 1",
    at = "LunchBox/LunchBox Structure"
)]
#[output("Primary Lines A", "LinesA", "The lines of the layer on the surface.")]
#[output("Primary Lines B", "LinesB", "The lines of the second layer.")]
#[output("Web Lines", "Web", "The struts between the layers, four for each cell.")]
#[output("Structure Nodes", "Nodes", "The nodes on the surface, then those of the second layer.")]
fn space_truss_1(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "Srf")]
    surface: &Surface,
    /// The number of divisions along u.
    #[port("U Divisions", "U", default = 10)]
    u: i32,
    /// The number of divisions along v.
    #[port("V Divisions", "V", default = 10)]
    v: i32,
    /// The distance of the second layer along the normals; negative for the other side.
    #[port("Truss Depth", "D", default = 1.0)]
    depth: f64,
) -> Result<(Vec<Line>, Vec<Line>, Vec<Line>, Vec<Point3>), Message> {
    if !depth.is_finite() {
        return Err(Message::error("The depth is not finite"));
    }
    let lattice = Lattice::new(context, surface, u, v)?;
    let second = middles(lattice.cells).map(|(i, j)| match lattice.normal(i, j) {
        Some(normal) => Ok(lattice.at(i, j) + normal * depth),
        None => Err(Message::error("The surface has no normal in the middle of a cell")),
    });
    two_layers(context, &lattice, &second.collect::<Result<Vec<_>, _>>()?)
}

/// A space truss between two surfaces: a grid on the first, a second one on the other with its nodes at the middles of the cells,
/// and four struts from each of those to the corners of its cell. Stands for LunchBox's Space Truss Structure 2.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c16",
    name = "Space Truss Structure 2",
    nick = "SpaceTruss 2",
    at = "LunchBox/LunchBox Structure"
)]
#[output("Primary Lines A", "LinesA", "The lines of the layer on the first surface.")]
#[output("Primary Lines B", "LinesB", "The lines of the layer on the second surface.")]
#[output("Web Lines", "Web", "The struts between the layers, four for each cell.")]
#[output("Structure Nodes", "Nodes", "The nodes on the first surface, then those on the second.")]
fn space_truss_2(
    context: &Context<'_>,
    /// The surface with the corners of the cells.
    #[port("Surface A", "Srf-A")]
    first: &Surface,
    /// The surface with their middles; u and v run as on the first.
    #[port("Surface B", "Srf-B")]
    second: &Surface,
    /// The number of divisions along u.
    #[port("U Divisions", "U", default = 10)]
    u: i32,
    /// The number of divisions along v.
    #[port("V Divisions", "V", default = 10)]
    v: i32,
) -> Result<(Vec<Line>, Vec<Line>, Vec<Line>, Vec<Point3>), Message> {
    let lattice = Lattice::new(context, first, u, v)?;
    let other = Lattice { surface: second, cells: lattice.cells };
    let nodes: Vec<Point3> = middles(lattice.cells).map(|(i, j)| other.at(i, j)).collect();
    two_layers(context, &lattice, &nodes)
}

/// A place in a net of hexagons: halves of a cell across, and a level; two levels for each row.
type Place = (usize, usize);

/// The corners of the hexagon in column i of row j, counter-clockwise from below. Every second row is shifted by half a cell.
fn hexagon(i: usize, j: usize) -> [Place; 6] {
    let (left, low) = (2 * i + j % 2, 2 * j);
    let (middle, right) = (left + 1, left + 2);
    [(middle, low), (right, low + 1), (right, low + 2), (middle, low + 3), (left, low + 2), (left, low + 1)]
}

/// A net of hexagons on a surface, whose cells lie as those of Hexagon Cells. Stands for LunchBox's Hexagonal Structure; that
/// cells which are not whole are left out, and that the type turns the net, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c17",
    name = "Hexagonal Structure",
    nick = "Hex",
    at = "LunchBox/LunchBox Structure"
)]
#[output("Structure Lines", "Lines", "The centre lines, each once.")]
#[output("Structure Nodes", "Nodes", "The points where they meet.")]
fn hexagonal(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "Srf")]
    surface: &Surface,
    /// The number of cells along u.
    #[port("U Divisions", "U", default = 10)]
    u: i32,
    /// The number of cells along v.
    #[port("V Divisions", "V", default = 10)]
    v: i32,
    /// How pointed the cells are: the part of a row that a tip takes, from 0 (rectangles) to 1.
    #[port("Adjust Shape", "A", default = 0.5)]
    tip: f64,
    /// Whether the tips point along u and not along v.
    #[port("Type", "T", default = false)]
    turned: bool,
) -> Result<(Vec<Line>, Vec<Point3>), Message> {
    if !(0.0..=1.0).contains(&tip) {
        return Err(Message::error(format!("A is {tip}: it must be from 0 to 1")));
    }
    let lattice = Lattice::new(context, surface, u, v)?;
    let [m, n] = if turned { [lattice.cells[1], lattice.cells[0]] } else { lattice.cells };
    context.items(m.saturating_mul(n).saturating_mul(6))?;
    // Rows overlap by the tips, so that all of the direction is n rows and one tip.
    let row = 1.0 / (n as f64 + 0.5 * tip);
    let point = |(k, level): Place| {
        let across = k as f64 / (2 * m) as f64;
        let along = row * ((level / 2) as f64 + if level % 2 == 1 { 0.5 * tip } else { 0.0 });
        if turned { lattice.at_parts(along, across) } else { lattice.at_parts(across, along) }
    };
    let mut numbers: HashMap<Place, usize> = HashMap::new();
    let mut seen: HashSet<Place> = HashSet::new();
    let (mut lines, mut nodes) = (Vec::new(), Vec::new());
    for j in 0..n {
        for i in 0..m - j % 2 {
            let ring = hexagon(i, j).map(|place| {
                *numbers.entry(place).or_insert_with(|| {
                    nodes.push(point(place));
                    nodes.len() - 1
                })
            });
            for (a, b) in crate::polygons::sides(&ring) {
                if seen.insert(crate::polygons::edge(a, b)) {
                    let end = |k: usize| nodes.get(k).copied().unwrap_or(Point3::ORIGIN);
                    lines.push(Line::new(end(a), end(b)));
                }
            }
        }
    }
    Ok((lines, nodes))
}

impl Lattice<'_> {
    /// The unit normal at the point [`Lattice::at`] gives; `None` where the surface has none.
    pub(super) fn normal(&self, i: usize, j: usize) -> Option<katydid_geometry::Vector3> {
        let [u, v] = [Direction::U, Direction::V].map(|d| self.surface.domain(d));
        let [m, n] = self.cells;
        let part = |k: usize, of: usize| k as f64 / (2 * of) as f64;
        self.surface.normal_at(u.at(part(i, m)), v.at(part(j, n)))
    }
}
