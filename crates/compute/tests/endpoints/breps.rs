//! Functions of breps.

use std::f64::consts::{PI, TAU};

use katydid_compute::Cause;
use katydid_compute::wire::Read;
use katydid_geometry::{Brep, Plane, Vector3};
use serde_json::{Value as Json, json};

use crate::helpers::{ask, at, c1, circle, cube_brep, curves, line, near, number, object, refused, square};

#[test]
fn breps() {
    let loft = ask(
        "brep/createfromloft-curvearray_point3d_point3d_lofttype_bool",
        json!([
            [
                c1(),
                object(
                    &circle(0.0, 5.0)
                        .transformed(&katydid_geometry::Xform::translation(Vector3::new(0.0, 0.0, 4.0)))
                        .unwrap()
                )
            ],
            [0, 0, 0],
            [0, 0, 0],
            0,
            false
        ]),
    );
    near(&ask("brep/getarea-brep", json!([loft[0]])), TAU * 5.0 * 4.0);
    let capped = ask("brep/capplanarholes-brep_double", json!([loft[0], 0.001]));
    near(&ask("brep/getvolume-brep", json!([capped])), PI * 25.0 * 4.0);
    assert_eq!(ask("brep/capplanarholes-brep_double", json!([cube_brep(), 0.001])), Json::Null);
    let flat = ask("brep/createplanarbreps-curvearray", json!([[c1()]]));
    near(&ask("brep/getarea-brep", json!([flat[0]])), PI * 25.0);
    assert_eq!(ask("brep/createplanarbreps-curve", json!([line()])), Json::Null);
    let pipe = ask(
        "brep/createpipe-curve_double_bool_pipecapmode_bool_double_double",
        json!([line(), 1.0, false, 0, false, 0.01, 0.01]),
    );
    near(&ask("brep/getarea-brep", json!([pipe[0]])), TAU * 20.0);
    let swept = ask(
        "brep/createfromsweep-curve_curve_bool_double",
        json!([[[0, 0, 0], [0, 0, 4]], c1(), false, 0.01]),
    );
    near(&ask("brep/getarea-brep", json!([swept[0]])), TAU * 5.0 * 4.0);
    let tipped = ask(
        "brep/createfromloft-curvearray_point3d_point3d_lofttype_bool",
        json!([[object(&circle(0.0, 5.0))], { "X": 0, "Y": 0, "Z": 12 }, null, 3, false]),
    );
    near(&ask("brep/getarea-brep", json!([tipped[0]])), PI * 5.0 * 13.0);
    let unrollable = ask(
        "brep/createdevelopableloft-curve_curve_bool_bool_int",
        json!([[[0, 0, 0], [4, 0, 0]], [[2, 1, 0], [0, 1, 0]], false, true, 50]),
    );
    near(&ask("brep/getarea-brep", json!([unrollable[0]])), 3.0);
    let fixed = ask(
        "brep/createdevelopableloft-nurbscurve_nurbscurve_point2darray",
        json!([[[0, 0, 0], [4, 0, 0]], [[0, 1, 0], [2, 1, 0]], [{ "X": 0.25, "Y": 0.75 }]]),
    );
    near(&ask("brep/getarea-brep", json!([fixed[0]])), 3.0);
    let four = ask(
        "brep/createfromcornerpoints-point3d_point3d_point3d_point3d_double",
        json!([[0, 0, 0], [2, 0, 0], [2, 3, 0], [0, 3, 0], 0.001]),
    );
    near(&ask("brep/getarea-brep", json!([four])), 6.0);
    assert_eq!(
        ask(
            "brep/ispointinside-brep_point3d_double_bool",
            json!([cube_brep(), [0.5, 0.5, 0.5], 0.001, false])
        ),
        json!(true)
    );
    assert_eq!(
        ask("brep/ispointinside-brep_point3d_double_bool", json!([cube_brep(), [0, 0.5, 0.5], 0.001, true])),
        json!(false)
    );
    at(&ask("brep/closestpoint-brep_point3d", json!([cube_brep(), [0.5, 0.5, 9]])), [0.5, 0.5, 3.0]);
    assert_eq!(ask("brep/getwireframe-brep_int", json!([cube_brep(), -1])).as_array().unwrap().len(), 12);
    let contours = ask(
        "brep/createcontourcurves-brep_point3d_point3d_double",
        json!([cube_brep(), [0, 0, 0.5], [0, 0, 2.5], 1]),
    );
    assert_eq!(curves(&contours).iter().map(|c| c.length().round() as i32).collect::<Vec<_>>(), [6, 6, 6]);
    let halves = [square(1.0), json!([[1, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0], [1, 0, 0]])]
        .map(|outline| ask("brep/createplanarbreps-curve", json!([outline]))[0].clone());
    let joined = ask("brep/joinbreps-breparray_double", json!([halves, 0.001]));
    assert_eq!(joined.as_array().unwrap().len(), 1);
    let merged = ask("brep/mergecoplanarfaces-brep_double", json!([joined[0], 0.001]));
    assert_eq!((&merged[0], Brep::read(&merged[1]).unwrap().faces().len()), (&json!(true), 1));
    let whole = ask(
        "brep/createplanarunion-brep_brep_plane_double",
        json!([halves[0], halves[1], object(&Plane::XY), 0.001]),
    );
    near(&ask("brep/getarea-brep", json!([whole[0]])), 2.0);
    let cut = ask(
        "brep/createplanardifference-brep_brep_plane_double",
        json!([flat[0], halves[0], object(&Plane::XY), 0.001]),
    );
    near(&ask("brep/getarea-brep", json!([cut[0]])), PI * 25.0 - 1.0);
    let patch = ask("brep/createpatch-geometrybasearray_int_int_double", json!([[c1()], 8, 8, 0.01]));
    assert!((number(&ask("brep/getarea-brep", json!([patch]))) - PI * 25.0).abs() < 0.1);
}

