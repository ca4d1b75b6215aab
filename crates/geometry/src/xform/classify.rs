//! What kind of map a matrix is.

use crate::Xform;

impl Xform {
    /// Whether no entry differs from the identity's by more than `tolerance`.
    pub fn is_identity(&self, tolerance: f64) -> bool {
        let pairs = self.rows.iter().flatten().zip(Self::IDENTITY.rows.iter().flatten());
        pairs.into_iter().all(|(a, b)| (a - b).abs() <= tolerance)
    }

    /// Whether the last row is exactly (0, 0, 0, 1): parallel lines stay parallel.
    #[inline]
    pub fn is_affine(&self) -> bool {
        self.rows[3] == [0.0, 0.0, 0.0, 1.0]
    }

    /// The factor by which every length grows, negative when the map mirrors; `None` when angles do not survive.
    ///
    /// `tolerance` bounds how far the linear part, divided by the factor, may be from orthonormal.
    pub fn similarity_factor(&self, tolerance: f64) -> Option<f64> {
        if !self.is_affine() {
            return None;
        }
        let column = |j: usize| crate::Vector3::new(self.rows[0][j], self.rows[1][j], self.rows[2][j]);
        let columns = [column(0), column(1), column(2)];
        let mean = (columns.iter().map(|c| c.length_squared()).sum::<f64>() / 3.0).sqrt();
        if !(mean > f64::MIN_POSITIVE && mean.is_finite()) {
            return None;
        }
        let unit = columns.map(|c| c / mean);
        for i in 0..3 {
            for j in i..3 {
                let wanted = if i == j { 1.0 } else { 0.0 };
                if (unit[i].dot(unit[j]) - wanted).abs() > tolerance {
                    return None;
                }
            }
        }
        Some(mean.copysign(unit[0].dot(unit[1].cross(unit[2]))))
    }

    /// Whether shapes keep their angles: rotations, mirrors, moves, uniform scales and their products.
    pub fn is_similarity(&self, tolerance: f64) -> bool {
        self.similarity_factor(tolerance).is_some()
    }

    /// Whether shapes keep their size and are not mirrored: rotations, moves and their products.
    pub fn is_rigid(&self, tolerance: f64) -> bool {
        self.similarity_factor(tolerance).is_some_and(|f| (f - 1.0).abs() <= tolerance)
    }

    /// 1 for a map that keeps sizes, −1 for one that keeps sizes and mirrors, else 0.
    pub fn rigid_type(&self, tolerance: f64) -> i8 {
        match self.similarity_factor(tolerance) {
            Some(f) if (f - 1.0).abs() <= tolerance => 1,
            Some(f) if (f + 1.0).abs() <= tolerance => -1,
            _ => 0,
        }
    }

    /// 1 for a map that keeps angles, −1 for one that keeps angles and mirrors, else 0.
    pub fn similarity_type(&self, tolerance: f64) -> i8 {
        match self.similarity_factor(tolerance) {
            Some(f) if f > 0.0 => 1,
            Some(_) => -1,
            None => 0,
        }
    }

    /// Whether the map is affine and leaves the origin where it is.
    pub fn is_linear(&self) -> bool {
        self.is_affine() && (0..3).all(|i| self.rows[i][3] == 0.0)
    }

    /// Whether the map is a rotation about an axis through the origin, the identity among them.
    pub fn is_rotation(&self, tolerance: f64) -> bool {
        self.is_linear() && self.is_rigid(tolerance)
    }

    /// Whether the map is affine and moves without turning or scaling; the identity is one.
    pub fn is_translation(&self, tolerance: f64) -> bool {
        let linear =
            (0..3).all(|i| (0..3).all(|j| (self.rows[i][j] - Self::IDENTITY.rows[i][j]).abs() <= tolerance));
        self.is_affine() && linear
    }

    /// Whether all entries are 0.
    pub fn is_zero(&self) -> bool {
        self.rows.iter().flatten().all(|&x| x == 0.0)
    }

    /// Whether all entries are finite.
    pub fn is_finite(&self) -> bool {
        self.rows.iter().flatten().all(|x| x.is_finite())
    }
}
