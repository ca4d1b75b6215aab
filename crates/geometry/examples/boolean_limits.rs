//! What booleans of solids keep to: memory beside the result, two threads beside one, solids with many patches.
//!
//! ```text
//! cargo run --release -p katydid-geometry --example boolean_limits -- memory | plate | threads | patches
//! ```
//!
//! Memory is told where the system has `/proc`.

use std::f64::consts::{PI, TAU};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use katydid_geometry::brep::Made;
use katydid_geometry::{
    BoundingBox, Box3, Brep, Cone, Cylinder, Interval, NurbsSurface, Plane, Point3, Result, Sphere,
    Tolerance, Torus, Vector3, construct,
};

const TOLERANCE: Tolerance = Tolerance { absolute: 1e-3, angle: 0.017_453_292_519_943_295 };

fn cuboid(min: [f64; 3], max: [f64; 3]) -> Result<Brep> {
    construct::box_brep(&Box3::from(BoundingBox { min: Point3::from(min), max: Point3::from(max) }))
}

/// A number of the status of this process, in megabytes: its memory now (`VmRSS`) or at most (`VmHWM`).
fn memory(what: &str) -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|l| l.starts_with(what)).unwrap_or_default();
    line.split_whitespace().nth(1).and_then(|n| n.parse::<f64>().ok()).map_or(f64::NAN, |k| k / 1024.0)
}

/// The most memory that an operation takes, beside what its result does: `copies` of it must be more than the operation
/// leaves free.
fn most_memory(name: &str, copies: usize, work: impl Fn() -> Result<Vec<Made>>) -> Result<()> {
    let before = memory("VmRSS");
    let made = work()?;
    let most = memory("VmHWM") - before;
    let faces: usize = made.iter().map(|m| m.brep.faces().len()).sum();
    // The first half fills what is free.
    let half: Vec<Vec<Made>> = (0..copies / 2).map(|_| made.clone()).collect();
    let start = memory("VmRSS");
    let rest: Vec<Vec<Made>> = (0..copies / 2).map(|_| made.clone()).collect();
    let own = (memory("VmRSS") - start) / rest.len() as f64;
    drop(half);
    println!("{name}: {faces} faces, at most {most:.1} MB, the result {own:.2} MB: {:.1} times", most / own);
    Ok(())
}

fn boxes_in_a_row(count: usize) -> Result<Vec<Brep>> {
    let place = |k: usize| (k as f64, 0.1 * (k % 2) as f64);
    (0..count).map(place).map(|(x, y)| cuboid([x, y, 0.0], [x + 1.5, 1.0 + y, 1.0])).collect()
}

/// A generator of numbers from -1 to 1 (S. Vigna's splitmix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn solid(&mut self, kind: usize) -> Result<Brep> {
        let [x, y, z, a, b, c] = [0; 6].map(|_| self.next());
        let plane = Plane::from_normal(Point3::new(x, y, z), Vector3::new(a, b, c))?;
        let [a, b, c] = [0; 3].map(|_| 1.4 + 0.6 * self.next());
        let range = |x: f64| Interval::new(-0.5 * x, 0.5 * x);
        match kind {
            0 => construct::box_brep(&Box3 { plane, x: range(a), y: range(b), z: range(c) }),
            1 => construct::cylinder(&Cylinder::new(plane, 0.5 * a, range(b))?, [true; 2]),
            2 => construct::sphere(&Sphere::new(plane, 0.6 * a)?),
            3 => construct::torus(&Torus::new(plane, 0.6 * a, 0.25 * a)?),
            _ => construct::cone(&Cone::new(plane, b, 0.5 * c)?, true),
        }
    }
}

/// Differences of pairs, one after another on every thread.
fn differences(pairs: &[[Brep; 2]], threads: usize) -> (f64, Vec<Option<Result<Vec<Made>>>>) {
    let next = AtomicUsize::new(0);
    let one = || {
        let mut own = Vec::new();
        while let Some((k, [a, b])) = {
            let k = next.fetch_add(1, Ordering::Relaxed);
            pairs.get(k).map(|pair| (k, pair))
        } {
            let made = Brep::difference(std::slice::from_ref(a), std::slice::from_ref(b), &TOLERANCE);
            own.push((k, made));
        }
        own
    };
    let start = Instant::now();
    let mut out: Vec<Option<Result<Vec<Made>>>> = vec![None; pairs.len()];
    std::thread::scope(|scope| {
        let running: Vec<_> = (0..threads).map(|_| scope.spawn(one)).collect();
        for own in running.into_iter().filter_map(|r| r.join().ok()).flatten() {
            if let Some(place) = out.get_mut(own.0) {
                *place = Some(own.1);
            }
        }
    });
    (start.elapsed().as_secs_f64(), out)
}

