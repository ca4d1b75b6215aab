//! Curves made from curves: offsets, fillets, blends, extensions, tweens, polylines, arcs, rebuilt and recognised.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::common::{self, close, close_points};
use katydid_geometry::{
    Arc, Circle, ContinuityTolerance, Curve, Ellipse, ExtensionStyle, Interval, Line, NurbsCurve,
    OffsetCorner, Plane, Point3, PolyCurve, PolylineCurve, PolylineLimits, Tolerance, TweenMatch, Vector3,
    combined_curves, compatible_curves, intersect::curve_self,
};
use proptest::prelude::*;

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn polyline(points: &[(f64, f64)]) -> Curve {
    PolylineCurve::new(points.iter().map(|&(x, y)| p(x, y, 0.0)).collect()).unwrap().into()
}

fn bezier(points: &[(f64, f64)]) -> Curve {
    NurbsCurve::bezier(&points.iter().map(|&(x, y)| p(x, y, 0.0)).collect::<Vec<_>>()).unwrap().into()
}

fn circle(r: f64) -> Curve {
    Circle::new(Plane::XY, r).unwrap().into()
}

const FINE: Tolerance = Tolerance { absolute: 1e-4, angle: 0.017 };

fn offset(c: &Curve, d: f64, corner: OffsetCorner) -> Vec<Curve> {
    c.offset(&Plane::XY, d, corner, &FINE).unwrap()
}

/// Every point of an offset is the distance away, but for what a corner style adds.
fn keeps_distance(c: &Curve, out: &[Curve], d: f64, tolerance: f64, exactly: bool) {
    for o in out {
        let domain = o.domain();
        for i in 0..=200 {
            let near = c.closest_point(o.point_at(domain.at(f64::from(i) / 200.0))).unwrap().distance;
            assert!(near >= d.abs() - tolerance, "{near} is nearer than {d}");
            assert!(!exactly || near <= d.abs() + tolerance, "{near} is farther than {d}");
        }
        assert!(curve_self(o, 1e-7).unwrap().crossings.is_empty(), "the offset crosses itself");
    }
}

#[test]
fn offsets_of_squares_in_every_style() {
    let square = polyline(&[(0., 0.), (4., 0.), (4., 4.), (0., 4.), (0., 0.)]);
    for (corner, length) in [
        (OffsetCorner::Sharp, 24.0),
        (OffsetCorner::Round, 16.0 + TAU),
        (OffsetCorner::Chamfer, 16.0 + 4.0 * 2.0_f64.sqrt()),
    ] {
        let out = offset(&square, 1.0, corner);
        assert_eq!(out.len(), 1, "{corner:?}");
        assert!(out[0].is_closed());
        close(out[0].length(), length, 1e-12, "length");
        keeps_distance(
            &square,
            &out,
            if corner == OffsetCorner::Chamfer { 0.5_f64.sqrt() } else { 1.0 },
            1e-9,
            false,
        );
    }
    assert_eq!(offset(&square, 1.0, OffsetCorner::None).len(), 4);
    let smooth = offset(&square, 1.0, OffsetCorner::Smooth);
    assert!(smooth.len() == 1 && smooth[0].is_closed());
    let inside = offset(&square, -1.0, OffsetCorner::Sharp);
    assert_eq!(inside.len(), 1);
    close(inside[0].length(), 8.0, 1e-12, "shrunk");
    assert_eq!(inside[0].as_polyline().unwrap().len(), 5);
    assert!(offset(&square, -2.5, OffsetCorner::Sharp).is_empty(), "nothing is left");
    assert!(offset(&square, -2.0, OffsetCorner::Sharp).is_empty(), "a point is nothing");
    assert_eq!(offset(&square, 0.0, OffsetCorner::Sharp), vec![square.clone()]);
    assert!(square.offset(&Plane::YZ, 1.0, OffsetCorner::Sharp, &FINE).is_err());
    assert!(square.offset(&Plane::XY, f64::NAN, OffsetCorner::Sharp, &FINE).is_err());
}

#[test]
fn offsets_fall_apart_where_the_shape_is_narrow() {
    // A dumbbell: two rooms and a corridor of width 1.
    let dumbbell = polyline(&[
        (0., 0.),
        (4., 0.),
        (4., 1.5),
        (8., 1.5),
        (8., 0.),
        (12., 0.),
        (12., 4.),
        (8., 4.),
        (8., 2.5),
        (4., 2.5),
        (4., 4.),
        (0., 4.),
        (0., 0.),
    ]);
    let out = offset(&dumbbell, -0.75, OffsetCorner::Sharp);
    assert_eq!(out.len(), 2);
    assert!(out.iter().all(Curve::is_closed));
    keeps_distance(&dumbbell, &out, 0.75, 1e-6, false);
    for o in &out {
        let (area, _) = o.area_and_centroid(1e-6).unwrap();
        assert!((area - 2.5 * 2.5).abs() < 0.1, "{area}");
    }
    assert_eq!(offset(&dumbbell, -0.4, OffsetCorner::Sharp).len(), 1);
}

