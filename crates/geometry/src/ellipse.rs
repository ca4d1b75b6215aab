use katydid_elementary::Elementary;

use crate::thresholds;
use crate::{Circle, Error, Plane, Point3, Result, Vector3, Xform};

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
        let (sin, cos) = angle.sine_cosine();
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
        let factor = xform.similarity_factor(thresholds::ROUNDING)?.abs();
        Self::new(self.plane.transformed(xform).ok()?, self.rx * factor, self.ry * factor).ok()
    }
}

impl Ellipse {
    /// The ellipse center + p·cos t + q·sin t of two conjugate radii, which need not be at right angles; its x axis
    /// is the longer one (D. Rytz's construction, solved by turning t to where the radius is longest).
    ///
    /// # Errors
    /// The radii are parallel or one has no length, or a number is not finite.
    pub fn from_conjugate_radii(center: Point3, p: Vector3, q: Vector3) -> Result<Self> {
        let (pp, qq, pq) = (p.length_squared(), q.length_squared(), p.dot(q));
        // |p cos t + q sin t|² is (pp + qq)/2 + (pp − qq)/2 cos 2t + pq sin 2t.
        let (sin, cos) = (0.5 * pq.arctangent_of(0.5 * (pp - qq))).sine_cosine();
        let (long, short) = (p * cos + q * sin, q * cos - p * sin);
        let plane = Plane::from_axes(center, long, short)
            .map_err(|_| Error::degenerate("conjugate radii", "they are parallel or have no length"))?;
        if !plane.is_finite() {
            return Err(Error::NotFinite("conjugate radius"));
        }
        // The area is the one thing that cancellation in a thin ellipse does not touch.
        let rx = long.length();
        Self::new(plane, rx, p.cross(q).length() / rx)
    }

    /// The image of a circle under an affine map, which is an ellipse again, its longer radius along x.
    ///
    /// # Errors
    /// The map is not affine, or flattens the circle.
    pub fn image_of_circle(circle: &Circle, xform: &Xform) -> Result<Self> {
        let Circle { plane, radius } = *circle;
        Self { plane, rx: radius, ry: radius }.image(xform)
    }

    /// The image under an affine map, its longer radius along x.
    ///
    /// # Errors
    /// The map is not affine, or flattens the ellipse.
    pub fn image(&self, xform: &Xform) -> Result<Self> {
        if !xform.is_affine() {
            return Err(Error::degenerate(
                "transform",
                "the image of an ellipse under a projective map may be open",
            ));
        }
        let (x, y) = (self.plane.x_axis * self.rx, self.plane.y_axis * self.ry);
        Self::from_conjugate_radii(xform.point(self.plane.origin), xform.vector(x), xform.vector(y))
    }
}
