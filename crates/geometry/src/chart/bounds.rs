//! Bounds on the derivatives of a surface over a part of its domain.

use super::{Chart, Patch};
use crate::nurbs::MAX_DEGREE;

/// What a control point is off after one step of de Casteljau's algorithm, as a part of the largest of the net: three
/// rounded operations.
const STEP_ROUNDING: f64 = 3.0 * f64::EPSILON;

/// The smallest and the largest of numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Range {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

impl Range {
    pub(crate) const EMPTY: Self = Self { low: f64::INFINITY, high: f64::NEG_INFINITY };

    pub(crate) fn add(&mut self, x: f64) {
        (self.low, self.high) = (self.low.min(x), self.high.max(x));
    }

    pub(crate) fn middle(self) -> f64 {
        0.5 * (self.low + self.high)
    }

    /// Half its length.
    pub(crate) fn radius(self) -> f64 {
        0.5 * (self.high - self.low)
    }

    fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    fn times(self, other: Self) -> Self {
        let mut out = Self::EMPTY;
        for a in [self.low, self.high] {
            for b in [other.low, other.high] {
                out.add(a * b);
            }
        }
        out.outward()
    }

    fn minus(self, other: Self) -> Self {
        Self { low: self.low - other.high, high: self.high - other.low }.outward()
    }

    /// The next number below and above: what one rounded operation may be off.
    fn outward(self) -> Self {
        Self { low: self.low.next_down(), high: self.high.next_up() }
    }

    /// Grown on both sides.
    fn grown(self, by: f64) -> Self {
        Self { low: self.low - by, high: self.high + by }.outward()
    }
}

/// Bounds on the three components of a vector.
pub(crate) type Bounds3 = [Range; 3];

/// The smallest box around two.
pub(crate) fn hull(a: Bounds3, b: Bounds3) -> Bounds3 {
    std::array::from_fn(|k| a[k].union(b[k]))
}

impl Chart {
    /// Bounds on the derivatives by u and v over ranges of the parameters, as far as they lie in the domain. They are
    /// rounded outward, so that they hold for the exact derivatives.
    ///
    /// A part of each patch that the ranges meet is cut out by de Casteljau's algorithm; the differences of its control
    /// points bound the derivatives. With weights, after a shift of the origin to the middle of the part,
    /// S′ = (P′ − S w′)/w is bounded term by term.
    pub(crate) fn partials_over(&self, ranges: [[f64; 2]; 2]) -> Option<[Bounds3; 2]> {
        let spans = [0, 1].map(|k| {
            let lines = &self.lines[k];
            let last = lines.len().saturating_sub(2);
            let first = lines.partition_point(|t| *t <= ranges[k][0]).saturating_sub(1).min(last);
            let end = lines.partition_point(|t| *t < ranges[k][1]).saturating_sub(1).clamp(first, last);
            first..=end
        });
        let columns = self.lines[1].len() - 1;
        let mut out: Option<[Bounds3; 2]> = None;
        for i in spans[0].clone() {
            for j in spans[1].clone() {
                let own = self.patches.get(i * columns + j)?.partials_over(self.counts, ranges);
                out = Some(match out {
                    Some(sum) => [hull(sum[0], own[0]), hull(sum[1], own[1])],
                    None => own,
                });
            }
        }
        out
    }
}

