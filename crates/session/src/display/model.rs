//! The Rhino model beside a definition: each layer is shown as if it were an object of the definition whose data are
//! the objects on it.

use std::collections::BTreeMap;

use katydid_component::{RhinoModel, RhinoObject};
use katydid_data::cast::Rules;
use katydid_data::{Column, Path, Tree};
use katydid_definition::document::{Object, ids};
use katydid_definition::kd::derived_id;
use uuid::Uuid;

use super::{Fineness, Geometry, Shown, encode};
use crate::protocol::{Colour, ModelLayerView, ModelObjectView, ModelView};

/// So many objects of a model are shown.
const MOST_OBJECTS: usize = 20_000;
/// The geometry of a model takes no more bytes.
const MOST_BYTES: usize = 512 << 20;
/// What layers without a colour are shown in.
const GREY: Colour = [128, 128, 128, 255];

/// A model as a viewport shows it.
#[derive(Debug, Clone)]
pub struct ModelPreview {
    /// Its layers. The name of the model is left to those who know its file.
    pub view: ModelView,
    /// The geometry of those layers that have one.
    pub geometries: Vec<Geometry>,
}

/// Encodes a model; nothing when `go_on` denies it.
pub fn encode_model(
    model: &RhinoModel,
    rules: &Rules,
    go_on: impl Fn() -> bool + Sync,
) -> Option<ModelPreview> {
    let mut shown: BTreeMap<usize, Vec<&RhinoObject>> = BTreeMap::new();
    let mut left_out = Vec::new();
    for (count, object) in model.objects().iter().filter(|object| is_seen(model, object)).enumerate() {
        if count == MOST_OBJECTS {
            left_out.push(format!("only the first {MOST_OBJECTS} objects of the model are shown"));
            break;
        }
        shown.entry(object.layer_index).or_default().push(object);
    }
    let mut layers = Vec::with_capacity(shown.len());
    let mut geometries = Vec::new();
    let mut bytes = 0;
    for (index, objects) in shown {
        let mut layer = view(model, index, &objects);
        if bytes > MOST_BYTES {
            left_out.push(format!("layer {} is not shown: too much is shown already", layer.path));
        } else {
            let (geometry, complaints) = geometry(&layer, &objects, rules, &go_on)?;
            layer.geometry = geometry.as_ref().map(|geometry| geometry.hash.clone());
            bytes += geometry.as_ref().map_or(0, |geometry| geometry.bytes.len());
            geometries.extend(geometry);
            left_out.extend(complaints);
        }
        layers.push(layer);
    }
    Some(ModelPreview { view: ModelView { name: String::new(), layers, left_out }, geometries })
}

/// Whether an object is seen where its layer is shown.
fn is_seen(model: &RhinoModel, object: &RhinoObject) -> bool {
    let is_layer_hidden = model.layers().get(object.layer_index).is_some_and(|layer| layer.hidden);
    !object.is_hidden || is_layer_hidden
}

fn view(model: &RhinoModel, index: usize, objects: &[&RhinoObject]) -> ModelLayerView {
    let layer = model.layers().get(index);
    let colour = layer.and_then(|layer| layer.colour);
    ModelLayerView {
        id: derived_id(Uuid::nil(), &format!("layer {index}")),
        path: layer.map_or_else(String::new, |layer| layer.path.to_string()),
        colour: colour.map_or(GREY, |c| [c.r, c.g, c.b, 255]),
        hidden: layer.is_some_and(|layer| layer.hidden),
        objects: objects.iter().map(|object| object_view(object)).collect(),
        geometry: None,
    }
}

fn object_view(object: &RhinoObject) -> ModelObjectView {
    let kind = object.geometry.as_ref().map_or("", |geometry| geometry.kind().name());
    ModelObjectView { id: object.id, name: object.name.clone(), kind: kind.to_owned() }
}

/// The geometry of a layer and what could not be shown of it; nothing when `go_on` denies it.
fn geometry(
    layer: &ModelLayerView,
    objects: &[&RhinoObject],
    rules: &Rules,
    go_on: impl Fn() -> bool + Sync,
) -> Option<(Option<Geometry>, Vec<String>)> {
    let data = Column::of_options(objects.iter().map(|object| object.geometry.clone()).collect());
    let outputs = [Tree::branch_at(Path::from([0].as_slice()), data)];
    let object = Object::new_parameter(ids::GEOMETRY, &layer.path, &layer.path, layer.id);
    let shown = Shown { object: &object, outputs: &outputs, inputs: &[] };
    let preview = encode(&[shown], rules, Fineness::Coarse, go_on).pop()?;
    Some((preview.geometry, preview.left_out))
}
