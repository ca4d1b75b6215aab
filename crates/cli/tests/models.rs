//! Models on the command line: `convert`, `info`, and geometry saved for other programs.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::path::Path;

use common::{katydid, said, shared, text};
use katydid_3dm::{Limits, Model, Object};
use katydid_geometry::{Circle, Curve, Mesh, MeshFace, Plane, Point3};
use serde_json::Value;

const EXAMPLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/attractor.ghx");

/// A circle, a mesh and a degenerate mesh on two layers.
fn sample(path: &Path, version: i32) {
    let mut model = Model::default();
    let layer = model.layer_at("walls::inner");
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
    let good = Mesh::new(corners.to_vec(), vec![MeshFace::Quad([0, 1, 2, 3])]).unwrap();
    let bad = Mesh::new(corners.to_vec(), vec![MeshFace::Triangle([0, 1, 1])]).unwrap();
    let circle: Curve = Circle::new(Plane::XY, 2.0).unwrap().into();
    for (name, object) in
        [("circle", Object::Curve(circle)), ("good", Object::from(good)), ("bad", Object::from(bad))]
    {
        let mut object = katydid_3dm::ModelObject::from(object);
        object.attributes.name = name.into();
        object.attributes.layer = Some(layer);
        model.objects.push(object);
    }
    std::fs::write(path, model.write(version).unwrap()).unwrap();
}

#[test]
fn models_are_converted_to_every_format_and_version() {
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("model.3dm");
    sample(&model, 70);
    for extension in ["obj", "stl", "ply", "glb", "gltf", "svg"] {
        let out = folder.path().join("model").with_extension(extension);
        let output = katydid(&["convert", text(&model), text(&out)]);
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
        assert!(std::fs::metadata(&out).unwrap().len() > 80, "{extension}");
        let told = said(&output).contains("1 × curve: STL holds triangles only");
        assert_eq!(told, extension == "stl", "{}", said(&output));
        if extension != "svg" {
            let back = folder.path().join(format!("from-{extension}.3dm"));
            let output = katydid(&["convert", text(&out), text(&back), "--version", "6"]);
            assert_eq!(output.status.code(), Some(0), "{}", said(&output));
            let read = Model::read(&std::fs::read(&back).unwrap(), &Limits::default()).unwrap();
            assert_eq!(read.archive_version, 60);
            assert!(read.counts().contains_key("Mesh"), "{:?}", read.counts());
        }
    }
    for (asked, version) in [("4", 4), ("50", 50), ("6", 60), ("70", 70), ("8", 80)] {
        let out = folder.path().join("other.3dm");
        let output = katydid(&["convert", text(&model), text(&out), "--version", asked]);
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
        let read = Model::read(&std::fs::read(&out).unwrap(), &Limits::default()).unwrap();
        assert_eq!((read.archive_version, read.objects.len()), (version, 3));
        assert_eq!(read.objects[0].attributes.name, "circle");
    }
}

#[test]
fn wrong_calls_say_why() {
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("model.3dm");
    sample(&model, 70);
    let out = folder.path().join("out");
    let with = |extension: &str| out.with_extension(extension);
    for (words, reason) in [
        (
            vec!["convert", text(&model), text(&with("dwg"))],
            "can be converted to .3dm, .obj, .stl, .ply, .glb, .gltf, .step or .svg",
        ),
        (vec!["convert", EXAMPLE, text(&with("obj"))], "use katydid run -o"),
        (vec!["convert", text(&model), text(&with("obj")), "--version", "7"], "--version is for .3dm files"),
        (vec!["convert", text(&model), text(&with("3dm")), "--version", "3"], "expected 4, 5, 6, 7 or 8"),
        (vec!["convert", text(&model), text(&with("svg")), "--tolerance", "0"], "above 0"),
        (vec!["convert", EXAMPLE, text(&with("kd")), "--ascii"], "are for models"),
        (vec!["convert", EXAMPLE, text(&with("kd")), "--lenient"], "are for models"),
        (vec!["convert", "scan.ply", text(&with("3dm")), "--lenient"], "for .3dm files that are read"),
        (vec!["convert", "nowhere.3dm", text(&with("obj"))], "no such file"),
        (vec!["convert", "x.mtl", text(&with("3dm"))], "x.mtl: it holds the materials of an .obj file"),
        (vec!["convert", "x.mtl", text(&with("kd"))], "x.mtl: a definition is read from"),
        (vec!["convert", "x.dwg", text(&with("3dm"))], "models that end with .dwg are not read"),
        (vec!["convert", "x", text(&with("obj"))], "no ending"),
        (vec!["info", EXAMPLE], "not a .3dm archive"),
    ] {
        let output = katydid(&words);
        assert_eq!(output.status.code(), Some(2), "{words:?}");
        assert!(said(&output).contains(reason), "{words:?}: {}", said(&output));
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "nothing is left behind");
}

#[test]
fn info_tells_what_is_there_and_what_is_wrong() {
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("model.3dm");
    sample(&model, 80);
    let output = katydid(&["info", text(&model), "--json"]);
    assert_eq!(output.status.code(), Some(1), "a mesh is not valid: {}", said(&output));
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&report["version"], &report["units"]), (&80.into(), &"Millimeters".into()));
    assert_eq!((&report["tables"]["object"], &report["tables"]["layer"]), (&3.into(), &2.into()));
    assert_eq!((&report["objects"]["Mesh"], &report["objects"]["ArcCurve"]), (&2.into(), &1.into()));
    assert_eq!(
        (&report["layers"][1]["path"], &report["layers"][1]["objects"]),
        (&"walls::inner".into(), &3.into())
    );
    let faults = report["invalid"].as_array().unwrap();
    assert_eq!((faults.len(), &faults[0]["name"]), (1, &"bad".into()));
    let output = katydid(&["info", text(&model)]);
    let told = String::from_utf8(output.stdout).unwrap();
    assert!(
        told.contains("version 80") && told.contains("walls::inner") && told.contains("invalid: Mesh 'bad'"),
        "{told}"
    );
}

