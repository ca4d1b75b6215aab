//! Curve / Spline: curves through and beside points.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{
    Curve, Interval, KnotSpacing, NurbsCurve, Point3, PolyCurve, PolylineCurve, Vector3,
    clamped_uniform_knots, combined_curves, hermite_to_bezier, periodic_uniform_knots,
};

use super::{measured, shared, warning};

/// The points of a list without nulls; at least two.
fn vertices(points: &List<'_, Point3>) -> Result<Vec<Point3>, Message> {
    let points: Vec<Point3> = points.present().collect();
    if points.len() < 2 {
        return Err(Message::warning("A curve needs at least two points"));
    }
    Ok(points)
}

fn degree(n: i32) -> Result<usize, Message> {
    match usize::try_from(n) {
        Ok(n) if (1..=11).contains(&n) => Ok(n),
        _ => Err(Message::error(format!("A degree of {n} is not possible: it goes from 1 to 11"))),
    }
}

/// The spacing that Grasshopper's number stands for.
fn spacing(n: i32) -> Result<KnotSpacing, Message> {
    match n {
        0 => Ok(KnotSpacing::Uniform),
        1 => Ok(KnotSpacing::Chord),
        2 => Ok(KnotSpacing::SquareRootChord),
        _ => Err(Message::error(format!(
            "There is no knot style {n}: 0 is uniform, 1 chord, 2 square root of chord"
        ))),
    }
}

/// Straight segments through points, in order. Nulls and points that repeat the one before are left out.
///
/// At least two different points.
#[component("71b5b089-500a-4ea6-81c5-2f960441a0e8", name = "PolyLine", nick = "PLine", at = "Curve/Spline")]
#[output("Polyline", "Pl", "The polyline; vertex number i is at parameter i.")]
fn polyline(
    /// The points.
    #[port("Vertices", "V")]
    vertices_: List<Point3>,
    /// Whether a last segment leads back to the first point.
    #[port("Closed", "C", default = false)]
    closed: bool,
) -> Result<Shared<Curve>, Message> {
    let mut points = vertices(&vertices_)?;
    points.dedup();
    if closed && points.len() > 2 && points.first() != points.last() {
        points.extend(points.first().copied());
    }
    Ok(shared(PolylineCurve::new(points).map_err(warning)?))
}

/// The NURBS curve with these control points, all of weight 1, over uniform knots.
///
/// With fewer points than the degree needs, the degree is lowered, with a warning.
#[component(
    "dde71aef-d6ed-40a6-af98-6b0673983c82",
    name = "Nurbs Curve",
    nick = "Nurbs",
    at = "Curve/Spline"
)]
#[output("Curve", "C", "The curve.")]
#[output("Length", "L", "Its length.")]
#[output("Domain", "D", "Its domain.")]
fn nurbs_curve(
    context: &Context<'_>,
    /// The control points; nulls are left out.
    #[port("Vertices", "V")]
    vertices_: List<Point3>,
    /// The degree, 1 to 11.
    #[port("Degree", "D", default = 3)]
    degree_: i32,
    /// Whether the curve closes smoothly round all points.
    #[port("Periodic", "P", default = false)]
    periodic: bool,
) -> Result<(Shared<Curve>, f64, Interval), Message> {
    let mut points = vertices(&vertices_)?;
    let wanted = degree(degree_)?;
    if periodic && points.len() > 2 && points.first() == points.last() {
        points.pop();
    }
    let most = if periodic { points.len() } else { points.len() - 1 };
    if wanted > most {
        context.warn(format!("{} points are too few for degree {wanted}: it is {most} here", points.len()));
    }
    let p = wanted.min(most);
    let curve = match periodic {
        true if p == 1 => {
            points.extend(points.first().copied());
            Curve::from(PolylineCurve::new(points).map_err(warning)?)
        }
        true => NurbsCurve::periodic_uniform(p, &points).map_err(warning)?.into(),
        false => NurbsCurve::clamped_uniform(p, &points).map_err(warning)?.into(),
    };
    Ok(measured(curve))
}

