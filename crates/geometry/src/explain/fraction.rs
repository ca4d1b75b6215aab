//! Exact fractions, for as long as they stay small.

use std::fmt;

/// A decimal that is written in a definition has a denominator no larger than this: 0.001 and a third of it, say. Numbers
/// without such a fraction were measured or computed, and stay decimals.
const LARGEST_DENOMINATOR: i128 = 3_000;
/// Whole parts beyond this have no room for a fraction in the 53 bits of a double.
const LARGEST_WHOLE: f64 = 1e9;
/// Numerators and denominators beyond this are not shown: nobody reads them.
const LARGEST_SHOWN: i128 = 1_000_000_000_000;

/// A fraction in lowest terms, with a positive denominator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fraction {
    numerator: i128,
    denominator: i128,
}

impl Fraction {
    /// A fraction of two whole numbers; none where the denominator is 0 or a part is too large.
    pub fn new(numerator: i128, denominator: i128) -> Option<Self> {
        let common = gcd(numerator.unsigned_abs(), denominator.unsigned_abs());
        let common = i128::try_from(common).ok().filter(|common| *common > 0)?;
        let sign = denominator.signum();
        let (numerator, denominator) = (
            numerator.checked_div(common)?.checked_mul(sign)?,
            denominator.checked_div(common)?.checked_mul(sign)?,
        );
        let fits = |part: i128| part.unsigned_abs() <= LARGEST_SHOWN.unsigned_abs();
        (denominator > 0 && fits(numerator) && fits(denominator)).then_some(Self { numerator, denominator })
    }

    /// The fraction with the smallest denominator that rounds to exactly this double, when it has a small one: 0.4 is 2/5.
    ///
    /// Convergents of the continued fraction (Hardy and Wright, chapter 10).
    pub fn simplest(x: f64) -> Option<Self> {
        if !(x.abs() <= LARGEST_WHOLE) {
            return None;
        }
        let (mut before, mut last) = ((0_i128, 1_i128), (1_i128, 0_i128));
        let mut rest = x;
        loop {
            let whole = rest.floor();
            #[allow(clippy::cast_possible_truncation, reason = "at most 10^9, or it ends the loop below")]
            let next = if whole.abs() <= LARGEST_WHOLE { whole as i128 } else { return None };
            let step = |last: i128, before: i128| next.checked_mul(last)?.checked_add(before);
            let (p, q) = (step(last.0, before.0)?, step(last.1, before.1)?);
            if q > LARGEST_DENOMINATOR {
                return None;
            }
            let found = Self::new(p, q)?;
            if found.to_f64() == x {
                return Some(found);
            }
            (before, last) = (last, (p, q));
            rest = 1.0 / (rest - whole);
            if !rest.is_finite() {
                return None;
            }
        }
    }

    /// The number above the line.
    pub fn numerator(self) -> i128 {
        self.numerator
    }

    /// The number below the line; positive.
    pub fn denominator(self) -> i128 {
        self.denominator
    }

    /// The nearest double.
    #[allow(clippy::cast_precision_loss, reason = "both parts are below 2^53")]
    pub fn to_f64(self) -> f64 {
        self.numerator as f64 / self.denominator as f64
    }

    /// The sum; none where it grows too large.
    pub fn plus(self, other: Self) -> Option<Self> {
        let left = self.numerator.checked_mul(other.denominator)?;
        let right = other.numerator.checked_mul(self.denominator)?;
        Self::new(left.checked_add(right)?, self.denominator.checked_mul(other.denominator)?)
    }

    /// The product; none where it grows too large.
    pub fn times(self, other: Self) -> Option<Self> {
        let numerator = self.numerator.checked_mul(other.numerator)?;
        Self::new(numerator, self.denominator.checked_mul(other.denominator)?)
    }

    /// One over it; none for 0.
    pub fn inverted(self) -> Option<Self> {
        Self::new(self.denominator, self.numerator)
    }

    /// With the other sign.
    pub fn negated(self) -> Self {
        Self { numerator: -self.numerator, ..self }
    }

    /// The square root, where both parts are squares.
    pub fn root(self) -> Option<Self> {
        let root = |x: i128| {
            let root = u128::try_from(x).ok()?.isqrt();
            let root = i128::try_from(root).ok()?;
            (root.checked_mul(root)? == x).then_some(root)
        };
        Self::new(root(self.numerator)?, root(self.denominator)?)
    }
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.denominator == 1 {
            write!(f, "{}", self.numerator)
        } else {
            write!(f, "{}/{}", self.numerator, self.denominator)
        }
    }
}

/// The greatest common divisor (Euclid).
fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_the_fractions_that_people_mean() {
        let told = |x: f64| Fraction::simplest(x).map(|f| f.to_string());
        assert_eq!(told(0.4).as_deref(), Some("2/5"));
        assert_eq!(told(-0.75).as_deref(), Some("-3/4"));
        assert_eq!(told(8.0 / 15.0).as_deref(), Some("8/15"));
        assert_eq!(told(0.0).as_deref(), Some("0"));
        assert_eq!(told(-3.0).as_deref(), Some("-3"));
        assert_eq!(told(std::f64::consts::PI), None);
        assert_eq!(told(f64::NAN), None);
        assert_eq!(told(f64::INFINITY), None);
        assert_eq!(told(1e300), None);
        assert_eq!(told(1e-300), None);
    }

    proptest::proptest! {
        #[test]
        fn fractions_come_back_from_doubles(n in -100_000_i128..100_000, d in 1_i128..3_000) {
            let f = Fraction::new(n, d).unwrap();
            proptest::prop_assert_eq!(Fraction::simplest(f.to_f64()), Some(f));
        }

        #[test]
        fn any_double_is_told_or_refused(x in proptest::num::f64::ANY) {
            if let Some(f) = Fraction::simplest(x) {
                proptest::prop_assert_eq!(f.to_f64(), x);
            }
        }
    }

    #[test]
    fn roots_of_squares() {
        assert_eq!(Fraction::new(9, 4).and_then(Fraction::root), Fraction::new(3, 2));
        assert_eq!(Fraction::new(2, 1).and_then(Fraction::root), None);
        assert_eq!(Fraction::new(-1, 1).and_then(Fraction::root), None);
        assert_eq!(Fraction::new(1, 0), None);
    }
}
