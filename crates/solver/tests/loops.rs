//! Loops: rounds with known answers, records, loops in loops, what stops them.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::time::{Duration, Instant};

use common::{Input, Sheet, number, value, wire};
use katydid_component::testing::texts;
use katydid_component::{Cancel, registry};
use katydid_definition::document::{Document, NewPort, Object, Side, Stored, ids};
use katydid_geometry::Point3;
use katydid_solver::{Engine, Options, Status};
use uuid::Uuid;

/// A definition of loops that is being written.
#[derive(Default)]
struct Loops(Sheet);

/// The outputs of a start.
struct Start {
    link: Uuid,
    counter: Uuid,
    data: Vec<Uuid>,
}

impl Loops {
    fn new() -> Self {
        katydid_components_more::link();
        Self::default()
    }

    fn add(&mut self, name: &str, inputs: Vec<Input>) -> Uuid {
        *self.0.add(name, inputs).first().unwrap()
    }

    fn object(&mut self, name: &str, inputs: Vec<(&str, Input)>, outputs: &[&str]) -> Vec<Uuid> {
        let component = registry::by_name(name).unwrap();
        let mut object = Object::new_component(
            component.guid,
            name,
            component.nick,
            Uuid::from_u128(0xA000_0000 + self.0.document.objects.len() as u128),
        );
        let base = 0x10_0000 * (1 + self.0.document.objects.len() as u128);
        for (k, (name, input)) in inputs.into_iter().enumerate() {
            let id = Uuid::from_u128(base + k as u128);
            object.add_port(
                Side::Input,
                &NewPort { id, name: name.to_owned(), nickname: name.to_owned(), ..NewPort::default() },
            );
            common::fill(&mut object, k, input);
        }
        let ids: Vec<Uuid> = (0..outputs.len()).map(|k| Uuid::from_u128(base + 0x1000 + k as u128)).collect();
        for (id, name) in ids.iter().zip(outputs) {
            object.add_port(
                Side::Output,
                &NewPort {
                    id: *id,
                    name: (*name).to_owned(),
                    nickname: (*name).to_owned(),
                    ..NewPort::default()
                },
            );
        }
        self.0.document.objects.push(object);
        ids
    }

    fn start(&mut self, rounds: Input, data: Vec<Input>) -> Start {
        let outputs: Vec<&str> = [">", "Counter"].into_iter().chain(data.iter().map(|_| "Data")).collect();
        let inputs =
            [("Iterations", rounds)].into_iter().chain(data.into_iter().map(|input| ("Data", input)));
        let ids = self.object("Fast Loop Start", inputs.collect(), &outputs);
        Start { link: ids[0], counter: ids[1], data: ids[2..].to_vec() }
    }

    fn end(&mut self, link: Uuid, exit: Input, data: Vec<Uuid>) -> Vec<Uuid> {
        let outputs: Vec<&str> = data.iter().map(|_| "Data").collect();
        let inputs = [("<", wire(link)), ("Exit", exit)].into_iter();
        let inputs = inputs.chain(data.into_iter().map(|id| ("Data", wire(id)))).collect();
        self.object("Fast Loop End", inputs, &outputs)
    }

    fn last(&mut self) -> &mut Object {
        self.0.document.objects.last_mut().unwrap()
    }

    fn solved(self) -> Engine {
        solved(self.0.document, Options::default())
    }
}

fn solved(document: Document, options: Options) -> Engine {
    let mut engine = Engine::new(document, options);
    engine.solve();
    engine
}

fn whole(n: i32) -> Input {
    value(Stored::Integer(n))
}

fn shown(engine: &Engine, object: usize, output: usize) -> String {
    let report = engine.report(object).unwrap();
    assert!(report.status == Status::Ok, "{:?}", report.messages);
    texts(&report.outputs[output]).join(" | ")
}

fn end_of(engine: &Engine) -> usize {
    let ends = [ids::LOOP_END, ids::FAST_LOOP_END];
    engine.document().objects.iter().rposition(|object| ends.contains(&object.component)).unwrap()
}

#[test]
fn the_ids_are_those_of_the_components() {
    katydid_components_more::link();
    let known = [
        (ids::LOOP_START, "Loop Start"),
        (ids::LOOP_END, "Loop End"),
        (ids::FAST_LOOP_START, "Fast Loop Start"),
        (ids::FAST_LOOP_END, "Fast Loop End"),
        (ids::HOOP_SNAKE, "HoopSnake"),
    ];
    for (id, name) in known {
        assert_eq!(registry::by_guid(id).unwrap().name, name);
    }
}

#[test]
fn fibonacci() {
    let mut loops = Loops::new();
    let start = loops.start(whole(30), vec![whole(0), whole(1)]);
    let sum = loops.add("Addition", vec![wire(start.data[0]), wire(start.data[1])]);
    loops.end(start.link, Input::Nothing, vec![start.data[1], sum]);
    let engine = loops.solved();
    assert_eq!(shown(&engine, end_of(&engine), 0), "{0}: 832040");
    assert_eq!(shown(&engine, end_of(&engine), 1), "{0}: 1346269");
}

