use crate::{Error, Plane, Point3, Result};

/// A full ellipse in a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipse {
    /// The plane; its origin is the centre and the two radii lie along its x and y axes.
    pub plane: Plane,
    /// The radius along the plane's x axis, greater than 0.
    pub rx: f64,
    /// The radius along the plane's y axis, greater than 0.
    pub ry: f64,
}

impl Ellipse {
    /// The ellipse with the two radii along the plane's x and y axes.
    ///
    /// # Errors
    /// When a radius is not a finite number greater than 0.
    pub fn new(plane: Plane, rx: f64, ry: f64) -> Result<Self> {
        for (what, value) in [("radius along x", rx), ("radius along y", ry)] {
            if !(value.is_finite() && value > 0.0) {
                return Err(Error::OutOfRange { what, value, must: "finite and greater than 0" });
            }
        }
        Ok(Self { plane, rx, ry })
    }

    /// The point at the eccentric angle in radians: (rx cos, ry sin) in the plane.
    #[inline]
    pub fn at(&self, angle: f64) -> Point3 {
        let (sin, cos) = angle.sin_cos();
        self.plane.at(self.rx * cos, self.ry * sin, 0.0)
    }

    /// The two foci, on the longer axis; the one on the positive side first.
    pub fn foci(&self) -> [Point3; 2] {
        let c = (self.rx * self.rx - self.ry * self.ry).abs().sqrt();
        if self.rx >= self.ry {
            [self.plane.at(c, 0.0, 0.0), self.plane.at(-c, 0.0, 0.0)]
        } else {
            [self.plane.at(0.0, c, 0.0), self.plane.at(0.0, -c, 0.0)]
        }
    }
}

impl Ellipse {
    /// The image under a similarity; `None` when the map does not keep angles. Other images are exact as NURBS curves:
    /// [`Ellipse::to_nurbs`], then [`crate::NurbsCurve::transformed`].
    pub fn transformed(&self, xform: &crate::Xform) -> Option<Self> {
        let factor = xform.similarity_factor(1e-12)?.abs();
        Self::new(self.plane.transformed(xform).ok()?, self.rx * factor, self.ry * factor).ok()
    }
}
