//! Geometry that inputs keep is moved, turned and scaled where it stands.

use katydid_component::registry;
use katydid_data::Value;
use katydid_geometry::{Brep, Curve, Interval, Mesh, Plane, Point3, Surface, Vector3, construct};
use katydid_session::protocol::{Drawing, Edit, GeometrySource, PlaneView};
use uuid::Uuid;

use crate::common::Studio;

const XY: PlaneView = PlaneView { origin: [0.0; 3], x: [1.0, 0.0, 0.0], y: [0.0, 1.0, 0.0] };

type Map = [[f64; 4]; 3];

/// A quarter turn about the z axis, and then a step of 10 along x.
const TURN: Map = [[0.0, -1.0, 0.0, 10.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
const DOUBLE: Map = [[2.0, 0.0, 0.0, 0.0], [0.0, 2.0, 0.0, 0.0], [0.0, 0.0, 2.0, 0.0]];

fn step(x: f64) -> Map {
    [[1.0, 0.0, 0.0, x], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]
}

/// A parameter of that name with something drawn in it, and its input.
fn with(studio: &mut Studio, parameter: &str, drawing: Drawing) -> (Uuid, Uuid) {
    let found = registry::all().into_iter().find(|one| one.floating && one.name == parameter && !one.old);
    let id = studio.place_as(found.unwrap().guid, [0.0, 0.0]);
    let port = studio.input(id, 0);
    studio.make(Edit::SetGeometry { port, items: vec![GeometrySource::Drawn { drawing }] });
    (id, port)
}

fn values(studio: &mut Studio, id: Uuid) -> Vec<Value> {
    studio.engine.solve();
    let at = studio.engine.document().objects.iter().position(|object| object.id == id).unwrap();
    studio.engine.report(at).unwrap().outputs[0].column().iter().flatten().collect()
}

#[test]
fn plain_values_follow_a_map() {
    let cases = [
        ("Point", Drawing::Point { at: [1.0, 2.0, 3.0] }, "{8, 1, 3}"),
        // A vector has no place: it is only turned.
        ("Vector", Drawing::Vector { along: [1.0, 2.0, 3.0] }, "{-2, 1, 3}"),
        ("Plane", Drawing::Plane { plane: XY }, "O(10.00,0.00,0.00) Z(0.00,0.00,1.00)"),
    ];
    for (parameter, drawing, image) in cases {
        let mut studio = Studio::empty();
        let (id, port) = with(&mut studio, parameter, drawing);
        studio.make(Edit::Transform { ports: vec![port], map: TURN });
        // Which zeros have a sign is nobody's business.
        let texts: Vec<String> = studio.texts(id).iter().map(|text| text.replace("-0.00", "0.00")).collect();
        assert_eq!(texts, [image], "{parameter}");
    }
}

#[test]
fn a_circle_stays_one_only_where_angles_stay() {
    let mut studio = Studio::empty();
    let circle = Drawing::Circle { plane: XY, radius: 2.0 };
    let (id, port) = with(&mut studio, "Circle", circle.clone());
    studio.make(Edit::Transform { ports: vec![port], map: DOUBLE });
    assert_eq!(studio.texts(id), ["Circle(R:4.00 mm)"]);
    let mut oval = DOUBLE;
    oval[1][1] = 1.0;
    let refused = studio.try_do(&Edit::Transform { ports: vec![port], map: oval }).unwrap_err();
    assert!(refused.to_string().contains("no Circle"), "{refused}");
    assert_eq!(studio.texts(id), ["Circle(R:4.00 mm)"]);
    // A curve may be an oval.
    let (id, port) = with(&mut studio, "Curve", circle);
    studio.make(Edit::Transform { ports: vec![port], map: oval });
    let [Value::Curve(oval)] = &values(&mut studio, id)[..] else { panic!("a curve") };
    assert!(oval.closest_point(Point3::new(4.0, 0.0, 0.0)).unwrap().distance < 1e-9);
    assert!(oval.closest_point(Point3::new(0.0, 2.0, 0.0)).unwrap().distance < 1e-9);
}

/// What a parameter shows that keeps a value as Grasshopper does, after a map.
fn kept(parameter: &str, value: Value, map: Map) -> Value {
    struct Given(Value);
    impl katydid_session::Results for Given {
        fn output(&self, _: Uuid, _: &[Uuid]) -> Option<katydid_data::Tree> {
            let column = katydid_data::Column::of_values(vec![self.0.clone()], None);
            Some(katydid_data::Tree::branch_at(katydid_data::Path::from([0].as_slice()), column))
        }
    }
    let mut studio = Studio::empty();
    let id = studio.place(parameter, [0.0, 0.0]);
    let port = studio.input(id, 0);
    let items = vec![GeometrySource::Item { port: Uuid::from_u128(7), path: "{0}".to_owned(), index: 0 }];
    let set = Edit::SetGeometry { port, items };
    let change = studio.editor.apply_with(&set, None, &[], &Given(value)).unwrap();
    studio.follow(&change);
    studio.make(Edit::Transform { ports: vec![port], map });
    // It is kept as a file has it, and read from there.
    let bytes = studio.editor.document().to_gh().unwrap();
    let limits = katydid_definition::archive::Limits::default();
    let again = katydid_definition::document::Document::read(&bytes, &limits).unwrap();
    values(&mut Studio::new(again), id).remove(0)
}

/// A box from the origin to (1, 2, 3), turned a quarter and moved, lies between these corners.
const CORNERS: [[f64; 3]; 2] = [[8.0, 0.0, 0.0], [10.0, 1.0, 3.0]];

fn block() -> Brep {
    let side = |length: f64| Interval::new(0.0, length);
    let block = katydid_geometry::Box3 { plane: Plane::XY, x: side(1.0), y: side(2.0), z: side(3.0) };
    construct::box_brep(&block).unwrap()
}

#[test]
fn solids_surfaces_and_meshes_follow_a_map() {
    let Value::Kept(raw) = kept("Brep", block().into(), TURN) else { panic!("a kept Brep") };
    let image = Value::Kept(raw).solid().unwrap();
    assert!(image.is_solid() && image.is_valid());
    assert!((image.volume_properties(1e-9, || true).unwrap().amount - 6.0).abs() < 1e-9);
    let vertices: Vec<Point3> = image.vertices().iter().map(|vertex| vertex.point).collect();
    for axis in 0..3 {
        let along = |p: &Point3| [p.x, p.y, p.z][axis];
        let low = vertices.iter().map(along).fold(f64::INFINITY, f64::min);
        let high = vertices.iter().map(along).fold(f64::NEG_INFINITY, f64::max);
        assert!((low - CORNERS[0][axis]).abs() < 1e-12 && (high - CORNERS[1][axis]).abs() < 1e-12);
    }
    let mesh = Mesh::sphere(&Plane::XY, 1.0, 8, 6).unwrap();
    let Value::Mesh(image) = kept("Mesh", mesh.clone().into(), TURN) else { panic!("a mesh") };
    for (before, after) in mesh.vertices().iter().zip(image.vertices()) {
        let expected = Point3::new(10.0 - before.y, before.x, before.z);
        // Files keep the vertices of meshes in single precision.
        assert!(after.distance_to(expected) < 1e-5);
    }
    let square = Surface::from(
        katydid_geometry::PlaneSurface::new(Plane::XY, Interval::UNIT, Interval::UNIT).unwrap(),
    );
    let twice = kept("Surface", square.into(), DOUBLE).solid().unwrap();
    assert!((twice.area_properties(1e-9, || true).unwrap().amount - 4.0).abs() < 1e-9);
}

#[test]
fn a_gesture_is_one_step_whose_maps_count_from_where_it_began() {
    let mut studio = Studio::empty();
    let (point, at) = with(&mut studio, "Point", Drawing::Point { at: [0.0; 3] });
    let line = Drawing::Line { ends: [[0.0; 3], [0.0, 5.0, 0.0]] };
    let (curve, along) = with(&mut studio, "Curve", line);
    for x in [1.0, 2.0, 0.1, 7.0] {
        let edit = Edit::Transform { ports: vec![at, along], map: step(x) };
        let change = studio.editor.apply(&edit, Some(5), &[]).unwrap();
        studio.follow(&change);
        assert_eq!(studio.texts(point), [format!("{{{x}, 0, 0}}")]);
    }
    let [Value::Curve(moved)] = &values(&mut studio, curve)[..] else { panic!("a curve") };
    assert!((moved.point_at(moved.domain().start) - Point3::ORIGIN - 7.0 * Vector3::X).length() < 1e-12);
    // Another gesture counts from here.
    let edit = Edit::Transform { ports: vec![at], map: step(1.0) };
    let change = studio.editor.apply(&edit, Some(6), &[]).unwrap();
    studio.follow(&change);
    assert_eq!(studio.texts(point), ["{8, 0, 0}"]);
    assert!(studio.undo());
    assert_eq!(studio.texts(point), ["{7, 0, 0}"]);
    assert!(studio.undo());
    assert_eq!(studio.texts(point), ["{0, 0, 0}"]);
    let [Value::Curve(back)] = &values(&mut studio, curve)[..] else { panic!("a curve") };
    assert_eq!(Curve::clone(back).point_at(back.domain().start), Point3::ORIGIN);
}

#[test]
fn what_cannot_follow_is_refused_by_name() {
    let mut studio = Studio::empty();
    let (id, port) = with(&mut studio, "Point", Drawing::Point { at: [1.0; 3] });
    let mut flat = DOUBLE;
    flat[2][2] = 0.0;
    let mut nowhere = DOUBLE;
    nowhere[0][3] = f64::NAN;
    for map in [flat, nowhere] {
        assert!(studio.try_do(&Edit::Transform { ports: vec![port], map }).is_err());
    }
    assert!(studio.try_do(&Edit::Transform { ports: vec![Uuid::from_u128(3)], map: DOUBLE }).is_err());
    let number = studio.place("Number", [0.0, 0.0]);
    let own = studio.input(number, 0);
    let refused = studio.try_do(&Edit::Transform { ports: vec![port, own], map: DOUBLE }).unwrap_err();
    assert!(refused.to_string().contains("keeps nothing"), "{refused}");
    studio.make(Edit::Keep { port: own, values: Some("3".to_owned()) });
    let refused = studio.try_do(&Edit::Transform { ports: vec![own], map: DOUBLE }).unwrap_err();
    assert!(refused.to_string().contains("A Number cannot be transformed"), "{refused}");
    assert_eq!(studio.texts(id), ["{1, 1, 1}"]);
}
