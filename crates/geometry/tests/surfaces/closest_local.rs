//! All local minima of the distance to a surface: closed forms, and dense sampling with descent.

use std::f64::consts::TAU;

use crate::common::Numbers;
use katydid_geometry::{
    ClosestOnSurface, Cone, Cylinder, Direction, Interval, NurbsSurface, Plane, PlaneSurface, Point3, Sphere,
    Surface, SurfaceMinima, Torus, clamped_uniform_knots,
};

#[track_caller]
fn distances(found: &SurfaceMinima, want: &[f64]) {
    let all: Vec<f64> = found.points.iter().map(|p| p.distance).collect();
    assert!(found.complete, "{found:?}");
    assert_eq!(all.len(), want.len(), "{found:?}");
    for (x, y) in all.iter().zip(want) {
        assert!((x - y).abs() < 1e-9, "{all:?} but {want:?}");
    }
}

#[test]
fn planes() {
    let range = Interval::new(0.0, 2.0);
    let s: Surface = PlaneSurface::new(Plane::XY, range, range).unwrap().into();
    for (q, want) in [
        (Point3::new(0.5, 1.5, 3.0), 3.0),
        (Point3::new(-4.0, 1.0, 3.0), 5.0),
        (Point3::new(3.0, 3.0, 1.0), 3.0_f64.sqrt()),
        (Point3::new(2.0, 1.0, 1.0), 1.0),
        (Point3::new(0.0, 0.0, 0.0), 0.0),
    ] {
        distances(&s.local_closest_points(q).unwrap(), &[want]);
    }
    assert!(s.local_closest_points(Point3::new(f64::NAN, 0.0, 0.0)).is_err());
    assert!(s.local_closest_points(Point3::new(1e200, 0.0, 0.0)).is_err());
}

#[test]
fn spheres_have_one_minimum_and_tori_one_or_two() {
    let mut numbers = Numbers(77);
    let plane = Plane { origin: Point3::new(1.0, -2.0, 0.5), ..Plane::XY };
    let sphere: Surface = Sphere::new(plane, 2.0).unwrap().into();
    let torus: Surface = Torus::new(plane, 3.0, 1.0).unwrap().into();
    for k in 0..80 {
        let q = match k {
            // Over the seam, over a pole, beside a pole.
            0 => plane.at(5.0, 0.0, 0.5),
            1 => plane.at(0.0, 0.0, 3.0),
            2 => plane.at(0.0, 0.0, 0.1),
            3..=14 => plane.at(10.0_f64.powi(-k), 0.3 * 10.0_f64.powi(-k), -3.0),
            _ => plane.origin + numbers.point(if k % 2 == 0 { 4.0 } else { 40.0 }).to_vector(),
        };
        let [x, y, z] = plane.coordinates(q);
        let found = sphere.local_closest_points(q).unwrap();
        // A hair from the axis rounding may leave ranges beside the pole undecided.
        let found = SurfaceMinima { complete: found.complete || (3..=14).contains(&k), ..found };
        distances(&found, &[(q.distance_to(plane.origin) - 2.0).abs()]);
        let p = found.points[0];
        assert!(sphere.point_at(p.u, p.v).distance_to(p.point) < 1e-9, "{q:?} {p:?}");
        if !(3..=14).contains(&k) {
            // In each half plane through the axis the nearer circle; the further one is a minimum along itself only
            // where the point is outside of its evolute, which is its centre.
            let found = torus.local_closest_points(q).unwrap();
            assert!(found.complete, "{q:?} {found:?}");
            let want = ((x.hypot(y) - 3.0).hypot(z) - 1.0).abs();
            assert!((found.points[0].distance - want).abs() < 1e-9, "{q:?} {found:?}");
            if x.hypot(y) > 1e-9 {
                assert_eq!(found.points.len(), 1, "{q:?} {found:?}");
            }
        }
    }
    // Everything is equally near.
    distances(&sphere.local_closest_points(plane.origin).unwrap(), &[2.0]);
    distances(&torus.local_closest_points(plane.at(0.0, 0.0, 1.5)).unwrap(), &[3.0_f64.hypot(1.5) - 1.0]);
    distances(&torus.local_closest_points(plane.at(0.0, 3.0, 0.0)).unwrap(), &[1.0]);
}

#[test]
fn parts_of_tori_have_two() {
    // Half a torus, seen from inside the hole: the two ends of the half are near as well.
    let torus: Surface = Torus::new(Plane::XY, 3.0, 1.0).unwrap().into();
    let half = torus.trimmed(Direction::U, Interval::new(0.0, 0.5 * TAU)).unwrap();
    // Below y = 0 each end of the half is nearest on its side.
    distances(
        &half.local_closest_points(Point3::new(0.5, -1.0, 0.0)).unwrap(),
        &[1.5_f64.hypot(1.0), 2.5_f64.hypot(1.0)],
    );
    distances(&half.local_closest_points(Point3::new(0.0, 0.5, 0.0)).unwrap(), &[1.5]);
}

