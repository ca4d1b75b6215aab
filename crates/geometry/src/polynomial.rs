//! Sums, products and derivatives of polynomials in Bernstein form over 0…1, and all their roots there.

use crate::bernstein::{BUDGET, binomial, halves, value};
use crate::thresholds;

/// Where all coefficients are 0 to rounding, a range of 0…1 that is narrower gives its middle as a root.
const NARROW: f64 = 1e-3;
/// A range of 0…1 that is no longer is not halved again.
const SHORTEST: f64 = 1e-14;

/// A polynomial by its Bernstein coefficients; one coefficient is a constant.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Polynomial(Vec<f64>);

impl Polynomial {
    pub(crate) fn new(coefficients: Vec<f64>) -> Self {
        Self(if coefficients.is_empty() { vec![0.0] } else { coefficients })
    }

    pub(crate) fn constant(value: f64) -> Self {
        Self(vec![value])
    }

    pub(crate) fn coefficients(&self) -> &[f64] {
        &self.0
    }

    pub(crate) fn degree(&self) -> usize {
        self.0.len() - 1
    }

    /// The largest coefficient: a bound of the polynomial over 0…1.
    pub(crate) fn size(&self) -> f64 {
        self.0.iter().fold(0.0, |m, c| m.max(c.abs()))
    }

    pub(crate) fn at(&self, x: f64) -> f64 {
        match self.0.as_slice() {
            [only] => *only,
            _ => value(&self.0.iter().map(|&c| [c]).collect::<Vec<_>>(), x)[0],
        }
    }

    /// The product: Bernstein coefficients times binomials multiply like power coefficients (R. Farouki and
    /// V. Rajan, *Algorithms for polynomials in Bernstein form*, CAGD 5, 1988).
    pub(crate) fn times(&self, other: &Self) -> Self {
        let (n, m) = (self.degree(), other.degree());
        if n == 0 || m == 0 {
            let (one, all) = if n == 0 { (self, other) } else { (other, self) };
            return all.scaled(one.0.first().copied().unwrap_or(0.0));
        }
        let scaled = |c: &[f64]| -> Vec<f64> {
            let mut b = 1.0;
            let n = c.len() - 1;
            c.iter()
                .enumerate()
                .map(|(i, x)| {
                    let out = x * b;
                    b = b * (n - i) as f64 / (i + 1) as f64;
                    out
                })
                .collect()
        };
        let (a, b) = (scaled(&self.0), scaled(&other.0));
        let mut out = vec![0.0; n + m + 1];
        for (i, x) in a.iter().enumerate() {
            for (slot, y) in out.iter_mut().skip(i).zip(&b) {
                *slot += x * y;
            }
        }
        for (k, c) in out.iter_mut().enumerate() {
            *c /= binomial(n + m, k);
        }
        Self(out)
    }

    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self(self.0.iter().map(|c| c * factor).collect())
    }

    /// The same polynomial with at least this degree.
    pub(crate) fn raised(&self, degree: usize) -> Self {
        match degree.checked_sub(self.degree()) {
            None | Some(0) => self.clone(),
            Some(_) if self.degree() == 0 => Self(vec![self.0.first().copied().unwrap_or(0.0); degree + 1]),
            Some(more) => self.times(&Self(vec![1.0; more + 1])),
        }
    }

    fn combined(&self, other: &Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let degree = self.degree().max(other.degree());
        let (a, b) = (self.raised(degree), other.raised(degree));
        Self(a.0.iter().zip(&b.0).map(|(&x, &y)| f(x, y)).collect())
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        self.combined(other, |x, y| x + y)
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        self.combined(other, |x, y| x - y)
    }

    /// The derivative by x.
    pub(crate) fn derivative(&self) -> Self {
        let n = self.degree() as f64;
        Self::new(self.0.windows(2).map(|w| n * (w[1] - w[0])).collect())
    }

    /// All roots in 0…1, in order, each once. Coefficients up to `noise` count as zero: a polynomial that stays below
    /// it over more than 1/1000 of the range has no roots there to speak of, and one that touches zero within it has
    /// one.
    ///
    /// Halving until the coefficients change sign at most once, which is exactly one root (the variation of the
    /// coefficients bounds the number of roots, and has its parity), then bisection.
    pub(crate) fn roots(&self, noise: f64) -> Vec<f64> {
        let mut out: Vec<f64> = Vec::new();
        if !self.0.iter().all(|c| c.is_finite()) || self.size() <= noise {
            return out;
        }
        let mut stack = vec![(self.0.iter().map(|&c| [c]).collect::<Vec<_>>(), 0.0, 1.0)];
        let mut budget = BUDGET;
        while let Some((c, a, b)) = stack.pop() {
            budget -= 1;
            if budget == 0 {
                break;
            }
            let flat = |x: f64| x.abs() <= noise;
            if c.iter().all(|x| flat(x[0])) {
                if b - a < NARROW {
                    out.push(0.5 * (a + b));
                }
                continue;
            }
            let (first, last) = (c.first().map_or(0.0, |x| x[0]), c.last().map_or(0.0, |x| x[0]));
            let mut changes = 0;
            let mut sign = 0.0;
            for x in &c {
                if !flat(x[0]) {
                    if sign * x[0] < 0.0 {
                        changes += 1;
                    }
                    sign = x[0].signum();
                }
            }
            if changes == 0 {
                if flat(first) {
                    out.push(a);
                }
                if flat(last) {
                    out.push(b);
                }
                continue;
            }
            if b - a < SHORTEST {
                out.push(0.5 * (a + b));
                continue;
            }
            if changes == 1 && !flat(first) && !flat(last) {
                let (mut low, mut high) = (0.0, 1.0);
                for _ in 0..56 {
                    let middle = 0.5 * (low + high);
                    if (value(&c, middle)[0] < 0.0) == (first < 0.0) {
                        low = middle;
                    } else {
                        high = middle;
                    }
                }
                out.push(a + (b - a) * 0.5 * (low + high));
                continue;
            }
            let middle = 0.5 * (a + b);
            let (left, right) = halves(&c);
            stack.push((right, middle, b));
            stack.push((left, a, middle));
        }
        out.sort_by(f64::total_cmp);
        out.dedup_by(|x, y| (*x - *y).abs() <= thresholds::SAME_PARAMETER);
        out
    }

    /// Whether the polynomial is at most `limit` all over 0…1, decided by halving `depth` times at most.
    pub(crate) fn stays_below(&self, limit: f64, depth: u32) -> bool {
        let mut stack = vec![(self.0.iter().map(|&c| [c]).collect::<Vec<_>>(), 0)];
        while let Some((c, level)) = stack.pop() {
            if c.iter().all(|x| x[0] <= limit) {
                continue;
            }
            let ends = [c.first(), c.last()];
            // NaN is not below.
            if level >= depth || ends.iter().flatten().any(|x| !(x[0] <= limit)) {
                return false;
            }
            let (left, right) = halves(&c);
            stack.push((left, level + 1));
            stack.push((right, level + 1));
        }
        true
    }
}

