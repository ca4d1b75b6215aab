//! Curves fitted within a tolerance, to points and to other curves.

use super::deviation::{Approximation, greatest_length};
use super::least_squares::{LeastSquares, placed_knots};
use super::{KnotSpacing, NurbsCurve};
use crate::nurbs::thresholds::KINK;
use crate::{Error, Point3, Result, Vector3};

/// No fit makes more spans than this.
const MOST_SPANS: usize = 8192;

impl NurbsCurve {
    /// A curve of a degree with few control points whose distance from every point is at most `tolerance`: it starts
    /// in the first and ends in the last, along unit tangents where they are given. The deviation is the largest
    /// distance of a point from the curve's point at its parameter, which bounds its distance from the curve.
    ///
    /// Least squares with knots of P&T eq. 9.69; parameters move to the nearest point of the curve (J. Hoschek,
    /// *Intrinsic parametrization for approximation*, CAGD 5, 1988); spans that miss are halved. When there are as
    /// many control points as points, it interpolates.
    ///
    /// # Errors
    /// Fewer than two different points, a degree outside 1…31, a number that is not finite, or a tolerance that is
    /// not above 0.
    pub fn fit_points(
        degree: usize,
        points: &[Point3],
        tolerance: f64,
        start_tangent: Option<Vector3>,
        end_tangent: Option<Vector3>,
    ) -> Result<Approximation> {
        super::uniform::clamped_uniform_knots(degree, degree + 1)?;
        if !(tolerance > 0.0) {
            return Err(Error::OutOfRange { what: "tolerance", value: tolerance, must: "greater than 0" });
        }
        if !points.iter().all(|p| p.is_finite()) {
            return Err(Error::NotFinite("point to fit"));
        }
        let mut points = points.to_vec();
        points.dedup();
        if points.len() < 2 {
            return Err(Error::Invalid {
                what: "points to fit",
                why: format!("there must be at least 2 different ones, got {}", points.len()),
            });
        }
        let mut parameters = KnotSpacing::Chord.parameters(&points);
        let length: f64 = points.windows(2).map(|w| w[0].distance_to(w[1])).sum();
        let along = |t: Option<Vector3>| t.and_then(Vector3::unitized).map(|t| t * length);
        let options = LeastSquares {
            start_derivative: along(start_tangent),
            end_derivative: along(end_tangent),
            ..LeastSquares::default()
        };
        let tangents = usize::from(start_tangent.is_some()) + usize::from(end_tangent.is_some());
        if points.len() <= degree {
            // Too few for the degree: a curve of lower degree through all of them, raised.
            let lower = Self::interpolate_at(points.len() - 1, &points, &parameters)?;
            return Ok(Approximation { curve: lower.raised_to(degree)?, deviation: 0.0 });
        }
        let mut knots = placed_knots(degree, degree + 1, &parameters)?;
        if degree + 1 < 2 + tangents {
            knots = placed_knots(degree, (2 + tangents).min(points.len()), &parameters)?;
        }
        let mut best: Option<Approximation> = None;
        for round in 0..64 {
            let Ok(mut curve) = Self::least_squares(degree, &knots, &points, &parameters, &options) else {
                break;
            };
            let mut misses = missed(&curve, &points, &parameters);
            for _ in 0..if round < 40 { 2 } else { 0 } {
                if worst(&misses) <= tolerance {
                    break;
                }
                let moved = corrected(&curve, &points, &parameters);
                let Ok(next) = Self::least_squares(degree, &knots, &points, &moved, &options) else { break };
                let next_misses = missed(&next, &points, &moved);
                if worst(&next_misses) >= worst(&misses) {
                    break;
                }
                (curve, misses, parameters) = (next, next_misses, moved);
            }
            let deviation = worst(&misses);
            if best.as_ref().is_none_or(|b| deviation < b.deviation) {
                best = Some(Approximation { curve, deviation });
            }
            if deviation <= tolerance || !halve_spans(&mut knots, degree, &parameters, &misses, tolerance) {
                break;
            }
        }
        match best {
            Some(best) if best.deviation <= tolerance => Ok(best),
            _ => {
                let curve = if degree == 3 && tangents > 0 {
                    Self::interpolate(3, &points, KnotSpacing::Chord, start_tangent, end_tangent)?
                } else {
                    let parameters = KnotSpacing::Chord.parameters(&points);
                    Self::interpolate_at(degree, &points, &parameters)?
                };
                Ok(Approximation { curve, deviation: 0.0 })
            }
        }
    }

