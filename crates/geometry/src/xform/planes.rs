//! Images of planes.

use crate::{Error, Plane, PlaneEquation, Result, Xform};

impl Plane {
    /// The image of the frame: origin, x and y axes are mapped and made a frame again.
    ///
    /// # Errors
    /// The map leaves no plane: an image axis has no length, the two become parallel, or a number overflows.
    pub fn transformed(&self, xform: &Xform) -> Result<Self> {
        let origin = xform.point(self.origin);
        if !origin.is_finite() {
            return Err(Error::NotFinite("transformed plane"));
        }
        let (x, y) = if xform.is_affine() {
            (xform.vector(self.x_axis), xform.vector(self.y_axis))
        } else {
            (xform.point(self.at(1.0, 0.0, 0.0)) - origin, xform.point(self.at(0.0, 1.0, 0.0)) - origin)
        };
        Self::from_axes(origin, x, y)
    }
}

impl PlaneEquation {
    /// The image of the plane: coefficients are mapped by the inverse from the right.
    ///
    /// # Errors
    /// The map has no inverse, or sends the plane to infinity.
    pub fn transformed(&self, xform: &Xform) -> Result<Self> {
        let inverse = xform.inverse().ok_or(Error::degenerate("transform", "it has no inverse"))?;
        let e = self.coefficients();
        let [a, b, c, d] = std::array::from_fn(|j| (0..4).map(|i| e[i] * inverse.rows[i][j]).sum());
        Self::new(a, b, c, d)
    }
}
