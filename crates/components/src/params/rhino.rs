//! The pipeline that looks into the Rhino model beside the definition.

use std::collections::HashMap;

use katydid_component::{Context, Message, RhinoObject, component};
use katydid_data::{Path, Tree, TreeBuilder, Value};

use super::wildcard::Wildcard;
use crate::rhino::model;

/// The geometry of the objects, and one warning for all whose class no value holds.
fn geometry<'a>(
    context: &Context<'_>,
    objects: impl Iterator<Item = &'a RhinoObject>,
) -> Result<Vec<(&'a RhinoObject, Value)>, Message> {
    let mut unknown: HashMap<&str, usize> = HashMap::new();
    let mut found = Vec::new();
    for object in objects {
        match &object.geometry {
            Some(value) => found.push((object, value.clone())),
            None => *unknown.entry(object.class.as_str()).or_default() += 1,
        }
    }
    if !unknown.is_empty() {
        let mut kinds: Vec<String> =
            unknown.iter().map(|(class, count)| format!("{count} × {class}")).collect();
        kinds.sort();
        context.warn(format!("Objects of kinds that cannot be used yet are left out: {}", kinds.join(", ")));
    }
    context.items(found.len())?;
    Ok(found)
}

/// Which objects a pipeline lets through.
struct Filter {
    layers: Wildcard,
    names: Wildcard,
    types: u32,
    hidden: bool,
    locked: bool,
}

impl Filter {
    /// As the object has it stored; what is not stored lets everything through.
    fn stored(context: &Context<'_>) -> Result<Self, Message> {
        let settings = context.settings();
        let flag = |name| settings.bool(name).unwrap_or(true);
        let layers = settings.str("LayerFilter").unwrap_or("*");
        Ok(Self {
            layers: if flag("SublayerFiltering") {
                Wildcard::with_sublayers(layers)?
            } else {
                Wildcard::new(layers)?
            },
            names: Wildcard::new(settings.str("NameFilter").unwrap_or("*"))?,
            types: settings.i32("TypeFilter").map_or(u32::MAX, i32::cast_unsigned),
            hidden: flag("IncludeHidden"),
            locked: flag("IncludeLocked"),
        })
    }

    fn takes(&self, object: &RhinoObject) -> bool {
        object.type_flag & self.types != 0
            && (self.hidden || !object.is_hidden)
            && (self.locked || !object.is_locked)
            && self.layers.takes_layer(&object.layer)
            && self.names.takes(&object.name)
    }
}

/// All objects of the Rhino model that its filters let through: by layer, by name, by type, hidden and locked ones or
/// not.
///
/// `*` in a filter stands for any text, `?` for one character; layers inside a layer that is named count as well where
/// the pipeline says so. Grouped by layer there is a branch for each layer, grouped by type one for each type, by both
/// one for each pair. The model is the file given to `katydid run` with `--model`.
#[component(
    "b341e2e5-c4b3-49a3-b3a4-b4e6e2054516",
    name = "Geometry Pipeline",
    nick = "Pipeline",
    at = "Params/Geometry",
    floating
)]
#[output("Geometry", "G", "The geometry of the objects, in the order of the model.", kind = Geometry)]
fn geometry_pipeline(
    context: &Context<'_>,
    /// Not used: the objects come from the model.
    #[port("Geometry", "G", optional, kind = Geometry)]
    _data: &Tree,
) -> Result<Tree, Message> {
    let filter = Filter::stored(context)?;
    let objects = model(context)?.objects().iter().filter(|object| filter.takes(object));
    let mut found = geometry(context, objects)?;
    let flag = |name| context.settings().bool(name).unwrap_or(false);
    let (by_layer, by_type) = (flag("GroupByLayer"), flag("GroupByType"));
    let key = |object: &RhinoObject| {
        (if by_layer { object.layer_index } else { 0 }, if by_type { object.type_flag } else { 0 })
    };
    found.sort_by_key(|(object, _)| key(object));
    let mut builder = TreeBuilder::<Value>::new();
    for (place, same) in found.chunk_by(|(a, _), (b, _)| key(a) == key(b)).enumerate() {
        builder.branch(Path::from([i32::try_from(place).unwrap_or(i32::MAX)].as_slice()));
        for (_, value) in same {
            builder.push(Some(value.clone()));
        }
    }
    Ok(builder.finish())
}

#[cfg(test)]
mod tests {
    use katydid_3dm::{Attributes, Layer, Model, ModelObject, Object, ObjectMode};
    use katydid_component::{RhinoModel, testing::Trial};
    use katydid_definition::archive::ItemValue;
    use katydid_geometry::{Line, Point3};
    use uuid::Uuid;

    /// Points on two layers, one inside the other, and a locked line.
    fn model() -> RhinoModel {
        let outer = Layer { id: Uuid::from_u128(1), ..Layer::new("House") };
        let inner = Layer { id: Uuid::from_u128(2), parent: Some(outer.id), ..Layer::new("Walls") };
        let mut model = Model { layers: vec![outer, inner], ..Model::default() };
        let mut add = |geometry: Object, layer, name: &str, mode| {
            let attributes =
                Attributes { layer: Some(layer), name: name.to_owned(), mode, ..Attributes::default() };
            model.objects.push(ModelObject { attributes, ..ModelObject::from(geometry) });
        };
        let point = |x| Point3::new(x, 0.0, 0.0);
        add(Object::Point(point(1.0)), 0, "north", ObjectMode::Normal);
        add(Object::Point(point(2.0)), 1, "north", ObjectMode::Hidden);
        add(Object::Curve(Line::new(point(0.0), point(5.0)).into()), 1, "south", ObjectMode::Locked);
        add(Object::Point(point(9.0)), 0, "north", ObjectMode::InDefinition);
        RhinoModel::new(model)
    }

    #[test]
    fn a_pipeline_lets_through_what_its_filters_say() {
        let pipeline = || Trial::of("Geometry Pipeline").model(model());
        let text =
            |name: &str, value: &str| pipeline().setting(name, ItemValue::String(value.into())).texts(0);
        assert_eq!(pipeline().texts(0), ["{0}: {1, 0, 0}, {2, 0, 0}, Line-like Curve"]);
        let points = pipeline().setting("TypeFilter", ItemValue::Int32(1));
        assert_eq!(points.texts(0), ["{0}: {1, 0, 0}, {2, 0, 0}"]);
        assert_eq!(text("NameFilter", "s*"), ["{0}: Line-like Curve"]);
        assert_eq!(text("LayerFilter", "walls"), ["{0}: {2, 0, 0}, Line-like Curve"]);
        assert_eq!(text("LayerFilter", "House"), ["{0}: {1, 0, 0}, {2, 0, 0}, Line-like Curve"]);
        let shown = pipeline().setting("IncludeHidden", ItemValue::Bool(false));
        assert_eq!(shown.texts(0), ["{0}: {1, 0, 0}, Line-like Curve"]);
        let grouped = pipeline().setting("GroupByLayer", ItemValue::Bool(true));
        assert_eq!(grouped.texts(0), ["{0}: {1, 0, 0}", "{1}: {2, 0, 0}, Line-like Curve"]);
    }

    #[test]
    fn without_a_model_it_says_so() {
        assert!(Trial::of("Geometry Pipeline").message().starts_with("Needs the Rhino model"));
    }
}
