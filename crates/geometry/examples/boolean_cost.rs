//! What booleans of solids cost.
//!
//! ```text
//! cargo run --release -p katydid-geometry --example boolean_cost [TEXT]
//! ```
//!
//! With a text only the lines that have it in their name are measured. Each line is the least time of several runs, with the volume of the result beside its closed form where it has one.

use std::f64::consts::PI;
use std::time::Instant;

use katydid_geometry::{
    BoundingBox, Box3, Brep, Cylinder, Interval, Plane, Point3, Result, Sphere, Tolerance, Torus, Vector3,
    construct,
};

const TOLERANCE: Tolerance = Tolerance { absolute: 1e-3, angle: 0.017_453_292_519_943_295 };

fn cuboid(min: [f64; 3], max: [f64; 3]) -> Result<Brep> {
    let bounds = BoundingBox { min: Point3::from(min), max: Point3::from(max) };
    construct::box_brep(&Box3::from(bounds))
}

fn tube(center: [f64; 3], radius: f64, height: f64) -> Result<Brep> {
    let plane = Plane::XY.with_origin(Point3::from(center));
    construct::cylinder(&Cylinder::new(plane, radius, Interval::new(0.0, height))?, [true; 2])
}

fn ring(center: [f64; 3], normal: [f64; 3], radii: [f64; 2]) -> Result<Brep> {
    let plane = Plane::from_normal(Point3::from(center), Vector3::from(normal))?;
    construct::torus(&Torus::new(plane, radii[0], radii[1])?)
}

/// Runs an operation some times and prints the least time, the volume of the result and the one that it should have. NaN where it is not asked for.
fn measure(name: &str, runs: usize, want: Option<f64>, work: impl Fn() -> Result<Vec<Brep>>) -> Result<f64> {
    if std::env::args().nth(1).is_some_and(|text| !name.contains(&text)) {
        return Ok(f64::NAN);
    }
    let mut least = f64::INFINITY;
    let mut made = Vec::new();
    for _ in 0..runs {
        let start = Instant::now();
        made = work()?;
        least = least.min(start.elapsed().as_secs_f64());
    }
    let mut volume = 0.0;
    let mut faces = 0;
    for brep in &made {
        volume += brep.volume_properties(1e-9, || true)?.amount;
        faces += brep.faces().len();
    }
    let want = want.map_or(String::new(), |w| format!(", off by {:.1e}", (volume - w).abs() / w));
    println!(
        "{name:<44} {:>10.3} ms, {} solids, {faces} faces, volume {volume:.6}{want}",
        1e3 * least,
        made.len()
    );
    Ok(least)
}

fn difference(a: &Brep, tools: &[Brep]) -> Result<Vec<Brep>> {
    let made = Brep::difference(std::slice::from_ref(a), tools, &TOLERANCE)?;
    Ok(made.into_iter().map(|m| m.brep).collect())
}

fn plate(count: usize) -> Result<()> {
    let side = 10.0 * count as f64;
    let block = cuboid([0.0; 3], [side, side, 5.0])?;
    let at = |k: usize| 10.0 * k as f64 + 5.0;
    let holes = (0..count * count)
        .map(|k| tube([at(k % count), at(k / count), -1.0], 3.0, 7.0))
        .collect::<Result<Vec<_>>>()?;
    let number = (count * count) as f64;
    let want = side * side * 5.0 - number * PI * 45.0;
    let name = format!("a plate with {number} holes in one call");
    measure(&name, if count > 4 { 3 } else { 10 }, Some(want), || difference(&block, &holes))?;
    Ok(())
}

fn row(count: usize) -> Result<()> {
    let boxes = (0..count)
        .map(|k| {
            let x = k as f64;
            cuboid([x, 0.1 * (k % 2) as f64, 0.0], [x + 1.5, 1.0 + 0.1 * (k % 2) as f64, 1.0])
        })
        .collect::<Result<Vec<_>>>()?;
    // Each two neighbours share 0.5 × 0.9 × 1; those after the next only touch nothing.
    let want = 1.5 * count as f64 - 0.45 * (count - 1) as f64;
    let name = format!("{count} boxes in a row united");
    let seconds = measure(&name, if count > 100 { 1 } else { 5 }, Some(want), || {
        Ok(Brep::union(&boxes, &TOLERANCE)?.into_iter().map(|m| m.brep).collect())
    })?;
    if seconds.is_finite() {
        println!("{:<44} {:>10.3} ms", "    for each box", 1e3 * seconds / count as f64);
    }
    Ok(())
}

fn main() -> Result<()> {
    let block = cuboid([0.0; 3], [10.0, 10.0, 10.0])?;
    let hole = [tube([5.0, 5.0, -1.0], 3.0, 12.0)?];
    measure("a box without a cylinder", 20, Some(1000.0 - 90.0 * PI), || difference(&block, &hole))?;
    plate(4)?;
    plate(10)?;
    for count in [10, 100, 1000] {
        row(count)?;
    }
    let first = ring([0.0; 3], [0.0, 0.0, 1.0], [5.0, 2.0])?;
    let ball = [construct::sphere(&Sphere::around(Point3::new(4.0, 1.0, 0.5), 3.0)?)?];
    measure("a torus without a ball", 3, None, || difference(&first, &ball))?;
    let second = [ring([4.0, 1.0, 0.5], [0.3, 1.0, 0.2], [5.0, 2.0])?];
    measure("a torus without a torus", 3, None, || difference(&first, &second))?;
    let bar = [tube([4.5, 0.5, -4.0], 1.5, 9.0)?];
    measure("a torus without a cylinder", 3, None, || difference(&first, &bar))?;
    let skew = Plane::from_normal(Point3::new(5.0, 1.0, 0.3), Vector3::new(0.3, 0.5, 1.0))?;
    let side = Interval::new(-2.0, 2.5);
    let block = [construct::box_brep(&Box3 { plane: skew, x: side, y: side, z: side })?];
    measure("a torus without a skew box", 3, None, || difference(&first, &block))?;
    Ok(())
}
