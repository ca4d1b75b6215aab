//! Rhino / Object: objects with their attributes.

use std::sync::Arc;

use katydid_component::{Context, Message, component};
use katydid_data::{Colour, Geometry, Kind, Value, Visibility, cast};

use super::{layer_of, object_of};

/// Takes a model object apart, and puts other attributes in the place of its own.
///
/// An input without data leaves what the object has. Geometry is taken for an object without attributes; geometry that
/// comes out of the model untouched is the object it is of. Visibility is one of the words Normal, Hidden and Locked,
/// or 0, 1 and 2 for them; Display is the object's own colour, and null where it has its layer's. Drafting and
/// render attributes are not supported: what Grasshopper puts into them is not known.
#[component(
    "d7071c97-bc7f-4966-beba-b7110064eebf",
    name = "Model Object",
    nick = "Object",
    at = "Rhino/Object"
)]
#[output("Object", "O", "The object.", kind = Content)]
#[output("Geometry", "G", "Its geometry.")]
#[output("Name", "N", "Its name.")]
#[output("Layer", "L", "Its layer.", kind = Content)]
#[output("Visibility", "V", "Normal, Hidden or Locked.", kind = Text)]
#[output("Display", "Ds", "Its own colour.")]
#[output("Drafting", "Dr", "Not supported: null.", kind = Generic)]
#[output("Render", "R", "Not supported: null.", kind = Generic)]
#[allow(clippy::too_many_arguments, reason = "an argument is a port")]
fn model_object(
    context: &Context<'_>,
    /// The object, or geometry.
    #[port("Object", "O")]
    object: Value,
    /// Its geometry from now on.
    #[port("Geometry", "G", optional)]
    geometry: Option<Geometry>,
    /// Its name from now on.
    #[port("Name", "N", optional)]
    name: Option<Arc<str>>,
    /// Its layer from now on, or the path of one (`Outer::Inner`).
    #[port("Layer", "L", optional)]
    layer: Option<Value>,
    /// How it takes part in the model from now on.
    #[port("Visibility", "V", optional)]
    visibility: Option<Value>,
    /// Its colour from now on.
    #[port("Display", "Ds", optional)]
    display: Option<Value>,
    /// Not supported.
    #[port("Drafting", "Dr", optional)]
    drafting: Option<Value>,
    /// Not supported.
    #[port("Render", "R", optional)]
    render: Option<Value>,
) -> Result<
    (
        Value,
        Option<Geometry>,
        Option<Arc<str>>,
        Option<Value>,
        Arc<str>,
        Option<Colour>,
        Option<Value>,
        Option<Value>,
    ),
    Message,
> {
    let mut object = object_of(context, &object)?;
    if let Some(Geometry(geometry)) = geometry {
        object.geometry = Some(geometry);
    }
    if let Some(name) = name {
        object.name = name;
    }
    if let Some(layer) = layer {
        object.layer = Some(layer_of(context, &layer)?);
    }
    if let Some(visibility) = visibility {
        object.visibility = visibility_of(context, &visibility)?;
    }
    if let Some(display) = display {
        object.colour = Some(colour_of(context, &display)?);
    }
    if drafting.is_some() || render.is_some() {
        context.warn("Not supported: drafting and render attributes are left out");
    }
    let parts = (
        object.geometry.clone().map(Geometry),
        Some(object.name.clone()).filter(|name| !name.is_empty()),
        object.layer.clone().map(Value::from),
        Arc::from(object.visibility.name()),
        object.colour,
    );
    let (geometry, name, layer, visibility, colour) = parts;
    Ok((Value::from(object), geometry, name, layer, visibility, colour, None, None))
}

fn visibility_of(context: &Context<'_>, value: &Value) -> Result<Visibility, Message> {
    let found = match value {
        Value::Text(word) => {
            Visibility::ALL.into_iter().find(|known| known.name().eq_ignore_ascii_case(word.trim()))
        }
        _ => match cast::value(value, Kind::Integer, context.rules()) {
            Some(Value::Integer(number)) => {
                usize::try_from(number).ok().and_then(|number| Visibility::ALL.get(number).copied())
            }
            _ => None,
        },
    };
    found.ok_or_else(|| Message::error("Visibility is one of Normal, Hidden and Locked, or 0, 1 and 2"))
}

fn colour_of(context: &Context<'_>, value: &Value) -> Result<Colour, Message> {
    match cast::value(value, Kind::Colour, context.rules()) {
        Some(Value::Colour(colour)) => Ok(colour),
        _ => Err(Message::error("Display takes a colour; display modes and the like are not supported")),
    }
}

#[cfg(test)]
mod tests {
    use katydid_3dm::{Attributes, Layer, Model, ModelObject, Object};
    use katydid_component::RhinoModel;
    use katydid_component::testing::{Trial, texts};
    use katydid_data::{Colour, Value};
    use katydid_geometry::{Line, Point3};
    use uuid::Uuid;

    fn model() -> RhinoModel {
        let layers = vec![Layer::new("Walls"), Layer::new("Roof")];
        let mut model = Model { layers, ..Model::default() };
        let attributes = Attributes {
            id: Uuid::from_u128(7),
            name: "north".into(),
            layer: Some(0),
            colour: Some([1, 2, 3, 255]),
            ..Attributes::default()
        };
        let line = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
        model.objects.push(ModelObject { attributes, ..ModelObject::from(Object::Curve(line.into())) });
        RhinoModel::new(model)
    }

    #[test]
    fn an_object_of_the_model_is_taken_apart() {
        let out = Trial::of("Model Object").item(model().objects()[0].content.clone()).run().outputs;
        let all: Vec<String> = out.iter().flat_map(texts).collect();
        let wanted = ["north", "Line-like Curve", "north", "Walls", "Normal", "1,2,3", "null", "null"];
        assert_eq!(all, wanted.map(|text| format!("{{0}}: {text}")));
        // Its geometry, untouched, leads to the attributes too.
        let known = model();
        let line = known.objects()[0].geometry.clone().unwrap();
        assert_eq!(Trial::of("Model Object").item(line).model(known).texts(3), ["{0}: Walls"]);
    }

    #[test]
    fn attributes_are_put_in_the_place_of_others() {
        let trial = |layer: &str| {
            Trial::of("Model Object")
                .item(Point3::ORIGIN)
                .item(Point3::new(1.0, 0.0, 0.0))
                .item("south")
                .item(layer)
                .item("locked")
                .item(Colour::rgb(9, 8, 7))
                .model(model())
        };
        let out = trial("roof").run().outputs;
        let all: Vec<String> = out.iter().flat_map(texts).collect();
        let wanted = ["south", "{1, 0, 0}", "south", "Roof", "Locked", "9,8,7", "null", "null"];
        assert_eq!(all, wanted.map(|text| format!("{{0}}: {text}")));
        assert_eq!(trial("A::B").texts(3), ["{0}: A::B"]);
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        assert_eq!(Trial::of("Model Object").item(1.5).message(), "A Number is no model object");
        let hidden = |value: Value| {
            let trial = Trial::of("Model Object").item(Point3::ORIGIN).default().default().default();
            trial.item(value)
        };
        assert_eq!(hidden(1.into()).texts(4), ["{0}: Hidden"]);
        assert!(hidden("seen".into()).message().starts_with("Visibility is one of"));
        assert!(hidden(9.into()).message().starts_with("Visibility is one of"));
    }
}
