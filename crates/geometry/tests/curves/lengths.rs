//! Arc length: truth from another program, closed forms, cusps, and the way back from lengths to parameters.

use crate::common::{curve, number, oracle};
use katydid_geometry::{
    Arc, ArcLength, Circle, Curve, Interval, KnotSpacing, NurbsCurve, Plane, Point3, PolyCurve, PolylineCurve,
};

fn p(x: f64, y: f64) -> Point3 {
    Point3::new(x, y, 0.0)
}

/// `length_at` and `parameter_at` undo each other.
fn there_and_back(c: &Curve, what: &str) {
    let measure = ArcLength::new(c);
    let total = measure.total();
    let mut before = f64::NEG_INFINITY;
    for i in 0..=200 {
        let length = total * f64::from(i) / 200.0;
        let t = measure.parameter_at(length);
        assert!(t >= before, "{what}: parameters go back at {length}");
        before = t;
        let back = measure.length_at(t);
        // Where the speed vanishes, a step of the parameter's last bit is still a small length.
        assert!((back - length).abs() <= 2e-13 * total, "{what}: {length} came back as {back}");
    }
}

#[test]
fn oracle_lengths() {
    let Some(cases) = oracle("occ_dev.json") else { return };
    for (i, case) in cases["length"].as_array().unwrap().iter().enumerate() {
        let c: Curve = curve(&case["in"]).into();
        let want = number(&case["length"]);
        assert!((c.length() - want).abs() <= 1e-12 * want, "case {i}: {} against {want}", c.length());
        assert!((c.length_within(1e-9) - want).abs() <= 1e-9 * want, "case {i}");
        let measure = ArcLength::new(&c);
        assert!((measure.total() - want).abs() <= 1e-12 * want, "case {i}: {}", measure.total());
        let half = measure.parameter_at(0.5 * want);
        assert!((measure.length_at(half) - 0.5 * want).abs() <= 1e-12 * want, "case {i}");
        let first = c.length_between(Interval::new(c.domain().start, half));
        assert!((first - 0.5 * want).abs() <= 1e-12 * want, "case {i}");
        there_and_back(&c, &format!("case {i}"));
    }
}

#[test]
fn parabola_and_cusps() {
    // y = x² from −1 to 1: √5 + asinh(2)/2.
    let parabola: Curve =
        NurbsCurve::new(2, vec![p(-1.0, 1.0), p(0.0, -1.0), p(1.0, 1.0)], vec![0.0, 0.0, 1.0, 1.0])
            .unwrap()
            .into();
    let want = 5f64.sqrt() + 0.5 * 2f64.asinh();
    assert!((parabola.length() - want).abs() < 1e-14 * want);
    // The semicubical parabola (t², t³) for t in −1…1 has a cusp at 0: 2 (13√13 − 8) / 27.
    let controls = vec![p(1.0, -1.0), p(-1.0 / 3.0, 1.0), p(-1.0 / 3.0, -1.0), p(1.0, 1.0)];
    let cusp = NurbsCurve::new(3, controls, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0]).unwrap();
    let want = 2.0 * (13.0 * 13f64.sqrt() - 8.0) / 27.0;
    let c: Curve = cusp.clone().into();
    assert!((c.length() - want).abs() < 1e-12 * want, "{} {want}", c.length());
    there_and_back(&c, "cusp");
    // The same with the cusp at no simple place, and opened a little.
    for (shift, gap) in [(0.137, 0.0), (0.0, 1e-4), (0.0, 1e-9), (0.213, 1e-7)] {
        let mut points = cusp.control_points();
        points[1].x += gap;
        let whole = NurbsCurve::new(3, points, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0]).unwrap();
        let part: Curve = whole.trimmed(Interval::new(shift, 1.0)).unwrap().into();
        there_and_back(&part, "near a cusp");
        let inner = 0.5 * (shift + 1.0);
        let two =
            part.length_between(Interval::new(shift, inner)) + part.length_between(Interval::new(inner, 1.0));
        assert!((two - part.length()).abs() < 1e-12 * two);
    }
    // There and back on a straight line: the speed is a parabola that turns at two points.
    let folded: Curve = NurbsCurve::new(
        3,
        vec![p(0.0, 0.0), p(3.0, 0.0), p(-2.0, 0.0), p(1.0, 0.0)],
        vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
    )
    .unwrap()
    .into();
    // x = 9t − 24t² + 16t³ turns at 1/4 (value 1) and 3/4 (value 0): 1 + 1 + 1.
    assert!((folded.length() - 3.0).abs() < 1e-12, "{}", folded.length());
    there_and_back(&folded, "folded line");
}

