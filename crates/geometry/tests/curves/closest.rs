//! The nearest point of a curve: against dense sampling, other programs, ties and limits.

use crate::common::{Numbers, curve, number, oracle, point};
use katydid_geometry::{
    Arc, Circle, ClosestOnCurve, Curve, Interval, KnotSpacing, Line, NurbsCurve, Plane, Point3, PolyCurve,
    PolylineCurve, Vector3,
};

fn p(x: f64, y: f64) -> Point3 {
    Point3::new(x, y, 0.0)
}

/// The least distance by 4,000 samples and golden sections around the best of them.
fn sampled(c: &Curve, samples: &[(f64, Point3)], q: Point3) -> f64 {
    let mut near: Vec<usize> = (0..samples.len()).collect();
    near.sort_by(|&a, &b| samples[a].1.distance_to(q).total_cmp(&samples[b].1.distance_to(q)));
    let mut least = f64::INFINITY;
    for &i in near.iter().take(6) {
        let (mut a, mut b) = (samples[i.saturating_sub(1)].0, samples[(i + 1).min(samples.len() - 1)].0);
        for _ in 0..50 {
            let (x, y) = (a + 0.382 * (b - a), a + 0.618 * (b - a));
            if c.point_at(x).distance_to(q) < c.point_at(y).distance_to(q) { b = y } else { a = x }
        }
        least = least.min(c.point_at(0.5 * (a + b)).distance_to(q)).min(samples[i].1.distance_to(q));
    }
    least
}

fn against_samples(c: &Curve, what: &str, queries: usize, numbers: &mut Numbers) {
    let index = ClosestOnCurve::new(c);
    let domain = c.domain();
    let samples: Vec<(f64, Point3)> =
        (0..=4000).map(|i| domain.at(f64::from(i) / 4000.0)).map(|t| (t, c.point_at(t))).collect();
    for k in 0..queries {
        let q = match k % 4 {
            0 => numbers.point(8.0),
            1 => numbers.point(80.0),
            2 => samples[k * 7 % 4001].1 + numbers.point(1e-3).to_vector(),
            _ => samples[k * 31 % 4001].1,
        };
        let found = index.nearest(q).unwrap();
        let want = sampled(c, &samples, q);
        assert!(found.distance <= want + 1e-9 * (1.0 + want), "{what}, {q:?}: {} but {want}", found.distance);
        assert!(domain.contains(found.parameter), "{what}: {} is outside", found.parameter);
        let back = c.point_at(found.parameter).distance_to(found.point);
        assert!(back < 1e-11, "{what}, {q:?}: {found:?} is {back} away");
        assert!((found.point.distance_to(q) - found.distance).abs() <= 1e-12 * (1.0 + want));
        let once = c.closest_point(q).unwrap();
        assert!(
            (once.distance - found.distance).abs() <= 1e-12 * (1.0 + want),
            "{what}, {q:?}: {once:?} {found:?}"
        );
        if k % 5 == 0 {
            let all = c.local_closest_points(q).unwrap();
            assert!(
                (all[0].distance - found.distance).abs() <= 1e-9 * (1.0 + want),
                "{what}, {q:?}: the nearest of the local ones is {}, not {}",
                all[0].distance,
                found.distance
            );
        }
        if k % 7 == 0 {
            assert_eq!(c.closest_point_within(q, found.distance * 0.99 - 1e-9).unwrap(), None);
            let within = index.nearest_within(q, found.distance * 1.01 + 1e-9).unwrap().unwrap();
            assert!((within.distance - found.distance).abs() <= 1e-12 * (1.0 + want));
        }
    }
}

#[test]
fn random_curves_and_places() {
    let mut numbers = Numbers(0x2545_f491_4f6c_dd1d);
    for case in 0..40 {
        let degree = [1, 2, 3, 3, 5, 7, 9][case % 7];
        let count = degree + 1 + case % 9;
        let points: Vec<Point3> = (0..count).map(|_| numbers.point(5.0)).collect();
        let mut t = 0.0;
        let mut knots = vec![0.0; degree];
        for i in 0..count - degree - 1 {
            t += if degree > 2 && i % 4 == 3 { 0.0 } else { 1.5 + numbers.next() };
            knots.push(t);
        }
        knots.extend(vec![t + 1.0; degree]);
        let weights: Vec<f64> = (0..count).map(|_| 1.2 + numbers.next()).collect();
        let c: Curve = if case % 2 == 0 {
            NurbsCurve::new(degree, points, knots).unwrap().into()
        } else {
            NurbsCurve::with_weights(degree, &points, &weights, knots).unwrap().into()
        };
        against_samples(&c, &format!("case {case}"), 250, &mut numbers);
    }
}

