//! NURBS surfaces against another kernel's answers, and their laws.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

mod common;

use common::{close_points, close_vectors, number, numbers, oracle, point, surface, vector};
use katydid_geometry::{Direction, Quadrant};

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
            let n = d.get(1, 0).cross(d.get(0, 1)).unitized().unwrap();
            close_vectors(n, vector(&e["NormalAt"]), 1e-12, id);
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
