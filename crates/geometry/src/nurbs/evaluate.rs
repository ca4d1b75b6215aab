//! Evaluation in the local span, without allocation.
//!
//! Common degrees have their own code with arrays of fixed size: the basis functions as products of the ratios of de
//! Boor's triangle, all independent of each other so that their divisions overlap. Only the ratios 0 and 1 occur at a
//! knot of full multiplicity, so a result equal to a control point there is exact.

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

/// How far `t` has come from a to b.
#[inline(always)]
fn ratio(t: f64, a: f64, b: f64) -> f64 {
    (t - a) / (b - a)
}

/// The three basis functions of degree 2 from the two of degree 1 and two ratios; in the same way each higher degree.
#[inline(always)]
fn quadratic([a, b]: [f64; 2], [x0, x1]: [f64; 2]) -> [f64; 3] {
    [(1.0 - x0) * a, x0 * a + (1.0 - x1) * b, x1 * b]
}

#[inline(always)]
fn cubic([a, b, c]: [f64; 3], [x0, x1, x2]: [f64; 3]) -> [f64; 4] {
    [(1.0 - x0) * a, x0 * a + (1.0 - x1) * b, x1 * b + (1.0 - x2) * c, x2 * c]
}

/// The Q = P + 1 basis functions of degree P that act in the span amid the U = 2P knots `u` (P&T, *The NURBS Book*,
/// eq. 2.5).
#[inline(always)]
pub(crate) fn basis_sized<const P: usize, const Q: usize, const U: usize>(u: &[f64; U], t: f64) -> [f64; Q] {
    let mut n = [0.0; Q];
    // Written out for the degrees that matter most: loops, even unrolled ones, cost half as much again.
    match P {
        1 => {
            let x = ratio(t, u[0], u[1]);
            n.copy_from_slice(&[1.0 - x, x]);
        }
        2 => {
            let x = ratio(t, u[1], u[2]);
            n.copy_from_slice(&quadratic([1.0 - x, x], [ratio(t, u[0], u[2]), ratio(t, u[1], u[3])]));
        }
        3 => {
            let x = ratio(t, u[2], u[3]);
            let q = quadratic([1.0 - x, x], [ratio(t, u[1], u[3]), ratio(t, u[2], u[4])]);
            let x = [ratio(t, u[0], u[3]), ratio(t, u[1], u[4]), ratio(t, u[2], u[5])];
            n.copy_from_slice(&cubic(q, x));
        }
        _ => {
            n[0] = 1.0;
            for level in 1..=P {
                let mut saved = 0.0;
                for i in 0..level {
                    let (x, term) = (ratio(t, u[P - level + i], u[P + i]), n[i]);
                    n[i] = saved + (1.0 - x) * term;
                    saved = x * term;
                }
                n[level] = saved;
            }
        }
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
fn point_sized<const N: usize, const P: usize, const Q: usize, const U: usize>(
    knots: &[f64],
    points: &[[f64; N]],
    j: usize,
    t: f64,
) -> [f64; N] {
    match (local::<_, Q>(points, j), local::<_, U>(knots, j)) {
        (Some(points), Some(u)) => weighted(&basis_sized::<P, Q, U>(u, t), points),
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
        3 => point_sized::<N, 3, 4, 6>(knots, points, j, t),
        2 => point_sized::<N, 2, 3, 4>(knots, points, j, t),
        1 => point_sized::<N, 1, 2, 2>(knots, points, j, t),
        5 => point_sized::<N, 5, 6, 10>(knots, points, j, t),
        4 => point_sized::<N, 4, 5, 8>(knots, points, j, t),
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
    match (degree, out) {
        (3, [a, b]) => [*a, *b] = jet(degree, knots, points, j, t),
        (3, [a, b, c]) => [*a, *b, *c] = jet(degree, knots, points, j, t),
        (3, [a, b, c, d]) => [*a, *b, *c, *d] = jet(degree, knots, points, j, t),
        (0..=7, out) => derivatives_long::<N, 8>(degree, knots, points, j, t, out),
        (_, out) => derivatives_long::<N, { MAX_DEGREE + 1 }>(degree, knots, points, j, t, out),
    }
}

/// The value and K − 1 derivatives at `t` in span `j`, for K known at compile time; fastest for degrees 2 and 3.
#[inline]
pub(crate) fn jet<const N: usize, const K: usize>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    j: usize,
    t: f64,
) -> [[f64; N]; K] {
    if degree == 3
        && K <= 4
        && let (Some(points), Some(u)) = (local(points, j), local(knots, j))
        && t < u[3]
    {
        return jet_cubic(u, points, t);
    }
    if degree == 2
        && K <= 3
        && let (Some(points), Some(u)) = (local(points, j), local(knots, j))
        && t < u[2]
    {
        return jet_quadratic(u, points, t);
    }
    let mut out = [[0.0; N]; K];
    match degree {
        0..=7 => derivatives_long::<N, 8>(degree, knots, points, j, t, &mut out),
        _ => derivatives_long::<N, { MAX_DEGREE + 1 }>(degree, knots, points, j, t, &mut out),
    }
    out
}

/// The weights on points from the weights on their differences.
#[inline(always)]
fn on_points_2([a, b]: [f64; 2]) -> [f64; 3] {
    [-a, a - b, b]
}

/// How far `t` has come along a distance between knots, all of which is exactly 1.
#[inline(always)]
fn part(from: f64, width: f64, over: f64) -> f64 {
    if from == width { 1.0 } else { from * over }
}

/// The basis functions of fixed degree P up to 3 and, as weights on the P differences of its control points, what
/// gives its derivatives of order 1 and 2.
#[inline(always)]
pub(crate) fn jet_weights<const P: usize, const Q: usize, const U: usize>(
    u: &[f64; U],
    t: f64,
) -> ([f64; Q], [[f64; P]; 2]) {
    let (mut n, mut d) = ([0.0; Q], [[0.0; P]; 2]);
    let width = |a: usize, b: usize| u[b] - u[a];
    match P {
        1 => {
            let w = width(0, 1);
            let x = part(t - u[0], w, 1.0 / w);
            n.copy_from_slice(&[1.0 - x, x]);
            d[0].copy_from_slice(&[1.0 / w]);
        }
        2 => {
            let (w1, w2) = (width(1, 2), [width(0, 2), width(1, 3)]);
            let (o1, o2) = (1.0 / w1, w2.map(|w| 1.0 / w));
            let x = part(t - u[1], w1, o1);
            let n1 = [1.0 - x, x];
            let x2 = [part(t - u[0], w2[0], o2[0]), part(t - u[1], w2[1], o2[1])];
            n.copy_from_slice(&quadratic(n1, x2));
            let s = o2.map(|w| 2.0 * w);
            d[0].copy_from_slice(&[n1[0] * s[0], n1[1] * s[1]]);
            d[1].copy_from_slice(&[-o1 * s[0], o1 * s[1]]);
        }
        3 => {
            let w1 = width(2, 3);
            let (w2, w3) = ([width(1, 3), width(2, 4)], [width(0, 3), width(1, 4), width(2, 5)]);
            let (o1, o2, o3) = (1.0 / w1, w2.map(|w| 1.0 / w), w3.map(|w| 1.0 / w));
            let from = [t - u[0], t - u[1], t - u[2]];
            let x = part(from[2], w1, o1);
            let n1 = [1.0 - x, x];
            let n2 = quadratic(n1, [part(from[1], w2[0], o2[0]), part(from[2], w2[1], o2[1])]);
            let x3 = [part(from[0], w3[0], o3[0]), part(from[1], w3[1], o3[1]), part(from[2], w3[2], o3[2])];
            n.copy_from_slice(&cubic(n2, x3));
            let s = o3.map(|w| 3.0 * w);
            d[0].copy_from_slice(&[n2[0] * s[0], n2[1] * s[1], n2[2] * s[2]]);
            let second = on_points_2([2.0 * n1[0] * o2[0], 2.0 * n1[1] * o2[1]]);
            d[1].copy_from_slice(&[second[0] * s[0], second[1] * s[1], second[2] * s[2]]);
        }
        _ => {
            n = [f64::NAN; Q];
            d = [[f64::NAN; P]; 2];
        }
    }
    (n, d)
}

/// The basis functions of a cubic and, as weights on the three differences of its four control points, what gives
/// its derivatives of order 1, 2 and 3, for `t` before the end of the span. One division for each of the six knot
/// distances.
#[inline(always)]
fn cubic_weights(u: &[f64; 6], t: f64) -> ([f64; 4], [[f64; 3]; 3]) {
    let over = |a: usize, b: usize| 1.0 / (u[b] - u[a]);
    let (w1, w2, w3) = (over(2, 3), [over(1, 3), over(2, 4)], [over(0, 3), over(1, 4), over(2, 5)]);
    let from = [t - u[0], t - u[1], t - u[2]];
    let x = from[2] * w1;
    let n1 = [1.0 - x, x];
    let n2 = quadratic(n1, [from[1] * w2[0], from[2] * w2[1]]);
    let n3 = cubic(n2, [from[0] * w3[0], from[1] * w3[1], from[2] * w3[2]]);
    let s = w3.map(|w| 3.0 * w);
    let r = w2.map(|w| 2.0 * w);
    let first = [n2[0] * s[0], n2[1] * s[1], n2[2] * s[2]];
    let second = on_points_2([n1[0] * r[0], n1[1] * r[1]]);
    let third = on_points_2([-w1 * r[0], w1 * r[1]]);
    let scaled = |c: [f64; 3]| [c[0] * s[0], c[1] * s[1], c[2] * s[2]];
    (n3, [first, scaled(second), scaled(third)])
}

#[inline(always)]
fn jet_cubic<const N: usize, const K: usize>(u: &[f64; 6], points: &[[f64; N]; 4], t: f64) -> [[f64; N]; K] {
    let (n, d) = cubic_weights(u, t);
    let difference = |i: usize| -> [f64; N] { std::array::from_fn(|c| points[i + 1][c] - points[i][c]) };
    let differences = [difference(0), difference(1), difference(2)];
    std::array::from_fn(|k| match k {
        0 => weighted(&n, points),
        1..=3 => weighted(&d[k - 1], &differences),
        _ => [0.0; N],
    })
}

#[inline(always)]
fn jet_quadratic<const N: usize, const K: usize>(
    u: &[f64; 4],
    points: &[[f64; N]; 3],
    t: f64,
) -> [[f64; N]; K] {
    let (w1, w2) = (1.0 / (u[2] - u[1]), [1.0 / (u[2] - u[0]), 1.0 / (u[3] - u[1])]);
    let x = (t - u[1]) * w1;
    let n1 = [1.0 - x, x];
    let n2 = quadratic(n1, [(t - u[0]) * w2[0], (t - u[1]) * w2[1]]);
    let s = w2.map(|w| 2.0 * w);
    let difference = |i: usize| -> [f64; N] { std::array::from_fn(|c| points[i + 1][c] - points[i][c]) };
    let differences = [difference(0), difference(1)];
    std::array::from_fn(|k| match k {
        0 => weighted(&n2, points),
        1 => weighted(&[n1[0] * s[0], n1[1] * s[1]], &differences),
        2 => weighted(&[-w1 * s[0], w1 * s[1]], &differences),
        _ => [0.0; N],
    })
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
#[inline(always)]
pub(crate) fn divided<const K: usize>(d: &[[f64; 4]; K]) -> [[f64; 3]; K] {
    let mut out = [[0.0; 3]; K];
    let (Some(first), Some(d0)) = (out.first_mut(), d.first()) else { return out };
    let w = d0[3];
    *first = [d0[0] / w, d0[1] / w, d0[2] / w];
    let over = 1.0 / w;
    for k in 1..K {
        let mut v = [d[k][0], d[k][1], d[k][2]];
        let mut choose = 1.0;
        for i in 1..=k {
            choose = if i == k { 1.0 } else { choose * (k - i + 1) as f64 / i as f64 };
            let factor = choose * d[i][3];
            v = std::array::from_fn(|c| v[c] - out[k - i][c] * factor);
        }
        out[k] = v.map(|x| x * over);
    }
    out
}

/// The quotient rule for a point and its two first partial derivatives.
#[inline(always)]
pub(crate) fn divided_partials(d: &[[f64; 4]; 3]) -> [[f64; 3]; 3] {
    let [point, u, v] = d;
    let w = point[3];
    let (over, at) = (1.0 / w, [point[0] / w, point[1] / w, point[2] / w]);
    let part = |d: &[f64; 4]| std::array::from_fn(|c| (d[c] - at[c] * d[3]) * over);
    [at, part(u), part(v)]
}
