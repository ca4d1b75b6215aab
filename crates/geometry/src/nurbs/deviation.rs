//! How far two curves are apart at equal parameters, with proof.

use super::NurbsCurve;
use super::refine::map_controls;
use crate::bernstein::{BUDGET, halves};
use crate::polynomial::Polynomial;
use crate::thresholds;
use crate::{Error, Result};

/// A curve that stands for something else, and how far it is away from it.
#[derive(Debug, Clone, PartialEq)]
pub struct Approximation {
    /// The approximating curve.
    pub curve: NurbsCurve,
    /// Its distance from what it stands for; the function that made it says how that is measured.
    pub deviation: f64,
}

impl NurbsCurve {
    /// The homogeneous Bézier points between consecutive `breaks`, which must contain every knot of the domain.
    pub(crate) fn beziers_between(&self, breaks: &[f64]) -> Result<Vec<Vec<[f64; 4]>>> {
        let p = self.degree;
        let knots: Vec<f64> = breaks.iter().flat_map(|&t| std::iter::repeat_n(t, p)).collect();
        let controls = map_controls(
            &self.controls,
            |c| super::blossom::over_knots(p, &self.knots, c, &knots),
            |c| super::blossom::over_knots(p, &self.knots, c, &knots),
        )
        .ok_or(Error::degenerate("knot vector", "a control point acts on no span"))?;
        let points = Self { degree: p, knots, controls }.homogeneous_points();
        Ok((0..breaks.len().saturating_sub(1))
            .map(|k| points.get(k * p..=k * p + p).unwrap_or(&[]).to_vec())
            .collect())
    }

    /// An upper bound of the greatest distance between points of equal parameters of two curves, the other one's
    /// domain mapped linearly to this one's. It is at most 1 % (and 10⁻¹² of the curves' size) above the true value.
    ///
    /// The difference of the curves is a rational Bézier curve on every common span; its control points bound it,
    /// and halving makes the bound close in (derived from the convex hull property).
    ///
    /// # Errors
    /// The other curve's knots cannot be mapped to this domain without falling together.
    pub fn deviation_from(&self, other: &Self) -> Result<f64> {
        let other = if other.domain() == self.domain() {
            std::borrow::Cow::Borrowed(other)
        } else {
            std::borrow::Cow::Owned(other.with_domain(self.domain())?)
        };
        let mut breaks = self.span_parameters();
        breaks.extend(other.span_parameters());
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        let size = self.control_points().iter().fold(0.0_f64, |m, p| m.max(p.to_vector().length()));
        let mut worst = 0.0_f64;
        for (a, b) in self.beziers_between(&breaks)?.iter().zip(&other.beziers_between(&breaks)?) {
            worst = worst.max(greatest_length(difference(a, b), worst, thresholds::ROUNDING * size));
        }
        Ok(worst)
    }
}

/// The control points of the difference of two Bézier curves.
pub(crate) fn difference(a: &[[f64; 4]], b: &[[f64; 4]]) -> Vec<[f64; 4]> {
    let plain = |c: &[[f64; 4]]| c.iter().all(|p| p[3] == 1.0);
    let row = |c: &[[f64; 4]], i: usize| Polynomial::new(c.iter().map(|p| p[i]).collect());
    let (parts, weight) = if plain(a) && plain(b) {
        ([0, 1, 2].map(|i| row(a, i).minus(&row(b, i))), None)
    } else {
        let (wa, wb) = (row(a, 3), row(b, 3));
        ([0, 1, 2].map(|i| row(a, i).times(&wb).minus(&row(b, i).times(&wa))), Some(wa.times(&wb)))
    };
    let [x, y, z] = &parts;
    (0..x.coefficients().len())
        .map(|i| {
            let at = |p: &Polynomial| p.coefficients().get(i).copied().unwrap_or(0.0);
            [at(x), at(y), at(z), weight.as_ref().map_or(1.0, at)]
        })
        .collect()
}

/// An upper bound, at most 1 % and `slack` too large, of the length of a Bézier curve's points as vectors; any number
/// up to `known` where it is below that.
pub(crate) fn greatest_length(points: Vec<[f64; 4]>, known: f64, slack: f64) -> f64 {
    let length = |p: &[f64; 4]| (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt() / p[3];
    let bound = |c: &[[f64; 4]]| c.iter().map(length).fold(0.0, f64::max);
    let mut best = known;
    let mut certified = known;
    let mut stack = vec![(points, 0_u32)];
    let mut budget = BUDGET;
    while let Some((c, depth)) = stack.pop() {
        for end in [c.first(), c.last()].into_iter().flatten() {
            best = best.max(length(end));
        }
        let above = bound(&c);
        budget = budget.saturating_sub(1);
        if above <= 1.01 * best + slack || depth > 40 || budget == 0 || !above.is_finite() {
            certified = certified.max(above);
            continue;
        }
        let (left, right) = halves(&c);
        stack.push((left, depth + 1));
        stack.push((right, depth + 1));
    }
    certified.max(best)
}
