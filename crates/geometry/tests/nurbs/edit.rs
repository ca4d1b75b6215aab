//! Knots out and in, degree down, other weights and parameters, least squares and fits.

use crate::common::{self, close, close_points};
use katydid_geometry::{
    Circle, ExactCondition, Interval, KnotSpacing, LeastSquares, NurbsCurve, Plane, Point3, Vector3,
};
use proptest::prelude::*;

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn wave() -> NurbsCurve {
    let points: Vec<Point3> = (0..9)
        .map(|i| p(f64::from(i), if i % 2 == 0 { 0.0 } else { 2.0 }, 0.3 * f64::from(i * i % 5)))
        .collect();
    NurbsCurve::clamped_uniform(3, &points).unwrap()
}

/// A weighted curve far from the origin, weights from 1e-3 to 1e3.
fn extreme() -> NurbsCurve {
    let points: Vec<Point3> =
        (0..7).map(|i| p(100.0 + f64::from(i), f64::from(i * i % 4), f64::from(i % 3))).collect();
    let weights = [1.0, 1e3, 0.5, 1e-3, 2.0, 30.0, 1.0];
    NurbsCurve::with_weights(3, &points, &weights, wave().knots()[..9].iter().map(|k| k.min(4.0)).collect())
        .unwrap()
}

fn largest_difference(a: &NurbsCurve, b: &NurbsCurve) -> f64 {
    let d = a.domain();
    (0..=1000)
        .map(|i| {
            let t = d.at(f64::from(i) / 1000.0);
            a.point_at(t).distance_to(b.point_at(b.domain().at(f64::from(i) / 1000.0)))
        })
        .fold(0.0, f64::max)
}

#[test]
fn deviation_is_a_tight_bound() {
    let a = wave();
    let mut moved = a.control_points();
    moved[4].z += 0.1;
    let b = NurbsCurve::new(3, moved, a.knots().to_vec()).unwrap();
    let (bound, seen) = (a.deviation_from(&b).unwrap(), largest_difference(&a, &b));
    assert!(seen <= bound && bound <= 1.011 * seen, "{seen} {bound}");
    let circle = Circle::new(Plane::XY, 2.0).unwrap().to_nurbs().unwrap();
    let other = circle.with_weight(1, 0.5).unwrap();
    let (bound, seen) = (circle.deviation_from(&other).unwrap(), largest_difference(&circle, &other));
    assert!(seen <= bound && bound <= 1.011 * seen, "{seen} {bound}");
    assert_eq!(a.deviation_from(&a).unwrap(), 0.0);
    assert!(extreme().deviation_from(&extreme().raised_to(5).unwrap()).unwrap() < 1e-10);
}

#[test]
fn inserted_knots_come_out_again() {
    for c in [wave(), extreme(), Circle::new(Plane::XY, 3.0).unwrap().to_nurbs().unwrap()] {
        let d = c.domain();
        let fine = c.refined(&[d.at(0.11), d.at(0.37), d.at(0.37), d.at(0.83)]).unwrap();
        assert_eq!(fine.point_count(), c.point_count() + 4);
        close(largest_difference(&c, &fine), 0.0, 1e-10, "refinement keeps the shape");
        // Bounds are safe, so unequal weights ask for more tolerance than rounding does.
        let tolerance = if c.weights().contains(&1e3) { 1e-5 } else { 1e-9 };
        let coarse = fine.remove_knots(tolerance).unwrap();
        assert!(coarse.deviation <= 1e-9, "{}", coarse.deviation);
        assert!(
            coarse.curve.point_count() <= c.point_count(),
            "{} {}",
            coarse.curve.point_count(),
            c.point_count()
        );
        let (once, times) = fine.remove_knot(d.at(0.37), 5, 2.0 * tolerance).unwrap();
        assert_eq!(times, 2);
        assert_eq!(once.multiplicity(d.at(0.37)), 0);
    }
    assert!(wave().remove_knot(0.5, 1, 1.0).is_err());
    assert!(wave().refined(&[2.0, 2.0, 2.0]).is_err());
    assert!(wave().refined(&[99.0]).is_err());
}

