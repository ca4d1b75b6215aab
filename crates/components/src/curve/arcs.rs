//! Curve / Primitive and Spline: circles and arcs that touch and follow, and hanging chains.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::biarc::{biarc, poly_arc};
use katydid_geometry::{
    Arc, Circle, Curve, Interval, NurbsCurve, Plane, Point3, PolyCurve, Vector3, catenary, touching_circle,
};

use super::{measured, primitive, shared, warning};

fn points(list: &List<'_, Point3>) -> Vec<Point3> {
    list.present().collect()
}

/// The plane that curves lie in: that of the first one that has one, else world XY at the height of the guess.
fn common_plane(context: &Context<'_>, curves: &[&Curve], guess: Point3) -> Plane {
    let tolerance = context.tolerance().absolute;
    let bent = curves.iter().filter(|c| !c.is_linear(tolerance)).find_map(|c| c.plane(tolerance));
    bent.unwrap_or_else(|| match curves {
        [a, b, ..] => Plane::from_axes(a.start(), a.end() - a.start(), b.end() - b.start())
            .unwrap_or(Plane { origin: guess, ..Plane::XY }),
        _ => Plane { origin: guess, ..Plane::XY },
    })
}

/// A circle that touches two curves of a plane. Of all such circles it is one whose centre is near the point.
///
/// It is an error when none is found from the point.
#[component(
    "50b204ef-d3de-41bb-a006-02fba2d3f709",
    name = "Circle TanTan",
    nick = "CircleTT",
    at = "Curve/Primitive"
)]
#[output("Circle", "C", "The circle.")]
fn circle_tan_tan(
    context: &Context<'_>,
    /// One curve.
    #[port("Curve A", "A")]
    a: &Curve,
    /// The other curve.
    #[port("Curve B", "B")]
    b: &Curve,
    /// Where the centre is looked for.
    #[port("Point", "P")]
    point: Point3,
) -> Result<Circle, Message> {
    let plane = common_plane(context, &[a, b], point);
    Ok(touching_circle(&[a, b], &plane, point, context.tolerance().absolute)?)
}

/// A circle that touches three curves of a plane: the one that is found from the point on.
///
/// It is an error when none is found.
#[component(
    "dcaa922d-5491-4826-9a22-5adefa139f43",
    name = "Circle TanTanTan",
    nick = "CircleTTT",
    at = "Curve/Primitive"
)]
#[output("Circle", "C", "The circle.")]
fn circle_tan_tan_tan(
    context: &Context<'_>,
    /// One curve.
    #[port("Curve A", "A")]
    a: &Curve,
    /// Another curve.
    #[port("Curve B", "B")]
    b: &Curve,
    /// The third curve.
    #[port("Curve C", "C")]
    c: &Curve,
    /// Where the centre is looked for.
    #[port("Point", "P")]
    point: Point3,
) -> Result<Circle, Message> {
    let plane = common_plane(context, &[a, b, c], point);
    Ok(touching_circle(&[a, b, c], &plane, point, context.tolerance().absolute)?)
}

fn arc_of(curve: &Curve) -> Option<Arc> {
    match curve {
        Curve::Arc(arc) => Some(arc.arc),
        _ => None,
    }
}

/// Two arcs that join smoothly, with given directions at both ends.
///
/// An arc is null where the way is straight; the curve has a line there.
#[component("75f4b0fd-9721-47b1-99e7-9c098b342e67", name = "BiArc", nick = "BiArc", at = "Curve/Primitive")]
#[output("First arc", "A1", "The arc at the start.")]
#[output("Second arc", "A2", "The arc at the end.")]
#[output("Bi-Arc", "B", "Both as one curve.")]
fn bi_arc(
    /// Where the first arc starts.
    #[port("Start Point", "S")]
    start: Point3,
    /// The direction there.
    #[port("Start Tangent", "Ts")]
    start_tangent: Vector3,
    /// Where the second arc ends.
    #[port("End Point", "E")]
    end: Point3,
    /// The direction there.
    #[port("End Tangent", "Te")]
    end_tangent: Vector3,
    /// The share of the first arc, between 0 and 1.
    #[port("Ratio", "R", default = 0.5)]
    ratio: f64,
) -> Result<(Option<Arc>, Option<Arc>, Shared<Curve>), Message> {
    let [a, b] = biarc(start, start_tangent, end, end_tangent, ratio)?;
    Ok((arc_of(&a), arc_of(&b), shared(PolyCurve::new(vec![a, b])?)))
}