/// The NURBS curve with these control points, weights and knots. The degree follows from the number of knots.
///
/// As many knots as points + degree - 1, as Rhino counts them; two more, as textbooks do, are understood too.
#[component(
    "1f8e1ff7-8278-4421-b39d-350e71d85d37",
    name = "Nurbs Curve PWK",
    nick = "NurbCrv",
    at = "Curve/Spline"
)]
#[output("Curve", "C", "The curve.")]
#[output("Length", "L", "Its length.")]
#[output("Domain", "D", "Its domain.")]
fn nurbs_curve_pwk(
    /// The control points.
    #[port("Points", "P")]
    points_: List<Point3>,
    /// One weight a point, each greater than 0; without any all are 1.
    #[port("Weights", "W", optional)]
    weights: List<f64>,
    /// The knots, which must not fall.
    #[port("Knots", "K")]
    knots: List<f64>,
) -> Result<(Shared<Curve>, f64, Interval), Message> {
    let points = vertices(&points_)?;
    let mut knots: Vec<f64> = knots.present().collect();
    let mut weights: Vec<f64> = weights.present().collect();
    if weights.is_empty() {
        weights = vec![1.0; points.len()];
    }
    let n = points.len();
    // A clamped knot vector repeats its ends degree times in Rhino, once more in textbooks.
    let repeated = knots.iter().take_while(|k| Some(*k) == knots.first()).count();
    if repeated > 1 && knots.len() == n + repeated {
        knots.pop();
        knots.remove(0);
    }
    let p = (knots.len() + 1).checked_sub(n).filter(|&p| p > 0);
    let p = p.ok_or_else(|| Message::error(format!("{} knots are too few for {n} points", knots.len())))?;
    Ok(measured(Curve::Nurbs(NurbsCurve::with_weights(p, &points, &weights, knots)?)))
}

/// The knots of a uniform NURBS curve, as Rhino counts them: points + degree - 1.
#[component(
    "846470bd-4918-4d00-9388-7e022b2cba73",
    name = "Knot Vector",
    nick = "Knots",
    at = "Curve/Spline"
)]
#[output("Knots", "K", "The knots.")]
fn knot_vector(
    /// The number of control points.
    #[port("Count", "N")]
    count: i32,
    /// The degree, 1 to 11.
    #[port("Degree", "D", default = 3)]
    degree_: i32,
    /// Whether the curve closes smoothly; else it ends in its end points.
    #[port("Periodic", "P", default = false)]
    periodic: bool,
    context: &Context<'_>,
) -> Result<Vec<f64>, Message> {
    let (n, p) = (usize::try_from(count).unwrap_or(0), degree(degree_)?);
    context.items(n.saturating_add(p))?;
    Ok(if periodic { periodic_uniform_knots(p, n)? } else { clamped_uniform_knots(p, n)? })
}

fn interpolated(
    points: &[Point3],
    p: usize,
    style: KnotSpacing,
    ends: [Option<Vector3>; 2],
) -> Result<Curve, Message> {
    let [start, end] = ends;
    let distinct = points.windows(2).filter(|w| w.first() != w.last()).count() + 1;
    // Beside the cubic, there must be more points than the degree.
    let p = if p == 3 { 3 } else { p.min(distinct.saturating_sub(1)).max(1) };
    Ok(NurbsCurve::interpolate(p, points, style, start, end).map_err(warning)?.into())
}

/// A smooth curve through points, in order. Nulls and points that repeat the one before are left out.
///
/// An even degree is raised by one, with a warning.
#[component(
    "2b2a4145-3dff-41d4-a8de-1ea9d29eef33",
    name = "Interpolate",
    nick = "IntCrv",
    at = "Curve/Spline",
    also("f5ea9d41-f062-487e-8dbf-7666ca53fbcd")
)]
#[output("Curve", "C", "The curve.")]
#[output("Length", "L", "Its length.")]
#[output("Domain", "D", "Its domain.")]
fn interpolate(
    context: &Context<'_>,
    /// The points.
    #[port("Vertices", "V")]
    vertices_: List<Point3>,
    /// The degree; 3 for the usual curve.
    #[port("Degree", "D", default = 3)]
    degree_: i32,
    /// Whether the curve closes smoothly.
    #[port("Periodic", "P", default = false)]
    periodic: bool,
    /// How parameters grow from point to point: 0 evenly, 1 by distance, 2 by its square root.
    #[port("KnotStyle", "K", default = 1)]
    style: i32,
) -> Result<(Shared<Curve>, f64, Interval), Message> {
    let points = vertices(&vertices_)?;
    let mut p = degree(degree_)?;
    if p % 2 == 0 {
        p += 1;
        context.warn(format!("The degree must be odd: {p} is used instead of {degree_}"));
    }
    let style = spacing(style)?;
    let curve = if periodic && points.len() > 2 {
        NurbsCurve::interpolate_periodic(p, &points, style).map_err(warning)?.into()
    } else {
        interpolated(&points, p, style, [None, None])?
    };
    Ok(measured(curve))
}

