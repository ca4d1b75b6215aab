//! What is found in slices is what is found in one piece.

#![allow(clippy::panic, clippy::unwrap_used, reason = "a test may fail loudly")]

use std::time::Duration;

use katydid_component::Cancel;
use katydid_definition::kd;
use katydid_session::Registry;
use katydid_solver::Options;
use katydid_study::{
    Effort, Inquiry, Output, Prepared, RangeSettings, StudyError, effects_here, effects_over_range,
    inputs_of, solve_for,
};

/// Definitions with a result: smooth ones, a jump, a change of count, a corner, whole numbers, a gene pool, a result that fails.
const CASES: [(&str, &str); 8] = [
    ("x = Number Slider(0.7, 0.00..2.00)\nf = Expression(\"Sin(x)*Exp(-x)\", x = x)\n", "f"),
    (
        "x = Number Slider(0.7, 0.00..2.00)\ny = Number Slider(1.5, 0.0..3.0)\nm = Multiplication(x, y)\n\
         s = Sine(m)\nt = Addition(s, x)\n",
        "t",
    ),
    ("x = Number Slider(2.4, 0.00..9.00)\nf = Expression(\"Floor(x)*x\", x = x)\n", "f"),
    (
        "x = Number Slider(2.4, 0.00..9.00)\ns = Series(0, 1, x)\nt = Mass Addition(s)\nu = Addition(t, x)\n",
        "u",
    ),
    ("x = Number Slider(1.0, 0.00..2.00)\nf = Expression(\"Abs(x - 1)\", x = x)\n", "f"),
    ("n = Number Slider(4, 0..9)\nx = Number Slider(0.50, 0.00..1.00)\nm = Multiplication(n, x)\n", "m"),
    ("x = Number Slider(1.00, 0.00..2.00)\nf = Expression(\"1/(x - 1.5)\", x = x)\n", "f"),
    ("x = Number Slider(0.50, 0.00..1.00)\ns = Series(0, x, 3)\n", "s"),
];

fn prepared((text, output): (&str, &str)) -> Prepared {
    katydid_components::link();
    let document = kd::read(&format!("katydid 1\n{text}"), &Registry).unwrap().document;
    let output = Output::find(&document, output).unwrap();
    let variables = inputs_of(&document, &output).unwrap();
    Prepared::new(document, Options::default(), variables, vec![output])
}

/// Asks with slices of no time, so that each has one solve, until there is an answer; and how many slices there were.
fn patient<T>(mut ask: impl FnMut() -> Option<Result<T, StudyError>>) -> (Result<T, String>, usize) {
    let mut slices = 1;
    loop {
        match ask() {
            Some(answer) => return (answer.map_err(|error| error.to_string()), slices),
            None => slices += 1,
        }
    }
}

#[test]
fn effects_here_are_the_same_in_slices() {
    for case in CASES {
        let whole = effects_here(&prepared(case), &Cancel::default()).map_err(|error| error.to_string());
        let mut inquiry = Inquiry::new(prepared(case));
        let (found, slices) = patient(|| inquiry.effects_here(Duration::ZERO));
        assert_eq!(found, whole, "{case:?}");
        assert!(slices > 1 || whole.is_err(), "{case:?}: {slices}");
        // All of it is known by then.
        assert_eq!(patient(|| inquiry.effects_here(Duration::ZERO)).1, 1, "{case:?}");
    }
}

#[test]
fn effects_over_ranges_are_the_same_in_slices() {
    for case in CASES {
        let settings = RangeSettings { pairs: 16, seed: 1, workers: 2, cancel: Cancel::default() };
        let whole = effects_over_range(&prepared(case), &settings).map_err(|error| error.to_string());
        let mut inquiry = Inquiry::new(prepared(case));
        let (found, slices) = patient(|| inquiry.effects_over_range(16, 1, Duration::ZERO));
        assert_eq!(found, whole, "{case:?}");
        assert_eq!(slices, whole.map_or(1, |(_, points, _)| points), "{case:?}");
    }
}

#[test]
fn inputs_for_a_wanted_result_are_the_same_in_slices() {
    for (case, wanted) in CASES.into_iter().zip([0.2, 1.3, 7.0, 12.0, 0.25, 3.0, -4.0, 1.0]) {
        let effort = Effort::default();
        let told = |error: StudyError| error.to_string();
        let whole = solve_for(&prepared(case), &[wanted], effort, &Cancel::default()).map_err(told);
        let mut inquiry = Inquiry::new(prepared(case));
        let (found, slices) = patient(|| inquiry.solve_for(&[wanted], effort, Duration::ZERO));
        assert_eq!(found, whole, "{case:?}");
        assert!(slices > 1 || whole.is_err(), "{case:?}: {slices}");
    }
}

#[test]
fn what_was_found_by_the_end_of_the_time_is_not_lost() {
    // No time is left in the first slice already: the answer is that of one piece without time.
    let case = CASES[1];
    let effort = Effort { time: Some(Duration::ZERO), ..Effort::default() };
    let whole = solve_for(&prepared(case), &[1.3], effort, &Cancel::default()).unwrap();
    let mut inquiry = Inquiry::new(prepared(case));
    let (found, _) = patient(|| inquiry.solve_for(&[1.3], effort, Duration::ZERO));
    let found = found.unwrap();
    assert!(found.off <= whole.off, "{found:?} {whole:?}");
    // Where the time ends between two slices, what the slices before it found stays found.
    let begun = || Inquiry::new(prepared(case));
    let mut slow = begun();
    for _ in 0..12 {
        assert!(slow.solve_for(&[1.3], Effort::default(), Duration::ZERO).is_none());
    }
    let (late, slices) = patient(|| slow.solve_for(&[1.3], effort, Duration::ZERO));
    assert!(late.as_ref().unwrap().off < found.off, "{late:?} {found:?}");
    // It stops there, but for the solve that finds the time over and that at the rounded inputs.
    assert!(slices <= 3, "{slices}");
}
