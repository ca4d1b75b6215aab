//! Functions of meshes.

use std::f64::consts::{PI, TAU};

use katydid_compute::wire::Read;
use katydid_geometry::{BoundingBox, Interval, Mesh, Plane, Point3, Rectangle};
use serde_json::{Value as Json, json};

use crate::helpers::{ask, at, ball, cube, cube_brep, cube_mesh, curves, near, object};

#[test]
fn meshes() {
    let of_ball = ask("mesh/createfrombrep-brep", json!([object(&ball(0.0, 5.0))]));
    let area: f64 = of_ball.as_array().unwrap().iter().map(|m| Mesh::read(m).unwrap().area()).sum();
    assert!((area - 100.0 * PI).abs() < 0.05 * 100.0 * PI, "{area}");
    assert_eq!(ask("mesh/createfrombrep-brep", json!([cube_brep()])).as_array().unwrap().len(), 6);
    let fine = ask(
        "mesh/createfrombrep-brep_meshingparameters",
        json!([object(&ball(0.0, 5.0)), { "Tolerance": 0.001, "RefineGrid": true }]),
    );
    let area: f64 = fine.as_array().unwrap().iter().map(|m| Mesh::read(m).unwrap().area()).sum();
    assert!((area - 100.0 * PI).abs() < 0.2, "{area}");
    let grid = ask(
        "mesh/createfrombox-boundingbox_int_int_int",
        json!([{ "Min": [0, 0, 0], "Max": [1, 1, 1] }, 2, 2, 2]),
    );
    assert_eq!(Mesh::read(&grid).unwrap().faces().len(), 24);
    let corners: Vec<Json> = cube().corners().iter().map(object).collect();
    near(
        &json!(
            Mesh::read(&ask("mesh/createfrombox-point3darray_int_int_int", json!([corners, 2, 1, 3])))
                .unwrap()
                .volume()
        ),
        6.0,
    );
    let sphere = json!({ "Radius": 2, "EquatorialPlane": object(&Plane::XY) });
    assert_eq!(
        Mesh::read(&ask("mesh/createfromsphere-sphere_int_int", json!([sphere, 10, 6])))
            .unwrap()
            .faces()
            .len(),
        60
    );
    let shifted = |x: f64| {
        let shape = BoundingBox { min: Point3::new(x, 0.0, 0.0), max: Point3::new(x + 2.0, 2.0, 2.0) };
        object(&Mesh::cuboid(&shape.into(), 1, 1, 1).unwrap())
    };
    let volume =
        |json: &Json| json.as_array().unwrap().iter().map(|m| Mesh::read(m).unwrap().volume()).sum::<f64>();
    near(
        &json!(volume(&ask("mesh/createbooleanunion-mesharray", json!([[shifted(0.0), shifted(1.0)]])))),
        12.0,
    );
    near(
        &json!(volume(&ask(
            "mesh/createbooleandifference-mesharray_mesharray",
            json!([[shifted(0.0)], [shifted(1.0)]])
        ))),
        4.0,
    );
    near(
        &json!(volume(&ask(
            "mesh/createbooleanintersection-mesharray_mesharray",
            json!([[shifted(0.0)], [shifted(1.0)]])
        ))),
        4.0,
    );
    // A client that sends single meshes for lists.
    near(
        &json!(volume(&ask(
            "mesh/createbooleanintersection-mesharray_mesharray",
            json!([shifted(0.0), shifted(1.0)])
        ))),
        4.0,
    );
    at(&ask("mesh/closestpoint-mesh_point3d", json!([cube_mesh(), [0.5, 0.5, 9]])), [0.5, 0.5, 3.0]);
    let found =
        ask("mesh/closestpoint-mesh_point3d_point3d_vector3d_double", json!([cube_mesh(), [0.5, 0.5, 9], 0]));
    at(&found[2], [0.0, 0.0, 1.0]);
    assert_eq!(
        ask("mesh/closestpoint-mesh_point3d_point3d_double", json!([cube_mesh(), [0.5, 0.5, 9], 1]))[0],
        json!(-1)
    );
    at(
        &ask(
            "mesh/pointat-mesh_int_double_double_double_double",
            json!([cube_mesh(), 4, 0.25, 0.25, 0.25, 0.25]),
        ),
        [0.5, 1.0, 0.0],
    );
    at(
        &ask(
            "mesh/normalat-mesh_int_double_double_double_double",
            json!([cube_mesh(), 4, 0.25, 0.25, 0.25, 0.25]),
        ),
        [0.0, 0.0, -1.0],
    );
    assert_eq!(
        ask(
            "mesh/ispointinside-mesh_point3d_double_bool",
            json!([cube_mesh(), [0.5, 0.5, 0.5], 0.001, true])
        ),
        json!(true)
    );
    let rectangle = Rectangle { plane: Plane::XY, x: Interval::UNIT, y: Interval::UNIT };
    let sheet = object(&Mesh::plane(&rectangle, 2, 2).unwrap());
    let rims = ask("mesh/getnakededges-mesh", json!([sheet]));
    assert_eq!((rims.as_array().unwrap().len(), rims[0].as_array().unwrap().len()), (1, 9));
    assert_eq!(ask("mesh/getnakededges-mesh", json!([cube_mesh()])), Json::Null);
    assert_eq!(
        ask(
            "mesh/split-mesh_plane",
            json!([cube_mesh(), object(&Plane::XY.with_origin(Point3::new(0.0, 0.0, 1.0)))])
        )
        .as_array()
        .unwrap()
        .len(),
        2
    );
    let contour = ask(
        "mesh/createcontourcurves-mesh_plane",
        json!([cube_mesh(), object(&Plane::XY.with_origin(Point3::new(0.0, 0.0, 1.0)))]),
    );
    near(&json!(curves(&contour)[0].length()), 6.0);
    let thick = ask("mesh/offset-mesh_double_bool", json!([sheet, 0.5, true]));
    near(&json!(Mesh::read(&thick).unwrap().volume()), 0.5);
    let shadow = ask("mesh/getoutlines-mesh_plane", json!([cube_mesh(), object(&Plane::XY)]));
    assert_eq!(shadow[0].as_array().unwrap().len(), 5);
    let reduced = ask(
        "mesh/reduce-mesh_int_bool_int_bool",
        json!([object(&Mesh::sphere(&Plane::XY, 2.0, 32, 16).unwrap()), 100, true, 5, false]),
    );
    assert!(Mesh::read(&reduced[1]).unwrap().faces().len() <= 100);
    let kept =
        ask("mesh/createfromfilteredfacelist-mesh_boolarray", json!([sheet, [true, false, false, true]]));
    assert_eq!(Mesh::read(&kept).unwrap().faces().len(), 2);
    let clash =
        ask("intersect/meshclash/search", json!([shifted(0.0), [shifted(1.0), shifted(9.0)], 0.1, 5]));
    assert_eq!(clash.as_array().unwrap().len(), 1);
}

