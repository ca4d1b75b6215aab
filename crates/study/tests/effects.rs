//! Effects against derivatives known by hand, jumps that were made on purpose, and variances in closed form.

#![allow(clippy::panic, clippy::unwrap_used, reason = "a test may fail loudly")]

use std::f64::consts::PI;

use katydid_component::Cancel;
use katydid_definition::kd;
use katydid_elementary::Elementary;
use katydid_session::Registry;
use katydid_solver::Options;
use katydid_study::{
    Here, Output, Prepared, RangeSettings, Ranged, Slope, effects_here, effects_over_range, inputs_of,
};

fn prepared(text: &str, output: &str) -> Prepared {
    katydid_components::link();
    let document = kd::read(&format!("katydid 1\n{text}"), &Registry).unwrap().document;
    let output = Output::find(&document, output).unwrap();
    let variables = inputs_of(&document, &output).unwrap();
    let options = Options { skip_unread: true, ..Options::default() };
    Prepared::new(document, options, variables, vec![output])
}

fn here(text: &str, output: &str) -> Vec<Here> {
    effects_here(&prepared(text, output), &Cancel::default()).unwrap().1
}

const CYLINDER: &str = "x = Number Slider(0.7, 0.00..2.00)\nh = Number Slider(3.0, 1.0..5.0)\nc = Circle(plane((0, 0, 0)), x)\n\
        z = Unit Z(h)\ne = Extrude(c, z)\nk = Cap Holes(e)\nv = Volume(k)\nl = Length(c)\na = Area(c)\ns = Area(k)\n";

#[test]
fn derivatives_are_those_worked_by_hand() {
    let x = 0.7;
    let one =
        |formula: &str| format!("x = Number Slider(0.7, 0.00..2.00)\nf = Expression(\"{formula}\", x = x)\n");
    let cylinder = CYLINDER;
    let points = "x = Number Slider(0.7, 0.00..2.00)\ny = Number Slider(1.5, 0.0..3.0)\np = Construct Point(x, y, 0)\n\
        q = Construct Point(2, 3, 0)\nd = Distance(p, q)\nl = Line(p, q)\nn = Length(l)\nt = Mass Addition([x, y, x])\n\
        m = Multiplication(x, y)\nu = Division(x, y)\nw = Power(x, y)\n";
    // A file, an output, and the derivative by each of its sliders.
    let cases: Vec<(String, &str, Vec<f64>)> = vec![
        (one("x"), "f", vec![1.0]),
        (one("3*x - 2"), "f", vec![3.0]),
        (one("x^2"), "f", vec![2.0 * x]),
        (one("x^3 - x"), "f", vec![3.0 * x * x - 1.0]),
        (one("Sin(x)"), "f", vec![x.cosine()]),
        (one("Cos(3*x)"), "f", vec![-3.0 * (3.0 * x).sine()]),
        (one("Tan(x)"), "f", vec![1.0 / (x.cosine() * x.cosine())]),
        (one("Exp(x)"), "f", vec![x.exponential()]),
        (one("Ln(x)"), "f", vec![1.0 / x]),
        (one("Sqrt(x)"), "f", vec![0.5 / x.sqrt()]),
        (one("1/(1 + x^2)"), "f", vec![-2.0 * x / ((1.0 + x * x) * (1.0 + x * x))]),
        (one("Sin(x)*Exp(-x)"), "f", vec![(-x).exponential() * (x.cosine() - x.sine())]),
        (one("Atan(x)"), "f", vec![1.0 / (1.0 + x * x)]),
        (one("Abs(x - 2)"), "f", vec![-1.0]),
        (one("1e6 + x^2"), "f", vec![2.0 * x]),
        (one("1e-6*x^2"), "f", vec![2e-6 * x]),
        (one("Sin(40*x)"), "f", vec![40.0 * (40.0 * x).cosine()]),
        (one("Sqrt(1 + x^4)"), "f", vec![2.0 * x * x * x / (1.0 + x * x * x * x).sqrt()]),
        (one("5"), "f", vec![0.0]),
        (cylinder.to_owned(), "l", vec![2.0 * PI]),
        (cylinder.to_owned(), "a.0", vec![2.0 * PI * x]),
        (points.to_owned(), "d", vec![-1.3 / (1.69_f64 + 2.25).sqrt(), -1.5 / (1.69_f64 + 2.25).sqrt()]),
        (points.to_owned(), "n", vec![-1.3 / (1.69_f64 + 2.25).sqrt(), -1.5 / (1.69_f64 + 2.25).sqrt()]),
        (points.to_owned(), "m", vec![1.5, x]),
        (points.to_owned(), "u", vec![1.0 / 1.5, -x / 2.25]),
        (points.to_owned(), "w", vec![1.5 * x.sqrt(), x.raised_to(1.5) * x.logarithm()]),
        ("x = Number Slider(2.00, 0.00..2.00)\nf = Multiplication(x, x)\n".to_owned(), "f", vec![4.0]),
        (
            "x = Number Slider(0.00, 0.00..2.00)\nf = Expression(\"Sin(x)\", x = x)\n".to_owned(),
            "f",
            vec![1.0],
        ),
    ];
    hold_derivatives(&cases);
}

