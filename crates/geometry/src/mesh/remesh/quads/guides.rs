//! Curves that lead the quads of a mesh.

use super::super::imprint::Course;
use super::super::target::Target;
use super::QuadOptions;
use crate::{Mesh, Point3, Vector3};

/// What the edges of quads do along a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GuideKind {
    /// A loop of edges lies on the curve.
    Loop,
    /// The curve runs through the middles of a strip of quads, across the edges between them.
    Ring,
}

/// Curves on a mesh.
#[derive(Default)]
pub(super) struct Guides {
    /// Those along which edges run.
    pub(super) courses: Vec<Course>,
    /// Those that edges cross in their middles.
    pub(super) rings: Vec<Course>,
}

/// The curves on a mesh that lead its quads, with sides of the given lengths.
///
/// Beside a curve that a ring of edges shall cross, a loop of edges runs half a quad away: the next one then lies about
/// half a quad on the other side.
pub(super) fn guides(
    mesh: &Mesh,
    options: &QuadOptions,
    surface: &Target,
    quad: impl Fn(Point3) -> f64,
) -> Guides {
    let mut out = Guides::default();
    if options.loops.is_empty() {
        return out;
    }
    let triangles: Vec<[Point3; 3]> = mesh.triangles().collect();
    let normal_at = |p: Point3| {
        surface.nearest_triangle(p).and_then(|i| {
            let [a, b, c] = triangles.get(i).copied()?;
            (b - a).cross(c - a).unitized()
        })
    };
    for (kind, points) in &options.loops {
        let places: Vec<Point3> = points.iter().map(|&p| surface.nearest(p)).collect();
        // What is nowhere near the mesh leads nothing.
        let near = |k: &usize| places[*k].distance_to(points[*k]) <= quad(places[*k]);
        let all: Vec<usize> = (0..points.len()).collect();
        for run in all.chunk_by(|a, b| near(a) && near(b)).filter(|run| run.iter().all(near)) {
            let on: Vec<Point3> = run.iter().map(|&k| places[k]).collect();
            match kind {
                GuideKind::Loop => out.courses.extend(Course::new(&on)),
                GuideKind::Ring => {
                    let beside = run.iter().map(|&k| {
                        let (p, along) = (places[k], direction(&places, k));
                        let left = normal_at(p).and_then(|n| n.cross(along).unitized());
                        left.map_or(p, |left| surface.nearest(p + left * (0.5 * quad(p))))
                    });
                    let beside: Vec<Point3> = beside.collect();
                    if let (Some(ring), Some(course)) = (Course::new(&on), Course::new(&beside)) {
                        out.rings.push(ring);
                        out.courses.push(course);
                    }
                }
            }
        }
    }
    out
}

/// The direction of a polyline at one of its points.
fn direction(points: &[Point3], k: usize) -> Vector3 {
    let n = points.len();
    let at = |i: usize| points.get(i).copied().unwrap_or_default();
    let closed = n > 3 && at(0).coincides(at(n - 1));
    let before = if k > 0 {
        k - 1
    } else if closed {
        n - 2
    } else {
        k
    };
    let after = if k + 1 < n {
        k + 1
    } else if closed {
        1
    } else {
        k
    };
    at(after) - at(before)
}
