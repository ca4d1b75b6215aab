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

/// The blossom of old control points at `arguments`, which increase.
///
/// Arguments that are consecutive old knots cost nothing: only the others need a level of de Boor's triangle each, and
/// all its ratios lie in 0…1. A control point whose arguments are all old knots is kept to the last bit. `above` is
/// the index of the first old knot greater than the first argument. `None` when old knots lie between the arguments
/// that are not among them.
#[inline]
fn among_knots<const N: usize>(
    degree: usize,
    knots: &[f64],
    points: &[[f64; N]],
    above: usize,
    arguments: &[f64],
) -> Option<[f64; N]> {
    let &first = arguments.first()?;
    let mut extra = [0.0; MAX_DEGREE];
    let mut extras = 0;
    // Old knots first_old…after_last are arguments.
    let (mut first_old, mut after_last) = (above, above);
    for &a in arguments {
        if a == first {
            if first_old > 0 && knots.get(first_old - 1) == Some(&a) {
                first_old -= 1;
                continue;
            }
        } else {
            match knots.get(after_last) {
                Some(&k) if k == a => {
                    after_last += 1;
                    continue;
                }
                Some(&k) if k < a => return None,
                _ => {}
            }
        }
        *extra.get_mut(extras)? = a;
        extras += 1;
    }
    // The extras + 1 control points all of whose knots but some are arguments.
    let c = first_old.checked_sub(extras)?;
    match extras {
        0 => points.get(c).copied(),
        1 => {
            let (low, high) = (*knots.get(c)?, *knots.get(c + degree)?);
            Some(mix(points.get(c)?, points.get(c + 1)?, (extra[0] - low) / (high - low)))
        }
        _ => {
            let (local, u) = (points.get(c..=c + extras)?, knots.get(c..c + degree + extras)?);
            let mut d = [[0.0; N]; MAX_DEGREE + 1];
            d.get_mut(..=extras)?.copy_from_slice(local);
            for level in 1..=extras {
                for i in 0..=extras - level {
                    let (low, high) = (u[i + level - 1], u[i + degree]);
                    d[i] = mix(&d[i], &d[i + 1], (extra[level - 1] - low) / (high - low));
                }
            }
            Some(d[0])
        }
    }
}

/// The index of the first knot greater than `t`, which is `from` or above.
#[inline]
fn first_above(knots: &[f64], from: usize, t: f64) -> usize {
    let mut i = from;
    while knots.get(i).is_some_and(|&k| k <= t) {
        i += 1;
    }
    i
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
    // A short piece of a long curve must not cost a walk along all of it.
    let mut above = new_knots.first().map_or(0, |&t| knots.partition_point(|&k| k <= t));
    for i in 0..count {
        let arguments = new_knots.get(i..i + degree)?;
        above = first_above(knots, above, *arguments.first()?);
        out.push(match among_knots(degree, knots, points, above, arguments) {
            Some(p) => p,
            None => {
                let t = inner_parameter(degree, new_knots, count, i)?;
                let j = span_index(knots, degree, t, false);
                blossom(degree, knots, points, j, arguments.iter().copied())
            }
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
    let mut above = 0;
    for i in 0..count {
        let arguments = new_knots.get(i..i + new_degree)?;
        let &first = arguments.first()?;
        above = first_above(knots, above, first);
        // All but the first; then each step puts back one more and leaves out the next.
        let mut others = [0.0; MAX_DEGREE];
        let others = others.get_mut(..degree)?;
        others.copy_from_slice(&arguments[1..]);
        let mut sum = [0.0; N];
        let mut left_out = 0;
        while left_out < new_degree {
            // Equal arguments leave the same behind.
            let value = arguments[left_out];
            let equal = arguments[left_out..].iter().take_while(|&&a| a == value).count();
            let above = if left_out == 0 { first_above(knots, above, others[0]) } else { above };
            let p = match among_knots(degree, knots, points, above, others) {
                Some(p) => p,
                None => {
                    let t = inner_parameter(new_degree, new_knots, count, i)?;
                    let j = span_index(knots, degree, t, false);
                    blossom(degree, knots, points, j, others.iter().copied())
                }
            };
            let share = equal as f64;
            sum = std::array::from_fn(|c| sum[c] + share * p[c]);
            for k in left_out..(left_out + equal).min(degree) {
                others[k] = value;
            }
            left_out += equal;
        }
        out.push(sum.map(|x| x / new_degree as f64));
    }
    Some(out)
}
