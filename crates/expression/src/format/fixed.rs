//! The commonest forms, a fixed number of decimals, without going through decimal digits.

/// As many decimals as are worked out here.
const MOST: usize = 9;

/// Powers of ten.
const TENS: [u64; MOST + 1] =
    [1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000, 1_000_000_000];

/// Writes a number in a form that asks for so many decimals and nothing else: `0`, `0.00`, `F2`. Writes nothing and says
/// so for other forms, for numbers of more than 14 digits, and where the last digit is in doubt: forms round by the
/// exact decimal value or by its first 15 digits, halves away from zero, and here it is the product with a power of
/// ten, off by 2⁻⁵³ of it at the most.
pub(super) fn push(x: f64, form: &str, out: &mut String) -> bool {
    let Some(&ten) = places(form).and_then(|places| TENS.get(places)) else { return false };
    let scaled = x.abs() * ten as f64;
    if scaled.is_nan() || scaled >= 1e14 {
        return false;
    }
    let whole = scaled.floor();
    let past_half = scaled - whole - 0.5;
    // Fifteen digits are off by half of the fifteenth: 5e-15 of the number.
    if past_half.abs() <= 1e-14 * scaled.max(1.0) {
        return false;
    }
    let units = whole as u64 + u64::from(past_half > 0.0);
    if x.is_sign_negative() {
        if units == 0 {
            return false;
        }
        out.push('-');
    }
    digits(units / ten, 1, out);
    if ten > 1 {
        out.push('.');
        digits(units % ten, ten.ilog10() as usize, out);
    }
    true
}

/// The decimals that a form asks for, when that is all it does.
fn places(form: &str) -> Option<usize> {
    match form.as_bytes() {
        b"0" => Some(0),
        [b'0', b'.', zeros @ ..] if !zeros.is_empty() && zeros.iter().all(|c| *c == b'0') => {
            Some(zeros.len())
        }
        [b'F' | b'f', digit @ b'0'..=b'9'] => Some(usize::from(digit - b'0')),
        _ => None,
    }
}

/// A whole number below 10²⁰ in at least `least` digits.
fn digits(mut n: u64, least: usize, out: &mut String) {
    let mut text = [b'0'; 20];
    let mut from = text.len();
    while n > 0 || text.len() - from < least {
        from -= 1;
        text[from] = b'0' + (n % 10) as u8;
        n /= 10;
    }
    out.extend(text[from..].iter().map(|digit| char::from(*digit)));
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::{Dialect, standard};
    use super::*;

    fn pushed(x: f64, form: &str) -> Option<String> {
        let mut text = String::new();
        push(x, form, &mut text).then_some(text)
    }

    #[test]
    fn doubt_is_left_to_others() {
        assert_eq!(pushed(1234.567, "0.00").as_deref(), Some("1234.57"));
        assert_eq!(pushed(-0.25, "F4").as_deref(), Some("-0.2500"));
        assert_eq!(pushed(0.0, "0").as_deref(), Some("0"));
        for x in [0.125, 1.005, -0.001, f64::NAN, f64::INFINITY, 1e14, 0.3 + 1e-17 + 0.025 - 0.02] {
            assert!(
                pushed(x, "0.00")
                    .is_none_or(|text| text == standard::format_number(x, "0.00", Dialect::Modern).unwrap())
            );
        }
        assert_eq!((pushed(0.125, "0.00"), pushed(-0.001, "0.00"), pushed(1.0, "#.0")), (None, None, None));
    }

    proptest! {
        #[test]
        fn as_by_decimal_digits(
            x in prop_oneof![
                -1e6..1e6_f64,
                any::<f64>(),
                (-1_000_000_i64..1_000_000, 1_i32..8).prop_map(|(n, p)| n as f64 / 10_f64.powi(p)),
                (-100_000_i64..100_000, 1_i32..8).prop_map(|(n, p)| (n as f64 + 0.5) / 10_f64.powi(p)),
            ],
            form in prop_oneof![Just("0"), Just("0.0"), Just("0.00"), Just("0.000000"), Just("F0"), Just("F3"), Just("f9")],
        ) {
            for dialect in [Dialect::Modern, Dialect::Framework] {
                if let Some(text) = pushed(x, form) {
                    prop_assert_eq!(&text, &standard::format_number(x, form, dialect).unwrap(), "{} {}", x, form);
                }
            }
        }
    }
}
