//! Optimisation against known optima and fronts.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use std::fs;
use std::path::Path;

use katydid_component::Cancel;
use katydid_definition::document::Document;
use katydid_definition::kd;
use katydid_session::Registry;
use katydid_solver::Options;
use katydid_study::{
    Bound, Constraint, Goal, Method, Objective, OptimiseSettings, Optimum, Output, Settings, StudyError,
    inputs_of, optimise,
};

fn document(text: &str) -> Document {
    katydid_components::link();
    kd::read(&format!("katydid 1\n{text}"), &Registry).unwrap().document
}

fn settings(method: Method, evaluations: usize, goals: &[Goal]) -> OptimiseSettings {
    OptimiseSettings {
        objectives: goals
            .iter()
            .enumerate()
            .map(|(output, goal)| Objective { output, goal: *goal })
            .collect(),
        constraints: Vec::new(),
        method,
        evaluations,
        patience: None,
        seed: 1,
        study: Settings { workers: 2, cancel: Cancel::default(), ..Settings::default() },
    }
}

fn run(
    text: &str,
    outputs: &[&str],
    folder: &Path,
    settings: &OptimiseSettings,
    stop_after: u64,
) -> Result<Optimum, StudyError> {
    let document = document(text);
    let outputs: Vec<Output> = outputs.iter().map(|name| Output::find(&document, name).unwrap()).collect();
    let mut variables = Vec::new();
    for output in &outputs {
        for variable in inputs_of(&document, output)? {
            if variables.iter().all(|other: &katydid_study::Variable| other.name != variable.name) {
                variables.push(variable);
            }
        }
    }
    let cancel = settings.study.cancel.clone();
    optimise(document, Options::default(), variables, outputs, folder, settings, |now| {
        if now.solved >= stop_after {
            cancel.cancel();
        }
    })
}

fn sliders(names: &[&str], range: &str) -> String {
    names.iter().map(|name| format!("{name} = Number Slider({range})\n")).collect()
}

#[test]
fn the_least_of_rosenbrocks_function_is_found() {
    let text = format!(
        "{}f = Expression(\"100*(y - x^2)^2 + (1 - x)^2 + 100*(z - y^2)^2 + (1 - y)^2\", x = x, y = y, z = z)\n",
        sliders(&["x", "y", "z"], "0, -2.0000000..2.0000000")
    );
    let folder = tempfile::tempdir().unwrap();
    let found =
        run(&text, &["f"], folder.path(), &settings(Method::Cma, 1500, &[Goal::Least]), u64::MAX).unwrap();
    let [best] = found.best.as_slice() else { panic!("{found:?}") };
    assert!(best.outputs[0].number().unwrap() < 1e-9 && best.holds, "{best:?}");
    assert!(best.inputs.iter().all(|x| (x.number().unwrap() - 1.0).abs() < 1e-4), "{best:?}");
    // All points are in the table; a search that is stopped goes on to the same bytes, for any number of workers.
    let table = fs::read(folder.path().join("data.csv")).unwrap();
    assert_eq!(table.iter().filter(|byte| **byte == b'\n').count() as u64, found.progress.points + 1);
    let other = tempfile::tempdir().unwrap();
    let mut again = settings(Method::Cma, 1500, &[Goal::Least]);
    assert!(matches!(run(&text, &["f"], other.path(), &again, 100), Err(StudyError::Stopped)));
    again.study = Settings { workers: 1, cancel: Cancel::default(), ..Settings::default() };
    let second = run(&text, &["f"], other.path(), &again, u64::MAX).unwrap();
    assert!(
        second.progress.had >= 100 && second.progress.had + second.progress.solved == found.progress.solved
    );
    assert!(fs::read(other.path().join("data.csv")).unwrap() == table && second.best == found.best);
}

