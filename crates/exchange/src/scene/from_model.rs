//! The objects of a model as a scene: where they are, what they are called, and how they look.

use std::collections::HashMap;

use katydid_3dm::{
    Attributes, BlockReference, Layer as ModelLayer, Model, ModelObject, Object, ObjectMode, Source,
};
use katydid_geometry::{Units, Xform};
use uuid::Uuid;

use super::drawn::Styles;
use super::shape::{Shapes, placed};
use super::tree::rooted;
use super::{Layer, LeftOut, Scene, Shape, Thing};

/// How a model becomes a scene.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Conversion {
    /// How far facets may be from their surfaces, in model units. When not given: the model's tolerance, or a
    /// ten-thousandth of the surface's size if that is more.
    pub tolerance: Option<f64>,
    /// Take objects along that are hidden or lie on hidden layers.
    pub hidden: bool,
    /// Keep surfaces and solids exact, as [`Shape::Brep`], instead of taking facets.
    pub exact: bool,
}

/// Blocks in blocks deeper than this are left out, and so is what makes more things than this: a few blocks that hold
/// each other twice would fill any memory.
const DEEPEST: usize = 32;
const MOST_THINGS: usize = 1_000_000;

impl Scene {
    /// The visible objects of a model. References to blocks become what the blocks hold.
    pub fn from_model(model: &Model) -> Self {
        Self::from_model_with(model, &Conversion::default())
    }

    /// The objects of a model. References to blocks become what the blocks hold.
    pub fn from_model_with(model: &Model, conversion: &Conversion) -> Self {
        let layers = layers(&model.layers);
        let shown = shown_layers(model, &layers);
        let scene = Self {
            units: model.units,
            metres: metres(model),
            tolerance: model.tolerance.absolute,
            layers,
            ..Self::default()
        };
        let members =
            model.objects.iter().filter(|object| object.attributes.mode == ObjectMode::InDefinition);
        let mut objects = Objects {
            model,
            conversion,
            shown,
            blocks: model.blocks.iter().enumerate().rev().map(|(place, block)| (block.id, place)).collect(),
            members: members.map(|object| (object.attributes.id, object)).collect(),
            known: HashMap::new(),
            styles: Styles::of(model),
            scene,
        };
        for object in &model.objects {
            // The members of blocks appear where a block is placed, not where they are kept.
            if object.attributes.mode != ObjectMode::InDefinition {
                objects.add(object, &Placement::default());
            }
        }
        for light in &model.lights {
            objects.leave_out(&light.geometry, "it has no form of its own");
        }
        objects.scene
    }
}

/// Where an object stands: itself, or through the blocks that hold it.
#[derive(Clone, Copy, Default)]
struct Placement<'a> {
    /// From the object's space to the model's; nothing for no motion.
    motion: Option<Xform>,
    depth: usize,
    /// The name and colour of the innermost reference, for members without their own.
    name: &'a str,
    colour: Option<[u8; 4]>,
}

/// The objects of a model on their way into a scene.
struct Objects<'a> {
    model: &'a Model,
    conversion: &'a Conversion,
    /// For each layer whether it and all layers above it are visible.
    shown: Vec<bool>,
    blocks: HashMap<Uuid, usize>,
    members: HashMap<Uuid, &'a ModelObject>,
    /// Shapes of members that were needed before.
    known: HashMap<Uuid, std::result::Result<Shape, String>>,
    styles: Styles,
    scene: Scene,
}

impl<'a> Objects<'a> {
    fn leave_out(&mut self, geometry: &Object, why: impl Into<String>) {
        LeftOut::add(&mut self.scene.left_out, LeftOut::new(geometry.class_name(), 1, why));
    }

    fn add(&mut self, object: &'a ModelObject, placement: &Placement<'_>) {
        let (geometry, attributes) = (&object.geometry, &object.attributes);
        if !self.conversion.hidden && !self.is_shown(attributes) {
            return self.leave_out(geometry, "hidden");
        }
        if let Object::BlockReference(reference) = geometry {
            return self.add_block(object, reference, placement);
        }
        if self.scene.things.len() >= MOST_THINGS {
            return self.leave_out(geometry, format!("blocks make more than {MOST_THINGS} things"));
        }
        match self.shape(object, placement) {
            Ok(shape) => {
                let colour = self.colour(attributes, &shape, placement);
                let layer = attributes.layer.filter(|layer| *layer < self.scene.layers.len());
                let name = if attributes.name.is_empty() { placement.name } else { &attributes.name };
                self.scene.things.push(Thing { name: name.to_owned(), layer, colour, shape });
            }
            Err(why) => self.leave_out(geometry, why),
        }
    }

