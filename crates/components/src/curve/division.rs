//! Curve / Division.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{ArcLength, Continuity, Curve, Interval, Plane, Point3, Vector3};

use super::warning;

/// Points, tangents and parameters of a division.
type Division = (Vec<Point3>, Vec<Option<Vector3>>, Vec<f64>);

fn divided(context: &Context<'_>, curve: &Curve, parameters: Vec<f64>) -> Result<Division, Message> {
    context.items(parameters.len().saturating_mul(3))?;
    let points = parameters.iter().map(|&t| curve.point_at(t)).collect();
    let tangents = if context.is_wanted(1) {
        parameters.iter().map(|&t| curve.tangent_at(t)).collect()
    } else {
        Vec::new()
    };
    Ok((points, tangents, parameters))
}

/// The parameters of a division into a number of equal parts.
fn parts(context: &Context<'_>, curve: &Curve, count: i32) -> Result<Vec<f64>, Message> {
    let count = usize::try_from(count).ok().filter(|&n| n > 0);
    let count = count.ok_or_else(|| Message::error("The count must be at least 1"))?;
    context.items(count)?;
    curve.divide_by_count(count).map_err(warning)
}

/// Divides a curve into parts of equal length.
///
/// An open curve gets a point more than parts, with both ends; a closed one as many, from its seam on.
#[component(
    "2162e72e-72fc-4bf8-9459-d4d82fa8aa14",
    name = "Divide Curve",
    nick = "Divide",
    at = "Curve/Division",
    also("93b1066f-060e-440d-a638-aae8cbe7acb7")
)]
#[output("Points", "P", "The division points.")]
#[output("Tangents", "T", "The directions of the curve there.")]
#[output("Parameters", "t", "Their parameters, in the curve's own domain.")]
fn divide_curve(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The number of parts, at least 1.
    #[port("Count", "N", default = 10)]
    count: i32,
    /// Whether kinks are added as division points.
    #[port("Kinks", "K", default = false)]
    kinks: bool,
) -> Result<(Vec<Point3>, Vec<Option<Vector3>>, Vec<f64>), Message> {
    let mut parameters = parts(context, curve, count)?;
    if kinks {
        let domain = curve.domain();
        parameters.extend(curve.discontinuities(Continuity::G1, &context.tolerance()));
        parameters.sort_by(f64::total_cmp);
        parameters.dedup_by(|b, a| *b - *a <= 1e-12 * domain.length());
    }
    divided(context, curve, parameters)
}

/// Divides a curve at steps of a length along it, from its start. What is left at the end gets no point.
#[component(
    "fdc466a9-d3b8-4056-852a-09dba0f74aca",
    name = "Divide Length",
    nick = "DivLength",
    at = "Curve/Division"
)]
#[output("Points", "P", "The division points.")]
#[output("Tangents", "T", "The directions of the curve there.")]
#[output("Parameters", "t", "Their parameters, in the curve's own domain.")]
fn divide_length(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The length of a step; greater than 0.
    #[port("Length", "L")]
    length: f64,
) -> Result<(Vec<Point3>, Vec<Option<Vector3>>, Vec<f64>), Message> {
    if length > 0.0 {
        context.items((curve.length() / length) as usize)?;
    }
    let parameters = curve.divide_by_length(length)?;
    divided(context, curve, parameters)
}

/// Divides a curve so that neighbouring points are a straight distance apart, from its start. What is left at the end
/// gets no point.
#[component(
    "1e531c08-9c80-46d6-8850-1b50d1dae69f",
    name = "Divide Distance",
    nick = "DivDist",
    at = "Curve/Division"
)]
#[output("Points", "P", "The division points.")]
#[output("Tangents", "T", "The directions of the curve there.")]
#[output("Parameters", "t", "Their parameters, in the curve's own domain.")]
fn divide_distance(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The distance from point to point; greater than 0.
    #[port("Distance", "D")]
    distance: f64,
) -> Result<(Vec<Point3>, Vec<Option<Vector3>>, Vec<f64>), Message> {
    if distance > 0.0 {
        context.items((curve.length() / distance) as usize)?;
    }
    let parameters = curve.divide_by_distance(distance)?;
    divided(context, curve, parameters)
}