#[test]
fn other_kinds() {
    let mut numbers = Numbers(77);
    let ring: Vec<Point3> = (0..9)
        .map(|i| f64::from(i) * 0.7)
        .map(|a| Point3::new(4.0 * a.cos(), 3.0 * a.sin(), (2.0 * a).sin()))
        .collect();
    let periodic: Curve = NurbsCurve::interpolate_periodic(3, &ring, KnotSpacing::Chord).unwrap().into();
    let plane = Plane::from_normal(Point3::new(1.0, 2.0, 3.0), Vector3::new(1.0, 1.0, 0.3)).unwrap();
    let circle = Circle::new(plane, 3.0).unwrap();
    let arc = Arc::new(circle, Interval::new(-0.5, 4.0)).unwrap();
    let line: Curve = PolylineCurve::new((0..30).map(|_| numbers.point(4.0)).collect()).unwrap().into();
    let high: Vec<Point3> = (0..32).map(|_| numbers.point(4.0)).collect();
    let mut knots = vec![0.0; 31];
    knots.extend([1.0; 31]);
    let high: Curve = NurbsCurve::new(31, high, knots).unwrap().into();
    let mixed: Curve = {
        let bridge = |a: &Curve, b: &Curve| Curve::from(Line::new(a.end(), b.start()));
        let arc = Curve::from(arc);
        let (first, second) = (bridge(&line, &periodic), bridge(&periodic, &arc));
        PolyCurve::new(vec![line.clone(), first, periodic.clone(), second, arc]).unwrap().into()
    };
    let kinds = [
        ("periodic", periodic),
        ("circle", circle.into()),
        ("arc", arc.into()),
        ("line", line),
        ("mixed", mixed),
        ("degree 31", high),
    ];
    for (what, c) in kinds {
        against_samples(&c, what, 200, &mut numbers);
    }
}

#[test]
fn oracle_cases() {
    let Some(cases) = oracle("occ_dev.json") else { return };
    for (i, case) in cases["closest_curve"].as_array().unwrap().iter().enumerate() {
        let c: Curve = curve(&case["in"]).into();
        let (q, want) = (point(&case["q"]), number(&case["dist"]));
        for found in [c.closest_point(q).unwrap(), ClosestOnCurve::new(&c).nearest(q).unwrap()] {
            assert!(found.distance <= want + 1e-9, "case {i}: {} but {want}", found.distance);
            assert!(found.distance >= want - 1e-9, "case {i}: {} but {want}", found.distance);
        }
    }
}

#[test]
fn ties_and_centres() {
    // From the middle of a NURBS circle every point is equally near.
    let circle =
        Arc::new(Circle::new(Plane::XY, 3.0).unwrap(), Interval::new(0.0, std::f64::consts::TAU)).unwrap();
    let nurbs: Curve = circle.to_nurbs(Interval::new(0.0, 1.0)).unwrap().into();
    let index = ClosestOnCurve::new(&nurbs);
    for offset in [0.0, 1e-16, 1e-13, 1e-9, 1e-6, 1e-3] {
        let found = index.nearest(Point3::new(offset, 0.3 * offset, 0.0)).unwrap();
        let want = 3.0 - offset * 1.09f64.sqrt();
        assert!((found.distance - want).abs() < 1e-11, "{offset}: {}", found.distance);
    }
    assert!((nurbs.local_closest_points(Point3::ORIGIN).unwrap()[0].distance - 3.0).abs() < 1e-12);
    // A parabola from above: two feet, equally far; the vertex is a maximum between them.
    let c: Curve =
        NurbsCurve::new(2, vec![p(-2.0, 4.0), p(0.0, -4.0), p(2.0, 4.0)], vec![0.0, 0.0, 1.0, 1.0])
            .unwrap()
            .into();
    let all = c.local_closest_points(p(0.0, 2.0)).unwrap();
    assert_eq!(all.len(), 2);
    for found in &all {
        assert!((found.distance - 1.75f64.sqrt()).abs() < 1e-12);
        assert!((found.point.x.abs() - 1.5f64.sqrt()).abs() < 1e-9);
    }
    // Corners, an end, and both ends of an arc.
    let corner: Curve = PolylineCurve::new(vec![p(0.0, 0.0), p(2.0, 2.0), p(4.0, 0.0)]).unwrap().into();
    assert_eq!(corner.local_closest_points(p(2.0, 3.0)).unwrap().len(), 1);
    assert_eq!(corner.local_closest_points(p(2.0, -3.0)).unwrap().len(), 2);
    let half: Curve =
        Arc::new(Circle::new(Plane::XY, 1.0).unwrap(), Interval::new(0.0, std::f64::consts::PI))
            .unwrap()
            .into();
    let ends = half.local_closest_points(p(0.0, -2.0)).unwrap();
    assert_eq!(ends.len(), 2);
    assert!((ends[0].distance - ends[1].distance).abs() < 1e-12);
}