/// Three polynomials as a vector.
pub(crate) type VectorPolynomial = [Polynomial; 3];

pub(crate) fn dot(a: &VectorPolynomial, b: &VectorPolynomial) -> Polynomial {
    let [x, y, z] = [0, 1, 2].map(|i| a[i].times(&b[i]));
    x.plus(&y).plus(&z)
}

pub(crate) fn cross(a: &VectorPolynomial, b: &VectorPolynomial) -> VectorPolynomial {
    let part = |i: usize, j: usize| a[i].times(&b[j]).minus(&a[j].times(&b[i]));
    [part(1, 2), part(2, 0), part(0, 1)]
}

/// The polynomials of a Bézier curve with homogeneous control points: weight, and w² times the derivative by x,
/// N′w − Nw′. Without weights these are the plain ones.
pub(crate) struct Hodograph {
    pub(crate) weight: Polynomial,
    pub(crate) tangent: VectorPolynomial,
}

impl Hodograph {
    pub(crate) fn new(points: &[[f64; 4]]) -> Self {
        let row = |c: usize| Polynomial::new(points.iter().map(|p| p[c]).collect());
        let numerator = [row(0), row(1), row(2)];
        let first = points.first().map_or(1.0, |p| p[3]);
        if points.iter().all(|p| p[3] == first) {
            let tangent = [0, 1, 2].map(|i| numerator[i].derivative().scaled(first));
            return Self { weight: Polynomial::constant(first), tangent };
        }
        let weight = row(3);
        let dw = weight.derivative();
        let tangent =
            [0, 1, 2].map(|i| numerator[i].derivative().times(&weight).minus(&numerator[i].times(&dw)));
        Self { weight, tangent }
    }
}

#[cfg(test)]
mod tests {
    use super::Polynomial;

    #[test]
    fn algebra_agrees_with_values() {
        let a = Polynomial::new(vec![1.0, -2.0, 0.5, 3.0]);
        let b = Polynomial::new(vec![0.3, 4.0, -1.0]);
        for k in 0..=10 {
            let x = f64::from(k) / 10.0;
            assert!((a.times(&b).at(x) - a.at(x) * b.at(x)).abs() < 1e-13);
            assert!((a.plus(&b).at(x) - a.at(x) - b.at(x)).abs() < 1e-13);
            assert!((a.minus(&b).at(x) - a.at(x) + b.at(x)).abs() < 1e-13);
            let slope = (a.at(x + 1e-6) - a.at(x - 1e-6)) / 2e-6;
            assert!((a.derivative().at(x) - slope).abs() < 1e-6);
        }
    }

    #[test]
    fn roots_simple_double_and_at_the_ends() {
        let linear = |r: f64| Polynomial::new(vec![-r, 1.0 - r]);
        let product = |rs: &[f64]| rs.iter().fold(Polynomial::constant(1.0), |p, &r| p.times(&linear(r)));
        let close = |found: Vec<f64>, wanted: &[f64], tolerance: f64| {
            assert_eq!(found.len(), wanted.len(), "{found:?}");
            assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < tolerance), "{found:?}");
        };
        close(product(&[0.1, 0.3, 0.35, 0.9]).roots(1e-15), &[0.1, 0.3, 0.35, 0.9], 1e-10);
        close(product(&[0.0, 0.4, 1.0]).roots(1e-15), &[0.0, 0.4, 1.0], 1e-12);
        close(product(&[0.37, 0.37]).roots(1e-14), &[0.37], 1e-6);
        close(product(&[2.0, -1.0]).roots(1e-15), &[], 1.0);
        close(Polynomial::constant(0.0).roots(1e-15), &[], 1.0);
    }

    #[test]
    fn bounds_are_decided_by_halving() {
        let p = Polynomial::new(vec![0.0, 2.0, 0.0]);
        assert!(p.stays_below(1.0, 20));
        assert!(!p.stays_below(0.99, 20));
        assert!(!Polynomial::new(vec![f64::NAN, 0.0]).stays_below(1.0, 3));
    }
}
