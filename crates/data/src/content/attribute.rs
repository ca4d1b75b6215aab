//! Attributes by the keys that filters and groups name them with.

use std::sync::Arc as Shared;

use super::{Content, ModelLayer, ModelObject};
use crate::Value;

/// What stands before the key of a user text.
const USER_TEXT: &str = "UserText.";

impl Content {
    /// The attribute of a key: `Name`, `Path`, `Id`; of objects `Layer`, `Layer.Name` and the other keys of layers,
    /// `Display.Color`, `Visibility`, and `UserText.` with a key behind it, or the key alone; of layers `Parent`.
    /// None where there is none.
    pub fn attribute(&self, key: &str) -> Option<Value> {
        match (self, key) {
            (_, "Path") => self.path().map(Value::text),
            (Self::Object(object), _) => object_attribute(object, key),
            (Self::Layer(layer), _) => layer_attribute(layer, key),
            (Self::Block(block), "Id") => block.id.map(Value::Guid),
            (Self::Block(block), "Description") => text(&block.description),
            (Self::Linetype(linetype), "Id") => linetype.id.map(Value::Guid),
            (Self::Block(_) | Self::Linetype(_), "Name") => self.path().map(Value::text),
            _ => None,
        }
    }
}

fn text(text: &Shared<str>) -> Option<Value> {
    (!text.is_empty()).then(|| Value::Text(text.clone()))
}

fn object_attribute(object: &ModelObject, key: &str) -> Option<Value> {
    match key {
        "Name" => text(&object.name),
        "Id" => object.id.map(Value::Guid),
        "Layer" => object.layer.clone().map(Value::from),
        "Visibility" => Some(Value::text(object.visibility.name())),
        "Display.Color" => object.colour.map(Value::Colour),
        _ => {
            let of_layer = key.strip_prefix("Layer.").zip(object.layer.as_ref());
            let of_layer = of_layer.and_then(|(key, layer)| layer_attribute(layer, key));
            let user_key = key.strip_prefix(USER_TEXT).unwrap_or(key);
            of_layer.or_else(|| object.text_of(user_key).cloned().map(Value::Text))
        }
    }
}

fn layer_attribute(layer: &ModelLayer, key: &str) -> Option<Value> {
    match key {
        "Name" => Some(Value::text(layer.name())).filter(|_| !layer.path.is_empty()),
        "Path" => text(&layer.path),
        "Id" => layer.id.map(Value::Guid),
        "Parent" => layer.parent().map(Value::text),
        "Display.Color" => layer.colour.map(Value::Colour),
        _ => None,
    }
}
