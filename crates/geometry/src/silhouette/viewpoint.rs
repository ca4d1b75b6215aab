//! From where something is seen.

use crate::{Error, Point3, Result, Vector3};

/// From where something is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Viewpoint {
    /// From far away along a direction, into which the viewer looks.
    Parallel(Vector3),
    /// From a point.
    Perspective(Point3),
}

impl Viewpoint {
    /// The viewpoint with a unit direction.
    ///
    /// # Errors
    /// It is not finite, or its direction has no length.
    pub fn checked(self) -> Result<Self> {
        match self {
            Self::Parallel(d) if !d.is_finite() => Err(Error::NotFinite("view direction")),
            Self::Parallel(d) => {
                let unit = d.unitized().ok_or(Error::degenerate("view direction", "it has no length"))?;
                Ok(Self::Parallel(unit))
            }
            Self::Perspective(p) if !p.is_finite() => Err(Error::NotFinite("camera")),
            Self::Perspective(_) => Ok(self),
        }
    }

    /// The vector from a point towards the viewer: to the eye itself, or a unit vector.
    pub fn towards(&self, p: Point3) -> Vector3 {
        match self {
            Self::Parallel(d) => -*d,
            Self::Perspective(eye) => *eye - p,
        }
    }

    /// The cosine between a normal and the line of sight to a point: positive where seen from the front.
    pub fn facing(&self, normal: Vector3, p: Point3) -> f64 {
        self.towards(p).unitized().map_or(0.0, |v| v.dot(normal))
    }
}