#[test]
fn offsets_of_arcs_and_lines_stay_arcs_and_lines() {
    close(offset(&circle(2.0), 0.5, OffsetCorner::Sharp)[0].length(), 5.0 * PI, 1e-13, "grown");
    close(offset(&circle(2.0), -0.5, OffsetCorner::Sharp)[0].length(), 3.0 * PI, 1e-13, "shrunk");
    assert!(offset(&circle(2.0), -2.0, OffsetCorner::Sharp).is_empty());
    assert!(offset(&circle(2.0), -3.0, OffsetCorner::Sharp).is_empty());
    let as_nurbs: Curve = circle(2.0).to_nurbs().unwrap().into();
    assert!(matches!(offset(&as_nurbs, 0.5, OffsetCorner::Sharp)[0], Curve::Arc(_) | Curve::Poly(_)));
    // A slot: two half circles and two lines.
    let a = Arc::from_start_direction_end(p(3., 0., 0.), Vector3::X, p(3., 2., 0.)).unwrap();
    let b = Arc::from_start_direction_end(p(0., 2., 0.), -Vector3::X, p(0., 0., 0.)).unwrap();
    let slot: Curve = PolyCurve::new(vec![
        Line::new(p(0., 0., 0.), p(3., 0., 0.)).into(),
        a.into(),
        Line::new(p(3., 2., 0.), p(0., 2., 0.)).into(),
        b.into(),
    ])
    .unwrap()
    .into();
    let out = offset(&slot, 0.5, OffsetCorner::Sharp);
    assert_eq!(out.len(), 1);
    close(out[0].length(), 6.0 + 3.0 * PI, 1e-12, "slot");
    keeps_distance(&slot, &out, 0.5, 1e-9, true);
    assert!(offset(&slot, -1.25, OffsetCorner::Sharp).is_empty());
    let line: Curve = Line::new(p(0., 0., 0.), p(1., 0., 0.)).into();
    close_points(offset(&line, 2.0, OffsetCorner::Sharp)[0].start(), p(0., -2., 0.), 1e-15, "right");
}

#[test]
fn offsets_of_nurbs_curves_are_within_the_tolerance() {
    let wave = bezier(&[(0., 0.), (2., 3.), (4., -3.), (6., 0.)]);
    for d in [0.2, -0.3] {
        let out = offset(&wave, d, OffsetCorner::Sharp);
        assert_eq!(out.len(), 1);
        keeps_distance(&wave, &out, d, 1.5e-4, true);
        close_points(
            out[0].start(),
            wave.start() + wave.tangent_at(0.0).unwrap().cross(Vector3::Z) * d,
            1e-9,
            "end",
        );
    }
    // A parabola beyond its radius of curvature 1/2: a swallowtail is cut away.
    let parabola = bezier(&[(-2., 4.), (0., -4.), (2., 4.)]);
    let out = offset(&parabola, -1.5, OffsetCorner::Sharp);
    assert_eq!(out.len(), 1);
    keeps_distance(&parabola, &out, 1.5, 1.6e-4, true);
    // The cut is on the axis: a kink at (0, y) with distance 1.5 to both sides.
    let kinks =
        out[0].discontinuities(katydid_geometry::Continuity::G1, &Tolerance { absolute: 1e-3, angle: 0.2 });
    assert_eq!(kinks.len(), 1);
    assert!(out[0].point_at(kinks[0]).x.abs() < 1e-3);
    // An ellipse inwards beyond its smallest radius 1/3, and beyond everything.
    let ellipse: Curve = Ellipse::new(Plane::XY, 3.0, 1.0).unwrap().to_nurbs().unwrap().into();
    let out = offset(&ellipse, -0.6, OffsetCorner::Sharp);
    assert_eq!(out.len(), 1);
    keeps_distance(&ellipse, &out, 0.6, 1.6e-4, true);
    assert!(offset(&ellipse, -1.1, OffsetCorner::Sharp).is_empty());
    let grown = offset(&ellipse, 1.0, OffsetCorner::Sharp);
    assert_eq!(grown.len(), 1);
    assert!(grown[0].start().distance_to(grown[0].end()) < 1e-4);
    // Steiner: length grows by 2πd around a convex curve.
    close(grown[0].length(), ellipse.length() + TAU, 1e-5, "Steiner's formula");
}

