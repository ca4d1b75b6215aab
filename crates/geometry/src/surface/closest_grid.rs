//! Grids of Bernstein coefficients: products, halves, values, convexity.

use crate::bernstein::binomial;

/// Halves a line of control points, with `stride` between them, at its middle: what is left is the second half, the
/// first goes to `other`.
pub(super) fn halve(
    points: &mut [[f64; 4]],
    stride: usize,
    count: usize,
    start: usize,
    other: &mut [[f64; 4]],
) {
    for level in 0..count {
        other[start + level * stride] = points[start];
        for i in 0..count - 1 - level {
            let (a, b) = (points[start + i * stride], points[start + (i + 1) * stride]);
            points[start + i * stride] = std::array::from_fn(|c| 0.5 * (a[c] + b[c]));
        }
    }
}

/// The Bernstein coefficients, of twice the degrees, of a bilinear product of two points of the grid.
pub(super) fn multiply<const K: usize>(
    [p, q]: [usize; 2],
    points: &[[f64; 4]],
    product: impl Fn(&[f64; 4], &[f64; 4]) -> [f64; K],
    out: &mut Vec<[f64; K]>,
) {
    let row = |n: usize| -> Vec<f64> { (0..=n).map(|i| binomial(n, i)).collect() };
    let (bp, bq, ap, aq) = (row(p), row(q), row(2 * p), row(2 * q));
    for k in 0..=2 * p {
        for l in 0..=2 * q {
            let mut sum = [0.0; K];
            for i in k.saturating_sub(p)..=k.min(p) {
                for j in l.saturating_sub(q)..=l.min(q) {
                    let s = bp[i] * bp[k - i] * bq[j] * bq[l - j];
                    let v = product(&points[i * (q + 1) + j], &points[(k - i) * (q + 1) + l - j]);
                    sum = std::array::from_fn(|c| sum[c] + s * v[c]);
                }
            }
            out.push(sum.map(|x| x / (ap[k] * aq[l])));
        }
    }
}

/// The Bernstein coefficients of the derivative in one direction, for a grid of the given degrees.
pub(super) fn derivative(grid: &[f64], [p, q]: [usize; 2], d: usize) -> Vec<f64> {
    let width = q + 1;
    if d == 0 {
        grid.iter().zip(grid.iter().skip(width)).map(|(a, b)| p as f64 * (b - a)).collect()
    } else {
        grid.chunks(width).flat_map(|row| row.windows(2).map(|w| q as f64 * (w[1] - w[0]))).collect()
    }
}

/// The Bernstein coefficients of the product of two grids, whose degrees add up.
pub(super) fn product(a: &[f64], da: [usize; 2], b: &[f64], db: [usize; 2]) -> Vec<f64> {
    let row = |n: usize| -> Vec<f64> { (0..=n).map(|i| binomial(n, i)).collect() };
    // Times its binomials a grid multiplies like power coefficients.
    let scaled = |g: &[f64], [p, q]: [usize; 2]| -> Vec<f64> {
        let (bp, bq) = (row(p), row(q));
        let rows = g.chunks(q + 1).zip(&bp);
        rows.flat_map(|(line, s)| line.iter().zip(&bq).map(move |(x, t)| x * s * t)).collect()
    };
    let (a, b) = (scaled(a, da), scaled(b, db));
    let degrees = [da[0] + db[0], da[1] + db[1]];
    let width = degrees[1] + 1;
    let mut out = vec![0.0; (degrees[0] + 1) * width];
    for (i, line) in a.chunks(da[1] + 1).enumerate() {
        for (k, other) in b.chunks(db[1] + 1).enumerate() {
            for (j, x) in line.iter().enumerate() {
                let start = (i + k) * width + j;
                for (slot, y) in out.iter_mut().skip(start).zip(other) {
                    *slot += x * y;
                }
            }
        }
    }
    let (bp, bq) = (row(degrees[0]), row(degrees[1]));
    for (line, s) in out.chunks_mut(width).zip(&bp) {
        for (x, t) in line.iter_mut().zip(&bq) {
            *x /= s * t;
        }
    }
    out
}

/// Halves a grid of coefficients in one direction by de Casteljau's algorithm: what is left is the second half, the
/// first is returned.
pub(super) fn halve_grid(grid: &mut [f64], [p, q]: [usize; 2], d: usize) -> Vec<f64> {
    let mut other = grid.to_vec();
    let (lines, jump, stride, count) =
        if d == 0 { (q + 1, 1, q + 1, p + 1) } else { (p + 1, q + 1, 1, q + 1) };
    for line in 0..lines {
        let start = line * jump;
        for level in 0..count {
            other[start + level * stride] = grid[start];
            for i in 0..count - 1 - level {
                let k = start + i * stride;
                grid[k] = 0.5 * (grid[k] + grid[k + stride]);
            }
        }
    }
    other
}

/// Whether coefficients less `bar` times those of the weight prove a convex function: both second derivatives are
/// positive and their least product is above the greatest square of the mixed one.
pub(super) fn convex<const C: usize>(c: &[[f64; C]], [m, n]: [usize; 2], bar: f64) -> bool {
    let h = |k: usize, l: usize| {
        let c = &c[k * n + l];
        if C == 1 { c[0] } else { c[0] - bar * c[C - 1] }
    };
    let (mut uu, mut vv, mut uv) = (f64::INFINITY, f64::INFINITY, 0.0_f64);
    let (p, q) = ((m - 1) as f64, (n - 1) as f64);
    for k in 1..m - 1 {
        for l in 0..n {
            uu = uu.min(h(k - 1, l) - 2.0 * h(k, l) + h(k + 1, l));
        }
    }
    if !(uu > 0.0) {
        return false;
    }
    for k in 0..m {
        for l in 1..n - 1 {
            vv = vv.min(h(k, l - 1) - 2.0 * h(k, l) + h(k, l + 1));
        }
    }
    if !(vv > 0.0) {
        return false;
    }
    for k in 1..m {
        for l in 1..n {
            uv = uv.max((h(k, l) - h(k - 1, l) - h(k, l - 1) + h(k - 1, l - 1)).abs());
        }
    }
    uu * vv * (p * (p - 1.0)) * (q * (q - 1.0)) > (uv * p * q).powi(2)
}