impl Patch {
    fn partials_over(&self, counts: [usize; 2], ranges: [[f64; 2]; 2]) -> [Bounds3; 2] {
        let [n, m] = counts;
        let local = |k: usize| {
            let [a, b] = self.ranges[k];
            ranges[k].map(|t| ((t - a) / (b - a)).clamp(0.0, 1.0))
        };
        let mut net = self.points.clone();
        let [x, y] = [local(0), local(1)];
        for j in 0..m {
            restrict(&mut net, j, m, n, x);
        }
        for i in 0..n {
            restrict(&mut net, i * m, 1, m, y);
        }
        // Each direction is restricted in two runs of as many steps as its degree; the shift of the origin is one more.
        let largest = net.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
        let rounding = STEP_ROUNDING * (2 * (n + m)) as f64 * largest;
        let rational = net.iter().any(|p| p[3] != 1.0);
        let mut weight = Range { low: 1.0, high: 1.0 };
        let mut room = [Range { low: 0.0, high: 0.0 }; 3];
        if rational {
            let middle = net[(n / 2) * m + m / 2];
            let center: [f64; 3] = std::array::from_fn(|c| middle[c] / middle[3]);
            weight = Range::EMPTY;
            room = [Range::EMPTY; 3];
            for p in &mut net {
                weight.add(p[3]);
                for c in 0..3 {
                    p[c] -= center[c] * p[3];
                    room[c].add(p[c] / p[3]);
                }
            }
            weight = weight.grown(rounding);
            // Weights near 0 bound nothing.
            let least = weight.low.max(0.0);
            room = room.map(|r| r.grown(rounding / least));
        }
        [0, 1].map(|k| {
            let width = self.ranges[k][1] - self.ranges[k][0];
            let part = if k == 0 { x[1] - x[0] } else { y[1] - y[0] };
            let (count, step) = if k == 0 { (n, m) } else { (m, 1) };
            // A range without width has the derivative of the patch: never asked for by a search, so any bound holds.
            let scale = (count as f64 - 1.0) / (width * part.max(f64::MIN_POSITIVE));
            let mut slopes = [Range::EMPTY; 4];
            for i in 0..n - usize::from(k == 0) {
                for j in 0..m - usize::from(k == 1) {
                    let at = i * m + j;
                    for c in 0..4 {
                        slopes[c].add((net[at + step][c] - net[at][c]) * scale);
                    }
                }
            }
            let slopes = slopes.map(|r| r.grown(2.0 * rounding * scale));
            if !rational {
                return [slopes[0], slopes[1], slopes[2]];
            }
            if !(weight.low > 0.0) {
                return [Range { low: f64::NEG_INFINITY, high: f64::INFINITY }; 3];
            }
            let inverse = Range { low: 1.0 / weight.high, high: 1.0 / weight.low }.outward();
            std::array::from_fn(|c| slopes[c].minus(room[c].times(slopes[3])).times(inverse))
        })
    }
}

/// Replaces the row of control points from `start` in steps of `step` by that of its part `x`.
fn restrict(net: &mut [[f64; 4]], start: usize, step: usize, count: usize, x: [f64; 2]) {
    let mut row = [[0.0; 4]; MAX_DEGREE + 1];
    let count = count.min(MAX_DEGREE + 1);
    for i in 0..count {
        row[i] = net[start + i * step];
    }
    if x[1] < 1.0 {
        // What stays of the triangle on its left side is the part up to x₁.
        for level in 1..count {
            for i in (level..count).rev() {
                row[i] = std::array::from_fn(|c| row[i - 1][c] + (row[i][c] - row[i - 1][c]) * x[1]);
            }
        }
    }
    if x[0] > 0.0 {
        let y = if x[1] > 0.0 { x[0] / x[1] } else { 0.0 };
        for level in 1..count {
            for i in 0..count - level {
                row[i] = std::array::from_fn(|c| row[i][c] + (row[i + 1][c] - row[i][c]) * y);
            }
        }
    }
    for i in 0..count {
        net[start + i * step] = row[i];
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a failing test may panic")]

    use super::super::Chart;
    use crate::{Direction, Interval, Plane, Sphere, Surface, Torus};

    /// Every derivative lies within the bounds, and the bounds close in on it with the ranges.
    fn holds(surface: &Surface) {
        let chart = Chart::new(surface.to_nurbs().unwrap()).unwrap();
        let [du, dv] = Direction::BOTH.map(|d| chart.nurbs().domain(d));
        for (i, width) in [0.9, 0.2, 0.01].into_iter().enumerate() {
            for step in 0..7 {
                let part = |d: Interval| {
                    let low = (1.0 - width) * f64::from(step) / 6.0;
                    [d.at(low), d.at(low + width)]
                };
                let ranges = [part(du), part(dv)];
                let bounds = chart.partials_over(ranges).unwrap();
                for k in 0..=10 {
                    for l in 0..=10 {
                        let at = |r: [f64; 2], k: i32| r[0] + (r[1] - r[0]) * f64::from(k) / 10.0;
                        let jet = chart.jet([at(ranges[0], k), at(ranges[1], l)]);
                        for d in 0..2 {
                            let own: [f64; 3] = jet[d + 1].into();
                            for c in 0..3 {
                                let slack = 1e-13 * (1.0 + own[c].abs());
                                assert!(bounds[d][c].low <= own[c] + slack, "{i} {step} {k} {l}");
                                assert!(bounds[d][c].high >= own[c] - slack, "{i} {step} {k} {l}");
                                if width < 0.1 {
                                    assert!(bounds[d][c].radius() < 0.2 * (1.0 + jet[d + 1].length()));
                                }
                            }
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn bounds_hold_derivatives() {
        holds(&Sphere::new(Plane::XY, 2.0).unwrap().into());
        holds(&Torus::new(Plane::XY.offset(3.0), 5.0, 2.0).unwrap().into());
    }
}
