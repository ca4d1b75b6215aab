//! Curve / Primitive: straight lines that touch circles.

use katydid_component::{Message, component};
use katydid_geometry::{Circle, Line, Plane, Point3, Vector3};

/// The two directions in a plane that make an angle with cosine `cos` with the direction from one point to another;
/// `None` when there is no such angle.
fn directions(plane: &Plane, from: Point3, to: Point3, cos: f64) -> Option<[Vector3; 2]> {
    let x = (to - from).unitized()?;
    let y = plane.z_axis.cross(x);
    let sin = (1.0 - cos * cos).sqrt();
    sin.is_finite().then(|| [x * cos + y * sin, x * cos - y * sin])
}

/// The two lines from a point that touch a circle. The point is projected into the circle's plane.
///
/// A point within the circle has none.
#[component(
    "ea0f0996-af7a-481d-8099-09c041e6c2d5",
    name = "Tangent Lines",
    nick = "Tan",
    at = "Curve/Primitive"
)]
#[output("Tangent 1", "T1", "The line that touches the circle on its left.")]
#[output("Tangent 2", "T2", "The line on its right.")]
fn tangent_lines(
    /// Where the lines start.
    #[port("Point", "P")]
    point: Point3,
    /// The circle to touch.
    #[port("Circle", "C")]
    circle: Circle,
) -> Result<(Line, Line), Message> {
    let (p, c, r) = (circle.plane.closest_point(point), circle.plane.origin, circle.radius);
    let touch = directions(&circle.plane, c, p, r / c.distance_to(p));
    let [a, b] = touch.ok_or_else(|| Message::warning("The point lies within the circle"))?;
    Ok((Line::new(p, c + b * r), Line::new(p, c + a * r)))
}

/// The two lines that touch two circles on the same side. The second circle is projected into the plane of the first.
///
/// A circle within the other has none.
#[component(
    "d6d68c93-d00f-4cd5-ba89-903c7f6be64c",
    name = "Tangent Lines (Ex)",
    nick = "TanEx",
    at = "Curve/Primitive"
)]
#[output("Tangent 1", "T1", "The line on the left.")]
#[output("Tangent 2", "T2", "The line on the right.")]
fn tangent_lines_ex(
    /// The circle where the lines start.
    #[port("Circle A", "A")]
    a: Circle,
    /// The circle where they end.
    #[port("Circle B", "B")]
    b: Circle,
) -> Result<(Line, Line), Message> {
    let (p, q) = (a.plane.origin, a.plane.closest_point(b.plane.origin));
    let touch = directions(&a.plane, p, q, (a.radius - b.radius) / p.distance_to(q));
    let [left, right] = touch.ok_or_else(|| Message::warning("One circle lies within the other"))?;
    let line = |n: Vector3| Line::new(p + n * a.radius, q + n * b.radius);
    Ok((line(left), line(right)))
}

/// The two lines that touch two circles on opposite sides, crossing between them. The second circle is projected into
/// the plane of the first.
///
/// Circles that overlap have none.
#[component(
    "e0168047-c46a-48c6-8595-2fb3d8574f23",
    name = "Tangent Lines (In)",
    nick = "TanIn",
    at = "Curve/Primitive"
)]
#[output("Tangent 1", "T1", "The line that starts on the left.")]
#[output("Tangent 2", "T2", "The line that starts on the right.")]
fn tangent_lines_in(
    /// The circle where the lines start.
    #[port("Circle A", "A")]
    a: Circle,
    /// The circle where they end.
    #[port("Circle B", "B")]
    b: Circle,
) -> Result<(Line, Line), Message> {
    let (p, q) = (a.plane.origin, a.plane.closest_point(b.plane.origin));
    let touch = directions(&a.plane, p, q, (a.radius + b.radius) / p.distance_to(q));
    let [left, right] = touch.ok_or_else(|| Message::warning("The circles overlap"))?;
    let line = |n: Vector3| Line::new(p + n * a.radius, q - n * b.radius);
    Ok((line(left), line(right)))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Circle, Plane, Point3};

    fn circle(x: f64, radius: f64) -> Circle {
        Circle { plane: Plane::XY.with_origin(Point3::new(x, 0.0, 0.0)), radius }
    }

    #[test]
    fn tangents() {
        let point = |x: f64| Trial::of("Tangent Lines").item(Point3::new(x, 0.0, 0.0)).item(circle(0.0, 3.0));
        assert_eq!(point(5.0).texts(0), ["{0}: Line(L:4.00 mm)"]);
        assert_eq!(point(1.0).texts(0), ["{0}: null"]);
        let outer = Trial::of("Tangent Lines (Ex)").item(circle(0.0, 5.0)).item(circle(5.0, 2.0));
        assert_eq!(outer.texts(1), ["{0}: Line(L:4.00 mm)"]);
        let inner = |x: f64| Trial::of("Tangent Lines (In)").item(circle(0.0, 2.0)).item(circle(x, 1.0));
        assert_eq!(inner(5.0).texts(0), ["{0}: Line(L:4.00 mm)"]);
        assert_eq!(inner(2.0).texts(0), ["{0}: null"]);
    }
}
