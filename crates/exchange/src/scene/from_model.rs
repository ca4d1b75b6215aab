//! The objects of a model as a scene.

use std::collections::HashMap;

use katydid_3dm::{
    Attributes, BrepSummary, Layer as ModelLayer, Model, Object, ObjectMode, PointCloud, RawObject,
};
use katydid_geometry::{Curve, Surface, Units};

use super::facets::{borders, facets};
use super::tree::rooted;
use super::{Layer, LeftOut, PointSet, Scene, Shape, Thing};

/// How a model becomes a scene.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Conversion {
    /// How far facets may be from their surfaces, in model units. When not given: the model's tolerance, or a
    /// ten-thousandth of the surface's size if that is more.
    pub tolerance: Option<f64>,
    /// Take objects along that are hidden or lie on hidden layers.
    pub hidden: bool,
}

impl Scene {
    /// The visible objects of a model.
    pub fn from_model(model: &Model) -> Self {
        Self::from_model_with(model, &Conversion::default())
    }

    /// The objects of a model.
    pub fn from_model_with(model: &Model, conversion: &Conversion) -> Self {
        let mut scene = Self {
            units: model.units,
            metres: metres(model),
            tolerance: model.tolerance.absolute,
            layers: layers(&model.layers),
            ..Self::default()
        };
        let objects = Objects { model, conversion, shown: shown_layers(model, &scene.layers) };
        for object in &model.objects {
            objects.add(&mut scene, &object.geometry, &object.attributes);
        }
        for light in &model.lights {
            LeftOut::add(&mut scene.left_out, LeftOut::new(light.geometry.class_name(), 1, NOT_GEOMETRY));
        }
        scene
    }
}

const NOT_GEOMETRY: &str = "it has no form of its own";
const UNKNOWN: &str = "not supported";

/// The objects of a model on their way into a scene.
struct Objects<'a> {
    model: &'a Model,
    conversion: &'a Conversion,
    /// For each layer whether it and all layers above it are visible.
    shown: Vec<bool>,
}

impl Objects<'_> {
    fn add(&self, scene: &mut Scene, geometry: &Object, attributes: &Attributes) {
        // The members of blocks appear where a block is placed, not where they are kept.
        if attributes.mode == ObjectMode::InDefinition {
            return;
        }
        if !self.conversion.hidden && !self.is_shown(attributes) {
            return LeftOut::add(&mut scene.left_out, LeftOut::new(geometry.class_name(), 1, "hidden"));
        }
        match self.shape(scene, geometry) {
            Ok(shape) => {
                let colour = self.colour(attributes, &shape);
                let layer = Some(attributes.layer).filter(|layer| *layer < scene.layers.len());
                scene.things.push(Thing { name: attributes.name.clone(), layer, colour, shape });
            }
            Err(why) => LeftOut::add(&mut scene.left_out, LeftOut::new(geometry.class_name(), 1, why)),
        }
    }

    fn is_shown(&self, attributes: &Attributes) -> bool {
        let layer = self.shown.get(attributes.layer).copied().unwrap_or(true);
        layer && attributes.visible && attributes.mode != ObjectMode::Hidden
    }

    /// The colour on the screen: the object's own, else its layer's. The black that layers begin with is the colour of
    /// lines; faces on such a layer have no colour of their own.
    fn colour(&self, attributes: &Attributes, shape: &Shape) -> Option<[u8; 4]> {
        let of_layer = || {
            let colour = self.model.layers.get(attributes.layer)?.colour;
            let is_black = colour.iter().take(3).all(|c| *c == 0);
            let is_face = matches!(shape, Shape::Mesh(_) | Shape::Faces { .. });
            (!(is_black && is_face)).then_some(colour)
        };
        attributes.colour.or_else(of_layer)
    }

    fn shape(&self, scene: &Scene, geometry: &Object) -> Result<Shape, String> {
        match geometry {
            Object::Point(p) => Ok(Shape::Points(vec![*p].into())),
            Object::PointCloud(cloud) => Ok(Shape::Points(cloud.into())),
            Object::Curve(curve) => Ok(Shape::Curve(curve.clone())),
            Object::Mesh(mesh) => Ok(Shape::Mesh(mesh.clone())),
            Object::Surface(surface) => Ok(self.faces(scene, surface)),
            Object::Kept(raw) => self.kept(scene, raw),
            _ => Err(UNKNOWN.into()),
        }
    }

    fn faces(&self, scene: &Scene, surface: &Surface) -> Shape {
        let tolerance = match surface.bounding_box() {
            Ok(bounds) => scene.tolerance_for(self.conversion.tolerance, &bounds),
            Err(_) => scene.tolerance,
        };
        Shape::Faces { facets: facets(surface, tolerance), edges: borders(surface) }
    }

    /// A brep by its edges, or by its surface when that is all there is to it.
    fn kept(&self, scene: &Scene, raw: &RawObject) -> Result<Shape, String> {
        if let Ok(Some(bare)) = raw.bare_surface() {
            return Ok(self.faces(scene, &bare.surface));
        }
        match BrepSummary::read(raw) {
            Ok(summary) => {
                let edges = edges(&summary);
                if edges.is_empty() {
                    Err("it has no edges to show".into())
                } else {
                    Ok(Shape::Faces { facets: None, edges })
                }
            }
            Err(_) => Err(UNKNOWN.into()),
        }
    }
}

