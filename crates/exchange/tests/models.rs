//! Models as scenes: blocks, layers, colours, what is hidden, and what is kept beside breps.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::path::PathBuf;

use common::summary;
use katydid_3dm::{BlockReference, Layer, Limits, Material, Model, ModelObject, Object, ObjectMode, Source};
use katydid_exchange::{Conversion, Format, Options, Scene, Shape, write};
use katydid_geometry::{Circle, Curve, Line, Mesh, MeshFace, Plane, Point3, Sphere, Surface, Vector3, Xform};

fn square(size: f64) -> Mesh {
    let corners = [[0.0, 0.0], [size, 0.0], [size, size], [0.0, size]].map(|[x, y]| Point3::new(x, y, 0.0));
    Mesh::new(corners.to_vec(), vec![MeshFace::Quad([0, 1, 2, 3])]).unwrap()
}

fn object(geometry: Object, layer: usize) -> ModelObject {
    let mut object = ModelObject::from(geometry);
    object.attributes.layer = Some(layer);
    object
}

fn reference(block: uuid::Uuid, motion: Xform) -> Object {
    Object::BlockReference(Box::new(BlockReference::new(block, motion)))
}

#[test]
fn blocks_are_what_they_hold_where_they_stand() {
    let mut model = Model::default();
    let layer = model.layer_at("parts");
    let circle: Curve = Circle::new(Plane::XY, 1.0).unwrap().into();
    let mut coloured = object(Object::Curve(circle), layer);
    coloured.attributes.colour_source = Source::Parent;
    let inner = model.add_block("inner", vec![coloured, object(Object::from(square(1.0)), layer)]);
    let double = Xform::scale(Point3::ORIGIN, 2.0);
    let outer = model.add_block("outer", vec![object(reference(inner, double), layer)]);
    let mut placed = object(reference(outer, Xform::translation(Vector3::new(10.0, 0.0, 0.0))), layer);
    placed.attributes.name = "placed".into();
    placed.attributes.colour = Some([1, 2, 3, 255]);
    model.objects.push(placed);
    model.objects.push(object(reference(uuid::Uuid::from_u128(7), Xform::IDENTITY), layer));
    let scene = Scene::from_model(&model);
    assert_eq!(scene.things.len(), 2, "{:?}", scene.left_out);
    let Shape::Curve(Curve::Arc(arc)) = &scene.things[0].shape else { panic!("a circle stays one") };
    assert_eq!((arc.arc.circle.radius, arc.arc.circle.center()), (2.0, Point3::new(10.0, 0.0, 0.0)));
    let Shape::Mesh(mesh) = &scene.things[1].shape else { panic!() };
    assert_eq!(mesh.area(), 4.0);
    assert_eq!(scene.left_out.len(), 1);
    assert!(scene.left_out[0].to_string().contains("is not in the model"));
}

#[test]
fn blocks_that_hold_each_other_come_to_an_end() {
    let mut model = Model::default();
    let layer = model.layer_at("l");
    let id = model.add_block("round", vec![object(Object::from(square(1.0)), layer)]);
    let mut again = object(reference(id, Xform::IDENTITY), layer);
    again.attributes.mode = ObjectMode::InDefinition;
    again.attributes.id = uuid::Uuid::from_u128(99);
    for _ in 0..2 {
        model.blocks[0].members.push(again.attributes.id);
    }
    model.objects.push(again.clone());
    model.objects.push(object(reference(id, Xform::IDENTITY), layer));
    let start = std::time::Instant::now();
    let scene = Scene::from_model(&model);
    assert!(scene.things.len() <= 1_000_000 && !scene.left_out.is_empty());
    assert!(start.elapsed().as_secs() < 30);
}

#[test]
fn what_is_hidden_is_left_out_and_counted() {
    let mut model = Model::default();
    let (top, under) = (model.layer_at("top"), model.layer_at("top::under"));
    model.layers[top].visible = false;
    let shown = model.layer_at("shown");
    let point = || Object::Point(Point3::ORIGIN);
    let mut hidden = object(point(), shown);
    hidden.attributes.mode = ObjectMode::Hidden;
    let mut invisible = object(point(), shown);
    invisible.attributes.visible = false;
    model.objects = vec![object(point(), under), object(point(), shown), hidden, invisible];
    let scene = Scene::from_model(&model);
    assert_eq!(scene.things.len(), 1);
    assert_eq!(scene.left_out[0].to_string(), "3 × Point: hidden");
    let all = Scene::from_model_with(&model, &Conversion { hidden: true, ..Conversion::default() });
    assert_eq!(all.things.len(), 4);
}

