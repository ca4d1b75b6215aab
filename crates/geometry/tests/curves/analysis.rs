//! Turning points, inflections, extrema of curvature, and continuity on both scales.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::common::{close, close_points, close_vectors};
use katydid_geometry::{
    Arc, Circle, Continuity, ContinuityTolerance, Curve, Ellipse, Interval, Line, NurbsCurve, Plane, Point3,
    PolyCurve, Vector3,
};
use proptest::prelude::*;

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn bezier(points: &[(f64, f64)]) -> Curve {
    NurbsCurve::bezier(&points.iter().map(|&(x, y)| p(x, y, 0.0)).collect::<Vec<_>>()).unwrap().into()
}

#[test]
fn curvature_extrema_of_an_ellipse_and_a_parabola() {
    let ellipse: Curve = Ellipse::new(Plane::XY, 3.0, 1.0).unwrap().to_nurbs().unwrap().into();
    // The vertices are joints of the exact form: cut elsewhere to have them inside.
    let turned = ellipse.with_seam(0.4).unwrap().to_nurbs().unwrap();
    assert!(turned.point_count() > 9);
    let quarter: Curve = NurbsCurve::rational(
        2,
        vec![
            [3.0 * 0.6_f64.cos(), -0.6_f64.sin(), 0.0, 1.0],
            [3.0, 0.0, 0.0, 0.6_f64.cos()],
            [3.0 * 0.6_f64.cos(), 0.6_f64.sin(), 0.0, 1.0],
        ],
        vec![0.0, 0.0, 1.0, 1.0],
    )
    .unwrap()
    .into();
    let found = quarter.curvature_extrema();
    assert_eq!(found.len(), 1);
    assert!(found[0].is_maximum);
    close(found[0].parameter, 0.5, 1e-9, "vertex");
    close(found[0].curvature, 3.0, 1e-9, "a/b²");
    let parabola = bezier(&[(-1.0, 1.0), (0.0, -1.0), (1.0, 1.0)]);
    let found = parabola.curvature_extrema();
    assert_eq!(found.len(), 1);
    close(found[0].parameter, 0.5, 1e-10, "vertex");
    close(found[0].curvature, 2.0, 1e-10, "y = x²");
    let circle: Curve = Circle::new(Plane::XY, 2.0).unwrap().into();
    assert!(circle.curvature_extrema().is_empty());
    let as_nurbs: Curve = circle.to_nurbs().unwrap().into();
    assert!(as_nurbs.curvature_extrema().is_empty());
    assert!(bezier(&[(0.0, 0.0), (1.0, 0.0), (3.0, 0.0), (7.0, 0.0)]).curvature_extrema().is_empty());
}

#[test]
fn inflections_of_known_curves() {
    let s = bezier(&[(0.0, 0.0), (1.0, 2.0), (2.0, -2.0), (3.0, 0.0)]);
    let found = s.inflections(1e-9);
    assert_eq!(found.len(), 1);
    close(found[0], 0.5, 1e-12, "symmetric");
    assert!(bezier(&[(0.0, 0.0), (1.0, 2.0), (2.0, 2.0), (3.0, 0.0)]).inflections(1e-9).is_empty());
    // y = x⁴ touches zero curvature without changing side.
    let quartic = bezier(&[(-1.0, 1.0), (-0.5, -1.0), (0.0, 1.0), (0.5, -1.0), (1.0, 1.0)]);
    assert!(quartic.inflections(1e-9).is_empty());
    // Two arcs bending to opposite sides meet.
    let a = Arc::from_start_direction_end(p(0., 0., 0.), Vector3::X, p(1., 1., 0.)).unwrap();
    let b = Arc::from_start_direction_end(p(1., 1., 0.), Vector3::Y, p(2., 2., 0.)).unwrap();
    let joined: Curve = PolyCurve::new(vec![a.into(), b.into()]).unwrap().into();
    assert_eq!(joined.inflections(1e-9), vec![FRAC_PI_2]);
    let line: Curve = Line::new(p(0., 0., 0.), p(1., 0., 0.)).into();
    assert!(line.inflections(1e-9).is_empty());
    // A wave of seven knots: the signs of the curvature agree with the parameters found.
    let points: Vec<Point3> = (0..12).map(|i| p(f64::from(i), f64::from(i * 7 % 5), 0.0)).collect();
    let wave: Curve = NurbsCurve::clamped_uniform(3, &points).unwrap().into();
    let found = wave.inflections(1e-9);
    let domain = wave.domain();
    let sign = |t: f64| wave.signed_curvature_at(t, Vector3::Z) > 0.0;
    let steps = 20_000;
    let changes = (1..steps)
        .filter(|&i| {
            let (a, b) =
                (domain.at(f64::from(i - 1) / f64::from(steps)), domain.at(f64::from(i) / f64::from(steps)));
            sign(a) != sign(b)
        })
        .count();
    assert_eq!(found.len(), changes);
}

