use std::fmt;
use std::str::FromStr;

/// A .NET decimal number: a whole number of 96 bits, a sign, and how many of its digits stand after the point.
/// Kept as the four words that the file holds, so that trailing zeros survive.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Decimal {
    /// The lowest 32 bits of the whole number.
    pub low: u32,
    /// The middle 32 bits.
    pub middle: u32,
    /// The highest 32 bits.
    pub high: u32,
    /// Bit 31 is the sign; bits 16 to 23 the digits after the point, 0 to 28; all others 0.
    pub flags: u32,
}

impl Decimal {
    const SIGN: u32 = 1 << 31;
    const SCALE: u32 = 0x00ff_0000;

    /// The digits after the point.
    pub fn scale(self) -> u32 {
        (self.flags & Self::SCALE) >> 16
    }

    /// Whether the flags are those of a number.
    pub fn is_valid(self) -> bool {
        self.flags & !(Self::SIGN | Self::SCALE) == 0 && self.scale() <= 28
    }

    fn digits(self) -> u128 {
        u128::from(self.low) | u128::from(self.middle) << 32 | u128::from(self.high) << 64
    }

    /// The nearest number of 64 bits.
    pub fn to_f64(self) -> f64 {
        self.to_string().parse().unwrap_or(f64::NAN)
    }

    /// The decimal number with the given number of digits after the point that is nearest to `x`; `None` when
    /// `x` is not finite or needs more than 96 bits.
    pub fn from_f64(x: f64, scale: u32) -> Option<Self> {
        if !x.is_finite() {
            return None;
        }
        let places = usize::try_from(scale.min(28)).ok()?;
        format!("{x:.places$}").parse().ok()
    }
}

impl fmt::Display for Decimal {
    /// As .NET prints it: `-12.50`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.flags & Self::SIGN != 0 {
            f.write_str("-")?;
        }
        let scale = usize::try_from(self.scale().min(28)).unwrap_or(0);
        let digits = format!("{:0width$}", self.digits(), width = scale + 1);
        let (whole, part) = digits.split_at(digits.len() - scale);
        f.write_str(whole)?;
        if part.is_empty() { Ok(()) } else { write!(f, ".{part}") }
    }
}

impl FromStr for Decimal {
    type Err = String;

    /// Reads an optional sign, digits and an optional point. Digits beyond the 28th after the point, and those
    /// that do not fit into 96 bits, are an error.
    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("\"{}\" is not a decimal number", text.chars().take(40).collect::<String>());
        let (negative, rest) = match text.as_bytes().first() {
            Some(b'-') => (true, text.get(1..).unwrap_or_default()),
            Some(b'+') => (false, text.get(1..).unwrap_or_default()),
            _ => (false, text),
        };
        let (whole, part) = rest.split_once('.').unwrap_or((rest, ""));
        if whole.is_empty() && part.is_empty() {
            return Err(wrong());
        }
        let mut digits: u128 = 0;
        for c in whole.chars().chain(part.chars()) {
            let d = c.to_digit(10).ok_or_else(wrong)?;
            digits = digits * 10 + u128::from(d);
            if digits >> 96 != 0 {
                return Err(format!("{}: it needs more than 96 bits", wrong()));
            }
        }
        let scale = u32::try_from(part.len()).ok().filter(|scale| *scale <= 28).ok_or_else(wrong)?;
        let word = |shift: u32| u32::try_from((digits >> shift) & 0xffff_ffff).unwrap_or(0);
        Ok(Self {
            low: word(0),
            middle: word(32),
            high: word(64),
            flags: scale << 16 | if negative { Self::SIGN } else { 0 },
        })
    }
}
