//! Curve / Primitive: lines, circles, arcs, ellipses, rectangles, polygons.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Geometry, Value};
use katydid_geometry::{
    Arc, Circle, Curve, Ellipse, Interval, Line, Plane, Point3, Rectangle, Vector3, intersect,
    regular_polygon,
};

use super::{fillet, shared, warning};

/// The straight segment between two points.
///
/// Two equal points give a line of length 0, and a warning.
#[component("4c4e56eb-2f04-43f9-95a3-cc46a14f495a", name = "Line", nick = "Ln", at = "Curve/Primitive")]
#[output("Line", "L", "The line.")]
fn line(
    context: &Context<'_>,
    /// Where it starts.
    #[port("Start Point", "A")]
    start: Point3,
    /// Where it ends.
    #[port("End Point", "B")]
    end: Point3,
) -> Line {
    if start == end {
        context.warn("The line has length 0");
    }
    Line::new(start, end)
}

/// A straight segment from its start, direction and length.
///
/// A direction of length 0 makes no line.
#[component("4c619bc9-39fd-4717-82a6-1e07ea237bbe", name = "Line SDL", nick = "Line", at = "Curve/Primitive")]
#[output("Line", "L", "The line.")]
fn line_sdl(
    /// Where it starts.
    #[port("Start", "S")]
    start: Point3,
    /// Where it points; its length does not matter.
    #[port("Direction", "D", default = Vector3::new(0.0, 0.0, 1.0))]
    direction: Vector3,
    /// How long it is; negative against the direction.
    #[port("Length", "L", default = 1.0)]
    length: f64,
) -> Result<Line, Message> {
    let v = direction.with_length(length);
    let v = v.ok_or_else(|| Message::warning("A direction of length 0 makes no line"))?;
    Ok(Line::new(start, start + v))
}

/// The part of a line between two planes.
#[component(
    "510c4a63-b9bf-42e7-9d07-9d71290264da",
    name = "Line 2Plane",
    nick = "Ln2Pl",
    at = "Curve/Primitive"
)]
#[output("Line", "L", "The part between.")]
fn line_2plane(
    /// The line; it counts as endless.
    #[port("Line", "L")]
    line: Line,
    /// The plane where the part starts.
    #[port("Plane A", "A")]
    a: Plane,
    /// The plane where it ends.
    #[port("Plane B", "B")]
    b: Plane,
) -> Result<Line, Message> {
    match (intersect::line_plane(&line, &a), intersect::line_plane(&line, &b)) {
        (Some(s), Some(t)) => Ok(Line::new(line.at(s), line.at(t))),
        _ => Err(Message::warning("The line is parallel to a plane")),
    }
}

/// The part of a line between the places nearest to two points.
#[component(
    "b9fde5fa-d654-4306-8ee1-6b69e6757604",
    name = "Line 4Pt",
    nick = "Ln4Pt",
    at = "Curve/Primitive"
)]
#[output("Line", "L", "The part between.")]
fn line_4pt(
    /// The line; it counts as endless.
    #[port("Line", "L")]
    line: Line,
    /// The point beside which the part starts.
    #[port("Point A", "A")]
    a: Point3,
    /// The point beside which it ends.
    #[port("Point B", "B")]
    b: Point3,
) -> Line {
    Line::new(line.at(line.closest_parameter(a)), line.at(line.closest_parameter(b)))
}

/// The line that fits points best: along the direction in which they spread most, as far as they reach.
///
/// At least two different points. Nulls are skipped.
#[component(
    "1f798a28-9de6-47b5-8201-cac57256b777",
    name = "Fit Line",
    nick = "FLine",
    at = "Curve/Primitive"
)]
#[output("Line", "L", "The line, from the first point towards the last.")]
fn fit_line(
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
) -> Result<Line, Message> {
    let points: Vec<Point3> = points.present().collect();
    Line::fit(&points).map_err(warning)
}

/// A circle in a plane.
#[component("807b86e3-be8d-4970-92b5-f8cdcb45b06b", name = "Circle", nick = "Cir", at = "Curve/Primitive")]
#[output("Circle", "C", "The circle.")]
fn circle(
    /// Its origin is the centre; the circle starts on its x axis.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// Greater than 0.
    #[port("Radius", "R", default = 1.0)]
    radius: f64,
) -> Result<Circle, Message> {
    Circle::new(plane, radius).map_err(warning)
}