/// A smooth cubic curve through points with given directions at its ends.
#[component(
    "75eb156d-d023-42f9-a85e-2f2456b8bcce",
    name = "Interpolate (t)",
    nick = "IntCrv(t)",
    at = "Curve/Spline"
)]
#[output("Curve", "C", "The curve.")]
#[output("Length", "L", "Its length.")]
#[output("Domain", "D", "Its domain.")]
fn interpolate_t(
    /// The points.
    #[port("Vertices", "V")]
    vertices_: List<Point3>,
    /// The direction in which the curve leaves the first point; zero for a free end.
    #[port("Tangent Start", "Ts")]
    start: Vector3,
    /// The direction in which it reaches the last point; zero for a free end.
    #[port("Tangent End", "Te")]
    end: Vector3,
    /// How parameters grow from point to point: 0 evenly, 1 by distance, 2 by its square root.
    #[port("KnotStyle", "K", default = 1)]
    style: i32,
) -> Result<(Shared<Curve>, f64, Interval), Message> {
    let some = |v: Vector3| v.unitized().map(|_| v);
    Ok(measured(interpolated(&vertices(&vertices_)?, 3, spacing(style)?, [some(start), some(end)])?))
}

/// A smooth curve through points with kinks where the way turns sharply.
#[component(
    "6f0993e8-5f2f-4fc0-bd73-b84bc240e78e",
    name = "Kinky Curve",
    nick = "KinkCrv",
    at = "Curve/Spline"
)]
#[output("Curve", "C", "The curve.")]
#[output("Length", "L", "Its length.")]
#[output("Domain", "D", "Its domain.")]
fn kinky_curve(
    /// The points.
    #[port("Vertices", "V")]
    vertices_: List<Point3>,
    /// The degree of the smooth parts.
    #[port("Degree", "D", default = 3)]
    degree_: i32,
    /// A point becomes a kink when the angle between its neighbours, as seen from it, is at most this, in radians.
    #[port("Angle", "A", default = 2.108497363)]
    angle: f64,
) -> Result<(Shared<Curve>, f64, Interval), Message> {
    let mut points = vertices(&vertices_)?;
    points.dedup();
    let p = degree(degree_)? | 1;
    let mut parts: Vec<Curve> = Vec::new();
    let mut run: Vec<Point3> = Vec::new();
    for (i, &point) in points.iter().enumerate() {
        run.push(point);
        let neighbours = i.checked_sub(1).and_then(|k| points.get(k)).zip(points.get(i + 1));
        let kink = neighbours
            .is_some_and(|(a, b)| (*a - point).angle_to(*b - point).is_some_and(|corner| corner <= angle));
        if (kink || i + 1 == points.len()) && run.len() > 1 {
            parts.push(interpolated(&run, p, KnotSpacing::Chord, [None, None])?);
            run = vec![point];
        }
    }
    if parts.len() == 1 {
        return Ok(measured(parts.remove(0)));
    }
    Ok(measured(PolyCurve::new(parts).map_err(warning)?))
}

/// The cubic span between two points that leaves and reaches them with given velocities (its first derivatives over the
/// domain 0 to 1).
#[component(
    "30ce59ce-22a1-49ee-9e21-e6d16b3684a8",
    name = "Bezier Span",
    nick = "BzSpan",
    at = "Curve/Spline"
)]
#[output("Curve", "C", "The span.")]
#[output("Length", "L", "Its length.")]
#[output("Domain", "D", "Its domain.")]
fn bezier_span(
    /// Where it starts.
    #[port("Start point", "A")]
    a: Point3,
    /// The velocity at the start.
    #[port("Start tangent", "At")]
    at: Vector3,
    /// Where it ends.
    #[port("End point", "B")]
    b: Point3,
    /// The velocity at the end.
    #[port("End tangent", "Bt")]
    bt: Vector3,
) -> Result<(Shared<Curve>, f64, Interval), Message> {
    let controls = hermite_to_bezier(a, at, b, bt);
    Ok(measured(Curve::Nurbs(NurbsCurve::bezier(&controls).map_err(warning)?)))
}

