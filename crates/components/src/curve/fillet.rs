//! Round corners of curves.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_elementary::Elementary;
use katydid_geometry::{Arc, Curve, Line, Point3, PolyCurve, PolylineCurve};

use super::{shared, warning};

/// How a corner is cut.
#[derive(Debug, Clone, Copy)]
pub(super) enum Cut {
    /// By an arc of this radius.
    Radius(f64),
    /// By an arc that begins and ends this far from the corner.
    Distance(f64),
}

/// A polyline with round corners: all of them, or only the one at vertex `only`. A corner stays sharp where its arc does
/// not fit between its neighbours. A closed polyline starts behind its first corner.
pub(super) fn rounded(points: &[Point3], cut: Cut, only: Option<usize>) -> Result<Curve, Message> {
    let mut corners: Vec<Point3> = points.to_vec();
    corners.dedup();
    let closed = corners.len() > 3 && corners.first() == corners.last();
    if closed {
        corners.pop();
    }
    let n = corners.len();
    let at = |i: usize| corners.get(i % n.max(1)).copied().unwrap_or(Point3::ORIGIN);
    let length = |i: usize| at(i).distance_to(at(i + 1));
    // What the corners before and behind have already taken of segment i.
    let mut taken = vec![0.0; n];
    let mut arcs: Vec<Option<Arc>> = vec![None; n];
    for i in 0..n {
        if (!closed && (i == 0 || i + 1 == n)) || only.is_some_and(|o| o % n != i) {
            continue;
        }
        let before = (i + n - 1) % n;
        let (Some(u), Some(v)) = ((at(i) - at(before)).unitized(), (at(i + 1) - at(i)).unitized()) else {
            continue;
        };
        let half = 0.5 * u.angle_to(v).unwrap_or(0.0);
        let reach = match cut {
            Cut::Radius(r) => r * half.tangent(),
            Cut::Distance(d) => d,
        };
        let free = |s: usize| length(s) - taken.get(s).copied().unwrap_or(0.0);
        // A straight angle has no corner; rounding must not refuse arcs that meet in the middle of a side.
        let fits = |s: usize| reach <= free(s) * (1.0 + 1e-9);
        if half < 1e-9 || !(reach > 0.0) || !fits(before) || !fits(i) {
            continue;
        }
        let Ok(arc) = Arc::from_start_direction_end(at(i) - u * reach, u, at(i) + v * reach) else {
            continue;
        };
        for s in [before, i] {
            if let Some(t) = taken.get_mut(s) {
                *t += reach;
            }
        }
        if let Some(place) = arcs.get_mut(i) {
            *place = Some(arc);
        }
    }
    let arc = |i: usize| arcs.get(i % n.max(1)).copied().flatten();
    if arcs.iter().all(Option::is_none) {
        return Ok(PolylineCurve::new(points.to_vec()).map_err(warning)?.into());
    }
    let mut segments: Vec<Curve> = Vec::with_capacity(2 * n);
    for i in 0..if closed { n } else { n.saturating_sub(1) } {
        let from = arc(i).map_or(at(i), |a| a.end());
        let to = arc(i + 1).filter(|_| closed || i + 2 < n).map_or(at(i + 1), |a| a.start());
        if from.distance_to(to) > 1e-9 * length(i) {
            segments.push(Line::new(from, to).into());
        }
        if closed || i + 2 < n {
            segments.extend(arc(i + 1).map(Curve::from));
        }
    }
    Ok(PolyCurve::new(segments).map_err(warning)?.into())
}

/// Whether a radius or distance of 0 leaves the curve as it is; it says so.
fn nothing(context: &Context<'_>, x: f64, what: &str) -> bool {
    if x == 0.0 {
        context.tell(Message::remark(format!("A {what} of 0 rounds nothing")));
    }
    x == 0.0
}

fn positive(x: f64, what: &str) -> Result<f64, Message> {
    if x > 0.0 { Ok(x) } else { Err(Message::error(format!("The {what} must be greater than 0"))) }
}

