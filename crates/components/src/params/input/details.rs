//! What is known of an object in a Rhino model.

use std::sync::Arc;

use katydid_component::{Context, component};
use katydid_data::{Colour, Geometry};
use uuid::Uuid;

/// What the Rhino model knows of an object.
///
/// Geometry that comes out of the model untouched is an object of it, be it through a parameter that refers to it, through
/// Geometry Pipeline or through Query Model Objects. All other geometry is available but not referenced, and has no
/// name, layer, colour or id. The model is the file given to `katydid run` with `--model`.
#[component(
    "c7b5c66a-6360-4f5f-aa17-a918d0b1c314",
    name = "Object Details",
    nick = "ObjDet",
    at = "Params/Input"
)]
#[output("Referenced", "R", "Whether the geometry is an object of the model.")]
#[output("Available", "A", "Whether the geometry is at hand: always.")]
#[output("Name", "N", "The name in the model.")]
#[output("Layer", "L", "The layer in the model, from the outermost one in.")]
#[output("Colour", "C", "The colour in the model: its own, else its layer's.")]
#[output("Guid", "Id", "The id in the model.")]
fn object_details(
    context: &Context<'_>,
    /// The geometry.
    #[port("Object", "O")]
    object: Geometry,
) -> (bool, bool, Option<Arc<str>>, Option<Arc<str>>, Option<Colour>, Option<Uuid>) {
    let Some(found) = context.model().and_then(|model| model.object_of(&object.0)) else {
        return (false, true, None, None, None, None);
    };
    let [r, g, b, a] = found.colour;
    let name = (!found.name.is_empty()).then(|| Arc::from(found.name.as_str()));
    let layer = Arc::from(found.layer.as_str());
    (true, true, name, Some(layer), Some(Colour { a, r, g, b }), Some(found.id))
}

#[cfg(test)]
mod tests {
    use katydid_3dm::{Attributes, Layer, Model, ModelObject, Object};
    use katydid_component::RhinoModel;
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Line, Point3};
    use uuid::Uuid;

    #[test]
    fn what_is_not_in_the_model_is_not_referenced() {
        let out = Trial::of("Object Details").item(Point3::ORIGIN).run().outputs;
        let all: Vec<String> = out.iter().flat_map(texts).collect();
        assert_eq!(all, ["{0}: False", "{0}: True", "{0}: null", "{0}: null", "{0}: null", "{0}: null"]);
    }

    #[test]
    fn what_comes_out_of_the_model_is_known_by_it() {
        let layers = vec![Layer { colour: [9, 8, 7, 255], ..Layer::new("Walls") }];
        let mut model = Model { layers, ..Model::default() };
        let line = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
        let attributes = Attributes { id: Uuid::from_u128(7), name: "north".into(), ..Attributes::default() };
        model.objects.push(ModelObject { attributes, ..ModelObject::from(Object::Curve(line.into())) });
        let model = RhinoModel::new(model);
        let known = model.objects()[0].geometry.clone().unwrap();
        let same = Value::from(katydid_geometry::Curve::from(line));
        let out = Trial::of("Object Details").list([known, same]).model(model).run().outputs;
        let all: Vec<String> = out.iter().flat_map(texts).collect();
        assert_eq!(all[0], "{0}: True, False");
        assert_eq!(all[2..4], ["{0}: north, null", "{0}: Walls, null"]);
        assert!(all[4].contains("9,8,7") && all[5].contains("000000000007"), "{all:?}");
    }
}
