//! The column form: which programs have one, repeating of short columns, and errors.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use katydid_expression::{EvalErrorKind, Expression, Program, Variant};

fn program(source: &str) -> Program {
    Expression::parse(source).unwrap().bind(&["x", "y"]).unwrap()
}

#[test]
fn programs_about_numbers_have_a_column_form() {
    for source in [
        "x",
        "2*π*x",
        "-x",
        "x²+y³",
        "x!",
        "x°",
        "if(x>y,x,y)",
        "if(x>0 and not(y>0), 1, -1)*x",
        "if(x>0, 1, x)*1.5",
        "Max(0, x)",
        "Max(0, (x-1)\\2)",
        "Round(x, 2)",
        "x*CInt(y/x)",
        "Sign(x)*Sqrt(Abs(x))",
        "Mean(1, 2, 4)+x",
        "e^(-(x-y)²/2)/((2*π)^.5)",
        "7/2",
    ] {
        assert!(program(source).is_numeric(), "{source}");
    }
}

#[test]
fn others_do_not() {
    for source in [
        "x>y",
        "1",
        "CInt(x)",
        "x & y",
        "{x,y,0}",
        "x.X",
        "if(x>0,1,0)",
        "if(x>0,1,x)",
        "CInt(x)+1",
        "2i*x",
        "[x]",
    ] {
        let program = program(source);
        assert!(!program.is_numeric(), "{source}");
        assert!(program.evaluate_numbers(&[&[1.0], &[1.0]], 1).is_none(), "{source}");
    }
}

#[test]
fn short_columns_repeat_their_last_value() {
    let x: Vec<f64> = (0..1000).map(f64::from).collect();
    let sums = program("x+y").evaluate_numbers(&[&x, &[10.0, 20.0, 30.0]], 1000).unwrap().unwrap();
    assert_eq!(sums.get(..4).unwrap(), [10.0, 21.0, 32.0, 33.0]);
    assert_eq!(sums.last(), Some(&1029.0));
    let longer = program("x").evaluate_numbers(&[&x, &[]], 1003).unwrap().unwrap();
    assert_eq!(longer.get(999..).unwrap(), [999.0; 4]);
    assert_eq!(program("x").evaluate_numbers(&[&x], 0), Some(Ok(vec![])));
}

#[test]
fn missing_and_empty_columns_are_declined() {
    assert_eq!(program("x+y").evaluate_numbers(&[&[1.0], &[]], 1), None);
    assert_eq!(program("x+y").evaluate_numbers(&[&[1.0]], 1), None);
    assert_eq!(program("x").evaluate_numbers(&[&[1.0]], usize::MAX), None);
}

#[test]
fn the_first_value_without_a_result_is_named() {
    let mut x = vec![1.0; 700];
    x[600] = 0.0;
    x[650] = 0.0;
    let error = program("1/x").evaluate_numbers(&[&x], 700).unwrap().unwrap_err();
    assert_eq!((error.index, error.error.kind.clone()), (600, EvalErrorKind::DivisionByZero));
    assert_eq!(error.to_string(), "value 600: division by zero");
    x[300] = -1.0;
    let error = program("Sqrt(x)/x").evaluate_numbers(&[&x], 700).unwrap().unwrap_err();
    assert_eq!(error.index, 300);
    assert_eq!(Err(error.error), program("Sqrt(x)/x").evaluate(&[Variant::Number(-1.0), Variant::Null]));
}
