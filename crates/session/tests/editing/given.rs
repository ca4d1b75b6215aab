//! Geometry that is picked or drawn in a viewport, and kept.

use katydid_3dm::{Attributes, Layer, Model, ModelObject, Object as Archived};
use katydid_component::{RhinoModel, registry};
use katydid_data::{Path, Tree, Value};
use katydid_definition::document::Stored;
use katydid_geometry::{Line, Mesh, Plane, Point3};
use katydid_session::Results;
use katydid_session::protocol::{Drawing, Edit, GeometrySource, PlaneView};
use uuid::Uuid;

use crate::common::Studio;

const XY: PlaneView = PlaneView { origin: [1.0, 2.0, 3.0], x: [2.0, 0.0, 0.0], y: [1.0, 5.0, 0.0] };

fn drawn(drawing: Drawing) -> GeometrySource {
    GeometrySource::Drawn { drawing }
}

/// What a parameter of that name shows after something was drawn into it.
fn shown(parameter: &str, drawings: Vec<Drawing>) -> Vec<String> {
    let mut studio = Studio::empty();
    let found = registry::all().into_iter().find(|one| one.floating && one.name == parameter && !one.old);
    let id = studio.place_as(found.unwrap().guid, [0.0, 0.0]);
    let port = studio.input(id, 0);
    studio.make(Edit::SetGeometry { port, items: drawings.into_iter().map(drawn).collect() });
    let texts = studio.texts(id);
    // What is kept is what is read again from a file of Grasshopper.
    let bytes = studio.editor.document().to_gh().unwrap();
    let limits = katydid_definition::archive::Limits::default();
    let again = katydid_definition::document::Document::read(&bytes, &limits).unwrap();
    let mut again = Studio::new(again);
    assert_eq!(again.texts(id), texts, "{parameter}");
    texts
}

/// The length of the curve that a parameter keeps.
fn length(drawing: Drawing) -> f64 {
    let mut studio = Studio::empty();
    let [curve, measure] = ["Curve", "Length"].map(|name| studio.place(name, [0.0, 0.0]));
    let port = studio.input(curve, 0);
    studio.make(Edit::SetGeometry { port, items: vec![drawn(drawing)] });
    studio.wire(curve, measure, 0);
    studio.texts(measure)[0].parse().unwrap()
}

#[test]
fn points_and_curves_are_drawn() {
    let points = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [3.0, 4.0, 0.0]];
    let many = points.map(|at| Drawing::Point { at }).to_vec();
    assert_eq!(shown("Point", many), ["{0, 0, 0}", "{3, 0, 0}", "{3, 4, 0}"]);
    assert_eq!(shown("Curve", vec![Drawing::Line { ends: [points[0], points[1]] }]), ["Line-like Curve"]);
    assert_eq!(length(Drawing::Polyline { points: points.to_vec() }), 7.0);
    let closed = [points.as_slice(), &points[..1]].concat();
    assert_eq!(length(Drawing::Polyline { points: closed }), 12.0);
    // A panel shows six digits.
    assert!((length(Drawing::Circle { plane: XY, radius: 2.0 }) - 4.0 * std::f64::consts::PI).abs() < 1e-5);
    assert_eq!(length(Drawing::Rectangle { plane: XY, size: [3.0, -4.0] }), 14.0);
    // A cubic through points of a line is that line.
    let straight = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [5.0, 0.0, 0.0]].to_vec();
    assert!((length(Drawing::Interpolated { points: straight, closed: false }) - 5.0).abs() < 1e-5);
}

#[test]
fn a_closed_interpolated_curve_passes_through_its_points() {
    let points = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]];
    let mut studio = Studio::empty();
    let [curve, closest, given] =
        ["Curve", "Curve Closest Point", "Point"].map(|n| studio.place(n, [0.0; 2]));
    let port = studio.input(curve, 0);
    studio.make(Edit::SetGeometry {
        port,
        items: vec![drawn(Drawing::Interpolated { points: points.clone(), closed: true })],
    });
    let port = studio.input(given, 0);
    let items = points.iter().map(|at| drawn(Drawing::Point { at: *at })).collect();
    studio.make(Edit::SetGeometry { port, items });
    studio.wire(given, closest, 0);
    studio.wire(curve, closest, 1);
    studio.engine.solve();
    let at = studio.engine.document().objects.iter().position(|object| object.id == closest).unwrap();
    let distances = &studio.engine.report(at).unwrap().outputs[2];
    for distance in distances.column().iter().flatten() {
        let Value::Number(distance) = distance else { panic!("{distance:?}") };
        assert!(distance < 1e-9, "{distance}");
    }
    assert_eq!(distances.item_count(), 4);
}

#[test]
fn shapes_are_kept_as_the_type_of_the_input() {
    let circle = Drawing::Circle { plane: XY, radius: 2.0 };
    assert_eq!(shown("Circle", vec![circle.clone()]), ["Circle(R:2.00 mm)"]);
    assert_eq!(shown("Curve", vec![circle.clone()]).len(), 1);
    assert_eq!(shown("Surface", vec![circle]).len(), 1);
    assert_eq!(shown("Geometry", vec![Drawing::Point { at: [1.0; 3] }]), ["{1, 1, 1}"]);
}