/// A circle from centre, normal and radius.
#[component(
    "d114323a-e6ee-4164-946b-e4ca0ce15efa",
    name = "Circle CNR",
    nick = "Circle",
    at = "Curve/Primitive"
)]
#[output("Circle", "C", "The circle.")]
fn circle_cnr(
    /// The centre.
    #[port("Center", "C")]
    center: Point3,
    /// The direction it is seen from; not zero.
    #[port("Normal", "N", default = Vector3::new(0.0, 0.0, 1.0))]
    normal: Vector3,
    /// Greater than 0.
    #[port("Radius", "R", default = 1.0)]
    radius: f64,
) -> Result<Circle, Message> {
    Circle::from_normal(center, normal, radius).map_err(warning)
}

/// The circle through three points.
///
/// Points on one line have none.
#[component(
    "47886835-e3ff-4516-a3ed-1b419f055464",
    name = "Circle 3Pt",
    nick = "Circle",
    at = "Curve/Primitive"
)]
#[output("Circle", "C", "The circle.")]
#[output("Plane", "P", "Its plane: the origin is the centre, x points to A.")]
#[output("Radius", "R", "Its radius.")]
fn circle_3pt(
    /// Where the circle starts.
    #[port("Point A", "A")]
    a: Point3,
    /// The second point.
    #[port("Point B", "B")]
    b: Point3,
    /// The third point.
    #[port("Point C", "C")]
    c: Point3,
) -> Result<(Circle, Plane, f64), Message> {
    let circle = Circle::through(a, b, c).map_err(warning)?;
    Ok((circle, circle.plane, circle.radius))
}

/// The circle that fits points best in the plane that fits them best.
///
/// At least three points that are not on one line. Nulls are skipped.
#[component(
    "be52336f-a2e1-43b1-b5f5-178ba489508a",
    name = "Circle Fit",
    nick = "FCircle",
    at = "Curve/Primitive"
)]
#[output("Circle", "C", "The circle.")]
#[output("Radius", "R", "Its radius.")]
#[output("Deviation", "D", "The largest distance of a point from it.")]
fn circle_fit(
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
) -> Result<(Circle, f64, f64), Message> {
    let points: Vec<Point3> = points.present().collect();
    let (circle, deviation) = Circle::fit(&points).map_err(warning)?;
    Ok((circle, circle.radius, deviation))
}

/// The circle within a triangle that touches its three sides.
#[component(
    "28b1c4d4-ab1c-4309-accd-1b7a954ed948",
    name = "InCircle",
    nick = "InCircle",
    at = "Curve/Primitive"
)]
#[output("Circle", "C", "The circle.")]
#[output("Plane", "P", "Its plane.")]
#[output("Radius", "R", "Its radius.")]
fn incircle(
    /// The first corner.
    #[port("Corner A", "A")]
    a: Point3,
    /// The second corner.
    #[port("Corner B", "B")]
    b: Point3,
    /// The third corner.
    #[port("Corner C", "C")]
    c: Point3,
) -> Result<(Circle, Plane, f64), Message> {
    let (x, y, z) = (b.distance_to(c), c.distance_to(a), a.distance_to(b));
    let around = x + y + z;
    let plane = Plane::from_points(a, b, c).map_err(warning)?;
    let middle = (a.to_vector() * x + b.to_vector() * y + c.to_vector() * z) / around;
    let radius = (b - a).cross(c - a).length() / around;
    let circle = Circle::new(plane.with_origin(middle.to_point()), radius).map_err(warning)?;
    Ok((circle, circle.plane, circle.radius))
}

/// The ellipse within a triangle that touches its sides in their middles (the Steiner inellipse).
#[component(
    "679a9c6a-ab97-4c20-b02c-680f9a9a1a44",
    name = "InEllipse",
    nick = "InEllipse",
    at = "Curve/Primitive"
)]
#[output("Ellipse", "E", "The ellipse.")]
#[output("Plane", "P", "Its plane, x along the longer radius.")]
fn inellipse(
    /// The first corner.
    #[port("Corner A", "A")]
    a: Point3,
    /// The second corner.
    #[port("Corner B", "B")]
    b: Point3,
    /// The third corner.
    #[port("Corner C", "C")]
    c: Point3,
) -> Result<(Shared<Curve>, Plane), Message> {
    let center = a + ((b - a) + (c - a)) / 3.0;
    // It is the affine image of a circle; the two conjugate radii are turned until they stand at right angles.
    let (f, g) = ((c - center) / 2.0, (a - b) / 12f64.sqrt());
    let turn = 0.5 * (2.0 * f.dot(g)).atan2(f.length_squared() - g.length_squared());
    let (sin, cos) = turn.sin_cos();
    let (x, y) = (f * cos + g * sin, g * cos - f * sin);
    let plane = Plane::from_axes(center, x, y).map_err(warning)?;
    let ellipse = Ellipse::new(plane, x.length(), y.length()).map_err(warning)?;
    Ok((shared(Curve::Nurbs(ellipse.to_nurbs()?)), plane))
}

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
    let circle = Circle::new(plane, radius).map_err(warning)?;
    let arc = Arc::new(circle, angle).map_err(warning)?;
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

