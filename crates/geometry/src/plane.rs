use crate::{Error, Point3, Result, Vector3};

/// A frame: an origin and three unit axes at right angles, right-handed (z = x × y).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// The origin.
    pub origin: Point3,
    /// The first axis, of length 1.
    pub x_axis: Vector3,
    /// The second axis, of length 1.
    pub y_axis: Vector3,
    /// The normal, of length 1.
    pub z_axis: Vector3,
}

impl Plane {
    /// World XY.
    pub const XY: Self =
        Self { origin: Point3::ORIGIN, x_axis: Vector3::X, y_axis: Vector3::Y, z_axis: Vector3::Z };

    /// The plane at `origin` with the given first axis and the second turned to be perpendicular to it.
    ///
    /// # Errors
    /// When an axis has no length or the two are parallel.
    pub fn from_axes(origin: Point3, x_axis: Vector3, y_axis: Vector3) -> Result<Self> {
        let x = x_axis.unitized().ok_or(Error::degenerate("x axis", "it has no length"))?;
        let y = y_axis.unitized().ok_or(Error::degenerate("y axis", "it has no length"))?;
        let z = x.cross(y);
        if z.length() < 1e-12 {
            return Err(Error::degenerate("axes", "they are parallel"));
        }
        let z = z.unitized().ok_or(Error::degenerate("axes", "they are parallel"))?;
        Ok(Self { origin, x_axis: x, y_axis: z.cross(x), z_axis: z })
    }

    /// The point at plane coordinates (u, v, w).
    #[inline]
    pub fn at(&self, u: f64, v: f64, w: f64) -> Point3 {
        self.origin + self.x_axis * u + self.y_axis * v + self.z_axis * w
    }

    /// The plane coordinates of a world point.
    #[inline]
    pub fn coordinates(&self, p: Point3) -> [f64; 3] {
        let d = p - self.origin;
        [d.dot(self.x_axis), d.dot(self.y_axis), d.dot(self.z_axis)]
    }
}