/// Arcs from point to point, each smooth with the one before.
#[component("7159ef59-e4ef-44b8-8cb2-91231e278292", name = "PolyArc", nick = "PArc", at = "Curve/Spline")]
#[output("PolyArc", "Crv", "The curve.")]
fn polyarc(
    /// The points.
    #[port("Vertices", "V")]
    vertices: List<Point3>,
    /// The direction in which it leaves the first point. Without one it begins with a line.
    #[port("Tangent", "T", optional)]
    tangent: Option<Vector3>,
    /// Whether an arc leads back to the first point.
    #[port("Closed", "C", default = false)]
    closed: bool,
) -> Result<Shared<Curve>, Message> {
    poly_arc(&points(&vertices), tangent, closed).map(shared).map_err(warning)
}

/// Arcs from point to point, each smooth with the one before, a line first. An early form of PolyArc.
#[component(
    "a5e4f966-417e-465d-afa9-f6607afea056",
    name = "Poly Arc",
    nick = "PArc",
    at = "Curve/Spline",
    old
)]
#[output("PolyArc", "Crv", "The curve.")]
fn early_poly_arc(
    /// The points.
    #[port("Vertices", "V")]
    vertices: List<Point3>,
) -> Result<Shared<Curve>, Message> {
    poly_arc(&points(&vertices), None, false).map(shared).map_err(warning)
}

/// The curve of a chain that hangs between two points.
///
/// The chain must be longer than the way between the points; else there is a warning and no curve.
#[component("275671d4-3e87-40bd-8aff-8e6a5fdbb892", name = "Catenary", nick = "Cat", at = "Curve/Spline")]
#[output("Catenary", "C", "The curve.")]
fn catenary_curve(
    /// One end.
    #[port("Point A", "A")]
    a: Point3,
    /// The other end.
    #[port("Point B", "B")]
    b: Point3,
    /// The length of the chain.
    #[port("Length", "L")]
    length: f64,
    /// The direction in which it hangs; its length does not matter.
    #[port("Gravity", "G", default = Vector3::new(0.0, 0.0, -1.0))]
    gravity: Vector3,
) -> Result<Shared<Curve>, Message> {
    catenary(a, b, length, gravity).map(shared).map_err(warning)
}

/// A curve through points with a given direction at each.
///
/// Fewer directions than points are repeated in order.
#[component(
    "f73498c5-178b-4e09-ad61-73d172fa6e56",
    name = "Tangent Curve",
    nick = "TanCurve",
    at = "Curve/Spline"
)]
#[output("Curve", "C", "The curve.")]
#[output("Length", "L", "Its length.")]
#[output("Domain", "D", "Its domain.")]
fn tangent_curve(
    /// The points, at least two.
    #[port("Vertices", "V")]
    vertices: List<Point3>,
    /// The directions; their lengths do not matter.
    #[port("Tangents", "T")]
    tangents: List<Vector3>,
    /// How far the directions reach, as a part of the way to the next point.
    #[port("Blend", "B", default = 0.5)]
    blend: f64,
    /// 3, or 5 for a curve without curvature at the points.
    #[port("Degree", "D", default = 3)]
    degree: i32,
) -> Result<(Shared<Curve>, f64, Interval), Message> {
    let points = points(&vertices);
    let directions: Vec<Vector3> = tangents.present().filter_map(Vector3::unitized).collect();
    if points.len() < 2 || directions.is_empty() {
        return Err(Message::warning("It needs two points and a direction"));
    }
    // How far the inner control points lie on the tangents, in parts of blend · way.
    let (degree, reach): (usize, &[f64]) = match degree {
        3 => (3, &[1.0]),
        5 => (5, &[0.5, 1.0]),
        other => return Err(Message::error(format!("Degree is {other}, which must be 3 or 5"))),
    };
    let mut control = Vec::with_capacity(points.len() * degree);
    let mut knots = Vec::with_capacity(points.len() * degree + degree);
    let mut parameter = 0.0;
    let way = |i: usize, v: f64| directions.get(i % directions.len()).map_or(Vector3::ZERO, |d| *d * v);
    for (i, pair) in points.windows(2).enumerate() {
        let &[p, q] = pair else { continue };
        let chord = p.distance_to(q);
        knots.extend(std::iter::repeat_n(parameter, degree));
        control.push(p);
        control.extend(reach.iter().map(|r| p + way(i, r * blend * chord)));
        control.extend(reach.iter().rev().map(|r| q - way(i + 1, r * blend * chord)));
        parameter += chord;
    }
    control.extend(points.last().copied());
    knots.extend(std::iter::repeat_n(parameter, degree));
    Ok(measured(NurbsCurve::new(degree, control, knots).map_err(warning)?))
}