#[test]
fn data_reduction_stays_within_its_tolerance() {
    let dense: Vec<Point3> =
        (0..400).map(|i| f64::from(i) / 40.0).map(|x| p(x, x.sin(), 0.2 * (2.0 * x).cos())).collect();
    let c = NurbsCurve::interpolate(3, &dense, KnotSpacing::Chord, None, None).unwrap();
    let mut before = c.point_count();
    for tolerance in [1e-6, 1e-4, 1e-2] {
        let r = c.remove_knots(tolerance).unwrap();
        assert!(r.deviation <= tolerance, "{}", r.deviation);
        assert!(largest_difference(&c, &r.curve) <= r.deviation);
        assert!(r.curve.point_count() < before);
        before = r.curve.point_count();
        assert_eq!((r.curve.control_point(0), c.control_point(0)), (c.control_point(0), c.control_point(0)));
    }
    assert!(before < 60, "{before}");
}

#[test]
fn degree_goes_up_and_down() {
    for c in [wave(), extreme(), Circle::new(Plane::XY, 3.0).unwrap().to_nurbs().unwrap()] {
        let up = c.raised_to(c.degree() + 1).unwrap();
        let down = up.reduce_degree(1e-7).unwrap();
        assert_eq!(down.curve.degree(), c.degree());
        assert_eq!(down.curve.point_count(), c.point_count());
        assert!(down.deviation < 1e-8, "{}", down.deviation);
    }
    let quintic =
        NurbsCurve::bezier(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(|x: f64| p(x, (3.0 * x).sin(), x * x)))
            .unwrap();
    let all = quintic.reduce_degree(f64::INFINITY).unwrap();
    assert!(largest_difference(&quintic, &all.curve) <= all.deviation);
    assert!(quintic.reduce_degree(0.5 * all.deviation).is_err());
    assert!(
        NurbsCurve::clamped_uniform(1, &[p(0., 0., 0.), p(1., 0., 0.)]).unwrap().reduce_degree(1.0).is_err()
    );
}

#[test]
fn end_weights_and_linear_fractional_parameters_keep_the_shape() {
    for c in [wave(), extreme()] {
        for (a, b) in [(1.0, 1.0), (0.2, 7.0), (300.0, 0.01)] {
            let other = c.with_end_weights(a, b).unwrap();
            close(other.weights()[0], a, 1e-12, "first");
            close(*other.weights().last().unwrap(), b, 1e-12, "last");
            assert_eq!(other.domain(), c.domain());
            for (x, y) in c.control_points().iter().zip(other.control_points()) {
                close_points(*x, y, 1e-12, "control points stay");
            }
        }
        let r = c.reparametrized(3.0).unwrap();
        let d = c.domain();
        for i in 0..=20 {
            let x = f64::from(i) / 20.0;
            close_points(
                c.point_at(d.at(x)),
                r.point_at(d.at(3.0 * x / (2.0 * x + 1.0))),
                1e-11,
                "same points",
            );
        }
    }
    assert!(wave().reparametrized(0.0).is_err());
    assert!(wave().with_end_weights(1.0, f64::NAN).is_err());
}

