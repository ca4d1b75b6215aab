//! Inputs for wanted results, against closed forms.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use std::fmt::Write;
use std::time::{Duration, Instant};

use katydid_component::Cancel;
use katydid_definition::kd;
use katydid_session::Registry;
use katydid_solver::Options;
use katydid_study::{Effort, Output, Prepared, Solution, StudyError, Variable, inputs_of, solve_for};

fn prepared(text: &str, outputs: &[&str]) -> Prepared {
    katydid_components::link();
    let document = kd::read(&format!("katydid 1\n{text}"), &Registry).unwrap().document;
    let outputs: Vec<Output> = outputs.iter().map(|name| Output::find(&document, name).unwrap()).collect();
    let mut variables: Vec<Variable> = Vec::new();
    for output in &outputs {
        for variable in inputs_of(&document, output).unwrap() {
            if variables.iter().all(|other| other.name != variable.name) {
                variables.push(variable);
            }
        }
    }
    Prepared::new(document, Options { skip_unread: true, ..Options::default() }, variables, outputs)
}

fn solved(text: &str, outputs: &[&str], wanted: &[f64]) -> Result<Solution, StudyError> {
    solve_for(&prepared(text, outputs), wanted, Effort::default(), &Cancel::default())
}

fn near(found: &Solution, inputs: &[f64], within: f64) {
    for (x, expected) in found.inputs.iter().zip(inputs) {
        assert!((x - expected).abs() <= within, "{found:?} for {inputs:?}");
    }
}

#[test]
fn numbers_and_points_are_reached() {
    let square = "x = Number Slider(1, 0.000000..9.000000)\nf = Multiplication(x, x)\n";
    near(&solved(square, &["f"], &[2.0]).unwrap(), &[2.0_f64.sqrt()], 1e-6);
    // A circle's area and a volume above it: the radius and the height.
    let text = "r = Number Slider(1, 0.100000..5.000000)\nh = Number Slider(1, 0.100000..9.000000)\n\
        a = Expression(\"3.141592653589793*r^2\", r = r)\nv = Multiplication(a, h)\n";
    near(
        &solved(text, &["a", "v"], &[12.0, 30.0]).unwrap(),
        &[(12.0 / std::f64::consts::PI).sqrt(), 2.5],
        2e-6,
    );
    // A point on a circle at 60 degrees.
    let text = "r = Number Slider(1, 0.100000..5.000000)\nt = Number Slider(0.2, 0.000000..6.000000)\n\
        x = Expression(\"r*Cos(t)\", r = r, t = t)\ny = Expression(\"r*Sin(t)\", r = r, t = t)\np = Construct Point(x, y, 0)\n";
    let found = solved(text, &["p"], &[1.0, 3.0_f64.sqrt(), 0.0]).unwrap();
    near(&found, &[2.0, std::f64::consts::FRAC_PI_3], 1e-6);
    assert!(found.off < 1e-5, "{found:?}");
}

#[test]
fn ranges_are_kept_and_what_cannot_be_reached_is_come_near_to() {
    // The least of (x + y - 9)² + (x - y - 1)² within x ≤ 3, y ≤ 4: x = 3, y = 4.
    let text = "x = Number Slider(1, 0.0000..3.0000)\ny = Number Slider(1, 0.0000..4.0000)\ns = Addition(x, y)\nd = Subtraction(x, y)\n";
    let found = solved(text, &["s", "d"], &[9.0, 1.0]).unwrap();
    near(&found, &[3.0, 4.0], 1e-4);
    // Only the sliders' own digits are given back, with what they lead to.
    let text = "x = Number Slider(1, 0.0..3.0)\nf = Multiplication(x, x)\n";
    let found = solved(text, &["f"], &[2.0]).unwrap();
    assert_eq!(found.inputs, [1.4]);
    assert!((found.off - 0.04).abs() < 1e-12, "{found:?}");
}

#[test]
fn what_cannot_be_asked_for_is_refused() {
    let whole = "n = Number Slider(3, 1..5)\nf = Multiplication(n, n)\n";
    assert!(matches!(solved(whole, &["f"], &[4.0]), Err(StudyError::Unfit(why)) if why.contains("'n'")));
    let text = "x = Number Slider(1, 0.0..3.0)\nf = Multiplication(x, x)\n";
    assert!(matches!(solved(text, &["f"], &[4.0, 1.0]), Err(StudyError::Unfit(_))));
}

#[test]
fn an_answer_for_three_hundred_objects_comes_while_one_drags() {
    let mut text = "x = Number Slider(1, 0.000000..3.000000)\ny = Number Slider(1, 0.000000..3.000000)\nm0 = Addition(x, y)\n".to_owned();
    for k in 1..298 {
        writeln!(text, "m{k} = Expression(\"0.9*a + 0.1*x*b\", a = m{}, x = x, b = y)", k - 1).unwrap();
    }
    let prepared = prepared(&text, &["m297"]);
    let start = Instant::now();
    let found = solve_for(&prepared, &[2.0], Effort::default(), &Cancel::default()).unwrap();
    assert!(found.off < 1e-5, "{found:?}");
    // A tenth of a second is wanted of the released program on a quiet machine; the tests run on busy ones.
    assert!(start.elapsed() < Duration::from_secs(2), "{:?} for {} solves", start.elapsed(), found.solves);
}
