//! Elimination: rank, solutions, orthogonality.

use super::Matrix;
use crate::{Error, Result};

/// A matrix in row echelon form and what elimination found on the way.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RowReduction {
    /// The reduced matrix: each row starts with a 1 right of the row above's, with zeros below it.
    pub reduced: Matrix,
    /// The right-hand side under the same row operations, when one was given.
    pub right: Option<Matrix>,
    /// The number of rows that are not zero.
    pub rank: usize,
    /// The determinant, 0 unless the matrix is square and of full rank.
    pub determinant: f64,
    /// The smallest pivot used, in size; 0 when there was none.
    pub pivot: f64,
}

impl Matrix {
    /// The sum of two matrices of the same size.
    ///
    /// # Errors
    /// The sizes differ.
    pub fn sum(&self, other: &Self) -> Result<Self> {
        if (self.rows, self.columns) != (other.rows, other.columns) {
            return Err(Error::Invalid {
                what: "matrix sum",
                why: format!(
                    "[{}×{}] + [{}×{}]: the sizes must be the same",
                    self.rows, self.columns, other.rows, other.columns
                ),
            });
        }
        let values = self.values.iter().zip(&other.values).map(|(a, b)| a + b).collect();
        Self::new(self.rows, self.columns, values)
    }

    /// All entries multiplied by a number.
    ///
    /// # Errors
    /// A product is not finite.
    pub fn scaled(&self, factor: f64) -> Result<Self> {
        Self::new(self.rows, self.columns, self.values.iter().map(|x| x * factor).collect())
    }

    /// The entries of a row; `None` when there is no such row.
    pub fn row(&self, i: usize) -> Option<&[f64]> {
        self.values.chunks_exact(self.columns).nth(i)
    }

    /// Gaussian elimination with row pivoting, on the right-hand side too when one is given. Pivots of a size not
    /// above `tolerance` count as 0.
    ///
    /// # Errors
    /// The right-hand side has another number of rows.
    pub fn row_reduced(&self, right: Option<&Self>, tolerance: f64) -> Result<RowReduction> {
        if let Some(b) = right
            && b.rows != self.rows
        {
            return Err(Error::Invalid {
                what: "right-hand side",
                why: format!("it has {} rows and the matrix {}", b.rows, self.rows),
            });
        }
        let (mut a, mut b) = (self.clone(), right.cloned());
        let (mut rank, mut determinant, mut smallest) = (0, 1.0, f64::INFINITY);
        for column in 0..self.columns {
            if rank == self.rows {
                break;
            }
            let entry = |a: &Self, i: usize| a.values[i * a.columns + column];
            let Some(best) =
                (rank..self.rows).max_by(|&i, &j| entry(&a, i).abs().total_cmp(&entry(&a, j).abs()))
            else {
                break;
            };
            let p = entry(&a, best);
            if !(p.abs() > tolerance.max(0.0)) {
                determinant = 0.0;
                continue;
            }
            if best != rank {
                determinant = -determinant;
                a.swap_rows(best, rank);
                if let Some(b) = &mut b {
                    b.swap_rows(best, rank);
                }
            }
            determinant *= p;
            smallest = smallest.min(p.abs());
            a.scale_row(rank, 1.0 / p);
            a.values[rank * a.columns + column] = 1.0;
            if let Some(b) = &mut b {
                b.scale_row(rank, 1.0 / p);
            }
            for i in rank + 1..self.rows {
                let f = entry(&a, i);
                if f != 0.0 {
                    a.add_row(rank, i, -f);
                    a.values[i * a.columns + column] = 0.0;
                    if let Some(b) = &mut b {
                        b.add_row(rank, i, -f);
                    }
                }
            }
            rank += 1;
        }
        let square = self.rows == self.columns && rank == self.rows;
        Ok(RowReduction {
            reduced: a,
            right: b,
            rank,
            determinant: if square { determinant } else { 0.0 },
            pivot: if smallest.is_finite() { smallest } else { 0.0 },
        })
    }

    /// The rank: rows left by elimination with pivots above `tolerance`.
    pub fn rank(&self, tolerance: f64) -> usize {
        self.row_reduced(None, tolerance).map_or(0, |r| r.rank)
    }

    /// A solution X of A·X = B: free unknowns are 0. `None` when there is none, that is when a row without pivot has a
    /// right-hand side above `tolerance`.
    ///
    /// # Errors
    /// The right-hand side has another number of rows, or a number of the solution is not finite.
    pub fn solve(&self, right: &Self, tolerance: f64) -> Result<Option<Self>> {
        let reduction = self.row_reduced(Some(right), tolerance)?;
        reduction.back_solved(tolerance)
    }

    fn swap_rows(&mut self, i: usize, j: usize) {
        for c in 0..self.columns {
            self.values.swap(i * self.columns + c, j * self.columns + c);
        }
    }

    fn scale_row(&mut self, i: usize, factor: f64) {
        for x in &mut self.values[i * self.columns..(i + 1) * self.columns] {
            *x *= factor;
        }
    }

