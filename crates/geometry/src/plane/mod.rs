mod angles;
mod construct;
mod equation;

pub(crate) use construct::principal_axes;
pub use equation::PlaneEquation;

use katydid_elementary::Elementary;

use crate::thresholds;
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

    /// World XZ: x along world x, y along world z, so the normal is −y.
    pub const XZ: Self = Self {
        origin: Point3::ORIGIN,
        x_axis: Vector3::X,
        y_axis: Vector3::Z,
        z_axis: Vector3::new(0.0, -1.0, 0.0),
    };

    /// World YZ: x along world y, y along world z, the normal along world x.
    pub const YZ: Self =
        Self { origin: Point3::ORIGIN, x_axis: Vector3::Y, y_axis: Vector3::Z, z_axis: Vector3::X };

    /// The plane at `origin` with the given first axis and the second turned to be perpendicular to it.
    ///
    /// # Errors
    /// When an axis has no length or the two are parallel.
    pub fn from_axes(origin: Point3, x_axis: Vector3, y_axis: Vector3) -> Result<Self> {
        let x = x_axis.unitized().ok_or(Error::degenerate("x axis", "it has no length"))?;
        let y = y_axis.unitized().ok_or(Error::degenerate("y axis", "it has no length"))?;
        let z = x.cross(y);
        if z.length() < thresholds::NO_DIRECTION {
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

    /// The coefficients (a, b, c, d) of a·x + b·y + c·z + d = 0, with (a, b, c) the unit normal.
    pub fn equation(&self) -> [f64; 4] {
        let n = self.z_axis;
        [n.x, n.y, n.z, -n.dot(self.origin.to_vector())]
    }

    /// The distance of `p` from the plane: positive on the side the normal points to.
    #[inline]
    pub fn signed_distance(&self, p: Point3) -> f64 {
        (p - self.origin).dot(self.z_axis)
    }

    /// The point of the plane nearest to `p`.
    #[inline]
    pub fn closest_point(&self, p: Point3) -> Point3 {
        let [u, v, _] = self.coordinates(p);
        self.at(u, v, 0.0)
    }

    /// The same plane at another origin.
    #[must_use]
    pub fn with_origin(&self, origin: Point3) -> Self {
        Self { origin, ..*self }
    }

    /// The plane moved along its normal.
    #[must_use]
    pub fn offset(&self, distance: f64) -> Self {
        self.with_origin(self.origin + self.z_axis * distance)
    }

    /// The plane seen from behind: x and y change places and the normal turns round.
    #[must_use]
    pub fn flipped(&self) -> Self {
        Self { origin: self.origin, x_axis: self.y_axis, y_axis: self.x_axis, z_axis: -self.z_axis }
    }

    /// The plane turned about its own normal, counter-clockwise by `angle` radians.
    #[must_use]
    pub fn rotated(&self, angle: f64) -> Self {
        let (sin, cos) = angle.sine_cosine();
        Self {
            x_axis: self.x_axis * cos + self.y_axis * sin,
            y_axis: self.y_axis * cos - self.x_axis * sin,
            ..*self
        }
    }

    /// Whether all numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.origin.is_finite()
            && self.x_axis.is_finite()
            && self.y_axis.is_finite()
            && self.z_axis.is_finite()
    }
}
