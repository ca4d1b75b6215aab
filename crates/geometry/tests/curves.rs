//! What every curve can do, checked against other kernels, formulas and identities.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop")]

mod common;

use common::{close, close_curves, close_points, close_vectors, curve, number, plane, point, vector};
use katydid_geometry::{
    Arc, ArcCurve, ArcLength, Circle, Containment, Continuity, Curve, Ellipse, Interval, KnotSpacing, Line,
    LineCurve, NurbsCurve, Plane, Point3, PolyCurve, PolylineCurve, Rectangle, Tolerance, Vector3, Xform,
    join_curves, regular_polygon,
};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn line(a: Point3, b: Point3) -> Curve {
    Line::new(a, b).into()
}

fn polyline(points: &[(f64, f64)]) -> Curve {
    PolylineCurve::new(points.iter().map(|&(x, y)| p(x, y, 0.0)).collect()).unwrap().into()
}

fn circle(r: f64) -> Curve {
    Circle::new(Plane::XY, r).unwrap().into()
}

fn wave() -> Curve {
    let points: Vec<_> = (0..12)
        .map(|i| p(f64::from(i), 3.0 * (f64::from(i) * 1.3).sin(), (f64::from(i) * 0.7).cos()))
        .collect();
    NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None).unwrap().into()
}

/// A line, an arc tangent to it and a spline, end to end.
fn chain() -> Curve {
    let arc = Arc::from_start_direction_end(p(4.0, 0.0, 0.0), Vector3::X, p(6.0, 2.0, 0.0)).unwrap();
    let spline =
        NurbsCurve::bezier(&[p(6.0, 2.0, 0.0), p(6.0, 4.0, 1.0), p(8.0, 4.0, 2.0), p(9.0, 9.0, 0.0)]);
    PolyCurve::new(vec![line(p(0.0, 0.0, 0.0), p(4.0, 0.0, 0.0)), arc.into(), spline.unwrap().into()])
        .unwrap()
        .into()
}

#[test]
fn oracle_tangents_curvatures_and_frames() {
    let Some(data) = common::oracle("on_dev.json") else { return };
    let mut frames = 0;
    for case in data["curves"].as_array().unwrap() {
        let id = case["id"].as_str().unwrap();
        let c: Curve = curve(&case["in"]).into();
        if let Some(closed) = case["out"]["IsClosed"].as_bool() {
            assert_eq!(c.is_closed(), closed, "{id} closed");
        }
        if let Some(linear) = case["out"]["IsLinear"].as_bool() {
            assert_eq!(c.is_linear(1e-9), linear, "{id} linear");
        }
        if let Some(planar) = case["out"]["IsPlanar"].as_bool() {
            assert_eq!(c.is_planar(1e-6), planar, "{id} planar");
        }
        let outer = common::numbers(&case["out"]["BBox"]);
        let ours = c.bounding_box();
        if outer.len() == 6 {
            for (k, x) in [ours.min.x, ours.min.y, ours.min.z].iter().enumerate() {
                assert!(*x >= outer[k] - 1e-12, "{id} box");
            }
            for (k, x) in [ours.max.x, ours.max.y, ours.max.z].iter().enumerate() {
                assert!(*x <= outer[k + 3] + 1e-12, "{id} box");
            }
        }
        let degree = case["deg"].as_u64().unwrap();
        for e in case["out"]["eval"].as_array().unwrap() {
            let t = number(&e["t"]);
            close_vectors(c.tangent_at(t).unwrap(), vector(&e["TangentAt"]), 1e-10, id);
            // Curvature of a polyline is rounding noise there and here.
            if degree == 1 {
                assert!(c.curvature_at(t).length() < 1e-10, "{id}");
                continue;
            }
            let k = vector(&e["CurvatureAt"]);
            close_vectors(c.curvature_at(t), k, 1e-8, &format!("{id} curvature at {t}"));
            let f = &e["FrameAt"];
            if f[0].as_bool() == Some(true) && k.length() > 1e-6 {
                frames += 1;
                let frame = c.frame_at(t).unwrap();
                close_vectors(frame.x_axis, vector(&f[2]), 1e-7, id);
                close_vectors(frame.y_axis, vector(&f[3]), 1e-7, id);
                close_vectors(frame.z_axis, vector(&f[4]), 1e-7, id);
            }
        }
    }
    assert!(frames > 100);
}

#[test]
fn oracle_conics() {
    let Some(data) = common::oracle("on_dev.json") else { return };
    for case in data["conics"].as_array().unwrap() {
        let (input, out, id) = (&case["in"], &case["out"], case["id"].as_str().unwrap());
        match input["kind"].as_str().unwrap() {
            "Circle" => {
                let c = Circle::new(plane(&input["plane"]), number(&input["r"])).unwrap();
                let t = number(&input["t"]);
                close_points(c.at(t), point(&out["PointAt"]), 1e-14, id);
                close(c.circumference(), number(&out["Circumference"]), 1e-14, id);
                close_curves(&c.to_nurbs().unwrap(), &curve(&out["Nurbs"]), 1e-13, id);
                let whole = ArcCurve {
                    arc: Arc::new(c, Interval::new(0.0, TAU)).unwrap(),
                    domain: Interval::new(0.0, TAU),
                };
                let found = Curve::from(whole).closest_point(point(&input["q"])).unwrap();
                close(found.parameter, number(&out["ClosestParameter"]), 1e-12, id);
                close_points(found.point, point(&out["ClosestPoint"]), 1e-12, id);
                let b = common::numbers(&out["BBox"]);
                // openNURBS gives a box around the circle that need not be tight.
                let ours = Curve::from(c).bounding_box();
                let theirs =
                    katydid_geometry::BoundingBox { min: p(b[0], b[1], b[2]), max: p(b[3], b[4], b[5]) };
                assert!(
                    theirs.inflated(1e-12).contains(ours.min) && theirs.inflated(1e-12).contains(ours.max)
                );
                let (_, d) = Curve::from(whole).derivatives(t, 3, false);
                for (a, b) in d.iter().zip(out["Der"].as_array().unwrap()) {
                    close_vectors(*a, vector(b), 1e-13, id);
                }
            }
            "Arc" => {
                let c = Circle::new(plane(&input["plane"]), number(&input["r"])).unwrap();
                let arc = Arc::new(c, common::interval(&input["angle"])).unwrap();
                close(arc.length(), number(&out["Length"]), 1e-13, id);
                close_points(arc.start(), point(&out["Start"]), 1e-13, id);
                close_points(arc.midpoint(), point(&out["Mid"]), 1e-13, id);
                close_points(arc.end(), point(&out["End"]), 1e-13, id);
                let over = ArcCurve { arc, domain: arc.angle };
                close_curves(&over.to_nurbs().unwrap(), &curve(&out["Nurbs"]), 1e-12, id);
                let found = Curve::from(over).closest_point(point(&input["q"])).unwrap();
                close(found.parameter, number(&out["ClosestParameter"]), 1e-12, id);
                let b = common::numbers(&out["BBox"]);
                let ours = Curve::from(over).bounding_box();
                let theirs =
                    katydid_geometry::BoundingBox { min: p(b[0], b[1], b[2]), max: p(b[3], b[4], b[5]) };
                assert!(
                    theirs.inflated(1e-12).contains(ours.min) && theirs.inflated(1e-12).contains(ours.max)
                );
            }
            _ => {
                let q: Vec<_> = input["p"].as_array().unwrap().iter().map(point).collect();
                let arc = Arc::through(q[0], q[1], q[2]).unwrap();
                close(arc.circle.radius, number(&out["Radius"]), 1e-9, id);
                close(arc.angle.length(), number(&out["Angle"]), 1e-9, id);
                close(arc.length(), number(&out["Length"]), 1e-9, id);
                let want = plane(&out["Plane"]);
                close_points(arc.circle.plane.origin, want.origin, 1e-9, id);
                close_vectors(arc.circle.plane.x_axis, want.x_axis, 1e-9, id);
                close_vectors(arc.circle.plane.z_axis, want.z_axis, 1e-9, id);
            }
        }
    }
}