    /// The clamped curve through points at parameters, as many control points as points.
    fn interpolate_at(degree: usize, points: &[Point3], parameters: &[f64]) -> Result<Self> {
        let n = points.len();
        let mut knots = vec![parameters[0]; degree];
        knots.extend((1..n - degree).map(|i| parameters[i..i + degree].iter().sum::<f64>() / degree as f64));
        knots.extend(std::iter::repeat_n(parameters[n - 1], degree));
        Self::least_squares(degree, &knots, points, parameters, &LeastSquares::default())
    }

    /// A non-rational curve of another degree within `tolerance` of this one at every parameter, with its kinks, ends
    /// and domain. The deviation is the certified bound of [`NurbsCurve::deviation_from`].
    ///
    /// Least squares between kinks on spans that are halved where the bound is above the tolerance; then knots are
    /// removed as far as the tolerance goes.
    ///
    /// # Errors
    /// A degree outside 1…31, a tolerance that is not above 0, or one that 8192 spans cannot reach.
    pub fn refit(&self, degree: usize, tolerance: f64) -> Result<Approximation> {
        super::uniform::clamped_uniform_knots(degree, degree + 1)?;
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(Error::OutOfRange {
                what: "tolerance",
                value: tolerance,
                must: "finite and greater than 0",
            });
        }
        let source = self.clamped()?;
        if let Some(plain) = source.to_non_rational()
            && plain.degree == degree
        {
            return plain.remove_knots_keeping(tolerance, &plain.broken_knots());
        }
        let kinks = source.broken_knots();
        let mut stretches = vec![source.domain().start];
        stretches.extend(kinks.iter().copied());
        stretches.push(source.domain().end);
        let mut knots: Vec<f64> = Vec::new();
        let mut points: Vec<Point3> = Vec::new();
        for w in stretches.windows(2) {
            let part = source.trimmed(crate::Interval::new(w[0], w[1]))?;
            let fitted = refit_smooth(&part, degree, 0.5 * tolerance)?;
            let skip = usize::from(!points.is_empty());
            points.extend(fitted.control_points().into_iter().skip(skip));
            knots.extend(fitted.knots().iter().skip(if knots.is_empty() { 0 } else { degree }));
        }
        let whole = Self::new(degree, points, knots)?;
        let reached = source.deviation_from(&whole)?;
        let reduced = whole.remove_knots_keeping((tolerance - reached).max(0.0), &kinks)?;
        let deviation = source.deviation_from(&reduced.curve)?;
        if deviation <= tolerance {
            return Ok(Approximation { curve: reduced.curve, deviation });
        }
        Ok(Approximation { curve: whole, deviation: reached })
    }

    /// The knots inside the domain where the first derivative jumps.
    pub(crate) fn broken_knots(&self) -> Vec<f64> {
        let spans = self.span_parameters();
        let inner = spans.get(1..spans.len().saturating_sub(1)).unwrap_or(&[]);
        inner
            .iter()
            .copied()
            .filter(|&t| self.multiplicity(t) >= self.degree)
            .filter(|&t| {
                let (a, b) = (self.derivatives(t, 1, true).1, self.derivatives(t, 1, false).1);
                match (a.first(), b.first()) {
                    (Some(a), Some(b)) => (*a - *b).length() > KINK * a.length().max(b.length()),
                    _ => true,
                }
            })
            .collect()
    }
}

