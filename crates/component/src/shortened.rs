//! Long numbers in messages.

/// Numbers with more digits than this are shortened. Ids and hashes, which may be of digits alone, are not that long.
const MOST_DIGITS: usize = 64;
/// So many digits are left of what is no number.
const LEFT: usize = 12;

/// The text with every number that has very many digits in a short form: a number of 301 digits as `1e300`. What is too
/// large for that keeps its first digits, and says how many it has.
///
/// ```
/// # use katydid_component::shortened;
/// assert_eq!(shortened(format!("{} is too large", 1e300)), "1e300 is too large");
/// assert_eq!(shortened("12 is too large"), "12 is too large");
/// ```
pub fn shortened(text: impl Into<String>) -> String {
    let text = text.into();
    if text.len() <= MOST_DIGITS {
        return text;
    }
    let mut short = String::new();
    let mut rest = text.as_str();
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let (before, from) = rest.split_at(start);
        let (number, after) = from.split_at(length(from));
        short.push_str(before);
        match number.bytes().filter(u8::is_ascii_digit).count() {
            0..=MOST_DIGITS => short.push_str(number),
            digits => push(&mut short, number, digits),
        }
        rest = after;
    }
    short.push_str(rest);
    short
}

/// The bytes of the digits that a text begins with, and of those behind one point.
fn length(text: &str) -> usize {
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let whole = digits(text);
    match text.get(whole..).and_then(|rest| rest.strip_prefix('.')).map(digits) {
        Some(fraction @ 1..) => whole + 1 + fraction,
        _ => whole,
    }
}

fn push(short: &mut String, number: &str, digits: usize) {
    match number.parse::<f64>() {
        Ok(value) if value.is_finite() && value != 0.0 => short.push_str(&format!("{value:e}")),
        _ => {
            let start: String = number.chars().take(LEFT).collect();
            short.push_str(&format!("{start}… ({digits} digits)"));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_very_long_numbers_are_shortened() {
        for (text, wanted) in [
            (format!("Radius is -{}, which", 1e300), "Radius is -1e300, which".to_owned()),
            (format!("{} and {}", f64::MAX, 1e-300), "1.7976931348623157e308 and 1e-300".to_owned()),
            (format!("x{}y", "9".repeat(400)), "x999999999999… (400 digits)y".to_owned()),
            (format!("{}.", "1".repeat(70)), "1.1111111111111112e69.".to_owned()),
            (format!("0.{}", "0".repeat(400)), "0.0000000000… (401 digits)".to_owned()),
        ] {
            assert_eq!(shortened(text), wanted);
        }
        for text in
            ["", "1.5, 2.25; 3..4 5. .6", "ä1ö", &"7".repeat(64), &"word 12 ".repeat(20), &"é".repeat(90)]
        {
            assert_eq!(shortened(text), text);
        }
    }
}
