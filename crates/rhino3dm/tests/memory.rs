//! What reading takes beside the model that it gives: counted allocations, the same on every run.
#![allow(clippy::unwrap_used, reason = "a test")]

mod common;

use allocation_counter::measure;
use katydid_3dm::{Limits, Model, Object};
use katydid_geometry::{Line, Point3};

/// Bytes on the heap while an archive is read, and of the model that comes out of it.
struct Memory {
    /// The most there was at any time, the archive's own bytes among it.
    peak: u64,
    /// The model without room to grow.
    model: u64,
}

impl Memory {
    fn of_reading(bytes: &[u8]) -> Self {
        let mut read = None;
        let reading = measure(|| read = Model::read(bytes, &Limits::default()).ok());
        let model = read.unwrap();
        let mut copy = None;
        let copying = measure(|| copy = Some(model.clone()));
        drop(copy);
        Self {
            peak: reading.bytes_max + bytes.len() as u64,
            model: u64::try_from(copying.bytes_current).unwrap(),
        }
    }
}

/// What reading may take beside the model: so many times the archive.
const TIMES: f64 = 4.0;

#[test]
fn reading_takes_four_times_the_archive_at_most_beside_the_model() {
    let mut shares: Vec<(f64, String)> = Vec::new();
    for (path, bytes) in common::archives() {
        let Memory { peak, model } = Memory::of_reading(&bytes);
        let beside = peak.saturating_sub(model) as f64;
        let size = bytes.len() as f64;
        let name = path.file_name().unwrap_or_default().display();
        shares.push((beside / size, format!("{name}, {size} bytes; the model has {model}")));
        assert!(beside <= TIMES * size, "{name}: {beside} bytes beside {model}");
    }
    shares.sort_by(|a, b| b.0.total_cmp(&a.0));
    shares.iter().for_each(|(share, what)| println!("{share:6.2} times {what}"));
}

/// Many small objects: lists that grow by doubling would take most here.
#[test]
fn many_objects_take_no_more() {
    let mut model = Model::default();
    for i in 0..5000 {
        let x = f64::from(i);
        let ends = [Point3::new(x, 0.0, 0.0), Point3::new(x, 1.0, 0.0)];
        model.objects.push(Object::Point(ends[0]).into());
        model.objects.push(Object::Curve(Line::new(ends[0], ends[1]).into()).into());
    }
    for version in [4, 50, 70, 80] {
        let bytes = model.write(version).unwrap();
        let Memory { peak, model } = Memory::of_reading(&bytes);
        let beside = peak.saturating_sub(model) as f64;
        assert!(beside <= TIMES * bytes.len() as f64, "{beside} bytes beside {model} for {}", bytes.len());
    }
}
