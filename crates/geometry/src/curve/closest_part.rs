//! Parts of Bézier curves prepared for questions about the squared distance to a point.
//!
//! With control points relative to a centre, the squared distance times the squared weight has Bernstein coefficients
//! that are linear in 1, r and r·r, where r is the point asked about from the centre: what stands beside each is
//! computed once. Coefficients bound the polynomial, and when they only fall and then only rise it has one minimum
//! (the variation diminishing property; G. Farin, *Curves and Surfaces for CAGD*, ch. 5).

use crate::MAX_DEGREE;
use crate::bernstein::{binomial, jet};
use crate::box_tree::{Bounds, bounds_of};
use crate::curve::thresholds::{MINIMUM_MARGIN, NEWTON_SMALL, PART_NOISE, RELATIVE_TIE};
use crate::thresholds;

/// A part of a Bézier curve of degree p, as a range of tables.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part {
    /// The piece of the curve that it belongs to.
    pub(super) piece: u32,
    degree: u32,
    /// Its range in 0…1 over the piece.
    pub(super) range: [f64; 2],
    centre: [f64; 3],
    /// The largest distance of a control point from the centre.
    radius: f64,
    points: u32,
    products: u32,
    rational: bool,
}

/// The tables of all parts.
#[derive(Debug, Clone, Default)]
pub(super) struct Parts {
    pub(super) list: Vec<Part>,
    /// Homogeneous control points, relative to the centre; the largest weight is 1.
    points: Vec<[f64; 4]>,
    /// The coefficients of degree 2p of |A|², A·w (three) and w².
    products: Vec<[f64; 5]>,
}

/// The best point found so far.
#[derive(Debug, Clone, Copy)]
pub(super) struct Best {
    /// Its squared distance.
    pub(super) squared: f64,
    pub(super) piece: u32,
    /// Its place in 0…1 over the piece.
    pub(super) place: f64,
}

impl Best {
    pub(super) fn offer(&mut self, squared: f64, piece: u32, place: f64) {
        if squared < self.squared {
            *self = Self { squared, piece, place };
        }
    }
}

/// How often a span may be halved beforehand.
const DEEPEST_PREPARED: u32 = 4;

impl Parts {
    /// Adds a Bézier curve over a range of a piece, halved until its control polygon is not much longer than its
    /// chord when `halve` is set; gives the bounds of each new part to `bounds`.
    pub(super) fn push(
        &mut self,
        piece: u32,
        points: &[[f64; 4]],
        range: [f64; 2],
        halve: bool,
        bounds: &mut Vec<Bounds>,
    ) {
        let mut work = [[0.0; 4]; MAX_DEGREE + 1];
        let Some(slots) = work.get_mut(..points.len()) else { return };
        slots.copy_from_slice(points);
        self.push_halved(piece, slots, range, if halve { 0 } else { DEEPEST_PREPARED }, bounds);
    }

