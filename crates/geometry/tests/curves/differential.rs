//! Tangents, curvature, torsion, continuity and frames.

use crate::common::{close, close_points, close_vectors};
use crate::made::{chain, circle, line, p, polyline, wave};
use katydid_geometry::{
    Arc, Circle, Curve, NurbsCurve, Plane, Point3, PolyCurve, PolylineCurve, Tolerance, Vector3,
};
use std::f64::consts::TAU;

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
