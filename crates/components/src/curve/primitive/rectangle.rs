//! Rectangles and regular polygons.

use std::sync::Arc as Shared;

use katydid_component::{Message, component};
use katydid_data::Value;
use katydid_elementary::Elementary;
use katydid_geometry::{Curve, Interval, Plane, Point3, Rectangle, Vector3, regular_polygon};

use crate::curve::{fillet, shared, warning};

/// A rectangle with its perimeter, or a curve with round corners.
fn with_corners(rectangle: Rectangle, radius: f64) -> Result<(Value, f64), Message> {
    if radius == 0.0 {
        return Ok((Value::from(rectangle), rectangle.perimeter()));
    }
    let half = 0.5 * rectangle.x.length().abs().min(rectangle.y.length().abs());
    if !(radius > 0.0) {
        return Err(Message::error("The corner radius must not be negative"));
    }
    let [a, b, c, d] = rectangle.corners();
    let curve = fillet::rounded(&[a, b, c, d, a], fillet::Cut::Radius(radius.min(half)), None)?;
    let length = curve.length();
    Ok((Value::from(curve), length))
}

/// A rectangle in a plane, with round corners when a radius is given.
#[component(
    "d93100b6-d50b-40b2-831a-814659dc38e3",
    name = "Rectangle",
    nick = "Rectangle",
    at = "Curve/Primitive",
    also("0ca0a214-396c-44ea-b22f-d3a1757c32d6")
)]
#[output("Rectangle", "R", "The rectangle; a curve when its corners are round.")]
#[output("Length", "L", "The length around it.")]
fn rectangle(
    /// The plane it lies in.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// From where to where it reaches along the plane's x axis.
    #[port("X Size", "X", default = Interval::new(-1.0, 1.0))]
    x: Interval,
    /// From where to where it reaches along its y axis.
    #[port("Y Size", "Y", default = Interval::new(-2.0, 2.0))]
    y: Interval,
    /// The radius of the corners, at most half the shorter side; 0 for sharp ones.
    #[port("Radius", "R", default = 0.0)]
    radius: f64,
) -> Result<(Value, f64), Message> {
    with_corners(Rectangle { plane, x, y }, radius)
}

/// A rectangle in a plane with two diagonal corners, with round corners when a radius is given.
#[component(
    "575660b1-8c79-4b8d-9222-7ab4a6ddb359",
    name = "Rectangle 2Pt",
    nick = "Rec 2Pt",
    at = "Curve/Primitive"
)]
#[output("Rectangle", "R", "The rectangle; a curve when its corners are round.")]
#[output("Length", "L", "The length around it.")]
fn rectangle_2pt(
    /// The plane it lies in; the corners are projected into it.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// A corner.
    #[port("Point A", "A", default = Point3::ORIGIN)]
    a: Point3,
    /// The corner diagonally across.
    #[port("Point B", "B", default = Point3::new(10.0, 5.0, 0.0))]
    b: Point3,
    /// The radius of the corners, at most half the shorter side; 0 for sharp ones.
    #[port("Radius", "R", default = 0.0)]
    radius: f64,
) -> Result<(Value, f64), Message> {
    with_corners(Rectangle::from_corners(&plane, a, b), radius)
}

/// A rectangle with a given edge, as high as a third point is beside it.
///
/// Points on one line make no rectangle.
#[component(
    "9bc98a1d-2ecc-407e-948a-09a09ed3e69d",
    name = "Rectangle 3Pt",
    nick = "Rec 3Pt",
    at = "Curve/Primitive",
    also("34493ef6-3dfb-47c0-b149-691d02a93588")
)]
#[output("Rectangle", "R", "The rectangle.")]
#[output("Length", "L", "The length around it.")]
fn rectangle_3pt(
    /// Where the edge starts.
    #[port("Point A", "A")]
    a: Point3,
    /// Where the edge ends.
    #[port("Point B", "B")]
    b: Point3,
    /// How high it is, and on which side.
    #[port("Point C", "C")]
    c: Point3,
) -> Result<(Rectangle, f64), Message> {
    let rectangle = Rectangle::from_points(a, b, c).map_err(warning)?;
    Ok((rectangle, rectangle.perimeter()))
}

