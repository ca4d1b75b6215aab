//! What points make of the space between them: triangulations, cells of nearest points, hulls, neighbours.
//!
//! All decisions about which side a point lies on are exact (J. R. Shewchuk, *Adaptive precision floating-point
//! arithmetic and fast robust geometric predicates*, 1997, by the `robust` crate), so that points on a grid, on a line
//! or on a circle give the same kind of answer as points strewn at random.

mod convex_polygon;
mod delaunay;
mod facets;
mod hull;
mod hull3;
mod neighbours;
mod partition;
mod polyhedron;
mod thresholds;
mod voronoi;
mod voronoi3;

pub use convex_polygon::ConvexPolygon;
pub use delaunay::Delaunay;
pub use facets::{Facet, facets};
pub use hull::convex_hull;
pub use hull3::convex_hull_3d;
pub use neighbours::{PointTree, proximity};
pub use partition::{Leaf, OcTree, Partition, QuadTree};
pub use polyhedron::ConvexPolyhedron;
pub use voronoi::Voronoi;
pub use voronoi3::{voronoi_cell_3d, voronoi_cells_3d};

use crate::{Error, Point2, Point3, Result};

/// The predicates neither overflow nor underflow up to 2²⁰¹ (Shewchuk 1997, §1).
const LARGEST: f64 = 3.213_876_088_517_980_6e60;

fn check_coordinates(mut coordinates: impl Iterator<Item = f64>) -> Result<()> {
    match coordinates.find(|x| !(x.abs() <= LARGEST)) {
        None => Ok(()),
        Some(x) if x.is_finite() => {
            Err(Error::OutOfRange { what: "coordinate of a point", value: x, must: "at most 3.2e60 in size" })
        }
        Some(_) => Err(Error::NotFinite("coordinate of a point")),
    }
}

/// Refuses points that are not finite or too far off for exact predicates, and more than an index can count.
fn check_points2(points: &[Point2]) -> Result<()> {
    check_count(points.len())?;
    check_coordinates(points.iter().flat_map(|p| [p.x, p.y]))
}

/// As [`check_points2`], in space.
fn check_points3(points: &[Point3]) -> Result<()> {
    check_count(points.len())?;
    check_coordinates(points.iter().flat_map(|p| [p.x, p.y, p.z]))
}

fn check_count(n: usize) -> Result<()> {
    if n < (u32::MAX / 8) as usize {
        return Ok(());
    }
    Err(Error::OutOfRange { what: "number of points", value: n as f64, must: "less than 2^29" })
}

/// Positive when the way from `a` over `b` to `c` turns left, negative when it turns right, 0 on a line; exact.
fn turn(a: Point2, b: Point2, c: Point2) -> f64 {
    let coord = |p: Point2| robust::Coord { x: p.x, y: p.y };
    robust::orient2d(coord(a), coord(b), coord(c))
}
