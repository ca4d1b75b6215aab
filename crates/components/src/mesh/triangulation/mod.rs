//! Mesh / Triangulation.

mod delaunay;
mod dome;
mod hull;
mod metaball;
mod proximity;
mod quads;
mod remesh;
mod substrate;
mod trees;
mod voronoi;
mod voronoi3;

use katydid_component::{Context, List};
use katydid_data::Path;
use katydid_geometry::{Plane, Point2, Point3};

/// Where a tree output of this iteration begins: the branch's path and the number of the iteration.
fn place(context: &Context<'_>) -> Path {
    context.path().child(context.iteration())
}

/// The points that there are, and their places in the list.
fn present(points: &List<'_, Point3>) -> (Vec<usize>, Vec<Point3>) {
    points.iter().enumerate().filter_map(|(i, p)| p.map(|p| (i, p))).unzip()
}

/// The coordinates of points in a plane.
fn flat(points: &[Point3], plane: &Plane) -> Vec<Point2> {
    let flat = |&p: &Point3| {
        let [x, y, _] = plane.coordinates(p);
        Point2::new(x, y)
    };
    points.iter().map(flat).collect()
}

/// The plane nearest to points; a level one has the world's axes, and so has that of points on a line.
fn plane_of(points: &[Point3]) -> Plane {
    match Plane::fit(points) {
        Ok((plane, _)) if plane.z_axis.z.abs() < 1.0 - 1e-12 => {
            if plane.z_axis.z < 0.0 {
                plane.flipped()
            } else {
                plane
            }
        }
        Ok((plane, _)) => Plane::XY.with_origin(plane.origin),
        Err(_) => Plane::XY.with_origin(points.first().copied().unwrap_or_default()),
    }
}

/// Results at the places of a list of `n`, nulls between them.
fn at_places<T>(n: usize, places: &[usize], results: impl IntoIterator<Item = Option<T>>) -> Vec<Option<T>> {
    let mut out: Vec<Option<T>> = std::iter::repeat_with(|| None).take(n).collect();
    for (&place, result) in places.iter().zip(results) {
        if let Some(slot) = out.get_mut(place) {
            *slot = result;
        }
    }
    out
}
