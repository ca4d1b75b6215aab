//! Curves from points and directions that a formula gives.

use katydid_elementary::Elementary;

use super::Curve;
use super::join::chains;
use crate::curve::thresholds::{ARC_OVER_TURN, ARC_TURN, CLOSE_SAMPLES};
use crate::thresholds;
use crate::{Arc, Circle, Line, NurbsCurve, Point3, PolyCurve, PolylineCurve, Result, Vector3};

/// A point of a curve that is known by a formula, and its unit direction there, if it has one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sample {
    pub(crate) point: Point3,
    pub(crate) direction: Option<Vector3>,
}

/// The most halvings of one stretch.
const DEEPEST: u32 = 14;
/// The most questions to a formula for one stretch; then what there is must do.
const MOST: u32 = 40_000;
/// Turning more than this between two samples is halved.
const TURN: f64 = 0.5;
/// Shares of a stretch at which a cubic that is right in the middle is asked once more: it may be off to one side before
/// the middle and to the other after it.
const BESIDE_MIDDLE: [f64; 2] = [0.25, 0.75];
/// Steps of Newton's method for the place of a cubic nearest to a point of the formula.
const STEPS: usize = 2;

/// The cubic between two samples: the inner control points lie a third of the length of the arc with these tangents
/// along the directions.
struct Span {
    from: Sample,
    to: Sample,
    length: f64,
}

impl Span {
    fn new(from: Sample, to: Sample) -> Self {
        let chord = to.point - from.point;
        let turn = match (from.direction, to.direction) {
            (Some(a), Some(b)) => a.angle_to(b).unwrap_or(0.0),
            _ => 0.0,
        };
        let half = 0.5 * turn;
        let stretch = if half > ARC_TURN && half < 1.5 { half / half.sine() } else { 1.0 };
        Self { from, to, length: chord.length() * stretch }
    }

    /// Directions with those that are missing replaced by the chord's.
    fn directions(&self) -> [Vector3; 2] {
        let chord = (self.to.point - self.from.point).unitized().unwrap_or(Vector3::ZERO);
        [self.from.direction.unwrap_or(chord), self.to.direction.unwrap_or(chord)]
    }

    /// Whether it turns little, and in the middle runs as the formula does.
    fn is_tame(&self, middle: Sample) -> bool {
        let [a, b] = self.directions();
        let along = self.middle_direction();
        let agrees = match (middle.direction, along) {
            (Some(d), Some(along)) => d.dot(along).abs() >= 0.97,
            _ => true,
        };
        agrees && a.angle_to(b).unwrap_or(0.0) <= TURN
    }

    fn middle_direction(&self) -> Option<Vector3> {
        let [a, b] = self.directions();
        ((self.to.point - self.from.point) * 1.5 - (a + b) * (0.25 * self.length)).unitized()
    }

    /// The point at a share of the way, and the derivative by it.
    fn at(&self, x: f64) -> (Point3, Vector3) {
        let [a, b] = self.directions().map(|d| d * self.length);
        let chord = self.to.point - self.from.point;
        let point = self.from.point
            + chord * (x * x * (3.0 - 2.0 * x))
            + a * (x * (1.0 - x) * (1.0 - x))
            + b * (x * x * (x - 1.0));
        let slope =
            chord * (6.0 * x * (1.0 - x)) + a * ((1.0 - x) * (1.0 - 3.0 * x)) + b * (x * (3.0 * x - 2.0));
        (point, slope)
    }

    /// How far it is from a point that should lie on it, near a share of the way.
    fn distance_to(&self, p: Point3, share: f64) -> f64 {
        let mut x = share;
        for _ in 0..STEPS {
            let (point, slope) = self.at(x);
            let square = slope.length_squared();
            if square > 0.0 {
                x = (x + (p - point).dot(slope) / square).clamp(0.0, 1.0);
            }
        }
        self.at(x).0.distance_to(p)
    }

    /// How far the middle is from a point that should lie on the curve near it.
    fn miss(&self, middle: Point3) -> f64 {
        let [a, b] = self.directions();
        let here = self.from.point.lerp(self.to.point, 0.5) + (a - b) * (self.length / 8.0);
        let off = middle - here;
        match self.middle_direction() {
            Some(along) => (off - along * off.dot(along)).length(),
            None => off.length(),
        }
    }
}