/// Rounds the corners of a curve with arcs of one radius. A corner where the arc does not fit stays sharp.
#[component("2f407944-81c3-4062-a485-276454ec4b8c", name = "Fillet", nick = "Fillet", at = "Curve/Util")]
#[output("Curve", "C", "The rounded curve.")]
fn fillet(
    context: &Context<'_>,
    /// The curve. Its corners are between lines, arcs or any curves that lie in one plane there.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The radius of the arcs; 0 leaves the curve as it is.
    #[port("Radius", "R")]
    radius: f64,
) -> Result<Shared<Curve>, Message> {
    if nothing(context, radius, "radius") {
        return Ok(shared(curve.clone()));
    }
    let radius = positive(radius, "radius")?;
    match curve.as_polyline() {
        Some(points) => Ok(shared(rounded(&points, Cut::Radius(radius), None)?)),
        None => Ok(shared(curve.fillet_corners(radius, &context.tolerance()).map_err(warning)?.0)),
    }
}

/// Rounds the corners of a curve with arcs that begin and end at one distance from the corner; between bent curves the
/// farther end is at that distance. A corner where the arc does not fit stays sharp.
#[component(
    "6fb21315-a032-400e-a80f-248687f5507f",
    name = "Fillet Distance",
    nick = "Fillet",
    at = "Curve/Util"
)]
#[output("Curve", "C", "The rounded curve.")]
fn fillet_distance(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// From the corner to the ends of the arc; 0 leaves the curve as it is.
    #[port("Distance", "D")]
    distance: f64,
) -> Result<Shared<Curve>, Message> {
    if nothing(context, distance, "distance") {
        return Ok(shared(curve.clone()));
    }
    let distance = positive(distance, "distance")?;
    match curve.as_polyline() {
        Some(points) => Ok(shared(rounded(&points, Cut::Distance(distance), None)?)),
        None => Ok(shared(curve.fillet_corners_at(distance, &context.tolerance()).map_err(warning)?.0)),
    }
}

