//! The tables of a Rhino model as content, and its blocks with what they place.

use std::collections::HashMap;
use std::sync::Arc as Shared;

use katydid_3dm::{
    Attributes, Block, LinetypeSegment, Model, ModelObject as Archived, Object, ObjectMode, Source, UserData,
};
use katydid_data::{
    BlockDefinition, BlockInstance, Colour, Material, ModelLayer, ModelLinetype, ModelMaterial, ModelObject,
    Value, Visibility,
};
use uuid::Uuid;

/// Blocks in blocks beyond this depth are not followed.
const DEEPEST: usize = 50;

/// Layers, groups, materials and linetypes in the order of their tables.
#[derive(Debug, Default)]
pub(crate) struct Tables {
    pub(crate) layers: Vec<Shared<ModelLayer>>,
    pub(crate) groups: Vec<Shared<str>>,
    pub(crate) materials: Vec<Shared<ModelMaterial>>,
    pub(crate) linetypes: Vec<Shared<ModelLinetype>>,
}

impl Tables {
    pub(crate) fn new(model: &Model) -> Self {
        let places: HashMap<Uuid, usize> =
            model.layers.iter().enumerate().map(|(place, layer)| (layer.id, place)).collect();
        Self {
            layers: (0..model.layers.len()).map(|place| Shared::new(layer(model, place, &places))).collect(),
            groups: model.groups.iter().map(|group| Shared::from(group.name.as_str())).collect(),
            materials: model.materials.iter().map(|material| Shared::new(self::material(material))).collect(),
            linetypes: model.linetypes.iter().map(|linetype| Shared::new(self::linetype(linetype))).collect(),
        }
    }

    pub(crate) fn layer_of(&self, attributes: &Attributes) -> Option<&Shared<ModelLayer>> {
        attributes.layer.and_then(|place| self.layers.get(place))
    }

    /// An object with its attributes as content.
    pub(crate) fn object(&self, attributes: &Attributes, geometry: Option<Value>) -> ModelObject {
        let group = |place: &usize| self.groups.get(*place).cloned();
        let mut object = ModelObject {
            id: Some(attributes.id).filter(|id| !id.is_nil()),
            name: attributes.name.as_str().into(),
            geometry,
            layer: self.layer_of(attributes).cloned(),
            visibility: match attributes.mode {
                ObjectMode::Hidden => Visibility::Hidden,
                ObjectMode::Locked => Visibility::Locked,
                _ if !attributes.visible => Visibility::Hidden,
                _ => Visibility::Normal,
            },
            colour: attributes.colour.map(colour),
            material: attributes
                .material
                .filter(|_| attributes.material_source == Source::Object)
                .and_then(|place| self.materials.get(place).cloned()),
            groups: attributes.groups.iter().filter_map(group).collect(),
            user_text: Vec::new(),
            geometry_text: Vec::new(),
        };
        for (key, text) in &attributes.user_strings {
            object.set_text(key, text.as_str());
        }
        object
    }
}

fn colour([r, g, b, a]: [u8; 4]) -> Colour {
    Colour { a, r, g, b }
}

fn layer(model: &Model, place: usize, places: &HashMap<Uuid, usize>) -> ModelLayer {
    // Parents that run in a circle end after as many steps as there are layers.
    let parent = |place: &usize| places.get(&model.layers.get(*place)?.parent?).copied();
    let chain = std::iter::successors(Some(place), parent).take(model.layers.len());
    let chain: Vec<_> = chain.filter_map(|place| model.layers.get(place)).collect();
    ModelLayer {
        id: model.layers.get(place).map(|layer| layer.id).filter(|id| !id.is_nil()),
        path: model.layer_path(place).unwrap_or_default().into(),
        colour: model.layers.get(place).map(|layer| colour(layer.colour)),
        hidden: chain.iter().any(|layer| !layer.visible),
        locked: chain.iter().any(|layer| layer.locked),
    }
}

fn material(material: &katydid_3dm::Material) -> ModelMaterial {
    /// The sharpest highlights that archives know.
    const SHARPEST: f64 = 255.0;
    let look = Material {
        diffuse: colour(material.diffuse),
        specular: colour(material.specular),
        emission: colour(material.emission),
        transparency: material.transparency,
        shine: material.shine / SHARPEST,
    };
    ModelMaterial { name: material.name.as_str().into(), look: Some(look) }
}

fn linetype(linetype: &katydid_3dm::Linetype) -> ModelLinetype {
    let length = |segment: &LinetypeSegment| if segment.is_gap { -segment.length } else { segment.length };
    let has_gaps = linetype.segments.iter().any(|segment| segment.is_gap);
    ModelLinetype {
        id: Some(linetype.id).filter(|id| !id.is_nil()),
        name: linetype.name.as_str().into(),
        segments: if has_gaps { linetype.segments.iter().map(length).collect() } else { Vec::new() },
        cap: linetype.cap as i32,
        join: linetype.join as i32,
        width: linetype.width,
        width_units: i32::from(linetype.width_units),
    }
}

/// The blocks of a model, made when they are asked for.
pub(crate) struct Blocks<'a> {
    tables: &'a Tables,
    definitions: HashMap<Uuid, Block>,
    members: HashMap<Uuid, Archived>,
    /// What is made already; none while it is being made, so that a block inside itself ends.
    made: HashMap<Uuid, Option<Shared<BlockDefinition>>>,
}

impl<'a> Blocks<'a> {
    pub(crate) fn new(tables: &'a Tables, blocks: Vec<Block>, members: Vec<Archived>) -> Self {
        Self {
            tables,
            definitions: blocks.into_iter().map(|block| (block.id, block)).collect(),
            members: members.into_iter().map(|member| (member.attributes.id, member)).collect(),
            made: HashMap::new(),
        }
    }

    /// The geometry of an object; what places a block brings it along.
    pub(crate) fn geometry(&mut self, geometry: Object, user_data: &[UserData]) -> Option<Value> {
        self.geometry_at(geometry, user_data, 0)
    }

    fn geometry_at(&mut self, geometry: Object, user_data: &[UserData], depth: usize) -> Option<Value> {
        if let Object::BlockReference(reference) = &geometry
            && let Some(definition) = self.definition_at(reference.definition, depth)
        {
            return Some(Value::from(BlockInstance { definition, transform: reference.transform }));
        }
        Value::from_object(geometry, user_data)
    }

    /// The block of an identifier.
    pub(crate) fn definition(&mut self, id: Uuid) -> Option<Shared<BlockDefinition>> {
        self.definition_at(id, 0)
    }

    fn definition_at(&mut self, id: Uuid, depth: usize) -> Option<Shared<BlockDefinition>> {
        if let Some(known) = self.made.get(&id) {
            return known.clone();
        }
        if depth > DEEPEST {
            return None;
        }
        let block = self.definitions.remove(&id)?;
        self.made.insert(id, None);
        let mut objects = Vec::with_capacity(block.members.len().min(self.members.len()));
        for member in &block.members {
            let Some(member) = self.members.remove(member) else { continue };
            let geometry = self.geometry_at(member.geometry, &member.user_data, depth + 1);
            objects.push(self.tables.object(&member.attributes, geometry));
        }
        let mut definition = BlockDefinition::new(block.name, objects);
        definition.id = Some(block.id).filter(|id| !id.is_nil());
        definition.description = block.description.into();
        definition.url = block.url.into();
        definition.url_description = block.url_tag.into();
        let definition = Shared::new(definition);
        self.made.insert(id, Some(definition.clone()));
        Some(definition)
    }
}
