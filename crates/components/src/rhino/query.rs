//! Rhino / Object: finding objects in the model.

use std::sync::Arc;

use katydid_component::{Context, Message, component};
use katydid_data::Value;

use super::model;
use crate::params::wildcard::Wildcard;

/// Finds objects in the Rhino model by name, layer, group and state.
///
/// `*` in a filter stands for any text, `?` for one character. An input without data asks for nothing. The objects
/// come with their attributes, and are their geometry where geometry is asked for. The model is the file given to
/// `katydid run` with `--model`.
#[component(
    "3ed98048-ed09-41ef-b378-74c60c8d3e9a",
    name = "Query Model Objects",
    nick = "Objects",
    at = "Rhino/Object"
)]
#[output("Objects", "O", "The objects, in the order of the model.", kind = Content)]
fn query_model_objects(
    context: &Context<'_>,
    /// The name.
    #[port("Name", "N", optional)]
    name: Option<Arc<str>>,
    /// The layer, by its path (`Outer::Inner`) or its own name.
    #[port("Layer", "L", optional)]
    layer: Option<Arc<str>>,
    /// The name of a group.
    #[port("Group", "G", optional)]
    group: Option<Arc<str>>,
    /// Whether locked objects count.
    #[port("Locked", "Lo", default = true)]
    locked: bool,
    /// Whether hidden objects count.
    #[port("Hidden", "Ho", default = true)]
    hidden: bool,
) -> Result<Vec<Value>, Message> {
    let names = name.as_deref().map(Wildcard::new).transpose()?;
    let layers = layer.as_deref().map(Wildcard::new).transpose()?;
    let groups = group.as_deref().map(Wildcard::new).transpose()?;
    let found = model(context)?.objects().iter().filter(|object| {
        (hidden || !object.is_hidden)
            && (locked || !object.is_locked)
            && names.as_ref().is_none_or(|names| names.takes(&object.name))
            && layers.as_ref().is_none_or(|layers| layers.takes_layer(&object.layer))
            && groups.as_ref().is_none_or(|groups| object.groups.iter().any(|name| groups.takes(name)))
    });
    let found: Vec<Value> = found.map(|object| object.content.clone()).collect();
    context.items(found.len())?;
    Ok(found)
}

#[cfg(test)]
mod tests {
    use katydid_3dm::{Attributes, Group, Layer, Model, ModelObject, Object, ObjectMode};
    use katydid_component::{RhinoModel, testing::Trial};
    use katydid_geometry::Point3;

    #[test]
    fn objects_are_asked_for_by_name_layer_group_and_state() {
        let layers = vec![Layer::new("Walls"), Layer { locked: true, ..Layer::new("Roof") }];
        let mut model = Model { layers, groups: vec![Group::new("west")], ..Model::default() };
        for (x, layer, groups, mode) in [
            (1.0, 0, vec![0], ObjectMode::Normal),
            (2.0, 0, vec![], ObjectMode::Hidden),
            (3.0, 1, vec![], ObjectMode::Normal),
        ] {
            let attributes = Attributes { layer: Some(layer), groups, mode, ..Attributes::default() };
            let point = Object::Point(Point3::new(x, 0.0, 0.0));
            model.objects.push(ModelObject { attributes, ..ModelObject::from(point) });
        }
        let query = || Trial::of("Query Model Objects").model(RhinoModel::new(model.clone()));
        assert_eq!(query().texts(0), ["{0;0}: {1, 0, 0}, {2, 0, 0}, {3, 0, 0}"]);
        assert_eq!(query().default().item("w*").texts(0), ["{0;0}: {1, 0, 0}, {2, 0, 0}"]);
        assert_eq!(query().default().default().item("west").texts(0), ["{0;0}: {1, 0, 0}"]);
        let seen = query().default().default().default().item(false).item(false);
        assert_eq!(seen.texts(0), ["{0;0}: {1, 0, 0}"]);
        assert!(Trial::of("Query Model Objects").message().starts_with("Needs the Rhino model"));
    }
}