/// A volume takes some milliseconds, and hundreds are asked for: `make test-effects`.
#[test]
#[ignore = "half a minute"]
fn derivatives_of_solids_are_those_worked_by_hand() {
    let x = 0.7;
    let cylinder = CYLINDER;
    hold_derivatives(&[
        (cylinder.to_owned(), "v.0", vec![2.0 * PI * x * 3.0, PI * x * x]),
        (cylinder.to_owned(), "s.0", vec![4.0 * PI * x + 2.0 * PI * 3.0, 2.0 * PI * x]),
    ]);
}

/// Each file, an output, and the derivative by each of its sliders.
fn hold_derivatives(cases: &[(String, &str, Vec<f64>)]) {
    for (text, output, expected) in cases {
        let found = here(text, output);
        assert_eq!(found.len(), expected.len(), "{output} of {text}");
        for (found, expected) in found.iter().zip(expected) {
            let Slope::Even(slope) = found.slope else { panic!("{found:?} of {output} in {text}") };
            let off = (slope.value - expected).abs();
            let relative = if *expected == 0.0 { off } else { off / expected.abs() };
            assert!(
                relative < 1e-6 && off <= slope.error.max(1e-15),
                "{output}: {slope:?} for {expected} in {text}"
            );
            let holds = found.holds.as_ref().unwrap();
            // Logarithms, quotients and circles fail at 0 alone, where their sliders end; the tangent has a pole.
            let pole = if text.contains("Tan(") { PI / 2.0 } else { 0.0 };
            let is_known = |end: &katydid_study::End| end.is_limit || (end.at - pole).abs() < 1e-9;
            assert!(holds.iter().all(is_known), "{output}: {holds:?} in {text}");
        }
    }
}

