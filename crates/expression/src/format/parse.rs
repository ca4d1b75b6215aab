/// Reads a number as .NET's `double.Parse` does in the invariant culture: blanks around it, a sign, digits with a
/// decimal point anywhere, an exponent. No thousands marks, and no text for NaN or infinity; a number too large
/// for a double is refused too.
pub fn parse_number(text: &str) -> Option<f64> {
    let text = text.trim_matches(|c: char| c == ' ' || ('\t'..='\r').contains(&c));
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (unsigned, None),
    };
    let digits = |t: &str| !t.is_empty() && t.bytes().all(|b| b.is_ascii_digit());
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let mantissa_is_fine = (digits(whole) && (fraction.is_empty() || digits(fraction)))
        || (whole.is_empty() && digits(fraction));
    let exponent_is_fine = exponent.is_none_or(|e| digits(e.strip_prefix(['+', '-']).unwrap_or(e)));
    if !mantissa_is_fine || !exponent_is_fine {
        return None;
    }
    text.parse::<f64>().ok().filter(|x| x.is_finite())
}

#[cfg(test)]
mod tests {
    use super::parse_number;

    #[test]
    fn what_reads_as_a_number() {
        for (text, value) in [
            ("12", 12.0),
            (" -1.5 ", -1.5),
            ("+.5", 0.5),
            ("5.", 5.0),
            ("1e3", 1000.0),
            ("1E-03", 0.001),
            ("\t7\r\n", 7.0),
            ("00012", 12.0),
        ] {
            assert_eq!(parse_number(text), Some(value), "{text:?}");
        }
        assert!(parse_number("-0").unwrap().is_sign_negative());
    }

    #[test]
    fn what_does_not() {
        for text in [
            "", " ", ".", "-", "1,000", "1 000", "0x10", "inf", "NaN", "Infinity", "1e", "1e+", "e5",
            "1.2.3", "1e400", "--1", "1_0", "٣",
        ] {
            assert_eq!(parse_number(text), None, "{text:?}");
        }
    }
}
