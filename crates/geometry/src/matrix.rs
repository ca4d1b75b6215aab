mod solve;

pub use solve::RowReduction;

use crate::{Error, Result};

/// A pivot that is no larger is rounding, whatever the tolerance.
const LEAST_PIVOT: f64 = 1e-15;

/// More entries than this are refused.
const MOST: usize = 1 << 26;

/// A matrix of any size, row by row.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix {
    rows: usize,
    columns: usize,
    values: Vec<f64>,
}

impl Default for Matrix {
    /// The 1 × 1 identity.
    fn default() -> Self {
        Self { rows: 1, columns: 1, values: vec![1.0] }
    }
}

impl Matrix {
    /// The matrix with the given entries, row by row.
    ///
    /// # Errors
    /// No rows or columns, another count of entries than rows × columns, or an entry that is not finite.
    pub fn new(rows: usize, columns: usize, values: Vec<f64>) -> Result<Self> {
        let wanted = Self::size(rows, columns)?;
        if values.len() != wanted {
            return Err(Error::Invalid {
                what: "matrix",
                why: format!("{rows} rows and {columns} columns need {wanted} entries, got {}", values.len()),
            });
        }
        if !values.iter().all(|x| x.is_finite()) {
            return Err(Error::NotFinite("matrix entry"));
        }
        Ok(Self { rows, columns, values })
    }

    /// The matrix of zeros.
    ///
    /// # Errors
    /// No rows or columns, or more than 2²⁶ entries.
    pub fn zeros(rows: usize, columns: usize) -> Result<Self> {
        Ok(Self { rows, columns, values: vec![0.0; Self::size(rows, columns)?] })
    }

    /// The matrix with ones on its main diagonal; it need not be square.
    ///
    /// # Errors
    /// As [`Matrix::zeros`].
    pub fn identity(rows: usize, columns: usize) -> Result<Self> {
        let mut m = Self::zeros(rows, columns)?;
        for i in 0..rows.min(columns) {
            m.values[i * columns + i] = 1.0;
        }
        Ok(m)
    }

    fn size(rows: usize, columns: usize) -> Result<usize> {
        match rows.checked_mul(columns) {
            Some(size) if size > 0 && size <= MOST => Ok(size),
            _ => Err(Error::Invalid {
                what: "matrix",
                why: format!("{rows} rows and {columns} columns are not between 1 and {MOST} entries"),
            }),
        }
    }

    /// The number of rows.
    #[inline]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The number of columns.
    #[inline]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// All entries, row by row.
    #[inline]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The entry at a row and column, both from 0; `None` outside.
    pub fn get(&self, row: usize, column: usize) -> Option<f64> {
        (row < self.rows && column < self.columns).then(|| self.values[row * self.columns + column])
    }

    /// Sets an entry.
    ///
    /// # Errors
    /// The place is outside the matrix, or the value not finite.
    pub fn set(&mut self, row: usize, column: usize, value: f64) -> Result<()> {
        if !value.is_finite() {
            return Err(Error::NotFinite("matrix entry"));
        }
        if row >= self.rows || column >= self.columns {
            return Err(Error::Invalid {
                what: "matrix index",
                why: format!("({row}, {column}) is outside {} × {}", self.rows, self.columns),
            });
        }
        self.values[row * self.columns + column] = value;
        Ok(())
    }

    /// The matrix product: this one has as many columns as `other` has rows; the result has this one's rows and the
    /// other's columns.
    ///
    /// # Errors
    /// The sizes do not match.
    pub fn product(&self, other: &Self) -> Result<Self> {
        if self.columns != other.rows {
            return Err(Error::Invalid {
                what: "matrix product",
                why: format!(
                    "[{}×{}] · [{}×{}]: the columns of the first must match the rows of the second",
                    self.rows, self.columns, other.rows, other.columns
                ),
            });
        }
        let mut out = Self::zeros(self.rows, other.columns)?;
        for i in 0..self.rows {
            for k in 0..self.columns {
                let a = self.values[i * self.columns + k];
                for j in 0..other.columns {
                    out.values[i * other.columns + j] += a * other.values[k * other.columns + j];
                }
            }
        }
        Ok(out)
    }

    /// Rows and columns exchanged.
    #[must_use]
    pub fn transposed(&self) -> Self {
        let values = (0..self.columns)
            .flat_map(|j| (0..self.rows).map(move |i| (i, j)))
            .map(|(i, j)| self.values[i * self.columns + j])
            .collect();
        Self { rows: self.columns, columns: self.rows, values }
    }

    /// The matrix with two rows exchanged; `None` when there is no such row.
    pub fn with_rows_swapped(&self, a: usize, b: usize) -> Option<Self> {
        if a >= self.rows || b >= self.rows {
            return None;
        }
        let mut out = self.clone();
        for j in 0..self.columns {
            out.values.swap(a * self.columns + j, b * self.columns + j);
        }
        Some(out)
    }

    /// The matrix with two columns exchanged; `None` when there is no such column.
    pub fn with_columns_swapped(&self, a: usize, b: usize) -> Option<Self> {
        Some(self.transposed().with_rows_swapped(a, b)?.transposed())
    }

