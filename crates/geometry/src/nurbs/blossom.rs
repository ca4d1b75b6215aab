//! Control points for new knots by blossoming.
//!
//! Each polynomial piece of degree p has a symmetric function of p arguments, its blossom, and the control point of
//! any knot vector over the same piece is the blossom of p consecutive knots (L. Ramshaw, *Blossoming: a
//! connect-the-dots approach to splines*, DEC SRC report 19, 1987). Knot insertion, clamping, trimming, Bézier pieces
//! and degree raising are all this one evaluation.

use super::evaluate::mix;
use super::knots::{MAX_DEGREE, span_index};

/// The blossom of the piece in span `j`, at `degree` arguments: the triangle of de Boor with one argument a level.
pub(crate) fn blossom<const N: usize>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    j: usize,
    arguments: impl Iterator<Item = f64>,
) -> [f64; N] {
    let mut d = [[0.0; N]; MAX_DEGREE + 1];
    let (Some(local), Some(u)) = (points.get(j..=j + degree), knots.get(j..j + 2 * degree)) else {
        return [f64::NAN; N];
    };
    d[..=degree].copy_from_slice(local);
    for (level, t) in (1..=degree).zip(arguments) {
        for i in 0..=degree - level {
            let (a, b) = (u[i + level - 1], u[i + degree]);
            d[i] = mix(&d[i], &d[i + 1], (t - a) / (b - a));
        }
    }
    d[0]
}

/// A parameter inside a span on which control point `i` of a curve with `new_knots` acts: the span nearest to the
/// middle of its support.
fn inner_parameter(new_degree: usize, new_knots: &[f64], count: usize, i: usize) -> Option<f64> {
    let (first, last) = (new_degree - 1, count - 1);
    let middle = i as f64 + (new_degree as f64 - 2.0) / 2.0;
    (i.saturating_sub(1).max(first)..(i + new_degree).min(last))
        .filter(|&k| new_knots[k] < new_knots[k + 1])
        .min_by(|&a, &b| (a as f64 - middle).abs().total_cmp(&(b as f64 - middle).abs()))
        .map(|k| 0.5 * (new_knots[k] + new_knots[k + 1]))
}

/// The control points that describe the same curve over `new_knots`, a refinement of `knots` on the new domain.
pub(crate) fn over_knots<const N: usize>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    new_knots: &[f64],
) -> Option<Vec<[f64; N]>> {
    let count = (new_knots.len() + 1).checked_sub(degree)?;
    let mut out = Vec::with_capacity(count);
    for i in 0..count {
        let arguments = new_knots.get(i..i + degree)?;
        let j = span_index(knots, degree, inner_parameter(degree, new_knots, count, i)?, false);
        // Where nothing changes the old control point stays, to the last bit.
        let kept = (j..=j + degree).find(|&c| knots.get(c..c + degree) == Some(arguments));
        out.push(match kept.and_then(|c| points.get(c)) {
            Some(&p) => p,
            None => blossom(degree, knots, points, j, arguments.iter().copied()),
        });
    }
    Some(out)
}

/// The control points of the same curve with the degree raised by one, over `new_knots`: the raised blossom is the
/// mean of the old one with each argument left out in turn.
pub(crate) fn raised<const N: usize>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    new_knots: &[f64],
) -> Option<Vec<[f64; N]>> {
    let new_degree = degree + 1;
    let count = (new_knots.len() + 1).checked_sub(new_degree)?;
    let mut out = Vec::with_capacity(count);
    for i in 0..count {
        let arguments = new_knots.get(i..i + new_degree)?;
        let j = span_index(knots, degree, inner_parameter(new_degree, new_knots, count, i)?, false);
        let mut sum = [0.0; N];
        for left_out in 0..new_degree {
            let others = arguments.iter().enumerate().filter(|&(k, _)| k != left_out).map(|(_, &t)| t);
            let p = blossom(degree, knots, points, j, others);
            sum = std::array::from_fn(|c| sum[c] + p[c]);
        }
        out.push(sum.map(|x| x / new_degree as f64));
    }
    Some(out)
}
