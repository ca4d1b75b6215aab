//! Objects of a Rhino model that are made or changed: attributes put on geometry, as plug-ins that bake do.

use std::sync::Arc as Shared;

use katydid_component::{Access, Context, Matching, Ranges};
use katydid_data::{Content, ModelLayer, ModelMaterial, ModelObject, Tree, Value};

/// The object that an item is, or is the geometry of.
pub(crate) fn object_of(context: &Context<'_>, value: &Value) -> Option<ModelObject> {
    let known = context.model().and_then(|model| model.object_of(value)).map(|object| &object.content);
    own_object(known.unwrap_or(value))
}

/// The object that an item is.
pub(crate) fn own_object(value: &Value) -> Option<ModelObject> {
    match value {
        Value::Content(content) => match &**content {
            Content::Object(object) => Some(object.clone()),
            _ => None,
        },
        _ => None,
    }
}

/// Geometry with attributes: those that are given go before those that it has.
pub(crate) fn attributed(geometry: Value, attributes: Option<&ModelObject>) -> ModelObject {
    let mut object = ModelObject::new(geometry);
    let Some(given) = attributes else { return object };
    if !given.name.is_empty() {
        object.name = given.name.clone();
    }
    object.layer = given.layer.clone().or(object.layer);
    object.colour = given.colour.or(object.colour);
    object.material = given.material.clone().or(object.material);
    object.visibility = given.visibility;
    if !given.groups.is_empty() {
        object.groups.clone_from(&given.groups);
    }
    for (key, text) in &given.user_text {
        object.set_text(key, text.clone());
    }
    object
}

/// Items of geometry with the attributes that stand beside them: branch by branch, the last of a shorter list again and again.
pub(crate) fn pairs(geometry: &Tree, attributes: &Tree) -> Vec<ModelObject> {
    // Geometry without attributes is none of the matching's business.
    if attributes.is_empty() {
        let items = (0..geometry.item_count()).filter_map(|at| geometry.column().get(at));
        return items.map(|value| attributed(value, None)).collect();
    }
    let inputs = [geometry.clone(), attributes.clone()];
    let matching = Matching::new(&inputs, &[Access::Item; 2], None);
    let mut ranges = Ranges::new();
    let mut objects = Vec::new();
    for set in 0..matching.paths().len() {
        matching.ranges(set, &mut ranges);
        let [things, given] = ranges.as_slice() else { continue };
        for index in 0..matching.set_range(set).len() {
            let at =
                |range: &std::ops::Range<usize>| Some(range.start + index.min(range.len().checked_sub(1)?));
            let value = at(things).and_then(|at| geometry.column().get(at));
            let given = at(given).and_then(|at| attributes.column().get(at)).as_ref().and_then(own_object);
            objects.extend(value.map(|value| attributed(value, given.as_ref())));
        }
    }
    objects
}

/// The layer that an item names, by its path, or is.
pub(crate) fn layer_of(value: Option<&Value>) -> Option<Shared<ModelLayer>> {
    match value? {
        Value::Text(path) if !path.trim().is_empty() => Some(Shared::new(ModelLayer::at(path.trim()))),
        Value::Content(content) => match &**content {
            Content::Layer(layer) => Some(layer.clone()),
            _ => None,
        },
        _ => None,
    }
}

/// The material that an item names, or is; a colour is one without a name.
pub(crate) fn material_of(value: Option<&Value>) -> Option<Shared<ModelMaterial>> {
    let material = match value? {
        Value::Text(name) if !name.trim().is_empty() => ModelMaterial::named(name.trim()),
        Value::Material(look) => ModelMaterial { name: "".into(), look: Some(**look) },
        Value::Colour(colour) => ModelMaterial { name: "".into(), look: Some((*colour).into()) },
        _ => return None,
    };
    Some(Shared::new(material))
}

/// The first item of a tree that is not null.
pub(crate) fn first(tree: &Tree) -> Option<Value> {
    tree.branches().find_map(|branch| branch.iter().flatten().next())
}

/// Whether the first item of a tree is true.
pub(crate) fn is_true(tree: Option<&Tree>) -> bool {
    matches!(tree.and_then(first), Some(Value::Boolean(true)))
}
