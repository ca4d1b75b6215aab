//! Numbers in source text.

use super::token::{IntSuffix, Tok};

type Refused = (u16, &'static str);

/// Reads the number that a text begins with, and its length in bytes.
pub(super) fn read(text: &str) -> Result<(Tok, usize), Refused> {
    let bytes = text.as_bytes();
    match bytes.get(1) {
        Some(b'x' | b'X') if bytes[0] == b'0' => return radix(text, 16),
        Some(b'b' | b'B') if bytes[0] == b'0' => return radix(text, 2),
        _ => {}
    }
    let digits = |mut at: usize| {
        while bytes.get(at).is_some_and(|b| b.is_ascii_digit() || *b == b'_') {
            at += 1;
        }
        at
    };
    let mut end = digits(0);
    let mut real = false;
    if bytes.get(end) == Some(&b'.') && bytes.get(end + 1).is_some_and(u8::is_ascii_digit) {
        real = true;
        end = digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        if bytes.get(end + 1 + sign).is_some_and(u8::is_ascii_digit) {
            real = true;
            end = digits(end + 1 + sign);
        }
    }
    let clean: String = text[..end].chars().filter(|c| *c != '_').collect();
    let suffix = bytes.get(end).map(u8::to_ascii_lowercase);
    let double = || clean.parse::<f64>().unwrap_or(f64::INFINITY);
    match suffix {
        Some(b'f') => {
            let value = clean.parse::<f32>().unwrap_or(f32::INFINITY);
            return if value.is_finite() { Ok((Tok::Float(value), end + 1)) } else { Err(TOO_REAL) };
        }
        Some(b'd') => return finite(double(), end + 1),
        Some(b'm') => return Ok((Tok::Decimal(clean.into()), end + 1)),
        _ if real => return finite(double(), end),
        _ => {}
    }
    let value = clean.parse::<u64>().map_err(|_| TOO_LARGE)?;
    let (suffix, length) = int_suffix(&text[end..]);
    Ok((Tok::Int(value, suffix), end + length))
}

const TOO_LARGE: Refused = (1021, "Integral constant is too large");
const TOO_REAL: Refused = (594, "Floating-point constant is outside the range of type 'double'");

fn finite(value: f64, length: usize) -> Result<(Tok, usize), Refused> {
    if value.is_finite() { Ok((Tok::Double(value), length)) } else { Err(TOO_REAL) }
}

fn radix(text: &str, radix: u32) -> Result<(Tok, usize), Refused> {
    let body = &text[2..];
    let end = body.find(|c: char| !(c.is_digit(radix) || c == '_')).unwrap_or(body.len());
    let clean: String = body[..end].chars().filter(|c| *c != '_').collect();
    if clean.is_empty() {
        return Err((1013, "Invalid number"));
    }
    let value = u64::from_str_radix(&clean, radix).map_err(|_| TOO_LARGE)?;
    let (suffix, length) = int_suffix(&body[end..]);
    Ok((Tok::Int(value, suffix), 2 + end + length))
}

fn int_suffix(text: &str) -> (IntSuffix, usize) {
    let lower = |i: usize| text.as_bytes().get(i).map(u8::to_ascii_lowercase);
    match (lower(0), lower(1)) {
        (Some(b'u'), Some(b'l')) | (Some(b'l'), Some(b'u')) => (IntSuffix::Ul, 2),
        (Some(b'u'), _) => (IntSuffix::U, 1),
        (Some(b'l'), _) => (IntSuffix::L, 1),
        _ => (IntSuffix::None, 0),
    }
}