/// Rows of samples of a formula over `from`…`to`, so many that the cubics between them are within `tolerance` of it,
/// tested in the middle of each. Directions may be given either way; they are turned to run along. Where the formula
/// gives nothing a row ends, to 10⁻⁹ of the range, and where it leaps, to 10⁻⁵ of it.
///
/// # Errors
/// The first error of the formula.
pub(crate) fn sampled(
    from: f64,
    to: f64,
    parts: usize,
    tolerance: f64,
    formula: impl FnMut(f64) -> Result<Option<Sample>>,
) -> Result<Vec<Vec<Sample>>> {
    rows(from, to, parts, tolerance, &[], formula)
}

/// As [`sampled`], tested also halfway from the middle of each cubic to its ends: for formulas that are smooth up to the
/// ends of the range.
///
/// # Errors
/// The first error of the formula.
pub(crate) fn sampled_closely(
    from: f64,
    to: f64,
    parts: usize,
    tolerance: f64,
    formula: impl FnMut(f64) -> Result<Option<Sample>>,
) -> Result<Vec<Vec<Sample>>> {
    rows(from, to, parts, tolerance, &BESIDE_MIDDLE, formula)
}

fn rows(
    from: f64,
    to: f64,
    parts: usize,
    tolerance: f64,
    beside: &[f64],
    mut formula: impl FnMut(f64) -> Result<Option<Sample>>,
) -> Result<Vec<Vec<Sample>>> {
    let parts = parts.max(1);
    let mut places: Vec<(f64, Option<Sample>)> = Vec::with_capacity(parts + 1);
    for i in 0..=parts {
        let t = from + (to - from) * (i as f64 / parts as f64);
        crate::cancellation::check()?;
        places.push((t, formula(t)?));
    }
    let towards = |s: Sample, way: Vector3| Sample {
        direction: s.direction.map(|d| if d.dot(way) < 0.0 { -d } else { d }),
        ..s
    };
    let mut out: Vec<Vec<Sample>> = vec![Vec::new()];
    let mut budget = MOST;
    for w in places.windows(2) {
        let mut stack = vec![(w[0], w[1], 0)];
        while let Some(((s, a), (t, b), depth)) = stack.pop() {
            if a.is_none() && b.is_none() && depth > 0 {
                continue;
            }
            crate::cancellation::check()?;
            let middle = 0.5 * (s + t);
            let m = formula(middle)?;
            budget = budget.saturating_sub(1);
            if let (Some(a), Some(b), Some(m)) = (a, b, m) {
                let span = Span::new(towards(a, m.point - a.point), towards(b, b.point - m.point));
                let long = a.point.distance_to(b.point) > tolerance;
                let mut fits = span.miss(m.point) <= tolerance && (!long || span.is_tame(m));
                if fits && long && depth < DEEPEST && budget > 0 {
                    for &share in beside {
                        budget = budget.saturating_sub(1);
                        let asked = formula(s + share * (t - s))?;
                        fits = asked.is_some_and(|p| span.distance_to(p.point, share) <= tolerance);
                        if !fits {
                            break;
                        }
                    }
                }
                if fits || depth >= DEEPEST || budget == 0 {
                    let leaps = !fits && long && depth >= DEEPEST;
                    if leaps {
                        out.push(Vec::new());
                    }
                    if let Some(row) = out.last_mut() {
                        if row.is_empty() {
                            row.push(if leaps { b } else { span.from });
                        }
                        if !leaps {
                            row.push(span.to);
                        }
                    }
                    continue;
                }
            } else if depth >= 2 * DEEPEST || budget == 0 {
                out.push(Vec::new());
                continue;
            }
            stack.push(((middle, m), (t, b), depth + 1));
            stack.push(((s, a), (middle, m), depth + 1));
        }
    }
    out.retain(|row| row.len() > 1);
    Ok(out)
}

fn reversed(samples: &[Sample]) -> Vec<Sample> {
    samples.iter().rev().map(|s| Sample { direction: s.direction.map(|d| -d), ..*s }).collect()
}

