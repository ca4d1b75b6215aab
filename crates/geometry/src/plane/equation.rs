//! Planes as an equation.

use crate::{Error, Plane, Point3, Result, Vector3};

/// The plane a·x + b·y + c·z + d = 0 with (a, b, c) of length 1, so that the left side is the signed distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneEquation {
    normal: Vector3,
    d: f64,
}

impl PlaneEquation {
    /// The plane a·x + b·y + c·z + d = 0; all four numbers are divided by the length of (a, b, c).
    ///
    /// # Errors
    /// a, b and c are all 0, or a number is not finite.
    pub fn new(a: f64, b: f64, c: f64, d: f64) -> Result<Self> {
        let n = Vector3::new(a, b, c);
        let normal =
            n.unitized().ok_or(Error::degenerate("plane equation", "a, b and c give no direction"))?;
        let d = d / n.length();
        if d.is_finite() { Ok(Self { normal, d }) } else { Err(Error::NotFinite("plane equation")) }
    }

    /// The plane through a point with a normal: a(x − x₀) + b(y − y₀) + c(z − z₀) = 0.
    ///
    /// # Errors
    /// The normal has no direction, or a number is not finite.
    pub fn from_point_and_normal(p: Point3, normal: Vector3) -> Result<Self> {
        let n = normal.unitized().ok_or(Error::degenerate("normal", "it has no direction"))?;
        Self::new(n.x, n.y, n.z, -n.dot(p.to_vector()))
    }

    /// The plane through three points, its normal by the right-hand rule.
    ///
    /// # Errors
    /// The points lie on a line, or a number is not finite.
    pub fn from_points(a: Point3, b: Point3, c: Point3) -> Result<Self> {
        let plane = Plane::from_points(a, b, c)?;
        Self::from_point_and_normal(a, plane.z_axis)
    }

    /// The plane of four numbers that are to the last bit what they shall be; those not unit are made so.
    #[cfg(feature = "serde")]
    pub(crate) fn from_unit([a, b, c, d]: [f64; 4]) -> Result<Self> {
        let normal = Vector3::new(a, b, c);
        if (normal.length() - 1.0).abs() <= crate::thresholds::FEW_ROUNDINGS && d.is_finite() {
            return Ok(Self { normal, d });
        }
        Self::new(a, b, c, d)
    }

    /// The unit normal (a, b, c).
    pub const fn normal(&self) -> Vector3 {
        self.normal
    }

    /// The four numbers a, b, c, d.
    pub const fn coefficients(&self) -> [f64; 4] {
        [self.normal.x, self.normal.y, self.normal.z, self.d]
    }

    /// a·x + b·y + c·z + d: the distance of the point, positive on the side of the normal.
    #[inline]
    pub fn value_at(&self, p: Point3) -> f64 {
        self.normal.dot(p.to_vector()) + self.d
    }

    /// The point of the plane nearest to `p`.
    pub fn closest_point(&self, p: Point3) -> Point3 {
        p - self.normal * self.value_at(p)
    }

    /// The same plane seen from behind.
    #[must_use]
    pub fn flipped(&self) -> Self {
        Self { normal: -self.normal, d: -self.d }
    }

    /// The plane moved along its normal.
    #[must_use]
    pub fn offset(&self, distance: f64) -> Self {
        Self { normal: self.normal, d: self.d - distance }
    }

    /// A frame on the plane, with its origin nearest to the world's.
    ///
    /// # Errors
    /// A number overflows.
    pub fn to_plane(&self) -> Result<Plane> {
        Plane::from_normal((self.normal * -self.d).to_point(), self.normal)
    }
}

impl From<&Plane> for PlaneEquation {
    fn from(plane: &Plane) -> Self {
        Self { normal: plane.z_axis, d: -plane.z_axis.dot(plane.origin.to_vector()) }
    }
}