#[test]
fn turning_points_are_all_of_them() {
    let circle: Curve = Circle::new(Plane::XY, 2.0).unwrap().into();
    let found = circle.turning_points(Vector3::new(1.0, 1.0, 0.0)).unwrap();
    assert_eq!(found.len(), 2);
    for t in found {
        close(circle.point_at(t).x.abs(), 2.0_f64.sqrt(), 1e-12, "diagonal");
    }
    let s = bezier(&[(0.0, 0.0), (1.0, 2.0), (2.0, -2.0), (3.0, 0.0)]);
    let ys = s.turning_points(Vector3::Y).unwrap();
    assert_eq!(ys.len(), 2);
    for t in ys {
        assert!(s.tangent_at(t).unwrap().y.abs() < 1e-10);
    }
    assert!(s.turning_points(Vector3::ZERO).is_err());
    let zigzag: Curve =
        katydid_geometry::PolylineCurve::new(vec![p(0., 0., 0.), p(1., 1., 0.), p(2., 0., 0.)])
            .unwrap()
            .into();
    assert_eq!(zigzag.turning_points(Vector3::Y).unwrap(), vec![1.0]);
}

#[test]
fn osculating_circles_on_both_sides_and_arc_length_derivatives() {
    let a = Arc::from_start_direction_end(p(0., 0., 0.), Vector3::X, p(1., 1., 0.)).unwrap();
    let b: Curve = Line::new(p(1., 1., 0.), p(1., 3., 0.)).into();
    let joined: Curve = PolyCurve::new(vec![a.into(), b]).unwrap().into();
    let t = FRAC_PI_2;
    close(joined.osculating_circle_on_side(t, true).unwrap().radius, 1.0, 1e-12, "arriving");
    assert!(joined.osculating_circle_on_side(t, false).is_none());
    let circle: Curve = Circle::new(Plane::XY, 2.0).unwrap().to_nurbs().unwrap().into();
    for t in [0.1, 1.0, 4.0] {
        let [d1, d2, d3] = circle.arc_length_derivatives(t, false).unwrap();
        close(d1.length(), 1.0, 1e-13, "unit");
        close(d2.length(), 0.5, 1e-12, "1/r");
        close_vectors(d3, d1 * -0.25, 1e-10, "−T/r²");
    }
}

#[test]
fn joins_on_both_scales() {
    let tolerance = ContinuityTolerance::default();
    let c = bezier(&[(0.0, 0.0), (1.0, 2.0), (2.0, -1.0), (4.0, 1.0), (5.0, 0.0)]);
    let (a, b) = (c.trimmed(Interval::new(0.0, 0.4)).unwrap(), c.trimmed(Interval::new(0.4, 1.0)).unwrap());
    let whole = a.join_continuity(&b, &tolerance);
    assert_eq!((whole.parametric, whole.geometric), (Some(3), Some(3)));
    // Another speed breaks the parametric scale only.
    let faster = b.with_domain(Interval::new(0.4, 0.6)).unwrap();
    let report = a.join_continuity(&faster, &tolerance);
    assert_eq!((report.parametric, report.geometric), (Some(0), Some(3)));
    assert!(report.derivative_differences[0] > 0.1 && report.curvature_difference < 1e-10);
    // A line and a tangent arc: G1; the curvature differs by 1/r.
    let line: Curve = Line::new(p(-1., 0., 0.), p(0., 0., 0.)).into();
    let arc: Curve = Arc::from_start_direction_end(p(0., 0., 0.), Vector3::X, p(2., 2., 0.)).unwrap().into();
    let report = line.join_continuity(&arc, &tolerance);
    assert_eq!(report.geometric, Some(1));
    close(report.curvature_difference, 0.5, 1e-12, "1/r");
    // A corner and a gap, with their numbers.
    let up: Curve = Line::new(p(0., 0., 0.), p(0., 1., 0.)).into();
    let report = line.join_continuity(&up, &tolerance);
    assert_eq!((report.parametric, report.geometric), (Some(0), Some(0)));
    close(report.angle.unwrap(), FRAC_PI_2, 1e-14, "corner");
    let away: Curve = Line::new(p(0., 0.25, 0.), p(1., 1., 0.)).into();
    let report = line.join_continuity(&away, &tolerance);
    assert_eq!((report.parametric, report.geometric, report.distance), (None, None, 0.25));
    // Curvature equal but changing at another rate: G2, not G3.
    let spiral = bezier(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (3.0, 1.0)]);
    let report = line.join_continuity(&spiral, &tolerance);
    assert_eq!(report.geometric, Some(2));
}

