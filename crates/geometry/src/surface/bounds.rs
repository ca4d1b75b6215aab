//! Boxes around surfaces.

use super::{RevolutionSurface, Surface};
use crate::{BoundingBox, Box3, Curve, Direction, Interval, Plane, Point3, Result, Vector3};

/// The circles or arcs through the ends of a segment that is turned about an axis, or points on the axis. Every ruling of
/// the surface goes from one to the other, so that what holds both holds the surface.
struct Rims([Rim; 2]);

enum Rim {
    Around(Curve),
    OnAxis(Point3),
}

impl Rims {
    /// Of a cylinder, a cone or a disc; none where the profile is not straight.
    fn of(surface: &RevolutionSurface) -> Option<Self> {
        let Curve::Line(profile) = surface.profile() else { return None };
        let rim = |t: f64, end: Point3| surface.parallel(t).map_or(Rim::OnAxis(end), Rim::Around);
        let domain = profile.domain;
        Some(Self([rim(domain.start, profile.line.from), rim(domain.end, profile.line.to)]))
    }

    fn extent_along(&self, direction: Vector3) -> Interval {
        let [a, b] = self.0.each_ref().map(|rim| match rim {
            Rim::Around(curve) => curve.extent_along(direction),
            Rim::OnAxis(point) => {
                let at = point.to_vector().dot(direction);
                Interval::new(at, at)
            }
        });
        Interval::new(a.start.min(b.start), a.end.max(b.end))
    }

    fn bounding_box(&self) -> BoundingBox {
        let [a, b] = self.0.each_ref().map(|rim| match rim {
            Rim::Around(curve) => curve.bounding_box(),
            Rim::OnAxis(point) => BoundingBox { min: *point, max: *point },
        });
        a.union(&b)
    }
}

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
            Self::Revolution(s) => match Rims::of(s) {
                Some(rims) => Ok(rims.extent_along(direction)),
                None => Ok(s.to_nurbs()?.extent_along(direction)),
            },
        }
    }

    /// The smallest box along the world axes that holds the surface.
    ///
    /// # Errors
    /// As [`Surface::extent_along`].
    pub fn bounding_box(&self) -> Result<BoundingBox> {
        if let Self::Revolution(s) = self {
            // Made once for all three.
            return match Rims::of(s) {
                Some(rims) => Ok(rims.bounding_box()),
                None => Self::Nurbs(s.to_nurbs()?).bounding_box(),
            };
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
