//! Attributes that objects are baked with.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Colour, ModelObject, Value};

use crate::model_objects::{attributed, layer_of, material_of, object_of, own_object};

/// Attributes for objects that are baked: user texts under keys, name, layer, colour and material. Stands for EleFront's Define
/// Object Attributes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd207",
    name = "Define Object Attributes",
    nick = "Attributes",
    at = "EleFront/03 Attributes"
)]
#[output("Attributes", "A", "The attributes.", kind = Content)]
fn define(
    /// The keys of user texts.
    #[port("User Keys", "K", optional)]
    keys: List<Shared<str>>,
    /// The text under each key.
    #[port("User Values", "V", optional)]
    values: List<Shared<str>>,
    /// What the object is called.
    #[port("Name", "N", optional)]
    name: Option<Shared<str>>,
    /// The path of its layer (`Outer::Inner`), or a layer.
    #[port("Layer", "[]L", kind = Generic, optional)]
    layer: Option<Value>,
    /// Its colour.
    #[port("Color", "C", optional)]
    colour: Option<Colour>,
    /// The name of its material, or a material.
    #[port("Material", "[]M", kind = Generic, optional)]
    material: Option<Value>,
) -> Result<Value, Message> {
    defined(name, layer.as_ref(), colour, material.as_ref(), &keys, &values)
}

/// Attributes of those parts.
///
/// # Errors
/// There are not as many texts as keys.
pub(super) fn defined(
    name: Option<Shared<str>>,
    layer: Option<&Value>,
    colour: Option<Colour>,
    material: Option<&Value>,
    keys: &List<Shared<str>>,
    values: &List<Shared<str>>,
) -> Result<Value, Message> {
    let mut object = ModelObject {
        name: name.unwrap_or_default(),
        layer: layer_of(layer),
        colour,
        material: material_of(material),
        ..ModelObject::default()
    };
    texts(&mut object, keys, values)?;
    Ok(Value::from(object))
}

/// Puts texts under keys.
///
/// # Errors
/// There are not as many texts as keys.
pub(crate) fn texts(
    object: &mut ModelObject,
    keys: &List<Shared<str>>,
    values: &List<Shared<str>>,
) -> Result<(), Message> {
    if keys.len() != values.len() {
        return Err(Message::error(format!("There are {} keys and {} values", keys.len(), values.len())));
    }
    for (key, text) in keys.iter().zip(values.iter()) {
        if let Some(key) = key.filter(|key| !key.is_empty()) {
            object.set_text(&key, text.unwrap_or_default());
        }
    }
    Ok(())
}

/// Geometry with attributes, as an object of the model: what it has already stays where the attributes say nothing. Stands for
/// EleFront's Attach Attributes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd208",
    name = "Attach Attributes",
    nick = "AttAtt",
    at = "EleFront/03 Attributes"
)]
#[output("Attributed Geometry", "AG", "The object.", kind = Content)]
fn attach(
    /// The geometry.
    #[port("Geometry", "G", kind = Generic)]
    geometry: Value,
    /// The attributes.
    #[port("Attributes", "A", kind = Generic, optional)]
    attributes: Option<Value>,
) -> Value {
    Value::from(attributed(geometry, attributes.as_ref().and_then(own_object).as_ref()))
}

/// An object taken apart into its geometry and its attributes. Stands for EleFront's Detach Attributes; the names of its outputs are
/// our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd209",
    name = "Detach Attributes",
    nick = "DetAtt",
    at = "EleFront/03 Attributes"
)]
#[output("Geometry", "G", "The geometry.", kind = Generic)]
#[output("Attributes", "A", "The attributes.", kind = Content)]
fn detach(
    context: &Context<'_>,
    /// The object, or its geometry.
    #[port("Attributed Geometry", "AG", kind = Generic)]
    object: Value,
) -> (Option<Value>, Option<Value>) {
    let Some(mut own) = object_of(context, &object) else { return (Some(object), None) };
    let geometry = own.geometry.take();
    (geometry, Some(Value::from(own)))
}

/// The user text of an object under a key; null where there is none. Stands for EleFront's Get User Value; the names of its ports
/// are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd20a",
    name = "Get User Value",
    nick = "GetUV",
    at = "EleFront/03 Attributes"
)]
#[output("Value", "V", "The text under the key.")]
fn user_value(
    context: &Context<'_>,
    /// The object, or its geometry.
    #[port("Geometry", "G", kind = Generic)]
    object: Value,
    /// The key.
    #[port("Key", "K")]
    key: Shared<str>,
) -> Option<Shared<str>> {
    object_of(context, &object).and_then(|object| object.text_of(&key).cloned())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Colour, ModelObject, Value};
    use katydid_geometry::Point3;

    use crate::model_objects::own_object;

    fn made(trial: Trial) -> ModelObject {
        own_object(&trial.run().outputs[0].column().get(0).unwrap()).unwrap()
    }

    fn attributes() -> Trial {
        Trial::of("Define Object Attributes")
            .list(["height", "fire"])
            .list(["3", "yes"])
            .item("north")
            .item("House::Walls")
            .item(Colour::rgb(200, 10, 20))
            .item("Concrete")
    }

    #[test]
    fn attributes_are_defined_and_attached() {
        let own = made(attributes());
        assert_eq!((&*own.name, &*own.layer.as_ref().unwrap().path), ("north", "House::Walls"));
        assert_eq!(own.colour, Some(Colour::rgb(200, 10, 20)));
        assert_eq!(&*own.material.as_ref().unwrap().name, "Concrete");
        assert_eq!(own.user_text.len(), 2);
        let object = made(Trial::of("Attach Attributes").item(Point3::ORIGIN).item(Value::from(own.clone())));
        assert_eq!(object, ModelObject { geometry: Some(Value::from(Point3::ORIGIN)), ..own.clone() });
        // What the new ones do not say stays.
        let mut other = ModelObject { name: "south".into(), ..ModelObject::default() };
        other.set_text("fire", "no");
        let again = made(Trial::of("Attach Attributes").item(Value::from(object)).item(Value::from(other)));
        assert_eq!((&*again.name, &*again.layer.as_ref().unwrap().path), ("south", "House::Walls"));
        assert_eq!(again.text_of("fire").map(|text| &**text), Some("no"));
        assert_eq!(again.text_of("height").map(|text| &**text), Some("3"));
        let value =
            |key: &str| Trial::of("Get User Value").item(Value::from(again.clone())).item(key).texts(0);
        assert_eq!(value("height"), ["{0}: 3"]);
        assert_eq!(value("width"), ["{0}: null"]);
        let apart = Trial::of("Detach Attributes").item(Value::from(again.clone())).run();
        assert_eq!(apart.outputs[0].column().get(0), Some(Value::from(Point3::ORIGIN)));
        let left = own_object(&apart.outputs[1].column().get(0).unwrap()).unwrap();
        assert_eq!(left, ModelObject { geometry: None, ..again });
    }

    #[test]
    fn keys_have_a_value_each() {
        let trial = Trial::of("Define Object Attributes").list(["a", "b"]).list(["1"]);
        let trial = trial.default().default().default().default();
        assert_eq!(trial.message(), "There are 2 keys and 1 values");
    }
}
