//! Small dense linear algebra that several files share.

use crate::{Result, cancellation};

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

/// With more entries beside the diagonal a step of the elimination takes microseconds.
const WIDE: usize = 16;

/// A banded system of linear equations for points in space.
pub(crate) struct Banded {
    half: usize,
    /// Row i holds columns i − half … i + 2·half: the right third fills when rows are exchanged. The rows stand one
    /// after another.
    entries: Vec<f64>,
    right: Vec<[f64; 3]>,
}

impl Banded {
    /// The system with as many rows as right-hand sides (`n` of them) and `half` entries beside the diagonal.
    ///
    /// # Errors
    /// There is no memory for it, or nobody waits any more.
    pub(crate) fn new(n: usize, half: usize, right: Vec<[f64; 3]>) -> Result<Self> {
        let count = n.saturating_mul(3 * half + 1);
        cancellation::room::<f64>(count)?;
        Ok(Self { half, entries: vec![0.0; count], right })
    }

    /// Adds to the entry at a row and column; outside the band nothing happens.
    #[inline]
    pub(crate) fn add(&mut self, row: usize, column: usize, value: f64) {
        let width = 3 * self.half + 1;
        if let Some(place) = (column + self.half).checked_sub(row)
            && place < width
            && let Some(entry) = self.entries.get_mut(row * width + place)
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
    pub(crate) fn solve(self) -> Option<Vec<[f64; 3]>> {
        self.eliminate(true)
    }

    /// Gaussian elimination without exchanges, which is stable for the totally positive matrices of interpolation by
    /// B-splines (C. de Boor & A. Pinkus, *Backward error analysis for totally positive linear systems*, Numer. Math.
    /// 27, 1977); `None` when a pivot vanishes.
    pub(crate) fn solve_totally_positive(self) -> Option<Vec<[f64; 3]>> {
        self.eliminate(false)
    }

    fn eliminate(mut self, exchange: bool) -> Option<Vec<[f64; 3]>> {
        let (n, half, width) = (self.right.len(), self.half, 3 * self.half + 1);
        let reach = if exchange { 2 * half } else { half };
        // After step k, the entry of row i in column c stands at c + half − i.
        for k in 0..n {
            let last = n.min(k + half + 1);
            if half > WIDE && cancellation::check().is_err() {
                return None;
            }
            if exchange {
                let size = |i: usize| self.entries[i * width + half + k - i].abs();
                let pivot = (k..last).max_by(|&a, &b| size(a).total_cmp(&size(b)))?;
                if pivot != k {
                    // Column k + c of the pivot row stands c + half − (pivot − k) places in; move both rows.
                    let shift = pivot - k;
                    for c in 0..=reach {
                        self.entries.swap(pivot * width + half + c - shift, k * width + half + c);
                    }
                    self.right.swap(k, pivot);
                }
            }
            let (above, below) = self.entries.split_at_mut((k + 1) * width);
            let row = &above[k * width + half..];
            let diagonal = row[0];
            if !(diagonal.abs() > f64::MIN_POSITIVE && diagonal.is_finite()) {
                return None;
            }
            let right = self.right[k];
            for (i, other) in below.chunks_exact_mut(width).enumerate().take(last - k - 1) {
                let from = half - i - 1;
                let factor = other[from] / diagonal;
                if factor == 0.0 {
                    continue;
                }
                for (entry, above) in other[from..].iter_mut().zip(&row[..=reach]) {
                    *entry -= factor * above;
                }
                let slot = &mut self.right[k + 1 + i];
                *slot = std::array::from_fn(|d| slot[d] - factor * right[d]);
            }
        }
        for k in (0..n).rev() {
            let row = &self.entries[k * width + half..];
            let mut sum = self.right[k];
            for (entry, next) in row[1..].iter().zip(&self.right[k + 1..]).take(reach) {
                sum = std::array::from_fn(|d| sum[d] - entry * next[d]);
            }
            self.right[k] = sum.map(|x| x / row[0]);
        }
        Some(self.right)
    }
}

#[cfg(test)]
mod tests {
    use super::Banded;

    #[test]
    fn solves_with_and_without_exchanges() {
        let n = 12;
        for (half, exchange) in [(1, false), (2, false), (3, true), (2, true)] {
            let entry = |i: usize, j: usize| {
                let near = 1.0 / (1.0 + (i as f64 - j as f64).abs());
                // Where rows are exchanged, some diagonals vanish.
                if exchange && i == j && i % 3 == 1 { 0.0 } else { near + 0.1 * ((i * 7 + j) as f64).sin() }
            };
            let want: Vec<[f64; 3]> = (0..n).map(|i| [i as f64, (i as f64).cos(), 1.0]).collect();
            let mut system = Banded::new(n, half, vec![[0.0; 3]; n]).unwrap();
            for i in 0..n {
                let mut sum = [0.0; 3];
                for j in i.saturating_sub(half)..(i + half + 1).min(n) {
                    system.add(i, j, entry(i, j));
                    sum = std::array::from_fn(|d| sum[d] + entry(i, j) * want[j][d]);
                }
                system.set_right(i, sum);
            }
            let have = if exchange { system.solve() } else { system.solve_totally_positive() };
            for (a, b) in have.unwrap().iter().flatten().zip(want.iter().flatten()) {
                assert!((a - b).abs() < 1e-10, "{a} {b}");
            }
        }
        assert!(Banded::new(2, 1, vec![[1.0; 3]; 2]).unwrap().solve().is_none());
    }
}