#[test]
fn open_hairpins_are_trimmed_at_their_own_ends() {
    // A U whose arms are 1 apart: at distance 0.8 inwards nothing stays between them.
    let u = polyline(&[(0., 5.), (0., 0.), (1., 0.), (1., 5.)]);
    assert!(offset(&u, -0.8, OffsetCorner::Sharp).is_empty());
    let spiral = polyline(&[(0., 0.), (6., 0.), (6., 6.), (0., 6.), (0., 1.), (4., 1.)]);
    for d in [0.3, -0.3, 0.8, -0.8, 1.4, -1.4] {
        let out = offset(&spiral, d, OffsetCorner::Round);
        keeps_distance(&spiral, &out, d, 1e-6, true);
    }
}

#[test]
fn fillets_touch_both_curves() {
    let tolerance = Tolerance::default();
    let a: Curve = Line::new(p(0., 0., 0.), p(4., 0., 0.)).into();
    let b: Curve = Line::new(p(4., 0., 0.), p(4., 3., 0.)).into();
    let f = a.fillet_with(&b, 1.0, &tolerance).unwrap();
    close_points(f.before.end(), p(3., 0., 0.), 1e-13, "before");
    close_points(f.after.start(), p(4., 1., 0.), 1e-13, "after");
    close(f.piece.length(), FRAC_PI_2, 1e-13, "quarter");
    assert!(a.fillet_with(&b, 3.5, &tolerance).is_err());
    assert!(a.fillet_with(&b, -1.0, &tolerance).is_err());
    assert!(a.fillet_with(&a.reversed(), 1.0, &tolerance).is_err());
    // Line and arc, arc and arc, line and spline: G1 at both ends.
    let arc: Curve = Arc::through(p(4., 0., 0.), p(5., 2., 0.), p(4., 4., 0.)).unwrap().into();
    let other: Curve = Arc::through(p(0., 0., 0.), p(2., 1., 0.), p(4., 0., 0.)).unwrap().into();
    let spline = bezier(&[(4., 0.), (4., 2.), (2., 3.), (3., 6.)]);
    for (x, y) in [(&a, &arc), (&other, &arc), (&a, &spline), (&other, &spline)] {
        for r in [1e-3, 0.1, 0.5] {
            let f = x.fillet_with(y, r, &tolerance).unwrap();
            let c = ContinuityTolerance { distance: 1e-9, angle: 1e-7, ..ContinuityTolerance::default() };
            assert!(f.before.join_continuity(&f.piece, &c).geometric >= Some(1));
            assert!(f.piece.join_continuity(&f.after, &c).geometric >= Some(1));
            close(f.piece.as_arc(1e-9).unwrap().circle.radius, r, 1e-9, "radius");
        }
    }
    let c = a.chamfer_with(&b, 1.0, 2.0, &tolerance).unwrap();
    assert_eq!((c.piece.start(), c.piece.end()), (p(3., 0., 0.), p(4., 2., 0.)));
}

#[test]
fn all_corners_at_once() {
    let tolerance = Tolerance::default();
    let square = polyline(&[(0., 0.), (4., 0.), (4., 4.), (0., 4.), (0., 0.)]);
    let (round, left) = square.fillet_corners(1.0, &tolerance).unwrap();
    assert!(left.is_empty() && round.is_closed());
    close(round.length(), 8.0 + TAU, 1e-12, "rounded");
    assert!(round.discontinuities(katydid_geometry::Continuity::G1, &tolerance).is_empty());
    let (cut, left) = square.chamfer_corners(1.0, &tolerance).unwrap();
    assert!(left.is_empty());
    close(cut.length(), 8.0 + 4.0 * 2.0_f64.sqrt(), 1e-12, "cut");
    let (_, left) = square.fillet_corners(2.5, &tolerance).unwrap();
    assert!(!left.is_empty());
    let open = polyline(&[(0., 0.), (4., 0.), (4., 4.)]);
    let (round, left) = open.fillet_corners(1.0, &tolerance).unwrap();
    assert!(left.is_empty());
    close(round.length(), 6.0 + FRAC_PI_2, 1e-12, "open");
    let drop = bezier(&[(0., 0.), (4., 4.), (-4., 4.), (0., 0.)]);
    let (round, left) = drop.fillet_corners(0.2, &tolerance).unwrap();
    assert!(left.is_empty(), "{left:?}");
    assert!(round.discontinuities(katydid_geometry::Continuity::G1, &tolerance).is_empty());
}