/// An ellipse in a plane.
#[component(
    "46b5564d-d3eb-4bf1-ae16-15ed132cfd88",
    name = "Ellipse",
    nick = "Ellipse",
    at = "Curve/Primitive"
)]
#[output("Ellipse", "E", "The ellipse.")]
#[output("Focus 1", "F1", "The focus on the positive side of the longer axis.")]
#[output("Focus 2", "F2", "The other focus.")]
fn ellipse(
    /// Its origin is the centre.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The radius along its x axis; greater than 0.
    #[port("Radius 1", "R1", default = 1.0)]
    r1: f64,
    /// The radius along its y axis; greater than 0.
    #[port("Radius 2", "R2", default = 1.0)]
    r2: f64,
) -> Result<(Shared<Curve>, Point3, Point3), Message> {
    let ellipse = Ellipse::new(plane, r1, r2).map_err(warning)?;
    let [f1, f2] = ellipse.foci();
    Ok((shared(Curve::Nurbs(ellipse.to_nurbs()?)), f1, f2))
}

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
    let largest = radius * (std::f64::consts::PI / sides as f64).cos();
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
    let (corner, side) = (edge / (2.0 * half.sin()), edge / (2.0 * half.tan()));
    let center = start.lerp(end, 0.5) + plane.y_axis * side;
    let toward: Vector3 = start - center;
    let own = Plane::from_axes(center, toward, plane.z_axis.cross(toward)).map_err(warning)?;
    Ok((shared(regular_polygon(&own, corner, sides).map_err(warning)?), center, corner, side))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use katydid_component::testing::Trial;
    use katydid_geometry::{Interval, Line, Plane, Point3, Vector3};

    const O: Point3 = Point3::ORIGIN;
    const X: Point3 = Point3::new(4.0, 0.0, 0.0);
    const Y: Point3 = Point3::new(0.0, 3.0, 0.0);

    #[test]
    fn lines() {
        assert_eq!(Trial::of("Line").item(O).item(X).texts(0), ["{0}: Line(L:4.00 mm)"]);
        assert!(Trial::of("Line").item(O).item(O).message().contains("length 0"));
        assert_eq!(
            Trial::of("Line SDL").item(O).item(Vector3::Y).item(-2.0).texts(0),
            ["{0}: Line(L:2.00 mm)"]
        );
        assert!(Trial::of("Line SDL").item(O).item(Vector3::ZERO).message().contains("direction"));
        let line = Line::new(O, X);
        let between =
            Trial::of("Line 2Plane").item(line).item(Plane::YZ.offset(1.0)).item(Plane::YZ.offset(7.0));
        assert_eq!(between.texts(0), ["{0}: Line(L:6.00 mm)"]);
        let part = Trial::of("Line 4Pt").item(line).item(Point3::new(1.0, 5.0, 0.0)).item(X);
        assert_eq!(part.texts(0), ["{0}: Line(L:3.00 mm)"]);
        assert_eq!(Trial::of("Fit Line").list([O, X, X]).texts(0), ["{0}: Line(L:4.00 mm)"]);
    }

    #[test]
    fn circles() {
        assert_eq!(Trial::of("Circle").item(Plane::XY).item(2.0).texts(0), ["{0}: Circle(R:2.00 mm)"]);
        assert!(!Trial::of("Circle").item(Plane::XY).item(0.0).message().is_empty());
        let round = Trial::of("Circle CNR").item(O).item(Vector3::X).item(2.0);
        assert_eq!(round.texts(0), ["{0}: Circle(R:2.00 mm)"]);
        let three = || Trial::of("Circle 3Pt").item(O).item(X).item(Y);
        assert_eq!(three().texts(2), ["{0}: 2.5"]);
        let line = Trial::of("Circle 3Pt").item(O).item(X).item(Point3::new(9.0, 0.0, 0.0));
        assert_eq!(line.texts(0), ["{0}: null"]);
        let fit = Trial::of("Circle Fit").list([O, X, Y, Point3::new(4.0, 3.0, 0.0)]);
        assert_eq!(fit.texts(1), ["{0}: 2.5"]);
        assert_eq!(Trial::of("InCircle").item(O).item(X).item(Y).texts(2), ["{0}: 1"]);
        assert!(Trial::of("InEllipse").item(O).item(X).item(Y).run().messages.is_empty());
        assert_eq!(Trial::of("Ellipse").item(Plane::XY).item(5.0).item(3.0).texts(1), ["{0}: {4, 0, 0}"]);
    }

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
