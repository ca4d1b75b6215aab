//! Polynomials in two parameters in Bernstein form, and the one that is zero on silhouettes.

use super::Viewpoint;
use crate::bernstein::binomial;
use crate::intersect::zeros::Cell;
use crate::{Direction, NurbsSurface, Point3, Vector3};

/// A polynomial over the unit square by its Bernstein coefficients times their binomials: such multiply like power
/// coefficients (R. Farouki and V. Rajan, *Algorithms for polynomials in Bernstein form*, CAGD 5, 1988).
#[derive(Debug, Clone)]
struct Scaled {
    counts: [usize; 2],
    /// v running fastest.
    values: Vec<f64>,
}

impl Scaled {
    /// From plain Bernstein coefficients.
    fn new(counts: [usize; 2], values: Vec<f64>) -> Self {
        let mut out = Self { counts, values };
        out.weigh(|x, b| x * b);
        out
    }

    fn weigh(&mut self, f: impl Fn(f64, f64) -> f64) {
        let [n, m] = self.counts;
        let rows: Vec<f64> = (0..n).map(|i| binomial(n - 1, i)).collect();
        let columns: Vec<f64> = (0..m).map(|j| binomial(m - 1, j)).collect();
        for (k, x) in self.values.iter_mut().enumerate() {
            *x = f(*x, rows[k / m] * columns[k % m]);
        }
    }

    fn times(&self, other: &Self) -> Self {
        let ([n, m], [p, q]) = (self.counts, other.counts);
        let counts = [n + p - 1, m + q - 1];
        let mut values = vec![0.0; counts[0] * counts[1]];
        for (k, x) in self.values.iter().enumerate() {
            let (i, j) = (k / m, k % m);
            for r in 0..p {
                let to = (i + r) * counts[1] + j;
                for (slot, y) in values.iter_mut().skip(to).zip(other.values.iter().skip(r * q).take(q)) {
                    *slot += x * y;
                }
            }
        }
        Self { counts, values }
    }

    /// The same polynomial with these counts, which must not be smaller.
    fn raised(&self, counts: [usize; 2]) -> Self {
        let more = [0, 1].map(|d| counts[d].saturating_sub(self.counts[d]));
        if more == [0, 0] {
            return self.clone();
        }
        self.times(&Self::new([more[0] + 1, more[1] + 1], vec![1.0; (more[0] + 1) * (more[1] + 1)]))
    }

    fn minus(&self, other: &Self) -> Self {
        let counts = [0, 1].map(|d| self.counts[d].max(other.counts[d]));
        let (a, b) = (self.raised(counts), other.raised(counts));
        Self { counts, values: a.values.iter().zip(&b.values).map(|(x, y)| x - y).collect() }
    }

    fn plus(&self, other: &Self) -> Self {
        let turned = Self { counts: other.counts, values: other.values.iter().map(|x| -x).collect() };
        self.minus(&turned)
    }

    /// Plain Bernstein coefficients.
    fn plain(mut self) -> Vec<f64> {
        self.weigh(|x, b| x / b);
        self.values
    }
}

type Vectors = [Scaled; 3];

fn cross(a: &Vectors, b: &Vectors) -> Vectors {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i].times(&b[j]).minus(&a[j].times(&b[i])))
}

fn dot(a: &Vectors, b: &Vectors) -> Scaled {
    a[0].times(&b[0]).plus(&a[1].times(&b[1])).plus(&a[2].times(&b[2]))
}

fn along(a: &Vectors, b: Vector3) -> Scaled {
    let constant = |x: f64| Scaled::new([1, 1], vec![x]);
    dot(a, &[constant(b.x), constant(b.y), constant(b.z)])
}

/// N·(towards the viewer) over a Bézier patch, times a power of the weights.
#[derive(Debug, Clone)]
pub(super) struct Form {
    ranges: [[f64; 2]; 2],
    counts: [usize; 2],
    values: Vec<f64>,
    /// Whether it is zero all over: the patch is seen edge-on.
    pub(super) level: bool,
    /// Whether it is zero along the side where u is least, greatest, where v is least, greatest.
    pub(super) zero: [bool; 4],
}

/// What is below this part of the largest that the patch could have counts as zero.
const LEVEL: f64 = 1e-11;