#[test]
fn cylinders_and_cones() {
    let height = Interval::new(0.0, 4.0);
    let cylinder: Surface = Cylinder::new(Plane::XY, 1.0, height).unwrap().into();
    distances(&cylinder.local_closest_points(Point3::new(0.0, 0.25, 1.0)).unwrap(), &[0.75]);
    distances(&cylinder.local_closest_points(Point3::new(3.0, 0.0, 6.0)).unwrap(), &[8.0_f64.sqrt()]);
    // The axis: a circle of minima, inside and at a side.
    distances(&cylinder.local_closest_points(Point3::new(0.0, 0.0, 1.0)).unwrap(), &[1.0]);
    distances(&cylinder.local_closest_points(Point3::new(0.0, 0.0, 7.0)).unwrap(), &[10.0_f64.sqrt()]);
    // A cone, apex at the origin, half angle 45°: inside each side is near; the apex is a minimum from beyond it.
    let cone: Surface = Cone::new(Plane::XY, 2.0, 2.0).unwrap().into();
    let inside = Point3::new(0.3, 0.0, 1.0);
    distances(&cone.local_closest_points(inside).unwrap(), &[0.7 / 2.0_f64.sqrt()]);
    distances(&cone.local_closest_points(Point3::new(0.1, 0.2, -1.0)).unwrap(), &[1.05_f64.sqrt()]);
}

/// A surface over a grid of control points.
fn net(degrees: [usize; 2], counts: [usize; 2], height: impl Fn(usize, usize) -> f64) -> NurbsSurface {
    let mut points = Vec::new();
    for i in 0..counts[0] {
        for j in 0..counts[1] {
            points.push(Point3::new(i as f64, j as f64, height(i, j)));
        }
    }
    let knots = [0, 1].map(|d| clamped_uniform_knots(degrees[d], counts[d]).unwrap());
    NurbsSurface::new(degrees, counts, points, knots).unwrap()
}

#[test]
fn waves_and_roofs() {
    // A wave seen from far above: its crests are minima along the lines across, its valleys are not.
    let wave = net([3, 1], [9, 2], |i, _| if i % 2 == 0 { 0.0 } else { 3.0 });
    let found = wave.local_closest_points(Point3::new(4.0, 0.5, 60.0)).unwrap();
    assert!(found.complete);
    assert_eq!(found.points.len(), 4, "{found:?}");
    // Folded roofs: creases are minima, corners too.
    let roof = net([1, 1], [5, 2], |i, _| if i % 2 == 0 { 0.0 } else { 1.0 });
    let found = roof.local_closest_points(Point3::new(2.0, 0.5, 30.0)).unwrap();
    assert_eq!(found.points.len(), 2, "{found:?}");
    assert!(found.points.iter().all(|p| (p.point.z - 1.0).abs() < 1e-12 && (p.point.y - 0.5).abs() < 1e-12));
    let found = roof.local_closest_points(Point3::new(2.0, 0.5, -30.0)).unwrap();
    assert_eq!(found.points.len(), 3, "{found:?}");
    // Pyramids.
    let tips = net([1, 1], [5, 5], |i, j| if i % 2 == 1 && j % 2 == 1 { 1.0 } else { 0.0 });
    let found = tips.local_closest_points(Point3::new(2.0, 2.0, 30.0)).unwrap();
    assert_eq!(found.points.len(), 4, "{found:?}");
    assert!((found.points[0].distance - found.points[3].distance).abs() < 1e-12);
}

/// Minima by a grid of samples: those no further than their eight neighbours, each followed downhill.
fn sampled(s: &NurbsSurface, q: Point3, steps: usize) -> Vec<(f64, f64, f64)> {
    let domains = Direction::BOTH.map(|d| s.domain(d));
    let at = |d: usize, i: usize| domains[d].at(i as f64 / steps as f64);
    let far = |u: f64, v: f64| s.point_at(u, v).distance_to(q);
    let grid: Vec<Vec<f64>> =
        (0..=steps).map(|i| (0..=steps).map(|j| far(at(0, i), at(1, j))).collect()).collect();
    let mut out = Vec::new();
    for i in 0..=steps {
        for j in 0..=steps {
            let near = |k: usize| k.saturating_sub(1)..=(k + 1).min(steps);
            if near(i).any(|k| near(j).any(|l| grid[k][l] < grid[i][j])) {
                continue;
            }
            let (mut u, mut v, mut best) = (at(0, i), at(1, j), grid[i][j]);
            let mut step = domains.map(|d| d.length() / steps as f64);
            for _ in 0..200 {
                let mut moved = false;
                for k in 0..16 {
                    let angle = TAU * f64::from(k) / 16.0;
                    let x = domains[0].clamp(u + angle.cos() * step[0]);
                    let y = domains[1].clamp(v + angle.sin() * step[1]);
                    let d = far(x, y);
                    if d < best {
                        (u, v, best, moved) = (x, y, d, true);
                    }
                }
                if !moved {
                    step = step.map(|x| 0.5 * x);
                }
            }
            out.push((u, v, best));
        }
    }
    out
}

