//! Boxes around surfaces.

use std::f64::consts::{PI, TAU};

use katydid_elementary::Elementary;

use super::thresholds::RECOGNISED;
use super::{RevolutionSurface, Surface};
use crate::{BoundingBox, Box3, Direction, Interval, Plane, Point3, Result, Vector3};

impl Surface {
    /// The range that the surface reaches along `direction`, measured from the origin in lengths of it; exact to
    /// 1e-12 of its size, see [`crate::NurbsSurface::extent_along`].
    ///
    /// # Errors
    /// A surface of revolution has a degenerate profile.
    pub fn extent_along(&self, direction: Vector3) -> Result<Interval> {
        match self {
            Self::Sum(s) => {
                let [a, b] = s.curves();
                let (x, y) = (a.extent_along(direction), b.extent_along(direction));
                let shift = s.shift().dot(direction);
                Ok(Interval::new(x.start + y.start + shift, x.end + y.end + shift))
            }
            Self::Nurbs(s) => Ok(s.extent_along(direction)),
            Self::Plane(s) => {
                let [u, v] = Direction::BOTH.map(|d| s.domain(d));
                let corners = [(u.start, v.start), (u.start, v.end), (u.end, v.start), (u.end, v.end)];
                let reach = corners.map(|(u, v)| s.point_at(u, v).to_vector().dot(direction));
                Ok(Interval::new(
                    reach.iter().copied().fold(f64::INFINITY, f64::min),
                    reach.iter().copied().fold(f64::NEG_INFINITY, f64::max),
                ))
            }
            Self::Revolution(s) => match s.half_plane() {
                Some(arm) => Ok(s.extent_in_half_plane(arm, direction)),
                None => Ok(s.to_nurbs()?.extent_along(direction)),
            },
        }
    }

    /// The smallest box along the world axes that holds the surface.
    ///
    /// # Errors
    /// As [`Surface::extent_along`].
    pub fn bounding_box(&self) -> Result<BoundingBox> {
        if let Self::Revolution(s) = self
            && s.half_plane().is_none()
        {
            // Converted once for all three.
            return Self::Nurbs(s.to_nurbs()?).bounding_box();
        }
        let (x, y, z) =
            (self.extent_along(Vector3::X)?, self.extent_along(Vector3::Y)?, self.extent_along(Vector3::Z)?);
        Ok(BoundingBox { min: Point3::new(x.start, y.start, z.start), max: Point3::new(x.end, y.end, z.end) })
    }

    /// The smallest box along a plane's axes that holds the surface.
    ///
    /// # Errors
    /// As [`Surface::extent_along`].
    pub fn bounding_box_in(&self, plane: &Plane) -> Result<Box3> {
        let along = |axis: Vector3| {
            let range = self.extent_along(axis)?;
            let origin = plane.origin.to_vector().dot(axis);
            Ok(Interval::new(range.start - origin, range.end - origin))
        };
        Ok(Box3 { plane: *plane, x: along(plane.x_axis)?, y: along(plane.y_axis)?, z: along(plane.z_axis)? })
    }
}

/// The range of `a cos t + b sin t` between two angles in radians.
fn range_of_turn([a, b]: [f64; 2], angle: Interval, is_full: bool) -> Interval {
    let most = a.hypotenuse(b);
    if is_full {
        return Interval::new(-most, most);
    }
    let ends = [angle.start, angle.end].map(|t| {
        let (sin, cos) = t.sine_cosine();
        a * cos + b * sin
    });
    let top = b.arctangent_of(a);
    let meets = |t: f64| t + ((angle.start - t) / TAU).ceil() * TAU <= angle.end;
    Interval::new(
        if meets(top + PI) { -most } else { ends[0].min(ends[1]) },
        if meets(top) { most } else { ends[0].max(ends[1]) },
    )
}

impl RevolutionSurface {
    /// The unit direction away from the axis in which a profile lies that is in one plane with the axis; none where it is
    /// not, or lies on the axis.
    fn half_plane(&self) -> Option<Vector3> {
        let (profile, axis) = (self.profile(), self.axis());
        let unit = axis.unit_direction()?;
        let away = |t: f64| {
            let w = profile.point_at(profile.domain().at(t)) - axis.from;
            w - unit * w.dot(unit)
        };
        let farther = |a: Vector3, b: Vector3| if b.length() > a.length() { b } else { a };
        let arm = [0.0, 0.25, 0.5, 0.75, 1.0].map(away).into_iter().reduce(farther)?;
        let across = unit.cross(arm).unitized()?;
        let leaves = profile.extent_along(across);
        let middle = axis.from.to_vector().dot(across);
        let size = arm.length() + axis.from.to_vector().length();
        let is_flat = (leaves.start - middle).abs().max((leaves.end - middle).abs()) <= RECOGNISED * size;
        is_flat.then(|| across.cross(unit))
    }

    /// The range along `direction` where the profile lies in the plane of the axis and of `arm`, a unit vector upright on
    /// it. At the height h and the signed distance r from the axis a point that is turned by t reaches
    /// h (unit · d) + r (arm · d cos t + turned arm · d sin t): for each r the extremes are at those of the bracket,
    /// whatever the point, and for these it is linear in the point of the profile. Derived here.
    fn extent_in_half_plane(&self, arm: Vector3, direction: Vector3) -> Interval {
        let unit = self.axis().unit_direction().unwrap_or(Vector3::ZERO);
        let origin = self.axis().from.to_vector();
        let turned = unit.cross(arm);
        let bracket =
            range_of_turn([arm.dot(direction), turned.dot(direction)], self.angle(), self.is_full_turn());
        let reach = |turn: f64| {
            let towards = unit * unit.dot(direction) + arm * turn;
            let along = self.profile().extent_along(towards);
            let shift = origin.dot(direction) - origin.dot(towards);
            Interval::new(along.start + shift, along.end + shift)
        };
        let (a, b) = (reach(bracket.start), reach(bracket.end));
        Interval::new(a.start.min(b.start), a.end.max(b.end))
    }
}
