//! Functions called by path, against closed forms.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

use std::f64::consts::{PI, TAU};

use katydid_compute::wire::{Read, Wire};
use katydid_compute::{Bounds, Cause, Fault, geometry};
use katydid_geometry::{
    BoundingBox, Box3, Brep, Circle, Curve, Interval, Line, Mesh, Plane, PlaneSurface, Point3, PolylineCurve,
    Rectangle, Sphere, Surface, Vector3, construct,
};
use serde_json::{Value as Json, json};

fn object<T: Wire>(value: &T) -> Json {
    value.to_json(70).unwrap()
}

fn asked(path: &str, query: &[(&str, &str)], arguments: &Json) -> Result<Json, Fault> {
    let query = geometry::Query::read(query.iter().copied())?;
    let reply = geometry::call(path, &query, arguments.to_string().as_bytes(), &Bounds::default())?;
    Ok(reply.json.unwrap_or(Json::Null))
}

fn ask(path: &str, arguments: Json) -> Json {
    asked(path, &[], &arguments).unwrap_or_else(|fault| panic!("{path}: {fault}"))
}

fn refused(path: &str, arguments: Json) -> Fault {
    match asked(path, &[], &arguments) {
        Ok(json) => panic!("{path} answered {json}"),
        Err(fault) => fault,
    }
}

fn number(json: &Json) -> f64 {
    json.as_f64().unwrap_or_else(|| panic!("{json} is no number"))
}

fn near(json: &Json, expected: f64) {
    let x = number(json);
    assert!((x - expected).abs() <= 1e-6 * expected.abs().max(1.0), "{x} is not {expected}");
}

fn at(json: &Json, expected: [f64; 3]) {
    let p = Point3::read(json).unwrap();
    assert!(p.distance_to(Point3::from(expected)) < 1e-6, "{p:?} is not {expected:?}");
}

fn curves(json: &Json) -> Vec<Curve> {
    Vec::read(json).unwrap()
}

fn circle(x: f64, radius: f64) -> Curve {
    Circle::new(Plane::XY.with_origin(Point3::new(x, 0.0, 0.0)), radius).unwrap().into()
}

fn c1() -> Json {
    object(&circle(0.0, 5.0))
}

fn c2() -> Json {
    object(&circle(3.0, 5.0))
}

fn line() -> Json {
    object(&Curve::from(Line::new(Point3::new(-10.0, 0.0, 0.0), Point3::new(10.0, 0.0, 0.0))))
}

fn ball(x: f64, radius: f64) -> Brep {
    construct::sphere(&Sphere::around(Point3::new(x, 0.0, 0.0), radius).unwrap()).unwrap()
}

fn cube() -> Box3 {
    BoundingBox { min: Point3::ORIGIN, max: Point3::new(1.0, 2.0, 3.0) }.into()
}

fn cube_brep() -> Json {
    object(&construct::box_brep(&cube()).unwrap())
}

fn cube_mesh() -> Json {
    object(&Mesh::cuboid(&cube(), 1, 1, 1).unwrap())
}

fn floor() -> Surface {
    PlaneSurface::new(Plane::XY, Interval::new(0.0, 4.0), Interval::new(0.0, 3.0)).unwrap().into()
}

fn square(size: f64) -> Json {
    json!([[0, 0, 0], [size, 0, 0], [size, size, 0], [0, size, 0], [0, 0, 0]])
}

/// The area between two circles of radius r whose centres are d apart, common to both.
fn lens(r: f64, d: f64) -> f64 {
    2.0 * r * r * (d / (2.0 * r)).acos() - 0.5 * d * (4.0 * r * r - d * d).sqrt()
}

#[test]
fn lengths_and_parameters() {
    near(&ask("curve/getlength-curve", json!([c1()])), TAU * 5.0);
    near(&ask("curve/getlength-curve_double", json!([c1(), 1e-8])), TAU * 5.0);
    near(&ask("curve/getlength-curve_interval", json!([line(), { "T0": 0, "T1": 5 }])), 5.0);
    near(&ask("RHINO/Geometry/Curve/GetLength", json!([line()])), 20.0);
    assert_eq!(ask("curve/isshort-curve_double", json!([line(), 19])), json!(false));
    assert_eq!(ask("curve/isshort-curve_double", json!([line(), 21])), json!(true));
    assert_eq!(ask("curve/lengthparameter-curve_double_double", json!([line(), 5])), json!([true, 5.0]));
    assert_eq!(ask("curve/lengthparameter-curve_double_double", json!([line(), 21]))[0], json!(false));
    near(
        &ask("curve/lengthparameter-curve_double_double_interval", json!([line(), 5, { "T0": 2, "T1": 9 }]))
            [1],
        7.0,
    );
    near(&ask("curve/normalizedlengthparameter-curve_double_double", json!([line(), 0.25]))[1], 5.0);
    let half =
        ask("curve/normalizedlengthparameters-curve_doublearray_double", json!([line(), [0, 0.5, 1], 0.01]));
    assert_eq!(half, json!([0.0, 10.0, 20.0]));
    at(&ask("curve/pointatlength-curve_double", json!([line(), 4])), [-6.0, 0.0, 0.0]);
    assert_eq!(ask("curve/pointatlength-curve_double", json!([line(), 40])), Json::Null);
    at(&ask("curve/pointatnormalizedlength-curve_double", json!([c1(), 0.25])), [0.0, 5.0, 0.0]);
}

