//! Evaluation at many parameters: where several in a row lie in one span, the span's Bézier form is made once.
//!
//! A Bézier form costs as much as some six points; after that a point is p steps of Horner's scheme for Bernstein
//! polynomials, v ← v (1 − s) + C(p, i) sⁱ bᵢ, which is exact at both ends of the span and as stable as de
//! Casteljau's algorithm. Several parameters go through it side by side (`lanes`); each has the bits that it has alone.

use super::blossom::blossom;
use super::evaluate::{de_boor, divided, find_span, jet};
use super::lanes::{Coordinates, Homogeneous, Place, side_by_side};
use super::{NurbsCurve, curve::Controls};
use crate::bernstein::binomial;
use crate::{Point3, Vector3};

/// How many parameters are worked on together, and by one thread: some 50 µs of work. Runs end at the border, so
/// that results do not depend on the number of threads.
const CHUNK: usize = 8192;

/// Fewer parameters than this in one span are evaluated one by one.
const SHORT_RUN: usize = 8;

/// The highest degree that has a Bézier form here.
const MAX_RUN_DEGREE: usize = 5;

/// A span's Bernstein coefficients, each times its binomial coefficient, and the map of the span onto 0…1.
#[derive(Clone, Copy)]
pub(super) struct Span<const N: usize> {
    pub(super) points: [[f64; N]; MAX_RUN_DEGREE + 1],
    pub(super) low: f64,
    pub(super) width: f64,
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
    pub(super) fn at<const P: usize>(&self, s: f64) -> [f64; N] {
        let r = 1.0 - s;
        let mut v = self.points[0];
        let mut power = 1.0;
        for i in 1..=P {
            power *= s;
            v = std::array::from_fn(|c| v[c] * r + self.points[i][c] * power);
        }
        v
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
fn many<const N: usize, F: Place<N>>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    parameters: &[f64],
    out: &mut [Point3],
) {
    match degree {
        1 => runs::<N, F, 1>(knots, points, parameters, out),
        2 => runs::<N, F, 2>(knots, points, parameters, out),
        3 => runs::<N, F, 3>(knots, points, parameters, out),
        4 => runs::<N, F, 4>(knots, points, parameters, out),
        5 => runs::<N, F, 5>(knots, points, parameters, out),
        _ => {
            for (&t, slot) in parameters.iter().zip(out) {
                *slot = F::point(de_boor(degree, knots, points, find_span(knots, degree, t), t));
            }
        }
    }
}

fn runs<const N: usize, F: Place<N>, const P: usize>(
    knots: &[f64],
    points: &[[f64; N]],
    mut parameters: &[f64],
    mut out: &mut [Point3],
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
            Some(span) if n >= SHORT_RUN => side_by_side::<N, F, P>(&span, these, places),
            _ => {
                for (slot, &t) in places.iter_mut().zip(these) {
                    *slot = F::point(de_boor(P, knots, points, j, t));
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
            Controls::Plain(c) => many::<3, Coordinates>(p, knots, c, t, out),
            Controls::Rational(c) => many::<4, Homogeneous>(p, knots, c, t, out),
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
