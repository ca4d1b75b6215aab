//! Sections in the coordinates of a moving frame, and what lies between them.

use crate::construct::thresholds::NO_WIDTH;
use crate::nurbs::{Skinning, skinned};
use crate::{
    Direction, Error, NurbsCurve, NurbsSurface, Point3, Result, Vector3, cancellation, compatible_curves,
};

/// An affine frame: where the axes and the origin of a section's coordinates go.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    pub(super) origin: Point3,
    pub(super) axes: [Vector3; 3],
}

impl Frame {
    /// A curve in the frame's coordinates, in space.
    pub(super) fn placed(&self, local: &NurbsCurve) -> Result<NurbsCurve> {
        cancellation::room::<[f64; 4]>(2 * local.point_count())?;
        let [x, y, z] = self.axes;
        moved(local, |[a, b, c, w]| {
            let p = self.origin.to_vector() * w + x * a + y * b + z * c;
            [p.x, p.y, p.z, w]
        })
    }

    /// A curve in space, in the frame's coordinates.
    pub(super) fn local(&self, curve: &NurbsCurve) -> Result<NurbsCurve> {
        let [x, y, z] = self.axes;
        let volume = x.dot(y.cross(z));
        let size = x.length() * y.length() * z.length();
        if !(volume.abs() > NO_WIDTH * size) {
            return Err(Error::degenerate("section", "it stands where the sweep has no width"));
        }
        moved(curve, |[a, b, c, w]| {
            let d = Vector3::new(a, b, c) - self.origin.to_vector() * w;
            let along = |u: Vector3, v: Vector3| d.dot(u.cross(v)) / volume;
            [along(y, z), along(z, x), along(x, y), w]
        })
    }
}

fn moved(curve: &NurbsCurve, to: impl Fn([f64; 4]) -> [f64; 4]) -> Result<NurbsCurve> {
    let points: Vec<[f64; 4]> = curve.homogeneous_points().into_iter().map(to).collect();
    let knots = curve.knots().to_vec();
    if curve.is_rational() {
        return NurbsCurve::rational(curve.degree(), points, knots);
    }
    NurbsCurve::new(curve.degree(), points.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect(), knots)
}

/// What a section is at each place of a rail: the only one, or between several.
pub(super) enum Sections {
    One(NurbsCurve),
    Between(NurbsSurface),
}

impl Sections {
    /// Sections at increasing places.
    pub(super) fn new(local: &[NurbsCurve], places: &[f64]) -> Result<Self> {
        let mut curves = compatible_curves(local)?;
        if curves.len() > 1 {
            return Ok(Self::Between(skinned(&curves, Skinning::Through, places, false)?));
        }
        curves.pop().map(Self::One).ok_or(Error::degenerate("sweep", "there are no sections"))
    }

    pub(super) fn is_one(&self) -> bool {
        matches!(self, Self::One(_))
    }

    /// The section at a place; beyond the first and the last it stays as it is there.
    pub(super) fn at(&self, place: f64) -> Result<NurbsCurve> {
        match self {
            Self::One(curve) => Ok(curve.clone()),
            Self::Between(surface) => {
                surface.isocurve(Direction::U, surface.domain(Direction::V).clamp(place))
            }
        }
    }
}
