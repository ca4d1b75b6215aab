//! The surface without ends on which a surface lies.

use katydid_elementary::Elementary;

use super::thresholds::SAME_BEND;
use crate::surface::{Round, RoundForm};
use crate::{Direction, Point3, Surface, Vector3};

/// A straight line without ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// A point on it.
    pub origin: Point3,
    /// Its unit direction.
    pub direction: Vector3,
}

impl Axis {
    /// The height of a point along the axis, and the way to it from there.
    pub(crate) fn split(&self, p: Point3) -> (f64, Vector3) {
        let way = p - self.origin;
        let height = way.dot(self.direction);
        (height, way - self.direction * height)
    }

    /// The point of the axis at a height.
    pub(crate) fn at(&self, height: f64) -> Point3 {
        self.origin + self.direction * height
    }
}

/// A plane, sphere, cylinder, cone or torus without ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Carrier {
    /// A plane.
    Plane(crate::Plane),
    /// A sphere.
    Sphere {
        /// Its centre.
        center: Point3,
        /// Its radius.
        radius: f64,
    },
    /// A cylinder.
    Cylinder {
        /// Its axis.
        axis: Axis,
        /// Its radius.
        radius: f64,
    },
    /// A double cone.
    Cone {
        /// Its axis, from its apex.
        axis: Axis,
        /// The angle between the axis and the rulings, in radians, between 0 and a right angle.
        half_angle: f64,
    },
    /// A torus without self-intersections.
    Torus {
        /// Its axis, from its centre.
        axis: Axis,
        /// The radius of the middle circle of its tube.
        major_radius: f64,
        /// The radius of its tube, less than the other.
        minor_radius: f64,
    },
}

impl Carrier {
    /// The carrier on which a surface of any kind lies within `tolerance`: also one inside a NURBS surface, a sum or a
    /// revolution. `None` when there is none of these kinds.
    pub fn of(surface: &Surface, tolerance: f64) -> Option<Self> {
        if let Some(round) = Round::of(surface) {
            return Some(Self::of_round(&round));
        }
        let axis = |p: &crate::Plane| Axis { origin: p.origin, direction: p.z_axis };
        if let Some(plane) = surface.plane(tolerance) {
            return Some(Self::Plane(plane));
        }
        if let Some(s) = surface.as_sphere(tolerance) {
            return Some(Self::Sphere { center: s.plane.origin, radius: s.radius });
        }
        if let Some(c) = surface.as_cylinder(tolerance) {
            return Some(Self::Cylinder { axis: axis(&c.plane), radius: c.radius });
        }
        if let Some(c) = surface.as_cone(tolerance) {
            return Some(Self::Cone { axis: axis(&c.plane), half_angle: c.half_angle() });
        }
        let t = surface.as_torus(tolerance)?;
        Some(Self::Torus { axis: axis(&t.plane), major_radius: t.major_radius, minor_radius: t.minor_radius })
    }

    /// The carrier of a surface that is made as a part of it.
    fn of_round(round: &Round) -> Self {
        let axis = Axis { origin: round.frame.origin, direction: round.frame.z_axis };
        match round.form {
            RoundForm::Sphere(radius) => Self::Sphere { center: axis.origin, radius },
            RoundForm::Cylinder(radius) => Self::Cylinder { axis, radius },
            RoundForm::Cone(slope) => Self::Cone { axis, half_angle: slope.arctangent() },
        }
    }

