//! What other kernels answer: tangents, curvatures, frames, conics, lengths and nearest points.

use crate::common::{
    self, close, close_curves, close_points, close_vectors, curve, number, plane, point, vector,
};
use crate::made::p;
use katydid_geometry::{Arc, ArcCurve, Circle, Curve, Interval};
use std::f64::consts::TAU;

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
