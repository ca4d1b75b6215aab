//! Surfaces without trims.

use katydid_geometry::{Direction, Surface};
use serde_json::{Value, json};

use crate::numbers::point;

pub(crate) fn surface(surface: &Surface) -> Value {
    let domains = Direction::BOTH.map(|d| surface.domain(d));
    let at = [0.0, 0.3, 0.5, 1.0];
    let samples: Vec<[f64; 3]> = at
        .iter()
        .flat_map(|x| at.map(|y| point(surface.point_at(domains[0].at(*x), domains[1].at(y)))))
        .collect();
    let kind = match surface {
        Surface::Plane(_) => "plane",
        Surface::Sum(_) => "sum",
        Surface::Revolution(_) => "revolution",
        Surface::Nurbs(_) => "nurbs",
    };
    let mut detail = json!({"kind": kind, "domains": domains.map(|d| [d.start, d.end]), "samples": samples});
    if let Surface::Nurbs(s) = surface {
        detail["degrees"] = json!(s.degrees());
        detail["knots"] = json!(Direction::BOTH.map(|d| s.knots(d)));
        detail["points"] = json!(s.homogeneous_points());
    }
    detail
}
