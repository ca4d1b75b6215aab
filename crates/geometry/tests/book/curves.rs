//! Rows C1 to C5, C9, C10 and N1 to N10 of the source book on curves, with its worked numbers.

use std::f64::consts::PI;

use crate::common::{close, close_points, close_vectors};
use katydid_geometry::{
    Arc, Circle, Continuity, ContinuityTolerance, Curve, Ellipse, Line, NurbsCurve, Plane, Point3,
    PolylineCurve, Tolerance, Vector3, bezier_to_hermite, clamped_uniform_knots, de_casteljau,
    periodic_uniform_knots,
};

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn four() -> Vec<Point3> {
    vec![p(0., 0., 0.), p(1., 3., 0.), p(4., 3., 1.), p(5., 0., 0.)]
}

fn seven() -> Vec<Point3> {
    (0..7).map(|i| p(f64::from(i), f64::from(i * i % 5), f64::from(i % 3))).collect()
}

/// The knots of C10 as the book prints them.
const TEXTBOOK: [f64; 11] = [0.0, 0.0, 0.0, 0.0, 0.25, 0.5, 0.75, 1.0, 1.0, 1.0, 1.0];

#[test]
fn c1_a_polyline_has_kinks_and_a_smooth_curve_has_none() {
    let polyline: Curve = PolylineCurve::new(seven()).unwrap().into();
    let smooth: Curve = NurbsCurve::clamped_uniform(3, &seven()).unwrap().into();
    let t = Tolerance::default();
    assert_eq!(polyline.discontinuities(Continuity::G1, &t).len(), 5);
    assert!(smooth.discontinuities(Continuity::C2, &t).is_empty());
    // To be as near to the smooth curve as 0.001 a polyline needs many more points than the seven control points.
    let many = smooth.to_polyline(&katydid_geometry::PolylineLimits::within(1e-3)).unwrap();
    assert!(many.points().len() > 40);
    // Moving one control point moves the smooth curve near it only.
    let moved =
        NurbsCurve::clamped_uniform(3, &seven()).unwrap().with_control_point(0, p(0., 0., 9.)).unwrap();
    assert_eq!(moved.point_at(3.5), smooth.point_at(3.5));
}

#[test]
fn c2_hermite_and_bezier_cubics_are_the_same_curves() {
    let b = [four()[0], four()[1], four()[2], four()[3]];
    let (a, ta, d, td) = bezier_to_hermite(b);
    assert_eq!((a, d), (b[0], b[3]));
    close_vectors(ta, (b[1] - b[0]) * 3.0, 1e-15, "tangent");
    let h = NurbsCurve::hermite(a, ta, d, td).unwrap();
    for i in 0..=10 {
        let t = f64::from(i) / 10.0;
        close_points(h.point_at(t), NurbsCurve::bezier(&b).unwrap().point_at(t), 1e-14, "same");
    }
}

#[test]
fn c3_a_knot_inserted_changes_nothing_and_can_be_taken_out() {
    let c = NurbsCurve::clamped_uniform(3, &seven()).unwrap();
    let more = c.insert_knot(1.5, 1).unwrap();
    assert_eq!(more.point_count(), 8);
    assert!(c.deviation_from(&more).unwrap() < 1e-13);
    let (less, times) = more.remove_knot(1.5, 1, 1e-12).unwrap();
    assert_eq!((times, less.point_count()), (1, 7));
    assert!(c.deviation_from(&less).unwrap() < 1e-12);
}

#[test]
fn c4_joins_told_apart_on_both_scales() {
    let t = ContinuityTolerance::default();
    let a: Curve = Line::new(p(-2., 0., 0.), p(0., 0., 0.)).into();
    let kinked: Curve = Line::new(p(0., 0., 0.), p(1., 1., 0.)).into();
    let tangent: Curve =
        Arc::from_start_direction_end(p(0., 0., 0.), Vector3::X, p(1., 1., 0.)).unwrap().into();
    let curved: Curve =
        NurbsCurve::bezier(&[p(0., 0., 0.), p(1., 0., 0.), p(2., 0., 0.), p(3., 1., 0.)]).unwrap().into();
    let straight: Curve = Line::new(p(0., 0., 0.), p(2., 0., 0.)).into();
    let orders = [&kinked, &tangent, &curved, &straight].map(|b| a.join_continuity(b, &t).geometric);
    assert_eq!(orders, [Some(0), Some(1), Some(2), Some(3)]);
    // G1 is equal direction; equal derivative vectors are C1, which is more.
    let faster = straight.with_domain(katydid_geometry::Interval::UNIT).unwrap();
    let report = a.join_continuity(&faster, &t);
    assert_eq!((report.geometric, report.parametric), (Some(3), Some(0)));
}

