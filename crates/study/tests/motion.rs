//! How places move with an input, against closed forms.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use katydid_component::Cancel;
use katydid_data::Path;
use katydid_definition::kd;
use katydid_geometry::{Point3, Vector3};
use katydid_session::Registry;
use katydid_solver::{Engine, Options};
use katydid_study::{Effort, Output, Prepared, Variable, motion, shown_objects, solve_for};

fn solved(text: &str) -> Engine {
    katydid_components::link();
    let document = kd::read(&format!("katydid 1\n{text}"), &Registry).unwrap().document;
    let mut engine = Engine::new(document, Options::default());
    engine.solve();
    engine
}

fn arrows(text: &str, input: &str) -> (Vec<(Point3, Vector3)>, usize) {
    let engine = solved(text);
    let variable = Variable::find(engine.document(), input).unwrap();
    let objects = shown_objects(engine.document());
    let prepared = Prepared::of_engine(engine, Cancel::default(), vec![variable], Vec::new());
    let found = motion(&prepared, &objects, &Cancel::default()).unwrap();
    (found.arrows.iter().map(|arrow| (arrow.at, arrow.by)).collect(), found.left_out.len())
}

#[test]
fn what_grows_from_a_centre_moves_away_from_it() {
    // A place at distance r from the middle moves by its own direction, whatever kind of geometry it is on.
    for maker in ["Circle(_, r)", "Sphere(_, r)"] {
        let (arrows, left_out) = arrows(&format!("r = Number Slider(2.0, 0.0..9.0)\nc = {maker}\n"), "r");
        assert!(!arrows.is_empty() && left_out == 0, "{maker}");
        for (at, by) in arrows {
            let away = at - Point3::ORIGIN;
            assert!((by * 2.0 - away).length() < 1e-6, "{maker}: {at:?} moves by {by:?}");
        }
    }
}

#[test]
fn at_an_end_of_the_range_the_other_side_tells() {
    let (arrows, _) = arrows("x = Number Slider(9.0, 0.0..9.0)\np = Construct Point(x, 1, 2)\n", "x");
    assert_eq!(arrows.len(), 1);
    assert!((arrows[0].1 - Vector3::new(1.0, 0.0, 0.0)).length() < 1e-6);
}

#[test]
fn what_changes_its_count_is_named_and_what_is_hidden_left_out() {
    // The count jumps where the slider stands.
    let text = "x = Number Slider(3.0, 0.0..9.0)\nn = Expression(\"Floor(x)\", x = x)\nk = Series(0, 1, n)\np = Construct Point(k, x, 0)\n\
        q = Construct Point(x, x, 0)\n";
    let (found, left_out) = arrows(text, "x");
    assert_eq!((found.len(), left_out), (1, 1));
}

#[test]
fn one_item_of_a_branch_is_asked_for() {
    let engine =
        solved("r = Number Slider(2.0, 0.0..9.0)\nk = Series(0, r, 4)\np = Construct Point(k, 1, 0)\n");
    let document = engine.document();
    let output = Output::find(document, "p").unwrap().only("{0;0}".parse::<Path>().unwrap(), 3);
    let none = Output::find(document, "p").unwrap().only("{7}".parse::<Path>().unwrap(), 0);
    assert_eq!(none.tree(&engine).item_count(), 0);
    let variable = Variable::find(document, "r").unwrap();
    let prepared = Prepared::of_engine(engine, Cancel::default(), vec![variable], vec![output]);
    let found = solve_for(&prepared, &[7.5, 1.0, 0.0], Effort::default(), &Cancel::default()).unwrap();
    assert_eq!(found.inputs, [2.5]);
}

#[test]
fn who_has_no_time_gets_the_best_so_far() {
    let engine = solved("x = Number Slider(1.0, 0.0..9.0)\nf = Multiplication(x, x)\n");
    let output = Output::find(engine.document(), "f").unwrap();
    let variable = Variable::find(engine.document(), "x").unwrap();
    let prepared = Prepared::of_engine(engine, Cancel::default(), vec![variable], vec![output]);
    let none = Effort { time: Some(std::time::Duration::ZERO), ..Effort::default() };
    let found = solve_for(&prepared, &[4.0], none, &Cancel::default()).unwrap();
    assert_eq!((found.inputs, found.off), (vec![1.0], 3.0));
    let found = solve_for(&prepared, &[4.0], Effort::default(), &Cancel::default()).unwrap();
    assert_eq!(found.inputs, [2.0]);
}
