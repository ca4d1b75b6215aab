//! Polynomials by their Bernstein coefficients: their smallest and largest coefficients bound them, and halving makes
//! the bounds close in quadratically.

/// A range of 0…1 that is no longer is not halved again: its ends are neighbours.
const SHORTEST: f64 = 1e-15;

/// A search that halves more often than this is lost in rounding noise: ordinary ones take some hundred halvings.
pub(crate) const BUDGET: u32 = 20_000;

/// C(n, k) as a number.
pub(crate) fn binomial(n: usize, k: usize) -> f64 {
    (0..k.min(n - k.min(n))).fold(1.0, |c, i| c * (n - i) as f64 / (i + 1) as f64)
}

/// The coefficients of the two halves, by de Casteljau's algorithm at 1/2.
pub(crate) fn halves<const N: usize>(coefficients: &[[f64; N]]) -> (Vec<[f64; N]>, Vec<[f64; N]>) {
    let mut row = coefficients.to_vec();
    let n = row.len();
    let mut left = Vec::with_capacity(n);
    for level in 0..n {
        left.push(row[0]);
        for i in 0..n - 1 - level {
            row[i] = std::array::from_fn(|c| 0.5 * (row[i][c] + row[i + 1][c]));
        }
    }
    // What is left behind in `row`, from its end, are the points of the right half.
    (left, row)
}

/// The value at x in 0…1 and the first two derivatives there, by de Casteljau's algorithm, whose last two levels hold
/// them. For up to M coefficients; more are left out.
#[inline]
pub(crate) fn jet<const M: usize>(coefficients: &[[f64; 4]], x: f64) -> [[f64; 4]; 3] {
    let n = coefficients.len().min(M);
    let p = n as f64 - 1.0;
    let mut d = [[0.0; 4]; M];
    d[..n].copy_from_slice(&coefficients[..n]);
    let mut out = [[0.0; 4]; 3];
    let y = 1.0 - x;
    for level in 1..n {
        if level + 2 == n {
            out[2] = std::array::from_fn(|c| p * (p - 1.0) * (d[2][c] - 2.0 * d[1][c] + d[0][c]));
        } else if level + 1 == n {
            out[1] = std::array::from_fn(|c| p * (d[1][c] - d[0][c]));
        }
        for i in 0..n - level {
            d[i] = std::array::from_fn(|c| y * d[i][c] + x * d[i + 1][c]);
        }
    }
    out[0] = d[0];
    out
}

/// The value at x in 0…1, by de Casteljau's algorithm.
pub(crate) fn value<const N: usize>(coefficients: &[[f64; N]], x: f64) -> [f64; N] {
    let mut row = coefficients.to_vec();
    while row.len() > 1 {
        for i in 0..row.len() - 1 {
            row[i] = std::array::from_fn(|c| (1.0 - x) * row[i][c] + x * row[i + 1][c]);
        }
        row.pop();
    }
    row.first().copied().unwrap_or([0.0; N])
}

/// For a Bézier curve with homogeneous control points: the coefficients, of twice its degree, of the squared distance
/// to `q` times w², and of w². Their quotient is the squared distance.
pub(crate) fn squared_distance(points: &[[f64; 4]], q: crate::Point3) -> Vec<[f64; 2]> {
    let p = points.len().saturating_sub(1);
    let a: Vec<[f64; 4]> =
        points.iter().map(|&[x, y, z, w]| [x - w * q.x, y - w * q.y, z - w * q.z, w]).collect();
    let row: Vec<f64> = (0..=p).map(|i| binomial(p, i)).collect();
    let mut out = vec![[0.0; 2]; 2 * p + 1];
    for (i, u) in a.iter().enumerate() {
        for (j, v) in a.iter().enumerate() {
            let share = row[i] * row[j];
            out[i + j][0] += share * (u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
            out[i + j][1] += share * u[3] * v[3];
        }
    }
    for (k, c) in out.iter_mut().enumerate() {
        let b = binomial(2 * p, k);
        *c = [c[0] / b, c[1] / b];
    }
    out
}

/// The smallest x in 0…1, beyond `after`, at which a polynomial that starts below 0 reaches it, found by halving;
/// `None` when it stays below.
pub(crate) fn first_rise(coefficients: &[f64], after: f64) -> Option<f64> {
    if !coefficients.iter().all(|c| c.is_finite()) {
        return None;
    }
    let mut stack = vec![(coefficients.iter().map(|&c| [c]).collect::<Vec<_>>(), 0.0, 1.0)];
    let mut budget = BUDGET;
    while let Some((c, a, b)) = stack.pop() {
        budget -= 1;
        if budget == 0 {
            return None;
        }
        if b <= after || c.iter().all(|x| x[0] < 0.0) {
            continue;
        }
        if b - a < SHORTEST || 0.5 * (a + b) == a {
            return Some(b.max(after));
        }
        let middle = 0.5 * (a + b);
        let (left, right) = halves(&c);
        stack.push((right, middle, b));
        stack.push((left, a, middle));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::{binomial, first_rise, halves, value};

    #[test]
    fn binomials() {
        assert_eq!(
            [binomial(0, 0), binomial(5, 2), binomial(6, 6), binomial(62, 31)].map(f64::round)[1],
            10.0
        );
        assert_eq!(binomial(6, 6), 1.0);
    }

    #[test]
    fn halves_agree_with_the_whole() {
        let c = [[1.0], [-4.0], [7.0], [2.0]];
        let (left, right) = halves(&c);
        for x in [0.0, 0.25, 1.0] {
            assert!((value(&left, x)[0] - value(&c, 0.5 * x)[0]).abs() < 1e-14);
            assert!((value(&right, x)[0] - value(&c, 0.5 + 0.5 * x)[0]).abs() < 1e-14);
        }
    }

    #[test]
    fn first_rise_is_the_first() {
        // (x − 0.25)(x − 0.75)·(−1) has Bernstein coefficients below; it rises at 0.25 and falls at 0.75.
        let f = |x: f64| -(x - 0.25) * (x - 0.75);
        let c = [f(0.0), 2.0 * f(0.5) - 0.5 * (f(0.0) + f(1.0)), f(1.0)];
        assert!((first_rise(&c, 0.0).unwrap_or(9.0) - 0.25).abs() < 1e-12);
        assert_eq!(first_rise(&[-1.0, -0.5, -1.0], 0.0), None);
    }
}
