//! Angles, projections and rotations of vectors.

use katydid_elementary::Elementary;

use crate::Vector3;

impl Vector3 {
    /// The angle to `other` in radians, 0…π; `None` when one of them has no direction.
    ///
    /// By atan2(|a×b|, a·b), which keeps its digits for nearly parallel vectors where the arc cosine of the dot
    /// product loses half of them.
    pub fn angle_to(self, other: Self) -> Option<f64> {
        let (a, b) = (self.unitized()?, other.unitized()?);
        Some(a.cross(b).length().arctangent_of(a.dot(b)))
    }

    /// The part of this vector along `direction`; `None` when `direction` has none.
    pub fn projected_onto(self, direction: Self) -> Option<Self> {
        let d = direction.unitized()?;
        Some(d * self.dot(d))
    }

    /// The part of this vector at right angles to `direction`; `None` when `direction` has none.
    pub fn rejected_from(self, direction: Self) -> Option<Self> {
        Some(self - self.projected_onto(direction)?)
    }

    /// A unit vector at right angles to this one, chosen as openNURBS does (`ON_3dVector::PerpendicularTo`): of the
    /// two components largest in size, swapped, the former second one is negated, and the third becomes 0. So z
    /// gives x. `None` for a vector without direction.
    pub fn perpendicular(self) -> Option<Self> {
        let n = self.unitized()?;
        let (x, y, z) = (n.x.abs(), n.y.abs(), n.z.abs());
        // i has the largest component and j the second; ties as openNURBS breaks them.
        let (i, j) = if y > x {
            if z > y {
                (2, 1)
            } else if z >= x {
                (1, 2)
            } else {
                (1, 0)
            }
        } else if z > x {
            (2, 0)
        } else if z > y {
            (0, 2)
        } else {
            (0, 1)
        };
        let from = [n.x, n.y, n.z];
        let mut to = [0.0; 3];
        to[i] = -from[j];
        to[j] = from[i];
        Self::from(to).unitized()
    }

    /// This vector turned by `angle` radians about `axis` by the right-hand rule (Rodrigues' formula); `None` when
    /// the axis has no direction.
    pub fn rotated(self, angle: f64, axis: Self) -> Option<Self> {
        let k = axis.unitized()?;
        let (sin, cos) = angle.sine_cosine();
        Some(self * cos + k.cross(self) * sin + k * (k.dot(self) * (1.0 - cos)))
    }

    /// 1 when `other` points the same way within `angle` radians, −1 when it points the opposite way, else 0; 0 too
    /// when one of them has no direction.
    pub fn parallel_to(self, other: Self, angle: f64) -> i8 {
        match self.angle_to(other) {
            Some(a) if a <= angle => 1,
            Some(a) if std::f64::consts::PI - a <= angle => -1,
            _ => 0,
        }
    }

    /// This vector between itself (t = 0) and `other` (t = 1), by components.
    #[inline]
    pub fn lerp(self, other: Self, t: f64) -> Self {
        self * (1.0 - t) + other * t
    }

    /// This vector with another length; a negative one reverses it. `None` for a vector without direction.
    pub fn with_length(self, length: f64) -> Option<Self> {
        Some(self.unitized()? * length)
    }
}

impl std::iter::Sum for Vector3 {
    fn sum<I: Iterator<Item = Self>>(vectors: I) -> Self {
        vectors.fold(Self::ZERO, |a, b| a + b)
    }
}