/// An arc by its plane, radius and angle. An early form of Arc.
#[component(
    "fd9fe288-a188-4e9b-a464-1148876d18ed",
    name = "Arc [OBSOLETE]",
    nick = "Arc",
    at = "Curve/Primitive",
    old
)]
#[output("Arc", "A", "The arc.")]
#[output("Length", "L", "Its length.")]
fn early_arc(
    /// The plane, with the centre as its origin.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The radius, above 0.
    #[port("Radius", "R", default = 1.0)]
    radius: f64,
    /// The range of angles in radians; a number is the range from 0 to it.
    #[port("Angle", "A", default = Interval::new(0.0, std::f64::consts::PI))]
    angle: Interval,
) -> Result<(Arc, f64), Message> {
    primitive::arc::measured(plane, radius, angle)
}

fn parts(arc: Arc) -> (Arc, Plane, f64) {
    (arc, arc.circle.plane, arc.circle.radius)
}

/// The arc from a point through a second one to a third. An early form of Arc 3Pt.
#[component(
    "32c57b97-b653-47dd-b78f-121e89fdd01c",
    name = "Arc 3Pt [OBSOLETE]",
    nick = "Arc",
    at = "Curve/Primitive",
    old
)]
#[output("Arc", "A", "The arc.")]
#[output("Plane", "P", "Its plane.")]
#[output("Radius", "R", "Its radius.")]
fn early_arc_3pt(
    /// Where it starts.
    #[port("Point A", "A")]
    a: Point3,
    /// A point on it.
    #[port("Point B", "B")]
    b: Point3,
    /// Where it ends.
    #[port("Point C", "C")]
    c: Point3,
) -> Result<(Arc, Plane, f64), Message> {
    Arc::through(a, b, c).map(parts).map_err(warning)
}