#[test]
fn bezier_spans_natural_ends_and_textbook_knots() {
    let c = wave();
    let b = c.with_bezier_spans().unwrap();
    assert!(b.has_bezier_spans() && !c.has_bezier_spans());
    assert_eq!(b.point_count(), 6 * 3 + 1);
    close(largest_difference(&c, &b), 0.0, 1e-13, "same");
    assert_eq!(c.is_natural(), [false, false]);
    let line = NurbsCurve::bezier(&[p(0., 0., 0.), p(1., 0., 0.), p(2., 0., 0.), p(4., 3., 0.)]).unwrap();
    assert_eq!(line.is_natural(), [true, false]);
    let again = NurbsCurve::from_textbook_knots(3, &c.control_points(), None, &c.textbook_knots()).unwrap();
    assert_eq!(again, c);
    assert!(NurbsCurve::from_textbook_knots(3, &c.control_points(), None, c.knots()).is_err());
    let why = NurbsCurve::check(3, &c.homogeneous_points(), &c.textbook_knots()).unwrap_err().to_string();
    assert!(why.contains("textbook"), "{why}");
    assert!(NurbsCurve::check(3, &c.homogeneous_points(), c.knots()).is_ok());
    assert!(NurbsCurve::check(0, &[], &[]).is_err());
}

#[test]
fn periodic_curves_turn_and_move() {
    let points: Vec<Point3> =
        (0..7).map(f64::from).map(|a: f64| p(a.cos() * (2.0 + 0.3 * a), a.sin() * 3.0, 0.0)).collect();
    for degree in 2..=5 {
        let c = NurbsCurve::periodic_uniform(degree, &points).unwrap();
        for t in [0.0, 0.3, 2.0, 6.9] {
            let s = c.with_periodic_seam(t).unwrap();
            assert!(s.is_periodic());
            for i in 0..50 {
                let x = f64::from(i) / 50.0 * 7.0;
                let old = if t + x > 7.0 { t + x - 7.0 } else { t + x };
                close_points(s.point_at(s.domain().start + x), c.point_at(old), 1e-12, "turned");
            }
        }
        let m = c.with_control_point(1, p(0.0, 0.0, 5.0)).unwrap();
        assert!(m.is_periodic());
    }
    assert!(wave().with_periodic_seam(1.0).is_err());
    assert!(wave().with_control_point(9, p(0., 0., 0.)).is_err());
    assert!(wave().with_control_point(2, p(f64::NAN, 0., 0.)).is_err());
}

#[test]
fn extension_goes_on_by_the_polynomial() {
    let c = wave();
    let e = c.extended_to(Interval::new(-0.5, 6.25)).unwrap();
    for t in [0.0, 1.3, 6.0, -0.4, 6.2] {
        close_points(e.point_at(t), c.point_at(t), 1e-12, "same polynomial");
    }
    assert!(c.extended_to(Interval::new(1.0, 7.0)).is_err());
}

#[test]
fn least_squares_closed_forms() {
    // Points of a cubic give the cubic back, whatever the knots.
    let c = NurbsCurve::bezier(&[p(0., 0., 0.), p(1., 3., 1.), p(2., -3., 2.), p(4., 1., 0.)]).unwrap();
    let parameters: Vec<f64> = (0..=30).map(|i| f64::from(i) / 30.0).collect();
    let points = c.points_at(&parameters);
    let knots = [0.0, 0.0, 0.0, 0.3, 0.6, 1.0, 1.0, 1.0];
    let f = NurbsCurve::least_squares(3, &knots, &points, &parameters, &LeastSquares::default()).unwrap();
    assert!(f.deviation_from(&c).unwrap() < 1e-11);
    // A straight line through symmetric noise: the classic regression line.
    let noisy = [p(0., 1., 0.), p(1., -1., 0.), p(2., -1., 0.), p(3., 1., 0.)];
    let t = [0.0, 1.0, 2.0, 3.0];
    let free = LeastSquares { free_ends: true, ..LeastSquares::default() };
    let line = NurbsCurve::least_squares(1, &[0.0, 3.0], &noisy, &t, &free).unwrap();
    close_points(line.point_at(0.0), p(0., 0., 0.), 1e-13, "regression");
    close_points(line.point_at(3.0), p(3., 0., 0.), 1e-13, "regression");
    // A weight of 10⁹ pulls the curve through its point.
    let weights = [1.0, 1e9, 1.0, 1.0];
    let pulled = LeastSquares { weights: Some(&weights), ..free };
    let line = NurbsCurve::least_squares(1, &[0.0, 3.0], &noisy, &t, &pulled).unwrap();
    close_points(line.point_at(1.0), noisy[1], 1e-6, "weight");
    // Derivatives at the ends and exact points inside.
    let exact = [ExactCondition { parameter: 0.5, order: 0, value: Vector3::new(2.0, 1.0, 1.0) }];
    let options = LeastSquares {
        start_derivative: Some(Vector3::new(0.0, 6.0, 0.0)),
        end_derivative: Some(Vector3::new(5.0, 0.0, 0.0)),
        exact: &exact,
        ..LeastSquares::default()
    };
    let knots = [0.0, 0.0, 0.0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.0, 1.0];
    let f = NurbsCurve::least_squares(3, &knots, &points, &parameters, &options).unwrap();
    close_points(f.point_at(0.5), p(2., 1., 1.), 1e-11, "exact point");
    common::close_vectors(f.derivatives(0.0, 1, false).1[0], Vector3::new(0., 6., 0.), 1e-11, "start");
    common::close_vectors(f.derivatives(1.0, 1, true).1[0], Vector3::new(5., 0., 0.), 1e-11, "end");
}

