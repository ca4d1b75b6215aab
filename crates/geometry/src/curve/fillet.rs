//! Corners rounded and cut.

use katydid_elementary::Elementary;

use super::{ArcLength, Continuity, Curve, PolyCurve};
use crate::curve::thresholds::{
    BALL_MOVES, FILLET_ROOM, FOUND_AT_LEAST, FOUND_FIRST, SHORTEST_STEP, SINGULAR, UNITS_IN_LAST_PLACE,
};
use crate::thresholds;
use crate::{Arc, Circle, Error, Interval, Line, Plane, Point3, Result, Tolerance, Vector3};

/// A corner between two curves that has been rounded or cut.
#[derive(Debug, Clone, PartialEq)]
pub struct CornerPiece {
    /// The first curve up to the piece.
    pub before: Curve,
    /// The arc or segment.
    pub piece: Curve,
    /// The second curve from the piece on.
    pub after: Curve,
}

/// The state of a rolling ball: parameters where it touches the two curves.
struct Contact {
    s: f64,
    t: f64,
}

/// Point, velocity and acceleration.
fn jet(curve: &Curve, t: f64, below: bool) -> (Point3, Vector3, Vector3) {
    let (p, d) = curve.derivatives(t, 2, below);
    let at = |k: usize| d.get(k).copied().unwrap_or(Vector3::ZERO);
    (p, at(0), at(1))
}

