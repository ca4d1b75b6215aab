//! RhinoCommon's JSON forms, both ways. The objects' bytes were written by rhino3dm.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

use std::f64::consts::{PI, TAU};

use katydid_compute::wire::{
    GeometryBase, MeshingParameters, Ray, Read, Subdivision, Wire, decode_object, encode,
};
use katydid_compute::{Cause, Fault};
use katydid_data::{Colour, Kind, Value};
use katydid_geometry::subd::{FromMesh, SubD, SubDNet};
use katydid_geometry::{
    Arc, BoundingBox, Box3, Brep, Circle, Cone, Curve, Cylinder, Ellipse, Interval, Line, Mesh, NurbsCurve,
    Plane, Point2, Point3, PolylineCurve, Rectangle, Sphere, Surface, Torus, Vector3, Xform, construct,
};
use proptest::prelude::*;
use serde_json::{Value as Json, json};

/// A line from (−10, 0, 0) to (10, 0, 0), by rhino3dm 8.35.
const LINE: &str = "+n8CAIEAAAAAAAAA+/8CABQAAAAAAAAA29TXTkfp0xG/5QAQgwEi8PSb6SP8/wIASQAAAAAAAAAQAAAAAAAAJMAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAJEAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA0QAMAAAAtYI8R/38CgAAAAAAAAAAA";

fn form(data: &str) -> Json {
    json!({ "version": 10000, "archive3dm": 60, "opennurbs": -1869833980, "data": data })
}

fn read<T: Read>(json: Json) -> Result<T, Fault> {
    T::read(&json)
}

fn refusal<T: Read + std::fmt::Debug>(json: Json) -> String {
    read::<T>(json).unwrap_err().message
}

#[test]
fn a_line_of_rhino3dm_is_read_and_written_byte_for_byte() {
    let curve: Curve = read(form(LINE)).unwrap();
    assert_eq!((curve.start(), curve.end()), (Point3::new(-10.0, 0.0, 0.0), Point3::new(10.0, 0.0, 0.0)));
    assert_eq!(curve.domain(), Interval::new(0.0, 20.0));
    assert_eq!(curve.to_json(60).unwrap()["data"], LINE);
    assert_eq!(curve.to_json(70).unwrap()["archive3dm"], 70);
}

#[test]
fn the_form_may_stand_in_a_string_with_numbers_as_strings_and_names_in_any_case() {
    let loose =
        json!({ "Version": "10000", "ARCHIVE3DM": "60", "openNURBS": "-1869833980", "Data": LINE, "x": [1] });
    assert_eq!(read::<Curve>(loose.clone()).unwrap(), read(form(LINE)).unwrap());
    assert_eq!(read::<Curve>(Json::from(loose.to_string())).unwrap(), read(form(LINE)).unwrap());
    let unsigned = json!({ "archive3dm": 60, "opennurbs": 2425133316_u32, "data": format!(" {}\n{}", &LINE[..40], &LINE[40..]) });
    assert_eq!(read::<Curve>(unsigned).unwrap(), read(form(LINE)).unwrap());
}

#[test]
fn points_are_objects_lists_or_text() {
    let expected = Point3::new(1.0, 2.5, -3.0);
    for loose in [
        json!({ "X": 1, "Y": 2.5, "Z": -3 }),
        json!({ "x": 1, "y": "2.5", "z": -3, "IsValid": true }),
        json!([1, 2.5, -3]),
        json!("{\"X\":1,\"Y\":2.5,\"Z\":-3}"),
        json!("[1, 2.5, -3]"),
    ] {
        assert_eq!(read::<Point3>(loose).unwrap(), expected);
    }
    assert_eq!(read::<Point3>(json!([1, 2])).unwrap(), Point3::new(1.0, 2.0, 0.0));
}