#[test]
fn constraints_hold_and_whole_numbers_and_choices_are_kept() {
    // The largest x·n with x + n at most 7: x = 2, n = 5 by the range of x.
    let text = "x = Number Slider(0.5, 0.000..2.000)\nn = Number Slider(1, 1..9)\nf = Multiplication(x, n)\ns = Addition(x, n)\n";
    let constraint = Constraint { output: 1, bound: Bound::AtMost(7.0) };
    for method in [Method::Cma, Method::Nsga2(20)] {
        let folder = tempfile::tempdir().unwrap();
        let mut all = settings(method, 800, &[Goal::Most]);
        all.constraints = vec![constraint.clone()];
        let found = run(text, &["f", "s"], folder.path(), &all, u64::MAX).unwrap();
        let best = &found.best[0];
        assert!(best.holds && best.inputs[1].number() == Some(5.0), "{best:?}");
        assert!(best.outputs[0].number().unwrap() > 9.99, "{best:?}");
    }
    // Points without a result are no optimum, and a space of few points ends the search.
    let text = "n = Number Slider(5, 1..9)\non = Boolean Toggle(true)\nf = Expression(\"Sqrt(n - 4) - If(on, 1, 0)\", n = n, on = on)\n";
    let folder = tempfile::tempdir().unwrap();
    let found = run(text, &["f"], folder.path(), &settings(Method::Nsga2(10), 500, &[Goal::Least]), u64::MAX)
        .unwrap();
    assert!(found.progress.points <= 18, "{found:?}");
    assert_eq!(found.best[0].inputs[0].number(), Some(4.0));
    assert_eq!(found.best[0].outputs[0].number(), Some(-1.0));
    // As near as can be to a number.
    let text = "x = Number Slider(0.5, 0.000..2.000)\nf = Multiplication(x, x)\n";
    let folder = tempfile::tempdir().unwrap();
    let found =
        run(text, &["f"], folder.path(), &settings(Method::Cma, 200, &[Goal::Near(2.25)]), u64::MAX).unwrap();
    assert_eq!(found.best[0].inputs[0].number(), Some(1.5));
}

/// The area between a front of two goals and a point behind it.
fn hypervolume(found: &Optimum, reference: [f64; 2]) -> f64 {
    let mut points: Vec<[f64; 2]> =
        found.best.iter().map(|best| [0, 1].map(|k| best.outputs[k].number().unwrap())).collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut top = reference[1];
    let mut area = 0.0;
    for [x, y] in points {
        if x < reference[0] && y < top {
            area += (reference[0] - x) * (top - y);
            top = y;
        }
    }
    area
}

/// Zitzler, Deb, Thiele 2000, with six inputs; the fronts are f2 = 1 - √f1, 1 - f1², and five pieces of 1 - √f1 - f1 sin 10πf1.
#[test]
fn fronts_of_zdt_reach_their_hypervolume() {
    let names = ["a", "b", "c", "d", "e", "h"];
    let others = "(1 + 9*(b + c + d + e + h)/5)";
    let wires = "a = a, b = b, c = c, d = d, e = e, h = h";
    // Behind (1.1, 1.1): the square of 1.1 less what lies below the front and beside it.
    let cases = [
        (format!("{others}*(1 - Sqrt(a/{others}))"), 1.21 - 1.0 / 3.0, 0.985),
        (format!("{others}*(1 - (a/{others})^2)"), 1.21 - 2.0 / 3.0, 0.98),
        (format!("{others}*(1 - Sqrt(a/{others}) - a/{others}*Sin(31.41592653589793*a))"), 1.331_76, 0.98),
    ];
    for (second, whole, part) in cases {
        let text = format!(
            "{}f = Expression(\"a\", a = a)\ng = Expression(\"{second}\", {wires})\n",
            sliders(&names, "0.5, 0.000000..1.000000")
        );
        let folder = tempfile::tempdir().unwrap();
        let goals = [Goal::Least, Goal::Least];
        let found =
            run(&text, &["f", "g"], folder.path(), &settings(Method::Nsga2(100), 8000, &goals), u64::MAX)
                .unwrap();
        let reached = hypervolume(&found, [1.1, 1.1]);
        assert!(reached > part * whole && reached < 1.001 * whole, "{reached} of {whole}: {second}");
    }
}
