//! Times the pairs of surfaces of a file of named curves and surfaces in text form.
//!
//! ```text
//! cargo run --release -p katydid-geometry --example ssi_time -- FILE NAME NAME
//! ```

use std::time::Instant;

use katydid_geometry::{NurbsSurface, Tolerance, intersect};

type Failure = Box<dyn std::error::Error>;

/// The surface of a name: `surf NAME degu degv nu nv rational`, then knots and control points on lines of their own.
fn surface(text: &str, name: &str) -> Result<NurbsSurface, Failure> {
    let mut lines = text.lines();
    let head = lines.find(|l| l.starts_with(&format!("surf {name} "))).ok_or("no such surface")?;
    let head: Vec<usize> = head.split_whitespace().skip(2).map(str::parse).collect::<Result<_, _>>()?;
    let &[p, q, n, m, _] = head.as_slice() else { return Err("five numbers are missing".into()) };
    let numbers = |line: Option<&str>| -> Result<Vec<f64>, Failure> {
        Ok(line.ok_or("too short")?.split_whitespace().map(str::parse).collect::<Result<_, _>>()?)
    };
    let knots = |all: Vec<f64>| all[1..all.len().max(2) - 1].to_vec();
    let (u, v) = (knots(numbers(lines.next())?), knots(numbers(lines.next())?));
    let points: Vec<[f64; 4]> = numbers(lines.next())?
        .chunks_exact(4)
        .map(|c| [c[0] * c[3], c[1] * c[3], c[2] * c[3], c[3]])
        .collect();
    Ok(NurbsSurface::rational([p, q], [n, m], points, [u, v])?)
}

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file, a, b] = arguments.as_slice() else { return Err("usage: ssi_time FILE NAME NAME".into()) };
    let text = std::fs::read_to_string(file)?;
    let [a, b] = [surface(&text, a)?, surface(&text, b)?];
    let [a, b] = [a, b].map(|s| s.to_non_rational().unwrap_or(s));
    for absolute in [1e-3, 1e-5] {
        let tolerance = Tolerance { absolute, ..Tolerance::default() };
        let mut best = f64::INFINITY;
        let mut met = intersect::surface_surface(&a, &b, &tolerance)?;
        for _ in 0..10 {
            let start = Instant::now();
            met = intersect::surface_surface(&a, &b, &tolerance)?;
            best = best.min(start.elapsed().as_secs_f64());
        }
        let length: f64 = met.branches.iter().map(|b| b.curve.length()).sum();
        println!(
            "within {absolute}: {} branches, {} closed, length {length:.6}, complete {}, {:.2} ms",
            met.branches.len(),
            met.branches.iter().filter(|b| b.closed).count(),
            met.complete,
            1e3 * best
        );
    }
    Ok(())
}