/// The curves that rows of samples make where their ends are within `gap` of each other: lines, arcs and circles where
/// all samples lie on such to rounding, else cubics through the samples with their directions, one for each stretch
/// without a kink of more than `angle`.
///
/// # Errors
/// A sample is not finite.
pub(crate) fn joined(rows: &[Vec<Sample>], gap: f64, angle: f64) -> Result<Vec<Curve>> {
    let rows: Vec<&Vec<Sample>> = rows.iter().filter(|r| r.len() > 1).collect();
    let ends: Vec<(Point3, Point3)> =
        rows.iter().filter_map(|r| Some((r.first()?.point, r.last()?.point))).collect();
    let closed: Vec<bool> = ends
        .iter()
        .zip(&rows)
        .map(|((a, b), r)| a.distance_to(*b) <= gap && r.iter().any(|s| s.point.distance_to(*a) > gap))
        .collect();
    let mut out = Vec::new();
    for chain in chains(&ends, &closed, gap, false) {
        let mut parts: Vec<Vec<Sample>> = Vec::new();
        for (i, backwards) in chain {
            let row = if backwards { reversed(rows[i]) } else { rows[i].clone() };
            match parts.last_mut() {
                Some(last) if goes_on(last, &row, angle) => last.extend(row.into_iter().skip(1)),
                _ => parts.push(row),
            }
        }
        // A closed curve may start inside a smooth stretch.
        if parts.len() > 1
            && let (Some(first), Some(last)) = (parts.first(), parts.last())
            && let (Some(a), Some(b)) = (first.first(), last.last())
            && a.point.distance_to(b.point) <= gap
            && goes_on(last, first, angle)
        {
            let first = parts.remove(0);
            if let Some(last) = parts.last_mut() {
                last.extend(first.into_iter().skip(1));
            }
        }
        for part in &mut parts {
            part.dedup_by(|b, a| b.point.distance_to(a.point) <= CLOSE_SAMPLES * gap);
        }
        // What is shorter than the gap is part of it.
        parts.retain(|p| p.first().is_some_and(|a| p.iter().any(|s| s.point.distance_to(a.point) > gap)));
        // Ends that meet within the gap meet exactly.
        for i in 1..parts.len() {
            let end = parts[i - 1].last().map(|s| s.point);
            if let (Some(end), Some(start)) = (end, parts[i].first_mut()) {
                start.point = end;
            }
        }
        if let (Some(start), Some(end)) = (
            parts.first().and_then(|p| p.first()).map(|s| s.point),
            parts.last_mut().and_then(|p| p.last_mut()),
        ) && start.distance_to(end.point) <= gap
        {
            end.point = start;
        }
        if parts.is_empty() {
            continue;
        }
        let curves = parts.iter().map(|p| shape(p)).collect::<Result<Vec<Curve>>>()?;
        out.push(whole(curves)?);
    }
    Ok(out)
}

/// Whether one row of samples goes on into the next without a kink.
fn goes_on(row: &[Sample], next: &[Sample], angle: f64) -> bool {
    let chord = |a: Option<&Sample>, b: Option<&Sample>| (b?.point - a?.point).unitized();
    let arrives = row.last().and_then(|s| s.direction);
    let arrives = arrives.or_else(|| chord(row.len().checked_sub(2).and_then(|i| row.get(i)), row.last()));
    let leaves = next.first().and_then(|s| s.direction).or_else(|| chord(next.first(), next.get(1)));
    match (arrives, leaves) {
        (Some(a), Some(b)) => a.angle_to(b).is_some_and(|x| x <= angle),
        _ => true,
    }
}

/// One curve from curves that follow each other.
pub(crate) fn whole(mut curves: Vec<Curve>) -> Result<Curve> {
    if curves.len() == 1
        && let Some(only) = curves.pop()
    {
        return Ok(only);
    }
    if curves.iter().all(|c| matches!(c, Curve::Line(_))) {
        let mut points: Vec<Point3> = curves.iter().map(Curve::start).collect();
        points.extend(curves.last().map(Curve::end));
        return Ok(PolylineCurve::new(points)?.into());
    }
    Ok(PolyCurve::new(curves)?.into())
}

