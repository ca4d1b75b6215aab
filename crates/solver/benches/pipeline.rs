//! A definition over a million items: Series → Sine → Construct Point → Move → Distance → Mass Addition.
//! `benches/compare.py` puts it beside the same in NumPy.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a benchmark may fail loudly")]

#[path = "../tests/common/mod.rs"]
mod common;

use common::{Sheet, number, value, wire};
use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use katydid_definition::document::{Document, Stored};
use katydid_geometry::{Point3, Vector3};
use katydid_solver::{Engine, Options, Status};

const ITEMS: i32 = 1_000_000;

fn pipeline() -> Document {
    let mut sheet = Sheet::default();
    let series = sheet.add("Series", vec![number(0.0), number(0.001), value(Stored::Integer(ITEMS))])[0];
    let sine = sheet.add("Sine", vec![wire(series)])[0];
    let point = sheet.add("Construct Point", vec![wire(series), wire(sine), number(0.0)])[0];
    let motion = value(Stored::Vector(Vector3::new(0.0, 0.0, 10.0)));
    let moved = sheet.add("Move", vec![wire(point), motion])[0];
    let distance = sheet.add("Distance", vec![wire(moved), value(Stored::Point(Point3::ORIGIN))])[0];
    sheet.add("Mass Addition", vec![wire(distance)]);
    sheet.document
}

fn bench(c: &mut Criterion) {
    let mut group = c.benchmark_group("pipeline");
    group.sample_size(10);
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let document = pipeline();
        group.bench_function(format!("threads {threads}"), |b| {
            b.iter_batched(
                || Engine::new(document.clone(), Options { skip_unread: true, ..Options::default() }),
                |mut engine| {
                    pool.install(|| engine.solve());
                    if std::env::var_os("PIPELINE_TIMES").is_some() {
                        let times =
                            (0..6).filter_map(|i| engine.report(i)).map(|r| r.time.as_secs_f64() * 1e3);
                        eprintln!("{:.1?}", times.collect::<Vec<_>>());
                    }
                    assert!((0..6).all(|i| engine.report(i).is_some_and(|r| r.status == Status::Ok)));
                    engine
                },
                BatchSize::PerIteration,
            );
        });
    }
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