/// Whether nothing around is nearer.
fn is_minimum(s: &NurbsSurface, u: f64, v: f64, q: Point3) -> bool {
    let domains = Direction::BOTH.map(|d| s.domain(d));
    let here = s.point_at(u, v).distance_to(q);
    [1e-3, 1e-5].into_iter().all(|step| {
        (0..32).all(|k| {
            let angle = TAU * f64::from(k) / 32.0;
            let x = domains[0].clamp(u + angle.cos() * step);
            let y = domains[1].clamp(v + angle.sin() * step);
            s.point_at(x, y).distance_to(q) >= here - 1e-12 * (1.0 + here)
        })
    })
}

#[test]
fn random_surfaces() {
    let mut numbers = Numbers(0x5151_1234_9abc_def1);
    let mut most = 0;
    for case in 0..30 {
        let degrees = [[1, 1], [2, 2], [3, 3], [3, 2], [1, 3], [5, 4]][case % 6];
        let counts = [degrees[0] + 1 + case % 4, degrees[1] + 1 + case % 3];
        let knots = [0, 1].map(|d| clamped_uniform_knots(degrees[d], counts[d]).unwrap());
        let wild = if case < 12 { 0.4 } else { 2.5 };
        let mut points = Vec::new();
        for i in 0..counts[0] {
            for j in 0..counts[1] {
                points.push(Point3::new(i as f64, j as f64, 0.0) + numbers.point(wild).to_vector());
            }
        }
        let weights: Vec<f64> = points.iter().map(|_| 1.3 + numbers.next()).collect();
        let s = if case % 2 == 0 {
            NurbsSurface::new(degrees, counts, points, knots).unwrap()
        } else {
            NurbsSurface::with_weights(degrees, counts, &points, &weights, knots).unwrap()
        };
        let index = ClosestOnSurface::of_nurbs(&s);
        for k in 0..12 {
            let q = numbers.point(if k % 2 == 0 { 4.0 } else { 12.0 });
            let found = index.local_closest_points(q).unwrap();
            assert!(found.complete, "case {case} {k}");
            most = most.max(found.points.len());
            let nearest = index.nearest(q).unwrap();
            assert!((found.points[0].distance - nearest.distance).abs() < 1e-11, "case {case} {k}");
            for p in &found.points {
                assert!(is_minimum(&s, p.u, p.v, q), "case {case} {k}: {p:?}");
            }
            for (a, b) in found.points.iter().zip(found.points.iter().skip(1)) {
                assert!(a.distance <= b.distance);
                assert!((a.u - b.u).abs() > 1e-7 || (a.v - b.v).abs() > 1e-7, "case {case} {k}: twice {a:?}");
            }
            for (u, v, d) in sampled(&s, q, 40) {
                // What the descent left on a slope is no minimum.
                if !is_minimum(&s, u, v, q) {
                    continue;
                }
                let there = s.point_at(u, v);
                let near = |p: &&katydid_geometry::SurfacePoint| p.point.distance_to(there) < 1e-3;
                assert!(found.points.iter().any(|p| near(&p)), "case {case} {k}: missed {u} {v} at {d}");
            }
        }
    }
    assert!(most >= 4, "{most}");
}

#[test]
fn what_has_no_end_is_cut_off() {
    // A tube whose lines run aslant, from its own axis: a skew valley.
    let (n, turn) = (17, 12);
    let mut points = Vec::new();
    for i in 0..n {
        for j in 0..turn + 3 {
            let angle = TAU * (j as f64 / turn as f64 + i as f64 / 16.0);
            points.push(Point3::new(angle.cos(), angle.sin(), 0.2 * i as f64 + 0.05 * j as f64));
        }
    }
    let knots = [0, 1].map(|d| clamped_uniform_knots(3, [n, turn + 3][d]).unwrap());
    let s = NurbsSurface::new([3, 3], [n, turn + 3], points, knots).unwrap();
    let q = Point3::new(0.0, 0.0, 1.7);
    let found = s.local_closest_points(q).unwrap();
    let nearest = s.closest_point(q).unwrap();
    assert!((found.points[0].distance - nearest.distance).abs() < 1e-9);
    // A point for a surface.
    let point = net([2, 2], [3, 3], |_, _| 0.0);
    let nothing = NurbsSurface::new(
        [2, 2],
        [3, 3],
        vec![Point3::new(1.0, 1.0, 1.0); 9],
        [point.knots(Direction::U).to_vec(), point.knots(Direction::V).to_vec()],
    )
    .unwrap();
    assert_eq!(nothing.local_closest_points(Point3::ORIGIN).unwrap().points.len(), 1);
}
