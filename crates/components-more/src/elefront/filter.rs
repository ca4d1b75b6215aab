//! Objects filtered and sorted by what they are and by their attributes.

use std::sync::Arc;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Colour, ModelObject, Tree, Value};

use super::criteria::{any, coloured, has_all, of_types, on_layers, pairs};
use crate::branches::{Branches, of};
use crate::model_objects::object_of;

type Passed = Result<(Vec<Value>, Vec<bool>), Message>;

/// The objects that pass, and whether each does. Null passes nothing.
fn filtered(context: &Context<'_>, geometry: &List<'_, Value>, passes: impl Fn(&Value) -> bool) -> Passed {
    context.items(geometry.len().saturating_mul(2))?;
    let mut found = (Vec::new(), Vec::with_capacity(geometry.len()));
    for value in geometry.iter() {
        context.check()?;
        let value = value.filter(|value| passes(value));
        found.1.push(value.is_some());
        found.0.extend(value);
    }
    Ok(found)
}

/// The same by attributes: geometry without any does not pass.
fn by_attributes(
    context: &Context<'_>,
    geometry: &List<'_, Value>,
    passes: impl Fn(&ModelObject) -> bool,
) -> Passed {
    filtered(context, geometry, |value| object_of(context, value).is_some_and(|object| passes(&object)))
}