#[test]
fn circles_of_every_make() {
    let circle = Circle::new(Plane::XY, 3.0).unwrap();
    let want = 6.0 * std::f64::consts::PI;
    let plain: Curve = circle.into();
    let nurbs: Curve = Arc::new(circle, Interval::new(0.0, std::f64::consts::TAU))
        .unwrap()
        .to_nurbs(Interval::new(-2.0, 5.0))
        .unwrap()
        .into();
    for (c, what) in [(plain, "circle"), (nurbs.clone(), "rational circle")] {
        assert!((c.length() - want).abs() < 1e-14 * want, "{what} {}", c.length());
        there_and_back(&c, what);
    }
    // Far from the origin and tiny.
    let Curve::Nurbs(n) = nurbs else { panic!("a NURBS") };
    let far: Vec<[f64; 4]> =
        n.homogeneous_points().iter().map(|p| [p[0] * 1e-3 + 1e6 * p[3], p[1] * 1e-3, p[2], p[3]]).collect();
    let far: Curve = NurbsCurve::rational(2, far, n.knots().to_vec()).unwrap().into();
    assert!((far.length() - 1e-3 * want).abs() < 1e-9, "{}", far.length() - 1e-3 * want);
}

#[test]
fn mixed_periodic_high_and_flat() {
    let ring: Vec<Point3> = (0..9)
        .map(|i| f64::from(i) * 0.7)
        .map(|a| Point3::new(4.0 * a.cos(), 3.0 * a.sin(), (2.0 * a).sin()))
        .collect();
    let periodic: Curve = NurbsCurve::interpolate_periodic(3, &ring, KnotSpacing::Chord).unwrap().into();
    there_and_back(&periodic, "periodic");
    let high: Vec<Point3> =
        (0..32).map(f64::from).map(|a| Point3::new(a.sin() * 5.0, (1.7 * a).cos() * 5.0, a)).collect();
    let mut knots = vec![0.0; 31];
    knots.extend([1.0; 31]);
    there_and_back(&NurbsCurve::new(31, high, knots).unwrap().into(), "degree 31");
    let line = PolylineCurve::new(vec![p(0.0, 0.0), p(1.0, 0.0), p(1.0, 2.0)]).unwrap();
    there_and_back(&PolyCurve::new(vec![line.into(), periodic.clone()]).unwrap().into(), "mixed");
    // A span without extent between two that have some.
    let points = vec![p(0.0, 0.0), p(1.0, 0.0), p(1.0, 0.0), p(1.0, 0.0), p(1.0, 1.0)];
    let flat: Curve = NurbsCurve::new(2, points, vec![0.0, 0.0, 1.0, 2.0, 3.0, 3.0]).unwrap().into();
    assert!((flat.length() - 2.0).abs() < 1e-14);
    let none = NurbsCurve::new(2, vec![p(1.0, 1.0); 3], vec![0.0, 0.0, 1.0, 1.0]).unwrap();
    let none: Curve = none.into();
    assert_eq!(none.length(), 0.0);
    assert_eq!(ArcLength::new(&none).parameter_at(0.0), 0.0);
    // Sizes far from 1.
    for size in [1e-150, 1e150] {
        let c: Curve =
            NurbsCurve::new(2, vec![p(-size, size), p(0.0, -size), p(size, size)], vec![0.0, 0.0, 1.0, 1.0])
                .unwrap()
                .into();
        let want = (5f64.sqrt() + 0.5 * 2f64.asinh()) * size;
        assert!((c.length() - want).abs() < 1e-13 * want, "{}", c.length());
    }
}
