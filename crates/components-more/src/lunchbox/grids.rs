//! LunchBox Panels: the corners of panels as lists of points, to build panels of one's own on.

use katydid_component::{Context, Message, component};
use katydid_geometry::{Point3, Surface, Vector3};

use super::Lattice;

/// The corners, middles and normals of panels.
type Corners = (Vec<Point3>, Vec<Point3>, Vec<Point3>, Vec<Point3>, Vec<Point3>, Vec<Vector3>);

/// A component whose panels are given by the places of their middles and corners in halves of a division.
macro_rules! point_grid {
    ($(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal, $middles:expr) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "LunchBox/LunchBox Panels")]
        #[output("Corner Point 1", "C1", "The first corner of each panel.")]
        #[output("Corner Point 2", "C2", "The second corner.")]
        #[output("Corner Point 3", "C3", "The third corner.")]
        #[output("Corner Point 4", "C4", "The fourth corner.")]
        #[output("Mid Point", "MPt", "The mean of the corners.")]
        #[output("Normals", "N", "The unit normal of the surface in the middle of the panel; zero where it has none.")]
        fn $function(
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
        ) -> Result<(Vec<Point3>, Vec<Point3>, Vec<Point3>, Vec<Point3>, Vec<Point3>, Vec<Vector3>), Message> {
            let lattice = Lattice::new(context, surface, u, v)?;
            let places: fn(usize, usize) -> Vec<[(usize, usize); 5]> = $middles;
            corners(context, &lattice, &places(lattice.cells[0], lattice.cells[1]))
        }
    };
}

/// Points and normals at places: of each panel the middle and the corners.
fn corners(
    context: &Context<'_>,
    lattice: &Lattice<'_>,
    panels: &[[(usize, usize); 5]],
) -> Result<Corners, Message> {
    context.items(panels.len().saturating_mul(6))?;
    let mut lists: [Vec<Point3>; 5] = std::array::from_fn(|_| Vec::with_capacity(panels.len()));
    let mut normals = Vec::with_capacity(panels.len());
    for [middle, places @ ..] in panels {
        let points = places.map(|(i, j)| lattice.at(i, j));
        let mean = Point3::mean(&points).unwrap_or(Point3::ORIGIN);
        for (list, point) in lists.iter_mut().zip(points.into_iter().chain([mean])) {
            list.push(point);
        }
        normals.push(lattice.normal(middle.0, middle.1).unwrap_or(Vector3::ZERO));
    }
    let [a, b, c, d, middles] = lists;
    Ok((a, b, c, d, middles, normals))
}

point_grid!(
    /// The corners of the quads that a surface is cut into, each corner a list. Stands for LunchBox's Quad Grid; that corners go
    /// round a panel, as u and v turn, is our reading.
    quad_grid, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c0a", "Quad Grid", "QGrid",
    |m, n| {
        let cell = |i: usize, j: usize| {
            let (a, b) = (2 * i, 2 * j);
            [(a + 1, b + 1), (a, b), (a + 2, b), (a + 2, b + 2), (a, b + 2)]
        };
        (0..m).flat_map(|i| (0..n).map(move |j| cell(i, j))).collect()
    }
);
point_grid!(
    /// The corners of the whole diamonds that a surface is cut into, each corner a list. Stands for LunchBox's Diamond Grid;
    /// that the triangles along the edges are left out, and that corners go round from the one at the least v, is our reading.
    diamond_grid, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c0b", "Diamond Grid", "DGrid",
    |m, n| {
        let inside = (1..2 * m).flat_map(|i| (1..2 * n).map(move |j| (i, j)));
        let diamond = |(i, j): (usize, usize)| [(i, j), (i, j - 1), (i + 1, j), (i, j + 1), (i - 1, j)];
        inside.filter(|(i, j)| (i + j) % 2 == 0).map(diamond).collect()
    }
);