#[test]
fn divisions() {
    let ten = ask("curve/dividebycount-curve_int_bool", json!([c1(), 10, true]));
    assert_eq!(ten.as_array().unwrap().len(), 10);
    assert_eq!(
        ask("curve/dividebycount-curve_int_bool", json!([line(), 4, true])),
        json!([0.0, 5.0, 10.0, 15.0, 20.0])
    );
    assert_eq!(
        ask("curve/dividebycount-curve_int_bool", json!([line(), 4, false])),
        json!([5.0, 10.0, 15.0])
    );
    let both = ask("curve/dividebycount-curve_int_bool_point3darray", json!([line(), 2, true]));
    at(&both[1][1], [0.0, 0.0, 0.0]);
    assert_eq!(
        ask("curve/dividebylength-curve_double_bool", json!([line(), 8, true])),
        json!([0.0, 8.0, 16.0])
    );
    let back = ask("curve/dividebylength-curve_double_bool_bool", json!([line(), 8, true, true]));
    [20.0, 12.0, 4.0].iter().enumerate().for_each(|(i, t)| near(&back[i], *t));
    assert_eq!(back.as_array().unwrap().len(), 3);
    assert_eq!(ask("curve/dividebylength-curve_double_bool", json!([line(), 80, true])), Json::Null);
    assert_eq!(ask("curve/divideequidistant-curve_double", json!([line(), 10])).as_array().unwrap().len(), 3);
    let contour =
        ask("curve/divideascontour-curve_point3d_point3d_double", json!([line(), [-9, 0, 0], [9, 0, 0], 6]));
    assert_eq!(contour.as_array().unwrap().len(), 4);
}

#[test]
fn nearest_points_and_places() {
    let found = ask("curve/closestpoint-curve_point3d_double", json!([c1(), [10, 0, 0]]));
    assert_eq!(found, json!([true, 0.0]));
    assert_eq!(
        ask("curve/closestpoint-curve_point3d_double_double", json!([line(), [0, 3, 0], 1]))[0],
        json!(false)
    );
    near(&ask("curve/closestpoint-curve_point3d_double_double", json!([line(), [0, 3, 0], 4]))[1], 10.0);
    let pair =
        ask("curve/closestpoints-curve_curve_point3d_point3d", json!([c1(), [[20, -1, 0], [20, 1, 0]]]));
    at(&pair[1], [5.0, 0.0, 0.0]);
    at(&pair[2], [20.0, 0.0, 0.0]);
    for (p, expected) in [([1, 1, 0], 1), ([9, 0, 0], 2), ([5, 0, 0], 3)] {
        assert_eq!(
            ask("curve/contains-curve_point3d_plane_double", json!([c1(), p, object(&Plane::XY), 0.001])),
            expected
        );
    }
    assert_eq!(ask("curve/contains-curve_point3d", json!([line(), [0, 0, 0]])), 0);
    let ends = ask("curve/extremeparameters-curve_vector3d", json!([c1(), [0, 1, 0]]));
    assert_eq!(ends.as_array().unwrap().len(), 2);
    let frame = ask("curve/perpendicularframeat-curve_double_plane", json!([line(), 3]));
    assert_eq!(frame[0], json!(true));
    at(&frame[1]["Normal"], [1.0, 0.0, 0.0]);
    assert_eq!(
        ask("curve/dodirectionsmatch-curve_curve", json!([line(), [[0, 1, 0], [5, 1, 0]]])),
        json!(true)
    );
    assert_eq!(
        ask("curve/dodirectionsmatch-curve_curve", json!([line(), [[5, 1, 0], [0, 1, 0]]])),
        json!(false)
    );
}

