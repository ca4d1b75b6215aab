//! Bad and large input: an answer or a refusal in good time, and none after nobody waits any more.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing test may panic")]

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use super::{SurfaceMeeting, surface_surface};
use crate::cancellation::work;
use crate::{CancellationToken, Error, NurbsSurface, Point3, Result, Tolerance};

/// What programs that are not optimised may take longer, on a machine that does other work as well.
const SLACK: u32 = if cfg!(debug_assertions) { 20 } else { 4 };

fn tolerance() -> Tolerance {
    Tolerance { absolute: 1e-5, ..Tolerance::default() }
}

fn grid(degree: usize, counts: [usize; 2], f: impl Fn(f64, f64) -> Point3) -> NurbsSurface {
    let [n, m] = counts;
    let points: Vec<Point3> =
        (0..n * m).map(|k| f((k / m) as f64 / (n - 1) as f64, (k % m) as f64 / (m - 1) as f64)).collect();
    NurbsSurface::clamped_uniform([degree, degree], counts, &points).unwrap()
}

fn wave(n: usize, phase: f64) -> NurbsSurface {
    grid(3, [n, n], |u, v| {
        let (x, y) = (10.0 * u, 10.0 * v);
        Point3::new(
            x + 0.05 * phase,
            y - 0.03 * phase,
            (1.3 * x + phase).sin() * (1.1 * y - 0.7 * phase).cos(),
        )
    })
}

/// The answer, which must come within seconds.
fn within(seconds: f64, a: &NurbsSurface, b: &NurbsSurface) -> Result<SurfaceMeeting> {
    let start = Instant::now();
    let met = surface_surface(a, b, &tolerance());
    let took = start.elapsed().as_secs_f64();
    println!("{took:.3} s");
    assert!(took < seconds * f64::from(SLACK), "{took} s");
    met
}

#[test]
fn collapsed_surfaces_end_soon() {
    let flat = grid(1, [2, 2], |u, v| Point3::new(u - 0.3, v - 0.4, 0.0));
    let point = grid(3, [5, 5], |_, _| Point3::ORIGIN);
    assert!(within(2.0, &point, &flat).is_err());
    for line in [
        grid(3, [5, 5], |u, _| Point3::new(u, 0.0, 0.0)),
        grid(3, [5, 5], |u, v| Point3::new(u + v, 0.1, 0.0)),
        grid(2, [5, 5], |u, _| Point3::new(u, u * u, u - 0.5)),
    ] {
        for other in [&flat, &wave(6, 0.3), &line] {
            assert!(within(2.0, &line, other).is_err());
        }
    }
    // One that is folded upon itself, and one that comes back to where it was.
    let folded = grid(2, [7, 7], |u, v| Point3::new((6.0 * u).sin(), v, 0.1 * v));
    let doubled = grid(3, [9, 9], |u, v| Point3::new((12.0 * u).cos(), (12.0 * u).sin(), v));
    for s in [&folded, &doubled] {
        for other in [&flat, &wave(6, 0.3), &folded, &doubled] {
            let _ = within(2.0, s, other);
        }
    }
}

#[test]
fn many_spans_end_soon() {
    // A hundred thousand patches.
    let large = wave(319, 0.2);
    let small = grid(3, [5, 5], |u, v| Point3::new(4.0 + u, 4.0 + v, 0.3 * u - 0.2 * v));
    let met = within(2.0, &large, &small);
    assert!(met.is_ok_and(|m| !m.branches.is_empty()));
    // A hundred thousand pieces between kinks, some of which run through a small surface.
    let strip = grid(1, [100_001, 2], |u, v| Point3::new(10.0 * u, 10.0 * v, 0.5 * (1000.0 * u).sin()));
    let met = within(2.0, &strip, &small);
    assert!(met.is_ok_and(|m| !m.branches.is_empty()));
    // All over each other: refused by name, or answered.
    let met = within(2.0, &large, &wave(319, 0.7));
    assert!(match met {
        Ok(met) => !met.branches.is_empty(),
        Err(error) => matches!(error, Error::Unsupported(_)),
    });
}

/// Between two questions whether anybody waits lies little work, whatever the input. A unit takes up to a microsecond in
/// programs that are optimised, so that 50 ms are 50,000; no clock is read.
#[test]
fn questions_are_asked_often() {
    const MOST: usize = 50_000;
    for (name, a, b) in [
        ("waves", wave(35, 0.0), wave(35, 1.0)),
        ("large waves", wave(319, 0.2), wave(319, 0.7)),
        ("strip", grid(1, [100_001, 2], |u, v| Point3::new(10.0 * u, 10.0 * v, 0.1 * u)), wave(35, 0.0)),
        ("next to each other", wave(12, 0.0), wave(13, 0.0)),
        ("the same", wave(100, 0.0), wave(100, 0.0)),
    ] {
        let asked = AtomicUsize::new(0);
        let token = CancellationToken::new(move || asked.fetch_add(1, Ordering::Relaxed) < 20_000);
        work::most();
        let met = token.during(|| surface_surface(&a, &b, &tolerance()));
        let most = work::most();
        println!("{name}: {most} units at most, {}", met.is_ok());
        assert!(most <= MOST, "{name}: {most}");
    }
}

#[test]
fn nobody_waits() {
    for (a, b) in [
        (wave(35, 0.0), wave(35, 1.0)),
        (wave(319, 0.2), wave(319, 0.7)),
        // Next to each other everywhere.
        (
            wave(9, 0.0),
            grid(3, [9, 9], |u, v| {
                let (x, y) = (10.0 * u, 10.0 * v);
                Point3::new(x, y, 1.3 * x.sin() * y.cos())
            }),
        ),
        (wave(12, 0.0), wave(13, 0.0)),
    ] {
        let start = Instant::now();
        let limit = Duration::from_millis(100);
        let token = CancellationToken::new(move || start.elapsed() < limit);
        let met = token.during(|| surface_surface(&a, &b, &tolerance()));
        let late = start.elapsed().saturating_sub(limit);
        assert!(late < Duration::from_millis(50) * SLACK, "{late:?}");
        assert!(met.is_ok() || met == Err(Error::Stopped));
    }
}

/// The same bits on any number of threads.
#[cfg(feature = "parallel")]
#[test]
fn threads_do_not_matter() {
    let (a, b) = (wave(12, 0.0), wave(12, 1.0));
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| surface_surface(&a, &b, &tolerance()).unwrap())
    };
    let one = on(1);
    assert!(!one.branches.is_empty());
    for threads in [2, 3, 8] {
        assert_eq!(on(threads), one);
    }
}