/// The sum of the counters 0 to n − 1, and who looks on sees the last round.
#[test]
fn sums_of_the_counter_and_who_looks_on() {
    for n in [0, 1, 2, 100] {
        let mut loops = Loops::new();
        let start = loops.start(whole(n), vec![whole(0)]);
        let sum = loops.add("Addition", vec![wire(start.data[0]), wire(start.counter)]);
        loops.add("Negative", vec![wire(start.counter)]);
        loops.add("Negative", vec![wire(sum)]);
        loops.end(start.link, Input::Nothing, vec![sum]);
        let engine = loops.solved();
        assert_eq!(shown(&engine, end_of(&engine), 0), format!("{{0}}: {}", n * (n - 1) / 2));
        assert_eq!(shown(&engine, 2, 0), format!("{{0}}: {}", -(n - 1).max(0)));
        assert_eq!(shown(&engine, 3, 0), format!("{{0}}: {}", -(n * (n - 1) / 2)));
    }
}

/// Collatz from 27 reaches 1 after 111 steps.
#[test]
fn collatz_stops_by_its_exit_condition() {
    let mut loops = Loops::new();
    let start = loops.start(Input::Nothing, vec![whole(27), whole(0)]);
    let x = start.data[0];
    let half = loops.add("Division", vec![wire(x), number(2.0)]);
    let thrice = loops.add("Multiplication", vec![wire(x), number(3.0)]);
    let more = loops.add("Addition", vec![wire(thrice), number(1.0)]);
    let rest = loops.add("Modulus", vec![wire(x), number(2.0)]);
    let next = loops.object(
        "Pick'n'Choose",
        vec![("Pattern", wire(rest)), ("Stream 0", wire(half)), ("Stream 1", wire(more))],
        &["Stream"],
    )[0];
    let steps = loops.add("Addition", vec![wire(start.data[1]), number(1.0)]);
    let done = loops.add("Equality", vec![wire(next), number(1.0)]);
    loops.end(start.link, wire(done), vec![next, steps]);
    let engine = loops.solved();
    assert_eq!(shown(&engine, end_of(&engine), 0), "{0}: 1");
    assert_eq!(shown(&engine, end_of(&engine), 1), "{0}: 111");
}

#[test]
fn a_record_has_a_branch_for_each_round() {
    let mut loops = Loops::new();
    let start = loops.start(whole(3), vec![value(Stored::Integer(1))]);
    let twice = loops.add("Multiplication", vec![wire(start.data[0]), number(2.0)]);
    let ids = loops.end(start.link, Input::Nothing, vec![twice]);
    loops.last().container_mut().set("RecordData", true);
    loops.add("Negative", vec![wire(ids[0])]);
    let engine = loops.solved();
    assert_eq!(shown(&engine, end_of(&engine), 0), "{0;0}: 2 | {0;1}: 4 | {0;2}: 8");
    assert_eq!(shown(&engine, 3, 0), "{0;0}: -2 | {0;1}: -4 | {0;2}: -8");
}

#[test]
fn lists_and_geometry_grow() {
    let mut loops = Loops::new();
    let point = value(Stored::Point(Point3::new(1.0, 0.0, 0.0)));
    let start = loops.start(whole(4), vec![point, Input::Nothing]);
    let along = loops.add("Unit X", vec![number(2.0)]);
    let moved = loops.add("Move", vec![wire(start.data[0]), wire(along)]);
    let list =
        loops.object("Merge", vec![("Data 1", wire(start.data[1])), ("Data 2", wire(moved))], &["Result"])[0];
    loops.end(start.link, Input::Nothing, vec![moved, list]);
    let engine = loops.solved();
    assert_eq!(shown(&engine, end_of(&engine), 0), "{0}: {9, 0, 0}");
    assert_eq!(shown(&engine, end_of(&engine), 1), "{0}: {3, 0, 0}, {5, 0, 0}, {7, 0, 0}, {9, 0, 0}");
}

/// Twelve times three additions of one, the inner loop as long as the outer one's counter says: 0 + 1 + … + 11.
#[test]
fn a_loop_in_a_loop() {
    let mut loops = Loops::new();
    let outer = loops.start(whole(12), vec![whole(0)]);
    let inner = loops.start(wire(outer.counter), vec![wire(outer.data[0])]);
    let more = loops.add("Addition", vec![wire(inner.data[0]), number(1.0)]);
    let done = loops.end(inner.link, Input::Nothing, vec![more]);
    loops.end(outer.link, Input::Nothing, vec![done[0]]);
    let engine = loops.solved();
    assert_eq!(shown(&engine, end_of(&engine), 0), "{0}: 66");
    assert_eq!(shown(&engine, 3, 0), "{0}: 66");
}

