//! Decimal digits of numbers.

/// A number as decimal digits: `±0.d₁d₂d₃… · 10^scale`, without zeros at either end. Zero has no digits and
/// scale 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Decimal {
    pub(super) negative: bool,
    /// ASCII digits.
    pub(super) digits: Vec<u8>,
    pub(super) scale: i32,
}

/// Digits beyond the wanted ones that are asked for, one number after the other while the answer is open.
const GUARDS: [usize; 3] = [2, 22, ALL];

/// The most significant digits that a double has in full: 767, for the largest odd subnormal.
const ALL: usize = 767;

impl Decimal {
    /// The fewest digits that read back as `x`, which must be finite.
    pub(super) fn shortest(x: f64) -> Self {
        Self::from_scientific(&format!("{x:e}"))
    }

    /// `x` in `count` significant digits, halves away from zero by its exact decimal value; `x` must be finite.
    pub(super) fn significant(x: f64, count: usize) -> Self {
        let count = count.clamp(1, ALL);
        Self::rounded(x, count, |_| i32::try_from(count).unwrap_or(i32::MAX))
    }

    /// `x` to `places` decimals, halves away from zero by its exact decimal value; `x` must be finite.
    pub(super) fn places(x: f64, places: usize) -> Self {
        let places = i32::try_from(places).unwrap_or(i32::MAX);
        // The shortest digits tell the scale, or one more than it: enough to know how many digits are needed.
        let count = usize::try_from(Self::shortest(x).scale.saturating_add(places)).unwrap_or(0);
        Self::rounded(x, count, |scale| scale.saturating_add(places))
    }

    /// `x` rounded behind the digit that `keep` finds from the scale, of about `count` digits.
    ///
    /// A few digits more tell on which side of the half the number lies, unless they read 50…0: then more are
    /// asked for, in the end all.
    fn rounded(x: f64, count: usize, keep: impl Fn(i32) -> i32) -> Self {
        let mut decimal = Self { negative: x.is_sign_negative(), digits: Vec::new(), scale: 0 };
        for guard in GUARDS {
            let wide = count.saturating_add(guard).min(ALL);
            decimal = Self::from_scientific(&format!("{x:.*e}", wide - 1));
            let half = decimal.digits.last() == Some(&b'5')
                && usize::try_from(keep(decimal.scale)) == Ok(decimal.digits.len() - 1);
            if !half || wide == ALL {
                break;
            }
        }
        decimal.round(keep(decimal.scale));
        decimal
    }

    /// A whole number.
    pub(super) fn integer(i: i32) -> Self {
        let digits = i.unsigned_abs().to_string().into_bytes();
        let scale = digits.len() as i32;
        Self { negative: i < 0, digits, scale }.trimmed()
    }

    /// Reads what `{:e}` prints.
    fn from_scientific(text: &str) -> Self {
        let negative = text.starts_with('-');
        let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
        let digits: Vec<u8> = mantissa.bytes().filter(u8::is_ascii_digit).collect();
        let scale = exponent.parse::<i32>().unwrap_or(0).saturating_add(1);
        Self { negative, digits, scale }.trimmed()
    }

    fn trimmed(mut self) -> Self {
        let zeros = self.digits.iter().take_while(|d| **d == b'0').count();
        if zeros > 0 {
            self.digits.drain(..zeros);
            self.scale -= zeros as i32;
        }
        while self.digits.last() == Some(&b'0') {
            self.digits.pop();
        }
        if self.digits.is_empty() {
            self.scale = 0;
        }
        self
    }

    /// Keeps the first `count` digits, halves away from zero. The sign stays, even on zero.
    pub(super) fn round(&mut self, count: i32) {
        let Ok(keep) = usize::try_from(count) else {
            self.digits.clear();
            self.scale = 0;
            return;
        };
        let up = self.digits.get(keep).is_some_and(|d| *d >= b'5');
        self.digits.truncate(keep);
        if up {
            while self.digits.last() == Some(&b'9') {
                self.digits.pop();
            }
            match self.digits.last_mut() {
                Some(digit) => *digit += 1,
                None => {
                    self.digits.push(b'1');
                    self.scale = self.scale.saturating_add(1);
                }
            }
        }
        while self.digits.last() == Some(&b'0') {
            self.digits.pop();
        }
        if self.digits.is_empty() {
            self.scale = 0;
        }
    }

    /// Whether it is zero.
    pub(super) fn is_zero(&self) -> bool {
        self.digits.is_empty()
    }

    /// The digits before the decimal point, at least one.
    pub(super) fn whole(&self) -> String {
        let Ok(count @ 1..) = usize::try_from(self.scale) else { return "0".into() };
        (0..count).map(|i| self.digit(i)).collect()
    }

    /// So many digits behind the decimal point.
    pub(super) fn fraction(&self, places: usize) -> String {
        let scale = i64::from(self.scale);
        let at = |i: usize| usize::try_from(scale + i64::try_from(i).unwrap_or(i64::MAX / 2));
        (0..places).map(|i| at(i).map_or('0', |k| self.digit(k))).collect()
    }

    /// The digit at a place counted from the first one; zeros behind the last.
    pub(super) fn digit(&self, i: usize) -> char {
        self.digits.get(i).map_or('0', |d| char::from(*d))
    }
}