#[test]
fn jumps_and_changes_of_count_are_named_with_the_interval_between_them() {
    let one = |formula: &str| {
        format!("x = Number Slider(0.70, 0.00..2.00)\nf = Expression(\"{formula}\", x = x)\n")
    };
    let divided = "x = Number Slider(0.70, 0.10..2.00)\nc = Circle(plane((0, 0, 0)), x)\nf = Divide Length(c, 1)\n\
        n = List Length(f.Points)\ns = Series(0, x, n)\nt = Mass Addition(s)\n";
    let picked = "x = Number Slider(0.70, 0.00..2.00)\nr = Round(x)\nf = List Item([5, 8, 13], r.Floor)\n";
    let third = 1.0 / 3.0;
    // A file, an output, where the answer holds, what is said on each side ("" for the end of the slider), the slope.
    type Case<'a> = (String, &'a str, [f64; 2], [&'a str; 2], f64);
    let cases: Vec<Case<'_>> = vec![
        (one("Floor(x)"), "f", [0.0, 1.0], ["", "jumps from 0 to 1"], 0.0),
        (one("Floor(10*x + 0.5)"), "f", [0.65, 0.75], ["jumps from 7 to 6", "jumps from 7 to 8"], 0.0),
        (one("x + Floor(3*x)"), "f", [2.0 * third, 1.0], ["jumps", "jumps"], 1.0),
        (one("x^2 + 0.001*Floor(x)"), "f", [0.0, 1.0], ["", "jumps"], 1.4),
        (one("If(x < 1.5, Sin(x), 3)"), "f", [0.0, 1.5], ["", "jumps"], 0.7_f64.cosine()),
        (one("If(x > 0.25, x, -x)"), "f", [0.25, 2.0], ["jumps", ""], 1.0),
        (one("Round(x*100)"), "f", [0.695, 0.705], ["jumps", "jumps"], 0.0),
        (one("If(x < 0.9, 2*x, Sqrt(0.5 - x))"), "f", [0.0, 0.9], ["", "f"], 2.0),
        (picked.to_owned(), "f", [0.0, 1.0], ["", "jumps from 5 to 8"], 0.0),
        // 2πx is more than 4, less than 5: five points, of which the sum of 0, x, 2x, 3x, 4x is 10x.
        (
            divided.to_owned(),
            "t.R",
            [2.0 / PI, 2.5 / PI],
            ["gives another count", "gives another count"],
            10.0,
        ),
    ];
    for (text, output, interval, says, expected) in &cases {
        let found = here(text, output);
        let found = &found[0];
        let holds = found.holds.as_ref().unwrap();
        for side in 0..2 {
            let end = &holds[side];
            assert!((end.at - interval[side]).abs() < 1e-9, "{end:?} for {} in {text}", interval[side]);
            assert_eq!(end.is_limit, says[side].is_empty(), "{end:?} in {text}");
            assert!(end.why.contains(says[side]), "{end:?} in {text}");
        }
        let Slope::Even(slope) = found.slope else { panic!("{found:?} in {text}") };
        assert!((slope.value - expected).abs() < 1e-6, "{slope:?} in {text}");
    }
}

#[test]
fn corners_jumps_at_the_value_and_whole_numbers_are_told_as_such() {
    let corner = here("x = Number Slider(0.7, 0.0..2.0)\nf = Expression(\"Abs(x - 0.7)\", x = x)\n", "f");
    let Slope::Corner([Some(left), Some(right)]) = corner[0].slope else { panic!("{corner:?}") };
    assert!((left.value + 1.0).abs() < 1e-6 && (right.value - 1.0).abs() < 1e-6);
    let jump = here("x = Number Slider(1.0, 0.0..2.0)\nf = Expression(\"x + Floor(x)\", x = x)\n", "f");
    let holds = jump[0].holds.as_ref().unwrap();
    assert!((holds[0].at - 1.0).abs() < 1e-9 && !holds[0].is_limit, "{jump:?}");
    let Slope::Even(slope) = jump[0].slope else { panic!("{jump:?}") };
    assert!((slope.value - 1.0).abs() < 1e-6);
    let steps = here("n = Number Slider(3, 1..5)\nf = Multiplication(n, n)\n", "f");
    assert_eq!(steps[0].slope, Slope::Steps { step: 1.0, change: [Some(-5.0), Some(7.0)] });
    let last = here("n = Number Slider(5, 1..5)\nf = Multiplication(n, n)\n", "f");
    assert_eq!(last[0].slope, Slope::Steps { step: 1.0, change: [Some(-9.0), None] });
}

fn ranged(text: &str, pairs: usize) -> Vec<Ranged> {
    let settings = RangeSettings { pairs, seed: 1, workers: 2, cancel: Cancel::default() };
    let prepared = prepared(text, "f");
    let (found, solved, failed) = effects_over_range(&prepared, &settings).unwrap();
    assert_eq!((solved, failed), (pairs * (found.len() + 2) + 20 * (found.len() + 1), 0));
    let again = effects_over_range(&prepared, &RangeSettings { workers: 1, ..settings }).unwrap();
    assert_eq!(again.0, found, "the same for any number of workers");
    found
}