    fn push_halved(
        &mut self,
        piece: u32,
        points: &mut [[f64; 4]],
        range: [f64; 2],
        depth: u32,
        bounds: &mut Vec<Bounds>,
    ) {
        if points.is_empty() {
            return;
        }
        if depth < DEEPEST_PREPARED && bent(points) {
            let mut left = [[0.0; 4]; MAX_DEGREE + 1];
            let n = points.len();
            for level in 0..n {
                left[level] = points[0];
                for i in 0..n - 1 - level {
                    points[i] = std::array::from_fn(|c| 0.5 * (points[i][c] + points[i + 1][c]));
                }
            }
            let middle = 0.5 * (range[0] + range[1]);
            self.push_halved(piece, &mut left[..n], [range[0], middle], depth + 1, bounds);
            self.push_halved(piece, points, [middle, range[1]], depth + 1, bounds);
            return;
        }
        let p = points.len() - 1;
        let space = points.iter().map(|&[x, y, z, w]| [x / w, y / w, z / w]);
        let hull = bounds_of(space.clone());
        let centre: [f64; 3] = std::array::from_fn(|c| 0.5 * (hull[0][c] + hull[1][c]));
        let from_centre = |s: [f64; 3]| (0..3).map(|c| (s[c] - centre[c]).powi(2)).sum::<f64>().sqrt();
        let radius = space.map(from_centre).fold(0.0, f64::max);
        let heaviest = points.iter().fold(0.0_f64, |m, c| m.max(c[3]));
        let rational = points.iter().any(|c| c[3] != heaviest);
        let (first_point, first_product) = (self.points.len() as u32, self.products.len() as u32);
        for &[x, y, z, w] in &*points {
            let v = w / heaviest;
            let s = [x / w, y / w, z / w];
            self.points.push([(s[0] - centre[0]) * v, (s[1] - centre[1]) * v, (s[2] - centre[2]) * v, v]);
        }
        let mut row = [0.0; MAX_DEGREE + 1];
        row.iter_mut().take(p + 1).enumerate().for_each(|(i, r)| *r = binomial(p, i));
        let local = &self.points[first_point as usize..];
        for k in 0..=2 * p {
            let mut sum = [0.0; 5];
            for i in k.saturating_sub(p)..=k.min(p) {
                let (a, b, s) = (&local[i], &local[k - i], row[i] * row[k - i]);
                sum[0] += s * (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
                (0..3).for_each(|c| sum[c + 1] += s * a[c] * b[3]);
                sum[4] += s * a[3] * b[3];
            }
            let all = binomial(2 * p, k);
            self.products.push(sum.map(|x| x / all));
        }
        bounds.push(hull);
        self.list.push(Part {
            piece,
            degree: p as u32,
            range,
            centre,
            radius,
            points: first_point,
            products: first_product,
            rational,
        });
    }

    /// Improves `best` by the nearest point of part `i` to `q`, if it is nearer.
    ///
    /// Branch and bound on the coefficients: a range is discarded when they prove it no nearer than the best, or
    /// solved when they prove one minimum there. `budget` counts the ranges that may be looked at.
    pub(super) fn search(&self, i: usize, q: [f64; 3], best: &mut Best, budget: &mut u32) {
        let Some(part) = self.list.get(i) else { return };
        let p = part.degree as usize;
        match (part.rational, p) {
            (false, 0..=3) => self.search_sized::<7, 1>(part, q, best, budget),
            (false, 4..=7) => self.search_sized::<15, 1>(part, q, best, budget),
            (false, _) => self.search_sized::<{ 2 * MAX_DEGREE + 1 }, 1>(part, q, best, budget),
            (true, 0..=3) => self.search_sized::<7, 2>(part, q, best, budget),
            (true, 4..=7) => self.search_sized::<15, 2>(part, q, best, budget),
            (true, _) => self.search_sized::<{ 2 * MAX_DEGREE + 1 }, 2>(part, q, best, budget),
        }
    }

    fn search_sized<const M: usize, const C: usize>(
        &self,
        part: &Part,
        q: [f64; 3],
        best: &mut Best,
        budget: &mut u32,
    ) {
        let p = part.degree as usize;
        let (first, point) = (part.products as usize, part.points as usize);
        let (Some(products), Some(points)) =
            (self.products.get(first..=first + 2 * p), self.points.get(point..=point + p))
        else {
            return;
        };
        let r: [f64; 3] = std::array::from_fn(|c| q[c] - part.centre[c]);
        let rr = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
        let mut c = [[0.0; C]; M];
        for (slot, m) in c.iter_mut().zip(products) {
            let cross = r[0] * m[1] + r[1] * m[2] + r[2] * m[3];
            let n = m[0] - 2.0 * cross + rr * m[4];
            *slot = std::array::from_fn(|k| if k == 0 { n } else { m[4] });
        }
        // What rounding may have done to a coefficient, as a part of the weight that stands with it.
        let noise = PART_NOISE * (part.radius + rr.sqrt()).powi(2);
        let search = Search { points, r, part, noise };
        if !best.squared.is_finite() {
            // The coefficients are judged against a bar.
            best.offer(search.squared(0.5), part.piece, search.place(0.5));
        }
        search.range(&c, [0.0, 1.0], 0, best, budget);
    }
}

/// Whether a curve turns so much, or moves so unevenly, that it is better halved.
fn bent(points: &[[f64; 4]]) -> bool {
    let at = |i: usize| points[i];
    let space = |[x, y, z, w]: [f64; 4]| [x / w, y / w, z / w];
    let gap = |a: [f64; 3], b: [f64; 3]| {
        ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2) + (a[2] - b[2]).powi(2)).sqrt()
    };
    let n = points.len();
    let polygon: f64 = (1..n).map(|i| gap(space(at(i - 1)), space(at(i)))).sum();
    polygon > 1.03 * gap(space(at(0)), space(at(n - 1)))
}