impl Curve {
    /// The arc of a radius that rounds the corner where this curve ends and `next` starts, both lying in one plane,
    /// and the curves cut back to it. Lines and arcs stay what they are.
    ///
    /// The centre is where the offsets of both curves on the inner side of the corner meet: Newton's method on the two
    /// parameters, led from the corner with the radius growing from 0 (derived); so it is the arc that belongs to this
    /// corner. Exact to rounding.
    ///
    /// # Errors
    /// The curves do not meet within the tolerance, run on smoothly or straight back, do not lie in one plane, or the
    /// radius is too large for them.
    pub fn fillet_with(&self, next: &Self, radius: f64, tolerance: &Tolerance) -> Result<CornerPiece> {
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(Error::OutOfRange {
                what: "radius",
                value: radius,
                must: "finite and greater than 0",
            });
        }
        let corner = self.corner_with(next, tolerance)?;
        let (normal, turn) = corner;
        // To the inner side of the corner: left of the way where it turns left about the normal, which it always does.
        let (da, db) = (self.domain(), next.domain());
        let mut at = Contact { s: da.end, t: db.start };
        let side = |v: Vector3| normal.cross(v).unitized();
        let (mut done, mut step) = (0.0, radius);
        let refused = || Error::OutOfRange {
            what: "radius",
            value: radius,
            must: "small enough for both curves beside the corner",
        };
        let mut tries = 0;
        while done < radius {
            tries += 1;
            if tries > 400 {
                return Err(refused());
            }
            let wanted = (done + step).min(radius);
            // A first guess by the straight corner: both feet move back by r·tan(turn/2).
            let back = (wanted - done) * (0.5 * turn).tangent();
            let (va, vb) = (jet(self, at.s, true).1.length(), jet(next, at.t, false).1.length());
            let mut guess = Contact { s: at.s - back / va, t: at.t + back / vb };
            let mut found = false;
            for _ in 0..30 {
                guess.s = guess.s.clamp(da.start, da.end);
                guess.t = guess.t.clamp(db.start, db.end);
                let (p, p1, p2) = jet(self, guess.s, guess.s > da.start);
                let (q, q1, q2) = jet(next, guess.t, guess.t >= db.end);
                let (Some(np), Some(nq)) = (side(p1), side(q1)) else { return Err(refused()) };
                let miss = (p + np * wanted) - (q + nq * wanted);
                // Derivatives of the offsets: C′(1 − κr), κ signed to the left.
                let bend = |v: Vector3, a: Vector3| v.cross(a).dot(normal) / v.length().powi(3);
                let (jp, jq) = (p1 * (1.0 - bend(p1, p2) * wanted), q1 * (1.0 - bend(q1, q2) * wanted));
                let determinant = jp.cross(-jq).dot(normal);
                if !(determinant.abs() > SINGULAR * jp.length() * jq.length()) {
                    break;
                }
                let ds = -miss.cross(-jq).dot(normal) / determinant;
                let dt = -jp.cross(miss).dot(normal) / determinant;
                let (old_s, old_t) = (guess.s, guess.t);
                guess.s = (guess.s + ds).clamp(da.start, da.end);
                guess.t = (guess.t + dt).clamp(db.start, db.end);
                if !(guess.s.is_finite() && guess.t.is_finite()) {
                    break;
                }
                let rest = miss.length();
                let small = |d: f64, x: f64| {
                    d.abs() <= UNITS_IN_LAST_PLACE * x.abs().max(thresholds::LEAST_DIVISOR) || d == 0.0
                };
                if rest <= FOUND_FIRST * (radius + p.to_vector().length())
                    || (small(guess.s - old_s, guess.s) && small(guess.t - old_t, guess.t))
                {
                    found = rest <= FOUND_AT_LEAST * (radius + p.to_vector().length());
                    break;
                }
            }
            let jump = 4.0 * (wanted - done) * (1.0 + (0.5 * turn).tangent());
            let moved = self.point_at(guess.s).distance_to(self.point_at(at.s));
            if found && moved <= jump.max(BALL_MOVES) && guess.s <= at.s && guess.t >= at.t {
                at = guess;
                done = wanted;
                step *= 2.0;
            } else {
                step *= 0.5;
                if step < SHORTEST_STEP * radius {
                    return Err(refused());
                }
            }
        }
        let (p, p1, _) = jet(self, at.s, true);
        let (q, _, _) = jet(next, at.t, false);
        let np = side(p1).ok_or_else(refused)?;
        let center = p + np * radius;
        let arc = arc_between(center, p, q, normal)?;
        let cut = |curve: &Self, range: Interval| -> Result<Self> {
            let domain = curve.domain();
            if range.length() <= FILLET_ROOM * domain.length() {
                return Err(refused());
            }
            curve.trimmed(range)
        };
        let before = cut(self, Interval::new(da.start, at.s))?;
        let after = cut(next, Interval::new(at.t, db.end))?;
        Ok(CornerPiece { before, piece: arc.into(), after })
    }

    /// The corner where this curve ends and `next` starts cut by a segment, `back` and `forward` along the curves away
    /// from it.
    ///
    /// # Errors
    /// The curves do not meet within the tolerance, or are not longer than the distances, which must be above 0.
    pub fn chamfer_with(
        &self,
        next: &Self,
        back: f64,
        forward: f64,
        tolerance: &Tolerance,
    ) -> Result<CornerPiece> {
        if !(self.end().distance_to(next.start()) <= tolerance.absolute) {
            return Err(Error::degenerate("corner", "the curves do not meet"));
        }
        let (first, second) = (ArcLength::new(self), ArcLength::new(next));
        for (value, whole) in [(back, first.total()), (forward, second.total())] {
            if !(value > 0.0 && value < whole) {
                return Err(Error::OutOfRange {
                    what: "chamfer distance",
                    value,
                    must: "greater than 0 and less than the length of the curve",
                });
            }
        }
        let s = first.parameter_at(first.total() - back);
        let t = second.parameter_at(forward);
        let before = self.trimmed(Interval::new(self.domain().start, s))?;
        let after = next.trimmed(Interval::new(t, next.domain().end))?;
        let piece = Line::new(before.end(), after.start()).into();
        Ok(CornerPiece { before, piece, after })
    }

    /// The normal about which the way turns left at the corner, and the angle of the turn.
    fn corner_with(&self, next: &Self, tolerance: &Tolerance) -> Result<(Vector3, f64)> {
        if !(self.end().distance_to(next.start()) <= tolerance.absolute) {
            return Err(Error::degenerate("corner", "the curves do not meet"));
        }
        let none = || Error::degenerate("corner", "a curve has no direction there");
        let arriving = self.tangent_on_side(self.domain().end, true).ok_or_else(none)?;
        let leaving = next.tangent_on_side(next.domain().start, false).ok_or_else(none)?;
        let cross = arriving.cross(leaving);
        let turn = cross.length().arctangent_of(arriving.dot(leaving));
        if !(cross.length() > thresholds::PARALLEL) {
            return Err(Error::degenerate("corner", "the curves run on smoothly or straight back"));
        }
        let normal = cross / cross.length();
        for curve in [self, next] {
            if !(curve.extent_along(normal).length() <= tolerance.absolute) {
                return Err(Error::degenerate("corner", "the curves do not lie in one plane"));
            }
        }
        Ok((normal, turn))
    }

    /// The curve with all its kinks rounded by arcs of a radius, that of the seam of a closed curve included, as one
    /// curve of lines, arcs and parts of the curve, and the parameters of the kinks at which the radius does not
    /// fit, which stay as they are.
    ///
    /// Neighbouring arcs may take up a part of the curve between them, but not overlap: the earlier one wins.
    ///
    /// # Errors
    /// The radius is not above 0, or a part has no extent.
    pub fn fillet_corners(&self, radius: f64, tolerance: &Tolerance) -> Result<(Self, Vec<f64>)> {
        self.worked_corners(tolerance, |_| true, |a, b| a.fillet_with(b, radius, tolerance), radius)
    }

    /// The curve with only the kink nearest to a parameter rounded by an arc of a radius, and the parameter of that kink.
    ///
    /// # Errors
    /// The curve has no kink, or the radius does not fit there or is not above 0.
    pub fn fillet_corner(&self, near: f64, radius: f64, tolerance: &Tolerance) -> Result<(Self, f64)> {
        let kinks = self.discontinuities(Continuity::G1, tolerance);
        let ends = [self.domain().start, self.domain().end];
        let inner = kinks.into_iter().filter(|t| self.is_closed() || !ends.contains(t));
        let kink = inner.min_by(|a, b| (a - near).abs().total_cmp(&(b - near).abs()));
        let kink = kink.ok_or_else(|| Error::degenerate("curve", "it has no corner"))?;
        let work = |a: &Self, b: &Self| a.fillet_with(b, radius, tolerance);
        let (made, left) = self.worked_corners(tolerance, |t| t == kink, work, radius)?;
        if !left.is_empty() {
            return Err(Error::OutOfRange {
                what: "radius",
                value: radius,
                must: "small enough for both curves beside the corner",
            });
        }
        Ok((made, kink))
    }

    /// The curve with all its kinks rounded by arcs that end a distance from them, and the parameters of the kinks where
    /// that does not fit. Between curves the two ends of an arc are not equally far away: the farther one is at the
    /// distance.
    ///
    /// # Errors
    /// The distance is not above 0, or a part has no extent.
    pub fn fillet_corners_at(&self, distance: f64, tolerance: &Tolerance) -> Result<(Self, Vec<f64>)> {
        let work = |a: &Self, b: &Self| a.fillet_reaching(b, distance, tolerance);
        self.worked_corners(tolerance, |_| true, work, distance)
    }

    /// [`Curve::fillet_with`] of the radius whose arc ends at a distance from the corner, found by scaling: near a corner
    /// the distance grows with the radius.
    fn fillet_reaching(&self, next: &Self, distance: f64, tolerance: &Tolerance) -> Result<CornerPiece> {
        let (_, turn) = self.corner_with(next, tolerance)?;
        let mut radius = distance / (0.5 * turn).tangent();
        for _ in 0..50 {
            let made = self.fillet_with(next, radius, tolerance)?;
            let corner = self.end();
            let reach = [made.piece.start(), made.piece.end()].map(|p| p.distance_to(corner));
            let reach = reach[0].max(reach[1]);
            if (reach - distance).abs() <= thresholds::ROUNDING * distance {
                return Ok(made);
            }
            radius *= distance / reach;
        }
        self.fillet_with(next, radius, tolerance)
    }

    /// The curve with all its kinks cut by segments, `distance` along the curve to both sides, and the parameters of
    /// the kinks where that does not fit.
    ///
    /// # Errors
    /// The distance is not above 0, or a part has no extent.
    pub fn chamfer_corners(&self, distance: f64, tolerance: &Tolerance) -> Result<(Self, Vec<f64>)> {
        let work = |a: &Self, b: &Self| a.chamfer_with(b, distance, distance, tolerance);
        self.worked_corners(tolerance, |_| true, work, distance)
    }

    fn worked_corners(
        &self,
        tolerance: &Tolerance,
        chosen: impl Fn(f64) -> bool,
        work: impl Fn(&Self, &Self) -> Result<CornerPiece>,
        size: f64,
    ) -> Result<(Self, Vec<f64>)> {
        if !(size > 0.0 && size.is_finite()) {
            return Err(Error::OutOfRange {
                what: "size of the corner",
                value: size,
                must: "finite and greater than 0",
            });
        }
        let domain = self.domain();
        let kinks = self.discontinuities(Continuity::G1, tolerance);
        let seam = self.is_closed() && kinks.first() == Some(&domain.start);
        let mut ends: Vec<f64> =
            kinks.iter().copied().filter(|&t| domain.start < t && t < domain.end).collect();
        ends.insert(0, domain.start);
        ends.push(domain.end);
        let mut parts =
            ends.windows(2).map(|w| self.trimmed(Interval::new(w[0], w[1]))).collect::<Result<Vec<_>>>()?;
        let n = parts.len();
        let mut between: Vec<Option<Self>> = vec![None; n];
        let mut left = Vec::new();
        for i in 0..if seam { n } else { n - 1 } {
            let j = (i + 1) % n;
            let kink = if j == 0 { domain.start } else { ends[j] };
            if !chosen(kink) {
                continue;
            }
            if i == j {
                // One closed part with a kink at its seam: its own end and start.
                let middle = domain.middle();
                let halves = [
                    parts[i].trimmed(Interval::new(domain.start, middle))?,
                    parts[i].trimmed(Interval::new(middle, domain.end))?,
                ];
                match work(&halves[1], &halves[0]) {
                    Ok(c) => {
                        between[i] = Some(c.piece);
                        parts[i] =
                            super::join_curves(&[c.after, c.before], thresholds::SAME_POINT * size, true)
                                .into_iter()
                                .next()
                                .unwrap_or_else(|| parts[i].clone());
                    }
                    Err(_) => left.push(kink),
                }
                continue;
            }
            match work(&parts[i], &parts[j]) {
                Ok(c) => {
                    parts[i] = c.before;
                    parts[j] = c.after;
                    between[i] = Some(c.piece);
                }
                Err(_) => left.push(kink),
            }
        }
        let mut segments = Vec::new();
        for (part, piece) in parts.into_iter().zip(between) {
            match part {
                Self::Poly(c) => segments.extend(c.into_parts().0),
                other => segments.push(other.as_simple()),
            }
            segments.extend(piece);
        }
        left.sort_by(f64::total_cmp);
        if segments.len() == 1
            && let Some(only) = segments.pop()
        {
            return Ok((only, left));
        }
        Ok((PolyCurve::new(segments)?.into(), left))
    }

    /// A polyline of one segment as a line.
    fn as_simple(&self) -> Self {
        match self {
            Self::Polyline(c) => match c.points() {
                [a, b] => Line::new(*a, *b).into(),
                _ => self.clone(),
            },
            _ => self.clone(),
        }
    }
}

/// The arc about a centre from p to q that turns left about the normal.
fn arc_between(center: Point3, p: Point3, q: Point3, normal: Vector3) -> Result<Arc> {
    let x = p - center;
    let frame = Plane::from_axes(center, x, normal.cross(x))?;
    let circle = Circle::new(frame, x.length())?;
    let [u, v, _] = frame.coordinates(q);
    let angle = v.arctangent_of(u);
    Arc::new(circle, Interval::new(0.0, if angle <= 0.0 { angle + std::f64::consts::TAU } else { angle }))
}
