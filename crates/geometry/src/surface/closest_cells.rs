//! Ranges of a patch, and what the derivatives of the squared distance prove about minima inside them.
//!
//! With A the homogeneous control points from the point asked about and w the weight, half the derivative of the
//! squared distance by u is (A·Aᵤ w − A·A wᵤ)/w³. Its numerator is a polynomial, and so are the numerator's
//! derivatives, which where it vanishes are those of the quotient times w³: their signs tell minima from saddles.

use super::closest_grid::{derivative, halve_grid, multiply, product};
use super::closest_patch::{Range, Search};

/// The degrees of the polynomials, which are the same in all cells of a patch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Degrees {
    /// Of the slope by u and of that by v.
    slopes: [[usize; 2]; 2],
    /// Of the weight.
    weight: [usize; 2],
}

/// A range of a patch.
#[derive(Debug, Clone)]
pub(super) struct Cell {
    pub(super) range: Range,
    /// The numerators of the slopes by u and by v: coefficients over the range, derivatives by the patch's parameters.
    slopes: [Vec<f64>; 2],
    /// The weight; empty when it is 1 throughout.
    weight: Vec<f64>,
}

/// What is proved about a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Verdict {
    /// No minimum inside.
    Empty,
    /// At most one place where both slopes vanish, and that is a minimum.
    Single,
    /// The distance does not change in these directions as far as rounding shows, and in the others it has one minimum.
    Level([bool; 2]),
    /// Nothing: halve it in this direction.
    Open(usize),
}

/// The least and the greatest of some numbers.
fn bounds(grid: impl IntoIterator<Item = f64>) -> (f64, f64) {
    grid.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
}

impl Cell {
    /// The whole patch.
    pub(super) fn whole(search: &Search<'_>) -> (Self, Degrees) {
        let n = search.n;
        let double = [2 * n[0], 2 * n[1]];
        let shifted = search.shifted();
        let mut squares = Vec::with_capacity((double[0] + 1) * (double[1] + 1));
        multiply(n, &shifted, |a, b| [a[0] * b[0] + a[1] * b[1] + a[2] * b[2]], &mut squares);
        let squares: Vec<f64> = squares.into_iter().map(|[x]| x).collect();
        let lower = |[p, q]: [usize; 2], d: usize| if d == 0 { [p - 1, q] } else { [p, q - 1] };
        let half =
            |d: usize| -> Vec<f64> { derivative(&squares, double, d).iter().map(|x| 0.5 * x).collect() };
        let range = [[0.0, 1.0]; 2];
        if !search.patch.rational {
            let slopes = [lower(double, 0), lower(double, 1)];
            return (
                Self { range, slopes: [half(0), half(1)], weight: Vec::new() },
                Degrees { slopes, weight: n },
            );
        }
        let weight: Vec<f64> = shifted.iter().map(|a| a[3]).collect();
        let slope = |d: usize| -> Vec<f64> {
            let first = product(&half(d), lower(double, d), &weight, n);
            let second = product(&squares, double, &derivative(&weight, n, d), lower(n, d));
            first.iter().zip(second).map(|(a, b)| a - b).collect()
        };
        let triple = [3 * n[0], 3 * n[1]];
        let degrees = Degrees { slopes: [lower(triple, 0), lower(triple, 1)], weight: n };
        (Self { range, slopes: [slope(0), slope(1)], weight }, degrees)
    }

    /// A measure of the work of halving it.
    pub(super) fn work(&self, degrees: &Degrees) -> u64 {
        let one = |grid: &[f64], d: [usize; 2]| (grid.len() * (2 + d[0].max(d[1]))) as u64;
        16 + (0..2).map(|d| one(&self.slopes[d], degrees.slopes[d])).sum::<u64>()
    }

    /// What rounding may do to slopes here.
    pub(super) fn noise(&self, degrees: &Degrees, noise: f64) -> f64 {
        let weight =
            self.weight.iter().fold(if self.weight.is_empty() { 1.0_f64 } else { 0.0 }, |m, w| m.max(*w));
        noise * degrees.weight[0].max(degrees.weight[1]) as f64 * weight.powi(3)
    }