#[test]
fn what_makes_no_sense_is_refused_and_changes_nothing() {
    let mut studio = Studio::empty();
    let id = studio.place("Curve", [0.0, 0.0]);
    let port = studio.input(id, 0);
    let flat = PlaneView { y: [1.0, 0.0, 0.0], x: [2.0, 0.0, 0.0], ..XY };
    let nowhere = [f64::NAN, 0.0, 0.0];
    let wrong = [
        Drawing::Point { at: [0.0; 3] },
        Drawing::Line { ends: [[1.0; 3]; 2] },
        Drawing::Line { ends: [[1.0; 3], nowhere] },
        Drawing::Polyline { points: vec![] },
        Drawing::Polyline { points: vec![[1.0; 3]; 5] },
        Drawing::Polyline { points: vec![[1.0; 3]; 1_000_000] },
        Drawing::Interpolated { points: vec![[0.0; 3], nowhere], closed: true },
        Drawing::Circle { plane: XY, radius: 0.0 },
        Drawing::Circle { plane: flat, radius: 1.0 },
        Drawing::Rectangle { plane: XY, size: [0.0, 1.0] },
        Drawing::Rectangle { plane: XY, size: [f64::INFINITY, 1.0] },
    ];
    for drawing in wrong {
        let edit = Edit::SetGeometry { port, items: vec![drawn(drawing)] };
        assert!(studio.try_do(&edit).is_err(), "{edit:?}");
    }
    assert!(studio.try_do(&Edit::SetGeometry { port, items: vec![] }).is_err());
    assert!(studio.object(id).persistent(&studio.object(id).inputs[0]).is_none());
}

/// Data of one output and a model, as an editor is given them.
struct Given {
    port: Uuid,
    tree: Tree,
    model: RhinoModel,
}

impl Results for Given {
    fn output(&self, port: Uuid, _: &[Uuid]) -> Option<Tree> {
        (port == self.port).then(|| self.tree.clone())
    }

    fn model(&self) -> Option<&RhinoModel> {
        Some(&self.model)
    }
}

fn given() -> Given {
    let line = Line::new(Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0));
    let mut model = Model { layers: vec![Layer::new("Walls")], ..Model::default() };
    for (id, geometry) in
        [(0xa1, Archived::Curve(line.into())), (0xa2, Archived::Point(Point3::new(7.0, 0.0, 0.0)))]
    {
        let attributes = Attributes { id: Uuid::from_u128(id), ..Attributes::default() };
        model.objects.push(ModelObject { attributes, ..ModelObject::from(geometry) });
    }
    let mesh = Mesh::sphere(&Plane::XY, 1.0, 8, 6).unwrap();
    let column = katydid_data::Column::of_values(vec![Value::Number(1.0), mesh.into()], None);
    let tree = Tree::branch_at(Path::from([0, 3].as_slice()), column);
    Given { port: Uuid::from_u128(77), tree, model: RhinoModel::new(model) }
}

#[test]
fn objects_of_the_model_are_referred_to_as_grasshopper_does() {
    let given = given();
    let mut studio = Studio::empty();
    let [curve, point] = ["Curve", "Point"].map(|name| studio.place(name, [0.0, 0.0]));
    let set = |studio: &mut Studio, id: Uuid, object: u128| {
        let items = vec![GeometrySource::Model { object: Uuid::from_u128(object) }];
        let edit = Edit::SetGeometry { port: studio.input(id, 0), items };
        studio.editor.apply_with(&edit, None, &[], &given).map(|change| studio.follow(&change))
    };
    set(&mut studio, curve, 0xa1).unwrap();
    set(&mut studio, point, 0xa2).unwrap();
    // A point is no curve, and an object that is not there is none.
    assert!(set(&mut studio, curve, 0xa2).unwrap_err().to_string().contains("no Curve"));
    assert!(set(&mut studio, curve, 0xff).unwrap_err().to_string().contains("has no object"));
    let kept = |studio: &Studio, id: Uuid| {
        let object = studio.object(id);
        object.persistent(&object.inputs[0]).unwrap().branches[0].items[0].clone()
    };
    let Stored::Geometry(reference) = kept(&studio, curve) else { panic!("no reference") };
    assert_eq!(
        (reference.ref_id, reference.edge, reference.on_data),
        (Uuid::from_u128(0xa1), Some(-1), None)
    );
    let Stored::Geometry(reference) = kept(&studio, point) else { panic!("no reference") };
    assert_eq!(reference.ref_type.as_deref(), Some("point_object"));
    // Beside the model they are what the model has.
    studio.engine.options_mut().model = Some(std::sync::Arc::new(given.model));
    assert_eq!(
        (studio.texts(curve), studio.texts(point)),
        (vec!["Line-like Curve".to_owned()], vec!["{7, 0, 0}".to_owned()])
    );
}

#[test]
fn items_of_outputs_are_copied() {
    let given = given();
    let mut studio = Studio::empty();
    let id = studio.place("Mesh", [0.0, 0.0]);
    let port = studio.input(id, 0);
    let pick = |path: &str, index: u32| Edit::SetGeometry {
        port,
        items: vec![GeometrySource::Item { port: given.port, path: path.to_owned(), index }],
    };
    for (path, index) in [("{0;3}", 0), ("{0;3}", 2), ("{0}", 1), ("nonsense", 1)] {
        assert!(studio.editor.apply_with(&pick(path, index), None, &[], &given).is_err(), "{path} {index}");
    }
    let change = studio.editor.apply_with(&pick("{0;3}", 1), None, &[], &given).unwrap();
    studio.follow(&change);
    let Value::Mesh(sphere) = given.tree.column().get(1).unwrap() else { panic!("no mesh") };
    assert_eq!(
        studio.texts(id),
        [format!("Mesh (V:{}  F:{})", sphere.vertices().len(), sphere.faces().len())]
    );
    assert!(studio.undo() && studio.texts(id).is_empty());
}
