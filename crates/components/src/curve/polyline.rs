//! Curve / Util: polylines.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_geometry::{Continuity, Curve, Line, Point3, PolylineCurve};

use super::{shared, warning};

fn vertices(curve: &Curve) -> Result<Vec<Point3>, Message> {
    curve.as_polyline().ok_or_else(|| Message::error("This curve is no polyline"))
}

fn polyline(points: Vec<Point3>) -> Result<Shared<Curve>, Message> {
    Ok(shared(PolylineCurve::new(points).map_err(warning)?))
}

fn integer(n: usize) -> i32 {
    i32::try_from(n).unwrap_or(i32::MAX)
}

/// Leaves out vertices of a polyline that lie near the rest of it (D. Douglas, T. Peucker, 1973).
///
/// Open polylines of two points and closed ones of less than five stay as they are.
#[component("884646c3-0e70-4ad1-90c5-42601ee26450", name = "Reduce", nick = "RedPLine", at = "Curve/Util")]
#[output("Polyline", "P", "The polyline of fewer vertices.")]
#[output("Reduction", "R", "How many were left out.")]
fn reduce(
    context: &Context<'_>,
    /// The polyline.
    #[port("Polyline", "P")]
    curve: &Curve,
    /// How far a vertex that goes may lie from what stays; not negative.
    #[port("Tolerance", "T", default = 1.0)]
    tolerance: f64,
) -> Result<(Shared<Curve>, i32), Message> {
    if !(tolerance >= 0.0) {
        return Err(Message::error("The tolerance must not be negative"));
    }
    let points = vertices(curve)?;
    let least = if curve.is_closed() { 5 } else { 3 };
    if points.len() < least {
        return Ok((shared(curve.clone()), 0));
    }
    let mut keep = vec![false; points.len()];
    for end in [0, points.len() - 1] {
        if let Some(k) = keep.get_mut(end) {
            *k = true;
        }
    }
    let mut todo = vec![(0, points.len() - 1)];
    while let Some((a, b)) = todo.pop() {
        context.check()?;
        let (Some(&from), Some(&to)) = (points.get(a), points.get(b)) else { continue };
        let chord = Line::new(from, to);
        let far = |i: usize| points.get(i).map_or(0.0, |p| chord.distance_to(*p));
        let worst = (a + 1..b).max_by(|&i, &j| far(i).total_cmp(&far(j)));
        if let Some(i) = worst.filter(|&i| far(i) > tolerance) {
            if let Some(k) = keep.get_mut(i) {
                *k = true;
            }
            todo.extend([(a, i), (i, b)]);
        }
    }
    let kept: Vec<Point3> = points.iter().zip(&keep).filter(|(_, k)| **k).map(|(p, _)| *p).collect();
    let gone = integer(points.len() - kept.len());
    Ok((polyline(kept)?, gone))
}

/// Removes short segments of a polyline, the shortest first: its two vertices become one in the middle.
#[component(
    "be298882-28c9-45b1-980d-7192a531c9a9",
    name = "Polyline Collapse",
    nick = "PCol",
    at = "Curve/Util"
)]
#[output("Polyline", "Pl", "The polyline of longer segments.")]
#[output("Count", "N", "How many segments were removed.")]
fn polyline_collapse(
    context: &Context<'_>,
    /// The polyline.
    #[port("Polyline", "P")]
    curve: &Curve,
    /// Segments shorter than this go.
    #[port("Tolerance", "t")]
    tolerance: f64,
) -> Result<(Shared<Curve>, i32), Message> {
    let mut points = vertices(curve)?;
    let before = points.len();
    while points.len() > 2 {
        context.check()?;
        let length = |i: &usize| match (points.get(*i), points.get(i + 1)) {
            (Some(a), Some(b)) => a.distance_to(*b),
            _ => f64::INFINITY,
        };
        let shortest = (0..points.len() - 1).min_by(|a, b| length(a).total_cmp(&length(b)));
        let Some(i) = shortest.filter(|i| length(i) < tolerance) else { break };
        let (Some(&a), Some(&b)) = (points.get(i), points.get(i + 1)) else { break };
        // The ends of the polyline stay where they are.
        let joined = match i {
            0 => a,
            i if i + 2 == points.len() => b,
            _ => a.lerp(b, 0.5),
        };
        points.splice(i..i + 2, [joined]);
    }
    let gone = integer(before - points.len());
    Ok((polyline(points)?, gone))
}

