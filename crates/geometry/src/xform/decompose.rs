//! Maps taken apart.

use katydid_elementary::Elementary;

use crate::linear::symmetric_eigen;
use crate::thresholds;
use crate::xform::thresholds::{JACOBI, NO_INVERSE};
use crate::{Point3, Vector3, Xform};

/// An affine map as moves, turns and scales: translation · rotation · axes · scale · axesᵀ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AffineParts {
    /// The move, applied last.
    pub translation: Vector3,
    /// The rotation of the polar decomposition.
    pub rotation: Xform,
    /// A rotation whose columns are the three perpendicular directions that are scaled.
    pub axes: Xform,
    /// The factors along these directions, the largest first; all three negative where the map mirrors.
    pub scale: Vector3,
}

impl AffineParts {
    /// The map again.
    pub fn compose(&self) -> Xform {
        Xform::translation(self.translation)
            * self.rotation
            * self.axes
            * Xform::diagonal(self.scale.x, self.scale.y, self.scale.z)
            * self.axes.transposed()
    }
}

impl Xform {
    /// The scale by three factors along the world axes about the origin.
    pub const fn diagonal(x: f64, y: f64, z: f64) -> Self {
        Self { rows: [[x, 0.0, 0.0, 0.0], [0.0, y, 0.0, 0.0], [0.0, 0.0, z, 0.0], [0.0, 0.0, 0.0, 1.0]] }
    }

    /// The last column: where an affine map moves the origin.
    pub fn translation_part(&self) -> Vector3 {
        Vector3::new(self.rows[0][3], self.rows[1][3], self.rows[2][3])
    }

    /// The map without its translation and its last row.
    #[must_use]
    pub fn linear_part(&self) -> Self {
        let [x, y, z] = self.linear_columns();
        Self::from_columns(x, y, z, Point3::ORIGIN)
    }

    /// The map with the last row (0, 0, 0, 1).
    #[must_use]
    pub fn affine_part(&self) -> Self {
        let mut m = *self;
        m.rows[3] = [0.0, 0.0, 0.0, 1.0];
        m
    }

    /// The images of the three world axes.
    fn linear_columns(&self) -> [Vector3; 3] {
        std::array::from_fn(|j| Vector3::new(self.rows[0][j], self.rows[1][j], self.rows[2][j]))
    }

    /// An affine map as translation · linear: the linear map is applied first. `None` when it is not affine.
    pub fn decompose_translation_linear(&self) -> Option<(Vector3, Self)> {
        self.is_affine().then(|| (self.translation_part(), self.linear_part()))
    }

    /// An affine map as linear · translation: the move is applied first. `None` when it is not affine or its linear
    /// part has no inverse.
    pub fn decompose_linear_translation(&self) -> Option<(Self, Vector3)> {
        let linear = self.is_affine().then(|| self.linear_part())?;
        Some((linear, linear.inverse()?.vector(self.translation_part())))
    }

    /// A map that keeps sizes as translation · (±rotation): the sign, 1 or −1, the move and the rotation, made
    /// orthogonal to the last bits. `None` when the map is none within `tolerance`.
    pub fn decompose_rigid(&self, tolerance: f64) -> Option<(i8, Vector3, Self)> {
        let sign = self.rigid_type(tolerance);
        (sign != 0).then_some(())?;
        let (translation, _, rotation) = self.decompose_similarity(tolerance)?;
        Some((sign, translation, rotation))
    }

    /// A map that keeps angles as translation · factor · rotation; the factor is negative when it mirrors. `None`
    /// when the map is none within `tolerance`.
    pub fn decompose_similarity(&self, tolerance: f64) -> Option<(Vector3, f64, Self)> {
        let factor = self.similarity_factor(tolerance)?;
        let columns = self.linear_columns().map(|c| c / factor);
        let [x, y, z] = columns;
        let rotation = Self::from_columns(x, y, z, Point3::ORIGIN).orthogonalized()?;
        Some((self.translation_part(), factor, rotation))
    }

    /// An affine map as translation, rotation and a scale along three perpendicular directions (the polar
    /// decomposition with its symmetric factor diagonalised). `None` when the map is not affine or not finite.
    ///
    /// By the singular value decomposition with one-sided Jacobi rotations, which keeps small factors exact
    /// (J. Demmel & K. Veselić, *Jacobi's method is more accurate than QR*, SIAM J. Matrix Anal. 13, 1992).
    pub fn decompose_affine(&self) -> Option<AffineParts> {
        if !(self.is_affine() && self.is_finite()) {
            return None;
        }
        let (u, s, v) = singular_values(self.linear_columns())?;
        let basis = |c: [Vector3; 3]| Self::from_columns(c[0], c[1], c[2], Point3::ORIGIN);
        let (u, v) = (basis(u), basis(v));
        // Both have determinant ±1; a negative product makes −rotation a rotation and the scale negative.
        let mirrored = u.determinant() * v.determinant() < 0.0;
        let sign = if mirrored { -1.0 } else { 1.0 };
        let turned = u * v.transposed();
        let [x, y, z] = turned.linear_columns().map(|c| c * sign);
        let axes = if v.determinant() < 0.0 {
            let [x, y, z] = v.linear_columns();
            basis([-x, -y, -z])
        } else {
            v
        };
        let scale = Vector3::new(s[0], s[1], s[2]) * sign;
        Some(AffineParts { translation: self.translation_part(), rotation: basis([x, y, z]), axes, scale })
    }

