//! The product of two matrices.

use super::thresholds::{MOST_ENTRIES, MOST_TERMS};
use super::{Algorithm, Explanation, Number, Quantity, Round, Step};
use crate::{Error, Matrix, Result};

/// The product A B, entry by entry: a row of A times a column of B. A round for each row of A. Rows and columns are counted
/// from 1: `c21` is in the second row; numbers of two digits have a point between them.
///
/// # Errors
/// The columns of A are not as many as the rows of B, or there are more entries than anybody reads.
pub fn matrix_product(a: &Matrix, b: &Matrix) -> Result<Explanation> {
    let product = a.product(b)?;
    let (rows, inner, columns) = (a.rows(), a.columns(), b.columns());
    if rows.saturating_mul(columns) > MOST_ENTRIES || inner > MOST_TERMS {
        return Err(Error::Unsupported("the steps of a product of large matrices"));
    }
    let of = |m: &Matrix, i: usize, j: usize| Number::given(m.get(i, j).unwrap_or_default());
    let line = |name: &str, m: &Matrix, i: usize| {
        Quantity::given(format!("row {} of {name}", i + 1), m.row(i).unwrap_or(&[]))
    };
    let given = (0..rows).map(|i| line("A", a, i)).chain((0..inner).map(|i| line("B", b, i))).collect();
    let rounds = (0..rows)
        .map(|i| Round {
            steps: (0..columns)
                .map(|j| {
                    let terms: Vec<_> = (0..inner).map(|k| (of(a, i, k), place("b", k, j))).collect();
                    let sum = (0..inner)
                        .fold(Number::given(0.0), |sum, k| sum.plus(of(a, i, k).times(of(b, k, j))));
                    Step { made: Quantity::new(place("c", i, j), vec![sum]), rule: String::new(), terms }
                })
                .collect(),
        })
        .collect();
    let result = (0..rows).map(|i| line("A B", &product, i)).collect();
    Ok(Explanation { algorithm: Algorithm::MatrixProduct, given, rounds, result })
}

/// The name of an entry.
fn place(letter: &str, i: usize, j: usize) -> String {
    let (i, j) = (i + 1, j + 1);
    if i < 10 && j < 10 { format!("{letter}{i}{j}") } else { format!("{letter}{i}.{j}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_times_columns() {
        let a = Matrix::new(2, 2, vec![1.0, 2.0, 3.0, 4.0]).unwrap();
        let b = Matrix::new(2, 1, vec![0.5, -1.0]).unwrap();
        let told = matrix_product(&a, &b).unwrap();
        assert_eq!(told.rounds[1].steps[0].to_string(), "c21 = 3 b11 + 4 b21 = -5/2");
        assert!(matrix_product(&b, &b).is_err());
        assert!(
            matrix_product(&Matrix::identity(40, 40).unwrap(), &Matrix::identity(40, 40).unwrap()).is_err()
        );
    }
}
