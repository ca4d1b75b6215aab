//! Corners where rounded edges of mixed convexity or of different radii meet, against closed forms.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

use std::f64::consts::{FRAC_PI_2, PI};

use katydid_geometry::brep::{FilletBlend, FilletRail};
use katydid_geometry::construct;
use katydid_geometry::{
    Box3, Brep, Curve, Interval, MeshSettings, Plane, Point3, PolylineCurve, Tolerance, Vector3,
};

const TOLERANCE: Tolerance = Tolerance { absolute: 0.001, angle: PI / 180.0 };
/// What an arc of radius 1 in a right angle leaves of the square.
const GAP: f64 = 1.0 - PI / 4.0;
/// What is left beside an arc of radius 1, squared and summed over its height.
const SQUARES: f64 = 5.0 / 3.0 - FRAC_PI_2;
const ELL: [(f64, f64); 6] = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)];

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn cuboid(a: f64, b: f64, c: f64) -> Brep {
    let [x, y, z] = [a, b, c].map(|n| Interval::new(0.0, n));
    construct::box_brep(&Box3 { plane: Plane::XY, x, y, z }).unwrap()
}

fn prism(corners: &[(f64, f64)], height: f64) -> Brep {
    let mut points: Vec<Point3> = corners.iter().map(|(x, y)| p(*x, *y, 0.0)).collect();
    points.push(points[0]);
    let profile: Curve = PolylineCurve::new(points).unwrap().into();
    construct::extrude(&profile, Vector3::Z * height, true, &TOLERANCE).unwrap()
}

/// Every edge with the radius that a rule gives for its middle.
fn radii(brep: &Brep, rule: impl Fn(Point3) -> Option<f64>) -> Vec<(usize, f64)> {
    let middle = |edge: usize| brep.edge_point(edge, brep.edges()[edge].part.domain.middle()).unwrap();
    (0..brep.edges().len()).filter_map(|edge| Some((edge, rule(middle(edge))?))).collect()
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

fn rounded(brep: &Brep, edges: &[(usize, f64)]) -> katydid_geometry::Result<Brep> {
    brep.filleted(edges, FilletBlend::Arc, FilletRail::RollingBall, &TOLERANCE)
}

/// A sound, closed brep whose mesh is closed too, of a volume.
fn holds(brep: &Brep, volume: f64, within: f64) {
    assert_eq!(brep.faults(), []);
    assert!(brep.is_solid());
    let found = brep.volume_properties(1e-12, || true).unwrap().amount;
    assert!((found - volume).abs() <= within * volume, "{found} instead of {volume}: {:e}", found - volume);
    let mesh = brep.mesh(&MeshSettings::default()).unwrap().welded().unwrap();
    assert!(mesh.is_closed());
    assert!(mesh.volume() > 0.0 && (mesh.volume() - volume).abs() < 0.1 * volume);
    let worst = (0..brep.edges().len()).map(|edge| brep.edge_deviation(edge).unwrap()).fold(0.0, f64::max);
    assert!(worst <= TOLERANCE.absolute, "an edge lies {worst} off");
}

/// The volume of a prism whose upright edges are rounded with one radius and those of top and bottom with another: the
/// area at a depth is that of the rounded outline, inset, A − P s + π s².
fn rounded_prism(corners: &[(f64, f64)], height: f64, upright: f64, flat: f64) -> f64 {
    let count = corners.len();
    let at = |k: usize| corners[k % count];
    let area: f64 = (0..count).map(|k| at(k).0 * at(k + 1).1 - at(k + 1).0 * at(k).1).sum::<f64>() / 2.0;
    let length: f64 = (0..count).map(|k| (at(k).0 - at(k + 1).0).hypot(at(k).1 - at(k + 1).1)).sum();
    let turn = |k: usize| {
        let (a, b, c) = (at(k), at(k + 1), at(k + 2));
        ((b.0 - a.0) * (c.1 - b.1) - (b.1 - a.1) * (c.0 - b.0)).signum()
    };
    let turns: f64 = (0..count).map(turn).sum();
    let area = area - turns * GAP * upright * upright;
    let length = length - count as f64 * (2.0 - FRAC_PI_2) * upright;
    height * area - 2.0 * length * GAP * flat * flat + 2.0 * PI * flat * flat * flat * SQUARES
}

#[test]
fn every_edge_of_a_bracket() {
    let bracket = prism(&ELL, 3.0);
    for r in [0.1, 0.4, 0.9] {
        let made = rounded(&bracket, &radii(&bracket, |_| Some(r))).unwrap();
        holds(&made, rounded_prism(&ELL, 3.0, r, r), 1e-11);
        assert_eq!(made.faces().len(), 8 + 18 + 10 + 2);
    }
    for (upright, flat) in [(0.5, 0.2), (0.9, 0.7)] {
        let all = radii(&bracket, |m| Some(if near(m.z, 1.5) { upright } else { flat }));
        holds(&rounded(&bracket, &all).unwrap(), rounded_prism(&ELL, 3.0, upright, flat), 1e-11);
    }
}
