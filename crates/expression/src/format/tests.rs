use super::*;
use crate::Variant;

fn one(form: &str, x: f64) -> String {
    format(&format!("{{0:{form}}}"), &[Variant::Number(x)], Dialect::Modern).unwrap()
}

fn old(form: &str, x: f64) -> String {
    format(&format!("{{0:{form}}}"), &[Variant::Number(x)], Dialect::Framework).unwrap()
}

fn whole(form: &str, i: i32) -> String {
    format(&format!("{{0:{form}}}"), &[Variant::Integer(i)], Dialect::Modern).unwrap()
}

#[test]
fn full_precision_and_the_switch_to_exponents() {
    let modern = |x| number_text(x, Dialect::Modern);
    assert_eq!(modern(0.1 + 0.2), "0.30000000000000004");
    assert_eq!(modern(1.0 / 3.0), "0.3333333333333333");
    assert_eq!(modern(std::f64::consts::PI), "3.141592653589793");
    assert_eq!(modern(-60.0), "-60");
    assert_eq!(modern(1e14), "100000000000000");
    assert_eq!(modern(1e16), "1E+16");
    assert_eq!(modern(9007199254740992.0), "9007199254740992");
    assert_eq!(modern(1.2345678901234568e17), "1.2345678901234568E+17");
    assert_eq!(modern(0.0001), "0.0001");
    assert_eq!(modern(0.00001), "1E-05");
    assert_eq!(modern(1.5e-10), "1.5E-10");
    assert_eq!(modern(-0.0), "-0");
    assert_eq!(modern(f64::NAN), "NaN");
    assert_eq!(modern(f64::NEG_INFINITY), "-Infinity");
    let framework = |x| number_text(x, Dialect::Framework);
    assert_eq!(framework(0.1 + 0.2), "0.3");
    assert_eq!(framework(std::f64::consts::PI), "3.14159265358979");
    assert_eq!(framework(-0.0), "0");
    assert_eq!(framework(9007199254740992.0), "9.00719925474099E+15");
}

#[test]
fn standard_forms() {
    assert_eq!(one("F", 1234.567), "1234.57");
    assert_eq!(one("F0", 2.5), "3");
    assert_eq!(one("F2", -0.125), "-0.13");
    assert_eq!(one("F2", 0.0), "0.00");
    assert_eq!(one("F3", 1e-9), "0.000");
    assert_eq!(one("F2", 0.999), "1.00");
    assert_eq!(one("N", 1234567.891), "1,234,567.89");
    assert_eq!(one("N0", -999.5), "-1,000");
    assert_eq!(one("N1", 100.0), "100.0");
    assert_eq!(one("E", 12345.678), "1.234568E+004");
    assert_eq!(one("e2", 0.00012), "1.20e-004");
    assert_eq!(one("E2", 0.0), "0.00E+000");
    assert_eq!(one("P", 0.1234), "12.34 %");
    assert_eq!(one("P0", 12.345), "1,235 %");
    assert_eq!(one("C", 1234.5), "¤1,234.50");
    assert_eq!(one("C", -1.0), "(¤1.00)");
    assert_eq!(one("G", 0.1), "0.1");
    assert_eq!(one("G3", 1234.5), "1.23E+03");
    assert_eq!(one("G4", 1234.5), "1235");
    assert_eq!(one("g2", 0.000012), "1.2e-05");
    assert_eq!(one("R", 0.1 + 0.2), "0.30000000000000004");
}

#[test]
fn exact_decimals_now_fifteen_digits_then() {
    // 2.675 lies below the half, which 15 digits do not show.
    assert_eq!(one("F2", 2.675), "2.67");
    assert_eq!(old("F2", 2.675), "2.68");
    assert_eq!(one("F20", 0.1), "0.10000000000000000555");
    assert_eq!(old("F20", 0.1), "0.10000000000000000000");
    assert_eq!(one("F0", 1e22), "10000000000000000000000");
    assert_eq!(one("F1", 1e23), "99999999999999991611392.0");
    assert_eq!((one("F2", -0.001).as_str(), old("F2", -0.001).as_str()), ("-0.00", "0.00"));
}

#[test]
fn integers() {
    assert_eq!(whole("D5", -42), "-00042");
    assert_eq!(whole("D", 7), "7");
    assert_eq!(whole("X", 255), "FF");
    assert_eq!(whole("x4", 255), "00ff");
    assert_eq!(whole("X", -1), "FFFFFFFF");
    assert_eq!(whole("N0", 1234567), "1,234,567");
    assert_eq!(whole("F1", i32::MIN), "-2147483648.0");
    assert_eq!(whole("000", 7), "007");
    assert_eq!(whole("G2", 12345), "1.2E+04");
    assert_eq!(whole("0,", -4), "0");
}