/// A regular polygon about a plane's origin, with round corners when a radius is given.
#[component(
    "845527a6-5cea-4ae9-a667-96ae1667a4e8",
    name = "Polygon",
    nick = "Polygon",
    at = "Curve/Primitive"
)]
#[output("Polygon", "P", "The polygon.")]
#[output("Length", "L", "The length around it.")]
fn polygon(
    /// Its origin is the centre; the first corner lies on its x axis.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// From the centre to a corner; greater than 0.
    #[port("Radius", "R", default = 3.0)]
    radius: f64,
    /// The number of sides, at least 3.
    #[port("Segments", "S", default = 6)]
    segments: i32,
    /// The radius of the corners; 0 for sharp ones.
    #[port("Fillet Radius", "Rf", default = 0.0)]
    fillet_radius: f64,
) -> Result<(Shared<Curve>, f64), Message> {
    let sides = usize::try_from(segments).map_err(|_| Message::error("A polygon needs at least 3 sides"))?;
    let outline = regular_polygon(&plane, radius, sides).map_err(warning)?;
    if fillet_radius == 0.0 {
        let curve = shared(outline);
        let length = curve.length();
        return Ok((curve, length));
    }
    if !(fillet_radius > 0.0) {
        return Err(Message::error("The corner radius must not be negative"));
    }
    // At the radius of the circle within, round corners meet in the middles of the sides.
    let largest = radius * (std::f64::consts::PI / sides as f64).cosine();
    let cut = fillet::Cut::Radius(fillet_radius.min(largest));
    let curve = shared(fillet::rounded(outline.points(), cut, None)?);
    let length = curve.length();
    Ok((curve, length))
}

/// A regular polygon on a given edge.
#[component(
    "f4568ce6-aade-4511-8f32-f27d8a6bf9e9",
    name = "Polygon Edge",
    nick = "PolEdge",
    at = "Curve/Primitive"
)]
#[output("Polygon", "P", "The polygon.")]
#[output("Centre", "C", "Its centre.")]
#[output("Corner Radius", "Rc", "From the centre to a corner.")]
#[output("Edge Radius", "Rc", "From the centre to the middle of a side.")]
fn polygon_edge(
    /// Where the edge starts.
    #[port("Edge Start", "E0")]
    start: Point3,
    /// Where it ends.
    #[port("Edge End", "E1")]
    end: Point3,
    /// On which side the polygon lies.
    #[port("Plane Point", "P")]
    point: Point3,
    /// The number of sides, at least 3.
    #[port("Segments", "S", default = 6)]
    segments: i32,
) -> Result<(Shared<Curve>, Point3, f64, f64), Message> {
    let sides = usize::try_from(segments).unwrap_or(0);
    if sides < 3 {
        return Err(Message::error("A polygon needs at least 3 sides"));
    }
    let plane = Plane::from_points(start, end, point).map_err(warning)?;
    let edge = start.distance_to(end);
    let half = std::f64::consts::PI / sides as f64;
    let (corner, side) = (edge / (2.0 * half.sine()), edge / (2.0 * half.tangent()));
    let center = start.lerp(end, 0.5) + plane.y_axis * side;
    let toward: Vector3 = start - center;
    let own = Plane::from_axes(center, toward, plane.z_axis.cross(toward)).map_err(warning)?;
    Ok((shared(regular_polygon(&own, corner, sides).map_err(warning)?), center, corner, side))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use katydid_component::testing::Trial;
    use katydid_geometry::{Interval, Plane, Point3};

    const O: Point3 = Point3::ORIGIN;
    const X: Point3 = Point3::new(4.0, 0.0, 0.0);
    const Y: Point3 = Point3::new(0.0, 3.0, 0.0);

    #[test]
    fn rectangles_and_polygons() {
        let plain = || Trial::of("Rectangle").item(Plane::XY).item(4.0).item(Interval::new(-1.0, 1.0));
        assert_eq!(plain().texts(0), ["{0}: Rectangle (w=4, h=2)"]);
        assert_eq!(plain().texts(1), ["{0}: 12"]);
        assert_eq!(plain().item(1.0).texts(1), [format!("{{0}}: {:.6}", 4.0 + 2.0 * PI)]);
        assert!(plain().item(-1.0).message().contains("negative"));
        assert_eq!(Trial::of("Rectangle 2Pt").texts(1), ["{0}: 30"]);
        assert_eq!(Trial::of("Rectangle 3Pt").item(O).item(X).item(Y).texts(1), ["{0}: 14"]);
        assert_eq!(Trial::of("Polygon").item(Plane::XY).item(1.0).item(6).texts(1), ["{0}: 6"]);
        assert!(Trial::of("Polygon").item(Plane::XY).item(1.0).item(2).run().messages.len() == 1);
        let round = Trial::of("Polygon").item(Plane::XY).item(1.0).item(4).item(9.0);
        assert_eq!(round.texts(1), [format!("{{0}}: {:.6}", 2f64.sqrt() * PI)]);
        let edge = || Trial::of("Polygon Edge").item(O).item(X).item(Y).item(4);
        assert_eq!(edge().texts(1), ["{0}: {2, 2, 0}"]);
        assert_eq!(edge().texts(3), ["{0}: 2"]);
    }
}
