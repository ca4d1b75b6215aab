//! Numbers as .NET prints and reads them with the invariant culture.

/// The bits of .NET's `Double.NaN`, whose sign is set.
const NAN: u64 = 0xfff8_0000_0000_0000;
/// The bits of .NET's `Single.NaN`.
const NAN32: u32 = 0xffc0_0000;

/// The shortest digits that read back as the same number; with an exponent below 1E-05 and from 1E+15, as "R"
/// formatting has it.
pub(super) fn double(x: f64) -> String {
    if x.is_finite() { finite(&format!("{x:e}"), &x.to_string(), 15) } else { special(x) }
}

/// The same for 32 bits, with an exponent from 1E+07.
pub(super) fn single(x: f32) -> String {
    if x.is_finite() { finite(&format!("{x:e}"), &x.to_string(), 7) } else { special(f64::from(x)) }
}

fn special(x: f64) -> String {
    if x.is_nan() {
        "NaN".to_owned()
    } else if x > 0.0 {
        "Infinity".to_owned()
    } else {
        "-Infinity".to_owned()
    }
}

fn finite(scientific: &str, plain: &str, from: i32) -> String {
    let Some((digits, exponent)) = scientific.split_once('e') else { return plain.to_owned() };
    let Ok(exponent) = exponent.parse::<i32>() else { return plain.to_owned() };
    if (-4..from).contains(&exponent) {
        return plain.to_owned();
    }
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{digits}E{sign}{:02}", exponent.unsigned_abs())
}

/// Reads a number. Text that rounds past the largest number is that number: .NET's 15 digits of it do.
pub(super) fn read_double(text: &str) -> Option<f64> {
    match word(text) {
        Some(x) if x.is_nan() => Some(f64::from_bits(NAN)),
        Some(x) => Some(x),
        None => text.parse::<f64>().ok().map(|x| x.clamp(f64::MIN, f64::MAX)),
    }
}

/// The same for 32 bits.
pub(super) fn read_single(text: &str) -> Option<f32> {
    match word(text) {
        Some(x) if x.is_nan() => Some(f32::from_bits(NAN32)),
        Some(x) if x > 0.0 => Some(f32::INFINITY),
        Some(_) => Some(f32::NEG_INFINITY),
        None => text.parse::<f32>().ok().map(|x| x.clamp(f32::MIN, f32::MAX)),
    }
}

/// The numbers that are words.
fn word(text: &str) -> Option<f64> {
    let is = |word: &str| text.eq_ignore_ascii_case(word);
    if is("NaN") || is("-NaN") {
        Some(f64::NAN)
    } else if is("Infinity") || is("+Infinity") || is("inf") || text == "∞" {
        Some(f64::INFINITY)
    } else if is("-Infinity") || is("-inf") || text == "-∞" {
        Some(f64::NEG_INFINITY)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn doubles_look_like_dot_net() {
        for (x, text) in [
            (0.0, "0"),
            (-0.0, "-0"),
            (0.1 + 0.2, "0.30000000000000004"),
            (1e15, "1E+15"),
            (123_456_789_012_345.0, "123456789012345"),
            (0.00001, "1E-05"),
            (0.0001, "0.0001"),
            (f64::MAX, "1.7976931348623157E+308"),
            (f64::NEG_INFINITY, "-Infinity"),
        ] {
            assert_eq!(double(x), text);
            assert_eq!(read_double(text), Some(x));
        }
        assert_eq!(read_double("1.79769313486232E+308"), Some(f64::MAX));
        assert_eq!(read_double("nan").map(f64::to_bits), Some(NAN));
        assert_eq!(read_double("1,5"), None);
        assert_eq!(single(1.095_029), "1.095029");
        assert_eq!(single(f32::MAX), "3.4028235E+38");
    }
}