#[test]
fn structs_of_other_libraries_are_understood() {
    // rhino3dm writes circles so.
    let circle: Circle = read(
        json!({ "radius": 5, "plane": { "Origin": [1, 2, 3], "XAxis": [1, 0, 0], "YAxis": [0, 1, 0] } }),
    )
    .unwrap();
    assert_eq!(circle, Circle::new(Plane::XY.with_origin(Point3::new(1.0, 2.0, 3.0)), 5.0).unwrap());
    let round: Circle = read(json!({ "Center": [0, 0, 1], "Normal": [0, 0, 2], "Radius": 1 })).unwrap();
    assert_eq!(round.plane.z_axis, Vector3::Z);
    let half: Arc = read(json!({ "Plane": { "Origin": [0, 0, 0] }, "Radius": 2, "Angle": PI })).unwrap();
    assert!((half.length() - 2.0 * PI).abs() < 1e-12);
    let shape: Box3 = read(json!({ "Min": [0, 0, 0], "Max": [1, 2, 3] })).unwrap();
    assert_eq!(shape.area(), 22.0);
    let tall: Cylinder =
        read(json!({ "Center": [0, 0, 0], "Axis": [0, 0, 1], "Radius": 1, "TotalHeight": 4 })).unwrap();
    assert_eq!(tall.height, Interval::new(0.0, 4.0));
    let sphere: Sphere = read(json!({ "Radius": 3, "EquatorialPlane": { "Origin": [0, 0, 0], "XAxis": [1, 0, 0], "YAxis": [0, 1, 0] } })).unwrap();
    assert_eq!(sphere.radius, 3.0);
}

#[test]
fn curves_may_be_lists_of_points_or_structs() {
    let chain: Curve = read(json!([[0, 0, 0], { "X": 1, "Y": 0, "Z": 0 }, [1, 1, 0]])).unwrap();
    assert_eq!(chain.length(), 2.0);
    let line: Curve = read(json!({ "From": [0, 0, 0], "To": [0, 3, 4] })).unwrap();
    assert_eq!(line.length(), 5.0);
    let circle: Curve = read(json!({ "Radius": 1, "Plane": { "Origin": [0, 0, 0] } })).unwrap();
    assert!((circle.length() - TAU).abs() < 1e-12);
    assert!(matches!(read::<GeometryBase>(json!([1, 2, 3])).unwrap(), GeometryBase::Point(_)));
    assert_eq!(read::<PolylineCurve>(form(LINE)).unwrap().segment_count(), 1);
}

#[test]
fn colours_are_names_of_channels_lists_text_or_bits() {
    let orange = Colour::rgb(255, 128, 0);
    for loose in [
        json!("255, 128, 0"),
        json!([255, 128, 0]),
        json!({ "R": 255, "G": 128, "B": 0, "A": 255 }),
        json!(-32768),
    ] {
        assert_eq!(read::<Colour>(loose).unwrap(), orange);
    }
    assert_eq!(read::<Colour>(json!("10, 255, 128, 0")).unwrap().a, 10);
    assert!(refusal::<Colour>(json!("256,0,0")).contains("channel 256"));
}

#[test]
fn meshing_parameters_of_rhino3dm_are_read() {
    let MeshingParameters(settings) = read(json!({
        "TextureRange": 2, "JaggedSeams": false, "RefineGrid": true, "SimplePlanes": true, "GridMinCount": 16,
        "GridMaxCount": 0, "GridAngle": 0.3, "GridAspectRatio": 6.0, "Tolerance": 0.01, "RelativeTolerance": 0.0,
        "MinimumEdgeLength": 0.0001, "MaximumEdgeLength": 2.0, "RefineAngle": 0.4
    }))
    .unwrap();
    assert_eq!((settings.max_distance, settings.max_edge, settings.max_angle), (0.01, 2.0, 0.4));
    assert_eq!((settings.min_count, settings.simple_planes), (16, true));
    assert!(refusal::<MeshingParameters>(json!({ "Tolerance": -1 })).contains("Tolerance is -1"));
    assert!(refusal::<MeshingParameters>(json!({ "GridMinCount": 2_000_000_000 })).contains("GridMinCount"));
}

#[test]
fn what_cannot_be_is_refused_in_words() {
    assert_eq!(refusal::<f64>(json!("NaN")), "is not a finite number");
    assert_eq!(refusal::<f64>(json!("1e999")), "is not a finite number");
    assert_eq!(refusal::<f64>(json!([1])), "is a list, not a number");
    assert_eq!(refusal::<i32>(json!(1.5)), "is 1.5, not a whole number");
    assert_eq!(refusal::<i32>(json!(3e9)), "is 3000000000, beyond 32 bits");
    assert_eq!(refusal::<bool>(json!("maybe")), "is text, not true or false");
    assert!(refusal::<Point3>(json!({ "X": 1, "Z": 0 })).contains("has no Y"));
    assert!(refusal::<Point3>(json!([1, "NaN", 0])).contains("not a finite number"));
    assert!(refusal::<Line>(json!({ "From": [0, 0, 0] })).contains("has no To"));
    assert!(
        refusal::<Plane>(json!({ "Origin": [0, 0, 0], "XAxis": [1, 0, 0], "YAxis": [2, 0, 0] }))
            .contains("parallel")
    );
    assert!(
        refusal::<Circle>(json!({ "Radius": -1, "Plane": { "Origin": [0, 0, 0] } })).contains("radius is -1")
    );
    assert!(refusal::<Ray>(json!({ "Position": [0, 0, 0], "Direction": [0, 0, 0] })).contains("no length"));
    assert!(refusal::<BoundingBox>(json!({ "Min": [1, 0, 0], "Max": [0, 0, 0] })).contains("beyond"));
    assert!(refusal::<Xform>(json!([1, 2, 3])).contains("16 numbers"));
}

