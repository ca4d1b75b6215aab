//! Curves that lead from one curve end to another, and ends made to match.

use super::Curve;
use crate::{Error, NurbsCurve, Point3, Result, Vector3};

/// The point, unit direction and curvature vector at an end, seen along the way of the blend.
struct End {
    point: Point3,
    direction: Vector3,
    curvature: Vector3,
}

impl End {
    fn of(curve: &Curve, at_end: bool) -> Result<Self> {
        let t = if at_end { curve.domain().end } else { curve.domain().start };
        let direction = curve
            .tangent_on_side(t, at_end)
            .ok_or(Error::degenerate("curve", "it has no direction at the end to go on from"))?;
        Ok(Self { point: curve.point_at(t), direction, curvature: curve.curvature_on_side(t, at_end) })
    }
}

fn check(orders: [u8; 2], bulges: [f64; 2]) -> Result<()> {
    for order in orders {
        if order > 2 {
            return Err(Error::OutOfRange {
                what: "order of continuity",
                value: f64::from(order),
                must: "0, 1 or 2",
            });
        }
    }
    for value in bulges {
        if !(value > 0.0 && value.is_finite()) {
            return Err(Error::OutOfRange { what: "bulge", value, must: "finite and greater than 0" });
        }
    }
    Ok(())
}

/// The Bézier curve from the end of one curve to the start of another: see [`Curve::blend_to`].
pub(crate) fn blend_between(a: &Curve, b: &Curve, orders: [u8; 2], bulges: [f64; 2]) -> Result<NurbsCurve> {
    check(orders, bulges)?;
    let (from, to) = (End::of(a, true)?, End::of(b, false)?);
    let chord = from.point.distance_to(to.point);
    if !(chord > 0.0) {
        return Err(Error::degenerate("blend", "the ends are in one place"));
    }
    let degree = usize::from(orders[0]) + usize::from(orders[1]) + 1;
    let n = degree as f64;
    // A third of the chord as speed over degree, as in a cubic; the bulge scales it.
    let leg = |bulge: f64| bulge * chord / n.max(3.0);
    let side = |end: &End, order: u8, bulge: f64, sign: f64| -> Vec<Point3> {
        let mut out = vec![end.point];
        let step = end.direction * (sign * leg(bulge));
        if order >= 1 {
            out.push(end.point + step);
        }
        if order >= 2 {
            // Curvature of a Bézier end is (n − 1)/n·h/a², h the height of the third point above the first leg.
            let height = end.curvature * (step.length_squared() * n / (n - 1.0));
            out.push(end.point + step * 2.0 + height);
        }
        out
    };
    let mut points = side(&from, orders[0], bulges[0], 1.0);
    let mut last = side(&to, orders[1], bulges[1], -1.0);
    last.reverse();
    points.append(&mut last);
    NurbsCurve::bezier(&points)
}

impl Curve {
    /// The curve from this one's end to the start of `next`: a Bézier curve of degree `orders[0] + orders[1] + 1`
    /// that goes on with position (0), tangent direction (1) or curvature (2) on each side. A bulge of 1 makes the
    /// tangent leg a third of the distance of the ends (less in higher degrees); larger ones reach farther. Turn
    /// curves round ([`Curve::reversed`]) to blend other ends.
    ///
    /// # Errors
    /// An order above 2, a bulge that is not above 0, ends in one place or without direction.
    pub fn blend_to(&self, next: &Self, orders: [u8; 2], bulges: [f64; 2]) -> Result<Self> {
        Ok(blend_between(self, next, orders, bulges)?.into())
    }
}

impl NurbsCurve {
    /// The cubic with given ends and derivatives there, over 0…1.
    ///
    /// # Errors
    /// A number is not finite.
    pub fn hermite(
        start: Point3,
        start_derivative: Vector3,
        end: Point3,
        end_derivative: Vector3,
    ) -> Result<Self> {
        Self::bezier(&crate::hermite_to_bezier(start, start_derivative, end, end_derivative))
    }

