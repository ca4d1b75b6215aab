//! How long a mesh of a million vertices takes to write and to read, in milliseconds: `mesh_archive_speed [OUT.3dm]`.

use std::time::Instant;

use katydid_3dm::{Limits, Model};
use katydid_geometry::{Mesh, MeshFace, Point3};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    const SIDE: u32 = 1000;
    let point = |i: u32| {
        let (x, y) = (f64::from(i % SIDE), f64::from(i / SIDE));
        Point3::new(x, y, (x / 50.0).sin() * (y / 70.0).cos())
    };
    let quads = (0..SIDE * (SIDE - 1)).filter(|i| i % SIDE + 1 < SIDE);
    let faces = quads.map(|i| MeshFace::Quad([i, i + 1, i + SIDE + 1, i + SIDE])).collect();
    let mut model = Model::default();
    model
        .objects
        .push(katydid_3dm::Object::from(Mesh::new((0..SIDE * SIDE).map(point).collect(), faces)?).into());
    let start = Instant::now();
    let bytes = model.write(70)?;
    println!("written: {} ms, {} bytes", start.elapsed().as_millis(), bytes.len());
    for _ in 0..3 {
        let start = Instant::now();
        let back = Model::read(&bytes, &Limits::default())?;
        println!("read: {} ms, {} objects", start.elapsed().as_millis(), back.objects.len());
    }
    if let Some(path) = std::env::args().nth(1) {
        std::fs::write(path, &bytes)?;
    }
    Ok(())
}
