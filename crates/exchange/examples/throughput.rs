//! How fast files are written and read: a ball of 1.5 million triangles, to memory.

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use katydid_exchange::{Format, Options, Scene, Shape, Thing, read, write};
use katydid_geometry::{Mesh, Plane};

fn main() -> Result<(), Box<dyn Error>> {
    let ball = Mesh::sphere(&Plane::XY, 10.0, 1232, 616)?;
    let triangles: usize = ball.faces().iter().map(|face| face.triangles().count()).sum();
    println!("{triangles} triangles");
    let scene = Scene { things: vec![Thing::named("ball", Shape::Mesh(ball))], ..Scene::default() };
    for format in Format::ALL {
        for ascii in [false, true] {
            if ascii && !matches!(format, Format::Stl | Format::Ply) {
                continue;
            }
            let options = Options { ascii, ..Options::default() };
            let mut bytes = Vec::with_capacity(800 << 20);
            let mut best = f64::INFINITY;
            for _ in 0..3 {
                bytes.clear();
                let start = Instant::now();
                write(black_box(&scene), format, &options, &mut bytes)?;
                best = best.min(start.elapsed().as_secs_f64());
            }
            let megabytes = bytes.len() as f64 / 1e6;
            let form = if ascii { " as text" } else { "" };
            print!("{format:?}{form}: {megabytes:.1} MB, written at {:.0} MB/s", megabytes / best);
            if format.is_read() {
                let start = Instant::now();
                black_box(read(&bytes, format)?);
                print!(", read at {:.0} MB/s", megabytes / start.elapsed().as_secs_f64());
            }
            println!();
        }
    }
    Ok(())
}
