//! Functions of intersections, rays and projections.

use std::f64::consts::TAU;

use katydid_geometry::{Curve, Interval, Plane, PlaneSurface, Point3, Surface};
use serde_json::{Value as Json, json};

use crate::helpers::{ask, at, ball, c1, cube_brep, cube_mesh, curves, floor, line, near, object};

#[test]
fn intersections_of_curves() {
    let events =
        ask("intersect/intersection/curvecurve-curve_curve_double_double", json!([c1(), line(), 0.001, 0.0]));
    let events = events.as_array().unwrap();
    assert_eq!(events.len(), 2);
    at(&events[0]["PointA"], [5.0, 0.0, 0.0]);
    near(&events[0]["ParameterB"], 15.0);
    let same =
        ask("intersect/intersection/curvecurve-curve_curve_double_double", json!([c1(), c1(), 0.001, 0.0]));
    assert_eq!(same[0]["IsOverlap"], json!(true));
    let through = ask(
        "intersect/intersection/curveline-curve_line_double_double",
        json!([c1(), { "From": [0, 0, 0], "To": [1, 0, 0] }, 0.001, 0]),
    );
    assert_eq!(through.as_array().unwrap().len(), 2);
    near(&through[1]["ParameterB"], -5.0);
    let plane =
        ask("intersect/intersection/curveplane-curve_plane_double", json!([c1(), object(&Plane::YZ), 0.001]));
    assert_eq!(plane.as_array().unwrap().len(), 2);
    let none = ask(
        "intersect/intersection/curveplane-curve_plane_double",
        json!([c1(), object(&Plane::XY.with_origin(Point3::new(0.0, 0.0, 1.0))), 0.001]),
    );
    assert_eq!(none, Json::Null);
    let brep = ask(
        "intersect/intersection/curvebrep-curve_brep_double_curvearray_point3darray",
        json!([line(), object(&ball(0.0, 5.0)), 0.001]),
    );
    assert_eq!(
        (&brep[0], brep[1].as_array().unwrap().len(), brep[2].as_array().unwrap().len()),
        (&json!(true), 0, 2)
    );
    let parameters = ask(
        "intersect/intersection/curvebrep-curve_brep_double_double_doublearray",
        json!([line(), object(&ball(0.0, 5.0)), 0.001, 0.01]),
    );
    near(&parameters[1][0], 5.0);
    let wall = ask(
        "intersect/intersection/curvesurface-curve_surface_double_double",
        json!([[[1, 1, -1], [1, 1, 1]], object(&floor()), 0.001, 0]),
    );
    near(&wall[0]["SurfaceU"], 1.0);
    let section = ask(
        "intersect/intersection/brepplane-brep_plane_double_curvearray_point3darray",
        json!([object(&ball(0.0, 5.0)), object(&Plane::XY), 0.001]),
    );
    near(&json!(curves(&section[1]).iter().map(Curve::length).sum::<f64>()), TAU * 5.0);
    // Balls of radius 5, 6 apart: a circle of radius 4.
    let balls = ask(
        "intersect/intersection/brepbrep-brep_brep_double_curvearray_point3darray",
        json!([object(&ball(0.0, 5.0)), object(&ball(6.0, 5.0)), 0.001]),
    );
    assert_eq!((&balls[0], balls[2].as_array().unwrap().len()), (&json!(true), 0));
    near(&json!(curves(&balls[1]).iter().map(Curve::length).sum::<f64>()), TAU * 4.0);
    let cut = ask(
        "intersect/intersection/brepsurface-brep_surface_double_curvearray_point3darray",
        json!([object(&ball(0.0, 1.0)), object(&floor()), 0.001]),
    );
    assert!(!curves(&cut[1]).is_empty());
}

#[test]
fn rays_and_projections() {
    let ray = json!({ "Position": { "X": 0.5, "Y": 0.5, "Z": 5 }, "Direction": { "X": 0, "Y": 0, "Z": -1 } });
    near(&ask("intersect/intersection/meshray-mesh_ray3d", json!([cube_mesh(), ray])), 2.0);
    let away = json!({ "Position": [9, 9, 9], "Direction": [0, 0, 1] });
    near(&ask("intersect/intersection/meshray-mesh_ray3d", json!([cube_mesh(), away])), -1.0);
    let shot = json!({ "Position": [0, 0, 20], "Direction": [0, 0, -1] });
    let hits = ask(
        "intersect/intersection/rayshoot-ray3d_geometrybasearray_int",
        json!([shot, [object(&ball(0.0, 5.0))], 1]),
    );
    at(&hits[0], [0.0, 0.0, 5.0]);
    // Between two walls a slanted ray goes to and fro.
    let wall = |z: f64| {
        let plane = Plane::XY.with_origin(Point3::new(-50.0, -50.0, z));
        object(&Surface::from(
            PlaneSurface::new(plane, Interval::new(0.0, 100.0), Interval::new(0.0, 100.0)).unwrap(),
        ))
    };
    let slanted = json!({ "Position": [0, 0, 0.5], "Direction": [1, 0, 1] });
    let bounced = ask(
        "intersect/intersection/rayshoot-geometrybasearray_ray3d_int",
        json!([[wall(0.0), wall(1.0)], slanted, 3]),
    );
    at(&bounced[0], [0.5, 0.0, 1.0]);
    at(&bounced[1], [1.5, 0.0, 0.0]);
    at(&bounced[2], [2.5, 0.0, 1.0]);
    let dropped = ask(
        "intersect/intersection/projectpointstobreps-breparray_point3darray_vector3d_double",
        json!([[cube_brep()], [[0.5, 0.5, 9]], [0, 0, -1], 0.001]),
    );
    assert_eq!(dropped.as_array().unwrap().len(), 2);
    at(&dropped[0], [0.5, 0.5, 3.0]);
    let onto = ask(
        "intersect/intersection/projectpointstomeshesex-mesharray_point3darray_vector3d_double_intarray",
        json!([[cube_mesh()], [[9, 9, 9], [0.5, 0.4, 9]], [0, 0, -1], 0.001]),
    );
    assert_eq!(onto[1], json!([1, 1]));
    let line = ask(
        "intersect/intersection/meshline-mesh_line_intarray",
        json!([cube_mesh(), { "From": [0.3, 0.4, -1], "To": [0.3, 0.4, 9] }]),
    );
    assert_eq!(line[0].as_array().unwrap().len(), 2);
}