#[test]
fn custom_forms() {
    assert_eq!(one("0.00", 2.7654), "2.77");
    assert_eq!(one("0.0m²", 12.34), "12.3m²");
    assert_eq!(one("#.##", 0.0), "");
    assert_eq!(one("#.##", 0.5), ".5");
    assert_eq!(one("0.##", 2.0), "2");
    assert_eq!(one("0.##", 2.345), "2.35");
    assert_eq!(one("00.0", 3.0), "03.0");
    assert_eq!(one("#,##0.0", 1234567.85), "1,234,567.9");
    assert_eq!(one("#,##0", 0.0), "0");
    assert_eq!(one("#,#", 1234.0), "1,234");
    assert_eq!(one("0,000", 12.0), "0,012");
    assert_eq!(one("0,,", 123456789.0), "123");
    assert_eq!(one("0.0,", 12345.0), "12345.0");
    assert_eq!(one("0%", 0.256), "26%");
    assert_eq!(one("0.0‰", 0.0256), "25.6‰");
    assert_eq!(one("0.###E+0", 86000.0), "8.6E+4");
    assert_eq!(one("0.00e-00", 0.00123), "1.23e-03");
    assert_eq!(one("00.0E0", 12345.0), "12.3E3");
    assert_eq!(one("0.0;(0.0);none", 1.25), "1.3");
    assert_eq!(one("0.0;(0.0);none", -1.25), "(1.3)");
    assert_eq!(one("0.0;(0.0);none", 0.0), "none");
    assert_eq!(one("0.0;(0.0);none", -0.01), "none");
    assert_eq!(one("0;;zero", -5.0), "-5");
    assert_eq!(one("'#'0", 5.0), "#5");
    assert_eq!(one("\\#0\\;", 5.0), "#5;");
    assert_eq!(one("0 \"a;b\"", 5.0), "5 a;b");
    assert_eq!(one("(###) ###-####", 1234567890.0), "(123) 456-7890");
    assert_eq!(one("mm 0", 3.0), "mm 3");
    assert_eq!((one("0.00", -0.001).as_str(), old("0.00", -0.001).as_str()), ("-0.00", "0.00"));
    assert_eq!(one("0", 0.5), "1");
    assert_eq!(one("0.0000000000000000000", 0.1), "0.1000000000000000000");
}

#[test]
fn composite() {
    let v = [
        Variant::Integer(1),
        Variant::Number(2.5),
        Variant::text("x"),
        Variant::Null,
        Variant::Boolean(true),
    ];
    let f = |p: &str| format(p, &v, Dialect::Modern);
    assert_eq!(f("{0} To {1}").unwrap(), "1 To 2.5");
    assert_eq!(f("{1,8:F2}|{2,-4}|{2,3}|").unwrap(), "    2.50|x   |  x|");
    assert_eq!(f("{{{0}}} {0}{0}").unwrap(), "{1} 11");
    assert_eq!(f("[{3}] {4} {2:F2}").unwrap(), "[] True x");
    assert_eq!(f("{ 0 , 3 }").unwrap(), "  1");
    assert_eq!(f("no items").unwrap(), "no items");
    let p = [Variant::point(1.0, 0.5, -2.0)];
    assert_eq!(format("{0}", &p, Dialect::Modern).unwrap(), "{1, 0.5, -2}");
    assert_eq!(format("{0:0.00}", &p, Dialect::Modern).unwrap(), "{1.00, 0.50, -2.00}");
}

#[test]
fn errors_say_where_and_why() {
    let f = |p: &str| format(p, &[Variant::Integer(1)], Dialect::Modern).unwrap_err();
    assert_eq!(f("{1}"), FormatError::MissingValue { index: 1, count: 1, at: 1 });
    assert_eq!(f("{1}").to_string(), "the item {1} at character 1 has no value: 1 is given");
    assert_eq!(f("a {"), FormatError::LoneBrace { brace: '{', at: 3 });
    assert_eq!(f("a } b"), FormatError::LoneBrace { brace: '}', at: 3 });
    assert_eq!(f("π{x}"), FormatError::BadIndex { at: 2 });
    assert_eq!(f("{0,x}"), FormatError::BadWidth { at: 1 });
    assert_eq!(f("{0,999999999999}"), FormatError::BadWidth { at: 1 });
    assert_eq!(f("{99999999999999999999}"), FormatError::BadIndex { at: 1 });
    assert!(matches!(f("{0:Q}"), FormatError::BadFormat { .. }));
    assert!(matches!(f("{0:D99999999999}"), FormatError::BadFormat { .. }));
    let number = format("{0:D2}", &[Variant::Number(1.0)], Dialect::Modern).unwrap_err();
    assert_eq!(number.to_string(), "'D2' does not fit a Number: D and X take integers only");
}