#[test]
fn c5_curvature_is_one_over_the_radius() {
    for r in [0.5, 2.0, 40.0] {
        let circle: Curve = Circle::new(Plane::XY, r).unwrap().into();
        for curve in [circle.clone(), circle.to_nurbs().unwrap().into()] {
            for i in 0..16 {
                let t = curve.domain().at(f64::from(i) / 16.0);
                close(curve.signed_curvature_at(t, Vector3::Z), 1.0 / r, 1e-12, "left is positive");
                close(
                    curve.reversed().signed_curvature_at(-t, Vector3::Z),
                    -1.0 / r,
                    1e-12,
                    "right is negative",
                );
                close(curve.osculating_circle_at(t).unwrap().radius, r, 1e-12, "best fit");
            }
        }
    }
    // The graph at a G1 join of a line and an arc jumps by 1/r.
    let arc = Arc::from_start_direction_end(p(0., 0., 0.), Vector3::X, p(2., 2., 0.)).unwrap();
    let parts = vec![Line::new(p(-1., 0., 0.), p(0., 0., 0.)).into(), arc.into()];
    let joined: Curve = katydid_geometry::PolyCurve::new(parts).unwrap().into();
    let hairs = joined.curvature_graph(4, 1.0);
    let at_join: Vec<f64> =
        hairs.iter().filter(|h| h.from.distance_to(p(0., 0., 0.)) < 1e-9).map(Line::length).collect();
    assert_eq!(at_join.len(), 2);
    close((at_join[0] - at_join[1]).abs(), 0.5, 1e-12, "jump");
}

#[test]
fn c9_de_casteljau_draws_six_points() {
    let levels = de_casteljau(&four(), 0.4);
    assert_eq!(levels.iter().map(Vec::len).collect::<Vec<_>>(), [3, 2, 1]);
    close_points(
        levels[2][0],
        NurbsCurve::bezier(&four()).unwrap().point_at(0.4),
        1e-15,
        "R is on the curve",
    );
}

#[test]
fn c10_de_boor_has_the_coefficients_of_the_book() {
    let points = seven();
    let c = NurbsCurve::from_textbook_knots(3, &points, None, &TEXTBOOK).unwrap();
    let steps = c.de_boor(0.4);
    let ratios: Vec<f64> = steps.levels.iter().flatten().map(|s| (s.ratio * 100.0).round() / 100.0).collect();
    // A, B, C; D, E; F.
    assert_eq!(ratios, [0.8, 0.53, 0.2, 0.8, 0.3, 0.6]);
    let a = points[1].lerp(points[2], 0.8);
    let b = points[2].lerp(points[3], 8.0 / 15.0);
    let cc = points[3].lerp(points[4], 0.2);
    let (d, e) = (a.lerp(b, 0.8), b.lerp(cc, 0.3));
    let f = d.lerp(e, 0.6);
    let found: Vec<Point3> = steps.levels.iter().flatten().map(|s| s.point).collect();
    for (x, y) in found.iter().zip([a, b, cc, d, e, f]) {
        close_points(*x, y, 1e-14, "A to F");
    }
    close_points(c.point_at(0.4), f, 1e-14, "F is on the curve");
}

#[test]
fn n1_degrees_of_lines_circles_ellipses_and_free_forms() {
    let line: Curve = Line::new(four()[0], four()[1]).into();
    let polyline: Curve = PolylineCurve::new(four()).unwrap().into();
    let circle = Circle::new(Plane::XY, 1.0).unwrap().to_nurbs().unwrap();
    let ellipse = Ellipse::new(Plane::XY, 2.0, 1.0).unwrap().to_nurbs().unwrap();
    assert_eq!((line.to_nurbs().unwrap().degree(), polyline.to_nurbs().unwrap().degree()), (1, 1));
    assert!([&circle, &ellipse].iter().all(|c| c.degree() == 2 && c.order() == 3 && c.is_rational()));
    for degree in 1..=11 {
        let points: Vec<Point3> = (0..12).map(|i| p(f64::from(i), f64::from(i % 2), 0.)).collect();
        assert_eq!(NurbsCurve::clamped_uniform(degree, &points).unwrap().order(), degree + 1);
    }
}

#[test]
fn n2_control_points_are_more_than_the_degree_and_equal_weights_say_nothing() {
    assert!(NurbsCurve::clamped_uniform(4, &four()).is_err());
    let c = NurbsCurve::clamped_uniform(3, &four()).unwrap();
    let equal = NurbsCurve::with_weights(3, &four(), &[7.0; 4], c.knots().to_vec()).unwrap();
    assert!(c.deviation_from(&equal).unwrap() < 1e-14);
    assert!(equal.to_non_rational().unwrap().deviation_from(&c).unwrap() < 1e-14);
}

