//! Geometry that is damaged, of another class than asked for, or of numbers that are none.

use std::time::Duration;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use katydid_compute::wire::Wire;
use katydid_geometry::{Box3, Circle, Curve, Interval, Line, Mesh, Plane, Point3, PolyCurve};
use serde_json::{Value, json};
use tokio::time::Instant;

use crate::client::{Answer, Compute, input};
use crate::definitions::gh;

const LENGTH: &str = "/rhino/geometry/curve/getlength-curve";
const VOLUME: &str = "/rhino/geometry/mesh/volume-mesh";

/// The length of a curve that is an input.
const CURVE: &str = "katydid 1\nc = Curve()\nx = Length(c)\n\"RH_IN:c\": c\n\"RH_OUT:x\": x\n";

fn circle() -> Value {
    Curve::from(Circle::new(Plane::XY, 5.0).unwrap()).to_json(70).unwrap()
}

fn mesh() -> Value {
    let side = || Interval::new(0.0, 1.0);
    let shape = Box3 { plane: Plane::XY, x: side(), y: side(), z: side() };
    Mesh::cuboid(&shape, 1, 1, 1).unwrap().to_json(70).unwrap()
}

fn bytes(object: &Value) -> Vec<u8> {
    BASE64_STANDARD.decode(object["data"].as_str().unwrap()).unwrap()
}

fn with_bytes(object: &Value, bytes: &[u8]) -> Value {
    let mut object = object.clone();
    object["data"] = json!(BASE64_STANDARD.encode(bytes));
    object
}

/// Whether numbers came out: finite ones, as what is not has to be written as text.
fn is_sound(answer: &Answer) -> bool {
    answer.status == 200 && !answer.text().contains("NaN") && !answer.text().contains("Infinity")
}

#[tokio::test(flavor = "multi_thread")]
async fn objects_that_are_cut_short() {
    let compute = Compute::start().await;
    let definition = gh(CURVE);
    for (path, object) in [(LENGTH, circle()), (VOLUME, mesh())] {
        assert_eq!(compute.post(path, &json!([object])).await.status, 200, "whole, it is fine");
        let whole = bytes(&object);
        for length in (0..whole.len()).step_by(7) {
            let answer = compute.post(path, &json!([with_bytes(&object, &whole[..length])])).await;
            assert!(answer.is_refused(), "{path} {length}: {} {}", answer.status, answer.text());
        }
    }
    let whole = bytes(&circle());
    let cut = with_bytes(&circle(), &whole[..whole.len() / 2]);
    for data in [cut.clone(), json!(cut.to_string())] {
        let answer = compute.solve(&definition, json!([input("RH_IN:c", "{0}", &[data])])).await;
        assert!(answer.is_refused(), "{} {}", answer.status, answer.text());
    }
    let whole = compute.solve(&definition, json!([input("RH_IN:c", "{0}", &[circle()])])).await;
    assert!((whole.output("RH_OUT:x").as_f64().unwrap() - 31.4159).abs() < 1e-3, "{}", whole.text());
    compute.is_well().await;
}