#[test]
fn broken_objects_are_refused_in_words() {
    let with = |name: &str, value: Json| {
        let mut form = form(LINE);
        form[name] = value;
        form
    };
    assert!(refusal::<Curve>(with("archive3dm", json!(999))).contains("999"));
    assert!(refusal::<Curve>(with("data", json!("%%%"))).contains("base64"));
    assert!(refusal::<Curve>(with("data", json!(""))).contains("no object of Rhino's"));
    assert!(refusal::<Curve>(with("data", json!(&LINE[..80]))).contains("no object of Rhino's"));
    assert!(refusal::<Curve>(with("opennurbs", json!("x"))).contains("32 bits"));
    assert!(refusal::<Mesh>(form(LINE)).contains("LineCurve"));
    assert!(refusal::<Brep>(form(LINE)).contains("LineCurve"));
    let fetched = read::<Brep>(json!({ "url": "http://127.0.0.1/x" })).unwrap_err();
    assert!(fetched.message.contains("not fetched"), "{fetched}");
    assert!(matches!(read::<Curve>(Json::Null).unwrap_err().cause, Cause::BadRequest));
}

#[test]
fn lengths_past_the_end_never_panic() {
    use base64::Engine as _;
    use base64::engine::general_purpose::STANDARD;
    let bytes = STANDARD.decode(LINE).unwrap();
    for place in 0..bytes.len() {
        for value in [0x00, 0x7f, 0x80, 0xff] {
            let mut broken = bytes.clone();
            broken[place] = value;
            let _ = decode_object(&form(&STANDARD.encode(&broken)));
        }
        let _ = decode_object(&form(&STANDARD.encode(&bytes[..place])));
    }
}

/// What is written is read again as it was.
fn there_and_back<T: Wire + PartialEq + std::fmt::Debug>(value: T) {
    for archive in [50, 60, 70, 80] {
        let json = value.to_json(archive).unwrap();
        assert_eq!(T::from_json(&json).unwrap(), value, "{json}");
        // Through text, as it travels.
        let text: Json = serde_json::from_str(&json.to_string()).unwrap();
        assert_eq!(T::from_json(&text).unwrap(), value);
    }
}

#[test]
fn geometry_goes_there_and_back() {
    let circle = Circle::new(Plane::XZ, 2.0).unwrap();
    there_and_back(Curve::from(circle));
    there_and_back(Curve::from(circle.to_nurbs().unwrap()));
    there_and_back(Curve::from(Line::new(Point3::ORIGIN, Point3::new(1.0, 2.0, 3.0))));
    let sphere = Sphere::around(Point3::ORIGIN, 5.0).unwrap();
    there_and_back(Surface::from(sphere.to_revolution()));
    there_and_back(construct::sphere(&sphere).unwrap());
    let cube = Box3::from(BoundingBox { min: Point3::ORIGIN, max: Point3::new(1.0, 2.0, 3.0) });
    there_and_back(construct::box_brep(&cube).unwrap());
    let mesh = Mesh::cuboid(&cube, 2, 2, 2).unwrap();
    there_and_back(mesh.clone());
    let net = SubDNet::from_mesh(&mesh, &FromMesh { creases: false, corners: false }).unwrap();
    let subd = Subdivision(SubD::new(net));
    let json = subd.to_json(70).unwrap();
    assert_eq!(Subdivision::from_json(&json).unwrap().0.net().faces().len(), subd.0.net().faces().len());
}

