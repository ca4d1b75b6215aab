//! An engine that follows a document by differences: what it keeps, what it solves again, what a cancel leaves.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::sync::{Arc, Mutex};

use common::{Input, Sheet, number, value, wire};
use katydid_component::Cancel;
use katydid_component::testing::texts;
use katydid_definition::document::{Difference, Document, Persistent, Stored};
use katydid_solver::{Engine, Finished, Options};

/// a → −a → |−a|, and b → −b beside it.
fn engine() -> Engine {
    let mut sheet = Sheet::default();
    let a = sheet.add("Number", vec![number(1.0)]);
    let b = sheet.add("Number", vec![number(2.0)]);
    let left = sheet.add("Negative", vec![wire(a[0])]);
    sheet.add("Negative", vec![wire(b[0])]);
    sheet.add("Absolute", vec![wire(left[0])]);
    let mut engine = Engine::new(sheet.document, Options::default());
    assert_eq!(engine.solve().solved, 5);
    engine
}

fn step(engine: &mut Engine, change: impl FnOnce(&mut Document)) {
    let mut after = engine.document().clone();
    change(&mut after);
    let difference = Difference::between(engine.document(), &after);
    engine.apply(&difference).unwrap();
    assert_eq!(engine.document(), &after);
}

fn first(engine: &Engine, at: usize) -> String {
    texts(&engine.report(at).unwrap().outputs[0]).join(" ")
}

#[test]
fn engines_and_documents_go_from_thread_to_thread() {
    fn goes<T: Send>() {}
    goes::<Engine>();
    goes::<Document>();
    goes::<Difference>();
}

#[test]
fn what_only_the_canvas_shows_makes_nothing_dirty() {
    let mut engine = engine();
    step(&mut engine, |document| {
        document.objects[0].set_place([1.0, 2.0, 3.0, 4.0], [5.0, 6.0]);
        document.objects[2].set_hidden(true);
        document.objects[3].move_by(1.0, 1.0);
    });
    assert!(engine.dirty().is_empty());
    // Neither does the order in which objects are drawn.
    step(&mut engine, |document| document.objects.swap(1, 3));
    assert!(engine.dirty().is_empty());
    assert_eq!(first(&engine, 1), "{0}: -2");
    assert_eq!(engine.solve().solved, 0);
}

#[test]
fn dirt_spreads_along_wires_old_and_new() {
    let mut engine = engine();
    let five = Persistent::item(Stored::Number(5.0));
    step(&mut engine, |document| document.objects[0].set_persistent(0, Some(&five)).unwrap());
    assert_eq!(engine.solve().solved, 3);
    assert_eq!(first(&engine, 4), "{0}: 5");
    // The last object reads the other row now.
    let other = engine.document().objects[3].outputs[0].id;
    step(&mut engine, |document| document.objects[4].set_sources(0, &[other]).unwrap());
    assert_eq!(engine.solve().solved, 1);
    assert_eq!(first(&engine, 4), "{0}: 2");
    // What it read is gone: it has nothing to read, and all others stay.
    step(&mut engine, |document| drop(document.objects.remove(3)));
    assert_eq!(engine.dirty(), [3]);
    engine.solve();
    assert!(engine.report(3).unwrap().outputs[0].is_empty());
    // It comes back in another place.
    let mut sheet = Sheet::default();
    sheet.add("Pi", vec![number(1.0)]);
    let pi = sheet.document.objects[0].clone();
    step(&mut engine, |document| document.objects.insert(0, pi));
    assert_eq!(engine.dirty(), [0]);
    assert_eq!(engine.solve().solved, 1);
    assert_eq!(first(&engine, 1), "{0}: 5");
    assert!(engine.apply(&Difference { removed: vec![99], ..Difference::default() }).is_err());
}

#[test]
fn what_a_cancel_left_is_solved_the_next_time() {
    let mut sheet = Sheet::default();
    let series = sheet.add("Series", vec![number(0.0), number(1.0), value(Stored::Integer(10))]);
    let mut last = series[0];
    for _ in 0..5 {
        last = sheet.add("Sine", vec![wire(last)])[0];
    }
    sheet.add("Pi", vec![Input::Nothing]);
    let mut engine = Engine::new(sheet.document, Options::default());
    let cancel = Cancel::default();
    engine.options_mut().cancel = cancel.clone();
    // Cancelled from within, when the third object is done.
    let seen = Arc::new(Mutex::new(0));
    let count = seen.clone();
    engine.options_mut().finished = Some(Arc::new(move |done: &Finished<'_>| {
        assert!(!done.report.outputs.is_empty());
        let mut count = count.lock().unwrap();
        *count += 1;
        if *count == 3 {
            cancel.cancel();
        }
    }));
    let summary = engine.solve();
    assert_eq!(summary.solved + summary.unfinished, 7);
    assert!((3..=4).contains(&summary.solved), "{summary:?}");
    assert_eq!(engine.dirty().len(), summary.unfinished);
    assert!(engine.dirty().iter().all(|at| engine.report(*at).is_none()));
    // The same flag stops the next one as well; another does not.
    assert_eq!(engine.solve().solved, 0);
    engine.options_mut().cancel = Cancel::default();
    let rest = engine.solve();
    assert_eq!((rest.solved, rest.unfinished), (summary.unfinished, 0));
    assert_eq!(*seen.lock().unwrap(), 7);
    let mut fresh = Engine::new(engine.document().clone(), Options::default());
    fresh.solve();
    assert_eq!(first(&engine, 5), first(&fresh, 5));
}

#[test]
fn other_rules_make_everything_dirty() {
    let mut engine = engine();
    engine.set_rules(engine.options().rules);
    assert!(engine.dirty().is_empty());
    let mut rules = engine.options().rules;
    rules.units = katydid_geometry::Units::Meters;
    engine.set_rules(rules);
    assert_eq!(engine.solve().solved, 5);
}