#[test]
fn blends_reach_their_continuity() {
    let a: Curve = Arc::through(p(0., 0., 0.), p(1., 0.5, 0.), p(2., 0., 0.)).unwrap().into();
    let b = bezier(&[(5., 1.), (6., 2.), (7., 0.), (8., 0.)]);
    for x in 0..=2_u8 {
        for y in 0..=2_u8 {
            for bulge in [0.5, 1.0, 2.0] {
                let c = a.blend_to(&b, [x, y], [bulge, 1.0]).unwrap();
                assert_eq!(c.to_nurbs().unwrap().degree(), usize::from(x + y) + 1);
                let t = ContinuityTolerance::default();
                assert!(a.join_continuity(&c, &t).geometric >= Some(x), "{x} {y}");
                assert!(c.join_continuity(&b, &t).geometric >= Some(y), "{x} {y}");
            }
        }
    }
    assert!(a.blend_to(&b, [3, 0], [1.0, 1.0]).is_err());
    assert!(a.blend_to(&b, [1, 1], [0.0, 1.0]).is_err());
    assert!(a.blend_to(&a.trimmed(a.domain()).unwrap().reversed(), [1, 1], [1.0, 1.0]).is_err());
    // Matching moves an end of a NURBS curve, rational ones too.
    let points: Vec<Point3> = (0..6).map(|i| p(-f64::from(i), f64::from(i % 2), 0.3)).collect();
    let weights = [1.0, 2.0, 0.5, 1.0, 3.0, 1.0];
    let knots = katydid_geometry::clamped_uniform_knots(3, 6).unwrap();
    let c = NurbsCurve::with_weights(3, &points, &weights, knots).unwrap();
    for order in 0..=2 {
        for at_end in [false, true] {
            let m: Curve = c.matched_to(at_end, &b, order).unwrap().into();
            let arriving = if at_end { m } else { m.reversed() };
            let report = arriving.join_continuity(&b, &ContinuityTolerance::default());
            assert!(report.geometric >= Some(order), "{order} {at_end} {report:?}");
        }
    }
    let h = NurbsCurve::hermite_through(
        &[p(0., 0., 0.), p(1., 1., 0.), p(2., 0., 0.)],
        &[Vector3::X, Vector3::Y, Vector3::Z],
        &[0.0, 1.0, 3.0],
    )
    .unwrap();
    common::close_vectors(h.derivatives(1.0, 1, false).1[0], Vector3::Y, 1e-14, "derivative");
    common::close_vectors(h.derivatives(3.0, 1, true).1[0], Vector3::Z, 1e-14, "derivative");
    close_points(h.point_at(1.0), p(1., 1., 0.), 1e-14, "point");
}

#[test]
fn extensions_have_their_length_and_smoothness() {
    let c = bezier(&[(0., 0.), (1., 2.), (2., -1.), (4., 0.)]);
    let whole = c.length();
    for style in [ExtensionStyle::Line, ExtensionStyle::Arc, ExtensionStyle::Smooth] {
        let e = c.extended(0.7, 1.3, style).unwrap();
        close(e.length(), whole + 2.0, 1e-9, "length");
        let kind = match style {
            ExtensionStyle::Line => katydid_geometry::Continuity::G1,
            ExtensionStyle::Arc => katydid_geometry::Continuity::G2,
            ExtensionStyle::Smooth => katydid_geometry::Continuity::CInfinity,
        };
        assert!(e.discontinuities(kind, &Tolerance::default()).is_empty(), "{style:?}");
    }
    let arc: Curve = Arc::through(p(1., 0., 0.), p(0., 1., 0.), p(-1., 0., 0.)).unwrap().into();
    let e = arc.extended(0.5, 0.5, ExtensionStyle::Smooth).unwrap();
    assert!(matches!(e, Curve::Arc(_)));
    close(e.length(), PI + 1.0, 1e-14, "arc");
    assert!(arc.extended(2.0, 2.0, ExtensionStyle::Smooth).is_err());
    assert!(circle(1.0).extended(1.0, 0.0, ExtensionStyle::Arc).is_err());
    assert!(c.extended(-1.0, 0.0, ExtensionStyle::Smooth).is_err());
    // The rational quarter circle goes on round its circle.
    let quarter: Curve = arc.to_nurbs().unwrap().into();
    let e = quarter.extended(0.0, 0.5, ExtensionStyle::Smooth).unwrap();
    close(e.end().to_vector().length(), 1.0, 1e-12, "on the circle");
}