    /// The cubic through points with given derivatives at given increasing parameters; its first derivative is
    /// continuous, every inner knot double.
    ///
    /// # Errors
    /// Fewer than two points, counts that differ, parameters that do not increase, or a number that is not finite.
    pub fn hermite_through(points: &[Point3], derivatives: &[Vector3], parameters: &[f64]) -> Result<Self> {
        let n = points.len();
        if n < 2 || derivatives.len() != n || parameters.len() != n {
            return Err(Error::Invalid {
                what: "Hermite data",
                why: format!(
                    "{n} points, {} derivatives and {} parameters: there must be as many of each, at least 2",
                    derivatives.len(),
                    parameters.len()
                ),
            });
        }
        let mut controls = Vec::with_capacity(2 * n);
        let mut knots = Vec::with_capacity(2 * n + 2);
        controls.extend(points.first());
        knots.extend(parameters.first());
        for i in 1..n {
            let h = parameters[i] - parameters[i - 1];
            if !(h > 0.0) {
                return Err(Error::Invalid {
                    what: "Hermite data",
                    why: "the parameters do not increase".into(),
                });
            }
            controls.push(points[i - 1] + derivatives[i - 1] * (h / 3.0));
            controls.push(points[i] - derivatives[i] * (h / 3.0));
            knots.extend([parameters[i - 1]; 2]);
        }
        controls.extend(points.last());
        knots.extend([parameters[n - 1]; 3]);
        Self::new(3, controls, knots)
    }

    /// The curve, clamped, whose end (or start) is moved to go on into `target` where that starts: with position
    /// (order 0), tangent direction (1) or curvature (2). Only as many control points at that end as the order asks
    /// for move, and their spacing along the tangent stays; so do weights and knots.
    ///
    /// # Errors
    /// An order above 2, fewer than `order` + 2 control points, a degree of 1 with order 2, or an end without
    /// direction.
    pub fn matched_to(&self, at_end: bool, target: &Curve, order: u8) -> Result<Self> {
        check([order, 0], [1.0, 1.0])?;
        if at_end {
            return matched(&self.clamped()?, target, order);
        }
        // The start must arrive at the target's start: seen backwards it is an end.
        let backwards = self.clamped()?.reversed();
        Ok(matched(&backwards, target, order)?.reversed())
    }
}

fn matched(curve: &NurbsCurve, target: &Curve, order: u8) -> Result<NurbsCurve> {
    let (n, p) = (curve.point_count(), curve.degree());
    if n < usize::from(order) + 2 || (order == 2 && p < 2) {
        return Err(Error::Invalid {
            what: "curve to match",
            why: format!("{n} control points of degree {p} are too few for continuity of order {order}"),
        });
    }
    let end = End::of(target, false)?;
    let old = curve.control_points();
    let mut new = old.clone();
    new[n - 1] = end.point;
    if order >= 1 {
        let leg = old[n - 1].distance_to(old[n - 2]);
        let leg = if leg > 0.0 { leg } else { end.point.distance_to(old[n - 2]) };
        if !(leg > 0.0) {
            return Err(Error::degenerate("curve to match", "its last control points are in one place"));
        }
        new[n - 2] = end.point - end.direction * leg;
        if order >= 2 {
            let (k, w) = (curve.knots(), curve.weights());
            let m = k.len();
            // Knot spans under the last two legs.
            let (u1, u2) = (k[m - 1] - k[m - 1 - p], k[m - 2] - k[m - 2 - p]);
            let factor =
                (p as f64 - 1.0) / p as f64 * (u1 / u2) * w[n - 1] * w[n - 3] / (w[n - 2] * w[n - 2]);
            let along = (old[n - 2] - old[n - 3]).length();
            let along = if along > 0.0 { along } else { leg };
            let height = end.curvature * (leg * leg / factor);
            new[n - 3] = new[n - 2] - end.direction * along + height;
        }
    }
    NurbsCurve::with_weights(p, &new, &curve.weights(), curve.knots().to_vec())
        .map(|c| if curve.is_rational() { c } else { c.to_non_rational().unwrap_or(c) })
}