#[test]
fn oracle_lengths_and_their_inverse() {
    let Some(data) = common::oracle("occ_dev.json") else { return };
    for (i, case) in data["length"].as_array().unwrap().iter().enumerate() {
        let c: Curve = curve(&case["in"]).into();
        let (length, want) = (c.length(), number(&case["length"]));
        assert!((length - want).abs() <= 1e-11 * want, "length {i}: {length} against {want}");
        let t = c.parameter_at_normalized_length(0.5).unwrap();
        // The reference parameter is itself only good to some 1e-3 of the length; the measure below is the test.
        assert!((t - number(&case["t_at_half"])).abs() < 0.02 * c.domain().length(), "half {i}: {t}");
        let half = c.length_between(Interval::new(c.domain().start, t));
        assert!((half - 0.5 * length).abs() < 1e-12 * length, "half {i} measured: {half}");
    }
}

#[test]
fn oracle_closest_points() {
    let Some(data) = common::oracle("occ_dev.json") else { return };
    for (i, case) in data["closest_curve"].as_array().unwrap().iter().enumerate() {
        let c: Curve = curve(&case["in"]).into();
        let found = c.closest_point(point(&case["q"])).unwrap();
        close(found.distance, number(&case["dist"]), 1e-12, &format!("distance {i}"));
        assert!((found.parameter - number(&case["t"])).abs() < 1e-7, "parameter {i}: {}", found.parameter);
    }
}

#[test]
fn closest_point_is_global_and_lipschitz() {
    let mut last: Option<(Point3, f64)> = None;
    for c in [wave(), chain(), circle(2.0), polyline(&[(0.0, 0.0), (3.0, 1.0), (1.0, 4.0), (0.0, 0.0)])] {
        let domain = c.domain();
        let samples: Vec<Point3> = (0..=4000).map(|i| c.point_at(domain.at(f64::from(i) / 4000.0))).collect();
        for i in 0..300 {
            let x = f64::from(i);
            let q = p(6.0 * (x * 0.73).sin() + 5.0, 5.0 * (x * 1.37).cos(), 3.0 * (x * 0.31).sin());
            let found = c.closest_point(q).unwrap();
            let least = samples.iter().map(|s| s.distance_to(q)).fold(f64::INFINITY, f64::min);
            assert!(found.distance <= least + 1e-12, "{i}: {} above {least}", found.distance);
            close_points(c.point_at(found.parameter), found.point, 1e-12, "point at parameter");
            if let Some((before, distance)) = last {
                assert!((found.distance - distance).abs() <= q.distance_to(before) + 1e-12);
            }
            last = Some((q, found.distance));
        }
        last = None;
        for i in 0..=50 {
            let t = domain.at(f64::from(i) / 50.0);
            assert!(c.closest_point(c.point_at(t)).unwrap().distance < 1e-9, "points of the curve itself");
        }
    }
    assert!(wave().closest_point(p(f64::NAN, 0.0, 0.0)).is_err());
}

#[test]
fn c5_curvature_of_a_circle_and_its_sign() {
    for r in [0.5, 2.0, 1e4] {
        let c = circle(r);
        for i in 0..8 {
            let t = c.domain().at(f64::from(i) / 8.0);
            close(c.curvature_at(t).length() * r, 1.0, 1e-12, "curvature");
            close(c.signed_curvature_at(t, Vector3::Z) * r, 1.0, 1e-12, "left is positive");
            close(c.signed_curvature_at(t, -Vector3::Z) * r, -1.0, 1e-12, "right is negative");
            let n: Curve = c.to_nurbs().unwrap().into();
            close(n.curvature_at(t).length() * r, 1.0, 1e-10, "rational form");
        }
        close(c.length(), TAU * r, 1e-15, "length");
        close(Curve::from(c.to_nurbs().unwrap()).length(), TAU * r, 1e-13, "length of the rational form");
    }
}

#[test]
fn c4_continuity_of_joined_curves() {
    let a = line(p(-2.0, 0.0, 0.0), p(0.0, 0.0, 0.0));
    let tolerance = Tolerance::default();
    let away = line(p(1.0, 0.0, 0.0), p(2.0, 0.0, 0.0));
    let kinked = line(p(0.0, 0.0, 0.0), p(1.0, 1.0, 0.0));
    let arc: Curve =
        Arc::from_start_direction_end(p(0.0, 0.0, 0.0), Vector3::X, p(1.0, 1.0, 0.0)).unwrap().into();
    let smooth: Curve =
        NurbsCurve::bezier(&[p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(2.0, 0.0, 0.0), p(3.0, 2.0, 0.0)])
            .unwrap()
            .into();
    assert_eq!(a.continuity_with(&away, &tolerance), None);
    assert_eq!(a.continuity_with(&kinked, &tolerance), Some(0));
    assert_eq!(a.continuity_with(&arc, &tolerance), Some(1));
    assert_eq!(a.continuity_with(&smooth, &tolerance), Some(2));
}

