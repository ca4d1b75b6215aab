//! Blocks that are placed in a model: what they show, and blocks that are made.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message};
use katydid_data::{BlockDefinition, BlockInstance, Content, ModelObject, Value};
use katydid_geometry::{Plane, Xform};

use crate::model_objects::{attributed, object_of, own_object, type_name};

/// The block that an item places.
pub(crate) fn placed(value: &Value) -> Option<BlockInstance> {
    match value {
        Value::Content(content) => match &**content {
            Content::Instance(instance) => Some(instance.clone()),
            _ => None,
        },
        _ => None,
    }
}

/// The block that an item places, itself or as the geometry of an object of the model.
pub(crate) fn instance_of(context: &Context<'_>, value: &Value) -> Option<BlockInstance> {
    placed(value).or_else(|| placed(object_of(context, value)?.geometry.as_ref()?))
}

/// The block that an item names, places or is.
///
/// # Errors
/// There is none of that name, or the item is no block.
pub(crate) fn block_of(context: &Context<'_>, value: &Value) -> Result<Shared<BlockDefinition>, Message> {
    if let Some(instance) = instance_of(context, value) {
        return Ok(instance.definition);
    }
    match value {
        Value::Text(name) => {
            let known = context.model().and_then(|model| model.block(name.trim())).cloned();
            known.ok_or_else(|| Message::error(format!("No block is called {name}")))
        }
        Value::Content(content) => match &**content {
            Content::Block(block) => Ok(block.clone()),
            _ => Err(no_block(value)),
        },
        _ => Err(no_block(value)),
    }
}

/// What a component says of an item that is no block.
pub(crate) fn no_block(value: &Value) -> Message {
    Message::error(format!("A {} is no block", type_name(value)))
}

/// The objects of a block where it shows them. Those that cannot be moved are left out with a warning.
///
/// # Errors
/// There are more than may be made.
pub(crate) fn shown(
    context: &Context<'_>,
    block: &BlockDefinition,
    by: &Xform,
) -> Result<Vec<ModelObject>, Message> {
    context.items(block.objects().len())?;
    let mut placed = Vec::with_capacity(block.objects().len());
    for object in block.objects() {
        context.check()?;
        let Some(geometry) = &object.geometry else { continue };
        let stays = *by == Xform::IDENTITY;
        let geometry = if stays { Ok(geometry.clone()) } else { geometry.transformed(by) };
        match geometry {
            // A copy is an object of its own.
            Ok(geometry) => {
                placed.push(ModelObject { id: None, geometry: Some(geometry), ..object.clone() });
            }
            Err(error) => context.warn(format!("Left out: {error}")),
        }
    }
    Ok(placed)
}

/// A block of geometry with attributes, of which the last is for all that follow; what lies in the base plane lies in the XY plane of
/// the block.
///
/// # Errors
/// There is no name or no geometry, or it cannot be moved.
pub(crate) fn made(
    name: &str,
    geometry: impl Iterator<Item = Value>,
    attributes: &[Value],
    base: &Plane,
) -> Result<BlockDefinition, Message> {
    if name.trim().is_empty() {
        return Err(Message::error("The block has no name"));
    }
    let back = Xform::plane_to_plane(base, &Plane::XY);
    let mut objects = Vec::new();
    for (place, value) in geometry.enumerate() {
        let given = attributes.get(place).or_else(|| attributes.last()).and_then(own_object);
        let mut object = attributed(value, given.as_ref());
        if let Some(geometry) = &object.geometry {
            let stays = back == Xform::IDENTITY;
            object.geometry = Some(if stays { geometry.clone() } else { geometry.transformed(&back)? });
        }
        objects.push(object);
    }
    if objects.is_empty() {
        return Err(Message::error(format!("The block {name} has no geometry")));
    }
    Ok(BlockDefinition::new(name.trim(), objects))
}