/// A stretch without kinks fitted within the tolerance.
fn refit_smooth(source: &NurbsCurve, degree: usize, tolerance: f64) -> Result<NurbsCurve> {
    let domain = source.domain();
    let mut breaks = vec![domain.start, domain.end];
    let mut last_error = f64::INFINITY;
    for _ in 0..48 {
        let mut parameters: Vec<f64> = Vec::new();
        for w in breaks.windows(2) {
            let per_span = degree + 3;
            parameters.extend((0..per_span).map(|k| w[0] + (w[1] - w[0]) * k as f64 / per_span as f64));
        }
        parameters.push(domain.end);
        let points = source.points_at(&parameters);
        let mut knots = vec![domain.start; degree - 1];
        knots.extend_from_slice(&breaks);
        knots.extend(std::iter::repeat_n(domain.end, degree - 1));
        let curve =
            NurbsCurve::least_squares(degree, &knots, &points, &parameters, &LeastSquares::default())?;
        let bad = bad_spans(source, &curve, &breaks, tolerance)?;
        if bad.is_empty() {
            return Ok(curve);
        }
        if breaks.len() > MOST_SPANS {
            break;
        }
        let before = breaks.len();
        for i in bad.into_iter().rev() {
            let middle = 0.5 * (breaks[i] + breaks[i + 1]);
            if breaks[i] < middle && middle < breaks[i + 1] {
                breaks.insert(i + 1, middle);
            }
        }
        if breaks.len() == before {
            break;
        }
        last_error = tolerance;
    }
    Err(Error::OutOfRange {
        what: "tolerance of the fit",
        value: last_error.min(tolerance),
        must: "larger: 8192 spans do not reach it",
    })
}

/// The indices of spans on which the two curves may be further apart than the tolerance.
fn bad_spans(a: &NurbsCurve, b: &NurbsCurve, breaks: &[f64], tolerance: f64) -> Result<Vec<usize>> {
    let mut all = a.span_parameters();
    all.extend_from_slice(breaks);
    all.sort_by(f64::total_cmp);
    all.dedup();
    let mut bad = Vec::new();
    for (k, (x, y)) in a.beziers_between(&all)?.iter().zip(&b.beziers_between(&all)?).enumerate() {
        if greatest_length(super::deviation::difference(x, y), 0.5 * tolerance, 0.0) > tolerance {
            let span = breaks.partition_point(|&t| t <= all[k]).saturating_sub(1);
            if bad.last() != Some(&span) {
                bad.push(span);
            }
        }
    }
    Ok(bad)
}

fn missed(curve: &NurbsCurve, points: &[Point3], parameters: &[f64]) -> Vec<f64> {
    curve.points_at(parameters).iter().zip(points).map(|(a, b)| a.distance_to(*b)).collect()
}

fn worst(misses: &[f64]) -> f64 {
    misses.iter().copied().fold(0.0, |m, x| if x > m || x.is_nan() { x } else { m })
}

/// Each parameter moved by one Newton step towards the foot of its point, staying in order.
fn corrected(curve: &NurbsCurve, points: &[Point3], parameters: &[f64]) -> Vec<f64> {
    let n = parameters.len();
    let mut out = parameters.to_vec();
    for i in 1..n.saturating_sub(1) {
        let (p, d) = curve.derivatives(parameters[i], 2, false);
        let [Some(d1), Some(d2)] = [d.first(), d.get(1)] else { continue };
        let miss = p - points[i];
        let slope = d1.length_squared() + miss.dot(*d2);
        if slope > 0.0 {
            let step = -miss.dot(*d1) / slope;
            let room = if step > 0.0 {
                0.45 * (parameters[i + 1] - parameters[i])
            } else {
                0.45 * (parameters[i] - parameters[i - 1])
            };
            out[i] = parameters[i] + step.clamp(-room, room);
        }
    }
    out
}

/// Puts a knot into each span that misses a point and holds enough of them; whether there was any.
fn halve_spans(
    knots: &mut Vec<f64>,
    degree: usize,
    parameters: &[f64],
    misses: &[f64],
    tolerance: f64,
) -> bool {
    let mut spans: Vec<f64> = knots.clone();
    spans.dedup();
    let mut new = Vec::new();
    let room = parameters.len().saturating_sub(knots.len() + 1 - degree + 1);
    for w in spans.windows(2) {
        let first = parameters.partition_point(|&t| t < w[0]);
        let last = parameters.partition_point(|&t| t < w[1]);
        let inside = parameters.get(first..last).unwrap_or(&[]);
        let bad = misses.get(first..last).is_some_and(|m| m.iter().any(|&x| !(x <= tolerance)));
        if bad && inside.len() >= 2 && new.len() < room {
            let k = inside.len() / 2;
            let t = 0.5 * (inside[k - 1] + inside[k]);
            if w[0] < t && t < w[1] {
                new.push(t);
            }
        }
    }
    if new.is_empty() || spans.len() > MOST_SPANS {
        return false;
    }
    knots.extend(new);
    knots.sort_by(f64::total_cmp);
    true
}