#[test]
fn polylines_stay_within_their_limits() {
    let weighted: Curve = NurbsCurve::rational(
        3,
        vec![[0., 0., 0., 1.], [1e-3, 3e-3, 0., 1e-3], [6e2, -2e2, 3e2, 1e2], [9., 1., 2., 1.5]],
        vec![0., 0., 0., 1., 1., 1.],
    )
    .unwrap()
    .into();
    for c in [bezier(&[(0., 0.), (3., 9.), (5., -7.), (8., 0.)]), circle(5.0), weighted] {
        let mut counts = Vec::new();
        for d in [1e-1, 1e-3, 1e-5] {
            let poly = c.to_polyline(&PolylineLimits::within(d)).unwrap();
            counts.push(poly.points().len());
            let curve: Curve = poly.clone().into();
            let mut worst = 0.0_f64;
            for w in poly.parameters().windows(2) {
                for k in 1..8 {
                    let q = c.point_at(w[0] + (w[1] - w[0]) * f64::from(k) / 8.0);
                    worst = worst.max(curve.closest_point(q).unwrap().distance);
                }
            }
            assert!(worst <= d * 1.000_001, "{worst} above {d}");
        }
        assert!(counts[2] < 40 * counts[1], "{counts:?}");
        let angle = PolylineLimits { angle: Some(0.1), ..PolylineLimits::within(10.0) };
        let poly = c.to_polyline(&angle).unwrap();
        for w in poly.points().windows(3) {
            assert!((w[1] - w[0]).angle_to(w[2] - w[1]).unwrap() <= 0.1 + 1e-9);
        }
        let long = PolylineLimits { longest: Some(0.5), ..PolylineLimits::within(10.0) };
        let poly = c.to_polyline(&long).unwrap();
        assert!(poly.points().windows(2).all(|w| w[0].distance_to(w[1]) <= 0.5 + 1e-12));
    }
    assert!(circle(1.0).to_polyline(&PolylineLimits::within(0.0)).is_err());
    assert!(circle(1.0).to_polyline(&PolylineLimits::within(1e-300)).is_err());
    // Straight curves get their ends only.
    let line = bezier(&[(0., 0.), (1., 0.), (2., 0.), (5., 0.)]);
    assert_eq!(line.to_polyline(&PolylineLimits::within(1e-9)).unwrap().points().len(), 2);
}

#[test]
fn arcs_and_lines_within_the_tolerance() {
    let s = bezier(&[(0., 0.), (3., 9.), (5., -7.), (8., 0.)]);
    let ellipse: Curve = Ellipse::new(Plane::XY, 3.0, 1.0).unwrap().to_nurbs().unwrap().into();
    for c in [s, ellipse] {
        let mut before = 0;
        for d in [1e-2, 1e-4, 1e-6] {
            let arcs = c.to_arcs_and_lines(d).unwrap();
            assert!(arcs.segments().iter().all(|s| matches!(s, Curve::Arc(_) | Curve::Line(_))));
            assert!(arcs.largest_gap() < 1e-9, "{}", arcs.largest_gap());
            let n = arcs.segments().len();
            // Biarcs converge with the third power: 100 times finer costs 4.6 times as many.
            assert!(before == 0 || n < 8 * before, "{n} after {before}");
            before = n;
            let curve: Curve = arcs.into();
            assert!(c.measured_deviation(&curve).unwrap() <= d * 1.000_001);
        }
    }
    let twisted: Curve =
        NurbsCurve::bezier(&[p(0., 0., 0.), p(1., 0., 0.), p(1., 1., 0.), p(1., 1., 1.)]).unwrap().into();
    assert!(twisted.to_arcs_and_lines(1e-3).is_err());
}

#[test]
fn simplified_curves_have_no_superfluous_parts() {
    let t = Tolerance::default();
    let c = polyline(&[(0., 0.), (1., 0.), (2., 0.), (2., 1.), (2., 2.), (0., 2.), (0., 0.)]);
    assert_eq!(c.simplified(&t).unwrap().as_polyline().unwrap().len(), 5);
    let split = circle(2.0).split_at(&[1.0, 3.0, 7.0]).unwrap();
    let parts: Curve = PolyCurve::new(split).unwrap().into();
    let one = parts.simplified(&t).unwrap();
    close(one.as_circle(1e-9).unwrap().radius, 2.0, 1e-12, "one circle");
    let quarter: Curve = Arc::through(p(1., 0., 0.), p(0.6, 0.8, 0.), p(0., 1., 0.)).unwrap().into();
    let quarter: Curve = quarter.to_nurbs().unwrap().into();
    assert!(matches!(quarter.simplified(&t).unwrap(), Curve::Arc(_)));
    let wave = bezier(&[(0., 0.), (3., 9.), (5., -7.), (8., 0.)]);
    assert_eq!(wave.simplified(&t).unwrap(), wave);
}

