use std::sync::Arc as Shared;

use uuid::Uuid;

use super::{Content, ModelLayer, ModelMaterial};
use crate::{Colour, Value};

/// Geometry with the attributes that a Rhino model keeps of it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ModelObject {
    /// Its identifier in the model; none for an object that no model has yet.
    pub id: Option<Uuid>,
    /// Its name; empty when it has none.
    pub name: Shared<str>,
    /// The geometry, which is never an object again; none when no value can hold it.
    pub geometry: Option<Value>,
    /// Its layer.
    pub layer: Option<Shared<ModelLayer>>,
    /// How it takes part in the model.
    pub visibility: Visibility,
    /// Its own colour; without one it has its layer's.
    pub colour: Option<Colour>,
    /// Its own material; without one it has its layer's.
    pub material: Option<Shared<ModelMaterial>>,
    /// The names of its groups.
    pub groups: Vec<Shared<str>>,
    /// Pairs of a key and a text, in their order. No key is twice.
    pub user_text: Vec<(Shared<str>, Shared<str>)>,
    /// The same of the geometry itself, which scripts set (`SetUserString`) and which stay with it when it is moved.
    pub geometry_text: Vec<(Shared<str>, Shared<str>)>,
}

/// How an object takes part in a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Visibility {
    /// Seen and selectable.
    #[default]
    Normal,
    /// Hidden.
    Hidden,
    /// Seen but not selectable.
    Locked,
}

impl Visibility {
    /// All of them, in the order of their numbers in archives.
    pub const ALL: [Self; 3] = [Self::Normal, Self::Hidden, Self::Locked];

    /// The word for it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Normal => "Normal",
            Self::Hidden => "Hidden",
            Self::Locked => "Locked",
        }
    }
}

impl ModelObject {
    /// An object without attributes. An object as geometry is taken over with what it has.
    pub fn new(geometry: Value) -> Self {
        match &geometry {
            Value::Content(content) => match &**content {
                Content::Object(object) => object.clone(),
                _ => Self { geometry: Some(geometry), ..Self::default() },
            },
            _ => Self { geometry: Some(geometry), ..Self::default() },
        }
    }

    /// Geometry that carries texts of its own; without any it is that geometry. Texts that it carried already are
    /// replaced, and attributes are left behind.
    pub fn carrying(geometry: Value, texts: Vec<(Shared<str>, Shared<str>)>) -> Value {
        let geometry = match &geometry {
            Value::Content(content) => match &**content {
                Content::Object(Self { geometry: Some(inner), .. }) => inner.clone(),
                _ => geometry,
            },
            _ => geometry,
        };
        if texts.is_empty() {
            return geometry;
        }
        Value::from(Self { geometry: Some(geometry), geometry_text: texts, ..Self::default() })
    }

    /// The text under a key.
    pub fn text_of(&self, key: &str) -> Option<&Shared<str>> {
        self.user_text.iter().find(|(known, _)| **known == *key).map(|(_, text)| text)
    }

    /// Puts a text under a key, in the place of what was there.
    pub fn set_text(&mut self, key: &str, text: impl Into<Shared<str>>) {
        match self.user_text.iter_mut().find(|(known, _)| **known == *key) {
            Some((_, old)) => *old = text.into(),
            None => self.user_text.push((key.into(), text.into())),
        }
    }
}
