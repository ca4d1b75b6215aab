//! Evaluation in the local span, without allocation.
//!
//! Common degrees have their own code with arrays of fixed size: the ratios of the triangle come first, all
//! independent of each other so that their divisions overlap, then the basis functions as products of them. Only the
//! ratios 0 and 1 occur at a knot of full multiplicity, so a result equal to a control point there is exact.

use super::knots::{MAX_DEGREE, span_index};

/// The point at x on the way from a to b.
#[inline]
pub(crate) fn mix<const N: usize>(a: &[f64; N], b: &[f64; N], x: f64) -> [f64; N] {
    std::array::from_fn(|c| (1.0 - x) * a[c] + x * b[c])
}

/// [`span_index`] from above, faster: the place where `t` would be among even knots is tried first.
#[inline]
pub(crate) fn find_span(knots: &[f64], degree: usize, t: f64) -> usize {
    let Some(last) = knots.len().checked_sub(2 * degree) else { return 0 };
    let Some(bounds) = knots.get(degree - 1..degree + last + 1) else { return 0 };
    let (Some(&start), Some(&end)) = (bounds.first(), bounds.last()) else { return 0 };
    // A number below 0 or NaN becomes 0.
    let guess = ((t - start) / (end - start) * (last + 1) as f64) as usize;
    if let Some(&[low, high]) = bounds.get(guess..).and_then(|b| b.first_chunk())
        && low <= t
        && t < high
    {
        return guess;
    }
    span_index(knots, degree, t, false)
}

/// Of fixed degree P, the numerators and denominators of the R = P(P + 1)/2 ratios of de Boor's triangle at `t`, level
/// by level, divided. `u` are the 2P knots around the span.
#[inline(always)]
fn ratios<const P: usize, const R: usize, const U: usize>(u: &[f64; U], t: f64) -> [f64; R] {
    let (mut over, mut width) = ([0.0; R], [1.0; R]);
    let mut r = 0;
    for level in 1..=P {
        for i in 0..level {
            over[r] = t - u[P - level + i];
            width[r] = u[P + i] - u[P - level + i];
            r += 1;
        }
    }
    std::array::from_fn(|r| over[r] / width[r])
}

/// From the basis functions of degree `level` − 1 those of degree `level` (P&T, *The NURBS Book*, eq. 2.5).
#[inline(always)]
fn raise_basis<const Q: usize>(n: &mut [f64; Q], level: usize, x: &[f64]) {
    let mut saved = 0.0;
    for i in 0..level {
        let term = n[i];
        n[i] = if i == 0 { (1.0 - x[i]) * term } else { saved + (1.0 - x[i]) * term };
        saved = x[i] * term;
    }
    n[level] = saved;
}

/// The Q = P + 1 basis functions of fixed degree P that act in a span.
#[inline(always)]
pub(crate) fn basis_sized<const P: usize, const Q: usize, const R: usize, const U: usize>(
    u: &[f64; U],
    t: f64,
) -> [f64; Q] {
    let x: [f64; R] = ratios::<P, R, U>(u, t);
    let mut n = [0.0; Q];
    n[0] = 1.0;
    let mut r = 0;
    for level in 1..=P {
        raise_basis(&mut n, level, &x[r..r + level]);
        r += level;
    }
    n
}

/// The sum of control points by weights.
#[inline(always)]
pub(crate) fn weighted<const N: usize, const Q: usize>(
    weights: &[f64; Q],
    points: &[[f64; N]; Q],
) -> [f64; N] {
    std::array::from_fn(|c| {
        let mut sum = weights[0] * points[0][c];
        for i in 1..Q {
            sum += weights[i] * points[i][c];
        }
        sum
    })
}

#[inline(always)]
fn point_sized<const N: usize, const P: usize, const Q: usize, const R: usize, const U: usize>(
    knots: &[f64],
    points: &[[f64; N]],
    j: usize,
    t: f64,
) -> [f64; N] {
    match (local::<_, Q>(points, j), local::<_, U>(knots, j)) {
        (Some(points), Some(u)) => weighted(&basis_sized::<P, Q, R, U>(u, t), points),
        _ => [f64::NAN; N],
    }
}

/// N items from index j on.
#[inline(always)]
pub(crate) fn local<T, const N: usize>(items: &[T], j: usize) -> Option<&[T; N]> {
    items.get(j..).and_then(|rest| rest.first_chunk())
}

/// Evaluates the spline with control points `points` (any dimension N) at `t`, in span `j`.
///
/// By basis functions up to degree 5, else by the triangle of de Boor (C. de Boor, *A Practical Guide to Splines*,
/// ch. X). A result equal to a control point at a knot of full multiplicity is exact, because the weights there are
/// 0 and 1.
#[inline]
pub(crate) fn de_boor<const N: usize>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    j: usize,
    t: f64,
) -> [f64; N] {
    match degree {
        3 => point_sized::<N, 3, 4, 6, 6>(knots, points, j, t),
        2 => point_sized::<N, 2, 3, 3, 4>(knots, points, j, t),
        1 => point_sized::<N, 1, 2, 1, 2>(knots, points, j, t),
        5 => point_sized::<N, 5, 6, 15, 10>(knots, points, j, t),
        4 => point_sized::<N, 4, 5, 10, 8>(knots, points, j, t),
        0..=7 => de_boor_long::<N, 8>(degree, knots, points, j, t),
        _ => de_boor_long::<N, { MAX_DEGREE + 1 }>(degree, knots, points, j, t),
    }
}