#[test]
fn tangent_where_the_curve_stands_still() {
    let points = [p(0.0, 0.0, 0.0), p(0.0, 0.0, 0.0), p(1.0, 1.0, 0.0), p(2.0, 1.0, 0.0), p(2.0, 1.0, 0.0)];
    let c: Curve = NurbsCurve::clamped_uniform(4, &points).unwrap().into();
    close_vectors(
        c.tangent_at(0.0).unwrap(),
        Vector3::new(0.5_f64.sqrt(), 0.5_f64.sqrt(), 0.0),
        1e-12,
        "start",
    );
    close_vectors(c.tangent_at(c.domain().end).unwrap(), Vector3::X, 1e-12, "end");
    let dot: Curve = NurbsCurve::new(1, vec![p(1.0, 1.0, 1.0); 2], vec![0.0, 1.0]).unwrap().into();
    assert_eq!(dot.tangent_at(0.5), None);
    assert_eq!(dot.length(), 0.0);
    assert!(dot.divide_by_count(3).is_err());
    assert!(dot.frame_at(0.5).is_none());
}

#[test]
fn length_at_a_cusp() {
    // (t², t³) on −1…1: length 2·(13√13 − 8)/27, with a cusp at 0 that is no knot.
    let c: Curve = NurbsCurve::bezier(&[
        p(1.0, -1.0, 0.0),
        p(-1.0 / 3.0, 1.0, 0.0),
        p(-1.0 / 3.0, -1.0, 0.0),
        p(1.0, 1.0, 0.0),
    ])
    .unwrap()
    .into();
    close_points(c.point_at(0.75), p(0.25, 0.125, 0.0), 1e-15, "parametrisation");
    close(c.length(), 2.0 * (13.0 * 13f64.sqrt() - 8.0) / 27.0, 1e-12, "cusp");
}

#[test]
fn torsion_of_a_twisted_cubic() {
    // (t, t², t³): torsion 3/(1 + 9t² + 9t⁴).
    let c: Curve = NurbsCurve::bezier(&[
        p(0.0, 0.0, 0.0),
        p(1.0 / 3.0, 0.0, 0.0),
        p(2.0 / 3.0, 1.0 / 3.0, 0.0),
        p(1.0, 1.0, 1.0),
    ])
    .unwrap()
    .into();
    for t in [0.0_f64, 0.3, 1.0] {
        close(c.torsion_at(t), 3.0 / (1.0 + 9.0 * t * t + 9.0 * t.powi(4)), 1e-11, "torsion");
    }
    assert_eq!(line(p(0.0, 0.0, 0.0), p(1.0, 1.0, 1.0)).torsion_at(0.5), 0.0);
}

#[test]
fn domains_of_the_basic_curves() {
    assert_eq!(line(p(0.0, 0.0, 0.0), p(3.0, 4.0, 0.0)).domain(), Interval::new(0.0, 5.0));
    assert_eq!(line(p(1.0, 0.0, 0.0), p(1.0, 0.0, 0.0)).domain(), Interval::new(0.0, 1.0));
    assert_eq!(circle(2.0).domain(), Interval::new(0.0, 4.0 * PI));
    assert_eq!(polyline(&[(0.0, 0.0), (5.0, 0.0), (5.0, 9.0)]).domain(), Interval::new(0.0, 2.0));
    assert_eq!(circle(2.0).with_domain(Interval::UNIT).unwrap().point_at(0.25), circle(2.0).point_at(PI));
}

#[test]
fn reversal_trimming_and_splitting_keep_the_points() {
    for c in [wave(), chain(), circle(2.0), polyline(&[(0.0, 0.0), (3.0, 1.0), (1.0, 4.0), (0.0, 7.0)])] {
        let d = c.domain();
        let r = c.reversed();
        assert_eq!(r.domain(), Interval::new(-d.end, -d.start));
        close(r.length(), c.length(), 1e-12, "length survives reversal");
        let (a, b) = (d.at(0.21), d.at(0.83));
        let part = c.trimmed(Interval::new(a, b)).unwrap();
        close(part.length(), c.length_between(Interval::new(a, b)), 1e-11, "length adds up");
        for i in 0..=20 {
            let t = d.at(f64::from(i) / 20.0);
            close_points(r.point_at(-t), c.point_at(t), 1e-12, "reversed");
            if (a..=b).contains(&t) {
                close_points(part.point_at(t), c.point_at(t), 1e-11, "trimmed");
            }
        }
        let pieces = c.split_at(&[b, a, a, d.end + 1.0, f64::NAN]).unwrap();
        assert_eq!(pieces.len(), if c.is_closed() { 2 } else { 3 });
        close(pieces.iter().map(Curve::length).sum::<f64>(), c.length(), 1e-11, "sum of the pieces");
        assert!(c.trimmed(Interval::new(b, a)).is_err());
        assert!(c.trimmed(Interval::new(d.start - 1.0, b)).is_err());
        let moved = c.with_domain(Interval::new(-1.0, 1.0)).unwrap();
        close_points(moved.point_at(0.0), c.point_at(d.middle()), 1e-11, "another domain");
    }
}

#[test]
fn closed_curves_split_as_in_rhino() {
    let c = circle(1.0);
    let parts = c.split_at(&[1.0, 2.0, 4.0]).unwrap();
    assert_eq!(parts.len(), 3);
    close_points(parts[2].start(), c.point_at(4.0), 1e-15, "the piece over the seam is last");
    close_points(parts[2].end(), c.point_at(1.0), 1e-14, "and ends at the first cut");
    assert!(matches!(parts[2], Curve::Arc(_)));
    assert_eq!(c.split_at(&[0.0, 2.0, 4.0]).unwrap().len(), 3);
    assert_eq!(c.split_at(&[]).unwrap(), vec![c.clone()]);
    assert_eq!(c.split_at(&[0.0]).unwrap().len(), 1);
    let square = polyline(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)]);
    let parts = square.split_at(&[1.5, 2.5]).unwrap();
    assert_eq!(parts[1].as_polyline().unwrap().len(), 5);
    let moved = square.with_seam(1.5).unwrap();
    assert_eq!(moved.domain(), Interval::new(1.5, 5.5));
    close(moved.length(), 4.0, 1e-15, "length");
    assert_eq!(moved.start(), p(1.0, 0.5, 0.0));
    let blob: Curve = NurbsCurve::periodic_uniform(
        3,
        &[p(0.0, 0.0, 0.0), p(6.0, 0.0, 0.0), p(2.0, 2.0, 0.0), p(0.0, 6.0, 0.0)],
    )
    .unwrap()
    .into();
    let moved = blob.with_seam(1.3).unwrap();
    assert!(matches!(moved, Curve::Nurbs(_)) && moved.is_closed());
    assert_eq!(moved.domain(), Interval::new(1.3, 5.3));
    close_points(moved.point_at(4.7), blob.point_at(0.7), 1e-12, "past the old seam");
    let sub = c.sub_curve(Interval::new(5.0, 1.0)).unwrap();
    close(sub.length(), TAU - 4.0, 1e-13, "through the seam");
}

