use std::sync::Arc as Shared;

use uuid::Uuid;

use crate::{Colour, Material};

/// A layer of a Rhino model.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ModelLayer {
    /// Its identifier in the model; none for a layer that no model has yet.
    pub id: Option<Uuid>,
    /// The names from the outermost layer in, joined by `::`.
    pub path: Shared<str>,
    /// The colour of its objects; none when only its path is known.
    pub colour: Option<Colour>,
    /// Whether it, or one it lies in, is hidden.
    pub hidden: bool,
    /// Whether it, or one it lies in, is locked.
    pub locked: bool,
}

impl ModelLayer {
    /// A layer of which only the path is known.
    pub fn at(path: impl Into<Shared<str>>) -> Self {
        Self { path: path.into(), ..Self::default() }
    }

    /// Its own name, without those of the layers it lies in.
    pub fn name(&self) -> &str {
        self.path.rsplit_once("::").map_or(&self.path, |(_, name)| name)
    }

    /// The path of the layer it lies in.
    pub fn parent(&self) -> Option<&str> {
        self.path.rsplit_once("::").map(|(parent, _)| parent)
    }
}

/// A material of a Rhino model.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ModelMaterial {
    /// Its name; empty where it has none.
    pub name: Shared<str>,
    /// How it looks; none where only its name is known.
    pub look: Option<Material>,
}

impl ModelMaterial {
    /// A material of which only the name is known.
    pub fn named(name: impl Into<Shared<str>>) -> Self {
        Self { name: name.into(), look: None }
    }
}

/// A pattern that lines are drawn in.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelLinetype {
    /// Its identifier in the model; none for a linetype that no model has yet.
    pub id: Option<Uuid>,
    /// Its name.
    pub name: Shared<str>,
    /// The lengths of dashes, positive, and gaps, negative, in millimetres; none for a continuous line.
    pub segments: Vec<f64>,
    /// The ends of lines: 0 round, 1 flat, 2 square.
    pub cap: i32,
    /// The corners of lines: 0 round, 1 mitred, 2 bevelled.
    pub join: i32,
    /// The width in `width_units`.
    pub width: f64,
    /// The unit of the width as Rhino numbers units; 0 for pixels.
    pub width_units: i32,
}

impl Default for ModelLinetype {
    /// A continuous line, one pixel wide.
    fn default() -> Self {
        Self {
            id: None,
            name: "Continuous".into(),
            segments: Vec::new(),
            cap: 0,
            join: 0,
            width: 1.0,
            width_units: 0,
        }
    }
}
