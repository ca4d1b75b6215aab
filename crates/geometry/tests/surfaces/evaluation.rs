//! NURBS surfaces against another kernel's answers, and their laws.

use crate::common::{
    close_curves, close_points, close_surfaces, close_vectors, curve, number, numbers, oracle, plane, point,
    surface, vector,
};
use katydid_geometry::{Direction, NurbsSurface, Point3, Quadrant, Surface, Xform};

#[test]
fn evaluation_agrees() {
    let Some(data) = oracle("on_dev.json") else { return };
    for case in data["surfaces"].as_array().unwrap() {
        let id = case["id"].as_str().unwrap();
        let s = surface(&case["in"]);
        for (d, i) in [(Direction::U, 0), (Direction::V, 1)] {
            let domain = numbers(&case["out"]["Domain"][i]);
            assert_eq!([s.domain(d).start, s.domain(d).end], domain[..], "{id}");
            assert_eq!(s.span_parameters(d), numbers(&case["out"]["SpanVector"][i]), "{id}");
        }
        for e in case["out"]["eval"].as_array().unwrap() {
            let (u, v) = (number(&e["uv"][0]), number(&e["uv"][1]));
            close_points(s.point_at(u, v), point(&e["PointAt"]), 1e-13, id);
            let d = s.derivatives(u, v, 1, Quadrant::NorthEast);
            close_points(d.point(), point(&e["PointAt"]), 1e-13, id);
            let whole = Surface::from(s.clone());
            close_vectors(whole.normal_at(u, v).unwrap(), vector(&e["NormalAt"]), 1e-13, id);
            let (frame, wanted) = (whole.frame_at(u, v).unwrap(), plane(&e["FrameAt"]));
            close_points(frame.origin, wanted.origin, 1e-13, id);
            close_vectors(frame.x_axis, wanted.x_axis, 1e-13, id);
            close_vectors(frame.y_axis, wanted.y_axis, 1e-13, id);
            close_vectors(frame.z_axis, wanted.z_axis, 1e-13, id);
        }
    }
}

#[test]
fn second_derivatives_agree() {
    let Some(data) = oracle("occ_dev.json") else { return };
    for case in data["curvature"].as_array().unwrap() {
        let s = surface(&case["in"]);
        for e in case["eval"].as_array().unwrap() {
            let d = s.derivatives(number(&e["uv"][0]), number(&e["uv"][1]), 2, Quadrant::NorthEast);
            for (k, name) in ["Su", "Sv", "Suu", "Suv", "Svv"].into_iter().enumerate() {
                close_vectors(d.values()[k + 1], vector(&e[name]), 1e-11, name);
            }
        }
    }
}

#[test]
fn constructions_agree() {
    let Some(data) = oracle("on_dev.json") else { return };
    for case in data["surfaces"].as_array().unwrap() {
        let id = case["id"].as_str().unwrap();
        let (s, out) = (surface(&case["in"]), &case["out"]);
        assert_eq!(s.plane(1e-9).is_some(), out["IsPlanar"].as_bool().unwrap(), "{id}");
        for (d, i) in [(Direction::U, 0), (Direction::V, 1)] {
            assert_eq!(s.is_closed(d), out["IsClosed"][i].as_bool().unwrap(), "{id}");
            assert_eq!(s.span_parameters(d).len() as u64 - 1, out["SpanCount"][i].as_u64().unwrap(), "{id}");
        }
        let b = numbers(&out["BBox"]);
        let hull = s.hull_box();
        close_points(hull.min, Point3::new(b[0], b[1], b[2]), 1e-15, id);
        close_points(hull.max, Point3::new(b[3], b[4], b[5]), 1e-15, id);
        for name in ["IsoCurve", "IsoCurve0"] {
            let iso = &out[name];
            let d = Direction::BOTH[iso["dir"].as_u64().unwrap() as usize];
            close_curves(&s.isocurve(d, number(&iso["c"])).unwrap(), &curve(&iso["r"]), 1e-14, id);
        }
        if let Some(x) = out.get("InsertKnotV") {
            let inserted = s.insert_knot(Direction::V, number(&x["t"]), 1).unwrap();
            close_surfaces(&inserted, &surface(&x["r"]), 1e-14, id);
        }
        if let Some(x) = out.get("IncreaseDegreeU") {
            let raised = s.raised_to(Direction::U, s.degree(Direction::U) + 1).unwrap();
            close_surfaces(&raised, &surface(&x["r"]), 1e-14, id);
        }
        if let Some(x) = out.get("Transform") {
            let m = numbers(&x["x"]);
            let xform =
                Xform { rows: [0, 1, 2, 3].map(|i| [m[4 * i], m[4 * i + 1], m[4 * i + 2], m[4 * i + 3]]) };
            close_surfaces(&s.transformed(&xform).unwrap(), &surface(&x["r"]), 1e-14, id);
        }
    }
}

#[test]
fn ruled_surfaces_agree() {
    let Some(data) = oracle("on_dev.json") else { return };
    for case in data["primitives"].as_array().unwrap() {
        if case["in"]["f"] == "CreateRuledSurface" {
            let ruled = NurbsSurface::ruled(&curve(&case["in"]["a"]), &curve(&case["in"]["b"])).unwrap();
            close_surfaces(&ruled, &surface(&case["out"]["Nurbs"]), 1e-14, case["id"].as_str().unwrap());
        }
    }
}