#[test]
fn transforms_of_arcs_are_exact() {
    let arc = Arc::new(Circle::new(Plane::XZ, 3.0).unwrap(), Interval::new(0.4, 4.0)).unwrap();
    let c: Curve = arc.into();
    let mirror = Xform::mirror(&Plane::from_normal(p(1.0, 2.0, 3.0), Vector3::new(1.0, 2.0, -1.0)).unwrap());
    let squash = Xform::scale_non_uniform(&Plane::XY, 2.0, 1.0, 0.3);
    let turn = Xform::rotation(1.0, Vector3::new(1.0, 1.0, 0.0), p(3.0, 0.0, 0.0)).unwrap();
    for (xform, stays) in [(mirror, true), (turn, true), (squash, false), (squash * turn, false)] {
        let image = c.transformed(&xform).unwrap();
        assert_eq!(matches!(image, Curve::Arc(_)), stays);
        assert_eq!(image.domain(), c.domain());
        for i in 0..=8 {
            let t = c.domain().at(f64::from(i) / 8.0);
            let want = xform.point(c.point_at(t));
            if stays {
                close_points(image.point_at(t), want, 1e-13, "same parameter");
            }
            assert!(image.closest_point(want).unwrap().distance < 1e-9, "same points");
        }
        close_points(image.start(), xform.point(c.start()), 1e-13, "start");
        close_points(image.end(), xform.point(c.end()), 1e-13, "end");
    }
    let flat = c.transformed(&Xform::planar_projection(&Plane::XY)).unwrap();
    assert!(flat.is_linear(1e-9) || flat.length() > 0.0);
    let huge = Xform::scale(Point3::ORIGIN, f64::MAX);
    assert!(wave().transformed(&huge).is_err());
}

#[test]
fn nurbs_forms_are_exact() {
    for c in [
        chain(),
        circle(2.0),
        polyline(&[(0.0, 0.0), (3.0, 1.0), (1.0, 4.0)]),
        line(p(0.0, 0.0, 0.0), p(1.0, 2.0, 3.0)),
    ] {
        let n: Curve = c.to_nurbs().unwrap().into();
        assert_eq!(n.domain(), c.domain());
        close(n.length(), c.length(), 1e-12, "length");
        for i in 0..=30 {
            let t = c.domain().at(f64::from(i) / 30.0);
            assert!(n.closest_point(c.point_at(t)).unwrap().distance < 1e-9);
        }
    }
    let e = Ellipse::new(Plane::XY, 5.0, 3.0).unwrap();
    let n: Curve = e.to_nurbs().unwrap().into();
    assert_eq!(n.domain(), Interval::new(0.0, TAU));
    assert!(n.is_closed());
    close_points(n.point_at(FRAC_PI_2), p(0.0, 3.0, 0.0), 1e-15, "quadrant");
    let (area, center) = n.area_and_centroid(1e-6).unwrap();
    close(area, PI * 15.0, 1e-12, "area of an ellipse");
    close_points(center, Point3::ORIGIN, 1e-12, "centre of an ellipse");
    assert_eq!(e.foci(), [p(4.0, 0.0, 0.0), p(-4.0, 0.0, 0.0)]);
    assert!(Ellipse::new(Plane::XY, 0.0, 1.0).is_err());
}

#[test]
fn recognised_for_what_they_are() {
    let c: Curve = Circle::from_normal(p(1.0, 2.0, 3.0), Vector3::new(1.0, 1.0, 1.0), 4.0).unwrap().into();
    let n: Curve = c.to_nurbs().unwrap().into();
    let found = n.as_circle(1e-9).unwrap();
    close(found.radius, 4.0, 1e-12, "radius");
    close_points(found.center(), p(1.0, 2.0, 3.0), 1e-12, "centre");
    let arc: Curve = Arc::through(p(0.0, 0.0, 0.0), p(1.0, 1.0, 0.0), p(2.0, 0.0, 0.0)).unwrap().into();
    let n: Curve = arc.to_nurbs().unwrap().into();
    let back = n.as_arc(1e-9).unwrap();
    close(back.length(), PI, 1e-12, "arc");
    close_points(back.end(), p(2.0, 0.0, 0.0), 1e-12, "end");
    assert!(n.as_circle(1e-9).is_none());
    assert!(wave().as_arc(1e-3).is_none() && wave().as_line(1e-3).is_none());
    let straight: Curve =
        NurbsCurve::bezier(&[p(0.0, 0.0, 0.0), p(1.0, 1.0, 0.0), p(2.0, 2.0, 0.0)]).unwrap().into();
    assert!(straight.is_linear(1e-9) && straight.as_arc(1e-3).is_none());
    assert_eq!(chain().as_polyline(), None);
    assert!(circle(1.0).is_periodic() && circle(1.0).is_closed());
    assert!(!polyline(&[(0.0, 0.0), (1.0, 0.0), (0.0, 0.0)]).is_closed());
    assert!(!chain().is_planar(1e-3));
    let clockwise = polyline(&[(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0), (0.0, 0.0)]);
    close_vectors(
        clockwise.plane(1e-9).unwrap().z_axis,
        -Vector3::Z,
        1e-12,
        "a closed curve runs counter-clockwise",
    );
    close_vectors(clockwise.reversed().plane(1e-9).unwrap().z_axis, Vector3::Z, 1e-12, "and its reverse too");
}

#[test]
fn boxes_are_tight() {
    for c in [wave(), chain(), circle(2.0)] {
        let b = c.bounding_box();
        let d = c.domain();
        let mut inner = katydid_geometry::BoundingBox { min: c.start(), max: c.start() };
        for i in 0..=20_000 {
            let q = c.point_at(d.at(f64::from(i) / 20_000.0));
            assert!(b.inflated(1e-12).contains(q));
            inner = inner.union(&katydid_geometry::BoundingBox { min: q, max: q });
        }
        assert!(b.min.distance_to(inner.min) < 1e-5 && b.max.distance_to(inner.max) < 1e-5);
    }
    let frame = Plane::from_normal(p(1.0, 0.0, 0.0), Vector3::new(1.0, 2.0, 3.0)).unwrap();
    let b = chain().bounding_box_in(&frame);
    assert!(b.contains(chain().point_at(3.3), 1e-12));
}

