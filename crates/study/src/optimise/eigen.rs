//! Eigenvalues of symmetric matrices.

/// Sweeps over all pairs; ten are more than matrices of a hundred rows need.
const SWEEPS: usize = 30;

/// The eigenvalues of a symmetric matrix and, as columns, its eigenvectors, by Jacobi's rotations (Golub, Van Loan, section 8.5).
/// Rows of the matrix come one after another; there are `n` of `n` numbers.
pub(super) fn symmetric(matrix: &[f64], n: usize) -> (Vec<f64>, Vec<f64>) {
    let mut a = matrix.to_vec();
    let mut vectors = vec![0.0; n * n];
    for k in 0..n {
        vectors[k * n + k] = 1.0;
    }
    let whole: f64 = a.iter().map(|x| x * x).sum();
    for _ in 0..SWEEPS {
        let mut beside = 0.0;
        for p in 0..n {
            for q in p + 1..n {
                beside += a[p * n + q] * a[p * n + q];
            }
        }
        if beside <= 1e-30 * whole {
            break;
        }
        for p in 0..n {
            for q in p + 1..n {
                rotate(&mut a, &mut vectors, n, p, q);
            }
        }
    }
    ((0..n).map(|k| a[k * n + k]).collect(), vectors)
}

/// Turns the plane of two axes so that their common entry is 0.
fn rotate(a: &mut [f64], vectors: &mut [f64], n: usize, p: usize, q: usize) {
    let common = a[p * n + q];
    if common == 0.0 {
        return;
    }
    let theta = (a[q * n + q] - a[p * n + p]) / (2.0 * common);
    let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
    let c = 1.0 / (t * t + 1.0).sqrt();
    let s = t * c;
    for k in 0..n {
        let (x, y) = (a[k * n + p], a[k * n + q]);
        (a[k * n + p], a[k * n + q]) = (c * x - s * y, s * x + c * y);
    }
    for k in 0..n {
        let (x, y) = (a[p * n + k], a[q * n + k]);
        (a[p * n + k], a[q * n + k]) = (c * x - s * y, s * x + c * y);
    }
    for k in 0..n {
        let (x, y) = (vectors[k * n + p], vectors[k * n + q]);
        (vectors[k * n + p], vectors[k * n + q]) = (c * x - s * y, s * x + c * y);
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn vectors_are_turned_into_themselves(n in 1_usize..8, seed in proptest::collection::vec(-1.0..1.0_f64, 64)) {
            let mut a = vec![0.0; n * n];
            for p in 0..n {
                for q in 0..n {
                    a[p * n + q] = seed[p * 8 + q] + seed[q * 8 + p];
                }
            }
            let (values, vectors) = symmetric(&a, n);
            for k in 0..n {
                for row in 0..n {
                    let turned: f64 = (0..n).map(|j| a[row * n + j] * vectors[j * n + k]).sum();
                    prop_assert!((turned - values[k] * vectors[row * n + k]).abs() < 1e-12);
                }
                let length: f64 = (0..n).map(|j| vectors[j * n + k] * vectors[j * n + k]).sum();
                prop_assert!((length - 1.0).abs() < 1e-12);
            }
        }
    }
}
