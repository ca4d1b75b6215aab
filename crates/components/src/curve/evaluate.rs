//! Curve / Analysis: what a curve is at a parameter.

use std::sync::Arc as Shared;

use katydid_component::{Context, Each, Message, component};
use katydid_geometry::{Circle, Curve, Interval, Plane, Point3, Vector3};

use super::shared;

/// Warns when a parameter lies outside a curve's domain.
fn within(context: &Context<'_>, curve: &Curve, t: f64) -> Result<f64, Message> {
    if !t.is_finite() {
        return Err(Message::error("The parameter is not a finite number"));
    }
    if !curve.domain().contains(t) {
        context.warn("The parameter lies outside the domain of the curve");
    }
    Ok(t)
}

/// The point, the tangent and the angle of the kink at a parameter.
fn at(curve: &Curve, t: f64) -> (Point3, Option<Vector3>, f64) {
    let (before, after) = (curve.tangent_on_side(t, true), curve.tangent_on_side(t, false));
    let inside = t > curve.domain().start && t < curve.domain().end;
    let kink = before.zip(after).filter(|_| inside).and_then(|(a, b)| a.angle_to(b)).unwrap_or(0.0);
    (curve.point_at(t), curve.tangent_at(t), kink)
}

/// The point and the tangent of a curve at a parameter.
#[component(
    "fc6979e4-7e91-4508-8e05-37c680779751",
    name = "Evaluate Curve",
    nick = "Eval",
    at = "Curve/Analysis",
    also("164d0429-e5f5-4292-aa80-3f88d43cdac2")
)]
#[output("Point", "P", "The point.")]
#[output("Tangent", "T", "The direction of the curve there, of length 1; behind a kink the outgoing one.")]
#[output("Angle", "A", "The angle of the kink there, in radians; 0 where the curve is smooth.")]
fn evaluate_curve(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The parameter, in the curve's own domain.
    #[port("Parameter", "t")]
    t: f64,
) -> Result<(Point3, Option<Vector3>, f64), Message> {
    Ok(at(curve, within(context, curve, t)?))
}

/// The point and the tangent of a curve at a parameter, and the length up to it.
#[component(
    "fdf09135-fae5-4e5f-b427-b1f384ca3009",
    name = "Evaluate Curve",
    nick = "Eval",
    at = "Curve/Analysis",
    old
)]
#[output("Point", "P", "The point.")]
#[output("Tangent", "T", "The direction of the curve there, of length 1.")]
#[output("Length", "L", "The length from the start of the curve.")]
fn evaluate_curve_with_length(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The parameter, in the curve's own domain.
    #[port("Parameter", "t")]
    t: f64,
) -> Result<(Point3, Option<Vector3>, f64), Message> {
    let (point, tangent, _) = at(curve, within(context, curve, t)?);
    let domain = curve.domain();
    let range = Interval::new(domain.start, domain.clamp(t));
    Ok((point, tangent, curve.length_between(range)))
}

/// The point and the tangent of a curve at a length from its start.
#[component(
    "6b021f56-b194-4210-b9a1-6cef3b7d0848",
    name = "Evaluate Length",
    nick = "Eval",
    at = "Curve/Analysis"
)]
#[output("Point", "P", "The point; nothing beyond the ends.")]
#[output("Tangent", "T", "The direction of the curve there, of length 1.")]
#[output("Parameter", "t", "The parameter, in the curve's own domain.")]
fn evaluate_length(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The length, or with `Normalized` the part of the whole length, 0 to 1.
    #[port("Length", "L")]
    length: f64,
    /// Whether the length is a part of the whole.
    #[port("Normalized", "N", default = true)]
    normalized: bool,
) -> Result<(Point3, Option<Vector3>, f64), Message> {
    let t = if normalized {
        curve.parameter_at_normalized_length(length)
    } else {
        curve.parameter_at_length(length)
    };
    let t = t.ok_or_else(|| Message::warning("The length lies beyond the ends of the curve"))?;
    Ok((curve.point_at(t), curve.tangent_at(t), t))
}