#[test]
fn tweens_lie_between() {
    let a = bezier(&[(0., 0.), (1., 2.), (3., 2.), (4., 0.)]);
    let b: Curve = NurbsCurve::clamped_uniform(
        2,
        &[p(0., 5., 0.), p(1., 7., 0.), p(2., 5., 1.), p(4., 6., 0.), p(5., 5., 0.)],
    )
    .unwrap()
    .into();
    for matching in [TweenMatch::ControlPoints, TweenMatch::Parameters(60), TweenMatch::Lengths(60)] {
        for x in [0.0, 0.25, 1.0] {
            let t = a.tween(&b, x, matching).unwrap();
            close_points(t.point_at(0.0), a.start().lerp(b.start(), x), 1e-12, "start");
            close_points(t.point_at(1.0), a.end().lerp(b.end(), x), 1e-12, "end");
        }
    }
    let half = a.mean_with(&b).unwrap();
    for i in 0..=20 {
        let x = f64::from(i) / 20.0;
        let wanted = a.point_at(a.domain().at(x)).lerp(b.point_at(b.domain().at(x)), 0.5);
        close_points(half.point_at(x), wanted, 1e-12, "equal parameters");
    }
    let c = circle(1.0).to_nurbs().unwrap();
    let all = compatible_curves(&[a.to_nurbs().unwrap(), b.to_nurbs().unwrap(), c]).unwrap();
    assert!(all.windows(2).all(|w| w[0].knots() == w[1].knots() && w[0].point_count() == w[1].point_count()));
    assert!(compatible_curves(&[]).is_err());
    assert!(a.tween(&b, f64::NAN, TweenMatch::ControlPoints).is_err());
    assert!(a.tween(&b, 0.5, TweenMatch::Lengths(1)).is_err());
}

/// Equal weights add up exactly; others within the tolerance, without kinks at common knots or at the seam.
#[test]
fn combined_curves_are_means_at_equal_parameters() {
    let unit = |c: Curve| c.to_nurbs().unwrap().with_domain(Interval::UNIT).unwrap();
    let round = unit(circle(2.0));
    let moved =
        round.transformed(&katydid_geometry::Xform::translation(Vector3::new(1.0, 5.0, -3.0))).unwrap();
    let half = Curve::from(combined_curves(&[(round.clone(), 0.25), (moved, 0.75)], 1e-3).unwrap());
    let found = half.as_circle(1e-12).unwrap();
    close(found.radius, 2.0, 1e-12, "radius");
    close_points(found.center(), p(0.75, 3.75, -2.25), 1e-12, "centre");
    let corners = [p(3., 0., 0.), p(0., 3., 1.), p(-3., 1., 0.), p(-2., -2., 0.), p(1., -3., 2.)];
    let wavy = NurbsCurve::periodic_uniform(3, &corners).unwrap().with_domain(Interval::UNIT).unwrap();
    for share in [0.5, 0.2, 1.5] {
        let parts = [(round.clone(), 1.0 - share), (wavy.clone(), share)];
        let mixed = combined_curves(&parts, 1e-3).unwrap();
        for i in 0..=500 {
            let t = f64::from(i) / 500.0;
            close_points(
                mixed.point_at(t),
                round.point_at(t).lerp(wavy.point_at(t), share),
                1e-3,
                "the mean",
            );
        }
        let slope = |t: f64, below: bool| mixed.derivatives(t, 1, below).1[0];
        for t in mixed.span_parameters() {
            let (left, right) = (if t > 0.0 { t } else { 1.0 }, if t < 1.0 { t } else { 0.0 });
            let kink = slope(left, true).angle_to(slope(right, false)).unwrap();
            close(kink, 0.0, 1e-7, "a kink");
        }
    }
    assert!(combined_curves(&[], 1e-3).is_err());
}

