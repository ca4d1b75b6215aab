//! A scene as a model.

use katydid_3dm::{Attributes, BrepObject, Model, ModelObject, Object, PointCloud, TextDot};

use super::{Label, LabelSize, PointSet, Region, Scene, Shape, Thing};

impl Scene {
    /// The model that holds the things of the scene, with their names, layers and colours. Facets stand for faces, or
    /// edges where there are none, boundaries for regions, and dots for text.
    pub fn to_model(&self) -> Model {
        let mut model = Model { units: self.units, ..Model::default() };
        model.tolerance.absolute =
            if self.tolerance > 0.0 { self.tolerance } else { model.tolerance.absolute };
        let places: Vec<usize> =
            (0..self.layers.len()).map(|layer| model.layer_at(&self.layer_path(layer))).collect();
        for thing in &self.things {
            let layer = thing.layer.and_then(|layer| places.get(layer).copied());
            let layer = layer.unwrap_or_else(|| model.layer_at("Default"));
            for geometry in geometry(&thing.shape) {
                model.objects.push(object(thing, layer, geometry));
            }
        }
        if model.layers.is_empty() {
            model.layer_at("Default");
        }
        model
    }
}

fn object(thing: &Thing, layer: usize, geometry: Object) -> ModelObject {
    let attributes = Attributes {
        name: thing.name.clone(),
        layer: Some(layer),
        colour: thing.colour,
        ..Attributes::default()
    };
    ModelObject { attributes, ..geometry.into() }
}

fn geometry(shape: &Shape) -> Vec<Object> {
    match shape {
        Shape::Points(set) => vec![points(set)],
        Shape::Curve(curve) => vec![Object::Curve(curve.clone())],
        Shape::Mesh(mesh) | Shape::Faces { facets: Some(mesh), .. } => vec![Object::from(mesh.clone())],
        Shape::Text(label) => vec![dot(label)],
        Shape::Brep(brep) => vec![Object::Brep(Box::new(BrepObject::from(brep.as_ref().clone())))],
        Shape::Region(Region { boundaries: edges, .. }) | Shape::Faces { facets: None, edges } => {
            edges.iter().map(|edge| Object::Curve(edge.clone())).collect()
        }
    }
}

fn dot(label: &Label) -> Object {
    let mut dot = TextDot::new(label.point, label.text.clone());
    if let LabelSize::Screen(height) = label.size {
        dot.height = height.clamp(1.0, 1000.0).round() as i32;
    }
    if !label.font.is_empty() {
        dot.font.clone_from(&label.font);
    }
    Object::TextDot(dot)
}

fn points(set: &PointSet) -> Object {
    match set.points.as_slice() {
        [one] if set.colours.is_empty() => Object::Point(*one),
        _ => Object::PointCloud(PointCloud {
            points: set.points.clone(),
            normals: set.normals.clone(),
            colours: set.colours.clone(),
            ..PointCloud::default()
        }),
    }
}