/// The edges of a brep as curves.
fn edges(brep: &BrepSummary) -> Vec<Curve> {
    let curve = |edge: &katydid_3dm::BrepEdge| {
        let curve = brep.curves.get(edge.curve?)?;
        let whole = edge.part == curve.domain();
        if whole { Some(curve.clone()) } else { curve.trimmed(edge.part).ok() }
    };
    brep.edges.iter().filter_map(curve).collect()
}

impl From<&PointCloud> for PointSet {
    fn from(cloud: &PointCloud) -> Self {
        Self { points: cloud.points.clone(), normals: cloud.normals.clone(), colours: cloud.colours.clone() }
    }
}

/// The length of the model's unit in metres.
fn metres(model: &Model) -> f64 {
    match (&model.unit_scale, model.units) {
        (Some(scale), _) if scale.metres > 0.0 && scale.metres.is_finite() => scale.metres,
        (_, Units::Microns) => 1e-6,
        (_, Units::Millimeters) => 1e-3,
        (_, Units::Centimeters) => 1e-2,
        (_, Units::Meters | Units::None) => 1.0,
        (_, Units::Kilometers) => 1e3,
        (_, Units::Inches) => 0.0254,
        (_, Units::Feet) => 0.3048,
        (_, Units::Yards) => 0.9144,
        (_, Units::Miles) => 1609.344,
    }
}

fn layers(layers: &[ModelLayer]) -> Vec<Layer> {
    let places: HashMap<_, _> =
        layers.iter().enumerate().rev().map(|(place, layer)| (layer.id, place)).collect();
    let parents: Vec<Option<usize>> =
        layers.iter().map(|layer| places.get(&layer.parent?).copied()).collect();
    let names = layers.iter().map(|layer| layer.name.clone());
    names.zip(rooted(&parents)).map(|(name, parent)| Layer { name, parent }).collect()
}

/// For each layer whether it and all above it are visible.
fn shown_layers(model: &Model, layers: &[Layer]) -> Vec<bool> {
    let visible = |i: usize| model.layers.get(i).is_none_or(|layer| layer.visible);
    let shown = |i: usize| {
        let mut next = Some(i);
        while let Some(at) = next {
            if !visible(at) {
                return false;
            }
            next = layers.get(at).and_then(|layer| layer.parent);
        }
        true
    };
    (0..layers.len()).map(shown).collect()
}
