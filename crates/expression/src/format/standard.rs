//! Standard numeric forms: a letter and an optional number of digits.

use super::decimal::Decimal;
use super::{Dialect, FormatError, custom};

/// The greatest number of digits behind the letter.
const MAX_DIGITS: usize = 999;

/// Significant digits of a double in .NET Framework, and for custom forms in every .NET.
pub(super) const FIFTEEN: usize = 15;

/// A number in full precision, as `{0}` prints it: the fewest digits that read back as the same number
/// ([`Dialect::Modern`]) or 15 significant digits ([`Dialect::Framework`]). Numbers of more than 15 whole digits
/// (17 where all of them are needed) and numbers below 0.0001 print with an exponent: `1E+15`, `1E-05`.
pub fn number_text(x: f64, dialect: Dialect) -> String {
    if let Some(text) = not_finite(x) {
        return text.into();
    }
    let decimal = full(x, dialect);
    // "The greater of the digits there are and 15": so that -60 does not print as -6E+01.
    let limit = decimal.digits.len().max(FIFTEEN);
    general(&decimal, limit, 'E', signed(&decimal, dialect))
}

fn full(x: f64, dialect: Dialect) -> Decimal {
    match dialect {
        Dialect::Modern => Decimal::shortest(x),
        Dialect::Framework => Decimal::significant(x, FIFTEEN),
    }
}

fn not_finite(x: f64) -> Option<&'static str> {
    match x {
        _ if x.is_nan() => Some("NaN"),
        f64::INFINITY => Some("Infinity"),
        f64::NEG_INFINITY => Some("-Infinity"),
        _ => None,
    }
}

/// Whether a minus is printed: .NET Framework leaves it out before zero.
fn signed(decimal: &Decimal, dialect: Dialect) -> bool {
    decimal.negative && !(decimal.is_zero() && dialect == Dialect::Framework)
}

/// A letter and up to three digits; anything else is a custom form.
fn letter_and_digits(form: &str) -> Option<(char, Option<usize>)> {
    let mut chars = form.chars();
    let letter = chars.next().filter(char::is_ascii_alphabetic)?;
    let digits = chars.as_str();
    if digits.is_empty() {
        return Some((letter, None));
    }
    if !digits.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    Some((letter, Some(digits.parse().unwrap_or(usize::MAX))))
}

fn bad(form: &str, value: &'static str, reason: &'static str) -> FormatError {
    FormatError::BadFormat { format: form.into(), value, reason }
}

/// A number in a standard or custom form.
pub(super) fn format_number(x: f64, form: &str, dialect: Dialect) -> Result<String, FormatError> {
    let standard = letter_and_digits(form);
    if let Some((letter, digits)) = standard {
        let upper = letter.to_ascii_uppercase();
        if matches!(upper, 'D' | 'X') {
            return Err(bad(form, "a Number", "D and X take integers only"));
        }
        if digits.is_some_and(|d| d > MAX_DIGITS) {
            return Err(bad(form, "a Number", "more than 999 digits"));
        }
        if !"GRFNEPC".contains(upper) {
            return Err(bad(form, "a Number", "there is no such form"));
        }
        if let Some(text) = not_finite(x) {
            return Ok(text.into());
        }
        if upper == 'R' || (upper == 'G' && digits.unwrap_or(0) == 0) {
            // R reads back in either .NET.
            let dialect_of_digits = if upper == 'R' { Dialect::Modern } else { dialect };
            let decimal = full(x, dialect_of_digits);
            let limit = decimal.digits.len().max(FIFTEEN);
            let mark = if letter == 'g' || letter == 'r' { 'e' } else { 'E' };
            return Ok(general(&decimal, limit, mark, signed(&decimal, dialect)));
        }
        let source = Source { x, dialect };
        return Ok(written(&source, letter, digits));
    }
    if let Some(text) = not_finite(x) {
        return Ok(text.into());
    }
    Ok(custom::format(Decimal::significant(x, FIFTEEN), form, dialect))
}

/// An integer in a standard or custom form.
pub(super) fn format_integer(i: i32, form: &str) -> Result<String, FormatError> {
    let Some((letter, digits)) = letter_and_digits(form) else {
        // Integers have no negative zero in either .NET.
        return Ok(custom::format(Decimal::integer(i), form, Dialect::Framework));
    };
    if digits.is_some_and(|d| d > MAX_DIGITS) {
        return Err(bad(form, "an Integer", "more than 999 digits"));
    }
    let width = digits.unwrap_or(0);
    Ok(match letter {
        'D' | 'd' => format!("{}{:0width$}", if i < 0 { "-" } else { "" }, i.unsigned_abs()),
        'X' => format!("{i:0width$X}"),
        'x' => format!("{i:0width$x}"),
        'R' | 'r' => i.to_string(),
        'G' | 'g' if width == 0 => i.to_string(),
        'G' | 'g' | 'F' | 'f' | 'N' | 'n' | 'E' | 'e' | 'P' | 'p' | 'C' | 'c' => {
            written(&Source { x: f64::from(i), dialect: Dialect::Modern }, letter, digits)
        }
        _ => return Err(bad(form, "an Integer", "there is no such form")),
    })
}

