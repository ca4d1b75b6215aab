//! What components of plug-ins leave behind: files that are written, and models that are baked.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::fs;

use common::{katydid, said, text};
use katydid_3dm::Model;

/// A table of two columns that goes into a workbook.
const TABLE: &str = "katydid 1\n\
    rows = Series(1, 1, 3)\n\
    doubled = Multiplication(rows, 2)\n\
    data = Entwine(rows, doubled)\n\
    written = Excel Write(true, \"C:\\\\jobs\\\\areas.xlsx\", \"Areas\", [\"Room\", \"Area\"], data)\n";

#[test]
fn a_workbook_is_written_where_the_user_says() {
    let folder = tempfile::tempdir().unwrap();
    let (definition, into) = (folder.path().join("a.kd"), folder.path().join("out"));
    fs::write(&definition, TABLE).unwrap();
    let without = katydid(&["run", text(&definition)]);
    assert!(said(&without).contains("--write"), "{}", said(&without));
    assert!(!into.exists());

    let with = katydid(&["run", text(&definition), "--write", text(&into)]);
    assert_eq!(with.status.code(), Some(0), "{}", said(&with));
    let book = into.join("areas.xlsx");
    assert!(book.exists(), "{}", said(&with));

    // Read again by a definition beside it.
    let reader = into.join("b.kd");
    fs::write(
        &reader,
        "katydid 1\nread = Excel Reader(true, \"areas.xlsx\", \"Areas\")\nout = Panel(read)\n",
    )
    .unwrap();
    let read = katydid(&["run", text(&reader), "--json=values"]);
    let told = String::from_utf8(read.stdout.clone()).unwrap();
    assert!(["Room", "Area", "6"].iter().all(|word| told.contains(word)), "{}{told}", said(&read));
}

/// A circle with attributes, baked by EleFront's components, beside a circle that is only seen.
const BAKED: &str = "katydid 1\n\
    seen = Circle(Construct Point(5, 0, 0), 1)\n\
    door = Circle(Construct Point(0, 0, 0), 2)\n\
    how = Define Object Attributes(\"Number\", \"12\", \"door\", \"Walls::Doors\", rgb(255, 0, 0))\n\
    told = Boolean Toggle(true)\n\
    baked = Bake Objects(door, how, \"doors\", told)\n";

#[test]
fn objects_are_baked_with_what_they_are_given() {
    let folder = tempfile::tempdir().unwrap();
    let (definition, out) = (folder.path().join("a.kd"), folder.path().join("a.3dm"));
    fs::write(&definition, BAKED).unwrap();
    let ran = katydid(&["run", text(&definition), "-o", text(&out)]);
    assert_eq!(ran.status.code(), Some(0), "{}", said(&ran));
    let model = Model::read(&fs::read(&out).unwrap(), &Default::default()).unwrap();
    assert_eq!(model.objects.len(), 1, "only what is baked is saved: {}", said(&ran));
    let attributes = &model.objects[0].attributes;
    assert_eq!(attributes.name, "door");
    assert_eq!(attributes.colour, Some([255, 0, 0, 255]));
    assert_eq!(attributes.layer.map(|layer| model.layers[layer].name.as_str()), Some("Doors"));
    // These and no others: where a piece comes from is told of what is only shown.
    let texts: Vec<(&str, &str)> =
        attributes.user_strings.iter().map(|(key, text)| (key.as_str(), text.as_str())).collect();
    assert_eq!(texts, [("Number", "12"), ("BakeName", "doors")]);
}

/// A circle that is baked without attributes, by either plug-in's component.
#[test]
fn what_is_baked_without_attributes_has_none() {
    let folder = tempfile::tempdir().unwrap();
    let (definition, out) = (folder.path().join("a.kd"), folder.path().join("a.3dm"));
    for baker in ["Bake Objects(door, _, _, told)", "Bake Geometry(told, door)"] {
        let source = format!(
            "katydid 1\ndoor = Circle(Construct Point(0, 0, 0), 2)\ntold = Boolean Toggle(true)\nbaked = {baker}\n"
        );
        fs::write(&definition, source).unwrap();
        let ran = katydid(&["run", text(&definition), "-o", text(&out)]);
        assert_eq!(ran.status.code(), Some(0), "{}", said(&ran));
        let model = Model::read(&fs::read(&out).unwrap(), &Default::default()).unwrap();
        assert_eq!(model.objects.len(), 1, "{}", said(&ran));
        let attributes = &model.objects[0].attributes;
        assert!(attributes.name.is_empty() && attributes.user_strings.is_empty(), "{attributes:?}");
        assert_eq!(attributes.layer.map(|layer| model.layers[layer].name.as_str()), Some("Default"));
    }
}
