//! What must not change an answer: the order of the surfaces, moves, scales, turns, other parameters; and answers that must
//! change only where the surfaces touch.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing test may panic")]

use super::random_tests::{TOLERANCE, pair, part};
use super::{SurfaceContactKind, SurfaceMeeting, surface_surface};
use crate::{Direction, Error, NurbsSurface, Plane, Point3, Surface, Tolerance, Torus, Vector3, Xform};

fn meet(a: &NurbsSurface, b: &NurbsSurface, scale: f64) -> SurfaceMeeting {
    surface_surface(a, b, &Tolerance { absolute: TOLERANCE * scale, ..Tolerance::default() }).unwrap()
}

fn counts(met: &SurfaceMeeting) -> [usize; 2] {
    let closed = met.branches.iter().filter(|b| b.closed).count();
    [closed, met.branches.len() - closed]
}

fn length(met: &SurfaceMeeting) -> f64 {
    met.branches.iter().map(|b| b.curve.length()).sum()
}

/// The same surface by more control points and other knots.
fn finer(s: &NurbsSurface) -> NurbsSurface {
    let up = s.raised_to(Direction::U, s.degree(Direction::U) + 1).unwrap();
    let [u, v] = Direction::BOTH.map(|d| up.domain(d));
    let fine = up.insert_knot(Direction::V, v.at(0.371), 1).unwrap();
    fine.insert_knot(Direction::U, u.at(0.613), 1).unwrap()
}

/// How many of the random pairs from `first` change their branches under what must not change them.
fn changed(pairs: u64, first: u64) -> [usize; 2] {
    let (mut told, mut wrong) = (0, 0);
    for number in first..first + pairs {
        let (a, b, ..) = pair(number);
        let met = meet(&a, &b, 1.0);
        if !met.complete || !met.contacts.is_empty() {
            continue;
        }
        told += 1;
        let (want, own) = (counts(&met), length(&met));
        let mut hold = |name: &str, other: &SurfaceMeeting, scale: f64, digits: f64| {
            let near = (length(other) / scale - own).abs() <= digits * own.max(1.0);
            if !(counts(other) == want && near && other.complete) {
                wrong += 1;
                println!(
                    "pair {number} {name}: {:?} {} {}, not {want:?} {own}",
                    counts(other),
                    length(other) / scale,
                    other.complete
                );
            }
        };
        hold("swapped", &meet(&b, &a, 1.0), 1.0, 1e-13);
        let turn = Xform::rotation(0.7, Vector3::new(1.0, 2.0, 2.0) / 3.0, Point3::ORIGIN).unwrap();
        for (name, xform, scale) in [
            ("moved", Xform::translation(Vector3::new(1e6, -1e6, 1e6)), 1.0),
            ("small", Xform::scale(Point3::ORIGIN, 1e-3), 1e-3),
            ("large", Xform::scale(Point3::ORIGIN, 1e4), 1e4),
            ("turned", turn, 1.0),
        ] {
            let [a, b] = [&a, &b].map(|s| s.transformed(&xform).unwrap());
            hold(name, &meet(&a, &b, scale), scale, 1e-4);
        }
        hold("reversed", &meet(&a.reversed(Direction::U), &b, 1.0), 1.0, 1e-4);
        hold("transposed", &meet(&a, &b.transposed(), 1.0), 1.0, 1e-4);
        hold("finer", &meet(&finer(&a), &finer(&b), 1.0), 1.0, 1e-4);
    }
    [told, wrong]
}

#[test]
fn nothing_changes_random_pairs() {
    let [told, wrong] = changed(6, 0);
    assert!(told > 3, "{told}");
    assert_eq!(wrong, 0);
}

/// Run with `make test-branches`; `PAIRS=first..end` runs a part.
#[test]
#[ignore = "minutes of work: make test-branches"]
fn no_branch_of_many_changes() {
    let [first, end] = part([100_000, 100_600]);
    let [told, wrong] = changed(end - first, first);
    println!("{told} told, {wrong} changed");
    assert_eq!(wrong, 0);
}

/// A plane through the middle of a ring tilts through the place where it touches the ring twice and cuts it in Villarceau's
/// circles: two circles around the axis become two beside it.
#[test]
fn a_plane_tilts_through_the_circles_of_villarceau() {
    let ring = Surface::from(Torus::new(Plane::XY, 2.0, 0.5).unwrap()).to_nurbs().unwrap();
    let critical = (0.5_f64 / 2.0).asin();
    for step in 0..=200 {
        let tilt = critical + 1e-3 * f64::from(step - 100);
        let normal = Vector3::new(tilt.sin() * 0.6, tilt.sin() * 0.8, tilt.cos());
        let plane = Plane::from_normal(Point3::ORIGIN, normal).unwrap();
        let corner = |x: f64, y: f64| plane.origin + plane.x_axis * x + plane.y_axis * y;
        let floor = NurbsSurface::from_corners(
            corner(-4.1, -4.3),
            corner(4.2, -4.0),
            corner(4.4, 4.1),
            corner(-4.0, 4.5),
        )
        .unwrap();
        let met = meet(&ring, &floor, 1.0);
        let crossings = met.contacts.iter().filter(|c| c.kind == SurfaceContactKind::Crossing).count();
        if step == 100 {
            assert_eq!((crossings, met.contacts.len()), (2, 2), "{:?}", met.contacts);
            let whole = 2.0 * std::f64::consts::TAU * 2.0;
            assert!((length(&met) - whole).abs() < 1e-4, "{}", length(&met));
        } else {
            assert_eq!((counts(&met), met.contacts.len(), met.complete), ([2, 0], 0, true), "{step}");
        }
    }
}

/// A wavy surface and itself turned about its normal by ever smaller angles have the curves in common along which turning
/// moves it in itself: always as many, or a cluster is named, or they are refused by name.
#[test]
fn waves_meet_themselves_turned() {
    let count = 9;
    let points: Vec<Point3> = (0..count * count)
        .map(|k| {
            let [x, y] = [k / count, k % count].map(|i| -2.0 + 4.0 * i as f64 / (count - 1) as f64);
            Point3::new(x, y, 0.3 * (1.7 * x + 0.4).sin() * (1.3 * y - 0.2).cos() + 0.1 * x * y)
        })
        .collect();
    let wave = NurbsSurface::clamped_uniform([3, 3], [count, count], &points).unwrap();
    let [p, u, v] = wave.partials_at(0.5, 0.5, crate::Quadrant::NorthEast);
    let normal = u.cross(v).unitized().unwrap();
    let mut known: Option<[usize; 2]> = None;
    for k in 0..=5 {
        let turn = Xform::rotation(10f64.powi(-k).to_radians(), normal, p.to_point()).unwrap();
        let tolerance = Tolerance { absolute: TOLERANCE, ..Tolerance::default() };
        let met = match surface_surface(&wave, &wave.transformed(&turn).unwrap(), &tolerance) {
            Err(Error::Unsupported(_)) if k > 0 => continue,
            met => met.unwrap(),
        };
        let named = met.contacts.iter().any(|c| c.kind == SurfaceContactKind::Undecided);
        assert!(met.complete || named, "{k}");
        if met.complete && k >= 1 {
            assert_eq!(*known.get_or_insert(counts(&met)), counts(&met), "{k}");
        }
        assert!(met.complete || k > 0, "{k}: {:?}", met.contacts);
    }
}