/// The search in one part.
struct Search<'s> {
    points: &'s [[f64; 4]],
    r: [f64; 3],
    part: &'s Part,
    noise: f64,
}

impl Search<'_> {
    /// Looks at the range a…b of the part, with the coefficients over it: squared distance times w², and w² where
    /// C is 2. The recursion ends at depth 50.
    fn range<const M: usize, const C: usize>(
        &self,
        c: &[[f64; C]; M],
        [a, b]: [f64; 2],
        depth: u32,
        best: &mut Best,
        budget: &mut u32,
    ) {
        let last = 2 * self.part.degree as usize;
        *budget = budget.saturating_sub(1);
        let (least, shape) = self.judge(c, last, best.squared);
        if least >= 0.0 {
            return;
        }
        if let Some(start) = shape {
            let x = a + (b - a) * start;
            let Some(found) = self.minimum([a, b], x, best) else {
                // The curve stands still there, which says nothing about the range.
                return self.halves(c, [a, b], depth, best, budget);
            };
            if C == 1 {
                return;
            }
            // A quotient: with the bar at the value found, the numerator less bar times denominator is 0 and level
            // there; if that is its one minimum, nothing in the range is below the bar (W. Dinkelbach, Management
            // Science 13, 1967).
            let (least, shape) = self.judge(c, last, best.squared);
            let found_best = found <= best.squared * (1.0 + RELATIVE_TIE);
            if least >= 0.0 || (found_best && shape.is_some()) {
                return;
            }
        }
        self.halves(c, [a, b], depth, best, budget);
    }

    /// Looks at both halves of a range, unless it is so small that they tell nothing new.
    fn halves<const M: usize, const C: usize>(
        &self,
        c: &[[f64; C]; M],
        [a, b]: [f64; 2],
        depth: u32,
        best: &mut Best,
        budget: &mut u32,
    ) {
        let last = 2 * self.part.degree as usize;
        if depth >= 50 || *budget == 0 {
            return;
        }
        let middle = 0.5 * (a + b);
        best.offer(self.squared(middle), self.part.piece, self.place(middle));
        if self.is_level(c, last) {
            return;
        }
        let (mut left, mut right) = ([[0.0; C]; M], *c);
        for level in 0..=last {
            left[level] = right[0];
            for i in 0..last - level {
                right[i] = std::array::from_fn(|k| 0.5 * (right[i][k] + right[i + 1][k]));
            }
        }
        let lowest = |c: &[[f64; C]; M]| c.iter().take(last + 1).fold(f64::INFINITY, |m, c| m.min(c[0]));
        if lowest(&left) <= lowest(&right) {
            self.range(&left, [a, middle], depth + 1, best, budget);
            self.range(&right, [middle, b], depth + 1, best, budget);
        } else {
            self.range(&right, [middle, b], depth + 1, best, budget);
            self.range(&left, [a, middle], depth + 1, best, budget);
        }
    }

    /// For the coefficients less `bar` times those of the weight: how far the least is above what could matter (a
    /// bound 2·10⁻¹³ below the best distance counts as equal, rounding as against us), and, when they fall and then
    /// rise, about where they turn.
    #[inline]
    fn judge<const M: usize, const C: usize>(
        &self,
        c: &[[f64; C]; M],
        last: usize,
        bar: f64,
    ) -> (f64, Option<f64>) {
        let weight = |k: usize| if C == 1 { 1.0 } else { c[k][C - 1] };
        let tie = bar * (1.0 - MINIMUM_MARGIN);
        let mut before = c[0][0] - tie * weight(0);
        let (mut least, mut lowest) = (before, 0);
        let mut margin = before - self.noise * weight(0);
        let (mut rising, mut one) = (false, true);
        for k in 1..=last {
            let here = c[k][0] - tie * weight(k);
            if here < before {
                one &= !rising;
            } else if here > before {
                rising = true;
            }
            if here < least {
                (least, lowest) = (here, k);
            }
            margin = margin.min(here - self.noise * weight(k));
            before = here;
        }
        if !one {
            return (margin, None);
        }
        // The zero of the polygon of differences.
        let value = |k: usize| c[k][0] - tie * weight(k);
        let start = if lowest == 0 {
            0.0
        } else if lowest == last {
            1.0
        } else {
            let (down, up) = (value(lowest) - value(lowest - 1), value(lowest + 1) - value(lowest));
            (lowest as f64 - 1.0 + down / (down - up)) / (last as f64 - 1.0)
        };
        (margin, Some(if start.is_finite() { start.clamp(0.0, 1.0) } else { 0.5 }))
    }

    /// Whether the coefficients differ by no more than rounding may: halving tells nothing new then, and around a
    /// minimum that was found it would go on for as long as the budget lasts.
    fn is_level<const M: usize, const C: usize>(&self, c: &[[f64; C]; M], last: usize) -> bool {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for c in c.iter().take(last + 1) {
            let value = if C == 1 { c[0] } else { c[0] / c[C - 1] };
            low = low.min(value);
            high = high.max(value);
        }
        high - low <= 4.0 * self.noise
    }

    fn place(&self, x: f64) -> f64 {
        let [a, b] = self.part.range;
        (1.0 - x) * a + x * b
    }

    /// The vector from the point asked about, and two derivatives, by de Casteljau's algorithm.
    fn jet(&self, x: f64) -> [[f64; 3]; 3] {
        match self.points.len() {
            0..=4 => self.jet_sized::<4>(x),
            5..=8 => self.jet_sized::<8>(x),
            _ => self.jet_sized::<{ MAX_DEGREE + 1 }>(x),
        }
    }

    fn jet_sized<const M: usize>(&self, x: f64) -> [[f64; 3]; 3] {
        let out = jet::<M>(self.points, x);
        let [w0, w1, w2] = out.map(|o| o[3]);
        if !self.part.rational {
            return std::array::from_fn(|k| {
                std::array::from_fn(|c| if k == 0 { out[0][c] - self.r[c] } else { out[k][c] })
            });
        }
        let at: [f64; 3] = std::array::from_fn(|c| out[0][c] / w0);
        let first: [f64; 3] = std::array::from_fn(|c| (out[1][c] - at[c] * w1) / w0);
        let second = std::array::from_fn(|c| (out[2][c] - 2.0 * first[c] * w1 - at[c] * w2) / w0);
        [std::array::from_fn(|c| at[c] - self.r[c]), first, second]
    }

    fn squared(&self, x: f64) -> f64 {
        let [v, _, _] = self.jet(x);
        v[0] * v[0] + v[1] * v[1] + v[2] * v[2]
    }

    /// Offers a minimum of the distance in a…b, and gives its square: Newton's method from x, kept in a bracket.
    /// `None` when what it ends at may be no minimum, because the curve stands still there.
    fn minimum(&self, [a, b]: [f64; 2], mut x: f64, best: &mut Best) -> Option<f64> {
        let dot = |u: &[f64; 3], v: &[f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
        let (mut low, mut high, mut before) = (a, b, 2.0 * (b - a));
        for _ in 0..100 {
            let [v, d1, d2] = self.jet(x);
            best.offer(dot(&v, &v), self.part.piece, self.place(x));
            let slope = dot(&v, &d1);
            let rate = dot(&d1, &d1) + dot(&v, &d2);
            if slope < 0.0 {
                low = x;
            } else if slope > 0.0 || rate > 0.0 {
                high = x;
            } else {
                return None;
            }
            let mut next = (x - slope / rate).clamp(a, b);
            // Steps that do not shrink by halves may go to and fro for ever.
            let newton = rate > 0.0 && low <= next && next <= high && (next - x).abs() <= 0.5 * before;
            if !newton {
                next = 0.5 * (low + high);
            }
            before = (next - x).abs();
            x = next;
            // After a Newton step this small the next is below rounding.
            if before <= thresholds::NEWTON_DONE || (newton && before <= NEWTON_SMALL) || !(low < high) {
                break;
            }
        }
        let [v, d1, d2] = self.jet(x);
        let found = dot(&v, &v);
        best.offer(found, self.part.piece, self.place(x));
        let (slope, rate) = (dot(&v, &d1), dot(&d1, &d1) + dot(&v, &d2));
        // Where the curve starts or ends with a speed of zero the slope is rounding, and its sign says nothing.
        let reach = self.part.radius + self.r.iter().map(|r| r * r).sum::<f64>().sqrt();
        let least = self.points.iter().fold(f64::INFINITY, |least, point| least.min(point[3]));
        let rounding = thresholds::FEW_ROUNDINGS * self.part.degree as f64 * reach * found.sqrt() / least;
        let at_end = (x <= a && slope > rounding) || (x >= b && slope < -rounding);
        // On the curve the distance is 0, and no point is nearer.
        (rate > 0.0 || at_end || found == 0.0).then_some(found)
    }
}