fn threads() -> Result<()> {
    let mut random = Random(7);
    let mut pairs = Vec::new();
    for k in 0..500 {
        pairs.push([random.solid(k % 5)?, random.solid(k / 5 % 5)?]);
    }
    let mut least = [f64::INFINITY; 2];
    let mut same = true;
    let mut refused = 0;
    for _ in 0..3 {
        let [one, two] = [1, 2].map(|threads| differences(&pairs, threads));
        least = [least[0].min(one.0), least[1].min(two.0)];
        same &= one.1 == two.1;
        refused = one.1.iter().filter(|r| matches!(r, Some(Err(_)) | None)).count();
    }
    let [one, two] = least;
    println!(
        "500 pairs, {refused} refused: {one:.3} s on one thread, {two:.3} s on two, {:.2} times as quick, {}",
        one / two,
        if same { "the same to the last bit" } else { "NOT the same" }
    );
    Ok(())
}

/// A ball with waves: a bicubic surface of n by n patches between two poles, closed around.
fn wavy_ball(n: usize, center: Point3, phase: f64) -> Result<Brep> {
    let count = n + 3;
    let knots: Vec<f64> =
        std::iter::repeat_n(0, 3).chain(0..=n).chain(std::iter::repeat_n(n, 3)).map(|k| k as f64).collect();
    // Without the first and the last, which say nothing.
    let knots = knots[1..knots.len() - 1].to_vec();
    let mut points = Vec::with_capacity(count * count);
    for i in 0..count {
        let turn = if i + 1 == count { 0.0 } else { TAU * i as f64 / (count - 1) as f64 };
        for j in 0..count {
            let height = PI * j as f64 / (count - 1) as f64;
            let radius = 3.0 + 0.2 * (3.0 * turn + phase).sin() * (2.0 * height).sin();
            let around = if j == 0 || j + 1 == count { 0.0 } else { height.sin() };
            let arm = Vector3::new(around * turn.cos(), around * turn.sin(), -height.cos());
            points.push(center + arm * if around == 0.0 { 3.0 } else { radius });
        }
    }
    Brep::from_surface(NurbsSurface::new([3, 3], [count, count], points, [knots.clone(), knots])?.into())
}

fn patches() -> Result<()> {
    for n in [5, 10, 20] {
        let a = wavy_ball(n, Point3::ORIGIN, 0.0)?;
        let b = wavy_ball(n, Point3::new(2.1, 0.7, 0.4), 1.0)?;
        let mut least = f64::INFINITY;
        let mut made = Vec::new();
        for _ in 0..5 {
            let start = Instant::now();
            made = Brep::difference(std::slice::from_ref(&a), std::slice::from_ref(&b), &TOLERANCE)?;
            least = least.min(start.elapsed().as_secs_f64());
        }
        let common = Brep::intersection(std::slice::from_ref(&a), std::slice::from_ref(&b), &TOLERANCE)?;
        // Two balls of the radius 3 have a lens in common; the waves are small beside it.
        let apart = (2.1_f64 * 2.1 + 0.7 * 0.7 + 0.4 * 0.4).sqrt();
        let lens = PI / 12.0 * (12.0 + apart) * (6.0 - apart) * (6.0 - apart);
        let mut volume = 0.0;
        for part in &common {
            volume += part.brep.volume_properties(1e-8, || true)?.amount;
        }
        println!(
            "{n}² bicubic solid without another: {:.1} ms, {} solids; {volume:.4} in common, of balls {lens:.4}",
            1e3 * least,
            made.len()
        );
    }
    Ok(())
}

fn main() -> Result<()> {
    let asked = std::env::args().nth(1);
    let is = |name: &str| asked.as_deref().is_none_or(|a| a == name);
    // Each in a process of its own: the most memory only grows.
    if is("memory") {
        let row = boxes_in_a_row(1000)?;
        most_memory("1,000 boxes in a row united", 40, || Brep::union(&row, &TOLERANCE))?;
    }
    if is("plate") {
        let side = 320.0;
        let block = [cuboid([0.0; 3], [side, side, 5.0])?];
        let at = |k: usize| 10.0 * k as f64 + 5.0;
        let tube = |k: usize| {
            let plane = Plane::XY.with_origin(Point3::new(at(k % 32), at(k / 32), -1.0));
            construct::cylinder(&Cylinder::new(plane, 3.0, Interval::new(0.0, 7.0))?, [true; 2])
        };
        let holes = (0..1024).map(tube).collect::<Result<Vec<_>>>()?;
        most_memory("a plate with 1,024 holes", 400, || Brep::difference(&block, &holes, &TOLERANCE))?;
    }
    if is("threads") {
        threads()?;
    }
    if is("patches") {
        patches()?;
    }
    Ok(())
}