#[test]
fn bad_places() {
    let c: Curve =
        NurbsCurve::new(2, vec![p(-2.0, 4.0), p(0.0, -4.0), p(2.0, 4.0)], vec![0.0, 0.0, 1.0, 1.0])
            .unwrap()
            .into();
    for bad in [f64::NAN, f64::INFINITY, 1e200] {
        assert!(c.closest_point(p(bad, 0.0)).is_err());
        assert!(c.local_closest_points(p(bad, 0.0)).is_err());
    }
    assert!(c.closest_points(&[p(0.0, 0.0), p(f64::NAN, 0.0)]).is_err());
    let far = c.closest_point(p(0.0, 1e12)).unwrap();
    assert!((far.distance / 1e12 - 1.0).abs() < 1e-11);
    assert_eq!(c.closest_point_within(p(0.0, 1.0), f64::NAN).unwrap(), None);
    let point: Curve = NurbsCurve::new(2, vec![p(1.0, 1.0); 3], vec![0.0, 0.0, 1.0, 1.0]).unwrap().into();
    assert!((point.closest_point(p(1.0, 3.0)).unwrap().distance - 2.0).abs() < 1e-14);
    assert_eq!(point.local_closest_points(p(1.0, 3.0)).unwrap().len(), 1);
}

/// Points of a curve, and points beside it, are found again: with weights from 1e-3 to 1e3, double control points where
/// the curve stands still, and branches that pass each other closely.
#[test]
fn points_of_wild_rational_curves_are_found_again() {
    let mut numbers = Numbers(0x1234_5678_9abc_def1);
    for case in 0..600 {
        let degree = 1 + case % 5;
        let count = degree + 2 + case % 6;
        let mut points: Vec<[f64; 4]> = (0..count)
            .map(|_| {
                let w = 10_f64.powf(3.0 * numbers.next());
                let q = numbers.point(5.0);
                [q.x * w, q.y * w, if case % 2 == 0 { 0.0 } else { q.z * w }, w]
            })
            .collect();
        if case % 3 == 0 {
            points[1 + case % (count - 1)] = points[case % (count - 1)];
        }
        let knots = katydid_geometry::clamped_uniform_knots(degree, count).unwrap();
        let c: Curve = NurbsCurve::rational(degree, points, knots).unwrap().into();
        let ready = ClosestOnCurve::new(&c);
        for k in 0..24 {
            let on = c.point_at(c.domain().at(0.5 + 0.5 * numbers.next()));
            let q = on + numbers.point([0.0, 1e-9, 1e-4, 0.5][k % 4]).to_vector();
            for found in [c.closest_point(q).unwrap(), ready.nearest(q).unwrap()] {
                let excess = found.distance - q.distance_to(on);
                assert!(excess < 1e-7, "case {case}: {excess:e} too far from {q:?}");
            }
        }
    }
}

/// A search beside a nearly tangent branch once spent its whole budget there.
#[test]
fn rounding_around_one_minimum_does_not_hide_another() {
    let points = vec![
        [0.0, 0.0, 0.0, 0.3],
        [-9.169148056589966, 0.9195904949156215, 0.0, 2.949062540680234],
        [6.733352730091489, -2.798482790214165, 0.0, 1.7267051215679472],
        [-4.642803746957714, 10.559728577009887, 0.0, 2.7727421050770173],
        [0.4487256186527543, 5.385290024703999, 0.0, 2.542758947360471],
        [0.5106639945273126, -1.5918657182885574, 0.0, 0.4387074261440936],
        [0.0, 0.0, 0.0, 0.3],
        [0.0, 0.0, 0.0, 0.3],
    ];
    let knots = vec![0.0, 0.0, 0.0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.0, 1.0];
    let c: Curve = NurbsCurve::rational(3, points, knots).unwrap().into();
    for i in 0..=4000 {
        let t = f64::from(i) / 4000.0;
        assert!(c.closest_point(c.point_at(t)).unwrap().distance < 1e-7, "at {t}");
    }
}

