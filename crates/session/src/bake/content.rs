//! Content of a model as entries of its tables.

use std::collections::HashMap;
use std::sync::Arc;

use katydid_3dm::{
    Attributes, Limits, LineCap, LineJoin, Linetype, LinetypeSegment, Material, Model,
    ModelObject as Archived, Object, ObjectMode, Source, UserData,
};
use katydid_data::{
    BlockDefinition, Colour, ModelLayer, ModelLinetype, ModelMaterial, ModelObject, Visibility, cast,
};
use uuid::Uuid;

use super::pieces;

/// The blocks that are in the model already.
#[derive(Debug, Default)]
pub(super) struct Blocks {
    /// By where they lie; they are kept, so that no address is used twice.
    known: HashMap<usize, (Arc<BlockDefinition>, Uuid)>,
}

impl Blocks {
    /// Puts a block into the model, with the blocks inside it; gives its identifier there.
    pub(super) fn put(
        &mut self,
        model: &mut Model,
        block: &Arc<BlockDefinition>,
        rules: &cast::Rules,
    ) -> Result<Uuid, String> {
        let address = Arc::as_ptr(block).addr();
        if let Some((_, id)) = self.known.get(&address) {
            return Ok(*id);
        }
        let mut members = Vec::new();
        for object in block.objects() {
            let mut objects = Vec::new();
            if let Some(geometry) = &object.geometry {
                pieces::of(geometry, rules, model, self, &mut objects)?;
            }
            let attributes = attributes(model, object);
            let texts = user_data(&object.geometry_text);
            let member = |geometry| archived(geometry, &attributes, &texts);
            members.extend(objects.into_iter().map(member));
        }
        let id = model.add_block(&block.name, members);
        if let Some(entry) = model.blocks.last_mut() {
            entry.description = block.description.to_string();
            entry.url = block.url.to_string();
            entry.url_tag = block.url_description.to_string();
        }
        self.known.insert(address, (block.clone(), id));
        Ok(id)
    }
}

/// The attributes of an object, with its layer and its groups in the tables of the model.
pub(super) fn attributes(model: &mut Model, object: &ModelObject) -> Attributes {
    let text = |(key, text): &(Arc<str>, Arc<str>)| (key.to_string(), text.to_string());
    let mut groups: Vec<usize> = object.groups.iter().map(|name| model.group_named(name)).collect();
    groups.dedup();
    let material = object.material.as_deref().map(|material| put_material(model, material));
    Attributes {
        name: object.name.to_string(),
        layer: object.layer.as_deref().and_then(|layer| put_layer(model, layer)),
        colour: object.colour.map(bytes),
        material,
        material_source: if material.is_some() { Source::Object } else { Source::default() },
        mode: match object.visibility {
            Visibility::Normal => ObjectMode::Normal,
            Visibility::Hidden => ObjectMode::Hidden,
            Visibility::Locked => ObjectMode::Locked,
        },
        visible: object.visibility != Visibility::Hidden,
        groups,
        user_strings: object.user_text.iter().map(text).collect(),
        ..Attributes::default()
    }
}

fn bytes(c: Colour) -> [u8; 4] {
    [c.r, c.g, c.b, c.a]
}

/// The place of a material in the model: one of the same name and look, else a new one.
fn put_material(model: &mut Model, material: &ModelMaterial) -> usize {
    /// The sharpest highlights that archives know.
    const SHARPEST: f64 = 255.0;
    let mut entry = Material { name: material.name.to_string(), ..Material::default() };
    if let Some(look) = material.look {
        entry.diffuse = bytes(look.diffuse);
        entry.specular = bytes(look.specular);
        entry.emission = bytes(look.emission);
        entry.transparency = look.transparency;
        entry.shine = look.shine * SHARPEST;
    }
    // A name alone means the material that has it, whatever its look.
    let same = |known: &Material| known.name == entry.name && (material.look.is_none() || *known == entry);
    if let Some(place) = model.materials.iter().position(same) {
        return place;
    }
    model.materials.push(entry);
    model.materials.len() - 1
}

/// The texts that geometry carries itself, as its user data.
pub(super) fn user_data(texts: &[(Arc<str>, Arc<str>)]) -> Vec<UserData> {
    if texts.is_empty() {
        return Vec::new();
    }
    let texts: Vec<_> = texts.iter().map(|(key, text)| (key.to_string(), text.to_string())).collect();
    UserData::of_user_strings(&texts).into_iter().collect()
}

/// An object of the model with the texts of its geometry.
///
/// What is kept as bytes has its user data in them; it is read, so that the texts can stand beside it.
pub(super) fn archived(geometry: Object, attributes: &Attributes, texts: &[UserData]) -> Archived {
    let mut user_data = texts.to_vec();
    let geometry = match geometry {
        Object::Kept(raw) if !texts.is_empty() => match raw.parse(&Limits::default()) {
            Ok(known) if !matches!(known, Object::Kept(_)) => {
                user_data
                    .extend(raw.user_data.into_iter().filter(|own| !matches!(own.strings(), Ok(Some(_)))));
                known
            }
            _ => Object::Kept(raw),
        },
        geometry => geometry,
    };
    Archived { attributes: attributes.clone(), user_data, ..Archived::from(geometry) }
}

/// The place of a layer in the model, which gets it with those that it lies in; none for a layer without a name.
pub(super) fn put_layer(model: &mut Model, layer: &ModelLayer) -> Option<usize> {
    if layer.path.trim().is_empty() {
        return None;
    }
    let before = model.layers.len();
    let place = model.layer_at(&layer.path);
    if place >= before
        && let Some(entry) = model.layers.get_mut(place)
    {
        entry.colour = layer.colour.map_or(entry.colour, |c| [c.r, c.g, c.b, c.a]);
        entry.visible = !layer.hidden;
        entry.locked = layer.locked;
    }
    Some(place)
}

/// Puts a linetype into the model, unless it has one of that name.
pub(super) fn put_linetype(model: &mut Model, linetype: &ModelLinetype) {
    if model.linetypes.iter().any(|known| known.name.eq_ignore_ascii_case(&linetype.name)) {
        return;
    }
    let segment = |length: &f64| LinetypeSegment { length: length.abs(), is_gap: *length < 0.0 };
    let mut entry = Linetype {
        name: linetype.name.to_string(),
        cap: match linetype.cap {
            1 => LineCap::Flat,
            2 => LineCap::Square,
            _ => LineCap::Round,
        },
        join: match linetype.join {
            1 => LineJoin::Miter,
            2 => LineJoin::Bevel,
            _ => LineJoin::Round,
        },
        width: linetype.width,
        width_units: u8::try_from(linetype.width_units).unwrap_or_default(),
        ..Linetype::default()
    };
    if !linetype.segments.is_empty() {
        entry.segments = linetype.segments.iter().map(segment).collect();
    }
    model.linetypes.push(entry);
}
