//! Partial derivatives of surfaces of every kind.

use super::Surface;
use crate::nurbs::MAX_ORDER;
use crate::{Quadrant, SurfaceDerivatives, Vector3};

impl Surface {
    /// The point and all partial derivatives up to a total order (32 at most), at a knot or joint those of the piece
    /// on the given side.
    pub fn derivatives(&self, u: f64, v: f64, order: usize, side: Quadrant) -> SurfaceDerivatives {
        let (order, below) = (order.min(MAX_ORDER), side.from_below());
        match self {
            Self::Plane(s) => {
                let [du, dv] = s.partials();
                SurfaceDerivatives::from_fn(order, |i, j| match (i, j) {
                    (0, 0) => s.point_at(u, v).to_vector(),
                    (1, 0) => du,
                    (0, 1) => dv,
                    _ => Vector3::ZERO,
                })
            }
            Self::Sum(s) => s.derivatives(u, v, order, below),
            Self::Revolution(s) => s.derivatives(u, v, order, below),
            Self::Nurbs(s) => s.derivatives(u, v, order, side),
        }
    }
}