/// The point of a curve nearest to a point.
#[component(
    "2dc44b22-b1dd-460a-a704-6462d6e91096",
    name = "Curve Closest Point",
    nick = "Crv CP",
    at = "Curve/Analysis"
)]
#[output("Point", "P", "The nearest point.")]
#[output("Parameter", "t", "Its parameter, in the curve's own domain.")]
#[output("Distance", "D", "The distance to it.")]
fn curve_closest_point(
    /// The point to start from.
    #[port("Point", "P")]
    point: Point3,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Result<(Point3, f64, f64), Message> {
    let near = curve.closest_point(point)?;
    Ok((near.point, near.parameter, near.distance))
}

/// How strongly a curve bends at a parameter.
#[component(
    "aaa665bd-fd6e-4ccb-8d2c-c5b33072125d",
    name = "Curvature",
    nick = "Curvature",
    at = "Curve/Analysis"
)]
#[output("Point", "P", "The point.")]
#[output(
    "Curvature",
    "K",
    "Towards the centre of the bend; its length is 1 / radius, 0 where the curve is straight."
)]
#[output("Curvature", "C", "The circle that fits the bend best; nothing where the curve is straight.")]
fn curvature(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The parameter, in the curve's own domain.
    #[port("Parameter", "t")]
    t: f64,
) -> Result<(Point3, Vector3, Option<Shared<Curve>>), Message> {
    let t = within(context, curve, t)?;
    let (point, k) = (curve.point_at(t), curve.curvature_at(t));
    let circle = curve.tangent_at(t).filter(|_| k.length() > 0.0).and_then(|tangent| {
        let center = point + k / k.length_squared();
        let plane = Plane::from_axes(center, point - center, tangent).ok()?;
        Circle::new(plane, 1.0 / k.length()).ok()
    });
    Ok((point, k, circle.map(shared)))
}

/// How strongly a curve leaves its plane of curvature at a parameter.
#[component(
    "dbe9fce4-b6b3-465f-9615-34833c4763bd",
    name = "Torsion",
    nick = "Torsion",
    at = "Curve/Analysis"
)]
#[output("Point", "P", "The point.")]
#[output("Torsion", "T", "The torsion: positive for a right-hand screw, 0 for a planar curve.")]
fn torsion(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The parameter, in the curve's own domain.
    #[port("Parameter", "t")]
    t: f64,
) -> Result<(Point3, f64), Message> {
    let t = within(context, curve, t)?;
    Ok((curve.point_at(t), curve.torsion_at(t)))
}

/// A frame, or a warning where the curve has none.
fn frame(plane: Option<Plane>) -> Result<Plane, Message> {
    plane.ok_or_else(|| Message::warning("The curve has no frame there"))
}

/// The frame of a curve at a parameter: x along the curve, y towards the centre of its bend.
#[component(
    "6b2a5853-07aa-4329-ba84-0a5d46b51dbd",
    name = "Curve Frame",
    nick = "Frame",
    at = "Curve/Analysis"
)]
#[output("Frame", "F", "The frame.")]
fn curve_frame(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The parameter, in the curve's own domain.
    #[port("Parameter", "t")]
    t: f64,
) -> Result<Plane, Message> {
    frame(curve.frame_at(within(context, curve, t)?))
}

/// The level frame of a curve at a parameter: x along the curve as seen from above, z straight up.
///
/// There is none where the curve is vertical.
#[component(
    "c048ad76-ffcd-43b1-a007-4dd1b2373326",
    name = "Horizontal Frame",
    nick = "HFrame",
    at = "Curve/Analysis"
)]
#[output("Frame", "F", "The frame.")]
fn horizontal_frame(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The parameter, in the curve's own domain.
    #[port("Parameter", "t")]
    t: f64,
) -> Result<Plane, Message> {
    frame(curve.horizontal_frame_at(within(context, curve, t)?))
}

/// The frame across a curve at a parameter: z along the curve, x and y turning about it as little as possible from its
/// start on.
#[component(
    "69f3e5ee-4770-44b3-8851-ae10ae555398",
    name = "Perp Frame",
    nick = "PFrame",
    at = "Curve/Analysis"
)]
#[output("Frame", "F", "The frame.")]
fn perp_frame(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The parameter, in the curve's own domain.
    #[port("Parameter", "t")]
    t: f64,
) -> Result<Plane, Message> {
    frame(curve.perpendicular_frame_at(within(context, curve, t)?))
}

