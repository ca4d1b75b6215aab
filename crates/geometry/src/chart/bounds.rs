//! Bounds on the derivatives of a surface over a part of its domain.

use super::{Chart, Patch};
use crate::Vector3;
use crate::nurbs::MAX_DEGREE;

/// What a control point is off after one step of de Casteljau's algorithm, as a part of the largest of the net: three
/// rounded operations.
const STEP_ROUNDING: f64 = 3.0 * f64::EPSILON;
/// What a product of three terms is off, as a part of the sum of the sizes of the factors of one side times the largest of the
/// other: five rounded operations, and three for factors that were rounded sums themselves.
const DOT_ROUNDING: f64 = 8.0 * f64::EPSILON;

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

    /// How far its numbers are from one at most.
    pub(crate) fn off(self, x: f64) -> f64 {
        (self.high - x).max(x - self.low)
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

/// Derivatives of a part of one patch: the coefficients that bound them.
#[derive(Debug)]
struct Part {
    /// The homogeneous derivatives by u, then by v, the origin being moved to the middle of the part where there are weights.
    slopes: [Vec<[f64; 4]>; 2],
    /// What rounding adds to a coefficient of either.
    error: [f64; 2],
    /// The control points as the middle sees them, what rounding adds to these, and the weights; none where all are 1.
    weighted: Option<Weighted>,
}

#[derive(Debug)]
struct Weighted {
    room: Vec<[f64; 3]>,
    error: f64,
    weight: Range,
}

/// The derivatives of a surface over a part of its domain.
#[derive(Debug)]
pub(crate) struct Slopes {
    parts: Vec<Part>,
}

impl Slopes {
    /// Bounds on the derivatives by u and v, each multiplied by a vector. They are rounded outward, so that they hold for the
    /// exact derivatives.
    ///
    /// The coefficients are multiplied first: what is the same for all of them adds nothing. The sizes are the sums of the
    /// components of each vector, or of the terms of which these were rounded sums.
    pub(crate) fn along(&self, vectors: [Vector3; 2], sizes: [f64; 2]) -> [Range; 2] {
        [0, 1].map(|k| {
            let own = self.parts.iter().map(|part| part.along(k, vectors[k], sizes[k]));
            own.fold(Range::EMPTY, Range::union)
        })
    }
}

impl Slopes {
    /// Bounds on the lengths of the derivatives by u and v.
    pub(crate) fn lengths(&self) -> [f64; 2] {
        [0, 1].map(|k| self.parts.iter().map(|part| part.length(k)).fold(0.0, f64::max))
    }
}

impl Part {
    /// A bound on the length of a derivative.
    fn length(&self, k: usize) -> f64 {
        let largest = |lengths: &mut dyn Iterator<Item = f64>| lengths.fold(0.0, f64::max);
        let length = |x: f64, y: f64, z: f64| (x * x + y * y + z * z).sqrt();
        // Each component is off by the error, and a length by less than twice that and its own rounding.
        let out = |length: f64, error: f64| (length + 2.0 * error) * (1.0 + DOT_ROUNDING);
        let own = out(largest(&mut self.slopes[k].iter().map(|p| length(p[0], p[1], p[2]))), self.error[k]);
        let Some(Weighted { room, error, weight }) = &self.weighted else { return own };
        if !(weight.low > 0.0) {
            return f64::INFINITY;
        }
        let place = out(largest(&mut room.iter().map(|p| length(p[0], p[1], p[2]))), *error);
        let weight_slope = largest(&mut self.slopes[k].iter().map(|p| p[3].abs())) + self.error[k];
        (own + place * weight_slope) / weight.low * (1.0 + DOT_ROUNDING)
    }

    fn along(&self, k: usize, vector: Vector3, size: f64) -> Range {
        let row: [f64; 3] = vector.into();
        let dot = |p: &[f64]| row[0] * p[0] + row[1] * p[1] + row[2] * p[2];
        let (mut slope, mut largest, mut weight_slope) = (Range::EMPTY, 0.0_f64, Range::EMPTY);
        for p in &self.slopes[k] {
            slope.add(dot(&p[..3]));
            weight_slope.add(p[3]);
            largest = largest.max(p[0].abs()).max(p[1].abs()).max(p[2].abs());
        }
        let slope = slope.grown(size * (self.error[k] + DOT_ROUNDING * largest));
        let Some(Weighted { room, error, weight }) = &self.weighted else { return slope };
        if !(weight.low > 0.0) {
            return Range { low: f64::NEG_INFINITY, high: f64::INFINITY };
        }
        let (mut place, mut far) = (Range::EMPTY, 0.0_f64);
        for p in room {
            place.add(dot(p));
            far = far.max(p[0].abs()).max(p[1].abs()).max(p[2].abs());
        }
        let place = place.grown(size * (error + DOT_ROUNDING * far));
        let inverse = Range { low: 1.0 / weight.high, high: 1.0 / weight.low }.outward();
        slope.minus(place.times(weight_slope.grown(self.error[k]))).times(inverse)
    }
}

impl Chart {
    /// The derivatives by u and v over ranges of the parameters, as far as they lie in the domain.
    ///
    /// A part of each patch that the ranges meet is cut out by de Casteljau's algorithm; the differences of its control
    /// points bound the derivatives. With weights, after a shift of the origin to the middle of the part,
    /// S′ = (P′ − S w′)/w is bounded term by term.
    pub(crate) fn slopes_over(&self, ranges: [[f64; 2]; 2]) -> Slopes {
        let spans = [0, 1].map(|k| {
            let lines = &self.nets.lines[k];
            let last = lines.len().saturating_sub(2);
            let first = lines.partition_point(|t| *t <= ranges[k][0]).saturating_sub(1).min(last);
            let end = lines.partition_point(|t| *t < ranges[k][1]).saturating_sub(1).clamp(first, last);
            first..=end
        });
        let columns = self.nets.lines[1].len() - 1;
        let mut parts = Vec::with_capacity(1);
        for i in spans[0].clone() {
            for j in spans[1].clone() {
                parts.push(part(self.patch(i * columns + j), self.counts, ranges));
            }
        }
        Slopes { parts }
    }
}

/// The derivatives of a patch over the part of it that ranges of the parameters meet.
fn part(patch: Patch<'_>, counts: [usize; 2], ranges: [[f64; 2]; 2]) -> Part {
    let [n, m] = counts;
    crate::cancellation::worked(n * m / 4 + 1);
    let local = |k: usize| {
        let [a, b] = patch.ranges[k];
        ranges[k].map(|t| ((t - a) / (b - a)).clamp(0.0, 1.0))
    };
    let mut net = patch.points.to_vec();
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
    let weighted = net.iter().any(|p| p[3] != 1.0).then(|| {
        let middle = net[(n / 2) * m + m / 2];
        let center: [f64; 3] = std::array::from_fn(|c| middle[c] / middle[3]);
        let mut weight = Range::EMPTY;
        let mut room = Vec::with_capacity(net.len());
        for p in &mut net {
            weight.add(p[3]);
            for c in 0..3 {
                p[c] -= center[c] * p[3];
            }
            room.push(std::array::from_fn(|c| p[c] / p[3]));
        }
        let weight = weight.grown(rounding);
        // Weights near 0 bound nothing.
        Weighted { room, error: rounding / weight.low.max(0.0), weight }
    });
    let scales = [0, 1].map(|k| {
        let width = patch.ranges[k][1] - patch.ranges[k][0];
        let part = if k == 0 { x[1] - x[0] } else { y[1] - y[0] };
        // A range without width has the derivative of the patch: never asked for by a search, so any bound holds.
        (counts[k] as f64 - 1.0) / (width * part.max(f64::MIN_POSITIVE))
    });
    let slopes = [0, 1].map(|k| {
        let step = if k == 0 { m } else { 1 };
        let mut out = Vec::with_capacity(n * m);
        for i in 0..n - usize::from(k == 0) {
            for j in 0..m - usize::from(k == 1) {
                let at = i * m + j;
                out.push(std::array::from_fn(|c| (net[at + step][c] - net[at][c]) * scales[k]));
            }
        }
        out
    });
    Part { slopes, error: scales.map(|s| 2.0 * rounding * s), weighted }
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
    use crate::{Direction, Interval, Plane, Sphere, Surface, Torus, Vector3};

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
                let slopes = chart.slopes_over(ranges);
                let lengths = slopes.lengths();
                let rows = [Vector3::X, Vector3::new(0.3, -0.8, 0.5), Vector3::new(-2.0, 1.0, 7.0)];
                let bounds =
                    rows.map(|row| slopes.along([row; 2], [row.x.abs() + row.y.abs() + row.z.abs(); 2]));
                for k in 0..=10 {
                    for l in 0..=10 {
                        let at = |r: [f64; 2], k: i32| r[0] + (r[1] - r[0]) * f64::from(k) / 10.0;
                        let jet = chart.jet([at(ranges[0], k), at(ranges[1], l)]);
                        for d in 0..2 {
                            let length = jet[d + 1].length();
                            assert!(lengths[d] >= length * (1.0 - 1e-13), "{i} {step} {k} {l}");
                            assert!(
                                width >= 0.1 || lengths[d] < 1.4 * length + 0.1,
                                "{} {length}",
                                lengths[d]
                            );
                            for (bound, row) in bounds.iter().zip(rows) {
                                let own = jet[d + 1].dot(row);
                                let slack = 1e-13 * (1.0 + own.abs());
                                assert!(bound[d].low <= own + slack, "{i} {step} {k} {l}");
                                assert!(bound[d].high >= own - slack, "{i} {step} {k} {l}");
                                if width < 0.1 {
                                    let near = 0.4 * row.length() * (1.0 + jet[d + 1].length());
                                    assert!(bound[d].off(own) < near);
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