    /// The determinant of a square matrix, by elimination with row pivoting.
    ///
    /// # Errors
    /// The matrix is not square.
    pub fn determinant(&self) -> Result<f64> {
        let n = self.square("determinant")?;
        let mut a = self.values.clone();
        let mut determinant = 1.0;
        for k in 0..n {
            let Some(pivot) = (k..n).max_by(|&i, &j| a[i * n + k].abs().total_cmp(&a[j * n + k].abs()))
            else {
                break;
            };
            if pivot != k {
                determinant = -determinant;
                for j in 0..n {
                    a.swap(k * n + j, pivot * n + j);
                }
            }
            let p = a[k * n + k];
            determinant *= p;
            if p == 0.0 {
                return Ok(0.0);
            }
            for i in k + 1..n {
                let f = a[i * n + k] / p;
                for j in k..n {
                    a[i * n + j] -= f * a[k * n + j];
                }
            }
        }
        Ok(determinant)
    }

    /// The inverse of a square matrix by Gauss–Jordan elimination; `None` when a pivot is not above `tolerance` times
    /// the largest entry of its row.
    ///
    /// # Errors
    /// The matrix is not square.
    pub fn inverse(&self, tolerance: f64) -> Result<Option<Self>> {
        let n = self.square("inverse")?;
        let mut a = self.values.clone();
        let mut b = Self::identity(n, n)?.values;
        for i in 0..n {
            let largest = a[i * n..(i + 1) * n].iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            if !(largest > f64::MIN_POSITIVE) {
                return Ok(None);
            }
            for j in 0..n {
                a[i * n + j] /= largest;
                b[i * n + j] /= largest;
            }
        }
        for k in 0..n {
            let Some(pivot) = (k..n).max_by(|&i, &j| a[i * n + k].abs().total_cmp(&a[j * n + k].abs()))
            else {
                break;
            };
            for j in 0..n {
                a.swap(k * n + j, pivot * n + j);
                b.swap(k * n + j, pivot * n + j);
            }
            let p = a[k * n + k];
            if !(p.abs() > tolerance.max(LEAST_PIVOT)) {
                return Ok(None);
            }
            for j in 0..n {
                a[k * n + j] /= p;
                b[k * n + j] /= p;
            }
            for i in (0..n).filter(|&i| i != k) {
                let f = a[i * n + k];
                if f != 0.0 {
                    for j in 0..n {
                        a[i * n + j] -= f * a[k * n + j];
                        b[i * n + j] -= f * b[k * n + j];
                    }
                }
            }
        }
        Ok(b.iter().all(|x| x.is_finite()).then_some(Self { rows: n, columns: n, values: b }))
    }

    fn square(&self, what: &'static str) -> Result<usize> {
        if self.rows == self.columns {
            return Ok(self.rows);
        }
        Err(Error::Invalid {
            what,
            why: format!("a matrix of {} rows and {} columns is not square", self.rows, self.columns),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Matrix;

    fn filled(rows: usize, columns: usize) -> Matrix {
        let values = (0..rows * columns).map(|i| ((i * 7 + 3) % 11) as f64 - 4.0).collect();
        Matrix::new(rows, columns, values).unwrap()
    }

    #[test]
    fn m1_sizes_of_products() {
        let size = |m: &Matrix| (m.rows(), m.columns());
        assert_eq!(size(&filled(2, 4).product(&filled(4, 3)).unwrap()), (2, 3));
        assert_eq!(size(&filled(2, 4).product(&filled(4, 5)).unwrap()), (2, 5));
        let error = filled(2, 4).product(&filled(3, 4)).unwrap_err().to_string();
        assert!(error.contains("[2×4] · [3×4]"), "{error}");
        let v = Matrix::new(4, 1, vec![2.0, 3.0, 1.0, 1.0]).unwrap();
        assert_eq!(Matrix::identity(4, 4).unwrap().product(&v).unwrap(), v);
    }

    #[test]
    fn inverse_and_determinant() {
        let m = Matrix::new(3, 3, vec![0.0, 2.0, 1.0, 3.0, 0.0, 1.0, 1.0, 1.0, 0.0]).unwrap();
        assert!((m.determinant().unwrap() - 5.0).abs() < 1e-14);
        let product = m.product(&m.inverse(1e-12).unwrap().unwrap()).unwrap();
        for (a, b) in product.values().iter().zip(Matrix::identity(3, 3).unwrap().values()) {
            assert!((a - b).abs() < 1e-15);
        }
        let singular = Matrix::new(2, 2, vec![1.0, 2.0, 2.0, 4.0]).unwrap();
        assert_eq!(singular.inverse(1e-12).unwrap(), None);
        assert_eq!(singular.determinant().unwrap(), 0.0);
        assert!(filled(2, 3).determinant().is_err() && filled(2, 3).inverse(0.0).is_err());
    }

    #[test]
    fn transposing_and_swapping() {
        let m = filled(3, 5);
        assert_eq!(m.transposed().transposed(), m);
        assert_eq!(m.transposed().get(4, 2), m.get(2, 4));
        assert_eq!(m.with_rows_swapped(0, 2).unwrap().get(0, 1), m.get(2, 1));
        assert_eq!(m.with_columns_swapped(0, 4).unwrap().get(1, 0), m.get(1, 4));
        assert_eq!((m.with_rows_swapped(0, 3), m.get(3, 0)), (None, None));
    }

    #[test]
    fn impossible_sizes() {
        assert!(Matrix::zeros(0, 3).is_err());
        assert!(Matrix::zeros(usize::MAX, 2).is_err());
        assert!(Matrix::zeros(1 << 20, 1 << 20).is_err());
        assert!(Matrix::new(1, 1, vec![f64::NAN]).is_err());
        assert!(filled(2, 2).set(2, 0, 1.0).is_err());
    }
}