impl Form {
    /// Of a patch.
    pub(super) fn new(patch: &NurbsSurface, viewpoint: Viewpoint) -> Self {
        let counts = patch.counts();
        let points = patch.homogeneous_points();
        // About a point of the patch, which keeps digits far away from the origin of the world.
        let origin =
            points.first().map_or(Point3::ORIGIN, |p| Point3::new(p[0] / p[3], p[1] / p[3], p[2] / p[3]));
        let centre = [origin.x, origin.y, origin.z];
        let part = |f: &dyn Fn(&[f64; 4]) -> f64| -> Vec<f64> { points.iter().map(f).collect() };
        let plain: [Vec<f64>; 3] = [0, 1, 2].map(|c| part(&|p: &[f64; 4]| p[c] - centre[c] * p[3]));
        let weights = part(&|p: &[f64; 4]| p[3]);
        let first = weights.first().copied().unwrap_or(1.0);
        let rational = weights.iter().any(|w| *w != first);
        let a: Vectors = [0, 1, 2].map(|c| Scaled::new(counts, plain[c].clone()));
        let [au, av]: [Vectors; 2] = [0, 1].map(|d| [0, 1, 2].map(|c| derivative(counts, &plain[c], d)));
        let flat = cross(&au, &av);
        let normal: Vectors = if rational {
            let w = Scaled::new(counts, weights.clone());
            let [wu, wv] = [0, 1].map(|d| derivative(counts, &weights, d));
            let (ua, av_) = (cross(&au, &a), cross(&a, &av));
            [0, 1, 2].map(|c| w.times(&flat[c]).minus(&wv.times(&ua[c])).minus(&wu.times(&av_[c])))
        } else {
            flat.clone()
        };
        let form = match viewpoint {
            Viewpoint::Parallel(d) => along(&normal, -d),
            // Without weights the normal has one factor w less than with them.
            Viewpoint::Perspective(eye) => {
                let share = if rational { 1.0 } else { 1.0 / first };
                let depth = dot(&flat, &a);
                let depth =
                    Scaled { counts: depth.counts, values: depth.values.iter().map(|x| x * share).collect() };
                along(&normal, eye - origin).minus(&depth)
            }
        };
        let size = |values: &[f64]| values.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let most = |v: &Vectors| v.iter().map(|c| size(&c.clone().plain())).fold(0.0, f64::max);
        let reach = match viewpoint {
            Viewpoint::Parallel(_) => 1.0,
            Viewpoint::Perspective(eye) => (eye - origin).length().max(most(&a) / first.abs()),
        };
        let bound = reach * most(&au) * most(&av) * if rational { size(&weights) } else { 1.0 };
        let counts = form.counts;
        let values = form.plain();
        let ranges = Direction::BOTH.map(|d| {
            let domain = patch.domain(d);
            [domain.start, domain.end]
        });
        let level = size(&values) <= 100.0 * LEVEL * bound;
        let mut out = Self { ranges, counts, values, level, zero: [false; 4] };
        if !level {
            out.divide(LEVEL * bound.min(1e3 * size(&out.values)));
        }
        out
    }

    /// The coefficients along a side: u least, u greatest, v least, v greatest.
    fn side(&self, side: usize) -> Vec<f64> {
        let [n, m] = self.counts;
        let at = |i: usize, j: usize| self.values.get(i * m + j).copied().unwrap_or(0.0);
        match side {
            0 => (0..m).map(|j| at(0, j)).collect(),
            1 => (0..m).map(|j| at(n - 1, j)).collect(),
            2 => (0..n).map(|i| at(i, 0)).collect(),
            _ => (0..n).map(|i| at(i, m - 1)).collect(),
        }
    }

    /// Divides by u, 1 − u, v and 1 − v as often as the sides are zero: what is left is zero on the other silhouettes
    /// only. So poles and knot lines that are silhouettes do not hide them.
    fn divide(&mut self, noise: f64) {
        for side in 0..4 {
            let d = side / 2;
            while self.counts[d] > 1 && self.side(side).iter().all(|x| x.abs() <= noise) {
                self.zero[side] = true;
                let [n, m] = self.counts;
                let degree = (self.counts[d] - 1) as f64;
                let mut counts = self.counts;
                counts[d] -= 1;
                let mut values = Vec::with_capacity(counts[0] * counts[1]);
                for i in 0..counts[0] {
                    for j in 0..counts[1] {
                        let k = if d == 0 { i } else { j };
                        let (from, share) = if side % 2 == 0 {
                            (k + 1, degree / (k + 1) as f64)
                        } else {
                            (k, degree / (degree - k as f64))
                        };
                        let at = if d == 0 { from * m + j } else { i * m + from };
                        values.push(self.values.get(at).copied().unwrap_or(0.0) * share);
                    }
                }
                debug_assert!(n * m > values.len());
                (self.counts, self.values) = (counts, values);
            }
        }
    }

    /// On which side the patch is seen next to the middle of a side: 1 front, −1 behind, 0 edge-on.
    pub(super) fn sign_beside(&self, side: usize) -> i8 {
        if self.level {
            return 0;
        }
        // Another silhouette may end in one of these places.
        let values = crate::polynomial::Polynomial::new(self.side(side));
        let (a, b) = (values.at(0.5), values.at(0.37));
        match if a.abs() > b.abs() { a } else { b } {
            x if x > 0.0 => 1,
            x if x < 0.0 => -1,
            _ => 0,
        }
    }

    /// The largest coefficient.
    fn size(&self) -> f64 {
        self.values.iter().fold(0.0, |m, x| m.max(x.abs()))
    }

    /// As a cell to search, scaled to coefficients of at most 1; `None` for a patch that is edge-on.
    pub(super) fn cell(&self, index: usize) -> Option<Cell> {
        let size = self.size();
        if self.level || !(size > 0.0) || !size.is_finite() {
            return None;
        }
        let values = self.values.iter().map(|x| x / size).collect();
        Some(Cell::new(index, self.ranges, self.counts, values))
    }
}

/// The derivative by u (0) or v (1) of a polynomial with plain coefficients.
fn derivative(counts: [usize; 2], values: &[f64], d: usize) -> Scaled {
    let [n, m] = counts;
    if counts[d] < 2 {
        return Scaled::new([1, 1], vec![0.0]);
    }
    let mut smaller = counts;
    smaller[d] -= 1;
    let degree = smaller[d] as f64;
    let step = if d == 0 { m } else { 1 };
    let mut out = Vec::with_capacity(smaller[0] * smaller[1]);
    for i in 0..smaller[0] {
        for j in 0..smaller[1] {
            let at = |k: usize| values.get(k).copied().unwrap_or(0.0);
            out.push(degree * (at(i * m + j + step) - at(i * m + j)));
        }
    }
    debug_assert!(n * m >= out.len());
    Scaled::new(smaller, out)
}