#[test]
fn a_face_is_split_along_curves() {
    let face = ask("brep/createplanarbreps-curve", json!([square(4.0)]))[0].clone();
    let cuts = json!([[[-1, 2, 0], [5, 2, 0]], [[2, 2, 0], [2, 5, 0]]]);
    let split = ask("brepface/split-brepface_curvearray_double", json!([face, cuts, 0.001]));
    assert_eq!(Brep::read(&split).unwrap().faces().len(), 3);
    near(&ask("brep/getarea-brep", json!([split])), 16.0);
}

#[test]
fn edges_are_rounded() {
    let path = "brep/createfilletedges-brep_intarray_doublearray_doublearray_blendtype_railtype_double";
    let volume = |blend: &str, rail: &str| {
        let made = ask(path, json!([cube_brep(), [0], [0.25], [0.25], blend, rail, 0.001]));
        assert_eq!(made.as_array().unwrap().len(), 1);
        let made = Brep::read(&made[0]).unwrap();
        (made.faces().len(), made.volume_properties(1e-9, || true).unwrap().amount)
    };
    let whole = Brep::read(&cube_brep()).unwrap();
    let length = whole.edge_as_curve(0).unwrap().unwrap().length();
    let whole = whole.volume_properties(1e-9, || true).unwrap().amount;
    let (faces, round) = volume("Fillet", "RollingBall");
    assert_eq!(faces, 7);
    near(&json!(whole - round), (1.0 - PI / 4.0) * 0.0625 * length);
    near(&json!(whole - volume("Chamfer", "DistanceFromEdge").1), 0.5 * 0.0625 * length);
    let two = refused(path, json!([cube_brep(), [0], [0.25], [0.5], 1, 1, 0.001]));
    assert!(matches!(two.cause, Cause::NotSupported(_)));
    assert!(
        refused(path, json!([cube_brep(), [99], [0.25], [0.25], 1, 1, 0.001])).message.contains("edge 99")
    );
    assert!(
        refused(path, json!([cube_brep(), [0, 1], [0.25], [0.25], 1, 1, 0.001])).message.contains("radius")
    );
}
