//! Whether a surface is closed, periodic, singular or planar.

use super::Surface;
use crate::surface::thresholds::{COINCIDENT, COINCIDENT_OF_PLACE};
use crate::{Curve, Direction, Plane, Side};

impl Surface {
    /// The parameters of one direction at which smooth pieces meet, both ends of the domain among them.
    pub fn span_parameters(&self, direction: Direction) -> Vec<f64> {
        let domain = self.domain(direction);
        let joints = |curve: &Curve| {
            let mut out: Vec<f64> = curve.pieces().iter().map(|p| p.whole.start).collect();
            out.push(domain.end);
            out
        };
        match self {
            Self::Sum(s) => joints(&s.curves()[direction.index()]),
            Self::Revolution(s) if direction != s.angle_direction() => joints(s.profile()),
            Self::Nurbs(s) => s.span_parameters(direction),
            Self::Plane(_) | Self::Revolution(_) => vec![domain.start, domain.end],
        }
    }

    /// Whether the surface meets itself where a direction ends.
    pub fn is_closed(&self, direction: Direction) -> bool {
        match self {
            Self::Plane(_) => false,
            Self::Sum(s) => s.curves()[direction.index()].is_closed(),
            Self::Revolution(s) if direction == s.angle_direction() => s.is_full_turn(),
            Self::Revolution(s) => s.profile().is_closed(),
            Self::Nurbs(s) => s.is_closed(direction),
        }
    }

    /// Whether the surface closes smoothly in a direction.
    pub fn is_periodic(&self, direction: Direction) -> bool {
        match self {
            Self::Plane(_) => false,
            Self::Sum(s) => s.curves()[direction.index()].is_periodic(),
            Self::Revolution(s) if direction == s.angle_direction() => s.is_full_turn(),
            Self::Revolution(s) => s.profile().is_periodic(),
            Self::Nurbs(s) => s.is_periodic(direction),
        }
    }

    /// Whether a side of the domain is a single point.
    pub fn is_singular(&self, side: Side) -> bool {
        match self {
            Self::Plane(_) | Self::Sum(_) => false,
            Self::Revolution(s) => {
                let (along, at_end) = side.along();
                let profile = s.profile();
                let p = if at_end { profile.end() } else { profile.start() };
                let size = p.to_vector().length().max(s.axis().from.to_vector().length());
                along == s.angle_direction()
                    && s.distance_from_axis(p) <= COINCIDENT.max(COINCIDENT_OF_PLACE * size)
            }
            Self::Nurbs(s) => s.is_singular(side),
        }
    }

    /// Whether the surface encloses a volume: each direction is closed, or the other one's sides are points.
    pub fn is_solid(&self) -> bool {
        let u =
            self.is_closed(Direction::U) || (self.is_singular(Side::East) && self.is_singular(Side::West));
        let v =
            self.is_closed(Direction::V) || (self.is_singular(Side::South) && self.is_singular(Side::North));
        u && v
    }

    /// Whether (u, v) lies on a side that is a single point.
    pub fn is_at_singularity(&self, u: f64, v: f64) -> bool {
        let [du, dv] = Direction::BOTH.map(|d| self.domain(d));
        (v == dv.start && self.is_singular(Side::South))
            || (u == du.end && self.is_singular(Side::East))
            || (v == dv.end && self.is_singular(Side::North))
            || (u == du.start && self.is_singular(Side::West))
    }

    /// In which directions (u, v) lies on the seam of a closed surface.
    pub fn is_at_seam(&self, u: f64, v: f64) -> [bool; 2] {
        let at = |d: Direction, t: f64| {
            let domain = self.domain(d);
            (t == domain.start || t == domain.end) && self.is_closed(d)
        };
        [at(Direction::U, u), at(Direction::V, v)]
    }

    /// The plane in which the surface lies within `tolerance`, with its normal on the surface's side. A NURBS
    /// surface is told by its control points, which all must lie in the plane.
    pub fn plane(&self, tolerance: f64) -> Option<Plane> {
        match self {
            Self::Plane(s) => Some(*s.plane()),
            Self::Nurbs(s) => s.plane(tolerance),
            _ => self.to_nurbs().ok()?.plane(tolerance),
        }
    }

    /// Whether all points lie in one plane within `tolerance`.
    pub fn is_planar(&self, tolerance: f64) -> bool {
        self.plane(tolerance).is_some()
    }

    /// Whether the corners of the domain are four different points.
    pub fn has_four_corners(&self) -> bool {
        let [u, v] = Direction::BOTH.map(|d| self.domain(d));
        let corners = [(u.start, v.start), (u.end, v.start), (u.end, v.end), (u.start, v.end)]
            .map(|(u, v)| self.point_at(u, v));
        (0..4).all(|i| (i + 1..4).all(|j| !corners[i].coincides(corners[j])))
    }
}