/// A sample whose second object is broken.
fn broken(path: &Path) {
    sample(path, 70);
    let mut bytes = std::fs::read(path).unwrap();
    let records: Vec<usize> = {
        let mut found = Vec::new();
        katydid_3dm::outline(&bytes, 1, |chunk| {
            if chunk.name == Some("object record") {
                found.push(chunk.offset);
            }
        })
        .unwrap();
        found
    };
    // Behind the record's header and its kind stands the class object: its length passes the end of all.
    let length = records[1] + 12 + 12 + 4;
    bytes[length..length + 8].copy_from_slice(&(1_u64 << 40).to_le_bytes());
    std::fs::write(path, &bytes).unwrap();
}

#[test]
fn a_broken_model_is_refused_unless_lenient() {
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("model.3dm");
    broken(&model);
    let out = folder.path().join("out.obj");
    let definition = ["run", EXAMPLE, "--model", text(&model)];
    for words in [vec!["info", text(&model)], vec!["convert", text(&model), text(&out)], definition.to_vec()]
    {
        let output = katydid(&words);
        assert_eq!(output.status.code(), Some(2), "{words:?}: {}", said(&output));
        let told = said(&output);
        // Where, in which chunks, why, and what to do about it.
        for part in ["at byte ", "object table › object record", "needs 1099511627776 bytes", "--lenient"] {
            assert!(told.contains(part), "{words:?}: {part} is not in {told}");
        }
        assert!(!out.exists());
    }
    let output = katydid(&["convert", text(&model), text(&out), "--lenient"]);
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    assert!(
        said(&output).contains("skipped") && said(&output).contains("1 × object record"),
        "{}",
        said(&output)
    );
    assert!(std::fs::read_to_string(&out).unwrap().contains("o circle\n"));
    let output = katydid(&["info", text(&model), "--lenient", "--json"]);
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        (&report["skipped"]["object"], &report["warnings"][0]["kind"]),
        (&1.into(), &"skipped".into())
    );
    assert!(report["warnings"][0]["path"].as_str().unwrap().starts_with("object table"));
    let output = katydid(&["info", text(&model), "--lenient"]);
    assert!(String::from_utf8(output.stdout).unwrap().contains("skipped: at byte "));
    let output = katydid(&[&definition[..], &["--lenient"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    assert!(said(&output).contains("1 × object record"), "{}", said(&output));
    // What is no model at all is not broken.
    let output = katydid(&["info", EXAMPLE]);
    assert!(!said(&output).contains("--lenient"));
}

#[test]
fn the_tree_shows_the_chunks_and_their_checksums() {
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("model.3dm");
    sample(&model, 70);
    let output = katydid(&["info", text(&model), "--tree", "--depth", "0"]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let top = String::from_utf8(output.stdout).unwrap();
    assert!(
        top.lines().next().unwrap().contains("comment 00000001") && !top.contains("object record"),
        "{top}"
    );
    let output = katydid(&["info", text(&model), "--tree", "--depth", "4"]);
    let tree = String::from_utf8(output.stdout).unwrap();
    assert!(
        tree.contains("object record ArcCurve") && tree.contains("class data") && tree.contains("CRC right"),
        "{tree}"
    );
    let mut bytes = std::fs::read(&model).unwrap();
    let place = bytes.len() / 2;
    bytes.truncate(place);
    std::fs::write(&model, &bytes).unwrap();
    let output = katydid(&["info", text(&model), "--tree"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8(output.stdout).unwrap().contains("no end mark"));
    assert_eq!(
        katydid(&["info", text(&model), "--depth", "3"]).status.code(),
        Some(2),
        "a depth needs a tree"
    );
}

#[test]
fn a_definition_is_run_into_every_format() {
    let folder = tempfile::tempdir().unwrap();
    let outs: Vec<_> =
        ["ply", "glb", "gltf", "svg"].map(|e| folder.path().join("a").with_extension(e)).into();
    let mut words = vec!["run", EXAMPLE];
    outs.iter().for_each(|out| words.extend(["-o", text(out)]));
    let output = katydid(&words);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let svg = std::fs::read_to_string(&outs[3]).unwrap();
    assert_eq!(svg.matches("<path ").count(), 130);
    assert!(svg.contains("inkscape:label=\"Circles\""), "{}", &svg[..600]);
}

#[test]
fn real_models_are_told_of_and_converted() {
    let folder = tempfile::tempdir().unwrap();
    for (name, out) in [
        ("jesterKing+import_3dm__399290a6_nested_blocks.3dm", "a.glb"),
        ("mcneel+opennurbs__c1df2172_v3_Terrain.3dm", "b.obj"),
        ("mcneel+opennurbs__63091e38_v5_extrusions.3dm", "c.svg"),
    ] {
        let Some(path) = shared(&format!("data/3dm/{name}")) else { return };
        let output = katydid(&["info", text(&path), "--json"]);
        assert!(output.status.code() < Some(2), "{name}: {}", said(&output));
        let report: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert!(report["objects"].as_object().unwrap().values().any(|n| n.as_u64() > Some(0)), "{name}");
        let out = folder.path().join(out);
        let output = katydid(&["convert", text(&path), text(&out)]);
        assert_eq!(output.status.code(), Some(0), "{name}: {}", said(&output));
        assert!(std::fs::metadata(&out).unwrap().len() > 500, "{name}: {}", said(&output));
    }
}