fn hold(found: &[Ranged], expected: &[[f64; 2]]) {
    for (found, [alone, total]) in found.iter().zip(expected) {
        let share = found.share.unwrap();
        // Confidences are of 95 in 100, and rounding of sliders does the rest.
        assert!((share.alone - alone).abs() < 1.5 * share.alone_confidence + 1e-3, "{found:?} for {alone}");
        assert!((share.total - total).abs() < 1.5 * share.total_confidence + 1e-3, "{found:?} for {total}");
        assert!(share.alone_confidence < 0.15 && share.total_confidence < 0.15, "{found:?}");
    }
}

/// Ishigami, Homma 1990: sin x + 7 sin² y + 0.1 z⁴ sin x on [-π, π]³.
#[test]
fn shares_of_ishigamis_function_are_those_in_closed_form() {
    let slider = |name: &str| format!("{name} = Number Slider(0, {:.6}..{:.6})\n", -PI, PI);
    let text = format!(
        "{}{}{}f = Expression(\"Sin(x) + 7*Sin(y)^2 + 0.1*z^4*Sin(x)\", x = x, y = y, z = z)\n",
        slider("x"),
        slider("y"),
        slider("z")
    );
    let (a, b) = (7.0_f64, 0.1_f64);
    let p4 = PI.powi(4);
    let first = 0.5 * (1.0 + b * p4 / 5.0) * (1.0 + b * p4 / 5.0);
    let second = a * a / 8.0;
    let both = b * b * p4 * p4 * (1.0 / 18.0 - 1.0 / 50.0);
    let all = first + second + both;
    let found = ranged(&text, 1024);
    hold(&found, &[[first / all, (first + both) / all], [second / all, second / all], [0.0, both / all]]);
    // z does nothing alone, so its changes go both ways; y's are uneven.
    let screening = found[2].screening.unwrap();
    assert!(screening.mean.abs() <= screening.size && screening.deviation > 0.0);
}

/// Saltelli, Sobol 1995: the product of (|4x - 2| + a) / (1 + a), with variances 1/(3(1 + a)²) of its factors.
#[test]
fn shares_of_the_g_function_are_those_in_closed_form() {
    let a = [0.0, 1.0, 4.5, 9.0];
    let names = ["p", "q", "r", "s"];
    let sliders: String =
        names.iter().map(|name| format!("{name} = Number Slider(0, 0.000000..1.000000)\n")).collect();
    let factors: Vec<String> =
        names.iter().zip(a).map(|(name, a)| format!("(Abs(4*{name} - 2) + {a})/(1 + {a})")).collect();
    let wires: Vec<String> = names.iter().map(|name| format!("{name} = {name}")).collect();
    let text = format!("{sliders}f = Expression(\"{}\", {})\n", factors.join("*"), wires.join(", "));
    let variances = a.map(|a: f64| 1.0 / (3.0 * (1.0 + a) * (1.0 + a)));
    let all: f64 = variances.iter().map(|v| 1.0 + v).product::<f64>() - 1.0;
    let expected: Vec<[f64; 2]> = variances
        .iter()
        .map(|v| {
            let others: f64 = variances.iter().map(|w| 1.0 + w).product::<f64>() / (1.0 + v);
            [v / all, v * others / all]
        })
        .collect();
    hold(&ranged(&text, 1024), &expected);
}

#[test]
fn an_output_that_does_not_change_has_no_shares() {
    let found = ranged("x = Number Slider(0.5, 0.0..1.0)\nf = Expression(\"0*x + 3\", x = x)\n", 8);
    assert_eq!(found[0].share, None);
    assert_eq!(found[0].screening.unwrap().size, 0.0);
}
