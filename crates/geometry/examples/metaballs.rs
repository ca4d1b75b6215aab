//! How long outlines and surfaces of up to a hundred thousand balls take:
//! `cargo run --release -p katydid-geometry --example metaballs`.

use std::time::Instant;

use katydid_geometry::isoline::Metaballs;
use katydid_geometry::isosurface::{Metaball, MetaballField};
use katydid_geometry::{Plane, Point3, Result};

/// The most looks at balls, and the most faces.
const MANY: usize = 1_000_000_000;

fn main() -> Result<()> {
    let mut state = 1_u64;
    // Numbers from 0 to 1 (D. Knuth's linear congruences).
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    for count in [1_000_u32, 10_000, 100_000] {
        let side = 4.0 * f64::from(count).sqrt();
        let points: Vec<Point3> =
            (0..count).map(|_| Point3::new(side * random(), side * random(), random())).collect();
        let field = Metaballs::new(&points, &[1.0], &Plane::XY)?;
        for threshold in [0.5, 2.0, 6.0] {
            let clock = Instant::now();
            let lines = field.isolines(threshold, field.usual_accuracy(threshold), MANY)?;
            let corners: usize = lines.iter().map(|l| l.points.len()).sum();
            let seconds = clock.elapsed().as_secs_f64();
            println!(
                "{count} balls at {threshold}: {} outlines, {corners} points, {seconds:.2} s",
                lines.len()
            );
        }
        let side = 1.3 * f64::from(count).cbrt();
        let balls: Vec<Metaball> = (0..count)
            .map(|_| {
                let center = Point3::new(side * random(), side * random(), side * random());
                Metaball { center, radius: 0.5 + random(), strength: 1.0 }
            })
            .collect();
        let clock = Instant::now();
        let mesh = MetaballField::new(&balls)?.mesh(0.9, 0.2, MANY, || true)?;
        let seconds = clock.elapsed().as_secs_f64();
        println!("{count} balls in space: {} faces, {seconds:.2} s", mesh.faces().len());
    }
    Ok(())
}
