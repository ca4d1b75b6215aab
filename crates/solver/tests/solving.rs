//! Order, loops, limits, cancel, what is dirty, unknown and disabled objects.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use common::{Input, Sheet, number, value, wire};
use katydid_component::testing::texts;
use katydid_component::{Cancel, Limits};
use katydid_data::Value;
use katydid_definition::document::{Document, Mapping, Object, Side, Stored};
use katydid_solver::{Engine, Options, Status};
use proptest::prelude::*;
use uuid::Uuid;

fn solved(document: Document) -> Engine {
    let mut engine = Engine::new(document, Options::default());
    engine.solve();
    engine
}

fn first_text(engine: &Engine, object: usize) -> String {
    texts(&engine.report(object).unwrap().outputs[0]).join(" ")
}

fn message(engine: &Engine, object: usize) -> &str {
    &engine.report(object).unwrap().messages[0].text
}

#[test]
fn two_to_the_thirty_one_items_are_a_message_and_the_rest_solves() {
    let mut sheet = Sheet::default();
    let series = sheet.add("Series", vec![number(0.0), number(1.0), value(Stored::Integer(i32::MAX))]);
    sheet.add("Sine", vec![wire(series[0])]);
    sheet.add("Pi", vec![number(1.0)]);
    let start = Instant::now();
    let engine = solved(sheet.document);
    assert!(start.elapsed() < Duration::from_secs(10));
    assert_eq!(engine.report(0).unwrap().status, Status::Error);
    assert!(message(&engine, 0).contains("items"), "{}", message(&engine, 0));
    assert_eq!(engine.report(1).unwrap().outputs[0].item_count(), 0);
    assert_eq!(first_text(&engine, 2), "{0}: 3.141593");
}

#[test]
fn a_wire_from_an_object_to_itself_names_it() {
    let mut sheet = Sheet::default();
    let sum = sheet.add("Addition", vec![number(1.0), number(2.0)]);
    sheet.document.objects[0].set_sources(1, &[sum[0]]).unwrap();
    sheet.add("Negative", vec![wire(sum[0])]);
    sheet.add("Pi", vec![number(1.0)]);
    let engine = solved(sheet.document);
    assert_eq!(engine.report(0).unwrap().status, Status::Error);
    assert!(message(&engine, 0).contains("reads its own output"));
    assert_eq!(engine.report(1).unwrap().status, Status::NoData);
    assert_eq!(engine.report(2).unwrap().status, Status::Ok);
}

#[test]
fn a_loop_names_its_objects_and_what_hangs_on_it_has_no_data() {
    let mut sheet = Sheet::default();
    let a = sheet.add("Negative", vec![Input::Nothing]);
    let b = sheet.add("Absolute", vec![wire(a[0])]);
    sheet.document.objects[0].set_sources(0, &[b[0]]).unwrap();
    sheet.add("Square Root", vec![wire(b[0])]);
    let engine = solved(sheet.document);
    for looped in [0, 1] {
        assert_eq!(engine.report(looped).unwrap().status, Status::Error);
        assert!(message(&engine, looped).contains("Neg") && message(&engine, looped).contains("Abs"));
    }
    assert_eq!(engine.report(2).unwrap().status, Status::NoData);
}

#[test]
fn forty_doublings_of_a_text_end_with_a_message() {
    let mut sheet = Sheet::default();
    let mut last = sheet.add("Text", vec![value(Stored::Text("abcdefgh".to_owned()))])[0];
    for _ in 0..40 {
        last = sheet.add("Concatenate", vec![wire(last), wire(last)])[0];
    }
    sheet.add("Pi", vec![number(1.0)]);
    let limits = Limits { bytes: 1 << 24, ..Limits::default() };
    let mut engine = Engine::new(sheet.document, Options { limits, ..Options::default() });
    engine.solve();
    let failed = (0..41).find(|&i| engine.report(i).unwrap().status == Status::Error).unwrap();
    assert!(message(&engine, failed).contains("bytes"), "{}", message(&engine, failed));
    assert!((18..=24).contains(&failed), "{failed}");
    assert_eq!(engine.report(41).unwrap().status, Status::Ok);
}