/// The arc with a given direction at its start. An early form of Arc SED.
#[component(
    "f17c37ae-b44a-481a-bd65-b4398be55ec8",
    name = "Arc SED [OBSOLETE]",
    nick = "Arc",
    at = "Curve/Primitive",
    old
)]
#[output("Arc", "A", "The arc.")]
#[output("Plane", "P", "Its plane.")]
#[output("Radius", "R", "Its radius.")]
fn early_arc_sed(
    /// Where it starts.
    #[port("Start", "S")]
    start: Point3,
    /// Where it ends.
    #[port("End", "E")]
    end: Point3,
    /// The direction at the start.
    #[port("Direction", "D")]
    direction: Vector3,
) -> Result<(Arc, Plane, f64), Message> {
    Arc::from_start_direction_end(start, direction, end).map(parts).map_err(warning)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Curve, Line, Point3, Vector3};

    const O: Point3 = Point3::ORIGIN;

    fn p(x: f64, y: f64) -> Point3 {
        Point3::new(x, y, 0.0)
    }

    fn curve(trial: Trial, output: usize) -> Curve {
        match trial.run().outputs[output].column().get(0) {
            Some(Value::Curve(curve)) => (*curve).clone(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn circles_touch() {
        let (x, y) = (Line::new(O, p(4.0, 0.0)), Line::new(O, p(0.0, 3.0)));
        let two = Trial::of("Circle TanTan").item(x).item(y).item(p(1.5, 1.5));
        assert_eq!(two.texts(0), ["{0}: Circle(R:1.50 mm)"]);
        let side = Line::new(p(4.0, 0.0), p(0.0, 3.0));
        let three = Trial::of("Circle TanTanTan").item(x).item(y).item(side).item(p(0.5, 0.5));
        assert_eq!(three.texts(0), ["{0}: Circle(R:1.00 mm)"]);
        let corner = Trial::of("Circle TanTan").item(x).item(y).item(O);
        assert!(corner.message().contains("curves meet"));
    }

    #[test]
    fn arcs_follow() {
        let trial = || Trial::of("BiArc").item(O).item(Vector3::Y).item(p(4.0, 0.0)).item(-Vector3::Y);
        let out = trial().run().outputs;
        // Two quarters of a circle of radius 2.
        assert_eq!(texts(&out[0]), ["{0}: Arc(R:2.00 mm A:90°)"]);
        assert_eq!(texts(&out[1]), ["{0}: Arc(R:2.00 mm A:90°)"]);
        assert!((curve(trial(), 2).length() - 2.0 * std::f64::consts::PI).abs() < 1e-12);
        assert!(trial().item(1.5).message().contains("between 0 and 1"));
        let chain = Trial::of("PolyArc").list([O, p(2.0, 2.0), p(4.0, 0.0)]).item(Vector3::Y);
        assert!((curve(chain, 0).length() - 2.0 * std::f64::consts::PI).abs() < 1e-12);
        let early = Trial::of("Poly Arc").list([O, p(2.0, 0.0)]);
        assert!((curve(early, 0).length() - 2.0).abs() < 1e-12);
        assert!(Trial::of("PolyArc").list([O]).message().contains("two points"));
    }

    #[test]
    fn chains_hang() {
        let length = 4.0 * 1f64.sinh();
        let chain = curve(Trial::of("Catenary").item(p(-2.0, 0.0)).item(p(2.0, 0.0)).item(length), 0);
        let low = chain.bounding_box().min.z;
        assert!((low - 2.0 * (1.0 - 1f64.cosh())).abs() < 1e-6, "{low}");
        assert!(Trial::of("Catenary").item(O).item(p(2.0, 0.0)).item(2.0).message().contains("length"));
    }

    #[test]
    fn curves_have_their_tangents() {
        for degree in [3, 5] {
            let trial = Trial::of("Tangent Curve").list([O, p(3.0, 0.0), p(3.0, 4.0)]);
            let c = curve(trial.list([Vector3::Y, Vector3::X]).item(0.5).item(degree), 0);
            for (t, at, tangent) in
                [(0.0, O, Vector3::Y), (3.0, p(3.0, 0.0), Vector3::X), (7.0, p(3.0, 4.0), Vector3::Y)]
            {
                assert!(c.point_at(t).distance_to(at) < 1e-12);
                assert!((c.tangent_on_side(t, t > 0.0).unwrap() - tangent).length() < 1e-9, "{degree} {t}");
            }
        }
        let wrong = Trial::of("Tangent Curve").list([O, p(1.0, 0.0)]).list([Vector3::X]).item(1.0).item(4);
        assert!(wrong.message().contains("3 or 5"));
    }

    #[test]
    fn early_arcs() {
        let arc = Trial::of("Arc [OBSOLETE]").default().item(2.0).run().outputs;
        assert_eq!(texts(&arc[0]), ["{0}: Arc(R:2.00 mm A:180°)"]);
        assert_eq!(texts(&arc[1]), ["{0}: 6.283185"]);
        let through = Trial::of("Arc 3Pt [OBSOLETE]").item(p(1.0, 0.0)).item(p(0.0, 1.0)).item(p(-1.0, 0.0));
        assert_eq!(through.texts(2), ["{0}: 1"]);
        let sed = Trial::of("Arc SED [OBSOLETE]").item(O).item(p(2.0, 2.0)).item(Vector3::Y);
        assert_eq!(sed.texts(0), ["{0}: Arc(R:2.00 mm A:90°)"]);
    }
}
