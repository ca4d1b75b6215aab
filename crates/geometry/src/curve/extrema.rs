//! Where a curve turns, bends most or least, and where its bend changes side.

use super::Curve;
use crate::curve::thresholds::{BEND_NOISE, INSIDE_SPAN, LEAST_SIGN_STEP, NO_BEND, NO_SLOPE, SIGN_STEP};
use crate::polynomial::{Hodograph, Polynomial, cross, dot};
use crate::thresholds;
use crate::{Circle, Error, Plane, Result, Vector3};

/// A place where the curvature is largest or smallest.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CurvatureExtremum {
    /// Where.
    pub parameter: f64,
    /// The curvature there, 0 or more.
    pub curvature: f64,
    /// Whether it is a maximum; otherwise it is a minimum.
    pub is_maximum: bool,
}

/// The size of the terms that a polynomial was summed from tells its rounding noise.
fn noise(size: f64) -> f64 {
    BEND_NOISE * size
}

impl Curve {
    /// The parameters at which the tangent is at right angles to a direction, in order: all of them, to rounding.
    /// These are where the curve reaches farthest that way, or turns back. Stretches at right angles to it give none;
    /// kinks where the curve turns back are among them.
    ///
    /// The roots of the Bernstein form of the derivative, by halving.
    ///
    /// # Errors
    /// The direction is zero or not finite.
    pub fn turning_points(&self, direction: Vector3) -> Result<Vec<f64>> {
        let direction = direction.unitized().ok_or(Error::degenerate("direction", "it has no length"))?;
        let mut out = Vec::new();
        for part in self.located_beziers() {
            let h = Hodograph::new(&part.points);
            let d = [direction.x, direction.y, direction.z];
            let terms = [0, 1, 2].map(|i| h.tangent[i].scaled(d[i]));
            let along = terms[0].plus(&terms[1]).plus(&terms[2]);
            let size = h.tangent.iter().map(Polynomial::size).fold(0.0, f64::max);
            out.extend(along.roots(noise(size)).into_iter().map(|x| part.at(x).1));
        }
        let inner: Vec<f64> = self.pieces().iter().skip(1).map(|p| p.whole.start).collect();
        for t in inner {
            let side = |below| self.tangent_on_side(t, below).map_or(0.0, |v| v.dot(direction));
            if side(true) * side(false) < 0.0 {
                out.push(t);
            }
        }
        Ok(self.ordered(out))
    }

    /// The parameters at which the bend changes side, in order. For a curve that is planar within `tolerance` these
    /// are all changes of sign of its curvature (to rounding), by the roots of the Bernstein form of C′ × C″; at
    /// joints between pieces the sides are compared. For a curve in space, all places inside pieces where the
    /// curvature vanishes. Straight stretches have none.
    pub fn inflections(&self, tolerance: f64) -> Vec<f64> {
        let plane = self.plane(tolerance);
        let mut out = Vec::new();
        for part in self.located_beziers() {
            let h = Hodograph::new(&part.points);
            let s = cross(&h.tangent, &h.tangent.clone().map(|t| t.derivative()));
            let t = h.tangent.iter().map(Polynomial::size).fold(0.0, f64::max);
            let size = t * t * (part.points.len() * part.points.len()) as f64;
            let roots = match &plane {
                Some(plane) => {
                    let n = plane.z_axis;
                    let bend = s[0].scaled(n.x).plus(&s[1].scaled(n.y)).plus(&s[2].scaled(n.z));
                    let all = bend.roots(noise(size));
                    // Only changes of sign: an undulation keeps its side.
                    all.into_iter()
                        .filter(|&x| {
                            let h = SIGN_STEP.min(0.5 * x).min(0.5 * (1.0 - x));
                            x > 0.0 && x < 1.0 && bend.at(x - h) * bend.at(x + h) < 0.0
                        })
                        .collect()
                }
                None => {
                    let squared = dot(&s, &s);
                    let mut all = squared.roots(noise(size) * noise(size).max(BEND_NOISE * size));
                    all.retain(|&x| x > 0.0 && x < 1.0);
                    all
                }
            };
            out.extend(roots.into_iter().map(|x| part.at(x).1));
        }
        if let Some(plane) = plane {
            // At a joint the bend on both sides decides.
            let pieces = self.pieces();
            for w in pieces.windows(2) {
                let bend = |t: f64, below: bool| {
                    let (_, d) = self.derivatives(t, 2, below);
                    match (d.first(), d.get(1)) {
                        (Some(a), Some(b)) => {
                            let c = a.cross(*b).dot(plane.z_axis);
                            if c.abs()
                                > NO_BEND * a.length_squared() / w[0].whole.length().max(w[1].whole.length())
                            {
                                return c;
                            }
                            // Flat at the joint itself: look a little into the piece.
                            let piece = if below { &w[0] } else { &w[1] };
                            let u = piece.own.at(if below { 1.0 - INSIDE_SPAN } else { INSIDE_SPAN });
                            let [_, a, b] = piece.jet(u);
                            let c = a.cross(b).dot(plane.z_axis);
                            if c.abs() > NO_BEND * a.length_squared() / piece.own.length().abs() {
                                c
                            } else {
                                0.0
                            }
                        }
                        _ => 0.0,
                    }
                };
                let t = w[1].whole.start;
                if bend(t, true) * bend(t, false) < 0.0 {
                    out.push(t);
                }
            }
        }
        self.ordered(out)
    }