    /// The slope in direction `d` along the side of the patch where that parameter starts or ends, seen inwards: the
    /// distance does not fall into the patch where it is at least 0.
    pub(super) fn inward(&self, degrees: &Degrees, d: usize, at_end: bool) -> Vec<f64> {
        let n = degrees.slopes[d];
        let sign = if at_end { -1.0 } else { 1.0 };
        let (first, step) = match (d, at_end) {
            (0, false) => (0, 1),
            (0, true) => (n[0] * (n[1] + 1), 1),
            (_, false) => (0, n[1] + 1),
            (_, true) => (n[1], n[1] + 1),
        };
        let line = self.slopes[d].iter().skip(first).step_by(step).take(n[1 - d] + 1);
        line.map(|x| sign * x).collect()
    }

    pub(super) fn verdict(&self, degrees: &Degrees, noise: f64) -> Verdict {
        let noise = self.noise(degrees, noise);
        let mut level = [false; 2];
        let mut size = [0.0; 2];
        for d in 0..2 {
            let (low, high) = bounds(self.slopes[d].iter().copied());
            if low > noise || high < -noise {
                return Verdict::Empty;
            }
            level[d] = low >= -noise && high <= noise;
            size[d] = high.max(-low);
        }
        if level == [true, true] {
            return Verdict::Level(level);
        }
        let width = self.range.map(|[a, b]| b - a);
        // The second derivatives, by the patch's parameters, and what rounding may do to them.
        let second = |d: usize, e: usize| {
            let (low, high) = bounds(derivative(&self.slopes[d], degrees.slopes[d], e));
            if low > high { (0.0, 0.0) } else { (low / width[e], high / width[e]) }
        };
        let doubt = |d: usize, e: usize| 2.0 * noise * degrees.slopes[d][e] as f64 / width[e];
        let all = [[second(0, 0), second(0, 1)], [second(1, 0), second(1, 1)]];
        for d in 0..2 {
            if !level[d] && all[d][d].1 < -doubt(d, d) {
                return Verdict::Empty;
            }
            if level[d] && all[1 - d][1 - d].0 > doubt(1 - d, 1 - d) {
                return Verdict::Level(level);
            }
        }
        let largest = |(low, high): (f64, f64)| high.max(-low);
        if level == [false, false] {
            let [uu, vv, uv, vu] = [all[0][0], all[1][1], all[0][1], all[1][0]];
            let mixed = 0.5 * (largest(uv) + largest(vu));
            if uu.0 > 0.0 && vv.0 > 0.0 && uu.0 * vv.0 > mixed * mixed {
                return Verdict::Single;
            }
            // A saddle wherever the slopes vanish: the mixed derivatives are one there and outweigh the others.
            let apart = |x: (f64, f64), doubt: f64| (x.0 - doubt).max(-x.1 - doubt).max(0.0);
            let least = apart(uv, doubt(0, 1)) * apart(vu, doubt(1, 0));
            let most = (uu.1 + doubt(0, 0)).max(0.0) * (vv.1 + doubt(1, 1)).max(0.0);
            if least > most {
                return Verdict::Empty;
            }
        }
        // Across the direction in which the slopes change more. (Beside a pole that makes needles, rightly.)
        let change = |e: usize| {
            let part = |d: usize| if level[d] { 0.0 } else { largest(all[d][e]) * width[e] / size[d] };
            part(0).max(part(1))
        };
        let e = usize::from(change(1) > change(0));
        Verdict::Open(e)
    }

    /// The two halves in a direction.
    pub(super) fn halves(mut self, degrees: &Degrees, d: usize) -> [Self; 2] {
        let (mut low, mut high) = (self.range, self.range);
        let middle = 0.5 * (self.range[d][0] + self.range[d][1]);
        low[d][1] = middle;
        high[d][0] = middle;
        let slopes = [0, 1].map(|k: usize| halve_grid(&mut self.slopes[k], degrees.slopes[k], d));
        let weight =
            if self.weight.is_empty() { Vec::new() } else { halve_grid(&mut self.weight, degrees.weight, d) };
        self.range = high;
        [Self { range: low, slopes, weight }, self]
    }
}
