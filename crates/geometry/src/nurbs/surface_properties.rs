//! Questions to a surface's control net and knots.

use super::NurbsSurface;
use super::curve::Controls;
use super::surface::Direction;
use super::surface_refine::transposed;
use crate::nurbs::thresholds::{PERIODIC_KNOTS, PERIODIC_POINTS, PLANAR_ROUNDING};
use crate::{Plane, Point3};

/// One of the four sides of a surface's domain, in the order of openNURBS.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Side {
    /// v at its smallest.
    South,
    /// u at its largest.
    East,
    /// v at its largest.
    North,
    /// u at its smallest.
    West,
}

impl Side {
    /// All four, in order.
    pub const ALL: [Self; 4] = [Self::South, Self::East, Self::North, Self::West];

    /// The direction that varies along the side, and whether the other parameter is at its largest.
    pub const fn along(self) -> (Direction, bool) {
        match self {
            Self::South => (Direction::U, false),
            Self::East => (Direction::V, true),
            Self::North => (Direction::U, true),
            Self::West => (Direction::V, false),
        }
    }
}

impl NurbsSurface {
    /// The lines of control points along `direction`, in space.
    fn net(&self, direction: Direction) -> Vec<Vec<Point3>> {
        let points = self.control_points();
        match direction {
            Direction::V => points.chunks(self.counts[1]).map(<[Point3]>::to_vec).collect(),
            Direction::U => {
                transposed(&points, self.counts[1]).chunks(self.counts[0]).map(<[Point3]>::to_vec).collect()
            }
        }
    }

    /// Whether both ends of a direction have full knot multiplicity.
    pub fn is_clamped(&self, direction: Direction) -> bool {
        let (k, p) = (self.knots(direction), self.degree(direction));
        k.first() == k.get(p - 1) && k.get(k.len() - p) == k.last()
    }

    /// Whether the surface closes smoothly in a direction: the degree is at least 2, the first `degree` lines of
    /// control points are repeated at the end, and the knots repeat with the period of the domain.
    pub fn is_periodic(&self, direction: Direction) -> bool {
        let (n, p, k) = (self.count(direction), self.degree(direction), self.knots(direction));
        if p < 2 || n < p + 2 {
            return false;
        }
        let shift = n - p;
        let tolerance = PERIODIC_KNOTS * self.domain(direction).length();
        let step = |i: usize| k.get(i + 1).zip(k.get(i)).map_or(f64::NAN, |(b, a)| b - a);
        let knots_repeat = (0..2 * (p - 1)).all(|i| (step(i) - step(i + shift)).abs() <= tolerance);
        if !knots_repeat {
            return false;
        }
        let repeats = |points: &[[f64; 4]], length: usize| {
            let size = points.iter().flatten().fold(1.0_f64, |m, x| m.max(x.abs()));
            points.chunks(length).all(|line| {
                line.iter()
                    .zip(line.get(shift..).unwrap_or(&[]))
                    .all(|(a, b)| a.iter().zip(b).all(|(x, y)| (x - y).abs() <= PERIODIC_POINTS * size))
            })
        };
        let points = self.homogeneous_points();
        match direction {
            Direction::V => repeats(&points, n),
            Direction::U => repeats(&transposed(&points, self.counts[1]), n),
        }
    }

    /// Whether the surface meets itself where a direction ends: it is periodic, or its first and last lines of
    /// control points coincide.
    pub fn is_closed(&self, direction: Direction) -> bool {
        if self.is_clamped(direction) {
            return self.count(direction) > 2
                && self.net(direction).iter().all(|line| match (line.first(), line.last()) {
                    (Some(&a), Some(&b)) => a.coincides(b),
                    _ => false,
                });
        }
        self.is_periodic(direction)
    }

    /// Whether a side of the surface is a single point.
    pub fn is_singular(&self, side: Side) -> bool {
        let (along, at_end) = side.along();
        let across = along.other();
        if self.is_clamped(across) {
            let line: Vec<Point3> = self
                .net(across)
                .iter()
                .filter_map(|line| if at_end { line.last() } else { line.first() }.copied())
                .collect();
            return line.first().is_some_and(|&a| line.iter().all(|&b| a.coincides(b)));
        }
        let domain = self.domain(across);
        let edge = self.isocurve(along, if at_end { domain.end } else { domain.start });
        edge.is_ok_and(|c| {
            let points = c.control_points();
            points.first().is_some_and(|&a| points.iter().all(|&b| a.coincides(b)))
        })
    }

    /// The plane in which the surface lies within `tolerance`: the one that fits its control points best, turned to
    /// the surface's own normal. The whole control net must lie in it; a net that leaves a plane its surface keeps
    /// to is not told.
    pub fn plane(&self, tolerance: f64) -> Option<Plane> {
        let (plane, deviation) = Plane::fit(&self.control_points()).ok()?;
        if !(deviation <= tolerance.max(0.0)) {
            // Points in one plane up to rounding are planar at tolerance 0 too.
            let size = self.control_points().iter().fold(0.0_f64, |m, p| m.max(p.to_vector().length()));
            if !(deviation <= PLANAR_ROUNDING * size) {
                return None;
            }
        }
        let [u, v] = Direction::BOTH.map(|d| self.domain(d).middle());
        let d = self.derivatives(u, v, 1, super::surface::Quadrant::NorthEast);
        let turned = d.get(1, 0).cross(d.get(0, 1)).dot(plane.z_axis) < 0.0;
        let plane = if turned { plane.flipped() } else { plane };
        Some(plane.with_origin(plane.closest_point(d.point())))
    }

    /// The greatest weight by the smallest, 1 in a non-rational surface.
    pub fn weight_ratio(&self) -> f64 {
        match &self.controls {
            Controls::Plain(_) => 1.0,
            Controls::Rational(points) => {
                let (low, high) =
                    points.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), p| (a.min(p[3]), b.max(p[3])));
                high / low
            }
        }
    }

    /// The control points that act at a pair of parameters, (degree + 1) by (degree + 1) of them, whose hull holds that piece.
    pub fn acting_control_points(&self, u: f64, v: f64) -> Vec<Point3> {
        let [ju, jv] = self.spans_at(u, v, super::surface::Quadrant::NorthEast);
        let [p, q] = self.degrees;
        (ju..=ju + p)
            .flat_map(|i| (jv..=jv + q).map(move |j| (i, j)))
            .filter_map(|(i, j)| self.control_point(i, j))
            .collect()
    }
}
