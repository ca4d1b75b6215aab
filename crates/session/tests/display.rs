//! Previews, read back by a reader of their own.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test may fail loudly"
)]

mod reader;

use katydid_data::cast::Rules;
use katydid_data::{Path, Tree, Value};
use katydid_definition::document::{Object, ids};
use katydid_geometry::{
    Circle, Curve, Interval, KnotSpacing, Mesh, NurbsCurve, Plane, PlaneSurface, Point3, Rectangle, Sphere,
    Surface,
};
use katydid_session::display::{Fineness, Geometry, Preview, Shown, encode};
use katydid_session::protocol::PartKind;
use reader::Read;
use uuid::{Uuid, uuid};

const CUSTOM_PREVIEW: Uuid = uuid!("537b0419-bbc2-4ff4-bf08-afe526367b2c");

fn object() -> Object {
    Object::new_parameter(ids::GEOMETRY, "Geometry", "Geo", Uuid::from_u128(7))
}

fn tree(values: impl IntoIterator<Item = Value>) -> Tree {
    Tree::branch_at(
        Path::from([0, 3].as_slice()),
        katydid_data::Column::of_values(values.into_iter().collect(), None),
    )
}

fn shown(tree: Tree, fineness: Fineness) -> Preview {
    let object = object();
    let outputs = [tree];
    let shown = Shown { object: &object, outputs: &outputs, inputs: &[] };
    encode(&[shown], &Rules::default(), fineness, || true).remove(0)
}

fn read(values: impl IntoIterator<Item = Value>) -> Read {
    Read::new(&shown(tree(values), Fineness::Smooth).geometry.unwrap())
}

#[test]
fn points_far_from_the_origin_keep_their_places_among_themselves() {
    let far = |x: f64| Point3::new(4e6 + x, -7e6, 1e3);
    let read = read([0.0, 0.001, 0.5].map(|x| Value::Point(far(x))));
    let part = read.part(PartKind::Points);
    for (found, x) in read.points(part).iter().zip([0.0, 0.001, 0.5]) {
        assert!(found.distance_to(far(x)) < 1e-6, "{found:?}");
    }
    let pieces: Vec<_> =
        part.pieces.iter().map(|p| (p.path.as_str(), p.index, p.start, p.count, p.items)).collect();
    assert_eq!(pieces, [("{0;3}", 0, 0, 1, 3)]);
    assert_eq!((part.colour, read.header.object), (None, Uuid::from_u128(7)));
}

#[test]
fn a_circle_is_as_long_as_it_should_be() {
    let circle = Circle::new(Plane::XY, 10.0).unwrap();
    let read = read([Value::from(circle)]);
    let part = read.part(PartKind::Curves);
    let length = read.length(part);
    let exact = 20.0 * std::f64::consts::PI;
    assert!((length - exact).abs() < 5e-4 * exact, "{length}");
    for p in read.points(part) {
        assert!((p.distance_to(Point3::ORIGIN) - 10.0).abs() < 1e-5);
    }
    assert!(read.drawn(part, 2).len() >= 68, "turns by 0.09 at most");
}

#[test]
fn a_ball_has_its_own_normals_and_curvatures() {
    let ball: Surface = Sphere::around(Point3::new(1.0, 2.0, 3.0), 2.0).unwrap().into();
    let read = read([Value::from(ball)]);
    let mesh = read.part(PartKind::Mesh);
    let area = read.area(mesh);
    let exact = 16.0 * std::f64::consts::PI;
    assert!(area < exact && area > 0.995 * exact, "{area}");
    let normals = read.singles(mesh.normals.as_ref().unwrap());
    for (p, n) in read.points(mesh).iter().zip(normals.chunks(3)) {
        let out = (*p - Point3::new(1.0, 2.0, 3.0)) * 0.5;
        let off = (out.x - f64::from(n[0])).abs()
            + (out.y - f64::from(n[1])).abs()
            + (out.z - f64::from(n[2])).abs();
        assert!(off < 2e-2, "{p:?} {n:?}");
    }
    for gaussian in read.singles(mesh.values.as_ref().unwrap()) {
        assert!((gaussian - 0.25).abs() < 1e-4, "{gaussian}");
    }
    for mean in read.singles(mesh.mean.as_ref().unwrap()) {
        assert!((mean.abs() - 0.5).abs() < 1e-4, "{mean}");
    }
    let [low, high] = mesh.range.unwrap();
    assert!((low - 0.25).abs() < 1e-4 && (high - 0.25).abs() < 1e-4);
    for p in read.points(read.part(PartKind::Isocurves)) {
        assert!((p.distance_to(Point3::new(1.0, 2.0, 3.0)) - 2.0).abs() < 1e-5);
    }
    assert!(read.part(PartKind::Edges).indices.is_some());
}

