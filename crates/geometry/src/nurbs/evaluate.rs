//! Evaluation by de Boor's algorithm in the local span, without allocation.

use super::knots::{MAX_DEGREE, span_index};

/// The point at x on the way from a to b.
#[inline]
pub(crate) fn mix<const N: usize>(a: &[f64; N], b: &[f64; N], x: f64) -> [f64; N] {
    std::array::from_fn(|c| (1.0 - x) * a[c] + x * b[c])
}

/// Evaluates the spline with control points `points` (any dimension N) at `t`, in span `j`.
///
/// The triangle of de Boor (C. de Boor, *A Practical Guide to Splines*, ch. X); a result equal to a control point
/// at a knot of full multiplicity is exact, because the weights there are 0 and 1.
#[inline]
pub(crate) fn de_boor<const N: usize>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    j: usize,
    t: f64,
) -> [f64; N] {
    match degree {
        0..=3 => de_boor_sized::<N, 4>(degree, knots, points, j, t),
        4..=7 => de_boor_sized::<N, 8>(degree, knots, points, j, t),
        _ => de_boor_sized::<N, { MAX_DEGREE + 1 }>(degree, knots, points, j, t),
    }
}

#[inline]
fn de_boor_sized<const N: usize, const M: usize>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    j: usize,
    t: f64,
) -> [f64; N] {
    let mut d = [[0.0; N]; M];
    let (Some(local), Some(u)) = (points.get(j..=j + degree), knots.get(j..j + 2 * degree)) else {
        return [f64::NAN; N];
    };
    d[..=degree].copy_from_slice(local);
    for level in 1..=degree {
        for i in 0..=degree - level {
            let (a, b) = (u[i + level - 1], u[i + degree]);
            let x = (t - a) / (b - a);
            d[i] = mix(&d[i], &d[i + 1], x);
        }
    }
    d[0]
}

/// The value and the first `out.len() − 1` derivatives at `t` in span `j`: derivative k is a spline of degree − k
/// whose control points are scaled differences (P&T, *The NURBS Book*, eq. 3.8).
pub(crate) fn derivatives<const N: usize>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    j: usize,
    t: f64,
    out: &mut [[f64; N]],
) {
    match degree {
        0..=3 => derivatives_sized::<N, 4>(degree, knots, points, j, t, out),
        4..=7 => derivatives_sized::<N, 8>(degree, knots, points, j, t, out),
        _ => derivatives_sized::<N, { MAX_DEGREE + 1 }>(degree, knots, points, j, t, out),
    }
}

fn derivatives_sized<const N: usize, const M: usize>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    j: usize,
    t: f64,
    out: &mut [[f64; N]],
) {
    let mut d = [[0.0; N]; M];
    let (Some(local), Some(u)) = (points.get(j..=j + degree), knots.get(j..j + 2 * degree)) else {
        out.fill([f64::NAN; N]);
        return;
    };
    d[..=degree].copy_from_slice(local);
    for (k, slot) in out.iter_mut().enumerate() {
        if k > degree {
            *slot = [0.0; N];
            continue;
        }
        if k > 0 {
            // Differences of level k: the knots that bound them are degree − k + 1 apart.
            let p = (degree - k + 1) as f64;
            for i in 0..=degree - k {
                let width = u[i + degree] - u[i + k - 1];
                d[i] = std::array::from_fn(|c| p * (d[i + 1][c] - d[i][c]) / width);
            }
        }
        // u without its first and last k knots is the local knot vector of the derivative.
        *slot = de_boor_sized::<N, M>(degree - k, &u[k..2 * degree - k], &d[..=degree - k], 0, t);
    }
}

/// The degree + 1 basis functions that act in span `j`, at `t` (P&T, *The NURBS Book*, algorithm A2.2).
pub(crate) fn basis(degree: usize, knots: &[f64], j: usize, t: f64, out: &mut [f64; MAX_DEGREE + 1]) {
    let Some(u) = knots.get(j..j + 2 * degree) else {
        out.fill(f64::NAN);
        return;
    };
    out[0] = 1.0;
    for level in 1..=degree {
        let mut saved = 0.0;
        for i in 0..level {
            let (right, left) = (u[degree + i] - t, t - u[degree + i - level]);
            let term = out[i] / (right + left);
            out[i] = saved + right * term;
            saved = left * term;
        }
        out[level] = saved;
    }
}

/// Evaluates at many parameters; each search for a span starts from the one before.
pub(crate) fn many<const N: usize>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    parameters: &[f64],
    mut take: impl FnMut([f64; N]),
) {
    let mut j = 0;
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for &t in parameters {
        if !(low <= t && t < high) {
            j = span_index(knots, degree, t, false);
            low = knots.get(j + degree - 1).copied().unwrap_or(f64::INFINITY);
            high = knots.get(j + degree).copied().unwrap_or(f64::NEG_INFINITY);
        }
        take(de_boor(degree, knots, points, j, t));
    }
}
