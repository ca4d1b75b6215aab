//! Convex hulls.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::cloud;
use katydid_geometry::{Curve, Plane, Point3, PolylineCurve};

use super::{flat, present};
use crate::mesh::integer;

/// The shortest closed polyline around points, seen along the plane's normal.
///
/// Points on its straight stretches are not corners. Points on one line have no hull.
#[component(
    "9d0c5284-ea24-4f9f-a183-ef57fc48b5b8",
    name = "Convex Hull",
    nick = "Hull",
    at = "Mesh/Triangulation"
)]
#[output("Hull", "H", "The hull in the plane, counter-clockwise.")]
#[output("Hull(z)", "Hz", "The same corners where the points are in space.")]
#[output("Indices", "I", "The places of the corners in the list, in the order of the hull.")]
fn convex_hull(
    context: &Context<'_>,
    /// The points; nulls are left out.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The plane of the hull.
    #[port("Plane", "Pl", default = Plane::XY, optional)]
    plane: Plane,
) -> Result<(Option<Shared<Curve>>, Option<Shared<Curve>>, Vec<i32>), Message> {
    let (places, points) = present(&points);
    let hull = cloud::convex_hull(&flat(&points, &plane))?;
    let indices = hull.iter().filter_map(|&i| places.get(i).map(|&p| integer(p))).collect();
    if hull.len() < 3 {
        context.warn("The points are fewer than three, or lie on one line seen along the plane's normal");
        return Ok((None, None, indices));
    }
    let ring = || hull.iter().chain(hull.first()).filter_map(|&i| points.get(i).copied());
    let closed = |points: Vec<Point3>| -> Result<_, Message> {
        Ok(Some(Shared::new(Curve::from(PolylineCurve::new(points)?))))
    };
    let level = closed(ring().map(|p| plane.closest_point(p)).collect())?;
    Ok((level, closed(ring().collect())?, indices))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Plane, Point3};

    #[test]
    fn hulls_in_a_plane_and_in_space() {
        let points = [[0.0, 0.0, 0.0], [2.0, 0.0, 1.0], [1.0, 0.0, 4.0], [1.0, 1.0, 0.0], [2.0, 2.0, 2.0]];
        let run = Trial::of("Convex Hull").list(points.map(Point3::from)).run();
        assert_eq!(texts(&run.outputs[2]), ["{0;0}: 0, 1, 4"]);
        let corners = |n: usize| Trial::of("Control Points").tree(run.outputs[n].clone()).texts(0);
        assert_eq!(corners(0), ["{0;0}: {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 0, 0}"]);
        assert_eq!(corners(1), ["{0;0}: {0, 0, 0}, {2, 0, 1}, {2, 2, 2}, {0, 0, 0}"]);
        let front = Trial::of("Convex Hull").list(points.map(Point3::from)).item(Plane::XZ);
        assert_eq!(front.texts(2), ["{0;0}: 0, 3, 1, 4, 2"]);
        let run = Trial::of("Convex Hull")
            .gaps([Some(Point3::ORIGIN), None, Some(Point3::new(1.0, 0.0, 0.0))])
            .run();
        assert_eq!(texts(&run.outputs[2]), ["{0;0}: 0, 2"]);
        assert!(run.messages[0].text.contains("one line"));
    }
}