#[test]
fn a_flat_surface_is_two_triangles_with_four_borders() {
    let side = Interval::new(0.0, 3.0);
    let square: Surface = PlaneSurface::new(Plane::XY, side, side).unwrap().into();
    let read = read([Value::from(square)]);
    let mesh = read.part(PartKind::Mesh);
    assert!((read.area(mesh) - 9.0).abs() < 1e-6 && read.indices(mesh).len() == 6);
    assert!((read.length(read.part(PartKind::Edges)) - 12.0).abs() < 1e-6);
    assert!(mesh.values.is_none());
}

#[test]
fn a_mesh_has_its_edges_once_and_creases() {
    let box_ = katydid_geometry::Box3 {
        plane: Plane::XY,
        x: Interval::new(0.0, 1.0),
        y: Interval::new(0.0, 2.0),
        z: Interval::new(0.0, 3.0),
    };
    let welded = Mesh::cuboid(&box_, 1, 1, 1).unwrap().welded(std::f64::consts::PI);
    // Without normals: those of a welded mesh are its own, and smooth.
    let mesh = Mesh::new(welded.vertices().to_vec(), welded.faces().to_vec()).unwrap();
    assert_eq!(mesh.vertices().len(), 8);
    for value in [Value::from(mesh.clone()), Value::from(box_)] {
        let read = read([value]);
        let part = read.part(PartKind::Mesh);
        assert!((read.area(part) - 22.0).abs() < 1e-6);
        let normals = read.singles(part.normals.as_ref().unwrap());
        let upright = |n: &[f32]| n.iter().filter(|x| x.abs() > 0.99).count() == 1;
        assert!(normals.chunks(3).all(upright), "every corner of a box is sharp");
        let edges = read.part(PartKind::Edges);
        assert_eq!(edges.positions, part.positions, "edges stand on the mesh's own points");
        let mut lines: Vec<String> = read
            .drawn(edges, 2)
            .iter()
            .map(|line| {
                let mut ends = [format!("{:?}", line[0]), format!("{:?}", line[1])];
                ends.sort();
                ends.concat()
            })
            .collect();
        lines.sort();
        lines.dedup();
        assert_eq!(lines.len(), 12);
    }
    let coloured = mesh.with_colours(&[[1, 2, 3, 255]]);
    let read = read([Value::from(coloured)]);
    let part = read.part(PartKind::Mesh);
    assert!(read.colours(part).iter().all(|colour| *colour == [1, 2, 3, 255]));
}

#[test]
fn while_dragging_there_are_few_triangles_in_all() {
    let grid = |n: usize| {
        let side = Interval::new(0.0, 100.0);
        Mesh::plane(&Rectangle { plane: Plane::XY, x: side, y: side }, n, n).unwrap()
    };
    let objects: Vec<Object> =
        (0..4).map(|k| Object::new_parameter(ids::GEOMETRY, "Geometry", "Geo", Uuid::from_u128(k))).collect();
    let ball: Surface = Sphere::around(Point3::ORIGIN, 2.0).unwrap().into();
    let outputs: Vec<[Tree; 1]> = vec![
        [tree([Value::from(grid(300))])],
        [tree([Value::from(grid(300))])],
        [tree([Value::from(grid(10))])],
        [tree((0..30).map(|_| Value::from(ball.clone())))],
    ];
    let shown: Vec<Shown<'_>> = objects
        .iter()
        .zip(&outputs)
        .map(|(object, outputs)| Shown { object, outputs, inputs: &[] })
        .collect();
    let draft =
        encode(&shown, &Rules::default(), Fineness::Draft { triangles: 50_000, exact: false }, || true);
    let geometry: Vec<&Geometry> = draft.iter().map(|preview| preview.geometry.as_ref().unwrap()).collect();
    let all: usize = geometry.iter().map(|geometry| geometry.triangles).sum();
    assert!(all <= 50_000 && all > 20_000, "{all}");
    let is_draft: Vec<bool> = geometry.iter().map(|geometry| geometry.is_draft).collect();
    assert_eq!(is_draft, [true, true, false, true]);
    assert_eq!(geometry[2].triangles, 200);
    let read = Read::new(geometry[0]);
    assert!((read.area(read.part(PartKind::Mesh)) - 1e4).abs() < 400.0);
    let full = encode(&shown, &Rules::default(), Fineness::Coarse, || true);
    assert_eq!(full[0].geometry.as_ref().unwrap().triangles, 180_000);
    assert_eq!(full[2].geometry.as_ref().unwrap().hash, geometry[2].hash, "what is whole is not sent again");
}