#[test]
fn the_time_limit_and_a_cancel_stop_a_solve() {
    let long = || {
        let mut sheet = Sheet::default();
        let series = sheet.add("Series", vec![number(0.0), number(1.0), value(Stored::Integer(3_000_000))]);
        let mut last = series[0];
        for _ in 0..20 {
            last = sheet.add("Sine", vec![wire(last)])[0];
        }
        sheet.document
    };
    let start = Instant::now();
    let mut engine = Engine::new(long(), Options::default().with_time(Duration::from_millis(50)));
    engine.solve();
    assert!(start.elapsed() < Duration::from_secs(8));
    let stopped = |engine: &Engine, word: &str| {
        (0..21).any(|i| engine.report(i).unwrap().messages.iter().any(|m| m.text.contains(word)))
    };
    assert!(stopped(&engine, "time limit"));

    let cancel = Cancel::default();
    cancel.cancel();
    let mut engine = Engine::new(long(), Options { cancel, ..Options::default() });
    let summary = engine.solve();
    assert_eq!((summary.solved, summary.unfinished), (0, 21));
    assert!((0..21).all(|i| engine.report(i).is_none()));
}

#[test]
fn only_what_hangs_on_a_change_solves_again() {
    let mut sheet = Sheet::default();
    let a = sheet.add("Number", vec![number(1.0)]);
    let b = sheet.add("Number", vec![number(2.0)]);
    let left = sheet.add("Negative", vec![wire(a[0])]);
    sheet.add("Negative", vec![wire(b[0])]);
    sheet.add("Absolute", vec![wire(left[0])]);
    let solved = Arc::new(AtomicUsize::new(0));
    let names = Arc::new(Mutex::new(Vec::new()));
    let (count, list) = (solved.clone(), names.clone());
    let progress = Arc::new(move |p: &katydid_solver::Progress| {
        count.fetch_add(1, Ordering::Relaxed);
        list.lock().unwrap().push((p.done, p.total));
    });
    let mut engine = Engine::new(sheet.document, Options { progress: Some(progress), ..Options::default() });
    assert_eq!(engine.solve().solved, 5);
    assert_eq!(engine.solve().solved, 0);
    let five = katydid_definition::document::Persistent::item(Stored::Number(5.0));
    engine.edit(0, |object| object.set_persistent(0, Some(&five)).unwrap());
    assert_eq!(engine.solve().solved, 3);
    assert_eq!(solved.load(Ordering::Relaxed), 8);
    assert!(names.lock().unwrap().iter().all(|(done, total)| done <= total));
    assert_eq!(first_text(&engine, 4), "{0}: 5");
}

#[test]
fn a_disabled_object_acts_as_if_it_had_no_output() {
    let mut sheet = Sheet::default();
    let a = sheet.add("Pi", vec![number(1.0)]);
    sheet.add("Negative", vec![wire(a[0])]);
    sheet.document.objects[0].set_locked(true);
    let engine = solved(sheet.document);
    assert_eq!(engine.report(0).unwrap().status, Status::Disabled);
    assert_eq!(engine.report(1).unwrap().status, Status::NoData);
    assert!(message(&engine, 1).contains("Input parameter x failed to collect data"));
}

#[test]
fn a_surface_flows_through_brep_and_geometry_ports() {
    let mut sheet = Sheet::default();
    let ball = sheet.add("Sphere", vec![Input::Nothing, number(2.0)]);
    let brep = sheet.add("Brep", vec![wire(ball[0])]);
    let moved = sheet.add("Move", vec![wire(brep[0]), value(Stored::Vector([1.0, 2.0, 3.0].into()))]);
    sheet.add("Area", vec![wire(moved[0])]);
    let divided = sheet.add("Divide Surface", vec![wire(moved[0]), number(1.0), number(1.0)]);
    let mut document = sheet.document;
    document.objects[4].inputs[0].modifiers.reparameterize = true;
    let engine = solved(document);
    assert_eq!(first_text(&engine, 1), "{0}: Untrimmed Surface");
    assert_eq!(first_text(&engine, 2), "{0}: Untrimmed Surface");
    assert_eq!(first_text(&engine, 3), "{0}: 50.265482");
    let report = engine.report(4).unwrap();
    let last = report.outputs[2].column().iter().last().flatten();
    assert_eq!(last, Some(Value::Point(katydid_geometry::Point3::new(1.0, 1.0, 0.0))), "{divided:?}");
}

#[test]
fn a_parameter_without_data_says_so() {
    let mut sheet = Sheet::default();
    sheet.add("Point", vec![Input::Nothing]);
    let engine = solved(sheet.document);
    assert_eq!(engine.report(0).unwrap().status, Status::NoData);
    assert_eq!(message(&engine, 0), "Floating parameter Pt failed to collect data");
}

#[test]
fn an_unknown_object_gives_a_null_and_is_named() {
    let mut sheet = Sheet::default();
    let a = sheet.add("Pi", vec![number(1.0)]);
    let b = sheet.add("Negative", vec![wire(a[0])]);
    sheet.add("Absolute", vec![wire(b[0])]);
    let chunk = sheet.document.objects[1].chunk().clone();
    let mut chunk = chunk;
    chunk.set("GUID", Uuid::from_u128(0xbad));
    chunk.set("Name", "Frobnicate");
    sheet.document.objects[1] = Object::from_chunk(chunk);
    let engine = solved(sheet.document);
    assert_eq!(engine.report(1).unwrap().status, Status::Unsupported);
    assert!(message(&engine, 1).contains("Frobnicate"));
    assert_eq!(first_text(&engine, 2), "{0}: null");
}

