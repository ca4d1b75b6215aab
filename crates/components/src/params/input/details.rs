//! What is known of an object in a Rhino model.

use std::sync::Arc;

use katydid_component::component;
use katydid_data::{Colour, Geometry};
use uuid::Uuid;

/// What a Rhino model knows of an object.
///
/// Geometry here never stands in a model: it is available but not referenced, and has no name, layer, colour or id.
#[component(
    "c7b5c66a-6360-4f5f-aa17-a918d0b1c314",
    name = "Object Details",
    nick = "ObjDet",
    at = "Params/Input"
)]
#[output("Referenced", "R", "Whether the geometry is an object of a model: never.")]
#[output("Available", "A", "Whether the geometry is at hand: always.")]
#[output("Name", "N", "The name in the model.")]
#[output("Layer", "L", "The layer in the model.")]
#[output("Colour", "C", "The colour in the model.")]
#[output("Guid", "Id", "The id in the model.")]
fn object_details(
    /// The geometry.
    #[port("Object", "O")]
    _object: Geometry,
) -> (bool, bool, Option<Arc<str>>, Option<Arc<str>>, Option<Colour>, Option<Uuid>) {
    (false, true, None, None, None, None)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::Point3;

    #[test]
    fn nothing_is_referenced() {
        let out = Trial::of("Object Details").item(Point3::ORIGIN).run().outputs;
        let all: Vec<String> = out.iter().flat_map(texts).collect();
        assert_eq!(all, ["{0}: False", "{0}: True", "{0}: null", "{0}: null", "{0}: null", "{0}: null"]);
    }
}