/// The derivatives of a curve by its parameter: velocity, acceleration and so on, one on each output.
#[component(
    "ab14760f-87a6-462e-b481-4a2c26a9a0d7",
    name = "Derivatives",
    nick = "CDiv",
    at = "Curve/Analysis"
)]
#[output("Point", "P", "The point.")]
#[output("First derivative", "1", "The derivative; each further output is one of the next order.")]
fn derivatives(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The parameter, in the curve's own domain.
    #[port("Parameter", "t")]
    t: f64,
) -> Result<(Point3, Each<Option<Vector3>>), Message> {
    let t = within(context, curve, t)?;
    let count = context.output_count().saturating_sub(1);
    let (point, derivatives) = curve.derivatives(t, count, t >= curve.domain().end);
    Ok((point, Each(derivatives.into_iter().map(Some).collect())))
}

/// The derivatives of a curve by its parameter: velocity, acceleration and so on.
#[component(
    "c2e16ca3-9508-4fa4-aeb3-0b1f0ebb72e3",
    name = "Derivatives",
    nick = "CDiv",
    at = "Curve/Analysis",
    old
)]
#[output("Point", "P", "The point.")]
#[output("Derivatives", "d", "The derivatives in order.")]
fn derivatives_as_list(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The parameter, in the curve's own domain.
    #[port("Parameter", "t")]
    t: f64,
    /// How many derivatives, 0 to 64.
    #[port("Count", "N", default = 1)]
    count: i32,
) -> Result<(Point3, Vec<Vector3>), Message> {
    let t = within(context, curve, t)?;
    let count = usize::try_from(count).ok().filter(|&n| n <= 64);
    let count = count.ok_or_else(|| Message::error("The number of derivatives goes from 0 to 64"))?;
    Ok(curve.derivatives(t, count, t >= curve.domain().end))
}

/// The length of a part of a curve.
#[component(
    "188edd02-14a9-4828-a521-34995b0d1e4a",
    name = "Length Domain",
    nick = "LenD",
    at = "Curve/Analysis"
)]
#[output("Length", "L", "The length of the part.")]
fn length_domain(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// From which parameter to which; only what lies in the curve's domain counts.
    #[port("Domain", "D")]
    range: Interval,
) -> Result<f64, Message> {
    let (own, range) = (curve.domain(), range.ordered());
    let part = own.intersection(range).ok_or_else(|| Message::warning("The part lies outside the curve"))?;
    Ok(curve.length_between(part))
}

/// The length of a curve before and behind a parameter.
#[component(
    "a1c16251-74f0-400f-9e7c-5e379d739963",
    name = "Length Parameter",
    nick = "LenP",
    at = "Curve/Analysis"
)]
#[output("Length", "L-", "From the start to the parameter.")]
#[output("Length", "L+", "From the parameter to the end.")]
fn length_parameter(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The parameter, in the curve's own domain.
    #[port("Parameter", "P")]
    t: f64,
) -> Result<(f64, f64), Message> {
    let domain = curve.domain();
    let t = domain.clamp(within(context, curve, t)?);
    let part = |a, b| curve.length_between(Interval::new(a, b));
    Ok((part(domain.start, t), part(t, domain.end)))
}

