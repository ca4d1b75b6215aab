//! One number of a 1,000-object definition changes, as when a slider is dragged: the solve that follows, by how many
//! objects hang on that number. The time is to be in proportion to them.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a benchmark may fail loudly")]

#[path = "../tests/common/mod.rs"]
mod common;

use common::{Sheet, number, wire};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use katydid_definition::document::{Document, Persistent, Stored};
use katydid_solver::{Engine, Options};

const OBJECTS: usize = 1_000;

/// Two numbers; `hanging` additions in rows of ten hang on the first, all others on the second.
fn definition(hanging: usize) -> Document {
    let mut sheet = Sheet::default();
    let moved = sheet.add("Number", vec![number(1.0)])[0];
    let still = sheet.add("Number", vec![number(2.0)])[0];
    for (source, count) in [(moved, hanging), (still, OBJECTS - 2 - hanging)] {
        let mut last = source;
        for k in 0..count {
            last = if k % 10 == 0 { source } else { last };
            last = sheet.add("Addition", vec![wire(last), number(0.5)])[0];
        }
    }
    sheet.document
}

fn bench(c: &mut Criterion) {
    let mut group = c.benchmark_group("slider");
    for hanging in [1, 10, 100, 998] {
        group.throughput(Throughput::Elements(hanging as u64));
        group.bench_with_input(BenchmarkId::from_parameter(hanging), &hanging, |b, &hanging| {
            let mut engine = Engine::new(definition(hanging), Options::default());
            assert_eq!(engine.solve().solved, OBJECTS);
            let mut x = 0.0;
            b.iter(|| {
                x += 1.0;
                let value = Persistent::item(Stored::Number(x));
                engine.edit(0, |object| object.set_persistent(0, Some(&value)).unwrap());
                assert_eq!(engine.solve().solved, hanging + 1);
            });
        });
    }
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
