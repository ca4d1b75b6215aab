//! How the parameters of a surface in a file follow from those of the kernel's.

use crate::Result;
use katydid_geometry::{Curve, Interval, Xform};

/// A linear map of parameter planes: each of the file's parameters is one of the kernel's, scaled and moved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Chart {
    /// Whether the first parameter of the file is the kernel's second.
    pub(super) swapped: bool,
    /// For each of the kernel's parameters the factor and what is added.
    pub(super) maps: [[f64; 2]; 2],
    /// Whether curves in the kernel's parameter plane stay on the surface: not where the surface is written in another
    /// form that has other parameters in between.
    pub(super) is_exact: bool,
}

impl Chart {
    /// The same parameters.
    pub(super) const SAME: Self = Self { swapped: false, maps: [[1.0, 0.0], [1.0, 0.0]], is_exact: true };
    /// Parameters that are not told.
    pub(super) const NONE: Self = Self { is_exact: false, ..Self::SAME };

    /// Whether the normal of the file's surface, if it is the cross product of its derivatives, is opposite.
    pub(super) fn turns(&self) -> bool {
        let [[u, _], [v, _]] = self.maps;
        (u * v < 0.0) != self.swapped
    }

    /// A curve of the kernel's parameter plane in the file's.
    pub(super) fn image(&self, curve: &Curve) -> Result<Curve> {
        if *self == Self::SAME {
            return Ok(curve.clone());
        }
        let [[a, b], [c, d]] = self.maps;
        let (u, v) = ([a, 0.0, 0.0, b], [0.0, c, 0.0, d]);
        let rows = if self.swapped { [v, u] } else { [u, v] };
        let xform = Xform { rows: [rows[0], rows[1], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]] };
        // An arc that is squeezed is none.
        let curve = if let Curve::Arc(_) = curve { curve.to_nurbs()?.into() } else { curve.clone() };
        Ok(curve.transformed(&xform)?)
    }
}

/// The factor and shift that take one interval to another.
pub(super) fn linear(from: Interval, to: [f64; 2]) -> [f64; 2] {
    let factor = (to[1] - to[0]) / from.length();
    [factor, to[0] - factor * from.start]
}
