//! The foot of a perpendicular on a surface, from a place near it.

use crate::surface::thresholds::{FLAT_TO_ROUNDING, RIGHT_ANGLE};
use crate::thresholds;
use crate::{Direction, Point3, Surface, Vector3};

/// A derivative is 0 that is smaller than the other by so much, each over the whole of its domain.
const POLE: f64 = 1e-12;

/// A surface that feet of perpendiculars are found on from places near them.
pub(crate) struct LocalFoot<'a> {
    pub(crate) surface: &'a Surface,
    /// The periods of directions in which parameters may leave the domain.
    pub(crate) periods: [Option<f64>; 2],
}

impl LocalFoot<'_> {
    /// A foot by the right angles there: the smallest distance alone leaves its place open by the square root of
    /// rounding, which is more than the tolerance where a surface is large. The first step may be as wide as a share of
    /// the domain, every other half as wide as the one before. With the last step, as such a share.
    pub(crate) fn polished(&self, start: [f64; 2], p: Point3, widest: f64) -> ([f64; 2], f64) {
        let domains = Direction::BOTH.map(|d| self.surface.domain(d));
        let inside = |k: usize, t: f64| if self.periods[k].is_some() { t } else { domains[k].clamp(t) };
        let mut uv = [inside(0, start[0]), inside(1, start[1])];
        let (mut last, mut size) = (widest, f64::INFINITY);
        for _ in 0..8 {
            let away = p - self.image(Point3::new(uv[0], uv[1], 0.0));
            let Some(step) = self.slope(uv, p.to_vector(), away) else { break };
            size = (0..2).map(|k| (step[k] / domains[k].length()).abs()).fold(0.0, f64::max);
            if !(size < last) {
                break;
            }
            last = 0.5 * size;
            for k in 0..2 {
                uv[k] = inside(k, uv[k] + step[k]);
            }
        }
        (uv, size)
    }

    /// The derivative of the parameters of the foot of a moving point, from its place and velocity: what keeps the
    /// way to the foot square to the surface, so that it also holds away from the surface. Beyond a side of the domain
    /// the foot moves along that side only. `None` where the surface is singular.
    ///
    /// Source: the derivative of (S − p)·Sᵤ = 0, (S − p)·Sᵥ = 0 (L. Piegl and W. Tiller, *The NURBS Book*, 6.1).
    pub(crate) fn slope(&self, uv: [f64; 2], place: Vector3, velocity: Vector3) -> Option<[f64; 2]> {
        let [u, v] = self.inside(uv);
        let d = self.surface.derivatives(u, v, 2, self.surface.inner_quadrant(u, v));
        let (a, b) = (d.get(1, 0), d.get(0, 1));
        let (e, f, g) = (a.dot(a), a.dot(b), b.dot(b));
        if !(e * g - f * f > thresholds::ROUNDING * e * g) || self.is_pole(e, g) {
            return None;
        }
        let away = place - d.point().to_vector();
        let (p, q) = (velocity.dot(a), velocity.dot(b));
        let held = [self.is_beyond(0, u, away, a), self.is_beyond(1, v, away, b)];
        let along = |rate: f64, square: f64, bend: f64| {
            rate / if square - bend > FLAT_TO_ROUNDING * square { square - bend } else { square }
        };
        let (bend_u, bend_v) = (away.dot(d.get(2, 0)), away.dot(d.get(0, 2)));
        match held {
            [true, true] => return Some([0.0, 0.0]),
            [true, false] => return Some([0.0, along(q, g, bend_v)]),
            [false, true] => return Some([along(p, e, bend_u), 0.0]),
            [false, false] => {}
        }
        // At a centre of curvature the foot has no derivative: there that on the surface has to do.
        let bent = [e - bend_u, f - away.dot(d.get(1, 1)), g - bend_v];
        let stable = bent[0] > 0.0 && bent[0] * bent[2] - bent[1] * bent[1] > FLAT_TO_ROUNDING * e * g;
        let [e, f, g] = if stable { bent } else { [e, f, g] };
        let determinant = e * g - f * f;
        Some([(g * p - f * q) / determinant, (e * q - f * p) / determinant])
    }

    /// The derivatives by u and v at parameters on any turn.
    pub(crate) fn partials(&self, uv: [f64; 2]) -> [Vector3; 2] {
        let [u, v] = self.inside(uv);
        let d = self.surface.derivatives(u, v, 1, self.surface.inner_quadrant(u, v));
        [d.get(1, 0), d.get(0, 1)]
    }

    /// The same parameters in the domain: of another turn, or the nearest.
    fn inside(&self, uv: [f64; 2]) -> [f64; 2] {
        Direction::BOTH.map(|d| {
            let k = d.index();
            match self.periods[k] {
                Some(_) => self.surface.domain(d).wrapped(uv[k]),
                None => self.surface.domain(d).clamp(uv[k]),
            }
        })
    }

    /// Whether one direction leads nowhere, by the squares of both derivatives: beside a pole rounding leaves a little
    /// of the derivative along it.
    fn is_pole(&self, e: f64, g: f64) -> bool {
        let [u, v] = Direction::BOTH.map(|d| self.surface.domain(d).length());
        let [along_u, along_v] = [e.sqrt() * u, g.sqrt() * v];
        along_u.min(along_v) <= POLE * along_u.max(along_v)
    }

    /// In which directions a point with its foot at these parameters lies beyond the side of the domain there.
    pub(crate) fn is_beyond_side(&self, [u, v]: [f64; 2], point: Point3) -> [bool; 2] {
        let d = self.surface.derivatives(u, v, 1, self.surface.inner_quadrant(u, v));
        let away = point - d.point();
        [self.is_beyond(0, u, away, d.get(1, 0)), self.is_beyond(1, v, away, d.get(0, 1))]
    }

    /// Whether a point with its foot at parameter `t` lies beyond the side of the domain there, by the way to it.
    fn is_beyond(&self, k: usize, t: f64, away: Vector3, tangent: Vector3) -> bool {
        let domain = self.surface.domain(Direction::BOTH[k]);
        let near = thresholds::EXACT_PARAMETER * domain.length();
        let out = away.dot(tangent);
        // A right angle but for rounding is none of it.
        let clear = RIGHT_ANGLE * away.length() * tangent.length();
        self.periods[k].is_none()
            && ((t <= domain.start + near && out < -clear) || (t >= domain.end - near && out > clear))
    }

    /// The image of parameters on any turn.
    pub(crate) fn image(&self, uv: Point3) -> Point3 {
        let inside = Direction::BOTH.map(|d| {
            let (t, domain) = (if d == Direction::U { uv.x } else { uv.y }, self.surface.domain(d));
            if self.periods[d.index()].is_some() && !domain.contains(t) { domain.wrapped(t) } else { t }
        });
        self.surface.point_at(inside[0], inside[1])
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a failing test may panic")]

    use super::*;
    use crate::{Plane, Sphere};
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn no_foot_moves_round_a_pole() {
        let surface = Surface::from(Sphere::new(Plane::XY, 4.0).unwrap().to_revolution());
        let foot = LocalFoot { surface: &surface, periods: [None; 2] };
        let moved = |v: f64| foot.slope([1.0, v], surface.point_at(1.0, v).to_vector(), Vector3::X);
        let north = surface.domain(Direction::V).end;
        assert!(moved(north).is_none());
        // One part in a million beside it the foot runs round a circle.
        let [u, v] = moved(north - 1e-6 * FRAC_PI_2).unwrap();
        assert!(u.abs() > 1e4 && v.abs() < 1.0, "{u} {v}");
    }
}
