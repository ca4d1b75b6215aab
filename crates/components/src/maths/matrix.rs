//! Maths / Matrix: matrices of any size. Rows and columns count from 0.

use std::sync::Arc;

use katydid_component::{Context, List, Message, component};
use katydid_data::Tree;
use katydid_geometry::Matrix;

use crate::sets;

/// Makes a matrix of numbers, row by row.
///
/// Without numbers it has ones on its main diagonal and zeros elsewhere. Too few are filled up with zeros, too many
/// are left out, each with a warning.
#[component(
    "54ac80cf-74f3-43f7-834c-0e3fe94632c6",
    name = "Construct Matrix",
    nick = "Matrix",
    at = "Maths/Matrix"
)]
#[output("Matrix", "M", "The matrix.")]
fn construct_matrix(
    context: &Context<'_>,
    /// The number of rows, at least 1.
    #[port("Rows", "R", default = 3)]
    rows: i32,
    /// The number of columns, at least 1.
    #[port("Columns", "C", default = 3)]
    columns: i32,
    /// The entries, the first row in front; nulls count as 0.
    #[port("Values", "V", optional)]
    values: List<f64>,
) -> Result<Arc<Matrix>, Message> {
    let (rows, columns) = (sets::count(rows, "Rows")?, sets::count(columns, "Columns")?);
    let wanted = rows.saturating_mul(columns);
    context.bytes(wanted.saturating_mul(size_of::<f64>()))?;
    if values.is_empty() {
        return Ok(Arc::new(Matrix::identity(rows, columns)?));
    }
    if values.len() != wanted {
        let n = values.len();
        context.warn(format!(
            "{rows} rows and {columns} columns have {wanted} entries, but there are {n} values"
        ));
    }
    // The size is checked before the room is taken.
    Matrix::zeros(rows, columns)?;
    let mut entries: Vec<f64> = values.iter().take(wanted).map(Option::unwrap_or_default).collect();
    entries.resize(wanted, 0.0);
    Ok(Arc::new(Matrix::new(rows, columns, entries)?))
}

/// The size and the entries of a matrix.
#[component(
    "3aa2a080-e322-4be3-8c6e-baf6c8000cf1",
    name = "Deconstruct Matrix",
    nick = "DeMatrix",
    at = "Maths/Matrix"
)]
#[output("Rows", "R", "The number of rows.")]
#[output("Columns", "C", "The number of columns.")]
#[output("Values", "V", "The entries, row by row.")]
fn deconstruct_matrix(
    /// The matrix; a transform counts as its 4 × 4 matrix.
    #[port("Matrix", "M")]
    matrix: &Matrix,
) -> (i32, i32, Vec<f64>) {
    (sets::integer(matrix.rows()), sets::integer(matrix.columns()), matrix.values().to_vec())
}

/// Shows a matrix as a table of numbers, and hands it on.
#[component(
    "b6d27aa4-a61f-4d08-b76e-1105fef0e9e4",
    name = "Display Matrix",
    nick = "Matrix",
    at = "Maths/Matrix",
    floating
)]
#[output("Matrix", "Matrix", "The matrix.", kind = Matrix)]
fn display_matrix(
    /// The matrix to show.
    #[port("Matrix", "Matrix", optional, kind = Matrix)]
    matrix: &Tree,
) -> Tree {
    matrix.clone()
}

/// The inverse of a square matrix: their product is the identity.
///
/// There is none, and the result is null, when the matrix is not square or its rows depend on one another. Matrices of
/// more than 2000 rows are refused.
#[component(
    "f986e79a-1215-4822-a1e7-3311dbdeb851",
    name = "Invert Matrix",
    nick = "MInvert",
    at = "Maths/Matrix"
)]
#[output("Matrix", "M", "The inverse.")]
#[output("Success", "S", "Whether there is one.")]
fn invert_matrix(
    context: &Context<'_>,
    /// The matrix.
    #[port("Matrix", "M")]
    matrix: &Matrix,
    /// The smallest pivot that is not taken for zero, beside entries of 1.
    #[port("Tolerance", "t", default = 1e-12)]
    tolerance: f64,
) -> Result<(Option<Arc<Matrix>>, bool), Message> {
    // The work grows with the third power of the size.
    if matrix.rows() > 2000 {
        return Err(Message::error("A matrix of more than 2000 rows is too large to be inverted"));
    }
    Ok(match matrix.inverse(tolerance) {
        Ok(inverse) => {
            let success = inverse.is_some();
            (inverse.map(Arc::new), success)
        }
        Err(error) => {
            context.warn(error.to_string());
            (None, false)
        }
    })
}

/// Rows and columns exchanged.
#[component(
    "0e90b1f3-b870-4e09-8711-4bf819675d90",
    name = "Transpose Matrix",
    nick = "Transpose",
    at = "Maths/Matrix"
)]
#[output("Matrix", "M", "The matrix with its rows as columns.")]
fn transpose_matrix(
    /// The matrix.
    #[port("Matrix", "M")]
    matrix: &Matrix,
) -> Arc<Matrix> {
    Arc::new(matrix.transposed())
}

fn outside(what: &str, a: i32, b: i32, n: usize) -> Message {
    Message::error(format!(
        "{what} {a} and {b} cannot be exchanged: the matrix has 0 to {}",
        n.saturating_sub(1)
    ))
}

