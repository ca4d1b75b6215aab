//! The Rhino model beside a definition, as a viewport gets it.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test may fail loudly"
)]

mod reader;

use katydid_3dm::{Attributes, Layer, Model, ModelObject, Object};
use katydid_component::RhinoModel;
use katydid_data::cast::Rules;
use katydid_geometry::{Line, Point3, Sphere, Surface};
use katydid_session::display::encode_model;
use katydid_session::protocol::PartKind;
use reader::Read;
use uuid::Uuid;

fn object(id: u128, layer: usize, geometry: Object, visible: bool) -> ModelObject {
    let attributes =
        Attributes { id: Uuid::from_u128(id), layer: Some(layer), visible, ..Attributes::default() };
    ModelObject { attributes, ..ModelObject::from(geometry) }
}

fn line(x: f64) -> Object {
    Object::Curve(Line::new(Point3::new(x, 0.0, 0.0), Point3::new(x, 4.0, 3.0)).into())
}

fn model() -> RhinoModel {
    let mut hidden = Layer::new("Site");
    hidden.visible = false;
    let ball: Surface = Sphere::around(Point3::ORIGIN, 2.0).unwrap().into();
    let objects = vec![
        object(1, 0, line(0.0), true),
        object(2, 1, line(9.0), true),
        object(3, 0, Object::Surface(ball), true),
        object(4, 0, line(5.0), false),
    ];
    RhinoModel::new(Model { layers: vec![Layer::new("Walls"), hidden], objects, ..Model::default() })
}

#[test]
fn each_layer_has_its_objects_and_their_geometry() {
    let preview = encode_model(&model(), &Rules::default(), || true).unwrap();
    let [walls, site] = preview.view.layers.as_slice() else { panic!("{:?}", preview.view.layers) };
    assert_eq!((walls.path.as_str(), walls.hidden), ("Walls", false));
    assert_eq!((site.path.as_str(), site.hidden), ("Site", true));
    // An object that is hidden itself is left out; those of a hidden layer are there to be shown.
    let ids = |objects: &[katydid_session::protocol::ModelObjectView]| {
        objects.iter().map(|object| object.id.as_u128()).collect::<Vec<_>>()
    };
    assert_eq!((ids(&walls.objects), ids(&site.objects)), (vec![1, 3], vec![2]));
    assert_eq!(walls.objects[0].kind, "Curve");
    assert_eq!(walls.objects[1].kind, "Surface");
    let read = |hash: &Option<String>| {
        let geometry = preview.geometries.iter().find(|geometry| Some(&geometry.hash) == hash.as_ref());
        Read::new(geometry.unwrap())
    };
    let wall = read(&walls.geometry);
    assert_eq!(wall.header.object, walls.id);
    let curves = wall.part(PartKind::Curves);
    assert!((wall.length(curves) - 5.0).abs() < 1e-6);
    assert_eq!(curves.pieces[0].index, 0);
    let ball = wall.part(PartKind::Mesh);
    assert_eq!(ball.pieces[0].index, 1, "a piece says which object of the layer it is");
    assert!((wall.area(ball) / (16.0 * std::f64::consts::PI) - 1.0).abs() < 0.02);
    assert!((read(&site.geometry).length(read(&site.geometry).part(PartKind::Curves)) - 5.0).abs() < 1e-6);
}

#[test]
fn a_drawing_that_is_cancelled_gives_nothing() {
    assert!(encode_model(&model(), &Rules::default(), || false).is_none());
    let empty = encode_model(&RhinoModel::default(), &Rules::default(), || true).unwrap();
    assert!(empty.view.layers.is_empty() && empty.geometries.is_empty());
}

#[test]
fn of_very_many_objects_the_first_are_shown_and_the_rest_is_said() {
    let point =
        |k: u32| object(u128::from(k) + 1, 0, Object::Point(Point3::new(f64::from(k), 0.0, 0.0)), true);
    let objects = (0..20_001).map(point).collect();
    let model = RhinoModel::new(Model { layers: vec![Layer::new("Trees")], objects, ..Model::default() });
    let preview = encode_model(&model, &Rules::default(), || true).unwrap();
    assert_eq!(preview.view.layers[0].objects.len(), 20_000);
    assert!(preview.view.left_out[0].contains("20000"), "{:?}", preview.view.left_out);
}