/// A part of a curve between two parameters. On a closed curve a falling range goes through the seam.
#[component("429cbba9-55ee-4e84-98ea-876c44db879a", name = "Sub Curve", nick = "SubCrv", at = "Curve/Spline")]
#[output("Curve", "C", "The part.")]
fn sub_curve(
    /// The curve.
    #[port("Base curve", "C")]
    curve: &Curve,
    /// From where to where.
    #[port("Domain", "D")]
    range: Interval,
) -> Result<Shared<Curve>, Message> {
    Ok(shared(curve.sub_curve(range).map_err(warning)?))
}

/// A curve between two others: points of equal parameters are mixed.
///
/// Control points are, where those of both curves have the same weights once both have the same degree and knots; curves with different
/// weights, such as an arc and a line, are followed within the tolerance. The curves run alongside each other from start to start; flip
/// one when they do not.
#[component(
    "139619d2-8b18-47b6-b3b9-bf4fec0d6eb1",
    name = "Tween Curve",
    nick = "TweenCrv",
    at = "Curve/Spline"
)]
#[output("Tween", "T", "The curve between.")]
fn tween_curve(
    context: &Context<'_>,
    /// The curve at factor 0.
    #[port("Curve A", "A")]
    a: &Curve,
    /// The curve at factor 1.
    #[port("Curve B", "B")]
    b: &Curve,
    /// 0 gives A, 1 gives B; other numbers go beyond them.
    #[port("Factor", "F", default = 0.5)]
    factor: f64,
) -> Result<Shared<Curve>, Message> {
    let unit = |curve: &Curve| -> Result<NurbsCurve, Message> {
        Ok(curve.with_domain(Interval::UNIT)?.to_nurbs()?.clamped()?)
    };
    let parts = [(unit(a)?, 1.0 - factor), (unit(b)?, factor)];
    let tween = combined_curves(&parts, context.tolerance().absolute).map_err(warning)?;
    Ok(shared(Curve::Nurbs(tween)))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Arc, Circle, Curve, Interval, Line, Plane, Point3, Vector3};

    fn points(xy: &[[f64; 2]]) -> Vec<Point3> {
        xy.iter().map(|&[x, y]| Point3::new(x, y, 0.0)).collect()
    }

    fn curve(trial: Trial) -> Curve {
        let outcome = trial.run();
        let Some(Value::Curve(curve)) = outcome.outputs[0].column().get(0) else {
            panic!("no curve: {:?}", outcome.messages)
        };
        (*curve).clone()
    }

    const BEND: [[f64; 2]; 5] = [[0.0, 0.0], [3.0, 4.0], [-1.0, 4.0], [-4.0, 0.0], [-4.0, -3.0]];

    #[test]
    fn polylines() {
        let line =
            curve(Trial::of("PolyLine").list(points(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [1.0, 1.0]])));
        assert_eq!(line.domain(), Interval::new(0.0, 2.0));
        let closed = curve(Trial::of("PolyLine").list(points(&BEND)).item(true));
        assert!(closed.is_closed());
        assert!(Trial::of("PolyLine").list(points(&[[0.0, 0.0]])).message().contains("two points"));
    }

    #[test]
    fn nurbs_curves() {
        let made = Trial::of("Nurbs Curve").list(points(&BEND)).run();
        assert_eq!(texts(&made.outputs[2]), ["{0}: 0 To 2"]);
        let periodic = curve(Trial::of("Nurbs Curve").list(points(&BEND)).item(3).item(true));
        assert!(periodic.is_periodic());
        assert_eq!(periodic.domain(), Interval::new(0.0, 5.0));
        let few = Trial::of("Nurbs Curve").list(points(&BEND[..2])).run();
        assert_eq!(texts(&few.outputs[1]), ["{0}: 5"]);
        assert!(few.messages[0].text.contains("too few"));
        let knots = [0.0, 0.0, 1.0, 1.0];
        let arc = |knots: &[f64]| {
            Trial::of("Nurbs Curve PWK").list(points(&BEND[..3])).list([1.0, 1.0, 1.0]).list(knots.to_vec())
        };
        assert_eq!(curve(arc(&knots)), curve(arc(&[0.0, 0.0, 0.0, 1.0, 1.0, 1.0])));
        assert_eq!(Trial::of("Knot Vector").item(5).texts(0), ["{0;0}: 0, 0, 0, 1, 2, 2, 2"]);
        assert_eq!(Trial::of("Knot Vector").item(5).item(3).item(true).texts(0)[0].split(", ").count(), 7);
    }

    #[test]
    fn interpolation_as_rhino_prints_it() {
        let Curve::Nurbs(made) = curve(Trial::of("Interpolate").list(points(&BEND))) else {
            panic!("a NURBS curve")
        };
        assert_eq!(made.knots(), [0.0, 0.0, 0.0, 5.0, 9.0, 14.0, 17.0, 17.0, 17.0]);
        let second = made.control_point(1).unwrap();
        assert!(second.distance_to(Point3::new(1.278803, 1.06885, 0.0)) < 1e-6);
        let even = Trial::of("Interpolate").list(points(&BEND)).item(2);
        assert!(even.message().contains("odd"));
        assert!(curve(Trial::of("Interpolate").list(points(&BEND)).item(3).item(true)).is_periodic());
        assert!(
            Trial::of("Interpolate")
                .list(points(&BEND))
                .item(3)
                .item(false)
                .item(9)
                .message()
                .contains("style")
        );
        let tangent = Trial::of("Interpolate (t)").list(points(&BEND)).item(Vector3::X).item(Vector3::Y);
        let tangent = curve(tangent);
        assert!(tangent.tangent_at(0.0).unwrap().dot(Vector3::X) > 1.0 - 1e-12);
    }

    #[test]
    fn kinks_spans_and_parts() {
        let corner = points(&[[0.0, 0.0], [2.0, 0.1], [4.0, 0.0], [4.0, 4.0]]);
        let Curve::Poly(kinky) = curve(Trial::of("Kinky Curve").list(corner)) else { panic!("two parts") };
        assert_eq!(kinky.segments().len(), 2);
        let span = Trial::of("Bezier Span").item(Point3::ORIGIN).item(Vector3::X * 3.0);
        let span = span.item(Point3::new(3.0, 0.0, 0.0)).item(Vector3::X * 3.0);
        assert_eq!(span.texts(1), ["{0}: 3"]);
        let line = Line::new(Point3::ORIGIN, Point3::new(8.0, 0.0, 0.0));
        let part = curve(Trial::of("Sub Curve").item(line).item(Interval::new(0.25, 0.625)));
        assert_eq!(part.length(), 3.0);
    }

    #[test]
    fn between_curves() {
        let low = Line::new(Point3::ORIGIN, Point3::new(4.0, 0.0, 0.0));
        let high = points(&[[0.0, 2.0], [2.0, 6.0], [4.0, 2.0]]);
        let high = Trial::of("PolyLine").list(high).run().outputs[0].clone();
        let middle = curve(Trial::of("Tween Curve").item(low).tree(high).item(0.5));
        assert!(middle.point_at(0.5).distance_to(Point3::new(2.0, 3.0, 0.0)) < 1e-12);
    }

    /// Circles have the same weights, a circle and an arc do not.
    #[test]
    fn tweens_of_rational_curves_are_means_without_kinks() {
        let circle = |centre: Point3, radius: f64| {
            Curve::from(Circle::new(Plane::XY.with_origin(centre), radius).unwrap())
        };
        let tween =
            |a: &Curve, b: &Curve| curve(Trial::of("Tween Curve").item(a.clone()).item(b.clone()).item(0.5));
        let shifted = tween(&circle(Point3::ORIGIN, 2.0), &circle(Point3::new(3.0, 1.0, 5.0), 2.0));
        assert!((shifted.as_circle(1e-9).unwrap().radius - 2.0).abs() < 1e-9);
        let between = tween(&circle(Point3::ORIGIN, 1.0), &circle(Point3::ORIGIN, 3.0));
        assert!((between.as_circle(1e-9).unwrap().radius - 2.0).abs() < 1e-9);
        let (round, bow) = (circle(Point3::ORIGIN, 2.0), {
            let [a, b, c] = [[2.0, 0.0, 1.0], [0.0, 3.0, 4.0], [-2.5, 0.0, 1.0]].map(Point3::from);
            Curve::from(Arc::through(a, b, c).unwrap())
        });
        let mixed = tween(&round, &bow);
        // Parameters are those of the NURBS forms, not angles.
        let (round, bow) = (round.to_nurbs().unwrap(), bow.to_nurbs().unwrap());
        let mut before: Option<Vector3> = None;
        for i in 0..=2000 {
            let t = f64::from(i) / 2000.0;
            let mean = round.point_at(round.domain().at(t)).lerp(bow.point_at(bow.domain().at(t)), 0.5);
            assert!(mixed.point_at(t).distance_to(mean) < 1e-3);
            let tangent = mixed.tangent_at(t).unwrap();
            assert!(before.is_none_or(|before| before.angle_to(tangent).unwrap() < 0.02), "a kink at {t}");
            before = Some(tangent);
        }
    }
}
