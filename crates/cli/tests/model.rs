//! Definitions that look into a Rhino model.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use common::{katydid, said, text};
use katydid_3dm::{Attributes, BlockReference, Layer, Model, ModelObject, Object, ObjectMode};
use katydid_geometry::{Line, Point3, Units, Vector3, Xform};
use serde_json::Value;
use uuid::Uuid;

const DEFINITION: &str = "katydid 1

wall = Curve(geometry(ref = @00000000-0000-0000-0000-0000000000a1))
lost = Curve(geometry(ref = @00000000-0000-0000-0000-0000000000ff))
ends = End Points(wall)
all  = Geometry Pipeline()
";

/// The ids, the layers and the geometry that the definition asks for, in metres.
fn model() -> Model {
    let mut model = Model { units: Units::Meters, layers: vec![Layer::new("Walls")], ..Model::default() };
    let line = Line::new(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0));
    for (id, geometry) in
        [(0xa1, Object::Curve(line.into())), (0xa2, Object::Point(Point3::new(7.0, 0.0, 0.0)))]
    {
        let attributes = Attributes { id: Uuid::from_u128(id), ..Attributes::default() };
        model.objects.push(ModelObject { attributes, ..ModelObject::from(geometry) });
    }
    model
}

fn items<'a>(report: &'a Value, nickname: &str, output: usize) -> &'a Value {
    let mut objects = report["objects"].as_array().unwrap().iter();
    &objects.find(|o| o["nickname"] == nickname).unwrap()["outputs"][output]["branches"][0]["items"]
}

#[test]
fn referenced_objects_come_from_the_model() {
    let folder = tempfile::tempdir().unwrap();
    let (definition, rhino) = (folder.path().join("d.kd"), folder.path().join("m.3dm"));
    std::fs::write(&definition, DEFINITION).unwrap();
    std::fs::write(&rhino, model().write(70).unwrap()).unwrap();

    let without = katydid(&["run", text(&definition)]);
    assert_eq!(without.status.code(), Some(0));
    let words = said(&without);
    assert!(words.contains("wall") && words.contains("00000000-0000-0000-0000-0000000000a1"), "{words}");
    assert!(words.contains("Needs the Rhino model") && words.contains("--model"), "{words}");

    let with = katydid(&["run", text(&definition), "--model", text(&rhino), "--json"]);
    assert_eq!(with.status.code(), Some(0), "{}", said(&with));
    let report: Value = serde_json::from_slice(&with.stdout).unwrap();
    assert_eq!(report["units"], "Meters");
    assert_eq!(items(&report, "ends", 1)[0], "{3, 4, 0}");
    assert_eq!(items(&report, "all", 0).as_array().unwrap().len(), 2);
    let words = said(&with);
    assert!(words.contains("lost") && words.contains("is not in the Rhino model"), "{words}");
}

#[test]
fn a_model_that_cannot_be_read_is_exit_code_2() {
    let folder = tempfile::tempdir().unwrap();
    let definition = folder.path().join("d.kd");
    std::fs::write(&definition, DEFINITION).unwrap();
    for model in [text(&definition), "nowhere.3dm"] {
        let output = katydid(&["run", text(&definition), "--model", model]);
        assert_eq!(output.status.code(), Some(2));
        assert!(said(&output).contains(model), "{}", said(&output));
    }
}

const REPEATED: &str = "katydid 1

x       = Series(0, 3, 4)
circles = Circle(Construct Point(x, 0, 0), 1)
both    = Group(circles)
seen    = Custom Preview(circles, rgb(255, 0, 0))
";