/// Smooths a polyline: in each step every vertex moves towards the middle of its neighbours. The ends of an open one stay.
#[component(
    "5c5fbc42-3e1d-4081-9cf1-148d0b1d9610",
    name = "Smooth Polyline",
    nick = "SmoothPLine",
    at = "Curve/Util"
)]
#[output("Polyline", "P", "The smoothed polyline.")]
fn smooth_polyline(
    context: &Context<'_>,
    /// The polyline.
    #[port("Polyline", "P")]
    curve: &Curve,
    /// How far: 1 moves a vertex half the way.
    #[port("Strength", "S", default = 0.5)]
    strength: f64,
    /// The number of steps, not negative.
    #[port("Times", "T", default = 1)]
    times: i32,
) -> Result<Shared<Curve>, Message> {
    let times =
        usize::try_from(times).map_err(|_| Message::error("The number of steps must not be negative"))?;
    let mut points = vertices(curve)?;
    let closed = curve.is_closed();
    if closed {
        points.pop();
    }
    let n = points.len();
    for _ in 0..times {
        context.check()?;
        let at = |i: usize| points.get(i % n.max(1)).copied().unwrap_or(Point3::ORIGIN);
        points = (0..n)
            .map(|i| {
                if !closed && (i == 0 || i + 1 == n) {
                    return at(i);
                }
                let middle = at(i + n - 1).lerp(at(i + 1), 0.5);
                at(i).lerp(middle, 0.5 * strength)
            })
            .collect();
    }
    if closed {
        points.extend(points.first().copied());
    }
    polyline(points)
}

/// A polyline that follows a curve. Polylines come back as they are.
#[component(
    "2956d989-3599-476f-bc92-1d847aff98b6",
    name = "Curve To Polyline",
    nick = "ToPoly",
    at = "Curve/Util"
)]
#[output("Polyline", "P", "The polyline.")]
#[output("Segments", "S", "The number of its segments.")]
fn curve_to_polyline(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// How far the polyline may be from the curve; 0 for no limit, unless both limits are 0: then the document's.
    #[port("Tolerance (distance)", "Td", default = 0.0)]
    distance: f64,
    /// By how much the curve may turn between two vertices, in radians; 0 for no limit.
    #[port("Tolerance (angle)", "Ta", default = 0.0)]
    angle: f64,
    /// Segments that would become shorter than this are not divided.
    #[port("MinEdge", "E-")]
    shortest: Option<f64>,
    /// Segments longer than this are divided.
    #[port("MaxEdge", "E+")]
    longest: Option<f64>,
) -> Result<(Shared<Curve>, i32), Message> {
    if let Some(points) = curve.as_polyline() {
        return Ok((polyline(points.clone())?, integer(points.len().saturating_sub(1))));
    }
    let limit = |x: f64| if x > 0.0 { x } else { f64::INFINITY };
    let (mut distance, angle) = (limit(distance), limit(angle));
    let longest = longest.map_or(f64::INFINITY, limit);
    let shortest = shortest.unwrap_or(0.0).max(0.0);
    if distance.is_infinite() && angle.is_infinite() {
        distance = context.tolerance().absolute;
    }
    let domain = curve.domain();
    let mut cuts = vec![domain.start];
    cuts.extend(curve.discontinuities(Continuity::G1, &context.tolerance()));
    if let Curve::Nurbs(c) = curve {
        cuts.extend(c.span_parameters());
    }
    // Four parts at least, so that no symmetry hides a bend from the samples.
    cuts.extend((1..=4).map(|i| domain.at(f64::from(i) / 4.0)));
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    let mut points = vec![curve.start()];
    for pair in cuts.windows(2) {
        if let [a, b] = pair {
            context.items(points.len())?;
            context.check()?;
            divide(curve, (*a, *b), [distance, angle, shortest, longest], 0, &mut points);
        }
    }
    points.dedup();
    let segments = integer(points.len().saturating_sub(1));
    Ok((polyline(points)?, segments))
}

