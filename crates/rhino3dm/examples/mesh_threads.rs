//! Meshes many breps on one thread and on two: `mesh_threads FRACTION COUNT PATH…`
//!
//! The breps are those of the archives, and made ones of every constructor up to COUNT in all. FRACTION is the
//! tolerance as a fraction of each brep's size. The rounds alternate between one thread and two; told are the medians.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "an example stops at the first thing wrong")]

#[path = "../../geometry/tests/solid_cases/mod.rs"]
mod solid_cases;

mod breps_of;

use std::time::Instant;

use breps_of::breps_of;
use katydid_geometry::{Brep, MeshSettings};
use rayon::ThreadPool;
use rayon::prelude::*;
use solid_cases::random::Random;

/// How often each number of threads meshes all breps.
const ROUNDS: usize = 7;

/// A brep and the tolerance for its mesh.
type Work = (Brep, MeshSettings);

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let fraction: f64 = arguments[0].parse().unwrap();
    let count: usize = arguments[1].parse().unwrap();
    let mut breps: Vec<Brep> = breps_of(&arguments[2..]).map(|(_, brep)| brep).collect();
    let from_files = breps.len().min(count);
    breps.truncate(count);
    made(&mut breps, count);
    let work: Vec<Work> = breps.into_iter().filter_map(|brep| with_settings(brep, fraction)).collect();
    println!("{} breps, {from_files} of them from archives", work.len());

    let pools = [1, 2].map(|n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap());
    let mut seconds = [const { Vec::new() }; 2];
    for round in 0..=ROUNDS {
        for (pool, seconds) in pools.iter().zip(&mut seconds) {
            let start = Instant::now();
            let triangles = meshed(pool, &work);
            // The first round warms the caches.
            if round > 0 {
                seconds.push(start.elapsed().as_secs_f64());
            } else {
                println!("{triangles} triangles on {} thread(s)", pool.current_num_threads());
            }
        }
    }
    let [one, two] = seconds.map(median);
    let load = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    println!("one thread {one:.3} s, two {two:.3} s: {:.2} times as fast; load {}", one / two, load.trim());
}

/// Fills up with breps of every constructor in turn.
fn made(breps: &mut Vec<Brep>, count: usize) {
    let cases = solid_cases::cases();
    for seed in 0.. {
        for (_, make) in &cases {
            breps.extend(make(&mut Random::of(seed)).into_iter().flatten());
            if breps.len() >= count {
                breps.truncate(count);
                return;
            }
        }
    }
}

fn with_settings(brep: Brep, fraction: f64) -> Option<Work> {
    let size = brep.bounds_of_faces()?.diagonal().length();
    Some((brep, MeshSettings::within(fraction * size)))
}

/// Meshes all on a pool; the sum of triangles.
fn meshed(pool: &ThreadPool, work: &[Work]) -> usize {
    let triangles = |(brep, settings): &Work| brep.mesh(settings).map_or(0, |mesh| mesh.triangle_count());
    pool.install(|| work.par_iter().map(triangles).sum())
}

fn median(mut seconds: Vec<f64>) -> f64 {
    seconds.sort_by(f64::total_cmp);
    seconds[seconds.len() / 2]
}