#[test]
fn baked_geometry_has_layers_colours_groups_user_text_and_blocks() {
    let folder = tempfile::tempdir().unwrap();
    let definition = folder.path().join("d.kd");
    std::fs::write(&definition, REPEATED).unwrap();
    let baked = |name: &str, words: &[&str]| {
        let out = folder.path().join(name);
        let all = [&["run", text(&definition), "-o", text(&out)], words].concat();
        assert_eq!(katydid(&all).status.code(), Some(0));
        Model::read(&std::fs::read(&out).unwrap(), &Default::default()).unwrap()
    };
    let plain = baked("plain.3dm", &[]);
    let on = |name: &str| {
        let layer = plain.layers.iter().position(|layer| layer.name == name);
        plain.objects.iter().filter(move |object| object.attributes.layer == layer)
    };
    assert!(plain.blocks.is_empty());
    assert_eq!((on("circles").count(), on("both").count(), on("seen").count()), (4, 4, 4));
    assert!(on("seen").all(|object| object.attributes.colour == Some([255, 0, 0, 255])));
    assert!(on("both").all(|object| object.attributes.groups == [0]) && plain.groups.len() == 1);
    let third = &on("circles").nth(2).unwrap().attributes.user_strings;
    assert!(
        third.contains(&("Path".into(), "{0;0}".into())) && third.contains(&("Index".into(), "2".into()))
    );

    let blocks = baked("blocks.3dm", &["--blocks"]);
    assert_eq!(blocks.blocks.len(), 3);
    let shifts: Vec<f64> = (blocks.objects.iter())
        .filter(|object| object.attributes.name == "circles")
        .filter_map(|object| match &object.geometry {
            Object::BlockReference(reference) => Some(reference.transform.translation_part().x),
            _ => None,
        })
        .collect();
    assert_eq!(shifts, [1.0, 4.0, 7.0, 10.0]);
}

const CONTENT: &str = "katydid 1

walls = Query Model Objects(_, \"Walls\")
changed = Model Object(walls, _, \"beam\", \"House::Roof\", \"locked\", rgb(1, 2, 3))
noted = User Text(changed.Object, \"Floor\", \"3\")
seats = Query Model Objects(\"seat\")
_first = Context Bake(noted.0)
_second = Context Bake(seats)
names = Panel(changed.Name)
layers = Panel(changed.Layer)
";

#[test]
fn objects_of_the_model_are_changed_and_baked_with_their_attributes_and_blocks() {
    let mut model = model();
    model.objects[0].attributes.layer = Some(0);
    model.objects[0].attributes.user_strings =
        vec![("Floor".into(), "1".into()), ("Use".into(), "shop".into())];
    let inside = ModelObject::from(Object::Point(Point3::new(0.0, 0.0, 1.0)));
    let block = model.add_block("Chair", vec![inside]);
    let by = Xform::translation(Vector3::new(4.0, 0.0, 0.0));
    let attributes = Attributes { name: "seat".into(), ..Attributes::default() };
    let reference = Object::BlockReference(Box::new(BlockReference::new(block, by)));
    model.objects.push(ModelObject { attributes, ..ModelObject::from(reference) });

    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("d.kd"), CONTENT).unwrap();
    std::fs::write(path("m.3dm"), model.write(70).unwrap()).unwrap();
    let (d, m, o) = (path("d.kd"), path("m.3dm"), path("o.3dm"));
    let output = katydid(&["run", text(&d), "--model", text(&m), "-o", text(&o), "--json"]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(items(&report, "names", 0)[0], "beam");
    assert_eq!(items(&report, "layers", 0)[0], "House::Roof");

    let baked = Model::read(&std::fs::read(&o).unwrap(), &Default::default()).unwrap();
    let free: Vec<&ModelObject> =
        baked.objects.iter().filter(|object| object.attributes.mode != ObjectMode::InDefinition).collect();
    let beam = &free.iter().find(|object| object.attributes.name == "beam").unwrap().attributes;
    assert_eq!(baked.layer_path(beam.layer.unwrap()).unwrap(), "House::Roof");
    assert_eq!((beam.colour, beam.mode), (Some([1, 2, 3, 255]), ObjectMode::Locked));
    let strings = &beam.user_strings;
    assert!(
        strings.contains(&("Floor".into(), "3".into())) && strings.contains(&("Use".into(), "shop".into()))
    );
    let seat = free.iter().find(|object| object.attributes.name == "seat").unwrap();
    let Object::BlockReference(reference) = &seat.geometry else { panic!("{:?}", seat.geometry) };
    assert_eq!(reference.transform, by);
    let chair = baked.block_by_id(reference.definition).unwrap();
    assert_eq!((chair.name.as_str(), baked.members(chair).count()), ("Chair", 1));
}
