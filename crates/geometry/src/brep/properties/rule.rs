//! Adaptive Gauss–Legendre rules for several functions at once.

use katydid_elementary::Elementary;

use crate::brep::thresholds::LEAST_PART_OF_TOLERANCE;
use crate::quadrature::{GAUSS_6, GAUSS_10};
use crate::{Error, Result};

/// The most halvings of a range.
const DEEPEST: u32 = 40;
/// The most ranges that one integral is divided into.
const RANGES: u32 = 4_000;

/// What an integration may use, and what it found of its own error.
pub(super) struct Work<'a> {
    left: u64,
    go_on: &'a dyn Fn() -> bool,
    /// The sum of the differences that were accepted.
    pub(super) error: f64,
}

impl<'a> Work<'a> {
    pub(super) fn new(most: u64, go_on: &'a dyn Fn() -> bool) -> Self {
        Self { left: most, go_on, error: 0.0 }
    }

    /// Takes the right to look at some densities.
    pub(super) fn take(&mut self, count: u64) -> Result<()> {
        self.left = self.left.checked_sub(count).ok_or_else(|| stopped("it takes too much work"))?;
        Ok(())
    }

    /// Whether the caller wants to wait any longer.
    pub(super) fn check(&self) -> Result<()> {
        if (self.go_on)() { Ok(()) } else { Err(Error::Stopped) }
    }
}

fn stopped(why: &str) -> Error {
    Error::Invalid { what: "integral", why: why.into() }
}

/// A value by the rule of 10 points and how far it may be off.
struct Part {
    range: [f64; 2],
    depth: u32,
    value: [f64; 10],
    error: f64,
}

fn part(range: [f64; 2], depth: u32, f: &mut dyn FnMut(f64) -> Result<[f64; 10]>) -> Result<Part> {
    let (middle, half) = (0.5 * (range[0] + range[1]), 0.5 * (range[1] - range[0]));
    let mut sum = |rule: &[[f64; 2]]| -> Result<[f64; 10]> {
        let mut out = [0.0; 10];
        for &[x, weight] in rule {
            for side in [-1.0, 1.0] {
                let value = f(middle + side * half * x)?;
                out.iter_mut().zip(value).for_each(|(sum, v)| *sum += weight * v);
            }
        }
        Ok(out.map(|v| v * half))
    };
    let (coarse, value) = (sum(&GAUSS_6)?, sum(&GAUSS_10)?);
    let difference = coarse.iter().zip(&value).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let scale = value.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    // The rule of 10 points is far better than its difference from that of 6 tells.
    let error = if scale > 0.0 {
        difference.min(scale * (100.0 * difference / scale).raised_to(1.5))
    } else {
        difference
    };
    Ok(Part { range, depth, value, error })
}

/// The middle and the outer places of the Gauss–Legendre rule of 3 points, √(3/5) from the middle, and their weights.
const GAUSS_3: [[f64; 2]; 3] =
    [[-0.774_596_669_241_483_4, 5.0 / 9.0], [0.0, 8.0 / 9.0], [0.774_596_669_241_483_4, 5.0 / 9.0]];

/// The integrals of ten polynomials of degree 5 or less over a range, exact to rounding.
pub(super) fn polynomial(
    [from, to]: [f64; 2],
    f: &mut dyn FnMut(f64) -> Result<[f64; 10]>,
) -> Result<[f64; 10]> {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let mut sum = [0.0; 10];
    for [x, weight] in GAUSS_3 {
        let value = f(middle + half * x)?;
        sum.iter_mut().zip(value).for_each(|(sum, v)| *sum += weight * half * v);
    }
    Ok(sum)
}

/// The integrals of ten functions over a chain of ranges, each to its share of a tolerance, and the error estimated.
/// Where halving does not help the last value counts.
pub(super) fn integral(
    stops: &[f64],
    tolerance: f64,
    f: &mut dyn FnMut(f64) -> Result<[f64; 10]>,
) -> Result<([f64; 10], f64)> {
    let (mut sum, mut error) = ([0.0; 10], 0.0);
    let Some((first, last)) = stops.first().zip(stops.last()) else { return Ok((sum, error)) };
    let length = (last - first).abs();
    let mut looked = 0;
    for w in stops.windows(2) {
        if w[0] == w[1] {
            continue;
        }
        let mut stack = vec![part([w[0], w[1]], 0, f)?];
        while let Some(found) = stack.pop() {
            let [a, b] = found.range;
            let share = tolerance * ((b - a).abs() / length).max(LEAST_PART_OF_TOLERANCE);
            looked += 1;
            if found.error > share && found.depth < DEEPEST && looked < RANGES {
                let middle = 0.5 * (a + b);
                stack.push(part([middle, b], found.depth + 1, f)?);
                stack.push(part([a, middle], found.depth + 1, f)?);
                continue;
            }
            sum.iter_mut().zip(found.value).for_each(|(sum, v)| *sum += v);
            error += found.error;
        }
    }
    Ok((sum, error))
}