/// A finite number to be rounded in one way or the other.
struct Source {
    x: f64,
    dialect: Dialect,
}

impl Source {
    /// To so many decimals after a shift of the decimal point.
    fn places(&self, places: usize, shift: i32) -> Decimal {
        match self.dialect {
            Dialect::Modern if shift == 0 => Decimal::places(self.x, places),
            // .NET Framework rounds what 15 digits show; a percentage shifts the digits, it does not multiply.
            _ => {
                let digits = if self.dialect == Dialect::Modern { 40 } else { FIFTEEN };
                let mut decimal = Decimal::significant(self.x, digits);
                if !decimal.is_zero() {
                    decimal.scale += shift;
                }
                decimal.round(decimal.scale.saturating_add(places as i32));
                decimal
            }
        }
    }

    fn significant(&self, count: usize) -> Decimal {
        match self.dialect {
            Dialect::Modern => Decimal::significant(self.x, count),
            Dialect::Framework => {
                // Up to 17 digits can be had by asking for more than 15.
                let mut decimal = Decimal::significant(self.x, if count > FIFTEEN { 17 } else { FIFTEEN });
                decimal.round(count as i32);
                decimal
            }
        }
    }
}

fn written(source: &Source, letter: char, digits: Option<usize>) -> String {
    let minus = |d: &Decimal| if signed(d, source.dialect) { "-" } else { "" };
    match letter.to_ascii_uppercase() {
        'F' => {
            let places = digits.unwrap_or(2);
            let d = source.places(places, 0);
            format!("{}{}", minus(&d), fixed(&d, places, false))
        }
        'N' => {
            let places = digits.unwrap_or(2);
            let d = source.places(places, 0);
            format!("{}{}", minus(&d), fixed(&d, places, true))
        }
        'P' => {
            let places = digits.unwrap_or(2);
            let d = source.places(places, 2);
            format!("{}{} %", minus(&d), fixed(&d, places, true))
        }
        'C' => {
            let places = digits.unwrap_or(2);
            let d = source.places(places, 0);
            let amount = fixed(&d, places, true);
            if signed(&d, source.dialect) { format!("(¤{amount})") } else { format!("¤{amount}") }
        }
        'E' => {
            let places = digits.unwrap_or(6);
            let d = source.significant(places + 1);
            let mut text = String::from(minus(&d));
            text.push(d.digit(0));
            if places > 0 {
                text.push('.');
                text.extend((1..=places).map(|i| d.digit(i)));
            }
            let exponent = if d.is_zero() { 0 } else { d.scale - 1 };
            text.push_str(&exponent_text(exponent, letter, 3, true));
            text
        }
        _ => {
            let count = digits.unwrap_or(FIFTEEN).max(1);
            let d = source.significant(count);
            let mark = if letter == 'g' { 'e' } else { 'E' };
            general(&d, count, mark, signed(&d, source.dialect))
        }
    }
}

/// `G`: plain digits while the whole part has at most `limit` of them and no more than four zeros follow the
/// decimal point, else one digit before the point and an exponent.
fn general(decimal: &Decimal, limit: usize, mark: char, negative: bool) -> String {
    let mut text = String::from(if negative { "-" } else { "" });
    let limit = i32::try_from(limit).unwrap_or(i32::MAX);
    if decimal.scale > limit || decimal.scale < -3 {
        text.push(decimal.digit(0));
        if decimal.digits.len() > 1 {
            text.push('.');
            text.extend((1..decimal.digits.len()).map(|i| decimal.digit(i)));
        }
        text.push_str(&exponent_text(decimal.scale - 1, mark, 2, true));
        return text;
    }
    text.push_str(&decimal.whole());
    let behind = i64::try_from(decimal.digits.len()).unwrap_or(0) - i64::from(decimal.scale);
    if let Ok(places @ 1..) = usize::try_from(behind) {
        text.push('.');
        text.push_str(&decimal.fraction(places));
    }
    text
}

fn fixed(decimal: &Decimal, places: usize, grouped: bool) -> String {
    let whole = decimal.whole();
    let mut text = String::with_capacity(whole.len() * 4 / 3 + places + 1);
    for (i, digit) in whole.chars().enumerate() {
        if grouped && i > 0 && (whole.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    if places > 0 {
        text.push('.');
        text.push_str(&decimal.fraction(places));
    }
    text
}

/// `E+05`: the mark, the sign (a plus only when wanted) and at least so many digits.
pub(super) fn exponent_text(exponent: i32, mark: char, least: usize, plus: bool) -> String {
    let sign = if exponent < 0 {
        "-"
    } else if plus {
        "+"
    } else {
        ""
    };
    format!("{mark}{sign}{:0least$}", exponent.unsigned_abs())
}
