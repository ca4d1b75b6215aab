//! LunchBox Structure: lines and nodes on surfaces.

use katydid_component::{Context, Message, component};
use katydid_geometry::{Line, Point3, Surface};

use super::Lattice;

/// The lines of a lattice with its nodes at the corners of cells.
pub(super) fn grid(lattice: &Lattice<'_>) -> (Vec<Line>, Vec<Point3>) {
    let [m, n] = lattice.cells;
    let (mut lines, mut nodes) = (Vec::new(), Vec::new());
    for i in 0..=m {
        for j in 0..=n {
            nodes.push(lattice.at(2 * i, 2 * j));
            if i < m {
                lines.push(lattice.line((2 * i, 2 * j), (2 * i + 2, 2 * j)));
            }
            if j < n {
                lines.push(lattice.line((2 * i, 2 * j), (2 * i, 2 * j + 2)));
            }
        }
    }
    (lines, nodes)
}

macro_rules! structure {
    ($(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal, $rule:expr) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "LunchBox/LunchBox Structure")]
        #[output("Lines A", "LinesA", "The lines of the grid.")]
        #[output("Lines B", "LinesB", "The diagonals.")]
        #[output("Nodes", "Nodes", "The points where lines of the grid meet.")]
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
        ) -> Result<(Vec<Line>, Vec<Line>, Vec<Point3>), Message> {
            let lattice = Lattice::new(context, surface, u, v)?;
            let (lines, nodes) = grid(&lattice);
            let mut diagonals = Vec::new();
            let [m, n] = lattice.cells;
            for i in 0..m {
                for j in 0..n {
                    let braces: fn(usize, usize) -> Vec<[(usize, usize); 2]> = $rule;
                    diagonals.extend(braces(i, j).into_iter().map(|[a, b]| lattice.line(a, b)));
                }
            }
            Ok((lines, diagonals, nodes))
        }
    };
}

/// A grid of lines on a surface. Stands for LunchBox's Grid Structure.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c11",
    name = "Grid Structure",
    nick = "Grid",
    at = "LunchBox/LunchBox Structure"
)]
#[output("Lines", "Lines", "The centre lines.")]
#[output("Nodes", "Nodes", "The points where they meet.")]
fn grid_structure(
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
) -> Result<(Vec<Line>, Vec<Point3>), Message> {
    Ok(grid(&Lattice::new(context, surface, u, v)?))
}

structure!(
    /// A grid of lines on a surface with a diagonal in each cell. Stands for LunchBox's Braced Grid 1D Structure; which diagonal is
    /// our reading.
    braced_1d, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c12", "Braced Grid 1D Structure", "BracedGrid1D",
    |i, j| vec![[(2 * i, 2 * j), (2 * i + 2, 2 * j + 2)]]
);
structure!(
    /// A grid of lines on a surface with both diagonals in each cell. Stands for LunchBox's Braced Grid 2D Structure.
    braced_2d, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c13", "Braced Grid 2D Structure", "BracedGrid2D",
    |i, j| vec![[(2 * i, 2 * j), (2 * i + 2, 2 * j + 2)], [(2 * i + 2, 2 * j), (2 * i, 2 * j + 2)]]
);

/// A net of diagonals on a surface. Stands for LunchBox's Diagrid Structure; what its types are is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c14",
    name = "Diagrid Structure",
    nick = "Diagrid",
    at = "LunchBox/LunchBox Structure"
)]
#[output("Lines", "Lines", "The centre lines.")]
#[output("Nodes", "Nodes", "The points where they meet.")]
fn diagrid(
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
    /// Whether lines along v are added, so that there are triangles.
    #[port("T", "T", default = false)]
    triangles: bool,
) -> Result<(Vec<Line>, Vec<Point3>), Message> {
    let lattice = Lattice::new(context, surface, u, v)?;
    let [m, n] = lattice.cells;
    let (mut lines, mut nodes) = (Vec::new(), Vec::new());
    // Nodes at the corners and in the middles of cells.
    for i in 0..=2 * m {
        for j in (0..=2 * n).filter(|j| (i + j) % 2 == 0) {
            nodes.push(lattice.at(i, j));
            if i < 2 * m && j < 2 * n {
                lines.push(lattice.line((i, j), (i + 1, j + 1)));
            }
            if i < 2 * m && j > 0 {
                lines.push(lattice.line((i, j), (i + 1, j - 1)));
            }
            if triangles && j + 2 <= 2 * n {
                lines.push(lattice.line((i, j), (i, j + 2)));
            }
        }
    }
    Ok((lines, nodes))
}