#[test]
fn n3_nine_knots_and_eleven() {
    let c = NurbsCurve::clamped_uniform(3, &seven()).unwrap();
    assert_eq!((c.knots().len(), c.textbook_knots().len()), (9, 11));
    assert_eq!(NurbsCurve::from_textbook_knots(3, &seven(), None, &c.textbook_knots()).unwrap(), c);
    // Neither form is taken for the other.
    assert!(NurbsCurve::new(3, seven(), TEXTBOOK.to_vec()).is_err());
    assert!(NurbsCurve::from_textbook_knots(3, &seven(), None, &TEXTBOOK[1..10]).is_err());
}

#[test]
fn n4_multiplicities() {
    let c = NurbsCurve::clamped_uniform(3, &seven()).unwrap();
    assert!(c.is_clamped());
    assert_eq!([0.0, 1.0, 2.0, 3.0, 4.0].map(|t| c.multiplicity(t)), [3, 1, 1, 1, 3]);
    // A full knot inside: the curve goes through that control point; a kink is possible, not certain.
    let full = vec![0., 0., 0., 1., 1., 1., 2., 2., 2.];
    let kinked: Curve = NurbsCurve::new(3, seven(), full.clone()).unwrap().into();
    assert_eq!(kinked.point_at(1.0), seven()[3]);
    assert!(!kinked.is_continuous_at(1.0, Continuity::G1, &ContinuityTolerance::default()));
    let mut in_line = seven();
    in_line[3] = in_line[2].lerp(in_line[4], 0.5);
    let smooth: Curve = NurbsCurve::new(3, in_line, full).unwrap().into();
    assert!(smooth.is_continuous_at(1.0, Continuity::C1, &ContinuityTolerance::default()));
    assert!(c.insert_knot(1.0, 4).is_err(), "at most the degree");
}

#[test]
fn n5_other_knots_are_another_curve() {
    let a = NurbsCurve::clamped_uniform(3, &seven()).unwrap();
    let b = NurbsCurve::new(3, seven(), vec![0., 0., 0., 0.2, 0.4, 3.8, 4., 4., 4.]).unwrap();
    assert_eq!(a.control_points(), b.control_points());
    assert!(a.deviation_from(&b).unwrap() > 0.1);
}

#[test]
fn n6_the_domain_is_the_curves() {
    let c: Curve = NurbsCurve::clamped_uniform(3, &seven()).unwrap().into();
    assert_eq!((c.domain().start, c.domain().end), (0.0, 4.0));
    assert_eq!((c.start(), c.end()), (seven()[0], seven()[6]));
    assert!(c.point_at(2.2).is_finite());
}

#[test]
fn n7_clamped_uniform_from_points_and_order() {
    let c = NurbsCurve::clamped_uniform(3, &four()).unwrap();
    assert_eq!((c.order(), c.point_count()), (4, 4));
    assert_eq!(c.knots(), clamped_uniform_knots(3, 4).unwrap());
    assert!(NurbsCurve::check(3, &c.homogeneous_points(), c.knots()).is_ok());
}

#[test]
fn n8_periodic_uniform_repeats_control_points() {
    for (degree, count) in [(3, 7), (2, 6)] {
        let c = NurbsCurve::periodic_uniform(degree, &four()).unwrap();
        assert_eq!(c.point_count(), count);
        assert_eq!(c.knots(), periodic_uniform_knots(degree, count).unwrap());
        assert!(c.is_periodic() && c.knots().iter().all(|&k| c.multiplicity(k) == 1));
        let curve: Curve = c.into();
        let kind = Continuity::Cn(u8::try_from(degree).unwrap() - 1);
        assert!(curve.is_continuous_at(0.0, kind, &ContinuityTolerance::default()), "smooth over the seam");
    }
}

#[test]
fn n9_walking_control_points_and_knots() {
    let c = NurbsCurve::clamped_uniform(3, &seven()).unwrap();
    let points: Vec<Point3> = (0..c.point_count()).filter_map(|i| c.control_point(i)).collect();
    assert_eq!(points, seven());
    assert_eq!(c.control_point(7), None);
    let knots: Vec<f64> = (0..9).filter_map(|i| c.knots().get(i).copied()).collect();
    assert_eq!(knots, [0., 0., 0., 1., 2., 3., 4., 4., 4.]);
    assert_eq!(c.textbook_knots().get(1..10), Some(knots.as_slice()));
}

#[test]
fn n10_weights_are_set_in_homogeneous_form() {
    let c = NurbsCurve::clamped_uniform(3, &four()).unwrap().to_rational();
    for w in [1e-3, 0.5, 4.0, 1e3] {
        let pulled = c.with_weight(1, w).unwrap();
        let h = pulled.homogeneous_point(1).unwrap();
        assert_eq!(h, [w, 3.0 * w, 0.0, w]);
        assert_eq!(pulled.control_point(1), Some(four()[1]));
    }
    let circle = Circle::new(Plane::XY, 2.0).unwrap().to_nurbs().unwrap();
    close(circle.weight(1).unwrap(), (PI / 4.0).cos(), 1e-15, "a quarter's weight");
}