fn de_boor_long<const N: usize, const M: usize>(
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
        1..=3 => {
            let n = out.len().min(4);
            let d: [[f64; N]; 4] = match (degree, n) {
                (3, 0..=3) => cut(jet_sized::<N, 3, 4, 6, 6, 3>(knots, points, j, t)),
                (3, _) => jet_sized::<N, 3, 4, 6, 6, 4>(knots, points, j, t),
                (2, _) => cut(jet_sized::<N, 2, 3, 3, 4, 3>(knots, points, j, t)),
                _ => cut(jet_sized::<N, 1, 2, 1, 2, 2>(knots, points, j, t)),
            };
            for (k, slot) in out.iter_mut().enumerate() {
                *slot = d.get(k).copied().unwrap_or([0.0; N]);
            }
        }
        0..=7 => derivatives_long::<N, 8>(degree, knots, points, j, t, out),
        _ => derivatives_long::<N, { MAX_DEGREE + 1 }>(degree, knots, points, j, t, out),
    }
}

/// As many as there are of other values; the rest are zero.
#[inline(always)]
fn cut<const N: usize, const K: usize, const L: usize>(d: [[f64; N]; K]) -> [[f64; N]; L] {
    std::array::from_fn(|k| if k < K { d[k] } else { [0.0; N] })
}

/// The value and K − 1 derivatives at `t` in span `j`, for K known at compile time: fast for degrees 1 to 5.
#[inline]
pub(crate) fn jet<const N: usize, const K: usize>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    j: usize,
    t: f64,
) -> [[f64; N]; K] {
    match degree {
        3 => jet_sized::<N, 3, 4, 6, 6, K>(knots, points, j, t),
        2 => jet_sized::<N, 2, 3, 3, 4, K>(knots, points, j, t),
        1 => jet_sized::<N, 1, 2, 1, 2, K>(knots, points, j, t),
        5 => jet_sized::<N, 5, 6, 15, 10, K>(knots, points, j, t),
        4 => jet_sized::<N, 4, 5, 10, 8, K>(knots, points, j, t),
        _ => {
            let mut out = [[0.0; N]; K];
            derivatives(degree, knots, points, j, t, &mut out);
            out
        }
    }
}

#[inline(always)]
fn jet_sized<
    const N: usize,
    const P: usize,
    const Q: usize,
    const R: usize,
    const U: usize,
    const K: usize,
>(
    knots: &[f64],
    points: &[[f64; N]],
    j: usize,
    t: f64,
) -> [[f64; N]; K] {
    let (Some(points), Some(u)) = (local::<_, Q>(points, j), local::<_, U>(knots, j)) else {
        return [[f64::NAN; N]; K];
    };
    let x: [f64; R] = ratios::<P, R, U>(u, t);
    // The basis functions of all degrees from P − K + 1 on.
    let mut rows = [[0.0; Q]; Q];
    rows[0][0] = 1.0;
    let mut r = 0;
    for level in 1..=P {
        rows[level] = rows[level - 1];
        raise_basis(&mut rows[level], level, &x[r..r + level]);
        r += level;
    }
    let mut out = [[0.0; N]; K];
    let mut d = *points;
    for k in 0..K.min(Q) {
        if k > 0 {
            let p = (P - k + 1) as f64;
            for i in 0..=P - k {
                let scale = p / (u[i + P] - u[i + k - 1]);
                d[i] = std::array::from_fn(|c| (d[i + 1][c] - d[i][c]) * scale);
            }
        }
        out[k] = std::array::from_fn(|c| {
            let mut sum = rows[P - k][0] * d[0][c];
            for i in 1..=P - k {
                sum += rows[P - k][i] * d[i][c];
            }
            sum
        });
    }
    out
}

fn derivatives_long<const N: usize, const M: usize>(
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
        *slot = match k {
            0 => de_boor(degree, u, &d[..=degree], 0, t),
            _ if k == degree => d[0],
            _ => de_boor(degree - k, &u[k..2 * degree - k], &d[..=degree - k], 0, t),
        };
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

/// The quotient rule for K − 1 derivatives of homogeneous ones (P&T, *The NURBS Book*, algorithm A4.2).
#[inline]
pub(crate) fn divided<const K: usize>(d: &[[f64; 4]; K]) -> [[f64; 3]; K] {
    let mut out = [[0.0; 3]; K];
    let w = d.first().map_or(1.0, |d| d[3]);
    for k in 0..K {
        let mut v = [d[k][0], d[k][1], d[k][2]];
        let mut choose = 1.0;
        for i in 1..=k {
            choose = choose * (k - i + 1) as f64 / i as f64;
            let factor = choose * d[i][3];
            v = std::array::from_fn(|c| v[c] - out[k - i][c] * factor);
        }
        out[k] = v.map(|x| x / w);
    }
    out
}
