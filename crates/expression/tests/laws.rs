//! Laws that hold for every expression and every number.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

use katydid_expression::{Dialect, Expression, Variant, format, number_text, parse_number};
use proptest::prelude::*;

/// Expressions as text, in x, y and z.
fn expressions() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        Just("x".to_string()),
        Just("y".to_string()),
        Just("z".to_string()),
        Just("pi".to_string()),
        (0..20i32).prop_map(|i| i.to_string()),
        (0.0..100.0f64).prop_map(|x| format!("{x:?}")),
        Just("True".to_string()),
        Just("\"a \"\" b\"".to_string()),
        Just("2i".to_string()),
    ];
    leaf.prop_recursive(6, 60, 3, |inner| {
        let infix = prop::sample::select(vec![
            "+", "-", "*", "/", "\\", "%", "^", "&", "=", "≠", "<", "≤", ">", "≥", "≈", " and ", " or ",
            " xor ", "×", "•", "∠",
        ]);
        prop_oneof![
            (inner.clone(), infix, inner.clone()).prop_map(|(a, o, b)| format!("({a}){o}({b})")),
            (inner.clone(), prop::sample::select(vec!["-", "+", "not "]))
                .prop_map(|(a, o)| format!("{o}({a})")),
            (inner.clone(), prop::sample::select(vec!["²", "³", "!", "°", ".x", ".O", "ⅈ"]))
                .prop_map(|(a, o)| format!("({a}){o}")),
            (
                inner.clone(),
                prop::sample::select(vec!["sin", "Abs", "sqrt", "Round", "CInt", "sign", "CBool", "Int"])
            )
                .prop_map(|(a, f)| format!("{f}({a})")),
            (
                inner.clone(),
                inner.clone(),
                prop::sample::select(vec!["Max", "ATan2", "Sum", "Mean", "Median", "Pow"])
            )
                .prop_map(|(a, b, f)| format!("{f}({a},{b})")),
            (inner.clone(), inner.clone(), inner.clone()).prop_map(|(a, b, c)| format!("if({a},{b},{c})")),
            (inner.clone(), inner.clone(), inner.clone()).prop_map(|(a, b, c)| format!("{{{a},{b},{c}}}")),
            inner.prop_map(|a| format!("[{a}]")),
        ]
    })
}

/// Expressions of numbers only, many of which have a column form.
fn numeric_expressions() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        3 => Just("x".to_string()),
        3 => Just("y".to_string()),
        1 => Just("z".to_string()),
        1 => (0..5i32).prop_map(|i| i.to_string()),
        1 => (0.0..10.0f64).prop_map(|x| format!("{x:?}")),
    ];
    leaf.prop_recursive(5, 40, 3, |inner| {
        let infix = prop::sample::select(vec!["+", "-", "*", "/", "\\", "%", "^", "×"]);
        let test = prop::sample::select(vec!["=", "≠", "<", "≤", ">", "≥", "≈", " and ", " or ", " xor "]);
        prop_oneof![
            4 => (inner.clone(), infix, inner.clone()).prop_map(|(a, o, b)| format!("({a}){o}({b})")),
            1 => inner.clone().prop_map(|a| format!("-({a})")),
            1 => (inner.clone(), prop::sample::select(vec!["²", "³", "!", "°"])).prop_map(|(a, o)| format!("({a}){o}")),
            2 => (inner.clone(), prop::sample::select(vec!["sin", "Abs", "Floor", "Round", "CInt", "sign", "CBool"]))
                .prop_map(|(a, f)| format!("{f}({a})")),
            1 => (inner.clone(), inner.clone(), prop::sample::select(vec!["Max", "Min", "ATan2", "Sum", "Median", "Pow", "HMean", "Round"]))
                .prop_map(|(a, b, f)| format!("{f}({a},{b})")),
            2 => (inner.clone(), test, inner.clone(), inner.clone(), inner)
                .prop_map(|(a, o, b, c, d)| format!("if(({a}){o}({b}),{c},{d})")),
        ]
    })
}

fn awkward_numbers() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -50.0..50.0f64,
        2 => (-6..7i32).prop_map(f64::from),
        1 => Just(0.0),
        1 => Just(-0.0),
        1 => prop::num::f64::NORMAL,
    ]
}