#[test]
fn colours_come_from_the_object_the_material_and_the_layer() {
    let mut model = Model::default();
    model.materials.push(Material { diffuse: [9, 8, 7, 255], transparency: 0.5, ..Material::default() });
    model.layers = vec![
        Layer { colour: [0, 0, 0, 255], ..Layer::new("black") },
        Layer { colour: [10, 20, 30, 255], ..Layer::new("coloured") },
        Layer { colour: [10, 20, 30, 255], material: Some(0), ..Layer::new("material") },
    ];
    let mesh = |layer| object(Object::from(square(1.0)), layer);
    let line: Curve = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)).into();
    let mut own = mesh(2);
    own.attributes.material = Some(0);
    own.attributes.material_source = Source::Object;
    own.attributes.colour = Some([0, 0, 0, 255]);
    let mut red = mesh(1);
    red.attributes.colour = Some([255, 0, 0, 255]);
    model.objects = vec![mesh(0), mesh(1), mesh(2), own, red, object(Object::Curve(line), 0)];
    let scene = Scene::from_model(&model);
    let colours: Vec<_> = scene.things.iter().map(|thing| thing.colour).collect();
    let material = Some([9, 8, 7, 128]);
    let expected =
        [None, Some([10, 20, 30, 255]), material, material, Some([255, 0, 0, 255]), Some([0, 0, 0, 255])];
    assert_eq!(colours, expected);
}

#[test]
fn surfaces_have_facets_and_borders() {
    let mut model = Model::default();
    let ball: Surface = Sphere::around(Point3::ORIGIN, 1.0).unwrap().into();
    model.objects.push(Object::Surface(ball).into());
    let scene =
        Scene::from_model_with(&model, &Conversion { tolerance: Some(1e-4), hidden: false, exact: false });
    let Shape::Faces { facets: Some(mesh), edges } = &scene.things[0].shape else { panic!() };
    assert_eq!(edges.len(), 1);
    let ratio = mesh.area() / (4.0 * std::f64::consts::PI);
    assert!((0.999..1.0).contains(&ratio), "{ratio}");
}

#[test]
fn a_scene_becomes_a_model_and_a_scene_again() {
    let scene = common::sample();
    let model = scene.to_model();
    assert_eq!(model.objects.len(), scene.things.len());
    let back = Scene::from_model(&model);
    let (a, b) = (summary(&scene, 1.0), summary(&back, 1.0));
    assert_eq!((a.meshes, a.area, a.length), (b.meshes, b.area, b.length));
    assert_eq!(back.things[0].name, scene.things[0].name);
    assert_eq!(back.things[0].colour, scene.things[0].colour);
    assert_eq!(model.layer_path(model.objects[0].attributes.layer.unwrap()).unwrap(), "outer::inner");
}

#[test]
fn every_real_model_is_written_in_every_format() {
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data/3dm"));
    let Ok(entries) = std::fs::read_dir(&folder) else {
        assert!(std::env::var_os("KATYDID_REQUIRE_SHARED").is_none(), "{} is absent", folder.display());
        return println!("skipped: {} is absent", folder.display());
    };
    let mut files: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    files.retain(|path| path.extension().is_some_and(|e| e == "3dm"));
    let (mut models, mut things) = (0, 0);
    for path in files {
        let Ok(model) = Model::read(&std::fs::read(&path).unwrap(), &Limits::default()) else { continue };
        let scene =
            Scene::from_model_with(&model, &Conversion { tolerance: Some(0.1), hidden: false, exact: false });
        models += 1;
        things += scene.things.len();
        let mut visible = model.objects.iter().filter(|o| o.attributes.mode != ObjectMode::InDefinition);
        let left: usize = scene.left_out.iter().map(|one| one.count).sum();
        assert!(
            scene.things.len() + left >= visible.by_ref().count(),
            "{}: nothing is lost in silence",
            path.display()
        );
        for format in Format::ALL {
            let mut bytes = Vec::new();
            let options = Options { tolerance: Some(0.1), ..Options::default() };
            write(&scene, format, &options, &mut bytes)
                .unwrap_or_else(|e| panic!("{} {format:?}: {e}", path.display()));
            if format == Format::Glb {
                gltf::Gltf::from_slice(&bytes).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
            }
            if format != Format::Svg {
                katydid_exchange::read(&bytes, format)
                    .unwrap_or_else(|e| panic!("{} {format:?}: {e}", path.display()));
            }
        }
    }
    println!("{models} models, {things} things");
}
