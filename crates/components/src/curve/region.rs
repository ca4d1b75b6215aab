//! Curve / Analysis: points inside and outside closed curves.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{Containment, Curve, Plane, Point3};

use super::warning;

/// Grasshopper's number for where a point lies, and its projection into the curve's plane.
fn relation(p: Point3, curve: &Curve, tolerance: f64) -> Result<(i32, Point3), Message> {
    let plane = match curve.plane(tolerance) {
        Some(plane) => plane,
        None => Plane::fit(&curve.hull_points()).map_err(warning)?.0,
    };
    let code = match curve.contains_in_plane(p, &plane, tolerance)? {
        Containment::Outside => 0,
        Containment::On => 1,
        Containment::Inside => 2,
    };
    Ok((code, plane.closest_point(p)))
}

/// Whether a point lies inside a closed curve, as seen at right angles to the curve's plane.
///
/// An open curve is an error.
#[component(
    "a72b0bd3-c7a7-458e-875d-09ae1624638c",
    name = "Point In Curve",
    nick = "InCurve",
    at = "Curve/Analysis",
    also("c076845a-1a09-4a95-bdcb-cb31c0936c99")
)]
#[output("Relationship", "R", "0 outside, 1 on the curve, 2 inside.")]
#[output("Point", "P'", "The point projected into the curve's plane.")]
fn point_in_curve(
    context: &Context<'_>,
    /// The point to test.
    #[port("Point", "P")]
    point: Point3,
    /// The closed curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Result<(i32, Point3), Message> {
    relation(point, curve, context.tolerance().absolute)
}

/// Whether a point lies inside any of several closed curves. Nulls among them are skipped.
///
/// An open curve is an error.
#[component(
    "0b04e8b9-00d7-47a7-95c3-0d51e654fe88",
    name = "Point in Curves",
    nick = "InCurves",
    at = "Curve/Analysis"
)]
#[output("Relationship", "R", "0 outside all, 1 on a curve, 2 inside one.")]
#[output("Index", "I", "The place in the list of the first curve that holds the point, -1 for none.")]
#[output("Point", "P'", "The point projected into that curve's plane; for none into the first one's.")]
fn point_in_curves(
    context: &Context<'_>,
    /// The point to test.
    #[port("Point", "P")]
    point: Point3,
    /// The closed curves.
    #[port("Curves", "C")]
    curves: List<Shared<Curve>>,
) -> Result<(i32, i32, Option<Point3>), Message> {
    let mut outside = None;
    for (i, curve) in curves.iter().enumerate() {
        let Some(curve) = curve else { continue };
        let (code, projected) = relation(point, &curve, context.tolerance().absolute)?;
        if code > 0 {
            return Ok((code, i32::try_from(i).unwrap_or(i32::MAX), Some(projected)));
        }
        outside.get_or_insert(projected);
    }
    Ok((0, -1, outside))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Circle, Line, Plane, Point3};

    #[test]
    fn inside_and_outside() {
        let circle = |x: f64| Circle { plane: Plane::XY.with_origin(Point3::new(x, 0.0, 1.0)), radius: 2.0 };
        let at = |x: f64| Trial::of("Point In Curve").item(Point3::new(x, 0.0, 9.0)).item(circle(0.0)).run();
        let codes = [0.0, 2.0, 3.0].map(|x| texts(&at(x).outputs[0]).join(""));
        assert_eq!(codes, ["{0}: 2", "{0}: 1", "{0}: 0"]);
        assert_eq!(texts(&at(0.0).outputs[1]), ["{0}: {0, 0, 1}"]);
        let open = Trial::of("Point In Curve")
            .item(Point3::ORIGIN)
            .item(Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)));
        assert!(open.message().contains("open"));
        let several = |x: f64| {
            Trial::of("Point in Curves")
                .item(Point3::new(x, 0.0, 0.0))
                .list([circle(0.0), circle(10.0)])
                .texts(1)
        };
        assert_eq!(several(11.0), ["{0}: 1"]);
        assert_eq!(several(5.0), ["{0}: -1"]);
    }
}
