//! Evaluation at many parameters: where several in a row lie in one span, the span's Bézier form is made once.
//!
//! A Bézier form costs as much as some six points; after that a point is p steps of Horner's scheme for Bernstein
//! polynomials, v ← v (1 − s) + C(p, i) sⁱ bᵢ, which is exact at both ends of the span and as stable as de
//! Casteljau's algorithm. Four parameters go through it side by side, so that the compiler puts two or four of them into
//! one instruction; each has the bits that it has alone.

use super::blossom::blossom;
use super::evaluate::{de_boor, divided, find_span, jet};
use super::{NurbsCurve, curve::Controls, curve::project};
use crate::bernstein::binomial;
use crate::{Point3, Vector3};

/// How many parameters are worked on together, and by one thread: some 50 µs of work. Runs end at the border, so
/// that results do not depend on the number of threads.
const CHUNK: usize = 8192;

/// Fewer parameters than this in one span are evaluated one by one.
const SHORT_RUN: usize = 8;

/// Parameters that go through Horner's scheme side by side.
const LANES: usize = 4;

/// The highest degree that has a Bézier form here.
const MAX_RUN_DEGREE: usize = 5;

/// A span's Bernstein coefficients, each times its binomial coefficient, and the map of the span onto 0…1.
#[derive(Clone, Copy)]
struct Span<const N: usize> {
    points: [[f64; N]; MAX_RUN_DEGREE + 1],
    low: f64,
    width: f64,
}

impl<const N: usize> Span<N> {
    fn new(degree: usize, knots: &[f64], points: &[[f64; N]], j: usize) -> Option<Self> {
        let (low, high) = (*knots.get(j + degree - 1)?, *knots.get(j + degree)?);
        let mut out = Self { points: [[0.0; N]; MAX_RUN_DEGREE + 1], low, width: high - low };
        for (i, slot) in out.points.get_mut(..=degree)?.iter_mut().enumerate() {
            // The blossom of p − i times the start and i times the end is Bézier point i.
            let arguments = std::iter::repeat_n(low, degree - i).chain(std::iter::repeat_n(high, i));
            *slot = blossom(degree, knots, points, j, arguments).map(|x| x * binomial(degree, i));
        }
        Some(out)
    }

    /// The same for the derivative by the curve's parameter, one degree lower.
    fn derivative(&self, degree: usize) -> Self {
        let mut out = *self;
        if degree == 0 {
            out.points = [[0.0; N]; MAX_RUN_DEGREE + 1];
            return out;
        }
        for i in 0..degree {
            // C(p, i) bᵢ is what is stored: p Δbᵢ C(p − 1, i) = (i + 1) C(p, i + 1) bᵢ₊₁ − (p − i) C(p, i) bᵢ.
            out.points[i] = std::array::from_fn(|c| {
                ((i + 1) as f64 * self.points[i + 1][c] - (degree - i) as f64 * self.points[i][c])
                    / self.width
            });
        }
        out
    }

    /// The value for fixed degree P.
    #[inline(always)]
    fn at<const P: usize>(&self, s: f64) -> [f64; N] {
        let r = 1.0 - s;
        let mut v = self.points[0];
        let mut power = 1.0;
        for i in 1..=P {
            power *= s;
            v = std::array::from_fn(|c| v[c] * r + self.points[i][c] * power);
        }
        v
    }

    /// [`Span::at`] for several places, coordinate by coordinate: the same operations in the same order.
    #[inline(always)]
    fn at_lanes<const P: usize>(&self, s: &[f64; LANES]) -> [[f64; LANES]; N] {
        let r = s.map(|s| 1.0 - s);
        let mut v = self.points[0].map(|x| [x; LANES]);
        let mut power = [1.0; LANES];
        for i in 1..=P {
            power = std::array::from_fn(|k| power[k] * s[k]);
            v = std::array::from_fn(|c| {
                std::array::from_fn(|k| v[c][k] * r[k] + self.points[i][c] * power[k])
            });
        }
        v
    }

    /// The values at many parameters of this span.
    #[inline(always)]
    fn all<T, const P: usize>(&self, parameters: &[f64], out: &mut [T], finish: impl Fn([f64; N]) -> T) {
        let scale = 1.0 / self.width;
        let (lanes, others) = parameters.as_chunks::<LANES>();
        let (places, last) = out.as_chunks_mut::<LANES>();
        for (slots, t) in places.iter_mut().zip(lanes) {
            let v = self.at_lanes::<P>(&t.map(|t| (t - self.low) * scale));
            *slots = std::array::from_fn(|k| finish(std::array::from_fn(|c| v[c][k])));
        }
        for (slot, &t) in last.iter_mut().zip(others) {
            *slot = finish(self.at::<P>((t - self.low) * scale));
        }
    }
}

