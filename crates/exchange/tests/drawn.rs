//! What drawings show beyond geometry, SubDs, and the colours of OBJ.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

use katydid_3dm::{
    CurveForm, Hatch, HatchFill, HatchLoop, HatchPattern, Limits, Model, ModelObject, Object, TextDot,
};
use katydid_exchange::{
    Error, Fill, Format, Label, LabelSize, LeftOut, Options, Scene, Shape, Thing, read, read_with, write,
    write_materials,
};
use katydid_geometry::subd::{SubD, SubDNet};
use katydid_geometry::{Circle, Curve, Line, Mesh, MeshFace, Plane, Point2, Point3, Vector3};

fn written(scene: &Scene, format: Format, options: &Options) -> (String, Vec<LeftOut>) {
    let mut out = Vec::new();
    let left_out = write(scene, format, options, &mut out).unwrap();
    (String::from_utf8_lossy(&out).into_owned(), left_out)
}

fn square(size: f64) -> Mesh {
    let corners = [[0.0, 0.0], [size, 0.0], [size, size], [0.0, size]].map(|[x, y]| Point3::new(x, y, 0.0));
    Mesh::new(corners.to_vec(), vec![MeshFace::Quad([0, 1, 2, 3])]).unwrap()
}

/// A ring about (10, 0, 5) in a plane that stands upright, filled with the pattern of a number.
fn ring(pattern: i32) -> ModelObject {
    let frame = Plane::from_axes(Point3::new(10.0, 0.0, 5.0), Vector3::X, Vector3::Z).unwrap();
    let circle = |radius: f64| -> Curve { Circle::new(Plane::XY, radius).unwrap().into() };
    let boundary = |outer: bool, radius: f64| HatchLoop { outer, curve: CurveForm::of(&circle(radius), 2) };
    let hatch = Hatch {
        plane: frame.into(),
        scale: 1.0,
        rotation: 0.0,
        pattern,
        loops: vec![boundary(true, 3.0), boundary(false, 1.0)],
        base_point: Point2::ORIGIN,
    };
    let mut object = ModelObject::from(Object::Hatch(Box::new(hatch)));
    object.attributes.colour = Some([200, 30, 7, 255]);
    object
}

#[test]
fn hatches_are_areas_in_drawings_and_boundaries_elsewhere() {
    let mut model = Model::default();
    let lines = HatchFill::Lines(Vec::new());
    model.hatch_patterns.push(HatchPattern::default());
    model.hatch_patterns.push(HatchPattern { fill: lines, ..HatchPattern::default() });
    model.objects = vec![ring(0), ring(1)];
    let scene = Scene::from_model(&model);
    let Shape::Region(region) = &scene.things[0].shape else { panic!("{:?}", scene.left_out) };
    let bounds = region.boundaries[0].bounding_box();
    assert!(bounds.min.distance_to(Point3::new(7.0, 0.0, 2.0)) < 1e-9, "{bounds:?}");
    assert_eq!(region.fill, Fill::Solid);
    let front = Options { view: katydid_exchange::View::Front, ..Options::default() };
    let (svg, left_out) = written(&scene, Format::Svg, &front);
    assert!(svg.contains("<path stroke=\"none\" fill-rule=\"evenodd\" fill=\"#c81e07\" d=\""), "{svg}");
    assert!(svg.contains("fill=\"#c81e07\" fill-opacity=\"0.25\""), "{svg}");
    assert_eq!(left_out, [LeftOut::new("pattern of a hatch", 1, "a tint stands for it")]);
    let (obj, left_out) = written(&scene, Format::Obj, &Options::default());
    assert_eq!(obj.lines().filter(|line| line.starts_with("l ")).count(), 4);
    assert_eq!((left_out[0].class.as_str(), left_out[0].count), ("hatch", 2));
    let (_, left_out) = written(&scene, Format::Stl, &Options::default());
    assert_eq!(left_out, [LeftOut::new("hatch", 2, "STL holds triangles only")]);
}

#[test]
fn dots_and_text_are_text_in_drawings_and_told_of_elsewhere() {
    let mut model = Model::default();
    let dot = Object::TextDot(TextDot::new(Point3::new(1.0, 2.0, 3.0), "a < b"));
    model.objects.push(dot.clone().into());
    // Text in a block turns with it.
    let quarter = katydid_geometry::Xform::rotation(std::f64::consts::FRAC_PI_2, Vector3::Z, Point3::ORIGIN);
    let id = model.add_block("b", vec![dot.into()]);
    let reference = katydid_3dm::BlockReference::new(id, quarter.unwrap());
    model.objects.push(Object::BlockReference(Box::new(reference)).into());
    let mut scene = Scene::from_model(&model);
    let Shape::Text(placed) = &scene.things[1].shape else { panic!("{:?}", scene.left_out) };
    assert!(placed.point.distance_to(Point3::new(-2.0, 1.0, 3.0)) < 1e-12);
    let label = Label {
        text: "wall".into(),
        point: Point3::ORIGIN,
        axes: [Vector3::X, Vector3::Y],
        size: LabelSize::Units(2.5),
        across: 0.0,
        upward: 0.0,
        font: String::new(),
    };
    scene.things.push(Thing::named("t", Shape::Text(label)));
    let (svg, left_out) = written(&scene, Format::Svg, &Options::default());
    assert_eq!(svg.matches("<text ").count(), 3, "{svg}");
    assert!(svg.contains(">a &lt; b</tspan>") && svg.contains("fill=\"#000000\""), "{svg}");
    assert!(left_out.is_empty());
    for format in [Format::Obj, Format::Ply, Format::Glb, Format::Stl] {
        let (_, left_out) = written(&scene, format, &Options::default());
        assert_eq!((left_out[0].class.as_str(), left_out[0].count), ("text", 3), "{format:?}");
    }
    // From the side the text in the plane cannot be read; the dots turn.
    let front = Options { view: katydid_exchange::View::Front, ..Options::default() };
    let (svg, left_out) = written(&scene, Format::Svg, &front);
    assert_eq!((svg.matches("<text ").count(), left_out[0].class.as_str()), (2, "text"));
    assert_eq!(scene.to_model().counts()["TextDot"], 3);
}

