//! Draws every Brep of archives with hidden lines: `draw_breps SECONDS PATH…`
//!
//! Said of every Brep that fails, whose curves are not all finite, or that takes longer than SECONDS; and the sums. One
//! that takes longer than 60 s is given up.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "an example stops at the first thing wrong")]

use std::sync::Arc;
use std::time::{Duration, Instant};

use katydid_geometry::brep::Brep;
use katydid_geometry::drawing::{DrawingOptions, Drawn, View, Visibility, drawing};
use katydid_geometry::{Plane, Point3, Tolerance, Vector3};

use breps_of::breps_of;

mod breps_of;

#[derive(Default, Debug)]
struct Sums {
    breps: usize,
    faces: usize,
    failed: usize,
    incomplete: usize,
    slow: usize,
    visible: usize,
    hidden: usize,
    seconds: f64,
    slowest: f64,
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let slow: f64 = arguments[0].parse().unwrap();
    let mut sums = Sums::default();
    for (name, brep) in breps_of(&arguments[1..]) {
        judge(&name, &brep, slow, &mut sums);
    }
    println!("{sums:?}");
}

fn judge(name: &str, brep: &Brep, slow: f64, sums: &mut Sums) {
    let Some(bounds) = brep.bounds_of_faces() else { return };
    let size = bounds.diagonal().length();
    let view =
        View::parallel(Plane::from_normal(Point3::ORIGIN, Vector3::new(3.0, -4.0, 2.0)).unwrap()).unwrap();
    let options = DrawingOptions {
        tangent_edges: true,
        tangent_seams: true,
        clipping: Vec::new(),
        tolerance: Tolerance { absolute: (1e-5 * size).max(1e-9), ..Tolerance::default() },
    };
    sums.breps += 1;
    sums.faces += brep.faces().len();
    let start = Instant::now();
    let go_on = || start.elapsed() < Duration::from_secs(60);
    let made = drawing(&[Drawn::Brep(Arc::new(brep.clone()))], &view, &options, &go_on);
    let took = start.elapsed().as_secs_f64();
    sums.seconds += took;
    sums.slowest = sums.slowest.max(took);
    if took > slow {
        sums.slow += 1;
        println!("{name}: {took:.2} s for {} faces", brep.faces().len());
    }
    match made {
        Err(why) => {
            sums.failed += 1;
            println!("{name}: {why}");
        }
        Ok(made) => {
            sums.incomplete += usize::from(!made.complete);
            for one in &made.curves {
                assert!(one.curve.check_finite().is_ok(), "{name}");
                sums.visible += usize::from(one.visibility == Visibility::Visible);
                sums.hidden += usize::from(one.visibility == Visibility::Hidden);
            }
        }
    }
}