    /// The places inside smooth pieces where the curvature has a local maximum or minimum, in order: all of them, to
    /// rounding; a minimum where it vanishes is among them. Arcs and lines have none.
    ///
    /// With T = w²C′ and S = T × T′ the squared curvature is S·S w⁴/(T·T)³; its derivative has the sign of
    /// (S·S′ w + 2 S·S w′) T·T − 3 S·S w T·T′ (derived), whose roots are found by halving.
    pub fn curvature_extrema(&self) -> Vec<CurvatureExtremum> {
        let mut out: Vec<CurvatureExtremum> = Vec::new();
        for part in self.located_beziers() {
            if part.is_circular() {
                continue;
            }
            // Unit size keeps the high powers in range.
            let first = part.points.first().copied().unwrap_or([0.0, 0.0, 0.0, 1.0]);
            let origin = [first[0] / first[3], first[1] / first[3], first[2] / first[3]];
            let moved: Vec<[f64; 4]> = part
                .points
                .iter()
                .map(|p| [p[0] - origin[0] * p[3], p[1] - origin[1] * p[3], p[2] - origin[2] * p[3], p[3]])
                .collect();
            let reach = moved.iter().flat_map(|p| [p[0], p[1], p[2]]).fold(0.0_f64, |m, x| m.max(x.abs()));
            let weight = moved.iter().map(|p| p[3]).fold(0.0_f64, f64::max);
            if !(reach > 0.0 && weight > 0.0) {
                continue;
            }
            let unit: Vec<[f64; 4]> =
                moved.iter().map(|p| [p[0] / reach, p[1] / reach, p[2] / reach, p[3] / weight]).collect();
            let h = Hodograph::new(&unit);
            let dt = h.tangent.clone().map(|t| t.derivative());
            let s = cross(&h.tangent, &dt);
            let ds = s.clone().map(|s| s.derivative());
            let (ss, tt) = (dot(&s, &s), dot(&h.tangent, &h.tangent));
            let (w, dw) = (&h.weight, h.weight.derivative());
            let rising = dot(&s, &ds).times(w).times(&tt);
            let weights = ss.times(&dw).times(&tt).scaled(2.0);
            let falling = ss.times(w).times(&dot(&h.tangent, &dt)).scaled(3.0);
            let slope = rising.plus(&weights).minus(&falling);
            let size = rising.size().max(falling.size()).max(weights.size());
            let size_of_bend = h.tangent.iter().map(Polynomial::size).fold(0.0, f64::max).powi(2);
            if ss.size() <= (thresholds::ROUNDING * size_of_bend).powi(2) || slope.size() <= NO_SLOPE * size {
                continue;
            }
            for x in slope.roots(thresholds::POLYNOMIAL_ZERO * slope.size()) {
                let h = SIGN_STEP.min(0.5 * x).min(0.5 * (1.0 - x));
                if !(x > 0.0 && x < 1.0) || h < LEAST_SIGN_STEP {
                    continue;
                }
                let (before, after) = (slope.at(x - h), slope.at(x + h));
                if before * after >= 0.0 {
                    continue;
                }
                let parameter = part.at(x).1;
                let (_, d) = self.derivatives(parameter, 2, false);
                let [Some(d1), Some(d2)] = [d.first(), d.get(1)] else { continue };
                let curvature = super::evaluate::curvature(*d1, *d2).length();
                out.push(CurvatureExtremum { parameter, curvature, is_maximum: before > 0.0 });
            }
        }
        out.sort_by(|a, b| a.parameter.total_cmp(&b.parameter));
        out
    }

    /// The osculating circle of the piece that ends at `t` (`from_below`) or begins there: at a kink or a jump of
    /// curvature the two differ. Angle 0 is at the point; `None` where the side is straight.
    pub fn osculating_circle_on_side(&self, t: f64, from_below: bool) -> Option<Circle> {
        let (point, d) = self.derivatives(t, 2, from_below);
        let k = super::evaluate::curvature(*d.first()?, *d.get(1)?);
        let radius = 1.0 / k.length();
        let toward = k.unitized()?;
        let tangent = self.tangent_on_side(t, from_below)?;
        let center = point + toward * radius;
        Circle::new(Plane::from_axes(center, -toward, tangent).ok()?, radius).ok()
    }

    /// The curvature vector of the piece that ends at `t` (`from_below`) or begins there.
    pub fn curvature_on_side(&self, t: f64, from_below: bool) -> Vector3 {
        let (_, d) = self.derivatives(t, 2, from_below);
        match (d.first(), d.get(1)) {
            (Some(a), Some(b)) => super::evaluate::curvature(*a, *b),
            _ => Vector3::ZERO,
        }
    }

    /// The derivatives of position by arc length at `t`, up to the third: tangent, curvature vector, and the rate of
    /// change of the curvature vector. `None` where the curve stands still.
    pub fn arc_length_derivatives(&self, t: f64, from_below: bool) -> Option<[Vector3; 3]> {
        let (_, d) = self.derivatives(t, 3, from_below);
        let [d1, d2, d3] = [*d.first()?, *d.get(1)?, *d.get(2)?];
        let v = d1.length();
        let tangent = d1.unitized()?;
        // Speed and its derivatives by the parameter.
        let v1 = d1.dot(d2) / v;
        let v2 = (d2.dot(d2) + d1.dot(d3) - v1 * v1) / v;
        let second = super::evaluate::curvature(d1, d2);
        let third = (d3 - d2 * (3.0 * v1 / v) - d1 * (v2 / v - 3.0 * v1 * v1 / (v * v))) / (v * v * v);
        (second.is_finite() && third.is_finite()).then_some([tangent, second, third])
    }

    /// Parameters in order, each once.
    fn ordered(&self, mut parameters: Vec<f64>) -> Vec<f64> {
        parameters.sort_by(f64::total_cmp);
        let near = thresholds::SAME_PARAMETER * self.domain().length();
        parameters.dedup_by(|a, b| (*a - *b).abs() <= near);
        parameters
    }
}