    fn add_block(&mut self, object: &'a ModelObject, reference: &BlockReference, placement: &Placement<'_>) {
        let model = self.model;
        let block = self.blocks.get(&reference.definition).and_then(|place| model.blocks.get(*place));
        let Some(block) = block else {
            return self.leave_out(&object.geometry, "the block it shows is not in the model");
        };
        if placement.depth >= DEEPEST {
            return self.leave_out(&object.geometry, format!("it lies in more than {DEEPEST} blocks"));
        }
        let members: Vec<&ModelObject> =
            block.members.iter().filter_map(|id| self.members.get(id).copied()).collect();
        if members.is_empty() {
            let why =
                if block.link().is_some() { "its block lies in another file" } else { "its block is empty" };
            return self.leave_out(&object.geometry, why);
        }
        let attributes = &object.attributes;
        let own = if attributes.name.is_empty() { &block.name } else { &attributes.name };
        let inner = Placement {
            motion: Some(placement.motion.map_or(reference.transform, |outer| outer * reference.transform)),
            depth: placement.depth + 1,
            name: own,
            colour: self.line_colour(attributes, placement),
        };
        for member in members {
            if self.scene.things.len() >= MOST_THINGS {
                return self
                    .leave_out(&object.geometry, format!("blocks make more than {MOST_THINGS} things"));
            }
            self.add(member, &inner);
        }
    }

    fn shape(
        &mut self,
        object: &ModelObject,
        placement: &Placement<'_>,
    ) -> std::result::Result<Shape, String> {
        let shapes = Shapes { scene: &self.scene, styles: &self.styles, conversion: self.conversion };
        let mut left_out = Vec::new();
        let shape = match placement.motion {
            None => shapes.of(&object.geometry, &mut left_out),
            Some(motion) => {
                let known = self.known.entry(object.attributes.id);
                let shape = known.or_insert_with(|| shapes.of(&object.geometry, &mut left_out));
                shape.as_ref().map_err(Clone::clone).and_then(|shape| placed(shape, &motion))
            }
        };
        left_out.into_iter().for_each(|one| LeftOut::add(&mut self.scene.left_out, one));
        shape
    }

    fn is_shown(&self, attributes: &Attributes) -> bool {
        let layer = attributes.layer.and_then(|layer| self.shown.get(layer).copied()).unwrap_or(true);
        layer && attributes.visible && attributes.mode != ObjectMode::Hidden
    }

    /// The colour of an object's lines on the screen.
    fn line_colour(&self, attributes: &Attributes, placement: &Placement<'_>) -> Option<[u8; 4]> {
        let layer = || attributes.layer.and_then(|layer| self.model.layers.get(layer));
        attributes.colour.or_else(|| match attributes.colour_source {
            Source::Display => self.material(attributes, placement).or_else(|| Some(layer()?.colour)),
            Source::Parent => placement.colour.or_else(|| Some(layer()?.colour)),
            Source::Layer | Source::Object => Some(layer()?.colour),
        })
    }

    /// The colour of its material: its own, or that of its layer.
    fn material(&self, attributes: &Attributes, placement: &Placement<'_>) -> Option<[u8; 4]> {
        let place = match attributes.material_source {
            Source::Object => attributes.material,
            Source::Parent => return placement.colour,
            _ => self.model.layers.get(attributes.layer?)?.material,
        };
        let material = self.model.materials.get(place?)?;
        let [r, g, b, _] = material.diffuse;
        let alpha = 255.0 * (1.0 - material.transparency.clamp(0.0, 1.0));
        Some([r, g, b, alpha.round() as u8])
    }

    /// Faces look as their material does, if they have one. The black that layers begin with is the colour of lines:
    /// faces on such a layer have no colour of their own.
    fn colour(&self, attributes: &Attributes, shape: &Shape, placement: &Placement<'_>) -> Option<[u8; 4]> {
        let of_lines = self.line_colour(attributes, placement);
        if !matches!(shape, Shape::Mesh(_) | Shape::Faces { .. } | Shape::Brep(_)) {
            return of_lines;
        }
        let is_black = |colour: &[u8; 4]| colour.iter().take(3).all(|part| *part == 0);
        let shown = of_lines.filter(|colour| attributes.colour.is_some() || !is_black(colour));
        self.material(attributes, placement).or(shown)
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
    let places: HashMap<Uuid, usize> =
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
