//! Objects and the buffers of meshes are written side by side; what comes out must not show it.
#![cfg(feature = "parallel")]
#![allow(clippy::unwrap_used, reason = "a test")]

mod common;

use katydid_3dm::{Limits, Model, Object};
use katydid_geometry::{Line, Mesh, Plane, Point3};
use rayon::ThreadPoolBuilder;

const VERSIONS: [i32; 5] = [4, 50, 60, 70, 80];

/// Objects of very different sizes, so that threads end them in another order than they began them.
fn mixed() -> Model {
    let mut model = Model::default();
    for i in 0..300_u32 {
        let x = f64::from(i);
        let object = match i % 10 {
            0 => Object::from(Mesh::sphere(&Plane::XY, 1.0 + x, 40, 3 + i as usize / 3).unwrap()),
            3 | 6 => Object::Point(Point3::new(x, 0.0, 0.0)),
            _ => Object::Curve(Line::new(Point3::ORIGIN, Point3::new(1.0, x, 0.0)).into()),
        };
        model.objects.push(object.into());
    }
    model
}

#[test]
fn the_bytes_do_not_depend_on_the_number_of_threads() {
    let largest = common::archives().into_iter().rev().take(12);
    let read = largest.map(|(_, bytes)| Model::read(&bytes, &Limits::default()).unwrap());
    let models: Vec<Model> = std::iter::once(mixed()).chain(read).collect();
    let written = |threads: usize| -> Vec<Vec<u8>> {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let pairs = models.iter().flat_map(|model| VERSIONS.map(|version| (model, version)));
        pool.install(|| pairs.map(|(model, version)| model.write_what_fits(version).unwrap().0).collect())
    };
    let alone = written(1);
    for threads in [2, 3, 8] {
        assert!(written(threads) == alone, "{threads} threads write other bytes than one");
    }
    // And again: no state is left behind by the first time.
    assert!(written(8) == alone);
}
