//! Transforms: every point goes where the transform says, and the content of solids grows as its determinant says.

use std::sync::Arc as Shared;

use katydid_3dm::{Limits, Object};
use katydid_component::testing::Trial;
use katydid_data::Value;
use katydid_geometry::Point3;
use katydid_geometry::{Box3, Curve, Interval, Plane, PolylineCurve, Rectangle, Vector3, Xform};

use crate::kinds::{chain, distance, kept, kinds, p, points, run, volume};

/// How far an image may be from where the transform sends a point: rounding, of shapes about 10 in size.
const NEAR: f64 = 1e-7;

/// A transform with all its inputs but the geometry.
type Moving = Box<dyn Fn(Value) -> Trial>;

/// Every transform that takes a geometry first and gives its image and its map.
fn transforms() -> Vec<(&'static str, Moving)> {
    let tilted = || Plane::from_axes(p(3.0, -1.0, 2.0), Vector3::new(1.0, 1.0, 0.0), Vector3::Z).unwrap();
    let rectangle =
        |x: f64, y: f64| Rectangle { plane: Plane::XY, x: Interval::new(0.0, x), y: Interval::new(0.0, y) };
    let triangle = |s: f64| {
        let corners = [[0.0, 0.0, 0.0], [s, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 0.0]].map(Point3::from);
        Curve::from(PolylineCurve::new(corners.to_vec()).unwrap())
    };
    let around = |s: f64| Box3 {
        plane: Plane::XY,
        x: Interval::new(0.0, s),
        y: Interval::new(0.0, 2.0),
        z: Interval::new(0.0, 1.0),
    };
    let projected = "23285717-156c-468f-a691-b242488c06a6";
    vec![
        ("Move", Box::new(|g| Trial::of("Move").item(g).item(Vector3::new(1.0, -2.0, 3.0)))),
        ("Rotate", Box::new(move |g| Trial::of("Rotate").item(g).item(0.7).item(tilted()))),
        ("Rotate 3D", Box::new(|g| Trial::of("Rotate 3D").item(g).item(0.7).default().item(Vector3::Y))),
        ("Rotate Axis", Box::new(|g| Trial::of("Rotate Axis").item(g).item(1.1).default())),
        (
            "Rotate Direction",
            Box::new(|g| Trial::of("Rotate Direction").item(g).default().item(Vector3::X).item(Vector3::Z)),
        ),
        ("Mirror", Box::new(move |g| Trial::of("Mirror").item(g).item(tilted()))),
        ("Orient", Box::new(move |g| Trial::of("Orient").item(g).item(Plane::XY).item(tilted()))),
        ("Scale", Box::new(|g| Trial::of("Scale").item(g).item(p(1.0, 0.0, 0.0)).item(2.5))),
        ("Scale by −1", Box::new(|g| Trial::of("Scale").item(g).item(p(1.0, 0.0, 0.0)).item(-1.0))),
        (
            "Scale NU",
            Box::new(|g| Trial::of("Scale NU").item(g).item(Plane::XY).item(2.0).item(0.5).item(3.0)),
        ),
        (
            "Scale NU askew",
            Box::new(move |g| Trial::of("Scale NU").item(g).item(tilted()).item(2.0).item(-0.5).item(1.0)),
        ),
        (
            "Shear",
            Box::new(|g| Trial::of("Shear").item(g).default().item(p(0.0, 0.0, 1.0)).item(p(0.5, 1.0, 1.0))),
        ),
        ("Shear Angle", Box::new(|g| Trial::of("Shear Angle").item(g).default().item(0.3).item(-0.2))),
        (
            "Camera Obscura",
            Box::new(|g| Trial::of("Camera Obscura").item(g).item(p(0.5, 0.0, 0.0)).item(0.5)),
        ),
        (
            "Orient Direction",
            Box::new(|g| {
                let from = Trial::of("Orient Direction").item(g).default().item(Vector3::Z);
                from.item(p(1.0, 1.0, 1.0)).item(Vector3::X * 2.0)
            }),
        ),
        (
            "Rectangle Mapping",
            Box::new(move |g| {
                Trial::of("Rectangle Mapping").item(g).item(rectangle(1.0, 1.0)).item(rectangle(2.0, 5.0))
            }),
        ),
        (
            "Box Mapping",
            Box::new(move |g| Trial::of("Box Mapping").item(g).item(around(1.0)).item(around(3.0))),
        ),
        (
            "Triangle Mapping",
            Box::new(move |g| Trial::of("Triangle Mapping").item(g).item(triangle(1.0)).item(triangle(3.0))),
        ),
        ("Transform", {
            let mut xform = Xform::shear(&Plane::XY, [[0.5, 0.0], [0.0, 0.2], [0.0, 0.0]]);
            xform.rows[0][3] = 2.0;
            Box::new(move |g| Trial::of("Transform").item(g).item(Value::Transform(Shared::new(xform))))
        }),
        ("Project", Box::new(move |g| Trial::of_guid(projected).item(g).item(Plane::XY))),
        (
            "Project Along",
            Box::new(|g| Trial::of("Project Along").item(g).default().item(Vector3::new(0.3, 0.1, -1.0))),
        ),
    ]
}