    /// A symmetric linear map as Q · diagonal · Qᵀ with Q a rotation: Q and the factors, ascending. `None` when
    /// entries across the diagonal differ by more than `tolerance` times the largest, or the map is not linear.
    pub fn decompose_symmetric(&self, tolerance: f64) -> Option<(Self, Vector3)> {
        if !(self.is_linear() && self.is_finite()) {
            return None;
        }
        let r = &self.rows;
        let largest = r.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
        if [(0, 1), (0, 2), (1, 2)].iter().any(|&(i, j)| (r[i][j] - r[j][i]).abs() > tolerance * largest) {
            return None;
        }
        let m = std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (r[i][j] + r[j][i])));
        let (values, vectors) = symmetric_eigen(m);
        let [x, y, z] = vectors.map(Vector3::from);
        let z = if x.cross(y).dot(z) < 0.0 { -z } else { z };
        Some((Self::from_columns(x, y, z, Point3::ORIGIN), values.into()))
    }

    /// The linear part made orthogonal, the nearest such map there is, and the same translation; `None` when the
    /// linear part has no inverse or is not finite.
    ///
    /// Newton's iteration X ← (X + X⁻ᵀ)/2 (N. Higham, *Computing the polar decomposition*, SIAM J. Sci. Stat.
    /// Comput. 7, 1986).
    pub fn orthogonalized(&self) -> Option<Self> {
        let mut columns = self.linear_columns();
        let size = columns.iter().map(|c| c.length()).fold(0.0, f64::max);
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        columns = columns.map(|c| c / size);
        for _ in 0..60 {
            let [a, b, c] = columns;
            let determinant = a.dot(b.cross(c));
            if !(determinant.abs() > NO_INVERSE) {
                return None;
            }
            let dual = [b.cross(c) / determinant, c.cross(a) / determinant, a.cross(b) / determinant];
            let next: [Vector3; 3] = std::array::from_fn(|i| (columns[i] + dual[i]) * 0.5);
            let moved = (0..3).map(|i| (next[i] - columns[i]).length()).fold(0.0, f64::max);
            columns = next;
            if moved <= thresholds::NEWTON_DONE {
                break;
            }
        }
        let [x, y, z] = columns;
        Some(Self::from_columns(x, y, z, self.translation_part().to_point()))
    }

    /// The map that normals of surfaces take: the cofactors of the linear part. It maps Su × Sv to the cross product
    /// of the images, so that it is right for mirrors and also for maps that flatten; the lengths are not kept.
    #[must_use]
    pub fn normal_map(&self) -> Self {
        let [a, b, c] = self.linear_columns();
        Self::from_columns(b.cross(c), c.cross(a), a.cross(b), Point3::ORIGIN)
    }

    /// The rank of the matrix and its four pivots, the largest first, by elimination with full pivoting; pivots below
    /// `tolerance` times the first do not count.
    pub fn rank(&self, tolerance: f64) -> (usize, [f64; 4]) {
        let mut a = self.rows;
        let mut pivots = [0.0; 4];
        for k in 0..4 {
            let mut best = (k, k);
            for i in k..4 {
                for j in k..4 {
                    if a[i][j].abs() > a[best.0][best.1].abs() {
                        best = (i, j);
                    }
                }
            }
            a.swap(k, best.0);
            for row in &mut a {
                row.swap(k, best.1);
            }
            pivots[k] = a[k][k];
            if a[k][k] == 0.0 {
                break;
            }
            for i in k + 1..4 {
                let f = a[i][k] / a[k][k];
                for j in k..4 {
                    a[i][j] -= f * a[k][j];
                }
            }
        }
        let limit = tolerance * pivots[0].abs();
        let rank = pivots.iter().take_while(|p| p.abs() > limit && p.abs() > 0.0).count();
        (rank, pivots)
    }
}

/// U, the singular values (descending) and V of the matrix with the given columns: A = U Σ Vᵀ.
fn singular_values(columns: [Vector3; 3]) -> Option<([Vector3; 3], [f64; 3], [Vector3; 3])> {
    let size = columns.iter().flat_map(|c| [c.x.abs(), c.y.abs(), c.z.abs()]).fold(0.0, f64::max);
    let world = [Vector3::X, Vector3::Y, Vector3::Z];
    if size == 0.0 {
        return Some((world, [0.0; 3], world));
    }
    // Scaled, so that no square overflows.
    let mut a = columns.map(|c| Vector3::new(c.x / size, c.y / size, c.z / size));
    let mut v = world;
    for _ in 0..60 {
        let mut turned = false;
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let (alpha, beta, gamma) = (a[p].length_squared(), a[q].length_squared(), a[p].dot(a[q]));
            if gamma == 0.0 || gamma.abs() <= JACOBI * (alpha * beta).sqrt() {
                continue;
            }
            turned = true;
            let zeta = (beta - alpha) / (2.0 * gamma);
            let t = 1.0_f64.copysign(zeta) / (zeta.abs() + zeta.hypotenuse(1.0));
            let c = 1.0 / t.hypotenuse(1.0);
            let s = c * t;
            (a[p], a[q]) = (a[p] * c - a[q] * s, a[p] * s + a[q] * c);
            (v[p], v[q]) = (v[p] * c - v[q] * s, v[p] * s + v[q] * c);
        }
        if !turned {
            break;
        }
    }
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| a[j].length().total_cmp(&a[i].length()));
    let (a, v) = (order.map(|i| a[i]), order.map(|i| v[i]));
    let u0 = a[0].unitized()?;
    // Directions of factors that vanish are free.
    let second = a[1].rejected_from(u0).filter(|w| w.length() > 0.0).and_then(Vector3::unitized);
    let u1 = second.or_else(|| u0.perpendicular())?;
    let mut u2 = u0.cross(u1);
    if a[2].dot(u2) < 0.0 {
        u2 = -u2;
    }
    Some(([u0, u1, u2], a.map(|c| c.length() * size), v))
}