/// The simplest curve through samples.
pub(crate) fn shape(samples: &[Sample]) -> Result<Curve> {
    let (first, last) = match samples {
        [a, .., b] => (a.point, b.point),
        _ => return Err(crate::Error::degenerate("curve", "it has no length")),
    };
    let line = Line::new(first, last);
    let size = samples.iter().map(|s| s.point.distance_to(first)).fold(0.0, f64::max);
    let exact = thresholds::SAME_POINT * size;
    if first.distance_to(last) > exact && samples.iter().all(|s| line.distance_to(s.point) <= exact) {
        return Ok(line.into());
    }
    if let Some(round) = round(samples, exact) {
        return Ok(round);
    }
    let samples = &apart(samples, CLOSE_SAMPLES * exact);
    let mut parameters = vec![0.0];
    let mut directions = Vec::with_capacity(samples.len());
    for w in samples.windows(2) {
        let span = Span::new(w[0], w[1]);
        let [a, b] = span.directions();
        if directions.is_empty() {
            directions.push(a);
        }
        directions.push(b);
        parameters.push(parameters.last().copied().unwrap_or(0.0) + span.length);
    }
    let points: Vec<Point3> = samples.iter().map(|s| s.point).collect();
    Ok(NurbsCurve::hermite_through(&points, &directions, &parameters)?.into())
}

/// The samples without those that are in the place of the one before; the last stays in its place.
fn apart(samples: &[Sample], reach: f64) -> Vec<Sample> {
    let mut kept: Vec<Sample> = Vec::with_capacity(samples.len());
    for sample in samples {
        match kept.last_mut() {
            Some(last) if last.point.distance_to(sample.point) <= reach => last.point = sample.point,
            _ => kept.push(*sample),
        }
    }
    if let (Some(first), Some(start)) = (kept.first_mut(), samples.first()) {
        first.point = start.point;
    }
    kept
}

/// The arc or circle on which all samples lie.
fn round(samples: &[Sample], exact: f64) -> Option<Curve> {
    let n = samples.len();
    if n < 5 {
        return None;
    }
    let at = |i: usize| samples.get(i).map(|s| s.point);
    let circle = Circle::through(at(0)?, at(n / 3)?, at(2 * n / 3)?).ok()?;
    let on = |p: Point3| {
        (p.distance_to(circle.center()) - circle.radius).abs() <= exact
            && circle.plane.signed_distance(p).abs() <= exact
    };
    if !(circle.radius < 1e6 * exact * 1e9) || !samples.iter().all(|s| on(s.point)) {
        return None;
    }
    // Samples are less than a half turn apart: they must all run the same way round.
    let turns = samples.windows(2).map(|w| {
        let (u, v) = (w[0].point - circle.center(), w[1].point - circle.center());
        u.cross(v).dot(circle.plane.z_axis).arctangent_of(u.dot(v))
    });
    let total: f64 = turns.clone().sum();
    if turns.clone().any(|t| t * total <= 0.0) || total.abs() > std::f64::consts::TAU * (1.0 + ARC_OVER_TURN)
    {
        return None;
    }
    let closed = at(0)? == at(n - 1)?;
    if closed {
        let circle = if total > 0.0 {
            circle
        } else {
            let plane = circle.plane;
            let plane = crate::Plane::from_axes(plane.origin, plane.x_axis, -plane.y_axis).ok()?;
            Circle::new(plane, circle.radius).ok()?
        };
        return Some(circle.into());
    }
    Some(Arc::through(at(0)?, at(n / 2)?, at(n - 1)?).ok()?.into())
}

#[cfg(test)]
mod tests {
    use super::{Sample, joined, sampled, sampled_closely};
    use crate::{Curve, Point3, Result, Vector3};

    fn wave(t: f64) -> Result<Option<Sample>> {
        let direction = Vector3::new(1.0, t.cos(), 0.0).unitized();
        Ok(Some(Sample { point: Point3::new(t, t.sin(), 0.0), direction }))
    }

