//! A definition over a million items: Series → Sine → Construct Point → Move → Distance → Mass Addition.
//! `benches/compare.py` puts it beside the same in NumPy.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

use criterion::{Criterion, criterion_group, criterion_main};
use katydid_component::{Component, registry};
use katydid_definition::document::{Document, NewPort, Object, Persistent, Side, Stored};
use katydid_geometry::{Point3, Vector3};
use katydid_solver::{Engine, Options, Status};
use uuid::Uuid;

const ITEMS: i32 = 1_000_000;

/// What an input has.
enum Input {
    Wire(Uuid),
    Value(Stored),
}

/// Adds a component with its inputs, and gives the id of its first output.
fn add(document: &mut Document, name: &str, inputs: Vec<Input>) -> Uuid {
    let next = |document: &Document, k: usize| Uuid::from_u128((document.objects.len() * 16 + k + 1) as u128);
    let component: &Component = registry::by_name(name).expect("the component is in");
    let mut object = Object::new_component(component.guid, name, component.nick, next(document, 0));
    for (k, (input, declared)) in inputs.into_iter().zip(component.inputs).enumerate() {
        let mut port =
            NewPort { id: next(document, k + 1), name: declared.name.to_owned(), ..NewPort::default() };
        let mut source = None;
        match input {
            Input::Wire(id) => source = Some(id),
            Input::Value(value) => port.persistent = Some(Persistent::item(value)),
        }
        let k = object.add_port(Side::Input, &port);
        if let Some(id) = source {
            object.set_sources(k, &[id]).expect("the input was just added");
        }
    }
    let mut first = None;
    for k in 0..component.outputs.len() {
        let port = NewPort { id: next(document, 10 + k), ..NewPort::default() };
        object.add_port(Side::Output, &port);
        first.get_or_insert(port.id);
    }
    document.objects.push(object);
    first.expect("the component has an output")
}

fn pipeline() -> Document {
    use Input::{Value, Wire};
    let mut document = Document::new();
    let d = &mut document;
    let number = |x: f64| Value(Stored::Number(x));
    let series = add(d, "Series", vec![number(0.0), number(0.001), Value(Stored::Integer(ITEMS))]);
    let sine = add(d, "Sine", vec![Wire(series)]);
    let point = add(d, "Construct Point", vec![Wire(series), Wire(sine), number(0.0)]);
    let moved = add(d, "Move", vec![Wire(point), Value(Stored::Vector(Vector3::new(0.0, 0.0, 10.0)))]);
    let origin = Value(Stored::Point(Point3::ORIGIN));
    let distance = add(d, "Distance", vec![Wire(moved), origin]);
    add(d, "Mass Addition", vec![Wire(distance)]);
    document
}

fn bench(c: &mut Criterion) {
    katydid_components::link();
    let mut group = c.benchmark_group("pipeline");
    group.sample_size(10);
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        group.bench_function(format!("threads {threads}"), |b| {
            let document = pipeline();
            b.iter_batched(
                || Engine::new(document.clone(), Options::default()),
                |mut engine| {
                    pool.install(|| engine.solve());
                    assert!((0..6).all(|i| engine.report(i).is_some_and(|r| r.status == Status::Ok)));
                    engine
                },
                criterion::BatchSize::PerIteration,
            );
        });
    }
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
