//! Geometry that repeats becomes a block.

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};

use katydid_3dm::{Attributes, BlockReference, Model, ModelObject, Object, ObjectMode};
use katydid_geometry::{Curve, Direction, Mesh, Point3, Surface, Vector3, Xform};
use uuid::Uuid;

/// How far apart, of the size of the geometry, the coordinates of two pieces may be that count as the same.
const SAME: f64 = 1e-9;

/// A piece without its place: all that must be equal, and its points from the first one on.
struct Shape {
    anchor: Point3,
    /// Kind, degrees, knots, faces, layer, colour: equal to the last bit.
    exact: u64,
    /// The points, measured from the anchor.
    points: Vec<Vector3>,
}

/// Turns pieces that are the same but for a shift into references to one block. Points and pieces that stand alone
/// stay what they are.
pub(super) fn gather(model: &mut Model) {
    let shapes: Vec<Option<Shape>> = model.objects.iter().map(shape).collect();
    let mut sets: Vec<Vec<usize>> = Vec::new();
    let mut by_content: HashMap<u64, Vec<usize>> = HashMap::new();
    for (place, shape) in shapes.iter().enumerate() {
        let Some(shape) = shape else { continue };
        let alike = by_content.entry(shape.exact).or_default();
        let first = |set: &usize| sets.get(*set)?.first().and_then(|first| shapes.get(*first)?.as_ref());
        let known = alike.iter().copied().find(|set| first(set).is_some_and(|first| same(first, shape)));
        match known.and_then(|set| sets.get_mut(set)) {
            Some(set) => set.push(place),
            None => {
                alike.push(sets.len());
                sets.push(vec![place]);
            }
        }
    }
    for set in sets.iter().filter(|set| set.len() > 1) {
        refer(model, set, &shapes);
    }
}

/// Makes a block of the first of these objects, and references to it of all of them.
fn refer(model: &mut Model, set: &[usize], shapes: &[Option<Shape>]) {
    let anchor = |place: &usize| shapes.get(*place)?.as_ref().map(|shape| shape.anchor);
    let Some((first, start)) =
        set.first().and_then(|first| Some((model.objects.get(*first)?, anchor(first)?)))
    else {
        return;
    };
    let to_origin = Xform::translation(Point3::ORIGIN - start);
    let Some(geometry) = moved(&first.geometry, &to_origin) else { return };
    let name = first.attributes.name.clone();
    let member = ModelObject {
        attributes: Attributes {
            id: Uuid::nil(),
            user_strings: Vec::new(),
            groups: Vec::new(),
            ..first.attributes.clone()
        },
        ..ModelObject::from(geometry)
    };
    let definition = model.add_block(&name, vec![member]);
    for place in set {
        let Some(at) = anchor(place) else { continue };
        if let Some(object) = model.objects.get_mut(*place) {
            let reference = BlockReference::new(definition, Xform::translation(at - Point3::ORIGIN));
            object.geometry = Object::BlockReference(Box::new(reference));
        }
    }
}

fn moved(geometry: &Object, by: &Xform) -> Option<Object> {
    Some(match geometry {
        Object::Curve(curve) => Object::Curve(curve.transformed(by).ok()?),
        Object::Surface(surface) => Object::Surface(surface.transformed(by).ok()?),
        Object::Mesh(mesh) => Object::from(mesh.to_mesh().ok()?.transformed(by).ok()?),
        _ => return None,
    })
}

fn same(a: &Shape, b: &Shape) -> bool {
    let size = a.points.iter().map(|v| v.length()).fold(0.0, f64::max);
    a.points.len() == b.points.len()
        && a.points.iter().zip(&b.points).all(|(a, b)| (*a - *b).length() <= SAME * size)
}

fn shape(object: &ModelObject) -> Option<Shape> {
    if object.attributes.mode == ObjectMode::InDefinition {
        return None;
    }
    let mut exact = DefaultHasher::new();
    (object.attributes.layer, object.attributes.colour).hash(&mut exact);
    let points = match &object.geometry {
        Object::Curve(curve) => curve_points(curve, &mut exact)?,
        Object::Surface(surface) => surface_points(surface, &mut exact)?,
        Object::Mesh(mesh) => mesh_points(&mesh.to_mesh().ok()?, &mut exact),
        _ => return None,
    };
    let anchor = *points.first()?;
    let points = points.iter().map(|point| *point - anchor).collect();
    Some(Shape { anchor, exact: exact.finish(), points })
}

fn numbers(numbers: &[f64], exact: &mut DefaultHasher) {
    numbers.iter().for_each(|x| x.to_bits().hash(exact));
}

/// The control points of a curve; its kind, degree, knots and weights are exact.
fn curve_points(curve: &Curve, exact: &mut DefaultHasher) -> Option<Vec<Point3>> {
    let nurbs = curve.to_nurbs().ok()?;
    (1_u8, std::mem::discriminant(curve), nurbs.degree()).hash(exact);
    numbers(nurbs.knots(), exact);
    numbers(&nurbs.weights(), exact);
    Some(nurbs.control_points())
}

fn surface_points(surface: &Surface, exact: &mut DefaultHasher) -> Option<Vec<Point3>> {
    let nurbs = surface.to_nurbs().ok()?;
    (2_u8, std::mem::discriminant(surface), nurbs.degrees()).hash(exact);
    Direction::BOTH.iter().for_each(|direction| numbers(nurbs.knots(*direction), exact));
    numbers(&nurbs.weights(), exact);
    Some(nurbs.control_points())
}

fn mesh_points(mesh: &Mesh, exact: &mut DefaultHasher) -> Vec<Point3> {
    3_u8.hash(exact);
    mesh.faces().iter().for_each(|face| face.indices().hash(exact));
    mesh.colours().hash(exact);
    mesh.vertices().to_vec()
}