/// The point in the middle of a curve's length.
#[component(
    "ccc7b468-e743-4049-891f-299432545898",
    name = "Curve Middle",
    nick = "MidPt",
    at = "Curve/Analysis"
)]
#[output("Midpoint", "M", "The middle.")]
fn curve_middle(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Result<Point3, Message> {
    let t = curve.parameter_at_normalized_length(0.5);
    t.map(|t| curve.point_at(t)).ok_or_else(|| Message::warning("The curve has no length"))
}

/// Where a curve starts and ends; for a closed curve it is one place.
#[component("11bbd48b-bb0a-4f1b-8167-fa297590390d", name = "End Points", nick = "End", at = "Curve/Analysis")]
#[output("Start", "S", "The start.")]
#[output("End", "E", "The end.")]
fn end_points(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> (Point3, Point3) {
    (curve.start(), curve.end())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Circle, Curve, Interval, Line, Plane, Point3, PolylineCurve};

    const LINE: Line = Line::new(Point3::ORIGIN, Point3::new(4.0, 0.0, 0.0));

    fn circle() -> Circle {
        Circle { plane: Plane::XY, radius: 2.0 }
    }

    fn corner() -> Curve {
        let points = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0]].map(Point3::from);
        PolylineCurve::new(points.to_vec()).unwrap().into()
    }

    #[test]
    fn points_and_tangents() {
        let kink = Trial::of("Evaluate Curve").item(corner()).item(1.0).run();
        assert_eq!(texts(&kink.outputs[0]), ["{0}: {4, 0, 0}"]);
        assert_eq!(texts(&kink.outputs[1]), ["{0}: {0, 1, 0}"]);
        assert_eq!(texts(&kink.outputs[2]), ["{0}: 1.570796"]);
        assert!(Trial::of("Evaluate Curve").item(corner()).item(9.0).message().contains("outside"));
        let length = Trial::of_guid("fdf09135-fae5-4e5f-b427-b1f384ca3009").item(corner()).item(1.5);
        assert_eq!(length.texts(2), ["{0}: 6"]);
        assert_eq!(Trial::of("Evaluate Length").item(corner()).item(0.75).texts(0), ["{0}: {4, 2, 0}"]);
        let metres = |l: f64| Trial::of("Evaluate Length").item(corner()).item(l).item(false);
        assert_eq!(metres(2.0).texts(2), ["{0}: 0.5"]);
        assert_eq!(metres(9.0).texts(0), ["{0}: null"]);
        let near = Trial::of("Curve Closest Point").item(Point3::new(1.0, 2.0, 0.0)).item(LINE).run();
        assert_eq!(texts(&near.outputs[1]), ["{0}: 0.25"]);
        assert_eq!(Trial::of("End Points").item(corner()).texts(1), ["{0}: {4, 4, 0}"]);
        assert_eq!(Trial::of("Curve Middle").item(corner()).texts(0), ["{0}: {4, 0, 0}"]);
    }

    #[test]
    fn bends_and_frames() {
        let bend = Trial::of("Curvature").item(circle()).item(0.0).run();
        assert_eq!(texts(&bend.outputs[1])[0].replace("-0}", "0}").replace("-0,", "0,"), "{0}: {-0.5, 0, 0}");
        assert_eq!(Trial::of("Curvature").item(LINE).item(0.0).texts(2), ["{0}: null"]);
        assert_eq!(Trial::of("Torsion").item(circle()).item(0.0).texts(1), ["{0}: 0"]);
        let frame = |name| Trial::of(name).item(circle()).item(0.0).texts(0)[0].clone();
        assert!(frame("Curve Frame").ends_with("0.00,1.00)"));
        assert!(frame("Horizontal Frame").ends_with("0.00,1.00)"));
        assert!(frame("Perp Frame").contains(",1.00,"));
        let up = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 1.0));
        assert_eq!(Trial::of("Horizontal Frame").item(up).item(0.0).texts(0), ["{0}: null"]);
    }

    #[test]
    fn derivatives_and_lengths() {
        let both = Trial::of("Derivatives").item(LINE).item(1.0).outputs(3).run();
        assert_eq!(texts(&both.outputs[1]), ["{0}: {4, 0, 0}"]);
        assert_eq!(texts(&both.outputs[2]), ["{0}: {0, 0, 0}"]);
        let list = Trial::of_guid("c2e16ca3-9508-4fa4-aeb3-0b1f0ebb72e3").item(LINE).item(1.0).item(2);
        assert_eq!(list.texts(1), ["{0;0}: {4, 0, 0}, {0, 0, 0}"]);
        let part = Trial::of("Length Domain").item(corner()).item(Interval::new(0.5, 9.0));
        assert_eq!(part.texts(0), ["{0}: 6"]);
        assert_eq!(Trial::of("Length Parameter").item(corner()).item(0.5).texts(1), ["{0}: 6"]);
    }
}