/// Adds the vertices behind `a` up to `b`, halving until the piece is within the limits.
fn divide(curve: &Curve, (a, b): (f64, f64), limits: [f64; 4], depth: u32, points: &mut Vec<Point3>) {
    let [distance, angle, shortest, longest] = limits;
    let (p, q) = (curve.point_at(a), curve.point_at(b));
    let chord = Line::new(p, q);
    let off = [0.25, 0.5, 0.75].map(|x| chord.distance_to(curve.point_at(a + (b - a) * x)));
    let turn = curve.tangent_on_side(a, false).zip(curve.tangent_on_side(b, true));
    let turn = turn.and_then(|(s, t)| s.angle_to(t)).unwrap_or(0.0);
    let length = chord.length();
    let coarse = off.iter().any(|d| *d > distance) || turn > angle || length > longest;
    if coarse && depth < 16 && length > 2.0 * shortest {
        let middle = 0.5 * (a + b);
        divide(curve, (a, middle), limits, depth + 1, points);
        divide(curve, (middle, b), limits, depth + 1, points);
    } else {
        points.push(q);
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Circle, Curve, Plane, Point3, PolylineCurve};

    fn polyline(points: &[[f64; 2]]) -> Curve {
        PolylineCurve::new(points.iter().map(|&[x, y]| Point3::new(x, y, 0.0)).collect()).unwrap().into()
    }

    #[test]
    fn fewer_vertices() {
        let bump = || polyline(&[[0.0, 0.0], [1.0, 0.1], [2.0, 0.0], [3.0, 5.0]]);
        assert_eq!(Trial::of("Reduce").item(bump()).item(0.5).texts(1), ["{0}: 1"]);
        assert_eq!(Trial::of("Reduce").item(bump()).item(0.01).texts(1), ["{0}: 0"]);
        assert!(Trial::of("Reduce").item(bump()).item(-1.0).message().contains("negative"));
        let short = || polyline(&[[0.0, 0.0], [5.0, 0.0], [5.2, 0.0], [9.0, 0.0]]);
        let collapsed = Trial::of("Polyline Collapse").item(short()).item(1.0).run();
        assert_eq!(texts(&collapsed.outputs[1]), ["{0}: 1"]);
        let points = Trial::of("Control Points").tree(collapsed.outputs[0].clone()).texts(0);
        assert_eq!(points, ["{0;0}: {0, 0, 0}, {5.1, 0, 0}, {9, 0, 0}"]);
    }

    #[test]
    fn smoother() {
        let peak = polyline(&[[0.0, 0.0], [1.0, 4.0], [2.0, 0.0]]);
        let smooth = Trial::of("Smooth Polyline").item(peak).item(1.0).item(1).run();
        let points = Trial::of("Control Points").tree(smooth.outputs[0].clone()).texts(0);
        assert_eq!(points, ["{0;0}: {0, 0, 0}, {1, 2, 0}, {2, 0, 0}"]);
    }

    #[test]
    fn polylines_of_curves() {
        let circle = Circle { plane: Plane::XY, radius: 1.0 };
        let fine = Trial::of("Curve To Polyline").item(circle).item(0.01).run();
        // 8 parts are off by 0.076, 16 by 0.019, 32 by 0.005.
        assert_eq!(texts(&fine.outputs[1]), ["{0}: 32"]);
        let same = Trial::of("Curve To Polyline").item(polyline(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]));
        assert_eq!(same.texts(1), ["{0}: 2"]);
    }
}
