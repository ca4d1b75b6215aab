//! Signed angles, averages and components.

use katydid_elementary::Elementary;

use crate::Vector3;
use crate::thresholds;

impl Vector3 {
    /// The angle in radians from this vector to `other`, −π…π, positive when the turn is counter-clockwise about
    /// `normal`, which need not be at right angles to them; `None` when one of the three has no direction.
    pub fn signed_angle_to(self, other: Self, normal: Self) -> Option<f64> {
        let angle = self.angle_to(other)?;
        let side = self.unitized()?.cross(other.unitized()?).dot(normal.unitized()?);
        Some(if side < 0.0 { -angle } else { angle })
    }

    /// The mean of several vectors. With `unitize` each counts by its direction alone, so that long ones do not pull
    /// the average towards them. `None` for none, or when a vector to unitise has no direction.
    pub fn average(vectors: &[Self], unitize: bool) -> Option<Self> {
        if vectors.is_empty() {
            return None;
        }
        let mut sum = Self::ZERO;
        for v in vectors {
            sum += if unitize { v.unitized()? } else { *v };
        }
        Some(sum / vectors.len() as f64)
    }

    /// The unit vector in the direction of the average; `None` when there is none.
    pub fn average_direction(vectors: &[Self], unitize: bool) -> Option<Self> {
        Self::average(vectors, unitize)?.unitized()
    }

    /// a·(b×c): the volume of the parallelepiped, positive for a right-handed triple.
    #[inline]
    pub fn triple_product(self, b: Self, c: Self) -> f64 {
        self.dot(b.cross(c))
    }

    /// Whether the vectors meet at a right angle within `angle` radians; never for one without direction.
    pub fn is_perpendicular_to(self, other: Self, angle: f64) -> bool {
        match (self.unitized(), other.unitized()) {
            (Some(a), Some(b)) => a.dot(b).abs() <= angle.sine(),
            _ => false,
        }
    }

    /// The coefficients (a, b, c) with a·x + b·y + c·z this vector, for three directions that need not be unit or at
    /// right angles; `None` when they lie in a plane.
    pub fn components_along(self, x: Self, y: Self, z: Self) -> Option<[f64; 3]> {
        let (u, v, w) = (x.unitized()?, y.unitized()?, z.unitized()?);
        let volume = u.triple_product(v, w);
        if !(volume.abs() > thresholds::FEW_ROUNDINGS) {
            return None;
        }
        let by = |a: Self, b: Self, length: f64| self.dot(a.cross(b)) / volume / length;
        Some([by(v, w, x.length()), by(w, u, y.length()), by(u, v, z.length())])
    }

    /// This vector reflected at a plane through the origin with the given normal; `None` when that has no direction.
    pub fn mirrored(self, normal: Self) -> Option<Self> {
        let n = normal.unitized()?;
        Some(self - n * (2.0 * self.dot(n)))
    }

    /// Whether `v` agrees with this vector in every component within `tolerance`.
    pub fn is_near(self, v: Self, tolerance: f64) -> bool {
        (self.x - v.x).abs() <= tolerance
            && (self.y - v.y).abs() <= tolerance
            && (self.z - v.z).abs() <= tolerance
    }
}
