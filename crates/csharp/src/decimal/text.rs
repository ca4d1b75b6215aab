//! Decimals read from texts.

use super::{BEYOND, Decimal, MOST_SCALE, of_parts};

/// Why a text is no number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Unread {
    Form,
    TooLarge,
}

/// A number from digits with a point, thousands and a sign before or behind them; with an exponent where that is
/// allowed. Digits that have no room are rounded, halves to the even digit.
pub(crate) fn read(text: &str, exponents: bool) -> Result<Decimal, Unread> {
    let text = text.trim_matches(|c: char| c.is_ascii_whitespace());
    let (mut body, mut negative) = (text, false);
    if let Some(rest) = body.strip_prefix(['+', '-']) {
        negative = body.starts_with('-');
        body = rest;
    } else if let Some(rest) = body.strip_suffix(['+', '-']) {
        negative = body.ends_with('-');
        body = rest.trim_end();
    }
    let mut power = 0_i64;
    if exponents && let Some((mantissa, exponent)) = body.split_once(['e', 'E']) {
        power = exponent.parse().map_err(|_| Unread::Form)?;
        body = mantissa;
    }
    let (whole, part) = body.split_once('.').unwrap_or((body, ""));
    if whole.starts_with(',') || whole.is_empty() && part.is_empty() {
        return Err(Unread::Form);
    }
    let whole: Vec<u8> = whole.bytes().filter(|b| *b != b',').collect();
    if !whole.iter().copied().chain(part.bytes()).all(|b| b.is_ascii_digit()) {
        return Err(Unread::Form);
    }
    let digits = whole.iter().copied().chain(part.bytes()).map(|b| b - b'0');
    let scale = part.len() as i64 - power.clamp(-100_000, 100_000);
    gathered(digits, whole.len() + part.len(), scale, negative).ok_or(Unread::TooLarge)
}

/// The number of digits of which the last stands so many places behind the point.
fn gathered(digits: impl Iterator<Item = u8>, count: usize, scale: i64, negative: bool) -> Option<Decimal> {
    let mut made = 0_u128;
    // How many places behind the point the last digit that was taken stands.
    let mut at = scale - count as i64;
    let mut digits = digits.peekable();
    let (mut half, mut tail) = (0, false);
    while let Some(digit) = digits.peek().copied() {
        let next = made * 10 + u128::from(digit);
        if next >= BEYOND || at >= i64::from(MOST_SCALE) {
            half = digit;
            digits.next();
            tail = digits.any(|d| d != 0);
            break;
        }
        digits.next();
        made = next;
        at += 1;
    }
    if at > i64::from(MOST_SCALE) {
        // All digits stand behind the last place.
        return Some(of_parts(0, MOST_SCALE, negative));
    }
    if half > 5 || half == 5 && (tail || made % 2 == 1) {
        made += 1;
        if made == BEYOND {
            // One digit less; 2^96 / 10 ends in a 6 rounded up.
            made = BEYOND / 10 + 1;
            at -= 1;
        }
    }
    if made == 0 {
        return Some(of_parts(0, at.clamp(0, i64::from(MOST_SCALE)) as u32, negative));
    }
    while at < 0 {
        made = made.checked_mul(10).filter(|m| *m < BEYOND)?;
        at += 1;
    }
    Some(of_parts(made, at as u32, negative))
}