/// A component of a list whose objects pass or do not.
macro_rules! filter {
    (
        $(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal,
        [$($(#[$told:meta])* $port:literal, $short:literal, $given:ident: $type:ty;)*],
        $way:ident($passes:expr)
    ) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "EleFront/02 Filter")]
        #[output("Geometry", "G", "The objects that pass.", kind = Generic)]
        #[output("Pattern", "P", "Whether each object passes.")]
        fn $function(
            context: &Context<'_>,
            /// The objects.
            #[port("Geometry", "G")]
            geometry: List<Value>,
            $(
                $(#[$told])*
                #[port($port, $short)]
                $given: List<$type>,
            )*
        ) -> Result<(Vec<Value>, Vec<bool>), Message> {
            $way(context, &geometry, $passes)
        }
    };
}

filter!(
    /// The objects of a list that are on layers. `*` stands for any text, `?` for one character; capitals do not matter. Stands for
    /// EleFront's Filter By Layer.
    filter_by_layer, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd211", "Filter By Layer", "FilterLayer",
    [
        /// The paths of the layers (`Outer::Inner`), or their own names.
        "Layer", "L", layers: Arc<str>;
    ],
    by_attributes(|object| on_layers(object, &layers))
);

filter!(
    /// The objects of a list that have names. `*` stands for any text, `?` for one character; capitals do not matter. Stands for
    /// EleFront's Filter By Name.
    filter_by_name, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd212", "Filter By Name", "FilterName",
    [
        /// The names.
        "Name", "N", names: Arc<str>;
    ],
    by_attributes(|object| any(&names, &object.name))
);

filter!(
    /// The objects of a list that are of types: Point, PointCloud, Curve, Surface, Brep, Extrusion, Mesh, SubD, Block, Text, TextDot,
    /// Leader, Dimension, Hatch, Light or ClippingPlane; Annotation stands for texts, leaders and dimensions. Stands for EleFront's Filter
    /// By Type.
    filter_by_type, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd213", "Filter By Type", "FilterType",
    [
        /// The types.
        "Type", "T", types: Arc<str>;
    ],
    filtered(|value| of_types(value, &types))
);

filter!(
    /// The objects of a list that are seen in colours, their own or those of their layers. Stands for EleFront's Filter By Color.
    filter_by_color, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd214", "Filter By Color", "FilterColor",
    [
        /// The colours.
        "Color", "C", colours: Colour;
    ],
    by_attributes(|object| coloured(object, &colours))
);

filter!(
    /// The objects of a list that have certain user texts under keys, all of them. `*` stands for any text, `?` for one character;
    /// capitals of the texts do not matter. Stands for EleFront's Filter By User Attributes.
    filter_by_user_attributes, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd215", "Filter By User Attributes", "FilterUA",
    [
        /// The keys.
        "Key", "K", keys: Arc<str>;
        /// The text under each.
        "Value", "V", values: Arc<str>;
    ],
    by_attributes(has_all(pairs(&keys, &values)?))
);

/// Objects sorted into a branch for each text that they have under a key, in the order in which the texts are met; objects without one
/// are left out. Stands for EleFront's Sort By Key; that the branches are `{path;0}`, `{path;1}` and so on is our reading, and one key
/// is supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd219",
    name = "Sort By Key",
    nick = "SortKey",
    at = "EleFront/02 Filter"
)]
#[output("Sorted Objects", "O", "A branch for each text.", kind = Generic)]
#[output("Values", "V1", "The text of each branch.", kind = Text)]
fn sort_by_key(
    context: &Context<'_>,
    /// The objects, or attributes.
    #[port("Attributes", "A", kind = Generic)]
    objects: &Tree,
    /// The key.
    #[port("Key 1", "[]K1", kind = Text)]
    key: &Tree,
) -> Result<(Tree, Tree), Message> {
    let Some(Value::Text(key)) = crate::model_objects::first(key) else {
        return Err(Message::error("There is no key"));
    };
    context.items(objects.item_count().saturating_mul(2))?;
    let (mut sorted, mut texts) = (Branches::default(), Branches::default());
    let mut left_out = 0_usize;
    for branch in objects.branches() {
        let mut known: Vec<Arc<str>> = Vec::new();
        for item in of(&branch) {
            context.check()?;
            let own = item.as_ref().and_then(|item| object_of(context, item));
            let Some(text) = own.and_then(|own| own.text_of(&key).cloned()) else {
                left_out += 1;
                continue;
            };
            let place = known.iter().position(|other| *other == text).unwrap_or(known.len());
            let path = branch.path().child(place);
            if place == known.len() {
                texts.push(path.clone(), Some(Value::Text(text.clone())));
                known.push(text);
            }
            sorted.push(path, item);
        }
    }
    if left_out > 0 {
        context.warn(format!("Objects without a text under {key} are left out: {left_out}"));
    }
    Ok((sorted.tree(), texts.tree()))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use katydid_3dm::{Attributes, Layer, Model, ModelObject as Archived, Object};
    use katydid_component::RhinoModel;
    use katydid_component::testing::{Trial, texts};
    use katydid_data::{Colour, ModelLayer, ModelObject, Value};
    use katydid_geometry::{Line, Point3};

    /// A point on House::Walls, red by itself; a line on House::Roof.
    fn objects() -> [Value; 2] {
        let mut wall = ModelObject::new(Point3::new(1.0, 0.0, 0.0).into());
        wall.name = "north".into();
        wall.layer = Some(Arc::new(ModelLayer::at("House::Walls")));
        wall.colour = Some(Colour::rgb(200, 0, 0));
        wall.set_text("use", "shop");
        let mut roof = ModelObject::new(Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)).into());
        roof.name = "south".into();
        let blue = ModelLayer { colour: Some(Colour::rgb(0, 0, 200)), ..ModelLayer::at("House::Roof") };
        roof.layer = Some(Arc::new(blue));
        roof.set_text("use", "flat");
        [wall.into(), roof.into()]
    }

    fn pattern<T: Into<Value>>(name: &str, wanted: T) -> Vec<String> {
        let out = Trial::of(name).list(objects()).item(wanted).run().outputs;
        let passed = texts(&out[1])[0].matches("True").count();
        assert_eq!(out[0].item_count(), passed, "{name}");
        texts(&out[1])
    }

    #[test]
    fn objects_are_filtered() {
        assert_eq!(pattern("Filter By Layer", "walls"), ["{0}: True, False"]);
        assert_eq!(pattern("Filter By Layer", "House::*"), ["{0}: True, True"]);
        assert_eq!(pattern("Filter By Name", "S?uth"), ["{0}: False, True"]);
        assert_eq!(pattern("Filter By Type", "curve"), ["{0}: False, True"]);
        assert_eq!(pattern("Filter By Color", Colour::rgb(200, 0, 0)), ["{0}: True, False"]);
        assert_eq!(pattern("Filter By Color", Colour::rgb(0, 0, 200)), ["{0}: False, True"]);
        let by = |key: &str, value: &str| {
            Trial::of("Filter By User Attributes").list(objects()).item(key).item(value).texts(1)
        };
        assert_eq!(by("use", "SHOP"), ["{0}: True, False"]);
        assert_eq!(by("use", "*"), ["{0}: True, True"]);
        assert_eq!(by("height", "*"), ["{0}: False, False"]);
        let uneven = Trial::of("Filter By User Attributes").list(objects()).list(["a", "b"]).item("c");
        assert_eq!(uneven.message(), "There are 2 keys and 1 values");
    }

    #[test]
    fn geometry_without_attributes_passes_by_type_only() {
        let point = || Trial::of("Filter By Type").item(Point3::ORIGIN).item("point").texts(1);
        assert_eq!(point(), ["{0}: True"]);
        assert_eq!(Trial::of("Filter By Name").item(Point3::ORIGIN).item("*").texts(1), ["{0}: False"]);
    }

    #[test]
    fn objects_are_sorted_by_a_text() {
        let [wall, roof] = objects();
        let items = [roof.clone(), wall, roof, Point3::ORIGIN.into()];
        let trial = || Trial::of("Sort By Key").list(items.clone()).item("use");
        assert_eq!(trial().texts(1), ["{0;0}: flat", "{0;1}: shop"]);
        let sorted = trial().run().outputs[0].clone();
        let counts: Vec<usize> = sorted.branches().map(|branch| branch.len()).collect();
        assert_eq!(counts, [2, 1]);
        assert_eq!(trial().message(), "Objects without a text under use are left out: 1");
        assert_eq!(Trial::of("Sort By Key").list(items.clone()).message(), "There is no key");
    }

    #[test]
    fn objects_of_the_model() {
        let layers = vec![Layer { colour: [0, 0, 200, 255], ..Layer::new("Roof") }];
        let mut model = Model { layers, ..Model::default() };
        let user_strings = vec![("use".to_owned(), "flat".to_owned())];
        let attributes = Attributes { layer: Some(0), user_strings, ..Attributes::default() };
        let point = Object::Point(Point3::ORIGIN);
        model.objects.push(Archived { attributes, ..Archived::from(point) });
        let count = |trial: Trial| trial.model(RhinoModel::new(model.clone())).run().outputs[0].item_count();
        assert_eq!(count(Trial::of("Reference by Color").item(Colour::rgb(0, 0, 200))), 1);
        assert_eq!(count(Trial::of("Reference by Color").item(Colour::rgb(0, 0, 0))), 0);
        assert_eq!(count(Trial::of("Reference by Type").item("Point")), 1);
        assert_eq!(count(Trial::of("Reference by Type").item("Mesh")), 0);
        assert_eq!(count(Trial::of("Reference by User Atributes").item("use").item("f*")), 1);
        assert_eq!(count(Trial::of("Reference by User Atributes").item("use").item("shop")), 0);
        assert!(Trial::of("Reference by Type").item("Mesh").message().starts_with("Needs the Rhino model"));
    }
}