    fn add_row(&mut self, from: usize, to: usize, factor: f64) {
        for c in 0..self.columns {
            self.values[to * self.columns + c] += factor * self.values[from * self.columns + c];
        }
    }

    /// Whether different rows are at right angles within `tolerance`.
    pub fn is_row_orthogonal(&self, tolerance: f64) -> bool {
        self.row_products().all(|(i, j, x)| i == j || x.abs() <= tolerance)
    }

    /// Whether rows are at right angles and of length 1 within `tolerance`.
    pub fn is_row_orthonormal(&self, tolerance: f64) -> bool {
        self.row_products().all(|(i, j, x)| (x - f64::from(u8::from(i == j))).abs() <= tolerance)
    }

    /// Whether different columns are at right angles within `tolerance`.
    pub fn is_column_orthogonal(&self, tolerance: f64) -> bool {
        self.transposed().is_row_orthogonal(tolerance)
    }

    /// Whether columns are at right angles and of length 1 within `tolerance`.
    pub fn is_column_orthonormal(&self, tolerance: f64) -> bool {
        self.transposed().is_row_orthonormal(tolerance)
    }

    fn row_products(&self) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
        let rows = || self.values.chunks_exact(self.columns).enumerate();
        rows().flat_map(move |(i, a)| {
            rows().take(i + 1).map(move |(j, b)| (i, j, a.iter().zip(b).map(|(x, y)| x * y).sum()))
        })
    }
}

impl RowReduction {
    /// The solution by substitution from the last row up, as [`Matrix::solve`].
    ///
    /// # Errors
    /// There was no right-hand side, or a number of the solution is not finite.
    pub fn back_solved(&self, tolerance: f64) -> Result<Option<Matrix>> {
        let Some(b) = &self.right else {
            return Err(Error::degenerate("row reduction", "it was made without a right-hand side"));
        };
        let (a, width) = (&self.reduced, b.columns);
        let rest = b.values.get(self.rank * width..).unwrap_or(&[]);
        if rest.iter().any(|x| x.abs() > tolerance) {
            return Ok(None);
        }
        let mut x = vec![0.0; a.columns * width];
        for i in (0..self.rank).rev() {
            let row = &a.values[i * a.columns..(i + 1) * a.columns];
            let Some(lead) = row.iter().position(|&v| v != 0.0) else { continue };
            for k in 0..width {
                let known: f64 = (lead + 1..a.columns).map(|j| row[j] * x[j * width + k]).sum();
                x[lead * width + k] = b.values[i * width + k] - known;
            }
        }
        Matrix::new(a.columns, width, x).map(Some)
    }
}

#[cfg(test)]
mod tests {
    use crate::Matrix;

    #[test]
    fn rank_determinant_and_solution() {
        let m = Matrix::new(3, 3, vec![0.0, 2.0, 1.0, 3.0, 0.0, 1.0, 1.0, 1.0, 0.0]).unwrap();
        let b = Matrix::new(3, 1, vec![7.0, 6.0, 3.0]).unwrap();
        let r = m.row_reduced(Some(&b), 0.0).unwrap();
        assert!((r.determinant - 5.0).abs() < 1e-14 && r.rank == 3);
        let x = m.solve(&b, 0.0).unwrap().unwrap();
        let back = m.product(&x).unwrap();
        assert!(back.values().iter().zip(b.values()).all(|(a, b)| (a - b).abs() < 1e-14));
        // One equation too few leaves a free unknown, a contradiction no solution.
        let wide = Matrix::new(2, 3, vec![1.0, 2.0, 3.0, 2.0, 4.0, 6.0]).unwrap();
        assert_eq!(wide.rank(1e-12), 1);
        let fits = Matrix::new(2, 1, vec![1.0, 2.0]).unwrap();
        let x = wide.solve(&fits, 1e-12).unwrap().unwrap();
        assert_eq!(wide.product(&x).unwrap(), fits);
        assert_eq!(wide.solve(&Matrix::new(2, 1, vec![1.0, 3.0]).unwrap(), 1e-12).unwrap(), None);
        assert!(wide.solve(&b, 0.0).is_err());
    }

    #[test]
    fn orthogonality() {
        let turn = Matrix::new(2, 2, vec![0.6, -0.8, 0.8, 0.6]).unwrap();
        assert!(turn.is_row_orthonormal(1e-15) && turn.is_column_orthonormal(1e-15));
        let scaled = turn.scaled(2.0).unwrap();
        assert!(scaled.is_row_orthogonal(1e-15) && !scaled.is_row_orthonormal(1e-15));
        assert!(!Matrix::new(1, 2, vec![1.0, 1.0]).unwrap().is_column_orthogonal(1e-15));
        assert_eq!(turn.sum(&turn).unwrap(), scaled);
        assert_eq!(turn.row(1), Some([0.8, 0.6].as_slice()));
    }
}
