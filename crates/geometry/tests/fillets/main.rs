//! Rounded edges of breps against closed forms.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

mod corners;
mod edges;

use std::f64::consts::PI;

use katydid_geometry::construct;
use katydid_geometry::{
    Box3, Brep, Curve, Interval, MeshSettings, Plane, Point3, PolylineCurve, Tolerance, Vector3,
};

const TOLERANCE: Tolerance = Tolerance { absolute: 0.001, angle: PI / 180.0 };
/// What an arc of radius 1 in a right angle leaves of the square.
const GAP: f64 = 1.0 - PI / 4.0;
const ELL: [(f64, f64); 6] = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)];

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn cuboid(a: f64, b: f64, c: f64) -> Brep {
    let [x, y, z] = [a, b, c].map(|n| Interval::new(0.0, n));
    construct::box_brep(&Box3 { plane: Plane::XY, x, y, z }).unwrap()
}

fn outline(corners: &[(f64, f64)]) -> Curve {
    let mut points: Vec<Point3> = corners.iter().map(|(x, y)| p(*x, *y, 0.0)).collect();
    points.push(points[0]);
    PolylineCurve::new(points).unwrap().into()
}

fn prism(corners: &[(f64, f64)], height: f64) -> Brep {
    construct::extrude(&outline(corners), Vector3::Z * height, true, &TOLERANCE).unwrap()
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
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