#[test]
fn the_expression_of_a_port_sees_x_and_the_name_of_the_port() {
    for formula in ["x-1", "X - 1", "i-1"] {
        let mut sheet = Sheet::default();
        let list = Input::Values([5.0, 6.0, 7.0].map(Stored::Number).to_vec());
        sheet.add("List Item", vec![list, value(Stored::Integer(2)), value(Stored::Boolean(true))]);
        let object = &mut sheet.document.objects[0];
        let port = object.container_mut().child_at_mut("param_input", 1);
        match port {
            Some(port) => port.set("InternalExpression", formula),
            None => {
                let parameters = object.container_mut().child_mut("ParameterData").unwrap();
                parameters.child_at_mut("InputParam", 1).unwrap().set("InternalExpression", formula);
            }
        }
        object.refresh();
        assert_eq!(first_text(&solved(sheet.document), 0), "{0}: 6", "{formula}");
    }
}

/// The book's own definition has most of its objects switched off: switched on, all that is supported solves.
#[test]
fn the_books_definition_solves_with_everything_switched_on() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../../shared/data/gh/the-book/TheEssentialMathematics_3rdEdition.gh"
    );
    let Ok(bytes) = std::fs::read(path) else {
        assert!(std::env::var_os("KATYDID_REQUIRE_SHARED").is_none(), "{path} is absent");
        println!("skipped: {path} is absent");
        return;
    };
    let mut document = Document::read(&bytes, &Default::default()).unwrap();
    assert_eq!(document.objects.len(), 1490);
    document.objects.iter_mut().for_each(|o| o.set_locked(false));
    let engine = solved(document);
    let mut counts = std::collections::BTreeMap::new();
    for (i, object) in engine.document().objects.iter().enumerate().filter(|(_, o)| !o.is_annotation()) {
        let report = engine.report(i).unwrap();
        *counts.entry(report.status).or_insert(0) += 1;
        assert!(report.messages.iter().all(|m| !m.text.contains("Internal error")), "{}", object.name);
        if report.status == Status::Error {
            println!("{}: {}", object.name, report.messages[0].text);
        }
    }
    println!("{counts:?}");
    assert!(counts[&Status::Ok] >= 700, "{counts:?}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, failure_persistence: None, ..Default::default() })]

    /// Any wiring of a few objects solves on one thread and on two to the same data.
    #[test]
    fn any_wiring_solves_the_same_on_any_number_of_threads(
        wires in prop::collection::vec((0..8usize, 0..8usize, 0..2usize), 0..24),
    ) {
        let mut sheet = Sheet::default();
        let ids: Vec<Uuid> = (0..8).map(|i| {
            sheet.add("Addition", vec![number(f64::from(i)), number(0.5)])[0]
        }).collect();
        for (from, to, port) in wires {
            let mut sources = sheet.document.objects[to].inputs[port].sources.clone();
            sources.push(ids[from]);
            sheet.document.objects[to].set_sources(port, &sources).unwrap();
        }
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let mut engine = Engine::new(sheet.document.clone(), Options::default());
            pool.install(|| engine.solve());
            (0..8).map(|i| {
                let report = engine.report(i).unwrap();
                let items: Vec<Option<Value>> =
                    report.outputs.iter().flat_map(|t| t.column().iter().collect::<Vec<_>>()).collect();
                (report.status, report.messages.clone(), items)
            }).collect::<Vec<_>>()
        };
        prop_assert_eq!(run(1), run(2));
    }
}

#[test]
fn a_floating_parameter_has_its_own_modifiers() {
    let mut sheet = Sheet::default();
    let series = sheet.add("Series", vec![number(0.0), number(1.0), value(Stored::Integer(3))])[0];
    sheet.add("Number", vec![wire(series)]);
    sheet.add("Number", vec![number(7.0)]);
    for object in [1, 2] {
        sheet.document.objects[object].set_mapping(Side::Input, 0, Mapping::Graft).unwrap();
    }
    let engine = solved(sheet.document);
    let shape = |object: usize| {
        let tree = &engine.report(object).unwrap().outputs[0];
        tree.branches().map(|branch| branch.path().to_string()).collect::<Vec<_>>()
    };
    assert_eq!(shape(1), ["{0;0;0}", "{0;0;1}", "{0;0;2}"]);
    assert_eq!(shape(2), ["{0;0}"]);
}