/// Cuts a curve at parameters.
///
/// Parameters outside the domain and repeated ones are ignored. On a closed curve the piece over the seam is one, the last.
#[component(
    "2ad2a4d4-3de1-42f6-a4b8-f71835f35710",
    name = "Shatter",
    nick = "Shatter",
    at = "Curve/Division"
)]
#[output("Segments", "S", "The pieces in order.")]
fn shatter(
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// Where to cut, in the curve's own domain; nulls are skipped.
    #[port("Parameters", "t")]
    parameters: List<f64>,
) -> Result<Vec<Shared<Curve>>, Message> {
    let parameters: Vec<f64> = parameters.present().collect();
    Ok(curve.split_at(&parameters)?.into_iter().map(Shared::new).collect())
}

/// Frames across a curve at parts of equal length: z along the curve, x and y turning as little as possible.
#[component(
    "983c7600-980c-44da-bc53-c804067f667f",
    name = "Perp Frames",
    nick = "PFrames",
    at = "Curve/Division",
    also("6da4b70c-ce98-4d52-a2bb-2fadccf39da0")
)]
#[output("Frames", "F", "The frames; null where the curve has no direction.")]
#[output("Parameters", "t", "Their parameters, in the curve's own domain.")]
fn perp_frames(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The number of parts, at least 1.
    #[port("Count", "N", default = 10)]
    count: i32,
    /// Whether each frame follows from the one before; otherwise each stands by itself.
    #[port("Align", "A", default = true)]
    align: bool,
) -> Result<(Vec<Option<Plane>>, Vec<f64>), Message> {
    let parameters = parts(context, curve, count)?;
    let frames = if align {
        curve.perpendicular_frames(&parameters)
    } else {
        let alone = |&t: &f64| Plane::from_normal(curve.point_at(t), curve.tangent_at(t)?).ok();
        parameters.iter().map(alone).collect()
    };
    Ok((frames, parameters))
}

/// Level frames along a curve at parts of equal length: x along the curve as seen from above, z straight up.
#[component(
    "8d058945-ce47-4e7c-82af-3269295d7890",
    name = "Horizontal Frames",
    nick = "HFrames",
    at = "Curve/Division"
)]
#[output("Frames", "F", "The frames; null where the curve is vertical.")]
#[output("Parameters", "t", "Their parameters, in the curve's own domain.")]
fn horizontal_frames(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The number of parts, at least 1.
    #[port("Count", "N", default = 10)]
    count: i32,
) -> Result<(Vec<Option<Plane>>, Vec<f64>), Message> {
    let parameters = parts(context, curve, count)?;
    Ok((parameters.iter().map(|&t| curve.horizontal_frame_at(t)).collect(), parameters))
}

/// Frames of a curve at parts of equal length: x along the curve, y towards the centre of its bend.
#[component(
    "0e94542a-2e46-4793-9f98-2200b06b28f4",
    name = "Curve Frames",
    nick = "Frames",
    at = "Curve/Division"
)]
#[output("Frames", "F", "The frames; null where the curve has no direction.")]
#[output("Parameters", "t", "Their parameters, in the curve's own domain.")]
fn curve_frames(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The number of parts, at least 1.
    #[port("Count", "N", default = 10)]
    count: i32,
) -> Result<(Vec<Option<Plane>>, Vec<f64>), Message> {
    let parameters = parts(context, curve, count)?;
    Ok((parameters.iter().map(|&t| curve.frame_at(t)).collect(), parameters))
}

