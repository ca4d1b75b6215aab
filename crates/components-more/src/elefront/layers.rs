//! Layers and colours of attributes, and attributes taken apart.

use std::sync::Arc;

use katydid_component::{Context, Message, component};
use katydid_data::{Colour, ModelLayer, Value};

use super::bake::BAKE_NAME;
use crate::model_objects::{attributed, object_of, own_object};

/// A layer for attributes. Stands for EleFront's Define Layer.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd221",
    name = "Define Layer",
    nick = "Layer",
    at = "EleFront/03 Attributes"
)]
#[output("Layer", "L", "The layer.", kind = Content)]
fn define_layer(
    /// The path (`Outer::Inner`).
    #[port("Layer Name", "N")]
    name: Arc<str>,
    /// The colour of its objects.
    #[port("Color", "C", optional)]
    colour: Option<Colour>,
) -> Result<Value, Message> {
    if name.trim().is_empty() {
        return Err(Message::error("The layer has no name"));
    }
    Ok(Value::from(ModelLayer { colour, ..ModelLayer::at(name.trim()) }))
}

/// A colour for attributes; null where the source is another than the object itself, so that the object has the colour of its layer.
/// Stands for EleFront's Define Color; that colours of a parent and of a material are those of the layer is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd222",
    name = "Define Color",
    nick = "Color",
    at = "EleFront/03 Attributes"
)]
#[output("Color", "C", "The colour.")]
fn define_color(
    context: &Context<'_>,
    /// The colour.
    #[port("Color", "C", optional)]
    colour: Option<Colour>,
    /// Where the colour comes from: Object, Layer, Parent or Material.
    #[port("Source", "[]S", default = "Object")]
    source: Arc<str>,
) -> Result<Option<Colour>, Message> {
    // Value lists may write the sources as Rhino names them: ColorFromLayer.
    let word = source.trim().to_lowercase();
    match word.strip_prefix("colorfrom").unwrap_or(&word) {
        "object" => Ok(colour),
        "layer" => Ok(None),
        "parent" | "material" => {
            context.tell(Message::remark("Colours of a parent or a material are those of the layer"));
            Ok(None)
        }
        _ => Err(Message::error(format!("{source} is none of Object, Layer, Parent and Material"))),
    }
}

/// Geometry with attributes, as an object of the model: what it has already stays where the attributes say nothing. Stands for
/// EleFront's Create Attributed Geometry, an earlier name of Attach Attributes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd223",
    name = "Create Attributed Geometry",
    nick = "AttGeo",
    at = "EleFront/03 Attributes"
)]
#[output("Attributed Geometry", "G", "The object.", kind = Content)]
fn attributed_geometry(
    /// The geometry.
    #[port("Geometry", "G", kind = Generic)]
    geometry: Value,
    /// The attributes.
    #[port("Attributes", "A", kind = Generic, optional)]
    attributes: Option<Value>,
) -> Value {
    Value::from(attributed(geometry, attributes.as_ref().and_then(own_object).as_ref()))
}

type KeysAndTexts = (Vec<Arc<str>>, Vec<Arc<str>>);

/// The user texts of an object or of attributes.
fn texts_of(context: &Context<'_>, value: &Value) -> Result<KeysAndTexts, Message> {
    let Some(object) = object_of(context, value) else {
        context.warn("The geometry is of no object of the model: it has no attributes");
        return Ok((Vec::new(), Vec::new()));
    };
    context.items(object.user_text.len().saturating_mul(2))?;
    Ok(object.user_text.iter().cloned().unzip())
}

/// The user texts of an object or of attributes. Stands for EleFront's Deconstruct Attributes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd224",
    name = "Deconstruct Attributes",
    nick = "DeAtt",
    at = "EleFront/03 Attributes"
)]
#[output("Keys", "K", "The keys, in their order.")]
#[output("Values", "V", "The text under each.")]
fn deconstruct(
    context: &Context<'_>,
    /// The object, its geometry, or attributes.
    #[port("Referenced Geometry or Attributes", "A", kind = Generic)]
    object: Value,
) -> Result<(Vec<Arc<str>>, Vec<Arc<str>>), Message> {
    texts_of(context, &object)
}