#[test]
fn divisions() {
    let c = wave();
    let ts = c.divide_by_count(7).unwrap();
    assert_eq!(ts.len(), 8);
    let measure = ArcLength::new(&c);
    for (i, t) in ts.iter().enumerate() {
        close(measure.length_at(*t), measure.total() * i as f64 / 7.0, 1e-12, "equal parts");
    }
    assert_eq!(circle(1.0).divide_by_count(5).unwrap().len(), 5);
    assert!(c.divide_by_count(0).is_err() && c.divide_by_count(usize::MAX).is_err());
    let straight = line(p(0.0, 0.0, 0.0), p(10.0, 0.0, 0.0));
    assert_eq!(straight.divide_by_length(3.0).unwrap().len(), 4);
    assert_eq!(straight.divide_by_length(2.5).unwrap(), vec![0.0, 2.5, 5.0, 7.5, 10.0]);
    assert_eq!(straight.divide_by_length(11.0).unwrap(), vec![0.0]);
    assert!(straight.divide_by_length(0.0).is_err() && straight.divide_by_length(f64::NAN).is_err());
    assert!(straight.divide_by_length(1e-300).is_err());
    let closed = polyline(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)]);
    assert_eq!(closed.divide_by_length(0.5).unwrap().len(), 8);
    for c in [wave(), chain(), circle(2.0)] {
        let ts = c.divide_by_distance(0.7).unwrap();
        assert!(ts.len() > 5);
        for w in ts.windows(2) {
            assert!(w[0] < w[1]);
            close(c.point_at(w[0]).distance_to(c.point_at(w[1])), 0.7, 1e-10, "chord");
            for i in 1..20 {
                let t = Interval::new(w[0], w[1]).at(f64::from(i) / 20.0);
                assert!(c.point_at(w[0]).distance_to(c.point_at(t)) < 0.7 + 1e-10, "the first such point");
            }
        }
    }
    assert_eq!(straight.divide_by_distance(2.0).unwrap().len(), 6);
    assert_eq!(straight.divide_by_distance(99.0).unwrap(), vec![0.0]);
    assert!(straight.divide_by_distance(-1.0).is_err() && straight.divide_by_distance(1e-9).is_err());
    assert_eq!(c.parameter_at_length(-1.0), None);
    assert_eq!(c.parameter_at_normalized_length(1.0), Some(c.domain().end));
}

#[test]
fn joins() {
    let (a, b, c) = (p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(1.0, 1.0, 0.0));
    let joined = join_curves(&[line(a, b), line(c, b), line(p(9.0, 9.0, 9.0), a)], 1e-3, false);
    assert_eq!(joined.len(), 1);
    assert_eq!(joined[0].as_polyline().unwrap(), [p(9.0, 9.0, 9.0), a, b, c]);
    assert!(matches!(joined[0], Curve::Polyline(_)));
    let kept = join_curves(&[line(a, b), line(c, b)], 1e-3, true);
    assert_eq!(kept.len(), 2);
    let triangle =
        join_curves(&[line(a, b), line(p(1.0, 0.0004, 0.0), c), line(c, p(0.0, 0.0003, 0.0))], 1e-3, true);
    assert_eq!(triangle.len(), 1);
    assert!(triangle[0].is_closed());
    let parts = chain().explode(true).unwrap();
    assert_eq!(parts.len(), 3);
    let mixed = [parts[2].reversed(), circle(1.0), parts[0].clone(), parts[1].clone()];
    let again = join_curves(&mixed, 1e-6, false);
    assert_eq!(again.len(), 2);
    close(again[0].length(), chain().length(), 1e-12, "joined again");
    assert_eq!(again[1], circle(1.0));
    assert!(join_curves(&[], 1.0, false).is_empty());
}

#[test]
fn explode_and_discontinuities() {
    let tolerance = Tolerance::default();
    let bent = polyline(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0)]);
    assert_eq!(bent.explode(true).unwrap().len(), 3);
    assert_eq!(bent.discontinuities(Continuity::G1, &tolerance), vec![2.0]);
    assert_eq!(bent.discontinuities(Continuity::C1, &tolerance), vec![2.0]);
    let square = polyline(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)]);
    assert_eq!(square.discontinuities(Continuity::G1, &tolerance), vec![0.0, 1.0, 2.0, 3.0]);
    assert!(circle(3.0).discontinuities(Continuity::G2, &tolerance).is_empty());
    assert!(wave().discontinuities(Continuity::C2, &tolerance).is_empty());
    let mut points: Vec<_> = (0..7).map(|i| p(f64::from(i), f64::from(i % 2), 0.0)).collect();
    let knots = vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0];
    let kinked: Curve = NurbsCurve::new(3, points.clone(), knots.clone()).unwrap().into();
    assert_eq!(kinked.explode(true).unwrap().len(), 2);
    points[4] = points[3] + (points[3] - points[2]);
    let smooth: Curve = NurbsCurve::new(3, points, knots).unwrap().into();
    assert_eq!(smooth.explode(true).unwrap().len(), 1);
    assert_eq!(smooth.discontinuities(Continuity::C2, &tolerance), vec![1.0]);
    let nested: Curve =
        PolyCurve::new(vec![chain(), line(p(9.0, 9.0, 0.0), p(9.0, 10.0, 0.0))]).unwrap().into();
    assert_eq!(nested.explode(true).unwrap().len(), 4);
    assert_eq!(nested.explode(false).unwrap().len(), 2);
    close_points(nested.point_at(nested.domain().end), p(9.0, 10.0, 0.0), 1e-15, "nested");
}

#[test]
fn extension_by_lines() {
    let arc: Curve =
        Arc::from_start_direction_end(p(0.0, 0.0, 0.0), Vector3::X, p(1.0, 1.0, 0.0)).unwrap().into();
    let longer = arc.extended_by_lines(2.0, 3.0).unwrap();
    close(longer.length(), arc.length() + 5.0, 1e-13, "length");
    close_points(longer.start(), p(-2.0, 0.0, 0.0), 1e-14, "start");
    close_points(longer.end(), p(1.0, 4.0, 0.0), 1e-14, "end");
    assert!(longer.discontinuities(Continuity::G1, &Tolerance::default()).is_empty());
    let l = line(p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0)).extended_by_lines(1.0, 1.0).unwrap();
    assert_eq!(
        l,
        LineCurve { line: Line::new(p(-1.0, 0.0, 0.0), p(2.0, 0.0, 0.0)), domain: Interval::new(-1.0, 2.0) }
            .into()
    );
    assert!(circle(1.0).extended_by_lines(1.0, 0.0).is_err());
    assert!(l.extended_by_lines(-1.0, 0.0).is_err());
    assert_eq!(arc.extended_by_lines(0.0, 0.0).unwrap(), arc);
}