/// Cuts a curve into dashes and gaps of given lengths, again and again until its end, which cuts the last one off.
#[component(
    "95866bbe-648e-4e2b-a97c-7d04679e94e0",
    name = "Dash Pattern",
    nick = "Dash",
    at = "Curve/Division"
)]
#[output("Dashes", "D", "The dashes.")]
#[output("Gaps", "G", "The gaps.")]
fn dash_pattern(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The lengths of dash, gap, dash, gap and so on; each at least 0, their sum greater than 0.
    #[port("Pattern", "Pt")]
    pattern: List<f64>,
) -> Result<(Vec<Shared<Curve>>, Vec<Shared<Curve>>), Message> {
    let pattern: Vec<f64> = pattern.present().collect();
    let sum: f64 = pattern.iter().sum();
    if pattern.iter().any(|x| !(*x >= 0.0)) || !(sum > 0.0) || !sum.is_finite() {
        return Err(Message::error("The pattern needs lengths of at least 0, with a sum greater than 0"));
    }
    let lengths = ArcLength::new(curve);
    let total = lengths.total();
    context.items(((total / sum) * pattern.len() as f64) as usize)?;
    let (mut dashes, mut gaps) = (Vec::new(), Vec::new());
    let (mut from, mut start) = (0.0, curve.domain().start);
    // A pattern of odd length goes on alternating: its second round begins with a gap.
    for (i, step) in pattern.iter().cycle().enumerate() {
        if from >= total * (1.0 - 1e-12) {
            break;
        }
        context.check()?;
        let to = from + step;
        let end = if to >= total { curve.domain().end } else { lengths.parameter_at(to) };
        if end > start {
            let piece = Shared::new(curve.trimmed(Interval::new(start, end))?);
            if i % 2 == 0 { dashes.push(piece) } else { gaps.push(piece) }
        }
        (from, start) = (to, end);
    }
    Ok((dashes, gaps))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Circle, Curve, Line, Plane, Point3, PolylineCurve};

    const LINE: Line = Line::new(Point3::ORIGIN, Point3::new(0.0, 96.0, 0.0));

    fn corner() -> Curve {
        let points = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0]].map(Point3::from);
        PolylineCurve::new(points.to_vec()).unwrap().into()
    }

    #[test]
    fn equal_parts() {
        let golden = Trial::of("Divide Curve").list([LINE, LINE]).item(10).texts(0);
        assert!(golden[0].starts_with("{0;0}: {0, 0, 0}, {0, 9.6, 0}, {0, 19.2, 0}"));
        assert!(golden[1].starts_with("{0;1}: {0, 0, 0}"));
        assert_eq!(golden[0].matches('{').count(), 12);
        let circle = Circle { plane: Plane::XY, radius: 1.0 };
        assert_eq!(Trial::of("Divide Curve").item(circle).item(4).run().outputs[0].item_count(), 4);
        let kinks = Trial::of("Divide Curve").item(corner()).item(3).item(true).texts(0);
        assert_eq!(kinks[0].matches("{4, 0, 0}").count(), 1);
        assert!(Trial::of("Divide Curve").item(LINE).item(0).message().contains("at least 1"));
    }

    #[test]
    fn steps() {
        assert_eq!(
            Trial::of("Divide Length").item(LINE).item(40.0).texts(2),
            ["{0;0}: 0, 0.416667, 0.833333"]
        );
        assert!(!Trial::of("Divide Length").item(LINE).item(0.0).message().is_empty());
        let straight = Trial::of("Divide Distance").item(corner()).item(32f64.sqrt()).texts(0);
        assert_eq!(straight[0].matches("{4, 4, 0}").count(), 1);
    }

    #[test]
    fn pieces() {
        let pieces = Trial::of("Shatter").item(Curve::from(LINE)).list([40.0, 500.0, 10.0, 40.0]).run();
        assert_eq!(pieces.outputs[0].item_count(), 3);
        let dashes = Trial::of("Dash Pattern").item(LINE).list([30.0, 10.0]).run();
        assert_eq!(dashes.outputs[0].item_count(), 3);
        assert_eq!(dashes.outputs[1].item_count(), 2);
        assert!(Trial::of("Dash Pattern").item(LINE).list([0.0]).message().contains("pattern"));
        assert_eq!(texts(&dashes.outputs[1]).len(), 1);
    }

    #[test]
    fn frames() {
        for name in ["Perp Frames", "Curve Frames"] {
            assert_eq!(Trial::of(name).item(LINE).item(2).run().outputs[0].item_count(), 3);
        }
        let alone = Trial::of("Perp Frames").item(LINE).item(2).item(false).texts(0);
        assert!(alone[0].contains("Z(0.00,1.00,0.00)"));
        let level = Trial::of("Horizontal Frames").item(LINE).item(2).texts(0);
        assert!(level[0].contains("Z(0.00,0.00,1.00)"));
    }
}