    #[test]
    fn a_formula_is_followed() {
        for tolerance in [1e-2, 1e-4, 1e-6] {
            let rows =
                [(0.0, 3.0), (3.0, 9.0)].map(|(a, b)| sampled(a, b, 2, tolerance, wave).unwrap()).concat();
            let curves = joined(&rows, 1e-9, 0.01).unwrap();
            assert_eq!(curves.len(), 1);
            for k in 0..=500 {
                let t = 9.0 * f64::from(k) / 500.0;
                let miss = curves[0].closest_point(Point3::new(t, t.sin(), 0.0)).unwrap().distance;
                assert!(miss <= 1.2 * tolerance, "{miss} {tolerance}");
            }
        }
    }

    #[test]
    fn what_is_right_in_the_middle_alone_is_divided() {
        // Odd about its middle: the cubic over the whole wave meets it there and has half of its height.
        let height = 0.01;
        let odd = |t: f64| {
            let turn = std::f64::consts::TAU * t;
            let direction = Vector3::new(1.0, std::f64::consts::TAU * height * turn.cos(), 0.0).unitized();
            Ok(Some(Sample { point: Point3::new(t, height * turn.sin(), 0.0), direction }))
        };
        let curves = joined(&sampled_closely(0.0, 1.0, 1, 1e-3, odd).unwrap(), 1e-9, 0.01).unwrap();
        for k in 0..=200 {
            let p = odd(f64::from(k) / 200.0).unwrap().unwrap().point;
            assert!(curves[0].closest_point(p).unwrap().distance <= 1e-3, "{k}");
        }
    }

    #[test]
    fn gaps_and_leaps_end_rows() {
        let holed = |t: f64| Ok(if (1.0..2.0).contains(&t) { None } else { wave(t)? });
        let rows = sampled(0.0, 3.0, 7, 1e-4, holed).unwrap();
        assert_eq!(rows.len(), 2);
        assert!((rows[0].last().unwrap().point.x - 1.0).abs() < 1e-6);
        assert!((rows[1][0].point.x - 2.0).abs() < 1e-6);
        let leaping = |t: f64| {
            let up = if t > 1.3 { 5.0 } else { 0.0 };
            Ok(wave(t)?.map(|s| Sample { point: s.point + Vector3::Z * up, ..s }))
        };
        let rows = sampled(0.0, 3.0, 2, 1e-4, leaping).unwrap();
        assert_eq!(rows.len(), 2);
        assert!((rows[1][0].point.x - 1.3).abs() < 1e-3);
    }

    #[test]
    fn circles_and_lines_are_known() {
        let circle = |t: f64| {
            let direction = Some(Vector3::new(-t.sin(), t.cos(), 0.0));
            Ok(Some(Sample { point: Point3::new(2.0 * t.cos(), 2.0 * t.sin(), 0.0), direction }))
        };
        let half = std::f64::consts::PI;
        let rows = [0.0, 2.0 * half].map(|a| sampled(a, half, 2, 1e-3, circle).unwrap()).concat();
        let all = joined(&rows, 1e-9, 0.01).unwrap();
        assert!(matches!(all.as_slice(), [Curve::Arc(a)] if a.is_circle()), "{all:?}");
        let open = joined(&rows[..1], 1e-9, 0.01).unwrap();
        assert!(matches!(open.as_slice(), [Curve::Arc(_)]) && (open[0].length() - 2.0 * half).abs() < 1e-9);
        let line = |t: f64| Ok(Some(Sample { point: Point3::new(t, 1.0, 0.0), direction: None }));
        let corner =
            |t: f64| Ok(Some(Sample { point: Point3::new(1.0, t, 0.0), direction: Some(Vector3::Y) }));
        let rows =
            [sampled(0.0, 1.0, 1, 1e-3, line).unwrap(), sampled(1.0, 3.0, 1, 1e-3, corner).unwrap()].concat();
        assert!(matches!(joined(&rows[..1], 1e-9, 0.1).unwrap().as_slice(), [Curve::Line(_)]));
        assert!(
            matches!(joined(&rows, 1e-9, 0.1).unwrap().as_slice(), [Curve::Polyline(p)] if p.segment_count() == 2)
        );
    }
}