#[test]
fn rebuilt_curves_report_their_deviation() {
    let c = bezier(&[(0., 0.), (3., 9.), (5., -7.), (8., 0.)]);
    let mut before = f64::INFINITY;
    for count in [4, 6, 12, 30] {
        let r = c.rebuilt(3, count, true).unwrap();
        assert_eq!((r.curve.point_count(), r.curve.domain()), (count, c.domain()));
        assert!(r.deviation < before);
        before = r.deviation;
        let t = c.tangent_at(0.0).unwrap();
        assert!(r.curve.derivatives(0.0, 1, false).1[0].angle_to(t).unwrap() < 1e-9);
    }
    assert!(before < 5e-3, "{before}");
    let r = circle(3.0).rebuilt(3, 12, false).unwrap();
    assert!(r.curve.is_periodic() && r.deviation < 2e-3, "{}", r.deviation);
    assert!(circle(3.0).refitted(3, 1e-5).unwrap().deviation <= 1e-5);
    assert!(c.rebuilt(0, 4, false).is_err() && c.rebuilt(3, 3, false).is_err());
}

#[test]
fn ellipses_are_exact_and_recognised() {
    let plane =
        Plane::from_axes(p(3., -1., 2.), Vector3::new(1., 2., 0.5), Vector3::new(-2., 1., 0.3)).unwrap();
    for (rx, ry) in [(3.0, 1.0), (1.0, 3.0), (2.0, 2.0), (100.0, 0.5)] {
        let e = Ellipse::new(plane, rx, ry).unwrap();
        let c: Curve = e.to_nurbs().unwrap().into();
        let found = c.as_ellipse(1e-6).unwrap_or_else(|| panic!("{rx} {ry}"));
        close(found.rx, rx.max(ry), 1e-8, "long");
        close(found.ry, rx.min(ry), 1e-8, "short");
        close_points(found.plane.origin, plane.origin, 1e-8, "centre");
        for range in [Interval::new(0.3, 1.0), Interval::new(-1.0, 2.5), Interval::new(0.0, TAU)] {
            let part = e.arc_to_nurbs(range, Interval::UNIT).unwrap();
            close_points(part.point_at(0.0), e.at(range.start), 1e-12, "start");
            close_points(part.point_at(1.0), e.at(range.end), 1e-12, "end");
            for k in 0..=20 {
                let q = part.point_at(f64::from(k) / 20.0);
                let [x, y, z] = plane.coordinates(q);
                close((x / rx).powi(2) + (y / ry).powi(2), 1.0, 1e-11, "on it");
                close(z, 0.0, 1e-11, "in the plane");
            }
        }
    }
    assert!(circle(2.0).as_ellipse(1e-9).is_some());
    assert!(polyline(&[(0., 0.), (1., 0.), (1., 1.), (0., 0.)]).as_ellipse(1e-3).is_none());
    assert!(bezier(&[(0., 0.), (4., 4.), (-4., 4.), (0., 0.)]).as_ellipse(1e-3).is_none());
    assert!(bezier(&[(0., 0.), (1., 2.), (3., 2.), (4., 0.)]).as_elliptic_arc(1e-9).is_none());
    let half = Ellipse::new(Plane::XY, 3.0, 1.0)
        .unwrap()
        .arc_to_nurbs(Interval::new(0.5, 2.0), Interval::UNIT)
        .unwrap();
    let (e, angle) = Curve::from(half).as_elliptic_arc(1e-9).unwrap();
    close(e.rx, 3.0, 1e-7, "part");
    close(angle.length(), 1.5, 1e-7, "angle");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    #[test]
    fn offsets_keep_their_distance(xs in proptest::collection::vec((-5.0..5.0_f64, -5.0..5.0_f64), 3..8), d in -2.0..2.0_f64, closed in any::<bool>(), degree in 1_usize..4) {
        let points: Vec<Point3> = xs.iter().map(|x| p(x.0, x.1, 0.0)).collect();
        let c = if closed { NurbsCurve::periodic_uniform(degree, &points) } else { NurbsCurve::clamped_uniform(degree.min(points.len() - 1), &points) };
        let c: Curve = c.unwrap().into();
        let t = Tolerance { absolute: 1e-3, angle: 0.01 };
        if let Ok(out) = c.offset(&Plane::XY, d, OffsetCorner::Round, &t) {
            for o in &out {
                for i in 0..=60 {
                    let q = o.point_at(o.domain().at(f64::from(i) / 60.0));
                    let near = c.closest_point(q).unwrap().distance;
                    prop_assert!((near - d.abs()).abs() <= 5e-3, "{near} {d}");
                }
            }
        }
    }

    #[test]
    fn offsets_miss_nothing(xs in proptest::collection::vec((-5.0..5.0_f64, -5.0..5.0_f64), 4..9), d in -1.5..1.5_f64, closed in any::<bool>(), degree in 2_usize..4) {
        let points: Vec<Point3> = xs.iter().map(|x| p(x.0, x.1, 0.0)).collect();
        let c = if closed { NurbsCurve::periodic_uniform(degree, &points) } else { NurbsCurve::clamped_uniform(degree, &points) };
        let c: Curve = c.unwrap().into();
        let t = Tolerance { absolute: 1e-3, angle: 0.01 };
        let out = c.offset(&Plane::XY, d, OffsetCorner::Round, &t).unwrap();
        for i in 0..=300 {
            let exact = |x: f64| {
                let u = c.domain().at(x.clamp(0.0, 1.0));
                c.point_at(u) + c.tangent_at(u).unwrap().cross(Vector3::Z) * d
            };
            let u = f64::from(i) / 300.0;
            let q = exact(u);
            // A stretch of the exact offset that is clear of everything else belongs to the result.
            let clear = |x: f64| c.closest_point(exact(x)).unwrap().distance >= d.abs() - 1e-9;
            if clear(u) && clear(u - 3e-3) && clear(u + 3e-3) {
                let near = out.iter().map(|o| o.closest_point(q).unwrap().distance).fold(f64::INFINITY, f64::min);
                prop_assert!(near <= 5e-3, "{near} at {u}, {} parts, distance {d}", out.len());
            }
        }
    }

    #[test]
    fn made_curves_answer_or_refuse(xs in proptest::collection::vec((-5.0..5.0_f64, -5.0..5.0_f64, -5.0..5.0_f64, -3.0..3.0_f64), 2..8), degree in 1_usize..6, size in -1.0..20.0_f64, planar in any::<bool>()) {
        let points: Vec<Point3> = xs.iter().map(|x| p(x.0.round(), x.1.round(), if planar { 0.0 } else { x.2 })).collect();
        let weights: Vec<f64> = xs.iter().map(|x| 10_f64.powf(x.3)).collect();
        let degree = degree.min(points.len() - 1);
        let knots = katydid_geometry::clamped_uniform_knots(degree, points.len()).unwrap();
        let c: Curve = NurbsCurve::with_weights(degree, &points, &weights, knots).unwrap().into();
        let t = Tolerance { absolute: 1e-2, angle: 0.02 };
        let other: Curve = Line::new(c.end(), p(9., 9., 0.)).into();
        let _ = (c.fillet_with(&other, size, &t), c.fillet_corners(size, &t), c.chamfer_corners(size, &t));
        let _ = (c.blend_to(&other, [2, 2], [size, 1.0]), c.to_arcs_and_lines(0.05), c.simplified(&t));
        for style in [ExtensionStyle::Line, ExtensionStyle::Arc, ExtensionStyle::Smooth] {
            if let Ok(e) = c.extended(size, size, style) {
                prop_assert!(e.start().is_finite() && e.end().is_finite());
            }
        }
        if let Ok(poly) = c.to_polyline(&PolylineLimits::within(0.01)) {
            prop_assert!(poly.points().iter().all(|p| p.is_finite()));
        }
        let _ = (c.rebuilt(3, 8, true), c.as_ellipse(0.1), c.curvature_extrema(), c.inflections(1e-6), c.tween(&other, size, TweenMatch::ControlPoints));
    }
}

#[test]
fn parts_that_begin_a_hair_beside_a_corner_begin_at_it() {
    let at = |x: f64, y: f64| Point3::new(x, y, 0.0);
    let corners = vec![at(0.0, 0.0), at(1.0, 0.0), at(2.0, 0.5), at(3.0, 0.5)];
    let polyline: Curve = katydid_geometry::PolylineCurve::new(corners.clone()).unwrap().into();
    let [a, b] = [1.0 - 2.0 * f64::EPSILON, 2.0 + 2.0 * f64::EPSILON];
    let Curve::Polyline(part) = polyline.trimmed(Interval::new(a, b)).unwrap() else { panic!() };
    assert_eq!(part.points().len(), 2);
    let segments: Vec<Curve> = corners.windows(2).map(|p| Line::new(p[0], p[1]).into()).collect();
    let joined: Curve = katydid_geometry::PolyCurve::new(segments).unwrap().into();
    let inner = match &joined {
        Curve::Poly(c) => Interval::new(c.parameters()[1] * (1.0 - 1e-15), c.parameters()[2]),
        _ => panic!(),
    };
    assert!(matches!(joined.trimmed(inner).unwrap(), Curve::Line(_)));
}