    /// As [`Self::of`], for a tolerance that leaves rounding only: the curvatures at a few places tell which kind alone it may
    /// be.
    pub(crate) fn exactly(surface: &Surface, tolerance: f64) -> Option<Self> {
        if let Some(plane) = surface.plane(tolerance) {
            return Some(Self::Plane(plane));
        }
        let shares = [0.21, 0.48, 0.83];
        let [du, dv] = Direction::BOTH.map(|d| surface.domain(d));
        let bends: Vec<[f64; 2]> = shares
            .iter()
            .flat_map(|x| shares.map(|y| (du.at(*x), dv.at(y))))
            .filter_map(|(u, v)| Some(surface.curvature_at(u, v).ok()?.principal))
            .collect();
        let larger = |[a, b]: &[f64; 2]| a.abs().max(b.abs());
        let same = |a: f64, b: f64, unit: f64| (a - b).abs() <= SAME_BEND * unit;
        let axis = |p: &crate::Plane| Axis { origin: p.origin, direction: p.z_axis };
        let first = bends.first()?;
        if bends.iter().all(|k| same(k[0], k[1], larger(k)) && same(k[0], first[0], larger(first))) {
            let s = surface.as_sphere(tolerance)?;
            return Some(Self::Sphere { center: s.plane.origin, radius: s.radius });
        }
        if bends.iter().all(|k| k[0].abs().min(k[1].abs()) <= SAME_BEND * larger(k)) {
            let round = |k: &[f64; 2]| same(larger(k), larger(first), larger(first));
            if bends.iter().all(round) {
                let c = surface.as_cylinder(tolerance)?;
                return Some(Self::Cylinder { axis: axis(&c.plane), radius: c.radius });
            }
            let c = surface.as_cone(tolerance)?;
            return Some(Self::Cone { axis: axis(&c.plane), half_angle: c.half_angle() });
        }
        if !first.iter().any(|tube| bends.iter().all(|k| k.iter().any(|x| same(*x, *tube, tube.abs())))) {
            return None;
        }
        let t = surface.as_torus(tolerance)?;
        Some(Self::Torus { axis: axis(&t.plane), major_radius: t.major_radius, minor_radius: t.minor_radius })
    }

    /// The distance between a point and the surface.
    pub fn distance_to(&self, p: Point3) -> f64 {
        match self {
            Self::Plane(plane) => plane.signed_distance(p).abs(),
            Self::Sphere { center, radius } => (p.distance_to(*center) - radius).abs(),
            Self::Cylinder { axis, radius } => (axis.split(p).1.length() - radius).abs(),
            Self::Cone { axis, half_angle } => {
                let (height, way) = axis.split(p);
                let (sin, cos) = half_angle.sine_cosine();
                // On the side of the nearer nappe; beyond the ruling's start the apex is nearest.
                let (r, z) = (way.length(), height.abs());
                if r * sin + z * cos <= 0.0 { r.hypotenuse(z) } else { (r * cos - z * sin).abs() }
            }
            Self::Torus { axis, major_radius, minor_radius } => {
                let (height, way) = axis.split(p);
                ((way.length() - major_radius).hypotenuse(height) - minor_radius).abs()
            }
        }
    }

    /// The direction in which a point leaves the surface fastest, away from a centre, an axis or the middle of a tube; not of
    /// unit length. 0 where there is none.
    pub(crate) fn gradient(&self, p: Point3) -> Vector3 {
        match self {
            Self::Plane(plane) => plane.z_axis,
            Self::Sphere { center, .. } => p - *center,
            Self::Cylinder { axis, .. } => axis.split(p).1,
            Self::Cone { axis, half_angle } => {
                let (height, way) = axis.split(p);
                let (sin, cos) = half_angle.sine_cosine();
                let out = way.unitized().unwrap_or(Vector3::ZERO);
                out * cos - axis.direction * (sin * height.signum())
            }
            Self::Torus { axis, major_radius, .. } => {
                let (height, way) = axis.split(p);
                let out = way.unitized().unwrap_or(Vector3::ZERO);
                way - out * *major_radius + axis.direction * height
            }
        }
    }

    /// The most by which [`Self::gradient`] changes within a distance of a point; `None` where an axis or the middle plane of a double
    /// cone lies as near.
    ///
    /// Half the square of the distance from a centre, an axis or the middle of a tube has a gradient that changes by no more
    /// than the way, times the radius over the distance to the axis more for a tube; a cone's turns with the way around its axis
    /// (derived here).
    pub(crate) fn gradient_change(&self, p: Point3, reach: f64) -> Option<f64> {
        match self {
            Self::Plane(_) => Some(0.0),
            Self::Sphere { .. } | Self::Cylinder { .. } => Some(reach),
            Self::Cone { axis, half_angle } => {
                let (height, way) = axis.split(p);
                let left = way.length() - reach;
                (left > 0.0 && height.abs() > reach).then(|| reach / left * half_angle.cosine())
            }
            Self::Torus { axis, major_radius, .. } => {
                let left = axis.split(p).1.length() - reach;
                (left > 0.0).then(|| reach * (1.0 + major_radius / left))
            }
        }
    }
}
