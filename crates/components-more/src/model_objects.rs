//! Objects of a Rhino model that are made or changed: attributes put on geometry, as plug-ins that bake do.

use std::sync::Arc as Shared;

use katydid_component::{Access, Context, Matching, Ranges};
use katydid_data::{Content, ModelLayer, ModelMaterial, ModelObject, Tree, Value};

use crate::wildcard::takes;

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

/// What an object is, in the words that filters by type take.
pub(crate) fn type_name(value: &Value) -> &'static str {
    match value {
        Value::Point(_) => "Point",
        Value::Line(_) | Value::Circle(_) | Value::Arc(_) | Value::Rectangle(_) | Value::Curve(_) => "Curve",
        Value::Surface(_) => "Surface",
        Value::Brep(_) | Value::Box(_) | Value::TwistedBox(_) => "Brep",
        Value::Mesh(_) => "Mesh",
        Value::Kept(raw) => class_word(&raw.class_name()),
        Value::Content(content) => match &**content {
            Content::Object(object) => object.geometry.as_ref().map_or("Other", type_name),
            Content::Instance(_) => "Block",
            _ => "Other",
        },
        _ => "Other",
    }
}

/// The word for a class of an archive.
fn class_word(class: &str) -> &'static str {
    match class {
        "PointCloud" => "PointCloud",
        "Brep" => "Brep",
        "Mesh" => "Mesh",
        "Extrusion" => "Extrusion",
        "SubD" => "SubD",
        "Hatch" => "Hatch",
        "Light" => "Light",
        "Text" => "Text",
        "Leader" => "Leader",
        "TextDot" | "AnnotationTextDot" => "TextDot",
        "InstanceReference" => "Block",
        "ClippingPlaneSurface" => "ClippingPlane",
        class if class.ends_with("Dimension") || class == "Centermark" => "Dimension",
        class if class.ends_with("Curve") => "Curve",
        class if class.ends_with("Surface") => "Surface",
        _ => "Other",
    }
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

/// Whether an item is of a type that a filter names: as [`type_name`] has it, or as Rhino's list of object types does.
pub(crate) fn is_of_type(value: &Value, wanted: &str) -> bool {
    let other: &[&str] = match type_name(value) {
        "Block" => &["InstanceReference", "BlockInstance"],
        "Text" | "Leader" | "Dimension" => &["Annotation"],
        "PointCloud" => &["PointSet"],
        "Brep" => &["Polysurface"],
        _ => &[],
    };
    let wanted = wanted.trim();
    takes(wanted, type_name(value)) || other.iter().any(|name| takes(wanted, name))
}
