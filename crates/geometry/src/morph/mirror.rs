//! Reflections in curves and surfaces.

use super::{Morph, finite};
use crate::curve::ClosestOnCurve;
use crate::{ClosestOnSurface, Curve, Point3, Result, Surface, Vector3};

/// Reflects every point in the point of a curve that is nearest to it.
///
/// Where two points of the curve are equally near, the map leaps from one side to the other.
#[derive(Debug, Clone)]
pub struct MirrorInCurve<'a> {
    nearest: ClosestOnCurve<'a>,
    /// The ends with the directions that lead away from the curve, when it is to go on.
    rays: Vec<(Point3, Vector3)>,
}

impl<'a> MirrorInCurve<'a> {
    /// The reflection in a curve; when `extended`, an open one goes on straight beyond its ends.
    pub fn new(curve: &'a Curve, extended: bool) -> Self {
        let domain = curve.domain();
        let ends = [(curve.start(), domain.start, -1.0), (curve.end(), domain.end, 1.0)];
        let rays = if extended && !curve.is_closed() {
            ends.into_iter()
                .filter_map(|(p, t, sign)| Some((p, curve.tangent_on_side(t, sign > 0.0)? * sign)))
                .collect()
        } else {
            Vec::new()
        };
        Self { nearest: ClosestOnCurve::new(curve), rays }
    }

    /// The point of the curve, or of what it goes on by, that is nearest to `p`.
    ///
    /// # Errors
    /// `p` is not finite, or too far away.
    pub fn foot(&self, p: Point3) -> Result<Point3> {
        let mut best = self.nearest.nearest(p)?.point;
        for (end, along) in &self.rays {
            let foot = *end + *along * (p - *end).dot(*along).max(0.0);
            if p.distance_to(foot) < p.distance_to(best) {
                best = foot;
            }
        }
        Ok(best)
    }
}

impl Morph for MirrorInCurve<'_> {
    fn image(&self, p: Point3) -> Result<Point3> {
        let foot = self.foot(p)?;
        finite(foot + (foot - p))
    }
}

/// Reflects every point in the point of a surface that is nearest to it.
#[derive(Debug, Clone)]
pub struct MirrorInSurface<'a> {
    surface: &'a Surface,
    nearest: ClosestOnSurface,
    extended: bool,
}

impl<'a> MirrorInSurface<'a> {
    /// The reflection in a surface; when `extended`, it goes on beyond its edges by its tangent planes there.
    ///
    /// # Errors
    /// The surface has no NURBS form.
    pub fn new(surface: &'a Surface, extended: bool) -> Result<Self> {
        Ok(Self { surface, nearest: ClosestOnSurface::new(surface)?, extended })
    }

    /// The point of the surface, or of what it goes on by, in which `p` is reflected.
    ///
    /// # Errors
    /// `p` is not finite, or too far away.
    pub fn foot(&self, p: Point3) -> Result<Point3> {
        let near = self.nearest.nearest(p)?;
        match self.surface.normal_at(near.u, near.v) {
            Some(normal) if self.extended => Ok(p - normal * (p - near.point).dot(normal)),
            _ => Ok(near.point),
        }
    }
}

impl Morph for MirrorInSurface<'_> {
    fn image(&self, p: Point3) -> Result<Point3> {
        let foot = self.foot(p)?;
        finite(foot + (foot - p))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Interval, Line, Plane, PlaneSurface, Tolerance};

    #[test]
    fn twice_is_nothing() {
        let line: Curve = Line::new(Point3::ORIGIN, Point3::new(4.0, 0.0, 0.0)).into();
        let (open, extended) = (MirrorInCurve::new(&line, false), MirrorInCurve::new(&line, true));
        for p in [[1.0, 2.0, 3.0], [9.0, 1.0, 0.0], [-1.0, -1.0, 0.0]].map(Point3::from) {
            for mirror in [&open, &extended] {
                let back = mirror.image(mirror.image(p).unwrap()).unwrap();
                assert!(back.distance_to(p) < 1e-9 || p.x < 0.0 || p.x > 4.0);
            }
            let back = extended.image(extended.image(p).unwrap()).unwrap();
            assert!(back.distance_to(p) < 1e-9);
        }
        assert_eq!(open.image(Point3::new(9.0, 1.0, 0.0)).unwrap(), Point3::new(-1.0, -1.0, 0.0));
        assert!(
            extended.image(Point3::new(9.0, 1.0, 0.0)).unwrap().distance_to(Point3::new(9.0, -1.0, 0.0))
                < 1e-9
        );
        let other: Curve = Line::new(Point3::new(0.0, 1.0, 0.0), Point3::new(6.0, 2.0, 0.0)).into();
        let image = other.morphed(&extended, &Tolerance::default()).unwrap();
        assert!(image.end().distance_to(Point3::new(6.0, -2.0, 0.0)) < 1e-9);
    }

    #[test]
    fn a_plane_mirrors_as_it_should() {
        let sheet: Surface =
            PlaneSurface::new(Plane::XY, Interval::new(0.0, 2.0), Interval::new(0.0, 2.0)).unwrap().into();
        let p = Point3::new(1.0, 1.0, 3.0);
        let mirror = MirrorInSurface::new(&sheet, false).unwrap();
        assert!(mirror.image(p).unwrap().distance_to(Point3::new(1.0, 1.0, -3.0)) < 1e-9);
        let beyond = Point3::new(5.0, 1.0, 3.0);
        assert!(mirror.image(beyond).unwrap().distance_to(Point3::new(-1.0, 1.0, -3.0)) < 1e-9);
        let extended = MirrorInSurface::new(&sheet, true).unwrap();
        assert!(extended.image(beyond).unwrap().distance_to(Point3::new(5.0, 1.0, -3.0)) < 1e-9);
    }
}
