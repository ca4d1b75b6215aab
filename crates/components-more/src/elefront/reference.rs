//! Objects of the Rhino model by layer, name, type, colour and user text.

use std::sync::Arc;

use katydid_component::{Context, List, Message, RhinoModel, component};
use katydid_data::{Colour, Content, ModelObject, Value};

use super::bake::BAKE_NAME;
use super::criteria::{any, colour_of, coloured, has_all, of_types, on_layers, pairs};
use crate::model_objects::object_of;

pub(crate) fn model<'a>(context: &Context<'a>) -> Result<&'a RhinoModel, Message> {
    let why = "Needs the Rhino model: none is given (katydid run FILE --model MODEL.3dm)";
    context.model().ok_or_else(|| Message::warning(why))
}

/// The objects that pass, in the order of the model.
pub(crate) fn objects(
    context: &Context<'_>,
    passes: impl Fn(&ModelObject) -> bool,
) -> Result<Vec<Value>, Message> {
    let mut found = Vec::new();
    for object in model(context)?.objects() {
        context.check()?;
        let Value::Content(content) = &object.content else { continue };
        if let Content::Object(known) = &**content
            && known.geometry.is_some()
            && passes(known)
        {
            found.push(object.content.clone());
        }
    }
    context.items(found.len())?;
    Ok(found)
}

/// A component of the objects of the Rhino model that pass.
macro_rules! reference {
    (
        $(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal,
        [$($(#[$told:meta])* $port:literal, $short:literal, $given:ident: $type:ty;)*],
        $passes:expr
    ) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "EleFront/01 Reference")]
        #[output("Geometry", "G", "The objects.", kind = Content)]
        fn $function(
            context: &Context<'_>,
            $(
                $(#[$told])*
                #[port($port, $short)]
                $given: List<$type>,
            )*
        ) -> Result<Vec<Value>, Message> {
            objects(context, $passes)
        }
    };
}

reference!(
    /// The objects of the Rhino model on layers. `*` stands for any text, `?` for one character; capitals do not matter. Stands for
    /// EleFront's Reference by Layer; that layers below are left out is our reading.
    reference_by_layer, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd201", "Reference by Layer", "RefLayer",
    [
        /// The paths of the layers (`Outer::Inner`), or their own names.
        "Layer", "L", layers: Arc<str>;
    ],
    |object| on_layers(object, &layers)
);

reference!(
    /// The objects of the Rhino model of some names. `*` stands for any text, `?` for one character; capitals do not matter. Stands
    /// for EleFront's Reference by Name.
    reference_by_name, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd202", "Reference by Name", "RefName",
    [
        /// The names.
        "Name", "N", names: Arc<str>;
    ],
    |object| any(&names, &object.name)
);

reference!(
    /// The objects of the Rhino model that have a user text under a key. Stands for EleFront's Reference by Key.
    reference_by_key, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd203", "Reference by Key", "RefKey",
    [
        /// The keys; one is enough.
        "Key", "K", keys: Arc<str>;
    ],
    |object| keys.present().any(|key| object.text_of(&key).is_some())
);

reference!(
    /// The objects of the Rhino model that have certain user texts under keys. Stands for EleFront's Reference by Key and Value; that
    /// all pairs must be there is our reading.
    reference_by_key_and_value, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd204", "Reference by Key and Value", "RefKeyValue",
    [
        /// The keys.
        "Key", "K", keys: Arc<str>;
        /// The text under each; `*` stands for any.
        "Value", "V", values: Arc<str>;
    ],
    has_all(pairs(&keys, &values)?)
);

reference!(
    /// The objects of the Rhino model that were baked under some names. `*` stands for any text, `?` for one character; capitals do not
    /// matter. Stands for EleFront's Reference by BakeName; that the name is the user text `BakeName` is our reading.
    reference_by_bake_name, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd20c", "Reference by BakeName", "RefBakeName",
    [
        /// The names.
        "BakeName", "N", names: Arc<str>;
    ],
    |object| object.text_of(BAKE_NAME).is_some_and(|name| any(&names, name))
);

reference!(
    /// The objects of the Rhino model that are seen in colours, their own or those of their layers. Stands for EleFront's Reference by
    /// Color.
    reference_by_color, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd216", "Reference by Color", "RefColor",
    [
        /// The colours.
        "Color", "C", colours: Colour;
    ],
    |object| coloured(object, &colours)
);

reference!(
    /// The objects of the Rhino model that are of types, which are those of Filter By Type. Stands for EleFront's Reference by Type.
    reference_by_type, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd217", "Reference by Type", "RefType",
    [
        /// The types.
        "Type", "T", types: Arc<str>;
    ],
    |object| object.geometry.as_ref().is_some_and(|value| of_types(value, &types))
);

reference!(
    /// The objects of the Rhino model that have certain user texts under keys, all of them. Stands for EleFront's Reference by User
    /// Atributes, an earlier name of Reference by Key and Value.
    reference_by_user_attributes, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd218", "Reference by User Atributes", "RefUA",
    [
        /// The keys.
        "Key", "K", keys: Arc<str>;
        /// The text under each; `*` stands for any.
        "Value", "V", values: Arc<str>;
    ],
    has_all(pairs(&keys, &values)?)
);

/// The name, layer and colour of an object of the Rhino model; null where geometry is of no object. Stands for EleFront's Get
/// Rhino Attributes. Material and source file are not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd205",
    name = "Get Rhino Attributes",
    nick = "GetRhAtt",
    at = "EleFront/03 Attributes"
)]
#[output("Name", "N", "The name.")]
#[output("Layer", "L", "The path of the layer.")]
#[output("Color", "C", "Its own colour, else that of its layer.")]
fn rhino_attributes(
    context: &Context<'_>,
    /// The object, or its geometry.
    #[port("Geometry", "G", kind = Generic)]
    geometry: Value,
) -> (Option<Arc<str>>, Option<Arc<str>>, Option<Colour>) {
    let Some(object) = object_of(context, &geometry) else {
        context.warn("The geometry is of no object of the model: it has no attributes");
        return (None, None, None);
    };
    let layer = object.layer.as_deref();
    let name = Some(object.name.clone()).filter(|name| !name.is_empty());
    (name, layer.map(|layer| layer.path.clone()), colour_of(&object))
}