#[test]
fn while_dragging_many_curves_have_few_segments() {
    let circle = Curve::from(Circle::new(Plane::XY, 10.0).unwrap());
    let through: Vec<Point3> =
        (0..=200).map(|k| circle.point_at(circle.domain().at(f64::from(k) / 200.0))).collect();
    let spline = NurbsCurve::interpolate(3, &through, KnotSpacing::Chord, None, None).unwrap();
    let curves = |count: usize| tree((0..count).map(|_| Value::from(Curve::from(spline.clone()))));
    let draft = Fineness::Draft { triangles: 50_000, exact: false };
    let geometry = shown(curves(61), draft).geometry.unwrap();
    assert!(geometry.is_draft);
    let read = Read::new(&geometry);
    let part = read.part(PartKind::Curves);
    assert!(read.drawn(part, 2).len() < 61 * 50);
    let exact = 61.0 * 20.0 * std::f64::consts::PI;
    assert!((read.length(part) - exact).abs() < 0.01 * exact);
    // Of few, each span is drawn, as when nothing is dragged.
    let few = shown(curves(60), draft).geometry.unwrap();
    assert!(!few.is_draft);
    assert_eq!(few.hash, shown(curves(60), Fineness::Coarse).geometry.unwrap().hash);
}

#[test]
fn a_custom_preview_has_its_colour() {
    let mut object = Object::new_component(CUSTOM_PREVIEW, "Custom Preview", "Preview", Uuid::from_u128(9));
    katydid_components::link();
    object.hidden = false;
    let red = katydid_data::Colour::argb(255, 200, 10, 20);
    let material = katydid_data::Material { transparency: 0.5, ..red.into() };
    let ball: Surface = Sphere::around(Point3::ORIGIN, 2.0).unwrap().into();
    let inputs = [tree([Value::from(ball)]), tree([Value::Material(material.into())])];
    let shown = Shown { object: &object, outputs: &[], inputs: &inputs };
    let preview = encode(&[shown], &Rules::default(), Fineness::Coarse, || true).remove(0);
    let read = Read::new(&preview.geometry.unwrap());
    assert_eq!(read.part(PartKind::Mesh).colour, Some([200, 10, 20, 128]));
    assert_eq!(read.part(PartKind::Mesh).pieces[0].path, "{0;3}");
}

#[test]
fn what_is_hidden_shows_nothing() {
    let mut object = object();
    let outputs = [tree([Value::Point(Point3::ORIGIN)])];
    for (hidden, locked) in [(true, false), (false, true)] {
        object.hidden = hidden;
        object.locked = locked;
        let shown = Shown { object: &object, outputs: &outputs, inputs: &[] };
        let preview = encode(&[shown], &Rules::default(), Fineness::Coarse, || true).remove(0);
        assert!(preview.geometry.is_none());
    }
    assert!(shown(tree([Value::Number(1.0), Value::from("text")]), Fineness::Coarse).geometry.is_none());
}

#[test]
fn equal_data_has_equal_bytes_and_what_is_not_wanted_is_not_made() {
    let curve = || Value::from(Curve::from(Circle::new(Plane::XY, 1.0).unwrap()));
    let hash = |values: Vec<Value>| shown(tree(values), Fineness::Coarse).geometry.unwrap().hash;
    assert_eq!(hash(vec![curve()]), hash(vec![curve()]));
    assert_ne!(hash(vec![curve()]), hash(vec![curve(), curve()]));
    let object = object();
    let outputs = [tree([curve()])];
    let shown = Shown { object: &object, outputs: &outputs, inputs: &[] };
    assert!(encode(&[shown], &Rules::default(), Fineness::Coarse, || false).is_empty());
}

#[test]
fn many_colours_are_told_point_by_point() {
    let mut object = Object::new_component(CUSTOM_PREVIEW, "Custom Preview", "Preview", Uuid::from_u128(9));
    katydid_components::link();
    object.hidden = false;
    let points = (0..200).map(|k| Value::Point(Point3::new(f64::from(k), 0.0, 0.0)));
    let materials = (0..200_u8).map(|k| {
        let diffuse = katydid_data::Colour::argb(255, k, 0, 0);
        Value::Material(katydid_data::Material::from(diffuse).into())
    });
    let inputs = [tree(points), tree(materials)];
    let shown = Shown { object: &object, outputs: &[], inputs: &inputs };
    let preview = encode(&[shown], &Rules::default(), Fineness::Coarse, || true).remove(0);
    let read = Read::new(&preview.geometry.unwrap());
    let part = read.part(PartKind::Points);
    let colours = read.colours(part);
    assert_eq!((colours.len(), colours[150][0]), (200, 150));
}