/// A symmetric curve has a minimum just where its range is halved first.
#[test]
fn minima_where_a_range_is_halved() {
    let xs = [-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0];
    let ys = [0.0, 9.0, -20.0, 30.0, -20.0, 9.0, 0.0];
    let points = xs.iter().zip(ys).map(|(&x, y)| Point3::new(x, y, 0.0)).collect();
    let c: Curve =
        NurbsCurve::new(6, points, katydid_geometry::clamped_uniform_knots(6, 7).unwrap()).unwrap().into();
    let q = Point3::new(0.0, 40.0, 0.0);
    let found = c.local_closest_points(q).unwrap();
    let domain = c.domain();
    let steps = 2_000;
    let far: Vec<f64> =
        (0..=steps).map(|k| c.point_at(domain.at(f64::from(k) / f64::from(steps))).distance_to(q)).collect();
    let inner = far.windows(3).filter(|w| w[1] <= w[0] && w[1] < w[2]).count();
    let ends = usize::from(far[0] < far[1]) + usize::from(far[far.len() - 1] < far[far.len() - 2]);
    assert_eq!(found.len(), inner + ends, "{found:?}");
    assert!(found.iter().any(|p| (p.parameter - domain.middle()).abs() < 1e-9), "{found:?}");
}

/// Where control points fall together at an end the curve starts or stops with a speed of zero: its slope there is
/// nothing but rounding, and must not pass for that of a nearest end.
#[test]
fn ends_with_a_speed_of_zero_are_not_taken_for_nearest() {
    let knots = |n: usize, degree: usize| -> Vec<f64> {
        let spans = n - degree;
        (0..n + degree - 1).map(|k| (k as f64 + 1.0 - degree as f64).clamp(0.0, spans as f64)).collect()
    };
    let mut seed = 5_u64;
    let mut random = move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as f64 / f64::from(1_u32 << 31)
    };
    for case in 0..200 {
        let degree = 2 + case % 4;
        let n = degree + 1 + case % 5;
        let mut points: Vec<[f64; 4]> = (0..n)
            .map(|_| {
                let w = if case % 2 == 0 { 1.0 } else { 0.3 + 2.0 * random() };
                [4.0 * random() * w, 4.0 * random() * w, random() * w, w]
            })
            .collect();
        // The second point falls on the first, with a weight of its own.
        let (w0, w1) = (points[0][3], points[1][3]);
        points[1] = points[0].map(|x| x / w0 * w1);
        points[1][3] = w1;
        let curve = Curve::from(NurbsCurve::rational(degree, points, knots(n, degree)).unwrap());
        let domain = curve.domain();
        let prepared = ClosestOnCurve::new(&curve);
        for _ in 0..10 {
            let start = curve.start();
            let q = start + Vector3::new(random() - 0.5, random() - 0.5, random() - 0.5);
            let found = prepared.nearest(q).unwrap();
            let best = (0..=4000)
                .map(|i| {
                    curve.point_at(domain.start + domain.length() * f64::from(i) / 4000.0).distance_to(q)
                })
                .fold(f64::INFINITY, f64::min);
            assert!(found.distance <= best + 1e-12, "case {case}: {q:?}: {} > {best}", found.distance);
        }
    }
}

/// A corner to which one side falls, and from which the other starts at a right angle, is nearest among its neighbours.
#[test]
fn corners_at_the_foot_of_a_perpendicular() {
    let bent: Curve = PolylineCurve::new(vec![p(-3.0, 2.0), p(-1.0, 3.0), p(-1.0, 0.0)]).unwrap().into();
    for c in [&bent, &bent.reversed()] {
        let found = c.local_closest_points(p(1.0, 3.0)).unwrap();
        assert_eq!(found.len(), 1, "{found:?}");
        assert!((found[0].distance - 2.0).abs() < 1e-12 && found[0].point.distance_to(p(-1.0, 3.0)) < 1e-12);
    }
    // An arc that starts nearest, and one that starts farthest.
    let half = Interval::new(0.0, std::f64::consts::PI);
    let arc: Curve = Arc::new(Circle::new(Plane::XY, 1.0).unwrap(), half).unwrap().into();
    let hook = PolyCurve::new(vec![Line::new(p(2.0, -1.0), p(1.0, 0.0)).into(), arc]).unwrap();
    for c in [Curve::from(hook.clone()), Curve::from(hook).reversed()] {
        let near = c.local_closest_points(p(0.3, 0.0)).unwrap();
        assert!(near.iter().any(|f| f.point.distance_to(p(1.0, 0.0)) < 1e-12), "{near:?}");
        let far = c.local_closest_points(p(-3.0, 0.0)).unwrap();
        assert_eq!(far.len(), 1, "{far:?}");
        assert!((far[0].distance - 2.0).abs() < 1e-12);
    }
}
