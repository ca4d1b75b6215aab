//! Display / Dimensions: texts in space.

use std::sync::Arc;

use katydid_component::component;
use katydid_data::Colour;
use katydid_geometry::{Plane, Point3};

/// Writes texts at points, facing the viewer.
#[component(
    "3b220754-4114-4170-b6c3-b286b86ed524",
    name = "Text Tag",
    nick = "Tag",
    at = "Display/Dimensions",
    also("4b3d38d3-0620-42e5-9ae8-0d4d9ad914cd")
)]
fn text_tag(
    /// Where the text stands.
    #[port("Location", "L")]
    _location: Point3,
    /// The text.
    #[port("Text", "T")]
    _text: Arc<str>,
    /// The colour of the text.
    #[port("Colour", "C")]
    _colour: Option<Colour>,
) {
}

/// Writes texts on planes, at a size in units of the model.
#[component(
    "5a41528b-12b9-40dc-a3f2-842034d267c4",
    name = "Text Tag 3D",
    nick = "Tag",
    at = "Display/Dimensions",
    also("18564c36-5652-4c63-bb6f-f0e1273666dd", "ebf4d987-09b9-4825-a735-cac3d4770c19")
)]
fn text_tag_3d(
    /// The plane to write on.
    #[port("Location", "L")]
    _location: Plane,
    /// The text.
    #[port("Text", "T")]
    _text: Option<Arc<str>>,
    /// The height of a letter.
    #[port("Size", "S", default = 1.0)]
    _size: f64,
    /// The colour of the text.
    #[port("Colour", "C")]
    _colour: Option<Colour>,
    /// Which part of the text stands at the plane's origin.
    #[port("Justification", "J", default = 7)]
    _justification: i32,
) {
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::Point3;

    #[test]
    fn tags_give_no_data() {
        for name in ["Text Tag", "Text Tag 3D"] {
            let out = Trial::of(name).item(Point3::ORIGIN).list([1.5, 2.0]).run();
            assert!(out.outputs.is_empty() && out.messages.is_empty(), "{name}");
        }
    }
}