/// Every word of an object set to a length past the end, to a count below none, and to half of a number that is none:
/// what is still an object is computed with, and everything else refused.
#[tokio::test(flavor = "multi_thread")]
async fn objects_with_flipped_bytes() {
    let compute = Compute::start().await;
    for (path, object) in [(LENGTH, circle()), (VOLUME, mesh())] {
        let whole = bytes(&object);
        let mut refused = 0;
        for at in (0..whole.len().saturating_sub(4)).step_by(4) {
            for word in [0x7fff_ffff_u32, 0xffff_ffff, 0xfff8_0000] {
                let mut bytes = whole.clone();
                bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
                let start = Instant::now();
                let answer = compute.post(path, &json!([with_bytes(&object, &bytes)])).await;
                let what = format!("{path} {word:x} at {at}: {} {}", answer.status, answer.text());
                assert!(answer.is_refused() || is_sound(&answer), "{what}");
                assert!(start.elapsed() < Duration::from_secs(5), "{what}");
                refused += usize::from(answer.is_refused());
            }
        }
        assert!(refused > 20, "{path}: {refused}");
    }
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn objects_of_no_known_form() {
    let compute = Compute::start().await;
    let changed = |member: &str, value: Value| {
        let mut object = circle();
        object[member] = value;
        object
    };
    for (path, object) in [
        (LENGTH, changed("archive3dm", json!(999))),
        (LENGTH, changed("archive3dm", json!(-1))),
        (LENGTH, changed("archive3dm", json!("seven"))),
        (LENGTH, changed("opennurbs", json!(1.5))),
        (LENGTH, changed("opennurbs", json!(1_u64 << 40))),
        (LENGTH, changed("data", json!("no base64!"))),
        (LENGTH, changed("data", json!(""))),
        (LENGTH, changed("data", json!(17))),
        (LENGTH, changed("data", json!([]))),
        (LENGTH, json!({"version": 10000, "archive3dm": 70, "opennurbs": 0})),
        // Sound, and of another class than asked for.
        (LENGTH, mesh()),
        (VOLUME, circle()),
        (LENGTH, json!({"Radius": 1})),
        (LENGTH, json!([1, 2, 3])),
        (LENGTH, json!(null)),
        (LENGTH, json!({"url": "http://127.0.0.1/curve"})),
    ] {
        let answer = compute.post(path, &json!([object])).await;
        assert!(answer.is_refused(), "{path} {object:.80}: {} {}", answer.status, answer.text());
    }
    // In a definition the same holds for data of an input that takes curves.
    for data in [changed("archive3dm", json!(999)), mesh(), changed("data", json!("AAAA"))] {
        let answer = compute.solve(&gh(CURVE), json!([input("RH_IN:c", "{0}", &[data])])).await;
        let says = answer.status == 500 && !answer.json()["errors"].as_array().unwrap().is_empty();
        assert!(answer.is_refused() || says, "{} {}", answer.status, answer.text());
    }
    compute.is_well().await;
}

/// Curves of curves of curves, as deep as they can be made.
#[tokio::test(flavor = "multi_thread")]
async fn objects_in_objects() {
    let compute = Compute::start().await;
    let mut curve = Curve::from(Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)));
    let mut levels = 0;
    while let Ok(deeper) = PolyCurve::new(vec![curve.clone()]) {
        curve = Curve::from(deeper);
        levels += 1;
    }
    assert!((16..=64).contains(&levels), "{levels}");
    let answer = compute.post(LENGTH, &json!([curve.to_json(70).unwrap()])).await;
    assert!(answer.is_refused() || answer.json() == json!(1.0), "{} {}", answer.status, answer.text());
    compute.is_well().await;
}

/// Points and distances that no geometry can be made of.
#[tokio::test(flavor = "multi_thread")]
async fn numbers_that_are_none() {
    let compute = Compute::start().await;
    let loft = "/rhino/geometry/brep/createfromloft-curvearray_point3d_point3d_lofttype_bool";
    let ball = |radius: Value| json!([{"Radius": radius, "Center": [0, 0, 0]}, 2]);
    let ring = |radius: Value| json!({"Radius": radius, "Plane": Plane::XY.to_json(70).unwrap()});
    for (path, body) in [
        ("mesh/createicosphere-sphere_int", ball(json!("NaN"))),
        ("mesh/createicosphere-sphere_int", ball(json!("Infinity"))),
        ("mesh/createicosphere-sphere_int", ball(json!(-1))),
        ("mesh/createicosphere-sphere_int", json!([{"Radius": 1, "Center": ["NaN", 0, 0]}, 2])),
        ("curve/createinterpolatedcurve-point3darray_int", json!([[["NaN", 0, 0], [1, 0, 0], [2, 1, 0]], 3])),
        (
            "curve/createinterpolatedcurve-point3darray_int",
            json!([[{"X": "1e999", "Y": 0, "Z": 0}, [1, 0, 0]], 3]),
        ),
        ("curve/getlength-curve_double", json!([circle(), "NaN"])),
        ("curve/getlength-curve_double", json!([ring(json!("NaN")), 1e-8])),
    ] {
        let answer = compute.post(&format!("/rhino/geometry/{path}"), &body).await;
        assert!(answer.is_refused(), "{path} {body:.100}: {} {}", answer.status, answer.text());
    }
    // JSON itself has no such numbers.
    for number in ["NaN", "Infinity", "1e999"] {
        let body = format!("[[[{number},0,0],[1,0,0],[2,1,0]],3]");
        let path = "/rhino/geometry/curve/createinterpolatedcurve-point3darray_int";
        let answer = compute.ask("POST", path, "", body.as_bytes()).await;
        assert!(answer.is_refused(), "{number}: {} {}", answer.status, answer.text());
    }
    // Numbers at the end of their range are numbers: refused in words, or nothing but finite numbers come out.
    let huge = |x: f64| Curve::from(Line::new(Point3::ORIGIN, Point3::new(x, 0.0, 0.0))).to_json(70);
    let Ok(huge) = huge(1e308) else { panic!("it can be written") };
    let answer = compute.post(loft, &json!([[huge, circle()], null, null, 0, false])).await;
    assert!(answer.is_refused() || is_sound(&answer), "{} {:.300}", answer.status, answer.text());
    compute.is_well().await;
}