/// Exchanges two rows of a matrix. It is an error when there is no such row.
#[component("8600a3fc-30f0-4df6-b126-aaa79ece5bfe", name = "Swap Rows", nick = "SwapR", at = "Maths/Matrix")]
#[output("Matrix", "M", "The matrix with the rows exchanged.")]
fn swap_rows(
    /// The matrix.
    #[port("Matrix", "M")]
    matrix: &Matrix,
    /// The number of one row.
    #[port("Row A", "A", default = 0)]
    a: i32,
    /// The number of the other.
    #[port("Row B", "B", default = 1)]
    b: i32,
) -> Result<Arc<Matrix>, Message> {
    let indices = usize::try_from(a).ok().zip(usize::try_from(b).ok());
    let swapped = indices.and_then(|(a, b)| matrix.with_rows_swapped(a, b));
    swapped.map(Arc::new).ok_or_else(|| outside("Rows", a, b, matrix.rows()))
}

/// Exchanges two columns of a matrix. It is an error when there is no such column.
#[component(
    "4cebcaf7-9a6a-435b-8f8f-95a62bacb0f2",
    name = "Swap Columns",
    nick = "SwapC",
    at = "Maths/Matrix"
)]
#[output("Matrix", "M", "The matrix with the columns exchanged.")]
fn swap_columns(
    /// The matrix.
    #[port("Matrix", "M")]
    matrix: &Matrix,
    /// The number of one column.
    #[port("Column A", "A", default = 0)]
    a: i32,
    /// The number of the other.
    #[port("Column B", "B", default = 1)]
    b: i32,
) -> Result<Arc<Matrix>, Message> {
    let indices = usize::try_from(a).ok().zip(usize::try_from(b).ok());
    let swapped = indices.and_then(|(a, b)| matrix.with_columns_swapped(a, b));
    swapped.map(Arc::new).ok_or_else(|| outside("Columns", a, b, matrix.columns()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Tree;
    use katydid_geometry::{Vector3, Xform};

    fn matrix(rows: i32, columns: i32, values: &[f64]) -> Tree {
        let trial = Trial::of("Construct Matrix").item(rows).item(columns).list(values.iter().copied());
        trial.run().outputs[0].clone()
    }

    fn values(tree: &Tree) -> Vec<String> {
        Trial::of("Deconstruct Matrix").tree(tree.clone()).texts(2)
    }

    #[test]
    fn matrices_are_filled_row_by_row() {
        let m = matrix(2, 3, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!(texts(&m), ["{0}: Matrix (2 rows, 3 columns)"]);
        let parts = Trial::of("Deconstruct Matrix").tree(m.clone()).run().outputs;
        assert_eq!((texts(&parts[0]), texts(&parts[1])), (vec!["{0}: 2".into()], vec!["{0}: 3".into()]));
        assert_eq!(values(&m), ["{0;0}: 1, 2, 3, 4, 5, 6"]);
        let turned = Trial::of("Transpose Matrix").tree(m.clone()).run().outputs[0].clone();
        assert_eq!(values(&turned), ["{0;0}: 1, 4, 2, 5, 3, 6"]);
        assert_eq!(texts(&Trial::of("Display Matrix").tree(m.clone()).run().outputs[0]), texts(&m));
        let identity = Trial::of("Construct Matrix").item(2).item(3).run().outputs[0].clone();
        assert_eq!(values(&identity), ["{0;0}: 1, 0, 0, 0, 1, 0"]);
        assert_eq!(values(&matrix(2, 2, &[7.0])), ["{0;0}: 7, 0, 0, 0"]);
        assert!(Trial::of("Construct Matrix").item(0).message().contains("0 rows"));
        assert!(Trial::of("Construct Matrix").item(-1).message().contains("negative"));
        assert!(!Trial::of("Construct Matrix").item(i32::MAX).item(i32::MAX).message().is_empty());
    }

    #[test]
    fn rows_and_columns_are_exchanged() {
        let m = matrix(2, 2, &[1.0, 2.0, 3.0, 4.0]);
        let rows = Trial::of("Swap Rows").tree(m.clone()).item(0).item(1).run().outputs[0].clone();
        assert_eq!(values(&rows), ["{0;0}: 3, 4, 1, 2"]);
        let columns = Trial::of("Swap Columns").tree(m.clone()).run().outputs[0].clone();
        assert_eq!(values(&columns), ["{0;0}: 2, 1, 4, 3"]);
        let outside = Trial::of("Swap Rows").tree(m).item(0).item(2).message();
        assert_eq!(outside, "Rows 0 and 2 cannot be exchanged: the matrix has 0 to 1");
    }

    #[test]
    fn inverses() {
        let inverse = |m: Tree| Trial::of("Invert Matrix").tree(m).run();
        let out = inverse(matrix(2, 2, &[4.0, 7.0, 2.0, 6.0]));
        assert_eq!(values(&out.outputs[0]), ["{0;0}: 0.6, -0.7, -0.2, 0.4"]);
        assert_eq!(texts(&out.outputs[1]), ["{0}: True"]);
        for singular in [matrix(2, 2, &[1.0, 2.0, 2.0, 4.0]), matrix(1, 2, &[1.0, 2.0])] {
            let out = inverse(singular);
            assert_eq!(texts(&out.outputs[0]), ["{0}: null"]);
            assert_eq!(texts(&out.outputs[1]), ["{0}: False"]);
        }
        // A transform is a matrix.
        let step = Trial::of("Invert Matrix").item(Xform::translation(Vector3::X)).run().outputs[0].clone();
        assert!(values(&step)[0].starts_with("{0;0}: 1, 0, 0, -1, 0, 1,"));
    }
}
