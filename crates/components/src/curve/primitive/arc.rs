//! Arcs.

use katydid_component::{Message, component};
use katydid_data::{Geometry, Value};
use katydid_geometry::{Arc, Circle, Interval, Plane, Point3, Vector3};

use crate::curve::warning;

/// A part of a circle in a plane.
#[component("bb59bffc-f54c-4682-9778-f6c3fe74fce3", name = "Arc", nick = "Arc", at = "Curve/Primitive")]
#[output("Arc", "A", "The arc.")]
#[output("Length", "L", "Its length.")]
fn arc(
    /// Its origin is the centre; angles are measured from its x axis.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// Greater than 0.
    #[port("Radius", "R", default = 1.0)]
    radius: f64,
    /// Start and end angle in radians. Reversed it runs clockwise; more than a turn is a full circle.
    #[port("Angle", "A", default = Interval::new(0.0, std::f64::consts::PI))]
    angle: Interval,
) -> Result<(Arc, f64), Message> {
    measured(plane, radius, angle)
}

/// The arc with its length.
pub(in crate::curve) fn measured(plane: Plane, radius: f64, angle: Interval) -> Result<(Arc, f64), Message> {
    let arc = Circle::new(plane, radius).and_then(|circle| Arc::new(circle, angle)).map_err(warning)?;
    Ok((arc, arc.length()))
}

/// The arc from one point through another to a third.
///
/// Points on one line make no arc.
#[component("9fa1b081-b1c7-4a12-a163-0aa8da9ff6c4", name = "Arc 3Pt", nick = "Arc", at = "Curve/Primitive")]
#[output("Arc", "A", "The arc.")]
#[output("Plane", "P", "Its plane: the origin is the centre, x points to the start.")]
#[output("Radius", "R", "Its radius.")]
fn arc_3pt(
    /// Where it starts.
    #[port("Point A", "A")]
    a: Point3,
    /// A point on the way.
    #[port("Point B", "B")]
    b: Point3,
    /// Where it ends.
    #[port("Point C", "C")]
    c: Point3,
) -> Result<(Geometry, Plane, f64), Message> {
    let arc = Arc::through(a, b, c).map_err(warning)?;
    Ok((Geometry(Value::from(arc)), arc.circle.plane, arc.circle.radius))
}

/// The arc between two points that leaves the first in a given direction.
///
/// A direction straight towards the end makes no arc.
#[component("9d2583dd-6cf5-497c-8c40-c9a290598396", name = "Arc SED", nick = "Arc", at = "Curve/Primitive")]
#[output("Arc", "A", "The arc.")]
#[output("Plane", "P", "Its plane: the origin is the centre, x points to the start.")]
#[output("Radius", "R", "Its radius.")]
fn arc_sed(
    /// Where it starts.
    #[port("Start", "S")]
    start: Point3,
    /// Where it ends.
    #[port("End", "E")]
    end: Point3,
    /// The tangent at the start.
    #[port("Direction", "D")]
    direction: Vector3,
) -> Result<(Geometry, Plane, f64), Message> {
    let arc = Arc::from_start_direction_end(start, direction, end).map_err(warning)?;
    Ok((Geometry(Value::from(arc)), arc.circle.plane, arc.circle.radius))
}

/// An arc with another radius, other angles, or both.
#[component(
    "9d8dec9c-3fd1-481c-9c3d-75ea5e15eb1a",
    name = "Modified Arc",
    nick = "ModArc",
    at = "Curve/Primitive"
)]
#[output("Arc", "A", "The changed arc.")]
fn modified_arc(
    /// The arc to change.
    #[port("Arc", "A")]
    arc: Arc,
    /// The new radius; without it the old one stays.
    #[port("Radius", "R")]
    radius: Option<f64>,
    /// The new angles in radians; without them the old ones stay.
    #[port("Angle", "A")]
    angle: Option<Interval>,
) -> Result<Arc, Message> {
    let circle = Circle::new(arc.circle.plane, radius.unwrap_or(arc.circle.radius)).map_err(warning)?;
    Arc::new(circle, angle.unwrap_or(arc.angle)).map_err(warning)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use katydid_component::testing::Trial;
    use katydid_geometry::{Interval, Plane, Point3, Vector3};

    const O: Point3 = Point3::ORIGIN;
    const X: Point3 = Point3::new(4.0, 0.0, 0.0);

    #[test]
    fn arcs() {
        let arc = Trial::of("Arc").item(Plane::XY).item(2.0).item(Interval::new(0.0, PI));
        assert_eq!(arc.texts(1), ["{0}: 6.283185"]);
        let through = Trial::of("Arc 3Pt").item(O).item(Point3::new(2.0, 2.0, 0.0)).item(X);
        assert_eq!(through.texts(2), ["{0}: 2"]);
        let tangent = || Trial::of("Arc SED").item(O).item(X);
        assert_eq!(tangent().item(Vector3::Y).texts(2), ["{0}: 2"]);
        assert_eq!(tangent().item(Vector3::X).texts(2), ["{0}: null"]);
        let made = Trial::of("Arc").item(Plane::XY).item(2.0).run().outputs[0].clone();
        let changed = Trial::of("Modified Arc").tree(made).item(5.0).tree(katydid_data::Tree::empty());
        assert_eq!(changed.texts(0), ["{0}: Arc(R:5.00 mm A:180\u{b0})"]);
    }
}