/// The user texts of an object of the Rhino model. Stands for EleFront's Get User Attributes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd206",
    name = "Get User Attributes",
    nick = "GetUA",
    at = "EleFront/03 Attributes"
)]
#[output("Key", "K", "The keys, in their order.")]
#[output("Value", "V", "The text under each.")]
fn user_attributes(
    context: &Context<'_>,
    /// The object, or its geometry.
    #[port("Geometry", "G", kind = Generic)]
    geometry: Value,
) -> Result<(Vec<Arc<str>>, Vec<Arc<str>>), Message> {
    let Some(object) = object_of(context, &geometry) else {
        context.warn("The geometry is of no object of the model: it has no attributes");
        return Ok((Vec::new(), Vec::new()));
    };
    context.items(object.user_text.len())?;
    Ok(object.user_text.iter().cloned().unzip())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_component::{Message, RhinoModel};
    use katydid_data::{ModelLayer, ModelObject, Value};
    use katydid_geometry::Point3;

    fn wall() -> Value {
        let mut object = ModelObject::new(Value::from(Point3::new(1.0, 2.0, 3.0)));
        object.name = "north".into();
        object.layer = Some(std::sync::Arc::new(ModelLayer::at("House::Walls")));
        object.set_text("height", "3");
        object.set_text("fire", "yes");
        Value::from(object)
    }

    #[test]
    fn attributes_of_objects() {
        let rhino = |k: usize| Trial::of("Get Rhino Attributes").item(wall()).texts(k);
        assert_eq!(rhino(0), ["{0}: north"]);
        assert_eq!(rhino(1), ["{0}: House::Walls"]);
        assert_eq!(Trial::of("Get User Attributes").item(wall()).texts(0), ["{0;0}: height, fire"]);
        assert_eq!(Trial::of("Get User Attributes").item(wall()).texts(1), ["{0;0}: 3, yes"]);
    }

    #[test]
    fn geometry_of_no_object_has_none() {
        let trial = Trial::of("Get Rhino Attributes").item(Point3::ORIGIN);
        assert_eq!(trial.texts(0), ["{0}: null"]);
    }

    #[test]
    fn references_need_a_model() {
        for name in ["Reference by Layer", "Reference by Name", "Reference by Key"] {
            assert!(Trial::of(name).item("*").message().starts_with("Needs the Rhino model"), "{name}");
            assert!(Trial::of(name).item("*").model(RhinoModel::default()).message().is_empty(), "{name}");
        }
        let pairs = Trial::of("Reference by Key and Value").list(["a"]).list(["b", "c"]);
        assert_eq!(pairs.message(), Message::error("There are 1 keys and 2 values").text);
    }
}