#[test]
fn perpendicular_frames_do_not_twist() {
    let c = circle(5.0);
    let ts: Vec<f64> = (0..=16).map(|i| c.domain().at(f64::from(i) / 16.0)).collect();
    let frames = c.perpendicular_frames(&ts);
    for (f, t) in frames.iter().zip(&ts) {
        let f = f.unwrap();
        close_vectors(f.z_axis, c.tangent_at(*t).unwrap(), 1e-13, "tangent");
        close_vectors(f.x_axis.cross(f.y_axis), f.z_axis, 1e-13, "right-handed");
        // In the plane of the circle there is nothing to turn about: the binormal keeps its coordinates.
        close(f.x_axis.dot(Vector3::Z), frames[0].unwrap().x_axis.dot(Vector3::Z), 1e-12, "no twist");
    }
    // The frames of a space curve turn about the tangent at no rate: x' has no part along y.
    let c = wave();
    let h = 1e-4;
    let t = c.domain().at(0.4);
    let f = c.perpendicular_frames(&[t - h, t, t + h]);
    let turn = (f[2].unwrap().x_axis - f[0].unwrap().x_axis).dot(f[1].unwrap().y_axis) / (2.0 * h);
    assert!(turn.abs() < 1e-4, "{turn}");
    let l = line(p(0.0, 0.0, 0.0), p(0.0, 0.0, 5.0));
    let frame = l.perpendicular_frame_at(2.0).unwrap();
    assert_eq!((frame.x_axis, frame.z_axis), (Vector3::X, Vector3::Z));
    assert!(l.horizontal_frame_at(2.0).is_none());
    assert!(c.horizontal_frame_at(2.0).unwrap().y_axis.z.abs() < 1e-15);
}

#[test]
fn regions() {
    let square = Rectangle { plane: Plane::XY, x: Interval::new(1.0, 3.0), y: Interval::new(1.0, 4.0) };
    let c: Curve = square.to_polyline().unwrap().into();
    let (area, center) = c.area_and_centroid(1e-6).unwrap();
    close(area, 6.0, 1e-15, "area");
    close_points(center, p(2.0, 2.5, 0.0), 1e-15, "centroid");
    assert_eq!((square.area(), square.perimeter(), square.center()), (6.0, 10.0, center));
    let at = |x: f64, y: f64| c.contains_in_plane(p(x, y, 7.0), &Plane::XY, 1e-6).unwrap();
    assert_eq!(at(2.0, 2.0), Containment::Inside);
    assert_eq!(at(0.0, 2.0), Containment::Outside);
    assert_eq!(at(3.0, 2.0), Containment::On);
    assert_eq!(at(1.0, 1.0), Containment::On);
    assert_eq!(at(0.0, 1.0), Containment::Outside);
    let disc = circle(2.0);
    let (area, _) = disc.area_and_centroid(1e-6).unwrap();
    close(area, 4.0 * PI, 1e-13, "disc");
    for i in 0..100 {
        let x = f64::from(i) / 25.0;
        let want = if x < 2.0 - 1e-9 {
            Containment::Inside
        } else if x > 2.0 + 1e-9 {
            Containment::Outside
        } else {
            Containment::On
        };
        assert_eq!(disc.contains_in_plane(p(0.0, x, 0.0), &Plane::XY, 1e-9).unwrap(), want, "{x}");
    }
    let blob: Curve = NurbsCurve::periodic_uniform(
        3,
        &[p(0.0, 0.0, 0.0), p(6.0, 0.0, 0.0), p(2.0, 2.0, 0.0), p(0.0, 6.0, 0.0)],
    )
    .unwrap()
    .into();
    let (area, center) = blob.area_and_centroid(1e-6).unwrap();
    let mut sum = 0.0;
    let n = 4000;
    for i in 0..n {
        let q = |k: i32| blob.point_at(blob.domain().at(f64::from(k) / f64::from(n))).to_vector();
        sum += 0.5 * q(i).cross(q(i + 1)).z;
    }
    assert!((sum - area).abs() < 1e-5 * area);
    assert_eq!(blob.contains_in_plane(center, &Plane::XY, 1e-9).unwrap(), Containment::Inside);
    assert_eq!(blob.contains_in_plane(p(6.0, 6.0, 0.0), &Plane::XY, 1e-9).unwrap(), Containment::Outside);
    assert!(wave().area_and_centroid(1e-6).is_err());
    assert!(wave().contains_in_plane(center, &Plane::XY, 1e-6).is_err());
    let hexagon: Curve = regular_polygon(&Plane::XY, 2.0, 6).unwrap().into();
    close(hexagon.length(), 12.0, 1e-14, "hexagon");
    close(hexagon.area_and_centroid(1e-6).unwrap().0, 6.0 * 3f64.sqrt(), 1e-14, "hexagon");
    assert!(regular_polygon(&Plane::XY, 2.0, 2).is_err() && regular_polygon(&Plane::XY, 0.0, 5).is_err());
}

#[test]
fn areas_grow_with_the_determinant() {
    let blob: Curve = NurbsCurve::periodic_uniform(
        3,
        &[p(0.0, 0.0, 0.0), p(6.0, 0.0, 0.0), p(2.0, 2.0, 0.0), p(0.0, 6.0, 0.0)],
    )
    .unwrap()
    .into();
    let far = Xform::translation(Vector3::new(1e5, -1e5, 0.0));
    let shear = Xform::shear(&Plane::XY, [[0.4, 0.0], [-0.3, 0.0], [0.0, 0.0]]);
    for c in [blob, circle(2.0), polyline(&[(0.0, 0.0), (3.0, 1.0), (1.0, 4.0), (0.0, 0.0)])] {
        let (area, center) = c.area_and_centroid(1e-6).unwrap();
        for xform in [far, shear, far * shear] {
            let (image, image_center) = c.transformed(&xform).unwrap().area_and_centroid(1e-6).unwrap();
            close(image, area * xform.determinant(), 1e-8, "area");
            close_points(image_center, xform.point(center), 1e-9, "centroid");
        }
        let (signed, _) = c.signed_area_in(&Plane::XY);
        close(c.reversed().signed_area_in(&Plane::XY).0, -signed, 1e-12, "reversal changes the sign");
    }
}