#[test]
fn least_squares_refuses() {
    let points = [p(0., 0., 0.), p(1., 0., 0.), p(2., 0., 0.)];
    let none = LeastSquares::default();
    let knots = [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0];
    assert!(NurbsCurve::least_squares(3, &knots, &points, &[0.0, 1.0, 3.0], &none).is_err());
    assert!(NurbsCurve::least_squares(1, &[0.0, 1.0], &points, &[0.0, 0.5, 2.0], &none).is_err());
    assert!(NurbsCurve::least_squares(1, &[0.0, 1.0], &points, &[0.0, 1.0], &none).is_err());
    assert!(NurbsCurve::least_squares(1, &[0.0, 1.0], &points, &[1.0, 0.5, 0.0], &none).is_err());
    assert!(NurbsCurve::least_squares(0, &[0.0, 1.0], &points, &[0.0, 0.5, 1.0], &none).is_err());
    assert!(NurbsCurve::least_squares(200, &[0.0, 1.0], &points, &[0.0, 0.5, 1.0], &none).is_err());
    let weights = [1.0, -1.0, 1.0];
    let bad = LeastSquares { weights: Some(&weights), ..none };
    assert!(NurbsCurve::least_squares(1, &[0.0, 1.0], &points, &[0.0, 0.5, 1.0], &bad).is_err());
}

#[test]
fn periodic_least_squares_of_a_circle() {
    let t: Vec<f64> = (0..200).map(|i| f64::from(i) / 200.0).collect();
    let points: Vec<Point3> =
        t.iter().map(|t| (t * std::f64::consts::TAU).sin_cos()).map(|(s, c)| p(c, s, 0.)).collect();
    for (count, bound) in [(6, 1e-2), (12, 3e-4), (24, 2e-5)] {
        let c = NurbsCurve::least_squares_periodic(3, count, Interval::UNIT, &points, &t).unwrap();
        assert!(c.is_periodic());
        let worst = (0..1000)
            .map(|i| (c.point_at(f64::from(i) / 1000.0).to_vector().length() - 1.0).abs())
            .fold(0.0, f64::max);
        assert!(worst < bound, "{count}: {worst}");
    }
    assert!(NurbsCurve::least_squares_periodic(3, 3, Interval::UNIT, &points, &t).is_err());
}