#[test]
fn real_annotations_and_hatches_have_their_places() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data/3dm/");
    for (name, texts, regions) in [
        ("mcneel+opennurbs__bb42dd69_V6_annotation.3dm", 2, 0),
        ("mcneel+opennurbs__d6a6724d_v8_selective_clipping.3dm", 3, 3),
    ] {
        let Ok(bytes) = std::fs::read(format!("{folder}{name}")) else { return };
        let model = Model::read(&bytes, &Limits::default()).unwrap();
        let all = katydid_exchange::Conversion { hidden: true, ..Default::default() };
        let scene = Scene::from_model_with(&model, &all);
        let count = |is: fn(&Shape) -> bool| scene.things.iter().filter(|thing| is(&thing.shape)).count();
        let found = [count(|s| matches!(s, Shape::Text(_))), count(|s| matches!(s, Shape::Region(_)))];
        assert_eq!(found, [texts, regions], "{name}: {:?}", scene.left_out);
    }
}

#[test]
fn subds_are_their_surface() {
    // A cube's surface by Catmull and Clark: at a corner of valence 3 it lies at half the control point, by (9 v + 4 Σe + Σf) / 24 by hand.
    let corners: Vec<Point3> = (0..8_u32)
        .map(|i| {
            let side = |bit: u32| if i & bit == 0 { -1.0 } else { 1.0 };
            Point3::new(side(1), side(2), side(4))
        })
        .collect();
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let net = SubDNet::from_polygons(corners, &sides.map(|side| side.to_vec())).unwrap();
    let mesh = SubD::new(net).limit_mesh(3).unwrap();
    assert_eq!(mesh.faces().len(), 6 * 64);
    let corner = mesh.vertices()[7];
    let expected = (9.0 + 4.0 * (1.0 + 1.0 - 1.0) + (1.0 - 1.0 - 1.0)) / 24.0;
    assert!(corner.distance_to(Point3::new(expected, expected, expected)) < 1e-12, "{corner:?}");
    assert!(mesh.is_closed() && mesh.check().is_ok());
}

#[test]
fn colours_of_things_come_back_from_obj() {
    let thing = |name: &str, colour, shape| Thing { colour, ..Thing::named(name, shape) };
    let red = Some([255, 0, 51, 255]);
    let line: Curve = Line::new(Point3::ORIGIN, Point3::new(1.0, 2.0, 3.0)).into();
    let scene = Scene {
        things: vec![
            thing("a", red, Shape::Mesh(square(1.0))),
            thing("b", None, Shape::Mesh(square(2.0))),
            thing("c", Some([0, 128, 0, 100]), Shape::Curve(line)),
            thing("d", red, Shape::Points(vec![Point3::ORIGIN].into())),
        ],
        ..Scene::default()
    };
    let options = Options { materials: Some("the colours.mtl".into()), ..Options::default() };
    let (obj, _) = written(&scene, Format::Obj, &options);
    let mut mtl = Vec::new();
    write_materials(&scene, &mut mtl).unwrap();
    assert_eq!(String::from_utf8_lossy(&mtl).matches("newmtl ").count(), 3);
    let back = read_with(obj.as_bytes(), Format::Obj, &mut |name| {
        if name == "the colours.mtl" { Ok(mtl.clone()) } else { Err(Error::Unsupported(name.into())) }
    });
    let back = back.unwrap();
    let of = |scene: &Scene| scene.things.iter().map(|t| (t.name.clone(), t.colour)).collect::<Vec<_>>();
    assert_eq!(of(&back), of(&scene));
    // Without its materials it is read all the same, and says so.
    let bare = read(obj.as_bytes(), Format::Obj).unwrap();
    assert_eq!((bare.things.len(), bare.things[0].colour), (4, None));
    assert!(bare.left_out[0].to_string().contains("file of materials"), "{:?}", bare.left_out);
    // Nobody asked for materials, or there are none to name.
    assert!(!written(&scene, Format::Obj, &Options::default()).0.contains("mtl"));
    let plain = Scene { things: vec![Thing::named("p", Shape::Mesh(square(1.0)))], ..Scene::default() };
    assert!(!written(&plain, Format::Obj, &options).0.contains("mtl"));
}

#[test]
fn a_material_that_changes_within_an_object_parts_it() {
    let obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\no x\nusemtl r\nf 1 2 3\nusemtl g\nf 2 4 3\nusemtl g\nf 1 2 4\n";
    let mtl = "newmtl r\nKd 1 0 0\nnewmtl g\nKd 0 1 0\n";
    let scene = read_with(obj.as_bytes(), Format::Obj, &mut |_| Ok(mtl.into())).unwrap();
    let colours: Vec<_> = scene.things.iter().map(|thing| thing.colour).collect();
    assert_eq!(colours, [Some([255, 0, 0, 255]), Some([0, 255, 0, 255])]);
    let Shape::Mesh(second) = &scene.things[1].shape else { panic!() };
    assert_eq!((second.faces().len(), scene.things[1].name.as_str()), (2, "x"));
}
