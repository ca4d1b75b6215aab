mod angles;
mod classify;
mod construct;
mod decompose;
mod inverse;
mod planes;
mod points;
mod thresholds;
mod view;

pub use decompose::AffineParts;
pub use view::Frustum;

use std::ops::Mul;

use crate::{Plane, Point3, Vector3};

/// A 4×4 matrix that transforms column vectors: `rows[i][j]` is row i, column j.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Xform {
    /// The four rows.
    pub rows: [[f64; 4]; 4],
}

impl Xform {
    /// The transform that changes nothing.
    pub const IDENTITY: Self = Self {
        rows: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]],
    };

    /// The move by `v`.
    pub const fn translation(v: Vector3) -> Self {
        Self {
            rows: [[1.0, 0.0, 0.0, v.x], [0.0, 1.0, 0.0, v.y], [0.0, 0.0, 1.0, v.z], [0.0, 0.0, 0.0, 1.0]],
        }
    }

    /// The uniform scale about a centre.
    pub fn scale(center: Point3, factor: f64) -> Self {
        let c = center.to_vector() * (1.0 - factor);
        Self {
            rows: [
                [factor, 0.0, 0.0, c.x],
                [0.0, factor, 0.0, c.y],
                [0.0, 0.0, factor, c.z],
                [0.0, 0.0, 0.0, 1.0],
            ],
        }
    }

    /// The rigid map that takes frame `from` onto frame `to`.
    pub fn plane_to_plane(from: &Plane, to: &Plane) -> Self {
        let cols = [from.x_axis, from.y_axis, from.z_axis];
        let rows = [to.x_axis, to.y_axis, to.z_axis];
        let component = |v: Vector3, i: usize| [v.x, v.y, v.z][i];
        let mut m = Self::IDENTITY;
        for i in 0..3 {
            for j in 0..3 {
                m.rows[i][j] = (0..3).map(|k| component(rows[k], i) * component(cols[k], j)).sum();
            }
        }
        let moved = m.vector(from.origin.to_vector());
        let t = to.origin.to_vector() - moved;
        m.rows[0][3] = t.x;
        m.rows[1][3] = t.y;
        m.rows[2][3] = t.z;
        m
    }

    /// The image of a point; divides by the homogeneous coordinate where the matrix is not affine.
    #[inline]
    pub fn point(&self, p: Point3) -> Point3 {
        let r = &self.rows;
        let at = |i: usize| r[i][0] * p.x + r[i][1] * p.y + r[i][2] * p.z + r[i][3];
        let w = at(3);
        if w == 1.0 { Point3::new(at(0), at(1), at(2)) } else { Point3::new(at(0) / w, at(1) / w, at(2) / w) }
    }

    /// The image of a vector: translation does not move it.
    #[inline]
    pub fn vector(&self, v: Vector3) -> Vector3 {
        let r = &self.rows;
        let at = |i: usize| r[i][0] * v.x + r[i][1] * v.y + r[i][2] * v.z;
        Vector3::new(at(0), at(1), at(2))
    }
}

impl Mul for Xform {
    type Output = Self;

    /// The product: first `rhs` is applied, then `self`.
    fn mul(self, rhs: Self) -> Self {
        let mut m = Self::IDENTITY;
        for i in 0..4 {
            for j in 0..4 {
                m.rows[i][j] = (0..4).map(|k| self.rows[i][k] * rhs.rows[k][j]).sum();
            }
        }
        m
    }
}
