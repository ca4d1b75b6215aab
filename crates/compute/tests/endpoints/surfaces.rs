//! Functions of surfaces and NURBS.

use std::f64::consts::{PI, TAU};

use katydid_compute::wire::Read;
use katydid_geometry::{Curve, Mesh, Plane, Point3, Surface};
use serde_json::{Value as Json, json};

use crate::helpers::{ask, at, ball, c1, cube_mesh, floor, near, object};

#[test]
fn surfaces_and_nurbs() {
    let ruled = ask(
        "nurbssurface/createfromcorners-point3d_point3d_point3d_point3d",
        json!([[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0]]),
    );
    near(&ask("areamassproperties/compute-surface", json!([ruled]))["Area"], 12.0);
    let found =
        ask("surface/closestpoint-surface_point3d_double_double", json!([object(&floor()), [1, 2, 5]]));
    assert_eq!(found, json!([true, 1.0, 2.0]));
    let wall = ask("surface/createextrusion-curve_vector3d", json!([c1(), [0, 0, 2]]));
    near(&ask("areamassproperties/compute-surface", json!([wall]))["Area"], TAU * 10.0);
    let cone = ask("surface/createextrusiontopoint-curve_point3d", json!([c1(), [0, 0, 12]]));
    near(&ask("areamassproperties/compute-surface", json!([cone]))["Area"], PI * 5.0 * 13.0);
    let up = ask("surface/offset-surface_double_double", json!([object(&floor()), 2, 0.001]));
    at(&object(&Surface::read(&up).unwrap().point_at(1.0, 1.0)), [1.0, 1.0, 2.0]);
    let path = ask(
        "surface/shortpath-surface_point2d_point2d_double",
        json!([object(&floor()), { "X": 0, "Y": 0 }, { "X": 4, "Y": 3 }, 0.001]),
    );
    near(&json!(Curve::read(&path).unwrap().length()), 5.0);
    assert_eq!(ask("surface/closestside-surface_double_double", json!([object(&floor()), 0.5, 1.5])), 3);
    // A flat spiral of constant growth, and a helix: length √((2πr)² + pitch²) a turn.
    let helix = ask(
        "nurbscurve/createspiral-point3d_vector3d_point3d_double_double_double_double",
        json!([[0, 0, 0], [0, 0, 1], [1, 0, 0], 3, 4, 2, 2]),
    );
    near(&json!(Curve::read(&helix).unwrap().length()), 4.0 * (TAU * 2.0).hypot(3.0));
    at(&object(&Curve::read(&helix).unwrap().end()), [2.0, 0.0, 12.0]);
    let arch = Curve::read(&ask(
        "nurbscurve/createparabolafromvertex-point3d_point3d_point3d",
        json!([[0, 0, 0], [-1, 1, 0], [2, 4, 0]]),
    ))
    .unwrap();
    for k in 0..=8 {
        let p = arch.point_at(arch.domain().at(f64::from(k) / 8.0));
        assert!((p.y - p.x * p.x).abs() < 1e-9, "{p:?}");
    }
    let points: Vec<Json> = (0..16).map(|i| json!([i / 4, i % 4, (i * 7) % 3])).collect();
    let through = ask(
        "nurbssurface/createthroughpoints-point3darray_int_int_int_int_bool_bool",
        json!([points, 4, 4, 3, 3, false, false]),
    );
    let through = Surface::read(&through).unwrap();
    for point in &points {
        assert!(through.closest_point(Point3::read(point).unwrap()).unwrap().distance < 1e-9);
    }
    let plane = ask(
        "nurbssurface/createfromplane-plane_interval_interval_int_int_int_int",
        json!([object(&Plane::XY), { "T0": 0, "T1": 4 }, { "T0": 1, "T1": 3 }, 3, 2, 6, 5]),
    );
    at(&object(&Surface::read(&plane).unwrap().point_at(1.5, 2.5)), [1.5, 2.5, 0.0]);
    assert_eq!(ask("brepface/ispointonface-brepface_double_double", json!([object(&floor()), 1, 1])), 1);
    assert_eq!(ask("brepface/ispointonface-brepface_double_double", json!([object(&floor()), 9, 1])), 0);
    let bounds = ask("geometrybase/getboundingbox-geometrybase_bool", json!([object(&ball(0.0, 5.0)), true]));
    at(&bounds["Max"], [5.0, 5.0, 5.0]);
    assert_eq!(
        ask("geometrybase/geometryequals-geometrybase_geometrybase", json!([c1(), c1()])),
        json!(true)
    );
    let subd = ask("subd/createfrommesh-mesh", json!([cube_mesh()]));
    assert!(Mesh::read(&ask("mesh/createfromsubd-subd_int", json!([subd, 2]))).unwrap().is_closed());
}
