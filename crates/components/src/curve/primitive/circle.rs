//! Circles and ellipses.

use std::sync::Arc as Shared;

use katydid_component::{List, Message, component};
use katydid_elementary::Elementary;
use katydid_geometry::{Circle, Curve, Ellipse, Plane, Point3, Vector3};

use crate::curve::{shared, warning};

/// A circle in a plane.
#[component("807b86e3-be8d-4970-92b5-f8cdcb45b06b", name = "Circle", nick = "Cir", at = "Curve/Primitive")]
#[output("Circle", "C", "The circle.")]
fn circle(
    /// Its origin is the centre; the circle starts on its x axis.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// Not 0; of a negative one the size counts.
    #[port("Radius", "R", default = 1.0)]
    radius: f64,
) -> Result<Circle, Message> {
    Circle::new(plane, radius.abs()).map_err(warning)
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
    /// Not 0; of a negative one the size counts.
    #[port("Radius", "R", default = 1.0)]
    radius: f64,
) -> Result<Circle, Message> {
    Circle::from_normal(center, normal, radius.abs()).map_err(warning)
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
    let turn = 0.5 * (2.0 * f.dot(g)).arctangent_of(f.length_squared() - g.length_squared());
    let (sin, cos) = turn.sine_cosine();
    let (x, y) = (f * cos + g * sin, g * cos - f * sin);
    let plane = Plane::from_axes(center, x, y).map_err(warning)?;
    let ellipse = Ellipse::new(plane, x.length(), y.length()).map_err(warning)?;
    Ok((shared(Curve::Nurbs(ellipse.to_nurbs()?)), plane))
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

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Plane, Point3, Vector3};

    const O: Point3 = Point3::ORIGIN;
    const X: Point3 = Point3::new(4.0, 0.0, 0.0);
    const Y: Point3 = Point3::new(0.0, 3.0, 0.0);

    #[test]
    fn circles() {
        assert_eq!(Trial::of("Circle").item(Plane::XY).item(2.0).texts(0), ["{0}: Circle(R:2.00 mm)"]);
        assert!(!Trial::of("Circle").item(Plane::XY).item(0.0).message().is_empty());
        let turned = Trial::of("Circle").item(Plane::XY).item(-2.0);
        assert_eq!(turned.texts(0), Trial::of("Circle").item(Plane::XY).item(2.0).texts(0));
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
}
