//! Inverse, determinant and transpose.

use crate::Xform;
use crate::xform::thresholds::NO_INVERSE;

impl Xform {
    /// The matrix with rows and columns exchanged.
    #[must_use]
    pub fn transposed(&self) -> Self {
        let r = &self.rows;
        Self { rows: std::array::from_fn(|i| std::array::from_fn(|j| r[j][i])) }
    }

    /// The determinant of the 4×4 matrix; for an affine map the factor by which volumes grow, negative when it
    /// mirrors.
    pub fn determinant(&self) -> f64 {
        let r = &self.rows;
        if self.is_affine() {
            return determinant3(r, [0, 1, 2], [0, 1, 2]);
        }
        let minor = |j: usize| {
            let columns = match j {
                0 => [1, 2, 3],
                1 => [0, 2, 3],
                2 => [0, 1, 3],
                _ => [0, 1, 2],
            };
            determinant3(r, [0, 1, 2], columns)
        };
        -r[3][0] * minor(0) + r[3][1] * minor(1) - r[3][2] * minor(2) + r[3][3] * minor(3)
    }

    /// The inverse; `None` when there is none.
    ///
    /// Singular means that the determinant is below 10⁻¹⁵ of what the lengths of the rows allow (Hadamard's bound),
    /// so a scale by a tiny factor is not mistaken for a projection.
    pub fn inverse(&self) -> Option<Self> {
        let r = &self.rows;
        if !r.iter().flatten().all(|x| x.is_finite()) {
            return None;
        }
        if self.is_affine() { self.inverse_affine() } else { self.inverse_general() }
    }

    fn inverse_affine(&self) -> Option<Self> {
        let r = &self.rows;
        // Each row scaled to length 1, so that neither overflow nor units matter.
        let mut unit = [[0.0; 3]; 3];
        let mut scale = [0.0; 3];
        for i in 0..3 {
            let row = crate::Vector3::new(r[i][0], r[i][1], r[i][2]);
            scale[i] = row.length();
            unit[i] = row.unitized()?.into();
        }
        let [a, b, c] = unit.map(crate::Vector3::from);
        let determinant = a.dot(b.cross(c));
        if !(determinant.abs() > NO_INVERSE) {
            return None;
        }
        // The columns of the inverse of rows a, b, c are b×c, c×a, a×b over the determinant.
        let columns = [b.cross(c), c.cross(a), a.cross(b)];
        let [x, y, z] = std::array::from_fn(|i| columns[i] / determinant / scale[i]);
        let mut m = Self::from_columns(x, y, z, crate::Point3::ORIGIN);
        let t = m.vector(crate::Vector3::new(r[0][3], r[1][3], r[2][3]));
        m.rows[0][3] = -t.x;
        m.rows[1][3] = -t.y;
        m.rows[2][3] = -t.z;
        m.rows.iter().flatten().all(|x| x.is_finite()).then_some(m)
    }

    /// Gauss–Jordan elimination with row pivoting on rows scaled to their largest entry.
    fn inverse_general(&self) -> Option<Self> {
        let mut a = self.rows;
        let mut b = Self::IDENTITY.rows;
        for i in 0..4 {
            let largest = a[i].iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            if !(largest > f64::MIN_POSITIVE) {
                return None;
            }
            for j in 0..4 {
                a[i][j] /= largest;
                b[i][j] /= largest;
            }
        }
        for k in 0..4 {
            let pivot = (k..4).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
            a.swap(k, pivot);
            b.swap(k, pivot);
            let p = a[k][k];
            if !(p.abs() > NO_INVERSE) {
                return None;
            }
            for j in 0..4 {
                a[k][j] /= p;
                b[k][j] /= p;
            }
            for i in 0..4 {
                let f = a[i][k];
                if i == k || f == 0.0 {
                    continue;
                }
                for j in 0..4 {
                    a[i][j] -= f * a[k][j];
                    b[i][j] -= f * b[k][j];
                }
            }
        }
        b.iter().flatten().all(|x| x.is_finite()).then_some(Self { rows: b })
    }
}

fn determinant3(m: &[[f64; 4]; 4], rows: [usize; 3], columns: [usize; 3]) -> f64 {
    let at = |i: usize, j: usize| m[rows[i]][columns[j]];
    at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1))
        - at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0))
        + at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0))
}
