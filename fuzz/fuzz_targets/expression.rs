#![no_main]
//! Any text is an expression or an error with a place in it; what it computes is a value or an error.

use katydid_expression::{Dialect, Expression, Variant, format};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &str| {
    let values =
        [Variant::Number(1.5), Variant::Integer(-3), Variant::text(data), Variant::point(1.0, 2.0, 3.0)];
    let _ = format(data, &values, Dialect::Modern);
    let _ = format(data, &values, Dialect::Framework);
    match Expression::parse(data) {
        Err(error) => {
            assert!(error.span.start <= error.span.end && error.span.end <= data.len());
            let _ = error.render(data);
        }
        Ok(expression) => {
            let printed = expression.to_string();
            // Printing may lengthen a text beyond what is read.
            if printed.len() < katydid_expression::MAX_LENGTH
                && let Ok(again) = Expression::parse(&printed)
            {
                assert!(again == expression, "{data:?} printed as {printed:?}");
            }
            let Ok(program) = expression.bind(&["x", "y", "z", "p"]) else { return };
            if let Err(error) = program.evaluate(&values) {
                let _ = error.render(data);
            }
            let columns: [&[f64]; 4] = [&[1.0, 0.0, -2.5], &[3.0], &[0.5], &[1e300]];
            if let Some(Ok(numbers)) = program.evaluate_numbers(&columns, 5) {
                assert!(numbers.len() == 5 && numbers.iter().all(|x| x.is_finite()));
            }
        }
    }
});