#[test]
fn circles_and_arcs_from_what_is_known() {
    let c = Circle::through(p(1.0, 0.0, 0.0), p(0.0, 1.0, 0.0), p(-1.0, 0.0, 0.0)).unwrap();
    close_points(c.center(), Point3::ORIGIN, 1e-15, "centre");
    close_points(c.at(0.0), p(1.0, 0.0, 0.0), 1e-15, "angle 0 at the first point");
    let line = |t: f64| p(t, 2.0 * t, -t);
    assert!(Circle::through(line(0.0), line(1.0), line(2.0)).is_err());
    assert!(Circle::through(line(0.0), line(0.0), line(2.0)).is_err());
    assert!(Arc::through(line(0.0), line(1.0), line(2.0)).is_err());
    assert!(Circle::new(Plane::XY, 0.0).is_err() && Circle::new(Plane::XY, f64::NAN).is_err());
    let arc = Arc::from_start_direction_end(p(0.0, 0.0, 0.0), Vector3::Y, p(-2.0, 0.0, 0.0)).unwrap();
    close_points(arc.midpoint(), p(-1.0, 1.0, 0.0), 1e-15, "bends towards the end");
    close(arc.length(), PI, 1e-15, "half a circle");
    let long =
        Arc::from_start_direction_end(p(0.0, 0.0, 0.0), Vector3::new(1.0, -1.0, 0.0), p(-2.0, 0.0, 0.0))
            .unwrap();
    close(long.length(), 1.5 * PI * 2f64.sqrt(), 1e-13, "three quarters");
    assert!(Arc::from_start_direction_end(p(0.0, 0.0, 0.0), Vector3::X, p(2.0, 0.0, 0.0)).is_err());
    assert!(Arc::from_start_direction_end(p(0.0, 0.0, 0.0), Vector3::ZERO, p(2.0, 1.0, 0.0)).is_err());
    let unit = Circle::new(Plane::XY, 1.0).unwrap();
    let back = Arc::new(unit, Interval::new(1.0, 0.0)).unwrap();
    close_points(back.start(), unit.at(1.0), 1e-15, "a reversed range starts at its first angle");
    close_points(back.end(), unit.at(0.0), 1e-15, "and ends at its second");
    assert!(Arc::new(unit, Interval::new(0.0, 99.0)).unwrap().is_circle());
    assert!(Arc::new(unit, Interval::new(1.0, 1.0)).is_err());
    let points: Vec<_> = (0..9)
        .map(|i| {
            Plane::YZ.with_origin(p(1.0, 2.0, 3.0)).at(
                f64::from(i).cos() * 2.0,
                f64::from(i).sin() * 2.0,
                0.0,
            )
        })
        .collect();
    let (fit, deviation) = Circle::fit(&points).unwrap();
    close(fit.radius, 2.0, 1e-12, "fitted radius");
    assert!(deviation < 1e-12);
    close_points(fit.center(), p(1.0, 2.0, 3.0), 1e-12, "fitted centre");
}

#[test]
fn offsets() {
    let square = polyline(&[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0), (0.0, 0.0)]);
    let grown = square.offset_in_plane(&Plane::XY, 1.0).unwrap();
    close(grown.area_and_centroid(1e-6).unwrap().0, 30.0, 1e-14, "counter-clockwise grows");
    assert_eq!(grown.start(), p(-1.0, -1.0, 0.0));
    assert_eq!(grown.domain(), square.domain());
    let shrunk = square.reversed().offset_in_plane(&Plane::XY, 1.0).unwrap();
    close(shrunk.area_and_centroid(1e-6).unwrap().0, 2.0, 1e-14, "clockwise shrinks");
    let open = polyline(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 2.0)])
        .offset_in_plane(&Plane::XY, -0.5)
        .unwrap();
    assert_eq!(
        open.as_polyline().unwrap(),
        [p(0.0, 0.5, 0.0), p(1.0, 0.5, 0.0), p(1.5, 0.5, 0.0), p(1.5, 2.0, 0.0)]
    );
    close(circle(2.0).offset_in_plane(&Plane::XY, 0.5).unwrap().length(), 5.0 * PI, 1e-14, "circle grows");
    assert!(circle(2.0).offset_in_plane(&Plane::XY, -2.0).is_err());
    assert!(circle(2.0).offset_in_plane(&Plane::YZ, 1.0).is_err());
    let l = line(p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0)).offset_in_plane(&Plane::XY, 2.0).unwrap();
    assert_eq!(l.start(), p(0.0, -2.0, 0.0));
    let smooth: Curve = PolyCurve::new(vec![
        line(p(0.0, 0.0, 0.0), p(4.0, 0.0, 0.0)),
        Arc::from_start_direction_end(p(4.0, 0.0, 0.0), Vector3::X, p(6.0, 2.0, 0.0)).unwrap().into(),
    ])
    .unwrap()
    .into();
    close(smooth.offset_in_plane(&Plane::XY, 1.0).unwrap().length(), 4.0 + 1.5 * PI, 1e-14, "line and arc");
    assert!(wave().offset_in_plane(&Plane::XY, 1.0).is_err(), "not planar");
}

#[test]
fn c5_osculating_circles_and_the_curvature_graph() {
    let c = wave();
    let t = c.domain().at(0.37);
    let o = c.osculating_circle_at(t).unwrap();
    close_points(o.at(0.0), c.point_at(t), 1e-12, "through the point");
    let touching: Curve = o.into();
    close_vectors(touching.tangent_at(0.0).unwrap(), c.tangent_at(t).unwrap(), 1e-12, "tangent");
    close_vectors(touching.curvature_at(0.0), c.curvature_at(t), 1e-10, "curvature");
    assert!(line(p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0)).osculating_circle_at(0.5).is_none());
    // A line joined to an arc of radius 2 without a kink: G1 but not G2, so the hair at the joint jumps.
    let joined: Curve = PolyCurve::new(vec![
        line(p(0.0, 0.0, 0.0), p(4.0, 0.0, 0.0)),
        Arc::from_start_direction_end(p(4.0, 0.0, 0.0), Vector3::X, p(6.0, 2.0, 0.0)).unwrap().into(),
    ])
    .unwrap()
    .into();
    let hairs = joined.curvature_graph(8, 10.0);
    assert_eq!(hairs.len(), 18);
    assert_eq!(hairs[8].length(), 0.0);
    close_vectors(hairs[9].direction(), Vector3::new(0.0, -5.0, 0.0), 1e-13, "away from the centre");
}