/// The number of leading parameters in low ≤ t < high, looked at in blocks without a branch for each.
#[inline]
fn run_length(parameters: &[f64], low: f64, high: f64) -> usize {
    let inside = |t: &f64| (low <= *t) & (*t < high);
    let (blocks, _) = parameters.as_chunks::<8>();
    let whole =
        8 * blocks.iter().take_while(|block| block.iter().map(inside).fold(true, |a, b| a & b)).count();
    let rest = parameters.get(whole..).unwrap_or(&[]);
    whole + rest.iter().take_while(|t| inside(t)).count()
}

/// Evaluates at many parameters into as many places.
#[inline]
fn many<const N: usize, T>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    parameters: &[f64],
    out: &mut [T],
    finish: impl Fn([f64; N]) -> T + Copy,
) {
    match degree {
        1 => runs::<N, T, 1>(knots, points, parameters, out, finish),
        2 => runs::<N, T, 2>(knots, points, parameters, out, finish),
        3 => runs::<N, T, 3>(knots, points, parameters, out, finish),
        4 => runs::<N, T, 4>(knots, points, parameters, out, finish),
        5 => runs::<N, T, 5>(knots, points, parameters, out, finish),
        _ => {
            for (&t, slot) in parameters.iter().zip(out) {
                *slot = finish(de_boor(degree, knots, points, find_span(knots, degree, t), t));
            }
        }
    }
}

fn runs<const N: usize, T, const P: usize>(
    knots: &[f64],
    points: &[[f64; N]],
    mut parameters: &[f64],
    mut out: &mut [T],
    finish: impl Fn([f64; N]) -> T + Copy,
) {
    while let Some(&t) = parameters.first() {
        let j = find_span(knots, P, t);
        let low = knots.get(j + P - 1).copied().unwrap_or(t);
        let high = knots.get(j + P).copied().unwrap_or(t);
        // Outside the domain, and at its end, there is no run.
        let n = run_length(parameters, low, high).max(1);
        let Some((these, rest)) = parameters.split_at_checked(n) else { return };
        let Some((places, later)) = std::mem::take(&mut out).split_at_mut_checked(n) else { return };
        (parameters, out) = (rest, later);
        match Span::new(P, knots, points, j) {
            Some(span) if n >= SHORT_RUN => span.all::<T, P>(these, places, finish),
            _ => {
                for (slot, &t) in places.iter_mut().zip(these) {
                    *slot = finish(de_boor(P, knots, points, j, t));
                }
            }
        }
    }
}

/// The value and K − 1 derivatives at many parameters.
fn many_jets<const N: usize, T, const K: usize>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    mut parameters: &[f64],
    mut out: &mut [T],
    finish: impl Fn([[f64; N]; K]) -> T + Copy,
) {
    while let Some(&t) = parameters.first() {
        let j = find_span(knots, degree, t);
        let low = knots.get(j + degree - 1).copied().unwrap_or(t);
        let high = knots.get(j + degree).copied().unwrap_or(t);
        let n = run_length(parameters, low, high).max(1);
        let Some((these, rest)) = parameters.split_at_checked(n) else { return };
        let Some((places, later)) = std::mem::take(&mut out).split_at_mut_checked(n) else { return };
        (parameters, out) = (rest, later);
        let span = if n >= SHORT_RUN && degree == 3 { Span::new(degree, knots, points, j) } else { None };
        if let Some(span) = span {
            let first = span.derivative(3);
            let second = first.derivative(2);
            let third = second.derivative(1);
            let scale = 1.0 / span.width;
            for (slot, &t) in places.iter_mut().zip(these) {
                let s = (t - span.low) * scale;
                *slot = finish(std::array::from_fn(|k| match k {
                    0 => span.at::<3>(s),
                    1 => first.at::<2>(s),
                    2 => second.at::<1>(s),
                    3 => third.points[0],
                    _ => [0.0; N],
                }));
            }
        } else {
            for (slot, &t) in places.iter_mut().zip(these) {
                *slot = finish(jet(degree, knots, points, j, t));
            }
        }
    }
}

