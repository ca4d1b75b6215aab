//! nalgebra's types of `f64`.

use nalgebra as na;

use crate::{Error, Matrix, Point2, Point3, Quaternion, Vector2, Vector3, Xform};

macro_rules! both_ways {
    ($($ours:ident, $theirs:ident { $($part:ident),* });* $(;)?) => { $(
        impl From<$ours> for na::$theirs<f64> {
            fn from(v: $ours) -> Self {
                Self::new($(v.$part),*)
            }
        }
        impl From<na::$theirs<f64>> for $ours {
            fn from(v: na::$theirs<f64>) -> Self {
                Self::new($(v.$part),*)
            }
        }
    )* };
}

both_ways! {
    Point2, Point2 { x, y };
    Vector2, Vector2 { x, y };
    Point3, Point3 { x, y, z };
    Vector3, Vector3 { x, y, z };
}

impl From<Xform> for na::Matrix4<f64> {
    fn from(m: Xform) -> Self {
        Self::from_fn(|i, j| m.rows[i][j])
    }
}

impl From<na::Matrix4<f64>> for Xform {
    fn from(m: na::Matrix4<f64>) -> Self {
        Self { rows: std::array::from_fn(|i| std::array::from_fn(|j| m[(i, j)])) }
    }
}

impl From<Quaternion> for na::Quaternion<f64> {
    fn from(q: Quaternion) -> Self {
        Self::new(q.w, q.x, q.y, q.z)
    }
}

impl From<na::Quaternion<f64>> for Quaternion {
    fn from(q: na::Quaternion<f64>) -> Self {
        Self::new(q.w, q.i, q.j, q.k)
    }
}

impl From<&Matrix> for na::DMatrix<f64> {
    fn from(m: &Matrix) -> Self {
        Self::from_row_slice(m.rows(), m.columns(), m.values())
    }
}

impl TryFrom<&na::DMatrix<f64>> for Matrix {
    type Error = Error;

    /// # Errors
    /// The matrix is empty or an entry not finite.
    fn try_from(m: &na::DMatrix<f64>) -> Result<Self, Error> {
        let values = m.row_iter().flat_map(|r| r.iter().copied().collect::<Vec<_>>()).collect();
        Self::new(m.nrows(), m.ncols(), values)
    }
}
