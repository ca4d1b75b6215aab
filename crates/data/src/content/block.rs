use std::sync::Arc as Shared;

use katydid_geometry::{BoundingBox, Xform};
use uuid::Uuid;

use super::{Content, ModelObject};
use crate::{Value, cast};

/// Blocks in blocks beyond this depth are not followed.
const DEEPEST: usize = 50;

/// A block: objects under a name, to be placed many times.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BlockDefinition {
    /// Its identifier in the model; none for a block that no model has yet.
    pub id: Option<Uuid>,
    /// Its name.
    pub name: Shared<str>,
    /// What it is.
    pub description: Shared<str>,
    /// A web address.
    pub url: Shared<str>,
    /// What the web address is called.
    pub url_description: Shared<str>,
    objects: Vec<ModelObject>,
    bounds: Option<BoundingBox>,
    height: usize,
}

impl BlockDefinition {
    /// A block of these objects. Those that are blocks in blocks deeper than 50 lose their geometry.
    pub fn new(name: impl Into<Shared<str>>, mut objects: Vec<ModelObject>) -> Self {
        let mut height = 0;
        for object in &mut objects {
            let inner = object.geometry.as_ref().and_then(instance).map_or(0, |i| i.definition.height + 1);
            if inner > DEEPEST {
                object.geometry = None;
            } else {
                height = height.max(inner);
            }
        }
        let boxes = objects.iter().filter_map(|object| cast::bounds(object.geometry.as_ref()?));
        let bounds = boxes.reduce(|a, b| a.union(&b));
        Self { name: name.into(), objects, bounds, height, ..Self::default() }
    }

    /// The objects, in the space of the block.
    pub fn objects(&self) -> &[ModelObject] {
        &self.objects
    }

    /// The box round all objects, as far as they have one.
    pub fn bounds(&self) -> Option<BoundingBox> {
        self.bounds
    }
}

/// The block that a value places.
fn instance(value: &Value) -> Option<&BlockInstance> {
    match value {
        Value::Content(content) => match &**content {
            Content::Instance(instance) => Some(instance),
            _ => None,
        },
        _ => None,
    }
}

/// A block placed in space.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockInstance {
    /// The block.
    pub definition: Shared<BlockDefinition>,
    /// From the space of the block to the space it is placed in.
    pub transform: Xform,
}

impl BlockInstance {
    /// A box round the placed objects: round the image of the block's own box.
    pub fn bounds(&self) -> Option<BoundingBox> {
        let corners = self.definition.bounds()?.corners();
        BoundingBox::from_points(corners.map(|corner| self.transform.point(corner)))
    }

    /// The same block, moved on.
    #[must_use]
    pub fn transformed(&self, by: &Xform) -> Self {
        Self { definition: self.definition.clone(), transform: *by * self.transform }
    }
}