#[test]
fn an_endless_loop_is_stopped_by_name() {
    let endless = |exit: bool| {
        let mut loops = Loops::new();
        let start = loops.start(Input::Nothing, vec![whole(0)]);
        let more = loops.add("Addition", vec![wire(start.data[0]), number(1.0)]);
        let never = loops.add("Smaller Than", vec![wire(more), number(0.0)]);
        let exit = if exit { wire(never) } else { Input::Nothing };
        let done = loops.end(start.link, exit, vec![more]);
        loops.add("Negative", vec![wire(done[0])]);
        loops.0.document
    };
    let message = |engine: &Engine| engine.report(3).unwrap().messages[0].text.clone();
    let engine = solved(endless(false), Options::default());
    assert!(message(&engine).contains("has no end"), "{}", message(&engine));
    let options = Options::default().with_time(Duration::from_millis(300));
    let begun = Instant::now();
    let engine = solved(endless(true), options);
    assert!(begun.elapsed() < Duration::from_secs(5));
    assert!(message(&engine).contains("was stopped after") && message(&engine).contains("time limit"));
    assert_eq!(engine.report(4).unwrap().status, Status::NoData);
    let cancel = Cancel::default();
    let options = Options { cancel: cancel.clone(), ..Options::default() };
    let mut engine = Engine::new(endless(true), options);
    let summary = std::thread::scope(|scope| {
        scope.spawn(|| {
            std::thread::sleep(Duration::from_millis(100));
            cancel.cancel();
        });
        engine.solve()
    });
    assert!(summary.unfinished > 0);
}

#[test]
fn what_changes_outside_has_the_whole_loop_run_again() {
    let mut loops = Loops::new();
    let step = loops.add("Number", vec![number(2.0)]);
    let start = loops.start(whole(5), vec![whole(0)]);
    let more = loops.add("Addition", vec![wire(start.data[0]), wire(step)]);
    loops.end(start.link, Input::Nothing, vec![more]);
    let mut engine = loops.solved();
    assert_eq!(shown(&engine, 3, 0), "{0}: 10");
    assert_eq!(engine.solve().solved, 0);
    let number = katydid_data::Value::Number(3.0);
    engine.give(0, 0, Some(katydid_data::Tree::item(number)));
    assert_eq!(engine.dirty().len(), 4);
    engine.solve();
    assert_eq!(shown(&engine, 3, 0), "{0}: 15");
    assert_eq!(shown(&engine, 2, 0), "{0}: 15");
}

#[test]
fn loops_that_cross_are_refused() {
    let mut loops = Loops::new();
    let a = loops.start(whole(2), vec![whole(0)]);
    let b = loops.start(whole(2), vec![whole(0)]);
    let sum = loops.add("Addition", vec![wire(a.data[0]), wire(b.data[0])]);
    loops.end(a.link, Input::Nothing, vec![sum]);
    loops.end(b.link, Input::Nothing, vec![sum]);
    let engine = loops.solved();
    let refused = (3..5).filter(|at| engine.report(*at).unwrap().status == Status::Error).count();
    assert_eq!(refused, 1);
}

/// 1, 2, 4, … as long as the double is below 100.
#[test]
fn a_snake_goes_round_until_it_is_told_to_stop() {
    let mut loops = Loops::new();
    let inputs = vec![("Start", whole(1)), ("Data", Input::Nothing), ("Continue", Input::Nothing)];
    let snake = loops.object("HoopSnake", inputs, &["F", "H", "i"]);
    let twice = loops.add("Multiplication", vec![wire(snake[0]), number(2.0)]);
    let small = loops.add("Smaller Than", vec![wire(twice), number(100.0)]);
    loops.0.document.objects[0].set_sources(1, &[twice]).unwrap();
    let engine = solved(loops.0.document.clone(), Options::default());
    assert_eq!(shown(&engine, 0, 0), "{0}: 1");
    loops.0.document.objects[0].set_sources(2, &[small]).unwrap();
    let engine = loops.solved();
    assert_eq!(shown(&engine, 0, 0), "{0}: 128");
    assert_eq!(shown(&engine, 0, 2), "{0}: 7");
}

/// A thousand rounds of ten objects, timed in optimised builds (`cargo test --release`).
#[test]
fn a_thousand_rounds_of_ten_objects() {
    let mut loops = Loops::new();
    let start = loops.start(whole(1000), vec![number(0.0)]);
    let mut last = start.data[0];
    for _ in 0..10 {
        last = loops.add("Addition", vec![wire(last), number(1.0)]);
    }
    loops.end(start.link, Input::Nothing, vec![last]);
    let begun = Instant::now();
    let engine = loops.solved();
    let took = begun.elapsed();
    assert_eq!(shown(&engine, end_of(&engine), 0), "{0}: 10000");
    eprintln!("a thousand rounds of ten objects: {took:?}");
    assert!(cfg!(debug_assertions) || took < Duration::from_millis(200), "{took:?}");
}