#[test]
fn curves_made_of_curves() {
    let grown = ask(
        "curve/offset-curve_plane_double_double_curveoffsetcornerstyle",
        json!([c1(), object(&Plane::XY), 1.0, 0.01, 1]),
    );
    near(&json!(curves(&grown)[0].length()), TAU * 6.0);
    let shrunk = ask(
        "curve/offset-curve_point3d_vector3d_double_double_curveoffsetcornerstyle",
        json!([c1(), [0, 0, 0], [0, 0, 1], 1.0, 0.01, "Sharp"]),
    );
    near(&json!(curves(&shrunk)[0].length()), TAU * 4.0);
    let joined =
        ask("curve/joincurves-curvearray", json!([[[[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [1, 1, 0]]]]));
    near(&json!(curves(&joined)[0].length()), 2.0);
    let through =
        ask("curve/createinterpolatedcurve-point3darray_int", json!([[[0, 0, 0], [1, 1, 0], [2, 0, 0]], 3]));
    let through = Curve::read(&through).unwrap();
    assert!(through.closest_point(Point3::new(1.0, 1.0, 0.0)).unwrap().distance < 1e-12);
    let between = ask(
        "curve/createtweencurves-curve_curve_int",
        json!([[[0, 0, 0], [1, 0, 0]], [[0, 2, 0], [1, 2, 0]], 1]),
    );
    at(&object(&curves(&between)[0].start()), [0.0, 1.0, 0.0]);
    near(
        &json!(
            Curve::read(&ask("curve/trim-curve_curveend_double", json!([line(), 1, 5]))).unwrap().length()
        ),
        15.0,
    );
    assert_eq!(ask("curve/trim-curve_curveend_double", json!([line(), 3, 10])), Json::Null);
    near(
        &json!(
            Curve::read(&ask("curve/extend-curve_double_double", json!([line(), -5, 25]))).unwrap().length()
        ),
        30.0,
    );
    let longer = ask("curve/extend-curve_curveend_double_curveextensionstyle", json!([line(), 2, 5, 0]));
    near(&json!(Curve::read(&longer).unwrap().length()), 25.0);
    let flat = ask("curve/projecttoplane-curve_plane", json!([[[0, 0, 0], [3, 0, 4]], object(&Plane::XY)]));
    near(&json!(Curve::read(&flat).unwrap().length()), 3.0);
    assert_eq!(curves(&ask("curve/duplicatesegments-curve", json!([square(2.0)]))).len(), 4);
    let split = ask("curve/split-curve_brep_double", json!([line(), object(&ball(0.0, 5.0)), 0.001]));
    let lengths: Vec<f64> = curves(&split).iter().map(Curve::length).collect();
    assert_eq!(lengths.len(), 3, "{lengths:?}");
    let rounded = ask(
        "curve/createfilletcornerscurve-curve_double_double_double",
        json!([square(4.0), 1, 0.001, 0.01]),
    );
    let rounded = Curve::read(&rounded).unwrap();
    assert!(rounded.length() < 16.0 && rounded.length() > 16.0 - 4.0 * (2.0 - PI / 2.0) - 1e-6);
    let fillet = ask(
        "curve/createfilletcurves-curve_point3d_curve_point3d_double_bool_bool_bool_double_double",
        json!([
            [[0, 0, 0], [10, 0, 0]],
            [0, 0, 0],
            [[5, -5, 0], [5, 5, 0]],
            [5, 5, 0],
            1,
            true,
            true,
            true,
            0.001,
            0.01
        ]),
    );
    near(&json!(curves(&fillet)[0].length()), 4.0 + PI / 2.0 + 4.0);
    let chain = ask("curve/topolyline-curve_double_double_double_double", json!([c1(), 0.01, 0, 0, 0]));
    let chain = PolylineCurve::read(&chain).unwrap();
    assert!((Curve::from(chain).length() - TAU * 5.0).abs() < 0.1);
    let simple = ask(
        "curve/simplify-curve_curvesimplifyoptions_double_double",
        json!([[[0, 0, 0], [1, 0, 0], [2, 0, 0]], 63, 0.01, 0.01]),
    );
    assert!(matches!(Curve::read(&simple).unwrap(), Curve::Line(_)));
}

#[test]
fn regions_of_curves() {
    let area = |json: &Json| curves(json).iter().map(|c| c.area_and_centroid(1e-6).unwrap().0).sum::<f64>();
    let (disc, common) = (PI * 25.0, lens(5.0, 3.0));
    near(
        &json!(area(&ask("curve/createbooleanunion-curvearray_double", json!([[c1(), c2()], 0.01])))),
        2.0 * disc - common,
    );
    near(&json!(area(&ask("curve/createbooleanintersection-curve_curve", json!([c1(), c2()])))), common);
    near(&json!(area(&ask("curve/createbooleandifference-curve_curve", json!([c1(), c2()])))), disc - common);
    near(
        &json!(area(&ask("curve/createbooleandifference-curve_curvearray", json!([c1(), [c2()]])))),
        disc - common,
    );
    let related = |a: Json, b: Json| {
        ask(
            "curve/planarclosedcurverelationship-curve_curve_plane_double",
            json!([a, b, object(&Plane::XY), 0.001]),
        )
    };
    assert_eq!(related(c1(), c2()), 1);
    assert_eq!(related(c1(), object(&circle(0.0, 1.0))), 3);
    assert_eq!(related(object(&circle(0.0, 1.0)), c1()), 2);
    assert_eq!(related(c1(), object(&circle(50.0, 1.0))), 0);
    assert_eq!(ask("curve/createbooleanunion-curvearray", json!([[line()]])), Json::Null);
}

#[test]
fn areas_and_volumes() {
    let disc = ask("areamassproperties/compute-curve", json!([c1()]));
    near(&disc["Area"], PI * 25.0);
    at(&disc["Centroid"], [0.0, 0.0, 0.0]);
    near(&disc["WorldCoordinatesMomentsOfInertia"]["Z"], 0.5 * PI * 625.0);
    near(&ask("areamassproperties/compute-brep", json!([object(&ball(0.0, 5.0))]))["Area"], 4.0 * PI * 25.0);
    near(
        &ask("volumemassproperties/compute-brep", json!([object(&ball(3.0, 5.0))]))["Volume"],
        4.0 / 3.0 * PI * 125.0,
    );
    at(
        &ask("volumemassproperties/compute-brep", json!([object(&ball(3.0, 5.0))]))["Centroid"],
        [3.0, 0.0, 0.0],
    );
    near(&ask("volumemassproperties/compute-mesh", json!([cube_mesh()]))["Volume"], 6.0);
    near(&ask("areamassproperties/compute-mesh", json!([cube_mesh()]))["Area"], 22.0);
    near(&ask("areamassproperties/compute-surface", json!([object(&floor())]))["Area"], 12.0);
    near(
        &ask("areamassproperties/compute-geometrybasearray", json!([[c1(), cube_brep()]]))["Area"],
        PI * 25.0 + 22.0,
    );
    near(&ask("brep/getvolume-brep", json!([cube_brep()])), 6.0);
    near(&ask("brep/getarea-brep_double_double", json!([cube_brep(), 1e-6, 1e-6])), 22.0);
    near(&ask("mesh/volume-mesh", json!([cube_mesh()])), 6.0);
}

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

#[test]
fn several_calls_in_one_body_and_chosen_members() {
    let twice =
        asked("areamassproperties/compute-curve", &[("multiple", "true")], &json!([[c1()], [c2()]])).unwrap();
    assert_eq!(twice.as_array().unwrap().len(), 2);
    at(&twice[1]["Centroid"], [3.0, 0.0, 0.0]);
    let chosen = [("return.Rhino.Geometry.AreaMassProperties", "Area,Centroid")];
    let only = asked("areamassproperties/compute-curve", &chosen, &json!([c1()])).unwrap();
    assert_eq!(only.as_object().unwrap().len(), 2);
    assert!(asked("curve/getlength-curve", &[("stopat", "1")], &json!([c1()])).unwrap().is_number());
    let fault = asked("curve/getlength-curve", &[("multiple", "true")], &json!([[c1()], [1]])).unwrap_err();
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
    let union = "brep/createbooleanunion-breparray_double";
    assert_eq!(refused(union, json!([[], 0.01])).cause, Cause::NotSupported(union.into()));
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
    assert!(table.help("brep/createbooleanunion").unwrap().contains("Not supported yet"));
    assert!(table.index().contains("href=\"/rhino/geometry/mesh/createfrombrep-brep\""));
    assert!(table.help("nothing/here").is_err());
}

/// The paths that are known and do not answer. This list only gets shorter.
const NOT_YET: &str = include_str!("endpoints_not_yet.txt");

#[test]
fn what_does_not_answer_is_what_the_list_says() {
    let table = geometry::endpoints();
    let answered: Vec<&str> = table.answered().collect();
    let missing: Vec<&str> = table.paths().filter(|path| !answered.contains(path)).collect();
    let expected: Vec<&str> = NOT_YET.lines().filter(|line| !line.is_empty()).collect();
    assert_eq!(missing, expected, "{} of {} answer", answered.len(), answered.len() + missing.len());
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
