//! Curves as polylines within a tolerance, with proof.

use katydid_elementary::Elementary;

use super::piece::Shape;
use super::{Curve, PolylineCurve};
use crate::bernstein::halves;
use crate::curve::thresholds::SHORTEST_RANGE;
use crate::nurbs::project;
use crate::thresholds;
use crate::{Error, Line, Point3, Result};

/// What a polyline for a curve must satisfy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PolylineLimits {
    /// The greatest distance of the curve from the polyline, in model units; above 0.
    pub distance: f64,
    /// The greatest angle in radians between segments at a point where the curve is smooth; `None` for any.
    pub angle: Option<f64>,
    /// Segments shorter than this are not divided any more; 0 for no such limit.
    pub shortest: f64,
    /// Segments longer than this are divided; `None` for any length.
    pub longest: Option<f64>,
}

impl PolylineLimits {
    /// Within a distance, without other limits.
    pub fn within(distance: f64) -> Self {
        Self { distance, angle: None, shortest: 0.0, longest: None }
    }
}

/// No polyline gets more points than this.
const MOST_POINTS: usize = 4_000_000;

impl Curve {
    /// A polyline with its points on the curve, at equal parameters, that the curve stays within the limits of. Kinks
    /// and ends of pieces are among its points. Straight pieces get no points inside but for `longest`.
    ///
    /// The distance is certified: a Bézier piece is no farther from its chord than the farthest inner control point
    /// times the greatest share that inner control points can have, which for a polynomial of degree n is 1 − 2^(1−n)
    /// (derived from convexity); so is the angle, because tangents lie in the cone of the control legs. `shortest`
    /// wins over both.
    ///
    /// # Errors
    /// A limit is not a number above 0 (0 or more for `shortest`), or the polyline would have more than four million
    /// points.
    pub fn to_polyline(&self, limits: &PolylineLimits) -> Result<PolylineCurve> {
        for (what, value, zero) in [
            ("distance", limits.distance, false),
            ("angle", limits.angle.unwrap_or(1.0), false),
            ("shortest segment", limits.shortest, true),
            ("longest segment", limits.longest.unwrap_or(1.0), false),
        ] {
            if !(value > 0.0 || (zero && value == 0.0)) {
                return Err(Error::OutOfRange { what, value, must: "greater than 0" });
            }
        }
        let mut points = vec![self.start()];
        let mut parameters = vec![self.domain().start];
        let too_many = || Error::Invalid {
            what: "polyline",
            why: format!("the limits would need more than {MOST_POINTS} points"),
        };
        for piece in self.pieces() {
            let mut add = |u: f64, p: Point3| {
                let t = if u == piece.own.end { piece.whole.end } else { piece.whole_parameter(u) };
                if parameters.last().is_some_and(|&last| t > last) {
                    parameters.push(t);
                    points.push(p);
                }
            };
            let mut count = |n: f64| -> Result<()> {
                if !(n <= MOST_POINTS as f64) {
                    return Err(too_many());
                }
                let n = n.max(1.0).ceil() as usize;
                for k in 1..=n {
                    let u = if k == n { piece.own.end } else { piece.own.at(k as f64 / n as f64) };
                    add(u, piece.point(u));
                }
                Ok(())
            };
            match piece.shape {
                Shape::Segment(a, b) => count(limits.longest.map_or(1.0, |l| a.distance_to(b) / l))?,
                Shape::Arc(arc) => {
                    let (sweep, r) = (arc.angle.length().abs(), arc.circle.radius);
                    // A chord over an angle a leaves the arc r(1 − cos a/2) high.
                    let mut step = 2.0 * (1.0 - (limits.distance / r).min(1.0)).arccosine();
                    step = step.min(limits.angle.unwrap_or(f64::INFINITY)).min(2.0);
                    if let Some(longest) = limits.longest {
                        step = step.min(2.0 * (0.5 * longest / r).min(1.0).arcsine());
                    }
                    let short = 2.0 * (0.5 * limits.shortest / r).min(1.0).arcsine();
                    // Halving stops once a segment is shorter than the shortest: the next above it stays.
                    count((sweep / step.max(0.5 * short)).max(if sweep > 4.0 { 3.0 } else { 1.0 }))?;
                }
                Shape::Span(..) => {
                    for bezier in piece.beziers() {
                        let mut stack = vec![(bezier, 0.0_f64, 1.0_f64)];
                        while let Some((c, a, b)) = stack.pop() {
                            let middle = 0.5 * (a + b);
                            if suffices(&c, limits) || b - a < SHORTEST_RANGE {
                                if let Some(&last) = c.last() {
                                    let u = if b == 1.0 { piece.own.end } else { piece.own.at(b) };
                                    add(u, project(last));
                                }
                                continue;
                            }
                            let (left, right) = halves(&c);
                            stack.push((right, middle, b));
                            stack.push((left, a, middle));
                            if stack.len() > 200 {
                                return Err(too_many());
                            }
                        }
                    }
                }
            }
            if points.len() > MOST_POINTS {
                return Err(too_many());
            }
        }
        if self.is_closed() {
            let first = points.first().copied();
            if let (Some(first), Some(last)) = (first, points.last_mut()) {
                *last = first;
            }
        }
        PolylineCurve::with_parameters(points, parameters)
    }
}

/// Whether the chord can stand for a Bézier piece.
fn suffices(c: &[[f64; 4]], limits: &PolylineLimits) -> bool {
    let (Some(&first), Some(&last)) = (c.first(), c.last()) else { return true };
    let chord = Line::new(project(first), project(last));
    let length = chord.length();
    if limits.longest.is_some_and(|l| length > l) {
        return false;
    }
    let polygon: f64 = c.windows(2).map(|w| project(w[0]).distance_to(project(w[1]))).sum();
    if polygon <= limits.shortest {
        return true;
    }
    if chord_distance(c) > limits.distance {
        return false;
    }
    let Some(angle) = limits.angle else { return true };
    let along = chord.direction();
    c.windows(2).all(|w| {
        let leg = project(w[1]) - project(w[0]);
        leg.length() <= thresholds::ROUNDING * polygon
            || leg.angle_to(along).is_some_and(|x| x <= 0.5 * angle)
    })
}

/// An upper bound of the distance of a Bézier piece from its chord.
pub(super) fn chord_distance(c: &[[f64; 4]]) -> f64 {
    let (Some(&first), Some(&last)) = (c.first(), c.last()) else { return 0.0 };
    let inner = c.get(1..c.len().saturating_sub(1)).unwrap_or(&[]);
    let chord = Line::new(project(first), project(last));
    let far = inner.iter().map(|&p| chord.distance_to(project(p))).fold(0.0, f64::max);
    // The share of the inner control points is largest in the middle when weights are equal; otherwise bounded by the
    // largest inner and the smallest outer weight.
    let share = 1.0 - 0.5_f64.powi(i32::try_from(c.len()).unwrap_or(64) - 2);
    let heavy = inner.iter().map(|p| p[3]).fold(0.0, f64::max) * share;
    let light = first[3].min(last[3]) * (1.0 - share);
    if heavy + light > 0.0 { far * heavy / (heavy + light) } else { far }
}
