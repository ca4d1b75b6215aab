//! Powers with whole exponents, rounded once.
//!
//! The power function of `libm` is within a unit of the last place, which gives `10^22`, a number that doubles have, with a wrong
//! last digit. The product of factors kept in two doubles (Dekker, "A floating-point technique for extending the available
//! precision", 1971) has some hundred bits.

/// Larger exponents are left to the logarithm.
const MOST: f64 = 512.0;
/// Between these, splitting a factor and its error neither overflow nor lose bits to small numbers.
const SAFE: std::ops::Range<f64> = 1e-250..1e250;
/// 2²⁷ + 1: cuts a double into two halves whose products are exact.
const SPLIT: f64 = 134_217_729.0;

/// A number as the sum of two doubles that do not overlap.
#[derive(Clone, Copy)]
struct Pair(f64, f64);

impl Pair {
    /// The product of two doubles without an error.
    fn product(a: f64, b: f64) -> Self {
        let halves = |x: f64| {
            let t = SPLIT * x;
            let high = t - (t - x);
            (high, x - high)
        };
        let whole = a * b;
        let ((a1, a2), (b1, b2)) = (halves(a), halves(b));
        Self(whole, ((a1 * b1 - whole) + a1 * b2 + a2 * b1) + a2 * b2)
    }

    fn times(self, other: Self) -> Self {
        let Self(whole, error) = Self::product(self.0, other.0);
        let error = error + (self.0 * other.1 + self.1 * other.0);
        let sum = whole + error;
        Self(sum, error - (sum - whole))
    }

    /// One over this, rounded once.
    fn inverse(self) -> f64 {
        let first = 1.0 / self.0;
        let Self(whole, error) = Self::product(first, self.0);
        first + first * ((1.0 - whole) - error - first * self.1)
    }
}

/// `x` to a power; `None` where the power is not whole or too large, or the result near the ends of what doubles hold.
pub(crate) fn power(x: f64, power: f64) -> Option<f64> {
    if power == 2.0 {
        return Some(x * x);
    }
    if power.trunc() != power || power.abs() > MOST {
        return None;
    }
    let safe = |x: f64| SAFE.contains(&x.abs());
    let (mut rest, mut square, mut result) = (power.abs() as u32, Pair(x, 0.0), Pair(1.0, 0.0));
    while rest > 0 {
        if !safe(square.0) || !safe(result.0) {
            return None;
        }
        if rest & 1 == 1 {
            result = result.times(square);
        }
        rest >>= 1;
        if rest > 0 {
            square = square.times(square);
        }
    }
    if !safe(result.0) {
        return None;
    }
    Some(if power < 0.0 { result.inverse() } else { result.0 + result.1 })
}