#[test]
fn fits_within_the_tolerance() {
    let points: Vec<Point3> =
        (0..300).map(|i| f64::from(i) / 30.0).map(|x| p(x, (1.3 * x).sin(), 0.5 * (0.7 * x).cos())).collect();
    let mut count = 300;
    for tolerance in [1e-6, 1e-4, 1e-2] {
        for degree in [1, 2, 3, 5] {
            let f = NurbsCurve::fit_points(degree, &points, tolerance, None, None).unwrap();
            assert!(f.deviation <= tolerance);
            let curve: katydid_geometry::Curve = f.curve.clone().into();
            for q in &points {
                let near = curve.closest_point(*q).unwrap();
                assert!(near.distance <= tolerance * 1.0001);
            }
            if degree == 3 {
                assert!(f.curve.point_count() < count);
                count = f.curve.point_count();
            }
        }
    }
    assert!(count < 20, "{count}");
    let t = Vector3::new(1.0, 1.3, 0.0);
    let f = NurbsCurve::fit_points(3, &points, 1e-3, Some(t), None).unwrap();
    let d = f.curve.derivatives(0.0, 1, false).1[0];
    assert!(d.angle_to(t).unwrap() < 1e-9);
    let two = NurbsCurve::fit_points(3, &points[..2], 1e-3, None, None).unwrap();
    assert_eq!((two.curve.degree(), two.curve.point_count()), (3, 4));
    assert!(NurbsCurve::fit_points(3, &[points[0], points[0]], 1e-3, None, None).is_err());
    assert!(NurbsCurve::fit_points(3, &points, 0.0, None, None).is_err());
    assert!(NurbsCurve::fit_points(0, &points, 0.1, None, None).is_err());
}

#[test]
fn refits_certified() {
    let circle = Circle::new(Plane::XY, 5.0).unwrap().to_nurbs().unwrap();
    for (degree, tolerance) in [(3, 1e-3), (3, 1e-6), (5, 1e-6), (2, 1e-3), (1, 0.05)] {
        let r = circle.refit(degree, tolerance).unwrap();
        assert_eq!(r.curve.degree(), degree);
        assert!(!r.curve.is_rational());
        assert!(r.deviation <= tolerance && largest_difference(&circle, &r.curve) <= r.deviation * 1.000_001);
        assert!(r.curve.point_count() < 400, "{}", r.curve.point_count());
    }
    // A kink stays a kink.
    let bent = NurbsCurve::new(
        2,
        vec![p(0., 0., 0.), p(1., 2., 0.), p(2., 0., 0.), p(3., 2., 0.), p(4., 0., 0.)],
        vec![0., 0., 1., 1., 2., 2.],
    )
    .unwrap();
    let r = bent.refit(3, 1e-4).unwrap();
    close_points(r.curve.point_at(1.0), p(2., 0., 0.), 1e-12, "kink");
    assert!(r.deviation <= 1e-4);
    assert!(extreme().refit(3, 1e-2).is_ok());
    assert!(circle.refit(3, 0.0).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn removal_is_certified(xs in proptest::collection::vec((-5.0..5.0_f64, -5.0..5.0_f64, -5.0..5.0_f64, -3.0..3.0_f64), 5..14), degree in 1_usize..5, tolerance in 0.0..2.0_f64, rational in any::<bool>()) {
        let points: Vec<Point3> = xs.iter().map(|x| p(x.0, x.1, x.2)).collect();
        let weights: Vec<f64> = xs.iter().map(|x| if rational { 10_f64.powf(x.3) } else { 1.0 }).collect();
        let knots = katydid_geometry::clamped_uniform_knots(degree, points.len()).unwrap();
        let c = NurbsCurve::with_weights(degree, &points, &weights, knots).unwrap();
        let r = c.remove_knots(tolerance).unwrap();
        prop_assert!(r.deviation <= tolerance.max(1e-12));
        prop_assert!(largest_difference(&c, &r.curve) <= r.deviation * 1.000_001 + 1e-12);
        if degree > 1 && let Ok(low) = c.reduce_degree(f64::INFINITY) {
            prop_assert!(largest_difference(&c, &low.curve) <= low.deviation * 1.000_001 + 1e-12);
        }
    }
}
