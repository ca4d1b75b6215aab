//! The nearest point of a surface and its area: against dense sampling, other programs and closed forms.

use std::f64::consts::PI;

use crate::common::{Numbers, number, numbers, oracle, point, surface};
use katydid_geometry::{ClosestOnSurface, Direction, NurbsSurface, Plane, Point3, Sphere, Surface, Torus};

/// The least distance by a grid of samples and a shrinking search around the best of them.
fn sampled(s: &NurbsSurface, samples: &[(f64, f64, Point3)], steps: usize, q: Point3) -> f64 {
    let mut near: Vec<usize> = (0..samples.len()).collect();
    near.select_nth_unstable_by(4, |&a, &b| {
        samples[a].2.distance_to(q).total_cmp(&samples[b].2.distance_to(q))
    });
    let domains = Direction::BOTH.map(|d| s.domain(d));
    let mut least = f64::INFINITY;
    for &i in near.iter().take(4) {
        let (mut u, mut v, p) = samples[i];
        let mut best = p.distance_to(q);
        let mut step = domains.map(|d| d.length() / steps as f64);
        for _ in 0..120 {
            let mut moved = false;
            for (a, b) in [
                (1.0, 0.0),
                (-1.0, 0.0),
                (0.0, 1.0),
                (0.0, -1.0),
                (1.0, 1.0),
                (-1.0, 1.0),
                (1.0, -1.0),
                (-1.0, -1.0),
            ] {
                let (x, y) = (domains[0].clamp(u + a * step[0]), domains[1].clamp(v + b * step[1]));
                let d = s.point_at(x, y).distance_to(q);
                if d < best {
                    (u, v, best, moved) = (x, y, d, true);
                }
            }
            if !moved {
                step = step.map(|x| 0.5 * x);
            }
        }
        least = least.min(best);
    }
    least
}

#[test]
fn random_surfaces_and_places() {
    let mut numbers = Numbers(0x1234_5678_9abc_def1);
    for case in 0..24 {
        let degrees = [[1, 1], [2, 2], [3, 3], [3, 2], [1, 3], [5, 4]][case % 6];
        let counts = [degrees[0] + 1 + case % 4, degrees[1] + 1 + case % 3];
        let knots = [0, 1].map(|d: usize| {
            let inner = counts[d] - degrees[d] - 1;
            let mut k = vec![0.0; degrees[d]];
            k.extend((1..=inner).map(|i| i as f64));
            k.extend(vec![inner as f64 + 1.0; degrees[d]]);
            k
        });
        let wild = if case < 12 { 0.4 } else { 2.5 };
        let mut points = Vec::new();
        for i in 0..counts[0] {
            for j in 0..counts[1] {
                points.push(Point3::new(i as f64, j as f64, 0.0) + numbers.point(wild).to_vector());
            }
        }
        if case % 5 == 4 {
            // A pole: one side is a point.
            let pole = points[0];
            (0..counts[1]).for_each(|j| points[j] = pole);
        }
        let weights: Vec<f64> = points.iter().map(|_| 1.3 + numbers.next()).collect();
        let s = if case % 2 == 0 {
            NurbsSurface::new(degrees, counts, points, knots).unwrap()
        } else {
            NurbsSurface::with_weights(degrees, counts, &points, &weights, knots).unwrap()
        };
        let (du, dv) = (s.domain(Direction::U), s.domain(Direction::V));
        let steps = 60;
        let mut samples = Vec::new();
        for i in 0..=steps {
            for j in 0..=steps {
                let (u, v) = (du.at(i as f64 / steps as f64), dv.at(j as f64 / steps as f64));
                samples.push((u, v, s.point_at(u, v)));
            }
        }
        let index = ClosestOnSurface::of_nurbs(&s);
        for k in 0..60 {
            let q = match k % 4 {
                0 => numbers.point(4.0),
                1 => numbers.point(30.0),
                2 => samples[k * 71 % samples.len()].2 + numbers.point(1e-2).to_vector(),
                _ => samples[k * 71 % samples.len()].2,
            };
            let found = index.nearest(q).unwrap();
            let want = sampled(&s, &samples, steps, q);
            assert!(
                found.distance <= want + 1e-9 * (1.0 + want),
                "case {case}, {q:?}: {} but {want}",
                found.distance
            );
            assert!(du.contains(found.u) && dv.contains(found.v));
            assert!(s.point_at(found.u, found.v).distance_to(found.point) < 1e-12);
            if k % 9 == 0 {
                assert!(index.nearest_within(q, 0.99 * found.distance - 1e-9).unwrap().is_none());
                assert!(index.nearest_within(q, 1.01 * found.distance + 1e-9).unwrap().is_some());
            }
        }
    }
}