/// Rounds one corner of a curve: the one nearest to a parameter.
#[component("c92cdfc8-3df8-4c4e-abc1-ede092a0aa8a", name = "Fillet", nick = "Fillet", at = "Curve/Util")]
#[output("Curve", "C", "The rounded curve.")]
#[output("Parameter", "t", "The parameter of the corner.")]
fn fillet_at_parameter(
    context: &Context<'_>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The parameter to look from.
    #[port("Parameter", "t", default = 0.293)]
    t: f64,
    /// The radius of the arc; 0 leaves the curve as it is.
    #[port("Radius", "R")]
    radius: f64,
) -> Result<(Shared<Curve>, f64), Message> {
    if nothing(context, radius, "radius") {
        return Ok((shared(curve.clone()), t));
    }
    let radius = positive(radius, "radius")?;
    let Some(points) = curve.as_polyline() else {
        let (made, kink) = curve.fillet_corner(t, radius, &context.tolerance()).map_err(warning)?;
        return Ok((shared(made), kink));
    };
    let closed = curve.is_closed();
    let last = points.len().saturating_sub(1);
    let corner = |&i: &usize| if closed { i < last } else { i > 0 && i < last };
    let parameters = match curve {
        Curve::Polyline(c) => c.parameters().to_vec(),
        other => {
            points.iter().map(|p| other.closest_point(*p).map(|c| c.parameter)).collect::<Result<_, _>>()?
        }
    };
    let far = |i: usize| parameters.get(i).map_or(f64::INFINITY, |p| (p - t).abs());
    let nearest = (0..points.len()).filter(corner).min_by(|&a, &b| far(a).total_cmp(&far(b)));
    let i = nearest.ok_or_else(|| Message::warning("The curve has no corner"))?;
    let round = rounded(&points, Cut::Radius(radius), Some(i))?;
    Ok((shared(round), parameters.get(i).copied().unwrap_or(t)))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use katydid_component::testing::Trial;
    use katydid_geometry::{Arc, Curve, Line, Point3, PolyCurve, PolylineCurve};

    fn polyline(points: &[[f64; 2]]) -> Curve {
        let points = points.iter().map(|&[x, y]| Point3::new(x, y, 0.0)).collect();
        PolylineCurve::new(points).unwrap().into()
    }

    fn length(trial: Trial) -> String {
        Trial::of_guid("c75b62fa-0a33-4da7-a5bd-03fd0068fd93")
            .tree(trial.run().outputs[0].clone())
            .texts(0)
            .join("")
    }

    #[test]
    fn round_corners() {
        let corner = || polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0]]);
        let fillet = "2f407944-81c3-4062-a485-276454ec4b8c";
        assert_eq!(
            length(Trial::of_guid(fillet).item(corner()).item(1.0)),
            format!("{{0}}: {:.6}", 6.0 + PI / 2.0)
        );
        // Too large for the sides: the corner stays.
        assert_eq!(length(Trial::of_guid(fillet).item(corner()).item(5.0)), "{0}: 8");
        assert!(Trial::of_guid(fillet).item(corner()).item(-1.0).message().contains("greater than 0"));
        assert_eq!(length(Trial::of_guid(fillet).item(corner()).item(0.0)), "{0}: 8");
        let by_distance = Trial::of("Fillet Distance").item(corner()).item(2.0);
        assert_eq!(length(by_distance), format!("{{0}}: {:.6}", 4.0 + PI));
        let square = || polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]]);
        let all = format!("{{0}}: {:.6}", 8.0 + 2.0 * PI);
        assert_eq!(length(Trial::of_guid(fillet).item(square()).item(1.0)), all);
        let one =
            || Trial::of_guid("c92cdfc8-3df8-4c4e-abc1-ede092a0aa8a").item(square()).item(1.2).item(1.0);
        assert_eq!(length(one()), format!("{{0}}: {:.6}", 14.0 + PI / 2.0));
        assert_eq!(one().texts(1), ["{0}: 1"]);
        // Half a disc: two right angles between the line and the arc.
        let arc = Arc::new(
            katydid_geometry::Circle { plane: katydid_geometry::Plane::XY, radius: 2.0 },
            katydid_geometry::Interval::new(0.0, PI),
        );
        let line = Line::new(Point3::new(-2.0, 0.0, 0.0), Point3::new(2.0, 0.0, 0.0));
        let half: Curve = PolyCurve::new(vec![arc.unwrap().into(), line.into()]).unwrap().into();
        let radius = 0.25;
        let round = Trial::of_guid(fillet).item(half.clone()).item(radius).run().outputs[0].clone();
        let Some(katydid_data::Value::Curve(round)) = round.column().get(0) else { panic!("a curve") };
        // The ball of radius r touches the line and the arc from inside at √((2 − r)² − r²) from the middle.
        let foot = ((2.0_f64 - radius).powi(2) - radius * radius).sqrt();
        let turn = PI / 2.0 + (radius / foot).atan();
        let sides = 2.0 * foot + 2.0 * (PI - 2.0 * (radius / foot).atan()) + 2.0 * radius * turn;
        assert!((round.length() - sides).abs() < 1e-9, "{} {sides}", round.length());
        let reach = Trial::of("Fillet Distance").item(half).item(0.5).run().outputs[0].clone();
        let Some(katydid_data::Value::Curve(reach)) = reach.column().get(0) else { panic!("a curve") };
        let ends: Vec<f64> = reach
            .explode(true)
            .unwrap()
            .iter()
            .map(|part| part.start().distance_to(Point3::new(2.0, 0.0, 0.0)))
            .collect();
        assert!(ends.iter().any(|d| (d - 0.5).abs() < 1e-9), "{ends:?}");
    }
}
