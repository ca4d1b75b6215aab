//! The table itself: overloads, several calls in a body, faults and pages.

use std::time::{Duration, Instant};

use katydid_component::Limits;
use katydid_compute::{Bounds, Cause, geometry};
use katydid_geometry::{Mesh, Plane};
use serde_json::{Value as Json, json};

use crate::helpers::{ask, asked_with, at, c1, c2, cube_brep, cube_mesh, line, near, object, refused};

#[test]
fn several_calls_in_one_body_and_chosen_members() {
    let twice =
        asked_with("areamassproperties/compute-curve", &[("multiple", "true")], &json!([[c1()], [c2()]]))
            .unwrap();
    assert_eq!(twice.as_array().unwrap().len(), 2);
    at(&twice[1]["Centroid"], [3.0, 0.0, 0.0]);
    let chosen = [("return.Rhino.Geometry.AreaMassProperties", "Area,Centroid")];
    let only = asked_with("areamassproperties/compute-curve", &chosen, &json!([c1()])).unwrap();
    assert_eq!(only.as_object().unwrap().len(), 2);
    assert!(asked_with("curve/getlength-curve", &[("stopat", "1")], &json!([c1()])).unwrap().is_number());
    let fault =
        asked_with("curve/getlength-curve", &[("multiple", "true")], &json!([[c1()], [1]])).unwrap_err();
    assert!(fault.message.starts_with("call 1: this is"), "{fault}");
}

#[test]
fn a_path_without_types_is_the_overload_that_fits() {
    near(
        &ask("brep/createplanarbreps", json!([[c1()]])).as_array().map_or(json!(0), |b| json!(b.len())),
        1.0,
    );
    near(&ask("areamassproperties/compute", json!([cube_brep()]))["Area"], 22.0);
    near(&ask("areamassproperties/compute", json!([cube_mesh()]))["Area"], 22.0);
    near(&ask("curve/getlength", json!([line(), { "T0": 0, "T1": 5 }])), 5.0);
    assert_eq!(refused("curve/createbooleanunion", json!([])).cause, Cause::BadRequest);
}

#[test]
fn faults_name_what_is_wrong() {
    assert_eq!(refused("curve/nosuch-curve", json!([])).cause, Cause::NotFound);
    let shell = "brep/createshell-brep_intarray_double_double";
    assert_eq!(refused(shell, json!([cube_brep(), [0], 0.1, 0.01])).cause, Cause::NotSupported(shell.into()));
    let message = |path: &str, arguments: Json| refused(path, arguments).message;
    assert_eq!(message("curve/getlength-curve", json!([])), "this is missing");
    assert!(message("curve/getlength-curve", json!([cube_mesh()])).contains("Mesh"));
    assert!(
        message("curve/closestpoint-curve_point3d_double", json!([c1(), ["NaN", 0, 0]]))
            .starts_with("testPoint is")
    );
    assert!(
        message("curve/createbooleanunion-curvearray_double", json!([[c1()], -1]))
            .starts_with("tolerance is -1")
    );
    assert!(
        message("curve/createbooleanunion-curvearray", json!([[]])).starts_with("curves is an empty list")
    );
    assert!(
        message("curve/dividebycount-curve_int_bool", json!([c1(), 2_000_000_000, true]))
            .starts_with("segmentCount")
    );
    let url = refused("curve/getlength-curve", json!([{ "url": "http://169.254.169.254/" }]));
    assert_eq!(url.cause, Cause::Refused);
    let big = refused(
        "mesh/createfromsphere-sphere_int_int",
        json!([{ "Radius": 2, "EquatorialPlane": object(&Plane::XY) }, 1_000_000, 1_000_000]),
    );
    assert_eq!(big.cause, Cause::TooLarge);
    let fault = |body: &[u8]| {
        geometry::call("curve/getlength-curve", &geometry::Query::default(), body, &Bounds::default())
            .unwrap_err()
    };
    assert!(fault(b"{}").message.contains("not a list"));
    assert!(fault(b"[1e999]").message.contains("not JSON"));
    assert!(fault("[".repeat(100_000).as_bytes()).message.contains("not JSON"));
    assert_eq!(fault(b"").message, "this is missing");
}

#[test]
fn pages_explain_paths() {
    let table = geometry::endpoints();
    let page = table.help("/rhino/geometry/curve/getlength").unwrap();
    assert!(page.contains("curve/getlength-curve_double") && page.contains("System.Double"));
    assert!(table.help("brep/createshell").unwrap().contains("Not supported yet"));
    assert!(table.index().contains("href=\"/rhino/geometry/mesh/createfrombrep-brep\""));
    assert!(table.help("nothing/here").is_err());
}

#[test]
fn what_does_not_answer_is_what_the_list_says() {
    let table = geometry::endpoints();
    let answered: Vec<&str> = table.answered().collect();
    let missing: Vec<&str> = table.paths().filter(|path| !answered.contains(path)).collect();
    let expected: Vec<&str> = NOT_YET.lines().filter(|line| !line.is_empty()).collect();
    assert_eq!(missing, expected, "{} of {} answer", answered.len(), answered.len() + missing.len());
}

/// The paths that are known and do not answer. This list only gets shorter.
const NOT_YET: &str = include_str!("not_yet.txt");

#[test]
fn a_call_ends_when_its_time_is_over_or_nobody_waits() {
    let call = |bounds: &Bounds, path: &str, body: &Json, query: &[(&str, &str)]| {
        let query = geometry::Query::read(query.iter().copied()).unwrap();
        geometry::call(path, &query, body.to_string().as_bytes(), bounds).unwrap_err().cause
    };
    let limits = Limits { time: Some(Duration::ZERO), ..Limits::default() };
    let late = Bounds { limits, ..Bounds::default() };
    let length = json!([c1()]);
    assert_eq!(call(&late, "curve/getlength-curve", &length, &[]), Cause::TimedOut);
    // No other overload is tried then, and nothing is said of the arguments.
    assert_eq!(call(&late, "curve/getlength", &length, &[]), Cause::TimedOut);
    let left = Bounds::default();
    left.cancel.cancel();
    assert_eq!(call(&left, "curve/getlength-curve", &length, &[]), Cause::Cancelled);
    // A million points take longer than this: it ends between two of them.
    let limits = Limits { time: Some(Duration::from_millis(300)), ..Limits::default() };
    let short = Bounds { limits, ..Bounds::default() };
    let ball = object(&Mesh::sphere(&Plane::XY, 2.0, 64, 64).unwrap());
    let points: Vec<Json> =
        (0..100_000).map(|i| json!([f64::from(i % 317) * 0.01, f64::from(i) * 1e-5, 1])).collect();
    let many: Vec<Json> = (0..20).map(|_| json!([ball, points])).collect();
    let begin = Instant::now();
    assert_eq!(
        call(&short, "mesh/pullpointstomesh-mesh_point3darray", &json!(many), &[("multiple", "true")]),
        Cause::TimedOut
    );
    assert!(begin.elapsed() < Duration::from_secs(20), "{:?}", begin.elapsed());
}
