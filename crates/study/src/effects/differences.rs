//! Derivatives from differences of ever smaller steps, extrapolated to a step of nothing.

use crate::thresholds::{DIFFERENCE_COLUMNS, DIFFERENCE_ROWS, ROUNDING_UNITS};

/// A derivative and how far it may be off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Derivative {
    /// Change of the output for a change of the input by one.
    pub value: f64,
    /// A bound of its error, of the same unit: four times the last change of the extrapolation and what rounding can do.
    pub error: f64,
}

/// The derivative at `x` from both sides, with steps up to `reach`; `None` where a value is missing.
pub(super) fn central(f: &mut dyn FnMut(f64) -> Option<f64>, x: f64, reach: f64) -> Option<Derivative> {
    extrapolated(reach, 4.0, |h| {
        let (above, below) = (x + h, x - h);
        let (a, b) = (f(above)?, f(below)?);
        Some(((a - b) / (above - below), rounding(a.abs().max(b.abs()), h)))
    })
}

/// The same from one side alone: the side of `reach`.
pub(super) fn one_sided(f: &mut dyn FnMut(f64) -> Option<f64>, x: f64, reach: f64) -> Option<Derivative> {
    let here = f(x)?;
    extrapolated(reach, 2.0, |h| {
        let beside = x + h;
        let a = f(beside)?;
        Some(((a - here) / (beside - x), rounding(a.abs().max(here.abs()), h)))
    })
}

/// What the rounding of values of that size does to their difference over a step.
fn rounding(size: f64, h: f64) -> f64 {
    ROUNDING_UNITS * f64::EPSILON * size / h.abs()
}

/// Richardson's extrapolation as Ridders (1982) has it: steps are halved, each column takes one more term of the error's series
/// away, and the number with the smallest sign of error counts. `factor` is by how much halving a step makes the first term
/// smaller: 4 for differences from both sides, whose series has even powers only, 2 from one side.
fn extrapolated(
    reach: f64,
    factor: f64,
    mut difference: impl FnMut(f64) -> Option<(f64, f64)>,
) -> Option<Derivative> {
    let mut best: Option<Derivative> = None;
    let mut before: Vec<f64> = Vec::new();
    let mut h = reach;
    for _ in 0..DIFFERENCE_ROWS {
        let (first, rounding) = difference(h)?;
        let mut row = vec![first];
        let mut weight = factor;
        for above in before.iter().take(DIFFERENCE_COLUMNS) {
            let left = row.last().copied().unwrap_or(first);
            let next = left + (left - above) / (weight - 1.0);
            let changed = (next - left).abs().max((next - above).abs());
            // The first column's rounding grows a little from column to column; twice covers all of them.
            let error = 4.0 * changed + 2.0 * rounding;
            if best.is_none_or(|best| error < best.error) {
                best = Some(Derivative { value: next, error });
            }
            row.push(next);
            weight *= factor;
        }
        before = row;
        h /= 2.0;
    }
    best.filter(|best| best.value.is_finite() && best.error.is_finite())
}

#[cfg(test)]
mod tests {
    use katydid_elementary::Elementary;

    use super::*;

    #[test]
    fn derivatives_of_smooth_functions_lie_within_their_bounds() {
        type Case = (fn(f64) -> f64, fn(f64) -> f64);
        let cases: [Case; 5] = [
            (|x| x * x * x - 2.0 * x, |x| 3.0 * x * x - 2.0),
            (|x| (5.0 * x).sine(), |x| 5.0 * (5.0 * x).cosine()),
            (|x| x.exponential(), |x| x.exponential()),
            (|x| 1.0 / (1.0 + x * x), |x| -2.0 * x / ((1.0 + x * x) * (1.0 + x * x))),
            (|_| 7.0, |_| 0.0),
        ];
        for (case, (f, slope)) in cases.into_iter().enumerate() {
            for x in [-1.3, 0.2, 2.0] {
                for reach in [0.9, 0.05] {
                    let found = [
                        central(&mut |x| Some(f(x)), x, reach),
                        one_sided(&mut |x| Some(f(x)), x, reach),
                        one_sided(&mut |x| Some(f(x)), x, -reach),
                    ];
                    for found in found.map(Option::unwrap) {
                        let off = (found.value - slope(x)).abs();
                        assert!(
                            off <= found.error && off <= 1e-6 * slope(x).abs().max(1.0),
                            "{case} {x} {found:?}"
                        );
                    }
                }
            }
        }
    }
}
