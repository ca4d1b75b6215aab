//! A number with its fraction.

use crate::explain::Fraction;

/// A number of an explanation: as a double, and as the exact fraction where all that it came from were fractions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number {
    /// The double.
    pub value: f64,
    /// The fraction; it stands for what was meant, so the double may be off it by rounding.
    pub exact: Option<Fraction>,
}

impl Number {
    /// A number that was given.
    pub fn given(value: f64) -> Self {
        Self { value, exact: Fraction::simplest(value) }
    }

    /// A number that was measured: without a fraction.
    pub fn measured(value: f64) -> Self {
        Self { value, exact: None }
    }

    fn of(value: f64, exact: Option<Fraction>) -> Self {
        Self { value: exact.map_or(value, Fraction::to_f64), exact }
    }

    /// The sum.
    pub fn plus(self, other: Self) -> Self {
        let exact = self.exact.zip(other.exact).and_then(|(a, b)| a.plus(b));
        Self::of(self.value + other.value, exact)
    }

    /// The difference.
    pub fn minus(self, other: Self) -> Self {
        let exact = self.exact.zip(other.exact).and_then(|(a, b)| a.plus(b.negated()));
        Self::of(self.value - other.value, exact)
    }

    /// The product.
    pub fn times(self, other: Self) -> Self {
        let exact = self.exact.zip(other.exact).and_then(|(a, b)| a.times(b));
        Self::of(self.value * other.value, exact)
    }

    /// The quotient; 0 where the divisor is.
    pub fn over(self, other: Self) -> Self {
        if other.value == 0.0 {
            return Self::given(0.0);
        }
        let exact = self.exact.zip(other.exact).and_then(|(a, b)| a.times(b.inverted()?));
        Self::of(self.value / other.value, exact)
    }

    /// The square root of what is not negative.
    pub fn root(self) -> Self {
        Self::of(self.value.max(0.0).sqrt(), self.exact.and_then(Fraction::root))
    }
}

impl std::fmt::Display for Number {
    /// The fraction, or the double to six digits after the point without noughts at the end.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.exact {
            Some(fraction) => fraction.fmt(f),
            None => {
                let text = format!("{:.6}", self.value);
                let text = text.trim_end_matches('0').trim_end_matches('.');
                f.write_str(if text == "-0" { "0" } else { text })
            }
        }
    }
}