#[test]
fn round_meshes() {
    let mesh = |path: &str, arguments: Json| Mesh::read(&ask(path, arguments)).unwrap();
    // A prism over a regular polygon of n corners: n/2·sin(2π/n)·r² instead of π·r².
    let polygon = |n: f64, r: f64| 0.5 * n * (TAU / n).sin() * r * r;
    let cylinder = json!({ "BasePlane": object(&Plane::XY), "Radius": 2, "Height1": 1, "Height2": 4 });
    near(
        &json!(mesh("mesh/createfromcylinder-cylinder_int_int", json!([cylinder, 2, 16])).volume()),
        3.0 * polygon(16.0, 2.0),
    );
    let open =
        mesh("mesh/createfromcylinder-cylinder_int_int_bool_bool", json!([cylinder, 2, 16, false, false]));
    assert_eq!((open.faces().len(), open.is_closed()), (32, false));
    for height in [3.0, -3.0] {
        let cone = json!({ "Plane": object(&Plane::XY), "Radius": 2, "Height": height });
        near(
            &json!(mesh("mesh/createfromcone-cone_int_int", json!([cone, 3, 16])).volume()),
            polygon(16.0, 2.0),
        );
    }
    // Pappus: a polygon turned about the axis in n steps.
    let torus = json!({ "Plane": object(&Plane::XY), "MajorRadius": 5, "MinorRadius": 1 });
    let torus = mesh("mesh/createfromtorus-torus_int_int", json!([torus, 64, 128]));
    assert!(torus.is_closed() && (torus.volume() - 2.0 * PI * PI * 5.0).abs() < 0.5);
    let sphere = json!({ "Radius": 3, "EquatorialPlane": object(&Plane::XY) });
    for (path, faces) in
        [("mesh/createquadsphere-sphere_int", 6 * 256), ("mesh/createicosphere-sphere_int", 20 * 256)]
    {
        let sphere = mesh(path, json!([sphere, 4]));
        assert!(sphere.is_closed() && sphere.is_oriented() && sphere.faces().len() == faces, "{path}");
        assert!(sphere.vertices().iter().all(|p| (p.to_vector().length() - 3.0).abs() < 1e-12));
        assert!(
            sphere.volume() > 0.98 * 36.0 * PI && sphere.volume() < 36.0 * PI,
            "{path}: {}",
            sphere.volume()
        );
    }
}