fn any_variant() -> impl Strategy<Value = Variant> {
    prop_oneof![
        Just(Variant::Null),
        any::<bool>().prop_map(Variant::Boolean),
        any::<i32>().prop_map(Variant::Integer),
        any::<f64>().prop_map(Variant::Number),
        ".{0,8}".prop_map(Variant::text),
        (any::<f64>(), -1.0..1.0f64, any::<f64>()).prop_map(|(x, y, z)| Variant::point(x, y, z)),
        Just(Variant::Plane(katydid_geometry::Plane::XY)),
        (-9.0..9.0f64, any::<f64>()).prop_map(|(re, im)| Variant::Complex { re, im }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_text_is_read_or_refused(source in "\\PC{0,60}") {
        if let Err(error) = Expression::parse(&source) {
            prop_assert!(error.span.start <= error.span.end && error.span.end <= source.len());
            let _ = error.render(&source);
        }
    }

    #[test]
    fn any_soup_of_tokens_is_read_or_refused(tokens in prop::collection::vec(prop::sample::select(vec![
        "x", "1", "2.5", "(", ")", "[", "]", "{", "}", ",", "+", "-", "*", "^", "!", "²", "°", ".x", "sin(", "if(", "max(",
        "and", "not", "\"a\"", "=", "<", "≠", "&", " ",
    ]), 0..24), values in prop::collection::vec(any_variant(), 1..2)) {
        let source = tokens.concat();
        match Expression::parse(&source) {
            Err(error) => { let _ = error.render(&source); }
            Ok(expression) => if let Ok(program) = expression.bind(&["x"]) {
                match program.evaluate(&values) {
                    Ok(value) => prop_assert!(value.is_finite() || !values[0].is_finite()),
                    Err(error) => { prop_assert!(error.span.end <= source.len()); let _ = error.render(&source); }
                }
            }
        }
    }

    #[test]
    fn printing_reads_back_as_the_same_tree(source in expressions()) {
        let tree = Expression::parse(&source).unwrap();
        let printed = tree.to_string();
        let again = Expression::parse(&printed);
        prop_assert_eq!(again.as_ref(), Ok(&tree), "{} printed as {}", source, printed);
    }

    #[test]
    fn evaluation_never_panics(source in expressions(), values in prop::collection::vec(any_variant(), 3)) {
        let program = Expression::parse(&source).unwrap().bind(&["x", "y", "z"]).unwrap();
        if let Err(error) = program.evaluate(&values) {
            prop_assert!(!error.to_string().contains("damaged"), "{}", source);
        }
    }

    #[test]
    fn columns_give_the_bits_of_single_values(
        source in numeric_expressions(),
        x in prop::collection::vec(awkward_numbers(), 1..600),
        y in prop::collection::vec(awkward_numbers(), 1..5),
        z in awkward_numbers(),
    ) {
        let program = Expression::parse(&source).unwrap().bind(&["x", "y", "z"]).unwrap();
        let n = x.len();
        let Some(result) = program.evaluate_numbers(&[&x, &y, &[z]], n) else { return Ok(()) };
        prop_assert!(program.is_numeric());
        let single = |i: usize| {
            program.evaluate(&[x[i].into(), y[i.min(y.len() - 1)].into(), z.into()])
        };
        match result {
            Ok(column) => {
                prop_assert_eq!(column.len(), n);
                for (i, value) in column.iter().enumerate() {
                    match single(i) {
                        Ok(Variant::Number(s)) => prop_assert_eq!(s.to_bits(), value.to_bits(), "{} at {}", source, i),
                        other => prop_assert!(false, "{source} at {i}: {other:?}"),
                    }
                }
            }
            Err(error) => {
                prop_assert_eq!(Err(error.error), single(error.index));
                for i in 0..error.index {
                    prop_assert!(single(i).is_ok());
                }
            }
        }
    }

    #[test]
    fn arithmetic_is_that_of_doubles(x in awkward_numbers(), y in awkward_numbers()) {
        let cases: [(&str, f64); 6] = [
            ("x+y", x + y), ("x-y", x - y), ("x*y", x * y), ("-x", -x), ("x²", x * x), ("abs(x)", x.abs()),
        ];
        for (source, expected) in cases {
            let result = Expression::parse(source).unwrap().bind(&["x", "y"]).unwrap().evaluate(&[x.into(), y.into()]);
            match result {
                Ok(Variant::Number(v)) => prop_assert_eq!(v.to_bits(), expected.to_bits()),
                Ok(other) => prop_assert!(false, "{other:?}"),
                Err(_) => prop_assert!(!expected.is_finite()),
            }
        }
    }

    #[test]
    fn integers_follow_the_wide_result(a in any::<i32>(), b in any::<i32>()) {
        let cases = [
            ("a+b", i64::from(a) + i64::from(b)),
            ("a-b", i64::from(a) - i64::from(b)),
            ("a*b", i64::from(a) * i64::from(b)),
        ];
        for (source, wide) in cases {
            let program = Expression::parse(source).unwrap().bind(&["a", "b"]).unwrap();
            let expected = i32::try_from(wide).map_or(Variant::Number(wide as f64), Variant::Integer);
            prop_assert_eq!(program.evaluate(&[a.into(), b.into()]).unwrap(), expected);
        }
    }

    #[test]
    fn full_precision_reads_back(x in any::<f64>()) {
        prop_assume!(x.is_finite());
        let text = number_text(x, Dialect::Modern);
        prop_assert_eq!(parse_number(&text).unwrap().to_bits(), x.to_bits());
        let old = parse_number(&number_text(x, Dialect::Framework));
        prop_assert!(old.is_none_or(|o| (o - x).abs() <= 1e-14 * x.abs()));
    }

    #[test]
    fn fixed_decimals_are_the_nearest(x in -1e9..1e9f64, places in 0usize..8) {
        let text = format(&format!("{{0:F{places}}}"), &[x.into()], Dialect::Modern).unwrap();
        // Rust rounds the exact value too, halves to even: equal but for exact halves.
        let rust = format!("{x:.places$}");
        let half = (x.abs() * 2f64.powi(1 + places as i32)).fract() == 0.0;
        prop_assert!(text == rust || half, "{text} {rust}");
        let custom = format(&format!("{{0:0.{}}}", "0".repeat(places)), &[x.into()], Dialect::Framework).unwrap();
        let old = format(&format!("{{0:F{places}}}"), &[x.into()], Dialect::Framework).unwrap();
        if places > 0 {
            prop_assert_eq!(custom, old);
        }
    }

    #[test]
    fn any_pattern_is_applied_or_refused(pattern in "\\PC{0,30}", values in prop::collection::vec(any_variant(), 0..3)) {
        let _ = format(&pattern, &values, Dialect::Modern).map_err(|e| e.to_string());
    }

    #[test]
    fn any_form_is_applied_or_refused(form in "[0#.,%;E+\\-e'\"\\\\a-zA-Z0-9‰ ]{0,14}", value in any_variant()) {
        for dialect in [Dialect::Modern, Dialect::Framework] {
            let _ = katydid_expression::format::format_value(&value, &form, dialect).map_err(|e| e.to_string());
        }
    }
}
