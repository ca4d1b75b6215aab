//! The order of the regions around a piece.

use katydid_elementary::Elementary;

use super::arrangement::{Track, trim_parameter};
use super::shells::{Shells, Use};
use super::thresholds::{RADIAL_APART, RADIAL_AT, RADIAL_STEP};
use crate::{Point3, Result, Vector3};

impl Shells<'_> {
    /// The uses of a piece in the order of the angles at which their faces leave it, counter-clockwise about it. A face
    /// that runs forwards has its inside at normal × axis: its normal looks to larger angles.
    pub(super) fn radial(&self, piece: usize, uses: &[Use]) -> Result<Vec<Use>> {
        Ok(self.angles(piece, uses)?.into_iter().map(|k| k.1).collect())
    }

    /// As [`Self::radial`] with the angles, in radians.
    pub(super) fn angles(&self, piece: usize, uses: &[Use]) -> Result<Vec<(f64, Use)>> {
        let refused = || self.refuse_at(piece, uses);
        let own = self.pieces.list.get(piece).ok_or_else(refused)?;
        let t = own.curve.domain().at(RADIAL_AT);
        let p = own.curve.point_at(t);
        let axis = own.curve.tangent_at(t).ok_or_else(refused)?;
        let x = axis.perpendicular().and_then(Vector3::unitized).ok_or_else(refused)?;
        let y = axis.cross(x);
        let reach = uses.iter().filter_map(|u| self.reach(u)).fold(own.bounds.diagonal().length(), f64::min);
        let mut keyed: Vec<(f64, Use)> = Vec::with_capacity(uses.len());
        for own in uses {
            let way = self.leaving(own, p, axis, RADIAL_STEP * reach).ok_or_else(refused)?;
            keyed.push((way.dot(y).arctangent_of(way.dot(x)), *own));
        }
        keyed.sort_by(|a, b| a.0.total_cmp(&b.0));
        // Faces that leave together are not in an order that can be relied on.
        let next = keyed.iter().cycle().skip(1);
        let close = keyed.iter().zip(next).any(|(a, b)| {
            let apart = (b.0 - a.0).rem_euclid(std::f64::consts::TAU);
            apart.min(std::f64::consts::TAU - apart) < RADIAL_APART
        });
        if close {
            return Err(refused());
        }
        Ok(keyed)
    }

    /// About how wide the region of a use is.
    fn reach(&self, own: &Use) -> Option<f64> {
        let region = self.region(own.chosen)?;
        Some(self.all.faces.get(region.face)?.bounds.diagonal().length())
    }

    /// The direction in which the region of a use leaves a point of its piece, by a place a little inside.
    fn leaving(&self, own: &Use, p: Point3, axis: Vector3, step: f64) -> Option<Vector3> {
        let region = self.region(own.chosen)?;
        let face = self.all.faces.get(region.face)?;
        let taken = region.loops.get(own.step.0)?.get(own.step.1)?;
        let backwards = matches!(taken.track, Track::Piece(_, true));
        let guess = taken.curve.domain().at(if backwards { 1.0 - RADIAL_AT } else { RADIAL_AT });
        let t = trim_parameter(face, &taken.curve, guess, p);
        let [uv, slope] = taken.curve.jet_at::<2>(t, false);
        let d = face.surface.derivatives(uv.x, uv.y, 1, face.surface.inner_quadrant(uv.x, uv.y));
        let (by_u, by_v) = (d.get(1, 0), d.get(0, 1));
        let normal = by_u.cross(by_v).unitized()?;
        // The face lies to the left of its trims.
        let along = (by_u * slope.x + by_v * slope.y).unitized()?;
        let inward = normal.cross(along);
        let rate = crate::chart::Chart::lifted(&[d.point().to_vector(), by_u, by_v], inward * step)?;
        let q = face.surface.point_at(uv.x + rate[0], uv.y + rate[1]);
        let way = q - p;
        Some(way - axis * way.dot(axis))
    }
}
