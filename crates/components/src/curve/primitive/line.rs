//! Lines.

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{Line, Plane, Point3, Vector3, intersect};

use crate::curve::warning;

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

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Line, Plane, Point3, Vector3};

    const O: Point3 = Point3::ORIGIN;
    const X: Point3 = Point3::new(4.0, 0.0, 0.0);

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
}
