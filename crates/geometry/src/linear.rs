//! Small dense linear algebra that several files share.

/// Eigenvalues, ascending, and unit eigenvectors of a symmetric 3×3 matrix by cyclic Jacobi rotations
/// (Golub & Van Loan, *Matrix Computations*, §8.5).
pub(crate) fn symmetric_eigen(mut a: [[f64; 3]; 3]) -> ([f64; 3], [[f64; 3]; 3]) {
    let mut v = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for _ in 0..64 {
        let off = a[0][1].abs() + a[0][2].abs() + a[1][2].abs();
        if off == 0.0 || !off.is_finite() {
            break;
        }
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
            let c = 1.0 / (t * t + 1.0).sqrt();
            let s = t * c;
            for row in &mut a {
                (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
            }
            for k in 0..3 {
                (a[p][k], a[q][k]) = (c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]);
            }
            for row in &mut v {
                (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
            }
        }
    }
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| a[i][i].total_cmp(&a[j][j]));
    let values = order.map(|i| a[i][i]);
    let vectors = order.map(|i| [v[0][i], v[1][i], v[2][i]]);
    (values, vectors)
}

/// A banded system of linear equations for points in space.
pub(crate) struct Banded {
    half: usize,
    /// Row i holds columns i − half … i + 2·half: the right third fills when rows are exchanged.
    rows: Vec<Vec<f64>>,
    right: Vec<[f64; 3]>,
}

impl Banded {
    /// The system with as many rows as right-hand sides (`n` of them) and `half` entries beside the diagonal.
    pub(crate) fn new(n: usize, half: usize, right: Vec<[f64; 3]>) -> Self {
        Self { half, rows: vec![vec![0.0; 3 * half + 1]; n], right }
    }

    /// Adds to the entry at a row and column; outside the band nothing happens.
    pub(crate) fn add(&mut self, row: usize, column: usize, value: f64) {
        let place = (column + self.half).checked_sub(row);
        if let (Some(place), Some(entries)) = (place, self.rows.get_mut(row))
            && let Some(entry) = entries.get_mut(place)
        {
            *entry += value;
        }
    }

    /// Sets the right-hand side of a row.
    pub(crate) fn set_right(&mut self, row: usize, value: [f64; 3]) {
        if let Some(slot) = self.right.get_mut(row) {
            *slot = value;
        }
    }

    /// Gaussian elimination with partial pivoting inside the band; `None` when a pivot vanishes.
    pub(crate) fn solve(mut self) -> Option<Vec<[f64; 3]>> {
        let (n, half) = (self.rows.len(), self.half);
        if self.right.len() != n {
            return None;
        }
        // After step k, the entry of row i in column c stands at c + half − i.
        for k in 0..n {
            let last = n.min(k + half + 1);
            let pivot = (k..last).max_by(|&a, &b| {
                self.rows[a][half + k - a].abs().total_cmp(&self.rows[b][half + k - b].abs())
            })?;
            if pivot != k {
                // Column k + c of the pivot row stands c + half − (pivot − k) places in; move both rows.
                let shift = pivot - k;
                for c in 0..=2 * half {
                    let (high, low) = (half + c, half + c - shift);
                    let swapped = self.rows[pivot][low];
                    self.rows[pivot][low] = self.rows[k][high];
                    self.rows[k][high] = swapped;
                }
                self.right.swap(k, pivot);
            }
            let diagonal = self.rows[k][half];
            if !(diagonal.abs() > f64::MIN_POSITIVE && diagonal.is_finite()) {
                return None;
            }
            for i in k + 1..last {
                let factor = self.rows[i][half + k - i] / diagonal;
                if factor == 0.0 {
                    continue;
                }
                for c in 0..=2 * half {
                    let above = self.rows[k][half + c];
                    if above != 0.0 {
                        self.rows[i][half + c + k - i] -= factor * above;
                    }
                }
                for d in 0..3 {
                    self.right[i][d] -= factor * self.right[k][d];
                }
            }
        }
        for k in (0..n).rev() {
            for c in 1..=2 * half {
                let Some(&next) = self.right.get(k + c) else { break };
                let entry = self.rows[k][half + c];
                for d in 0..3 {
                    self.right[k][d] -= entry * next[d];
                }
            }
            for d in 0..3 {
                self.right[k][d] /= self.rows[k][half];
            }
        }
        Some(self.right)
    }
}