#[test]
fn structs_go_there_and_back() {
    let plane = Plane::XZ.with_origin(Point3::new(1.0, -2.0, 0.5));
    there_and_back(plane);
    there_and_back(Interval::new(-1.0, 3.5));
    there_and_back(Circle::new(plane, 0.25).unwrap());
    there_and_back(Arc::new(Circle::new(plane, 0.25).unwrap(), Interval::new(-1.0, 2.0)).unwrap());
    there_and_back(Ellipse::new(plane, 2.0, 1.0).unwrap());
    there_and_back(Rectangle { plane, x: Interval::new(0.0, 2.0), y: Interval::new(-1.0, 1.0) });
    there_and_back(Box3 { plane, x: Interval::new(0.0, 2.0), y: Interval::UNIT, z: Interval::UNIT });
    there_and_back(Sphere::new(plane, 2.0).unwrap());
    there_and_back(Cylinder::new(plane, 2.0, Interval::new(-1.0, 1.0)).unwrap());
    there_and_back(Cone::new(plane, 2.0, 1.0).unwrap());
    there_and_back(Torus::new(plane, 2.0, 1.0).unwrap());
    there_and_back(Colour::argb(1, 2, 3, 4));
    there_and_back(Point2::new(1.0, 2.0));
    there_and_back(Ray { position: Point3::ORIGIN, direction: Vector3::Z });
    there_and_back(Xform::rotation_zyx(0.5, 0.25, -1.0));
}

#[test]
fn values_have_the_names_of_their_types() {
    let name = |value: Value| encode(&value, 70).map(|encoded| (encoded.type_name, encoded.json.to_string()));
    assert_eq!(name(Value::Number(5.0)), Some(("System.Double", "5.0".into())));
    assert_eq!(name(Value::Integer(5)), Some(("System.Int32", "5".into())));
    assert_eq!(name(Value::Boolean(true)), Some(("System.Boolean", "true".into())));
    assert_eq!(name(Value::text("a\"b")), Some(("System.String", "\"a\\\"b\"".into())));
    assert_eq!(name(Value::Number(f64::NAN)), Some(("System.Double", "\"NaN\"".into())));
    let circle = Circle::new(Plane::XY, 1.0).unwrap();
    assert_eq!(name(circle.into()).unwrap().0, "Rhino.Geometry.Circle");
    assert_eq!(name(Curve::from(circle).into()).unwrap().0, "Rhino.Geometry.ArcCurve");
    let sphere = Sphere::around(Point3::ORIGIN, 5.0).unwrap();
    assert_eq!(name(Surface::from(sphere.to_revolution()).into()).unwrap().0, "Rhino.Geometry.Brep");
    assert_eq!(encode(&Value::Path([0, 1].into()), 70), None);
}

#[test]
fn a_value_that_was_kept_is_written_for_the_version_asked_for() {
    let cube = Box3::from(BoundingBox { min: Point3::ORIGIN, max: Point3::new(1.0, 2.0, 3.0) });
    let brep = construct::box_brep(&cube).unwrap();
    let kept = decode_object(&brep.to_json(80).unwrap()).unwrap();
    assert_eq!(kept.kind(), Kind::Kept);
    for archive in [50, 60, 70, 80] {
        let encoded = encode(&kept, archive).unwrap();
        assert_eq!(
            (encoded.type_name, &encoded.json["archive3dm"]),
            ("Rhino.Geometry.Brep", &json!(archive))
        );
        assert_eq!(Brep::from_json(&encoded.json).unwrap().faces().len(), 6);
    }
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![-1e6..1e6_f64, prop::num::f64::NORMAL.prop_filter("finite squares", |x| x.abs() < 1e100)]
}

fn point() -> impl Strategy<Value = Point3> {
    (number(), number(), number()).prop_map(|(x, y, z)| Point3::new(x, y, z))
}

proptest! {
    #[test]
    fn any_point_goes_there_and_back(p in point()) {
        there_and_back(p);
    }

    #[test]
    fn any_polyline_and_nurbs_curve_goes_there_and_back(points in prop::collection::vec(point(), 4..12)) {
        there_and_back(Curve::from(PolylineCurve::new(points.clone()).unwrap()));
        let knots = katydid_geometry::clamped_uniform_knots(3, points.len()).unwrap();
        there_and_back(Curve::from(NurbsCurve::new(3, points, knots).unwrap()));
    }

    #[test]
    fn no_json_makes_it_panic(text in "[\\[\\]{}\",:0-9a-zA-Z.-]{0,60}") {
        if let Ok(json) = serde_json::from_str::<Json>(&text) {
            let _ = (Curve::read(&json), GeometryBase::read(&json), Plane::read(&json), decode_object(&json));
        }
    }
}
