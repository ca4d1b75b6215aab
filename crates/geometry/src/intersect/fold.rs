//! Where a curve turns back on itself: it is cut there, so that each of its pieces runs on.

use super::thresholds::{FOLD, SAME_PARAMETER, STILL};
use crate::bernstein::{halves, value};
use crate::curve::{Piece, Shape};
use crate::nurbs::project;
use crate::polynomial::Polynomial;
use crate::{Interval, Vector3};

/// The ranges of one span that are looked at for places where it stands still: ordinary ones take some tens.
const BUDGET: usize = 500;

/// Cuts spans where their derivative vanishes, within what moves the curve by no more than the tolerance: cusps, and
/// points where a span turns back along itself. With the pieces come the parameters of the whole curve at which it
/// turns back, there or at a joint.
pub(super) fn unfolded(pieces: Vec<Piece<'_>>, tolerance: f64) -> (Vec<Piece<'_>>, Vec<f64>) {
    let cuts: Vec<(usize, Vec<f64>)> = pieces
        .iter()
        .enumerate()
        .map(|(i, piece)| (i, standstills(piece, tolerance)))
        .filter(|(_, cuts)| !cuts.is_empty())
        .collect();
    let mut out = pieces;
    for (i, cuts) in cuts.iter().rev() {
        let piece = out[*i];
        let mut parts = Vec::with_capacity(cuts.len() + 1);
        let mut from = 0.0;
        for &to in cuts.iter().chain(&[1.0]) {
            let part = |whole: Interval| {
                let at = |x: f64| if x == 1.0 { whole.end } else { whole.at(x) };
                Interval::new(at(from), at(to))
            };
            parts.push(Piece { whole: part(piece.whole), own: part(piece.own), shape: piece.shape });
            from = to;
        }
        out.splice(*i..=*i, parts);
    }
    let turns = out.windows(2).filter(|w| turns_back(&w[0], &w[1])).map(|w| w[1].whole.start).collect();
    (out, turns)
}

/// Whether a piece leaves its joint with the one before in the direction from which that came.
fn turns_back(before: &Piece<'_>, after: &Piece<'_>) -> bool {
    let chord = |piece: &Piece<'_>, from: f64, to: f64| {
        let at = |x: f64| piece.point(piece.own.at(x));
        (at(to) - at(from)).unitized()
    };
    match (chord(before, 0.999, 1.0), chord(after, 0.0, 0.001)) {
        (Some(a), Some(b)) => a.dot(b) < -0.999,
        _ => false,
    }
}

/// The places strictly inside a span, as parts of it, where its derivative is as good as 0; increasing.
fn standstills(piece: &Piece<'_>, tolerance: f64) -> Vec<f64> {
    let Shape::Span(curve, j) = piece.shape else { return Vec::new() };
    if curve.degree() < 2 {
        return Vec::new();
    }
    let mut points = Vec::with_capacity(curve.degree() + 1);
    curve.push_bezier(j, &mut points);
    // All differences of control points lead forward: so does the curve.
    let space: Vec<Vector3> = points.iter().map(|&p| project(p).to_vector()).collect();
    let (Some(&first), Some(&last)) = (space.first(), space.last()) else { return Vec::new() };
    if space.windows(2).all(|w| (w[1] - w[0]).dot(last - first) > 0.0) {
        return Vec::new();
    }
    let hodograph = hodograph(&points);
    let size = hodograph.iter().fold(0.0_f64, |m, d| m.max(length(d)));
    let still = (STILL * size).max(tolerance);
    if !(size > 16.0 * still) {
        return Vec::new();
    }
    let mut ranges: Vec<[f64; 2]> = Vec::new();
    let mut stack = vec![(hodograph.clone(), 0.0, 1.0)];
    let mut budget = BUDGET;
    while let Some((d, a, b)) = stack.pop() {
        budget = budget.saturating_sub(1);
        let sum = d.iter().fold(Vector3::ZERO, |s, &d| s + Vector3::from(d));
        let least = still * sum.length();
        if budget == 0 || d.iter().all(|&d| Vector3::from(d).dot(sum) > least) {
            continue;
        }
        if b - a < FOLD {
            match ranges.last_mut() {
                Some(known) if a - known[1] <= 2.0 * FOLD => known[1] = b,
                _ => ranges.push([a, b]),
            }
            continue;
        }
        let middle = 0.5 * (a + b);
        let (left, right) = halves(&d);
        stack.push((right, middle, b));
        stack.push((left, a, middle));
    }
    let slope = |d: &[[f64; 3]]| -> Vec<[f64; 3]> {
        let n = d.len().saturating_sub(1) as f64;
        d.windows(2).map(|w| std::array::from_fn(|c| n * (w[1][c] - w[0][c]))).collect()
    };
    let second = slope(&hodograph);
    let third = slope(&second);
    let at = |d: &[[f64; 3]], t: f64| Vector3::from(value(d, t));
    let mut out = Vec::new();
    for [a, b] in ranges {
        // Newton's method for the least speed.
        let mut t = 0.5 * (a + b);
        for _ in 0..12 {
            let (v, d, dd) = (at(&hodograph, t), at(&second, t), at(&third, t));
            let step = v.dot(d) / (d.length_squared() + v.dot(dd));
            let next = (t - step).clamp(a - (b - a), b + (b - a));
            if !next.is_finite() || next == t {
                break;
            }
            t = next;
        }
        if t > SAME_PARAMETER && t < 1.0 - SAME_PARAMETER && at(&hodograph, t).length() <= 2.0 * still {
            out.push(t);
        }
    }
    out.dedup_by(|b, a| *b - *a <= SAME_PARAMETER);
    out
}

fn length(d: &[f64; 3]) -> f64 {
    Vector3::from(*d).length()
}

/// The derivative of a Bézier curve over 0…1; with weights, its numerator A′w − Aw′ for a greatest weight of 1.
fn hodograph(points: &[[f64; 4]]) -> Vec<[f64; 3]> {
    let heaviest = points.iter().fold(0.0_f64, |m, p| m.max(p[3]));
    let coordinate = |c: usize| Polynomial::new(points.iter().map(|p| p[c] / heaviest).collect());
    let rational = points.iter().any(|p| p[3] != heaviest);
    let w = coordinate(3);
    let slope = |c: usize| {
        let x = coordinate(c);
        if rational { x.derivative().times(&w).minus(&x.times(&w.derivative())) } else { x.derivative() }
    };
    let [x, y, z] = [slope(0), slope(1), slope(2)];
    let rest = y.coefficients().iter().zip(z.coefficients());
    x.coefficients().iter().zip(rest).map(|(&x, (&y, &z))| [x, y, z]).collect()
}