/// The user texts of an object or of attributes, and the name that it was baked under, which is not among them. Stands for EleFront's
/// Get All Keys/Values; that the name is the user text `BakeName` is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd225",
    name = "Get All Keys/Values",
    nick = "GetKV",
    at = "EleFront/03 Attributes"
)]
#[output("Keys", "K", "The keys, in their order.")]
#[output("Values", "V", "The text under each.")]
#[output("BakeName", "B", "The name of the bake.")]
fn all_keys(
    context: &Context<'_>,
    /// The object, its geometry, or attributes.
    #[port("Attributes or Attributed Geometry", "A", kind = Generic)]
    object: Value,
) -> Result<(Vec<Arc<str>>, Vec<Arc<str>>, Option<Arc<str>>), Message> {
    let (keys, texts) = texts_of(context, &object)?;
    let (mut own, mut bake) = ((Vec::new(), Vec::new()), None);
    for (key, text) in keys.into_iter().zip(texts) {
        if &*key == BAKE_NAME {
            bake = Some(text);
        } else {
            own.0.push(key);
            own.1.push(text);
        }
    }
    Ok((own.0, own.1, bake))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::{Colour, ModelObject, Value};
    use katydid_geometry::Point3;

    use crate::model_objects::own_object;

    #[test]
    fn layers_are_defined() {
        let layer = Trial::of("Define Layer").item(" House::Walls ").item(Colour::rgb(1, 2, 3));
        let layer = layer.run().outputs[0].clone();
        assert_eq!(texts(&layer), ["{0}: House::Walls"]);
        let attributes = Trial::of("Define Object Attributes").default().default().default().tree(layer);
        let object = own_object(&attributes.run().outputs[0].column().get(0).unwrap()).unwrap();
        assert_eq!(object.layer.unwrap().colour, Some(Colour::rgb(1, 2, 3)));
        assert_eq!(Trial::of("Define Layer").item(" ").message(), "The layer has no name");
    }

    #[test]
    fn colours_by_their_source() {
        let from = |source: &str| Trial::of("Define Color").item(Colour::rgb(1, 2, 3)).item(source);
        assert_eq!(from("object").texts(0), ["{0}: 1,2,3"]);
        assert_eq!(from("ColorFromLayer").texts(0), ["{0}: null"]);
        assert!(from("Parent").message().contains("those of the layer"));
        assert!(from("Sky").message().starts_with("Sky is none of"));
    }

    #[test]
    fn attributes_are_taken_apart() {
        let mut attributes = ModelObject::default();
        for (key, text) in [("fire", "yes"), ("BakeName", "run"), ("height", "3")] {
            attributes.set_text(key, text);
        }
        let attributes = Value::from(attributes);
        let made = Trial::of("Create Attributed Geometry").item(Point3::ORIGIN).item(attributes);
        let object = made.run().outputs[0].clone();
        let told = |name: &str, k: usize| Trial::of(name).tree(object.clone()).texts(k);
        assert_eq!(told("Deconstruct Attributes", 0), ["{0;0}: fire, BakeName, height"]);
        assert_eq!(told("Deconstruct Attributes", 1), ["{0;0}: yes, run, 3"]);
        assert_eq!(told("Get All Keys/Values", 0), ["{0;0}: fire, height"]);
        assert_eq!(told("Get All Keys/Values", 1), ["{0;0}: yes, 3"]);
        assert_eq!(told("Get All Keys/Values", 2), ["{0}: run"]);
        let none = Trial::of("Deconstruct Attributes").item(Point3::ORIGIN);
        assert!(none.message().contains("no attributes"));
    }
}