#[test]
fn every_transform_takes_every_geometry() {
    katydid_components::link();
    for (name, trial) in transforms() {
        let flat = name.starts_with("Project");
        for (kind, value) in kinds() {
            if flat && kind == "plane" {
                // What is left of it need not be a plane.
                continue;
            }
            let (image, map) = run(name, kind, trial(value.clone()));
            let map = map.unwrap_or_else(|| {
                let mut xform = Xform::shear(&Plane::XY, [[0.5, 0.0], [0.0, 0.2], [0.0, 0.0]]);
                xform.rows[0][3] = 2.0;
                xform
            });
            if let Value::Vector(v) = value {
                assert_eq!(image, Value::Vector(map.vector(v)), "{name}");
                continue;
            }
            if let (true, Some(_)) = (flat, value.brep()) {
                // A flattened solid is a heap of flat faces: it is enough that there is one, and that it is flat.
                let at = points(&image);
                assert!(at.iter().all(|q| q.z.abs() < NEAR), "{name} of a {kind}");
                continue;
            }
            for q in points(&value) {
                let miss = distance(&image, map.point(q));
                assert!(miss < NEAR, "{name} of a {kind}: {q:?} is {miss} off");
            }
            if let Some(brep) = image.brep() {
                let brep = brep.unwrap();
                assert!(brep.is_valid(), "{name} of a {kind}: {:?}", brep.faults());
            }
            if let Some(before) = volume(&value) {
                let (after, factor) = (volume(&image).unwrap_or(f64::NAN), map.determinant().abs());
                let near = (after - before * factor).abs() <= 1e-6 * before.abs() * factor;
                assert!(near, "{name} of a {kind}: {before} × {factor} becomes {after}");
            }
        }
    }
}

#[test]
fn a_trimmed_face_keeps_its_area_under_a_twofold_stretch() {
    // Twice as long in each direction by two steps that are no similarities: the area is four times what it was.
    katydid_components::link();
    for (kind, value) in kinds().into_iter().filter(|(kind, _)| kind.starts_with("trimmed")) {
        let area = |value: &Value| {
            let brep = value.brep().unwrap().unwrap();
            brep.area_properties(1e-9, || true).unwrap().amount
        };
        let stretch = |g: Value, [x, y, z]: [f64; 3]| {
            run("Scale NU", kind, Trial::of("Scale NU").item(g).default().item(x).item(y).item(z)).0
        };
        let image = stretch(stretch(value.clone(), [2.0, 1.0, 4.0]), [1.0, 2.0, 0.5]);
        let (before, after) = (area(&value), area(&image));
        assert!((after - 4.0 * before).abs() < 1e-6 * after, "{kind}: {before} and {after}");
    }
}

#[test]
fn arrays_take_every_geometry() {
    katydid_components::link();
    let cell = Box3 { plane: Plane::XY, x: Interval::UNIT, y: Interval::UNIT, z: Interval::UNIT };
    let square = Rectangle { plane: Plane::XY, x: Interval::UNIT, y: Interval::UNIT };
    for (kind, value) in kinds() {
        let arrays = [
            (3, Trial::of("Linear Array").item(value.clone()).item(Vector3::X * 5.0).item(3)),
            (8, Trial::of("Box Array").item(value.clone()).item(cell).item(2).item(2).item(2)),
            (4, Trial::of("Rectangular Array").item(value.clone()).item(square).item(2).item(2)),
            (3, Trial::of("Polar Array").item(value.clone()).default().item(3).default()),
            (4, Trial::of("Kaleidoscope").item(value.clone()).default().item(4)),
            (3, Trial::of("Curve Array").item(value.clone()).item(chain()).item(3)),
        ];
        for (count, trial) in arrays {
            let outcome = trial.run();
            assert!(outcome.messages.is_empty(), "{kind}: {:?}", outcome.messages);
            let tree = outcome.outputs.first().unwrap();
            let images = tree.column();
            assert!(images.len() >= count, "{kind}: {} images", images.len());
            assert!((0..images.len()).all(|i| images.get(i).is_some()), "{kind}");
        }
    }
}

/// Every Brep and extrusion inside the definitions at hand goes through a stretch and a turn.
#[test]
fn stored_solids_of_real_files() {
    katydid_components::link();
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data/3dm");
    let Ok(files) = std::fs::read_dir(folder) else {
        println!("skipped: {folder} is absent");
        return;
    };
    let (mut seen, mut faults) = (0, Vec::new());
    for file in files {
        let path = file.unwrap().path();
        let Ok(bytes) = std::fs::read(&path) else { continue };
        let Ok(model) = katydid_3dm::Model::read(&bytes, &Limits::default()) else { continue };
        for object in model.objects {
            let Object::Brep(brep) = &object.geometry else { continue };
            if !brep.brep.is_valid() || brep.brep.faces().len() > 60 {
                continue;
            }
            let value = kept(object.geometry);
            seen += 1;
            let named = path.file_stem().unwrap().to_string_lossy().into_owned();
            for trial in [
                Trial::of("Scale NU").item(value.clone()).default().item(2.0).item(0.5).item(3.0),
                Trial::of("Rotate").item(value).item(0.5).default(),
            ] {
                let outcome = trial.run();
                let image = outcome.outputs.first().and_then(|tree| tree.column().get(0));
                match image.and_then(|image| image.brep()) {
                    Some(Ok(image)) if image.is_valid() => {}
                    other => faults.push(format!(
                        "{named} {}: {:?} {:?}",
                        object.attributes.id,
                        outcome.messages,
                        other.map(|image| image.map(|image| image.faults().first().cloned()))
                    )),
                }
            }
        }
    }
    assert!(seen == 0 || seen > 100, "{seen}");
    assert!(faults.is_empty(), "{} of {seen}: {}", faults.len(), faults.join("\n"));
}