#[test]
fn oracle_cases() {
    let Some(cases) = oracle("occ_dev.json") else { return };
    for (i, case) in cases["closest_surface"].as_array().unwrap().iter().enumerate() {
        let s = surface(&case["in"]);
        let (q, want) = (point(&case["q"]), number(&case["dist"]));
        let found = s.closest_point(q).unwrap();
        assert!((found.distance - want).abs() <= 1e-9, "case {i}: {} but {want}", found.distance);
    }
    for (i, case) in cases["area"].as_array().unwrap().iter().enumerate() {
        let s = surface(&case["in"]);
        let (want, error) = (number(&case["area"]), number(&case["quad_err"]).max(1e-9));
        let found = s.area_within(1e-10).unwrap();
        assert!((found.area - want).abs() <= error * want, "case {i}: {} but {want}", found.area);
        let centroid = numbers(&case["centroid"]);
        let off = found.centroid.distance_to(Point3::new(centroid[0], centroid[1], centroid[2]));
        assert!(off <= 1e-8 * (1.0 + want.sqrt()), "case {i}: the centroid is {off} off");
    }
}

#[test]
fn spheres_and_tori() {
    let mut numbers = Numbers(99);
    let plane = Plane { origin: Point3::new(1.0, -2.0, 0.5), ..Plane::XY };
    let sphere: Surface = Sphere::new(plane, 2.0).unwrap().into();
    let torus: Surface = Torus::new(plane, 3.0, 1.0).unwrap().into();
    let (ball, ring) = (ClosestOnSurface::new(&sphere).unwrap(), ClosestOnSurface::new(&torus).unwrap());
    for k in 0..200 {
        let q = plane.origin + numbers.point(if k % 2 == 0 { 4.0 } else { 40.0 }).to_vector();
        let want = (q.distance_to(plane.origin) - 2.0).abs();
        let found = ball.nearest(q).unwrap();
        assert!((found.distance - want).abs() < 1e-11, "{q:?}: {} but {want}", found.distance);
        assert!(sphere.point_at(found.u, found.v).distance_to(found.point) < 1e-9);
        let [x, y, z] = plane.coordinates(q);
        let want = ((x.hypot(y) - 3.0).hypot(z) - 1.0).abs();
        let found = ring.nearest(q).unwrap();
        assert!((found.distance - want).abs() < 1e-11, "{q:?}: {} but {want}", found.distance);
        assert!(torus.point_at(found.u, found.v).distance_to(found.point) < 1e-9);
    }
    // Everywhere equally far, and nearly so; beside a pole.
    for offset in [0.0, 1e-14, 1e-10, 1e-6, 1e-3] {
        let found = ball.nearest(Point3::new(1.0 + offset, -2.0, 0.5)).unwrap();
        assert!((found.distance - (2.0 - offset)).abs() < 1e-11, "{offset}: {}", found.distance);
        let found = ball.nearest(Point3::new(1.0 + offset, -2.0, 4.5)).unwrap();
        assert!(
            (found.distance - (4.0f64.hypot(offset) - 2.0)).abs() < 1e-11,
            "{offset}: {}",
            found.distance
        );
    }
    let area = sphere.area().unwrap();
    assert!((area.area - 16.0 * PI).abs() < 1e-8, "{}", area.area);
    assert!(area.centroid.distance_to(plane.origin) < 1e-9);
    // ∫x² over a sphere: 4πr⁴/3.
    for k in 0..6 {
        let want = if k < 3 { 64.0 * PI / 3.0 } else { 0.0 };
        assert!((area.second_moments[k] - want).abs() < 1e-7, "{k}: {}", area.second_moments[k]);
    }
    assert!((torus.area().unwrap().area - 12.0 * PI * PI).abs() < 1e-8);
}

