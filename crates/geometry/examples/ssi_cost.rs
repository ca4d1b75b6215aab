//! What surface with surface costs by the number of patches: waves that cross in many curves.
//!
//! ```text
//! cargo run --release -p katydid-geometry --example ssi_cost
//! ```

use std::time::Instant;

use katydid_geometry::{NurbsSurface, Point3, Tolerance, intersect};

type Failure = Box<dyn std::error::Error>;

/// A bicubic surface of n by n patches over a square of side 10, its heights a wave of a phase.
fn wave(n: usize, phase: f64) -> Result<NurbsSurface, Failure> {
    let count = n + 3;
    let points: Vec<Point3> = (0..count * count)
        .map(|k| {
            let [x, y] = [k / count, k % count].map(|i| 10.0 * i as f64 / (count - 1) as f64);
            Point3::new(
                x + 0.05 * phase,
                y - 0.03 * phase,
                (1.3 * x + phase).sin() * (1.1 * y - 0.7 * phase).cos(),
            )
        })
        .collect();
    Ok(NurbsSurface::clamped_uniform([3, 3], [count, count], &points)?)
}

/// Seconds that this process has used a processor where the system tells; else seconds by the clock.
fn seconds(start: Instant) -> f64 {
    let own = std::fs::read_to_string("/proc/self/schedstat").ok();
    let nanoseconds = own.and_then(|s| s.split_whitespace().next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| start.elapsed().as_secs_f64(), |n| 1e-9 * n)
}

/// The most memory that this process had, in megabytes, where the system tells.
fn memory() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    Some(line.split_whitespace().nth(1)?.parse::<f64>().ok()? / 1024.0)
}

fn main() -> Result<(), Failure> {
    let start = Instant::now();
    println!("patches   branches  places  complete  seconds  memory (MB)");
    for n in [4, 8, 16, 32] {
        let (a, b) = (wave(n, 0.0)?, wave(n, 1.0)?);
        let tolerance = Tolerance { absolute: 1e-4, ..Tolerance::default() };
        let before = seconds(start);
        let met = intersect::surface_surface(&a, &b, &tolerance)?;
        let used = seconds(start) - before;
        let places: usize = met.branches.iter().map(|b| b.parameters[0].control_points().len() / 2).sum();
        println!(
            "{:>7}  {:>9}  {places:>6}  {:>8}  {used:>7.4}  {:>8.1}",
            format!("{n}²"),
            met.branches.len(),
            met.complete,
            memory().unwrap_or(f64::NAN)
        );
    }
    Ok(())
}