/// The same through definitions: points of a triangulation, a loft, a difference of solids.
#[tokio::test(flavor = "multi_thread")]
async fn numbers_that_are_none_in_definitions() {
    let compute = Compute::start_with(|config| katydid_server::compute::Config {
        timeout: Duration::from_secs(20),
        ..config
    })
    .await;
    let net = gh("katydid 1\np = Point()\nx = Delaunay Mesh(p)\n\"RH_IN:p\": p\n\"RH_OUT:x\": x\n");
    let points = |first: Value| {
        let point = |x: f64, y: f64| json!({"X": x, "Y": y, "Z": 0.0});
        json!([input("RH_IN:p", "{0}", &[first, point(1.0, 0.0), point(0.0, 1.0), point(1.0, 1.0)])])
    };
    for x in ["NaN", "Infinity", "-Infinity", "1e999", "many"] {
        let answer = compute.solve(&net, points(json!({"X": x, "Y": 0, "Z": 0}))).await;
        assert!(answer.is_refused(), "{x}: {} {:.300}", answer.status, answer.text());
    }
    let numbers = "katydid 1\nr = Number()\na = Circle(XY Plane(), r)\nb = Move(a, Unit Z(4))\nl = Loft(a, b)\n\
        s = Sphere(XY Plane(), r)\nx = Volume(s)\n\"RH_IN:r\": r\n\"RH_OUT:l\": l\n\"RH_OUT:x\": x\n";
    let numbers = gh(numbers);
    for text in ["NaN", "Infinity", "1e999"] {
        let answer = compute.solve(&numbers, json!([input("RH_IN:r", "{0}", &[json!(text)])])).await;
        assert!(answer.is_refused(), "{text}: {} {:.300}", answer.status, answer.text());
    }
    for (definition, values) in [
        (&net, points(json!({"X": 1e308, "Y": -1e308, "Z": 1e308}))),
        (&numbers, json!([input("RH_IN:r", "{0}", &[json!(1e308)])])),
        (&numbers, json!([input("RH_IN:r", "{0}", &[json!(1e-308)])])),
    ] {
        let start = Instant::now();
        let answer = compute.solve(definition, values).await;
        let says = answer.status == 500 && !answer.json()["errors"].as_array().unwrap().is_empty();
        assert!(
            says || answer.is_refused() || answer.status == 200,
            "{} {:.300}",
            answer.status,
            answer.text()
        );
        assert!(start.elapsed() < Duration::from_secs(30));
    }
    compute.is_well().await;
}

#[tokio::test(flavor = "multi_thread")]
async fn tolerances_and_units_that_are_none() {
    let compute = Compute::start().await;
    let algo = gh(crate::definitions::SUM);
    for (member, value) in [
        ("absolutetolerance", json!(-1)),
        ("absolutetolerance", json!("NaN")),
        ("absolutetolerance", json!("Infinity")),
        ("absolutetolerance", json!(1e308)),
        ("absolutetolerance", json!([1])),
        ("angletolerance", json!(-1)),
        ("angletolerance", json!("NaN")),
        ("modelunits", json!("Parsecs")),
        ("modelunits", json!(7)),
    ] {
        let mut body = json!({"algo": algo, "absolutetolerance": 0.01, "angletolerance": 1.0});
        body[member] = value.clone();
        let answer = compute.post("/grasshopper", &body).await;
        assert!(answer.is_refused(), "{member} {value}: {} {}", answer.status, answer.text());
        assert!(answer.text().contains(member), "it says which: {}", answer.text());
    }
    // The protocol takes 0 for none.
    let body = json!({"algo": algo, "absolutetolerance": 0, "angletolerance": 0, "modelunits": ""});
    assert_eq!(compute.post("/grasshopper", &body).await.output("RH_OUT:sum"), 5.0);
    let planar = "/rhino/geometry/brep/createplanarbreps-curvearray_double";
    for tolerance in [json!(-1), json!("NaN"), json!(1e308), json!("wide"), json!({})] {
        let answer = compute.post(planar, &json!([[circle()], tolerance])).await;
        assert!(answer.is_refused(), "{tolerance}: {} {}", answer.status, answer.text());
    }
    // 0 is the document's own, as in Rhino.
    assert_eq!(compute.post(planar, &json!([[circle()], 0])).await.status, 200);
    compute.is_well().await;
}