/// Calls `work` on pieces of at most [`CHUNK`] parameters with their places, in parallel with the `parallel` feature.
pub(crate) fn in_chunks<T: Send>(parameters: &[f64], out: &mut [T], work: impl Fn(&[f64], &mut [T]) + Sync) {
    #[cfg(feature = "parallel")]
    if parameters.len() >= 4 * CHUNK {
        use rayon::prelude::*;
        let pairs = parameters.par_chunks(CHUNK).zip(out.par_chunks_mut(CHUNK));
        crate::parallel::waiting(|| pairs.for_each(|(t, out)| work(t, out)));
        return;
    }
    parameters.chunks(CHUNK).zip(out.chunks_mut(CHUNK)).for_each(|(t, out)| work(t, out));
}

impl NurbsCurve {
    /// The points at many parameters, fastest when they are sorted: then every span's Bézier form is made once, and
    /// results differ from [`NurbsCurve::point_at`] by a few units in the last place. Long lists run in parallel with
    /// the `parallel` feature; the result is the same to the last bit.
    pub fn points_at(&self, parameters: &[f64]) -> Vec<Point3> {
        let mut out = vec![Point3::ORIGIN; parameters.len()];
        self.points_into(parameters, &mut out);
        out
    }

    /// [`NurbsCurve::points_at`] without allocation: as many points as there are both parameters and places.
    pub fn points_into(&self, parameters: &[f64], out: &mut [Point3]) {
        let (p, knots) = (self.degree, &self.knots);
        in_chunks(parameters, out, |t, out| match &self.controls {
            Controls::Plain(c) => many(p, knots, c, t, out, Point3::from),
            Controls::Rational(c) => many(p, knots, c, t, out, project),
        });
    }

    /// At many parameters the position, as a vector from the origin, and K − 1 derivatives: [`NurbsCurve::jet_at`] for
    /// each. Fastest when the parameters are sorted; at a knot the side that begins there is meant.
    pub fn jets_at<const K: usize>(&self, parameters: &[f64]) -> Vec<[Vector3; K]> {
        let mut out = vec![[Vector3::ZERO; K]; parameters.len()];
        self.jets_into(parameters, &mut out);
        out
    }

    /// [`NurbsCurve::jets_at`] without allocation: as many as there are both parameters and places.
    pub fn jets_into<const K: usize>(&self, parameters: &[f64], out: &mut [[Vector3; K]]) {
        let (p, knots) = (self.degree, &self.knots);
        in_chunks(parameters, out, |t, out| match &self.controls {
            Controls::Plain(c) => many_jets(p, knots, c, t, out, |d: [_; K]| d.map(Vector3::from)),
            Controls::Rational(c) => {
                many_jets(p, knots, c, t, out, |d: [_; K]| divided(&d).map(Vector3::from));
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::LANES;
    use crate::{NurbsCurve, Point3};

    /// A curve of one span: whatever the number of parameters, they are one run.
    fn arch(degree: usize, rational: bool) -> NurbsCurve {
        let corner = |i: usize| [i as f64, (i as f64 * 1.7).sin(), 0.3 * i as f64];
        let knots = [vec![0.0; degree], vec![1.0; degree]].concat();
        let made = if rational {
            let weighted = |i: usize| {
                let (w, [x, y, z]) = (1.0 + 0.25 * i as f64, corner(i));
                [x * w, y * w, z * w, w]
            };
            NurbsCurve::rational(degree, (0..=degree).map(weighted).collect(), knots)
        } else {
            NurbsCurve::new(degree, (0..=degree).map(|i| Point3::from(corner(i))).collect(), knots)
        };
        made.unwrap()
    }

    #[test]
    fn a_point_has_the_same_bits_whoever_stands_beside_it() {
        let all: Vec<f64> = (0..40).map(|i| f64::from(i) / 41.0).collect();
        for degree in 1..=5 {
            for rational in [false, true] {
                let curve = arch(degree, rational);
                // From 8 parameters on a run has a Bézier form; each shift puts a parameter into another lane.
                let whole = curve.points_at(&all);
                for shift in 0..2 * LANES {
                    assert_eq!(curve.points_at(&all[shift..]), whole[shift..], "{degree} {rational} {shift}");
                }
                for (p, &t) in whole.iter().zip(&all) {
                    assert!(p.distance_to(curve.point_at(t)) < 1e-14, "{degree} {rational} {t}");
                }
            }
        }
    }
}