#[test]
fn bad_places_and_flat_surfaces() {
    let knots = || [vec![0.0, 1.0], vec![0.0, 1.0]];
    let square = |s: f64| {
        let p = |x: f64, y: f64| Point3::new(x * s, y * s, 0.0);
        NurbsSurface::new([1, 1], [2, 2], vec![p(0.0, 0.0), p(0.0, 1.0), p(1.0, 0.0), p(1.0, 1.0)], knots())
            .unwrap()
    };
    let s = square(1.0);
    assert!(s.closest_point(Point3::new(f64::NAN, 0.0, 0.0)).is_err());
    assert!(s.closest_point(Point3::new(1e200, 0.0, 0.0)).is_err());
    let corner = s.closest_point(Point3::new(2.0, 3.0, 2.0)).unwrap();
    assert_eq!((corner.u, corner.v, corner.distance), (1.0, 1.0, 3.0));
    let side = s.closest_point(Point3::new(0.25, -3.0, 4.0)).unwrap();
    assert!((side.u - 0.25).abs() < 1e-12 && side.v == 0.0 && (side.distance - 5.0).abs() < 1e-14);
    let area = s.area_within(1e-12).unwrap();
    assert!((area.area - 1.0).abs() < 1e-14 && (area.second_moments[0] - 1.0 / 12.0).abs() < 1e-14);
    assert!(square(0.0).area_within(1e-9).is_err());
    assert!((square(0.0).closest_point(Point3::new(3.0, 0.0, 4.0)).unwrap().distance - 5.0).abs() < 1e-14);
    for size in [1e-60, 1e60] {
        let area = square(size).area_within(1e-9).unwrap().area;
        assert!((area / size / size - 1.0).abs() < 1e-12);
    }
}

/// Points of a surface, and points beside it, are found again: with weights from 1e-2 to 1e2 and rows of control points
/// that fall together.
#[test]
fn points_of_wild_rational_surfaces_are_found_again() {
    let mut numbers = Numbers(0x0fed_cba9_8765_4321);
    for case in 0..60 {
        let degrees = [1 + case % 3, 1 + case / 3 % 3];
        let counts = degrees.map(|d| d + 2);
        let mut points: Vec<[f64; 4]> = (0..counts[0] * counts[1])
            .map(|k| {
                let w = 10_f64.powf(2.0 * numbers.next());
                let place = numbers.point(1.0);
                let x =
                    [(k / counts[1]) as f64 * 3.0 + place.x, (k % counts[1]) as f64 * 3.0 + place.y, place.z];
                [x[0] * w, x[1] * w, x[2] * w, w]
            })
            .collect();
        if case % 4 == 0 {
            let first = points[0];
            points[..counts[1]].fill(first);
        }
        let knots = [0, 1].map(|d| katydid_geometry::clamped_uniform_knots(degrees[d], counts[d]).unwrap());
        let s = NurbsSurface::rational(degrees, counts, points, knots).unwrap();
        let (du, dv) = (s.domain(Direction::U), s.domain(Direction::V));
        let ready = ClosestOnSurface::of_nurbs(&s);
        for k in 0..12 {
            let on = s.point_at(du.at(0.5 + 0.5 * numbers.next()), dv.at(0.5 + 0.5 * numbers.next()));
            let q = on + numbers.point([0.0, 1e-9, 1e-4, 0.5][k % 4]).to_vector();
            let excess = ready.nearest(q).unwrap().distance - q.distance_to(on);
            assert!(excess < 1e-6, "case {case}: {excess:e} too far from {q:?}");
        }
    }
}

/// Where rows of control points fall together at a side, partial derivatives are zero there: rounding must not pass for
/// a slope that makes the side the nearest.
#[test]
fn sides_with_a_speed_of_zero_are_not_taken_for_nearest() {
    let mut numbers = Numbers(77);
    for case in 0..40 {
        let (degrees, counts) = ([3, 2], [5, 4]);
        let rational = case % 2 == 1;
        let mut points: Vec<[f64; 4]> = Vec::new();
        for i in 0..counts[0] {
            for j in 0..counts[1] {
                let w = if rational { 1.0 + 0.6 * numbers.next() } else { 1.0 };
                let p = Point3::new(i as f64, j as f64, numbers.next());
                // The second row falls on the first, with weights of its own.
                let p = if i == 1 {
                    let [x, y, z, v] = points[j];
                    Point3::new(x / v, y / v, z / v)
                } else {
                    p
                };
                points.push([p.x * w, p.y * w, p.z * w, w]);
            }
        }
        let knots = [vec![0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0], vec![0.0, 0.0, 1.0, 2.0, 2.0]];
        let s = NurbsSurface::rational(degrees, counts, points, knots).unwrap();
        let ready = ClosestOnSurface::of_nurbs(&s);
        for _ in 0..6 {
            let foot = s.point_at(0.0, 1.0 + numbers.next());
            let q = foot + numbers.point(0.6).to_vector();
            let found = ready.nearest(q).unwrap().distance;
            let steps = 200;
            let grid = (0..=steps).flat_map(|i| (0..=steps).map(move |j| (i, j)));
            let at = |k: i32| 2.0 * f64::from(k) / f64::from(steps);
            let least =
                grid.map(|(i, j)| s.point_at(at(i), at(j)).distance_to(q)).fold(f64::INFINITY, f64::min);
            assert!(found <= least + 1e-12, "case {case}: {q:?}: {found} > {least}");
        }
    }
}