#[test]
fn c5_the_curvature_is_sampled_by_spans_and_jumps_between_them() {
    let c = wave();
    let spans = c.curvature_samples(6);
    assert_eq!(spans.len(), c.bending_spans());
    assert!(spans.iter().all(|span| span.len() == 7));
    for sample in spans.iter().flat_map(|span| span.iter().skip(1).take(5)) {
        close_points(sample.point, c.point_at(sample.parameter), 1e-12, "on the curve");
        close_vectors(sample.curvature, c.curvature_at(sample.parameter), 1e-9, "curvature");
    }
    let arc: Curve =
        Arc::from_start_direction_end(p(4.0, 0.0, 0.0), Vector3::X, p(6.0, 2.0, 0.0)).unwrap().into();
    let joined: Curve = PolyCurve::new(vec![line(p(0.0, 0.0, 0.0), p(4.0, 0.0, 0.0)), arc]).unwrap().into();
    let spans = joined.curvature_samples(4);
    assert_eq!((joined.bending_spans(), spans.len()), (1, 1), "the line does not bend");
    for sample in &spans[0] {
        close(sample.curvature.length(), 0.5, 1e-13, "1/radius everywhere");
        close_points(sample.point + sample.curvature * 4.0, p(4.0, 2.0, 0.0), 1e-12, "towards the centre");
    }
    let circle: Curve = Circle::new(Plane::XY, 3.0).unwrap().into();
    assert_eq!((circle.bending_spans(), circle.curvature_samples(5)[0].len()), (4, 21));
    let corner = PolylineCurve::new(vec![p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(1.0, 1.0, 0.0)]).unwrap();
    assert!(Curve::from(corner).curvature_samples(5).is_empty());
}

#[test]
fn tangents_of_circles() {
    let a = Circle::new(Plane::XY, 1.0).unwrap();
    let b = Circle::new(Plane::XY.with_origin(p(5.0, 1.0, 0.0)), 2.0).unwrap();
    let touches = |l: &Line, c: &Circle, at: Point3| {
        close(at.distance_to(c.center()), c.radius, 1e-14, "on the circle");
        close(l.direction().dot(at - c.center()), 0.0, 1e-13, "at right angles to the radius");
    };
    for l in a.tangents_from(p(3.0, -2.0, 7.0)).unwrap() {
        assert_eq!(l.from.z, 0.0);
        touches(&l, &a, l.to);
    }
    let [left, right] = a.tangents_from(p(-3.0, 0.0, 0.0)).unwrap();
    assert!(left.to.y > 0.0 && right.to.y < 0.0);
    for pair in [a.outer_tangents(&b).unwrap(), a.inner_tangents(&b).unwrap()] {
        for l in pair {
            touches(&l, &a, l.from);
            touches(&l, &b, l.to);
        }
        assert!(pair[0].from.y > pair[1].from.y);
    }
    assert!(a.tangents_from(p(0.5, 0.0, 0.0)).is_none());
    let inside = Circle::new(Plane::XY, 0.25).unwrap();
    assert!(a.outer_tangents(&inside).is_none() && a.inner_tangents(&inside).is_none());
}

#[test]
fn m9_one_circle_gives_three() {
    let c = Circle::new(Plane::XY, 2.0).unwrap();
    let scaled = c.transformed(&Xform::scale(p(1.0, 0.0, 0.0), 1.5)).unwrap();
    assert_eq!((scaled.radius, scaled.center()), (3.0, p(-0.5, 0.0, 0.0)));
    let turned = c.transformed(&Xform::rotation(FRAC_PI_2, Vector3::Y, Point3::ORIGIN).unwrap()).unwrap();
    close_vectors(turned.plane.z_axis, Vector3::X, 1e-15, "normal turned about y");
    let moved = c.transformed(&Xform::translation(Vector3::new(1.0, 2.0, 3.0))).unwrap();
    assert_eq!((moved.radius, moved.center()), (2.0, p(1.0, 2.0, 3.0)));
    assert!(c.transformed(&Xform::scale_non_uniform(&Plane::XY, 1.0, 2.0, 1.0)).is_none());
}

#[test]
fn sections_with_a_plane() {
    let c = wave();
    let cut = Plane::from_normal(p(3.3, 0.0, 0.0), Vector3::Y).unwrap();
    let ts = c.intersect_plane(&cut, 1e-9).unwrap();
    let n = 20_000;
    let side = |i: i32| c.point_at(c.domain().at(f64::from(i) / f64::from(n))).y > 0.0;
    // The curve starts on the plane: that end is one more.
    let crossings = (1..n).filter(|&i| side(i) != side(i + 1)).count();
    assert_eq!(ts.len(), crossings + 1, "{ts:?}");
    assert!(ts.windows(2).all(|w| w[0] < w[1]));
    for t in &ts {
        assert!(c.point_at(*t).y.abs() < 1e-9);
    }
    let disc = circle(2.0);
    assert_eq!(disc.intersect_plane(&Plane::YZ, 1e-9).unwrap().len(), 2);
    let touching = disc.intersect_plane(&Plane::YZ.with_origin(p(0.0, 2.0, 0.0)).rotated(0.0), 1e-9).unwrap();
    assert_eq!(touching.len(), 2);
    let tangent = Plane::from_normal(p(0.0, 2.0, 0.0), Vector3::Y).unwrap();
    let touch = disc.intersect_plane(&tangent, 1e-9).unwrap();
    assert_eq!(touch.len(), 1, "{touch:?}");
    close_points(disc.point_at(touch[0]), p(0.0, 2.0, 0.0), 1e-6, "touch");
    assert!(
        disc.intersect_plane(&Plane::from_normal(p(0.0, 2.1, 0.0), Vector3::Y).unwrap(), 1e-9)
            .unwrap()
            .is_empty()
    );
    let bent = polyline(&[(0.0, 1.0), (1.0, 0.0), (3.0, 0.0), (4.0, -1.0)]);
    assert_eq!(bent.intersect_plane(&Plane::XZ, 1e-9).unwrap(), vec![1.0, 2.0]);
    let through = polyline(&[(0.0, 1.0), (1.0, 0.0), (2.0, -1.0)]);
    assert_eq!(through.intersect_plane(&Plane::XZ, 1e-9).unwrap(), vec![1.0]);
    assert!(disc.intersect_plane(&Plane::XY, f64::NAN).is_err());
}

#[test]
fn degenerate_curves_are_refused() {
    assert!(PolylineCurve::new(vec![p(0.0, 0.0, 0.0)]).is_err());
    assert!(PolylineCurve::new(vec![p(0.0, 0.0, 0.0), p(f64::NAN, 0.0, 0.0)]).is_err());
    assert!(
        PolylineCurve::with_parameters(vec![p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0)], vec![1.0, 1.0]).is_err()
    );
    assert!(PolyCurve::new(vec![]).is_err());
    let mut deep = circle(1.0);
    for _ in 0..32 {
        deep = PolyCurve::new(vec![deep]).unwrap().into();
    }
    assert!(PolyCurve::new(vec![deep]).is_err());
    let zero = line(p(1.0, 1.0, 1.0), p(1.0, 1.0, 1.0));
    assert_eq!((zero.length(), zero.tangent_at(0.5)), (0.0, None));
    close(zero.closest_point(p(1.0, 1.0, 3.0)).unwrap().distance, 2.0, 1e-15, "zero-length line");
    assert!(zero.to_nurbs().is_ok() && !zero.reversed().is_linear(1e-9));
}