#[test]
fn discontinuities_one_after_another() {
    let tolerance = ContinuityTolerance::default();
    let knots = vec![0., 0., 0., 1., 2., 2., 3., 3., 3., 4., 4., 4.];
    let points: Vec<Point3> = (0..10).map(|i| p(f64::from(i), f64::from(i * i % 7), 0.0)).collect();
    let c: Curve = NurbsCurve::new(3, points, knots).unwrap().into();
    let next = |kind, from| c.next_discontinuity(kind, from, 4.0, &tolerance);
    assert_eq!(next(Continuity::C0, 0.0), None);
    assert_eq!(next(Continuity::C1, 0.0), Some(3.0));
    assert_eq!(next(Continuity::C2, 0.0), Some(2.0));
    assert_eq!(next(Continuity::C2, 2.0), Some(3.0));
    assert_eq!(next(Continuity::Cn(3), 0.0), Some(1.0));
    assert_eq!(next(Continuity::CInfinity, 0.0), Some(1.0));
    assert_eq!(next(Continuity::G1, 0.0), Some(3.0));
    assert_eq!(next(Continuity::G1, 3.0), None);
    assert_eq!(c.next_discontinuity(Continuity::C2, 4.0, 0.0, &tolerance), Some(3.0));
    assert_eq!(c.next_discontinuity(Continuity::C2, 3.0, 0.0, &tolerance), Some(2.0));
    assert_eq!(c.next_discontinuity(Continuity::C2, 2.0, 0.0, &tolerance), None);
    let circle: Curve = Circle::new(Plane::XY, 1.0).unwrap().into();
    assert_eq!(circle.next_discontinuity(Continuity::CInfinity, 0.0, 2.0 * PI, &tolerance), None);
    let square: Curve = katydid_geometry::PolylineCurve::new(
        [(0., 0.), (1., 0.), (1., 1.), (0., 1.), (0., 0.)].map(|(x, y)| p(x, y, 0.)).to_vec(),
    )
    .unwrap()
    .into();
    assert_eq!(square.next_discontinuity(Continuity::G1, 3.0, 4.0, &tolerance), Some(4.0));
    assert_eq!(
        c.discontinuities(Continuity::Cn(3), &katydid_geometry::Tolerance::default()),
        vec![1.0, 2.0, 3.0]
    );
    close_points(c.point_at(3.0), c.to_nurbs().unwrap().control_point(6).unwrap(), 1e-12, "full knot");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn curvature_has_no_extremum_that_is_missed(xs in proptest::collection::vec((-5.0..5.0_f64, -5.0..5.0_f64, -5.0..5.0_f64, 0.2..4.0_f64), 3..6), planar in any::<bool>()) {
        let points: Vec<Point3> = xs.iter().map(|x| p(x.0, x.1, if planar { 0.0 } else { x.2 })).collect();
        let weights: Vec<f64> = xs.iter().map(|x| x.3).collect();
        let degree = points.len() - 1;
        let knots = katydid_geometry::clamped_uniform_knots(degree, points.len()).unwrap();
        let c: Curve = NurbsCurve::with_weights(degree, &points, &weights, knots).unwrap().into();
        let found = c.curvature_extrema();
        let n = 4000_i32;
        let k: Vec<f64> = (0..=n).map(|i| c.curvature_at(f64::from(i) / f64::from(n)).length()).collect();
        for i in 2..n as usize - 1 {
            // A clear local extremum among samples must be near a found one.
            let (a, b, d) = (k[i - 2], k[i], k[i + 2]);
            let clear = 1e-6 * b;
            if (b > a + clear && b > d + clear) || (b < a - clear && b < d - clear) {
                let t = i as f64 / f64::from(n);
                prop_assert!(found.iter().any(|e| (e.parameter - t).abs() < 3.0 / f64::from(n)), "{t} {found:?}");
            }
        }
    }
}
