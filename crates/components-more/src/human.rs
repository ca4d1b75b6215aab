//! Human: previews with colours and line weights.

use katydid_component::component;
use katydid_data::{Colour, Geometry, Material};

/// What geometry is shown in where nothing is given; the plug-in's own colour is not known.
const GREY: Colour = Colour::rgb(150, 150, 150);

/// Shows geometry in a material, its lines in a width. Stands for Human's Custom Preview Lineweights.
#[component(
    "a77d0879-94c2-4101-be44-e4a616ffeb0c",
    name = "Custom Preview Lineweights",
    nick = "PreviewLW",
    at = "Human/Display"
)]
fn lineweights(
    /// The geometry.
    #[port("Geometry", "G")]
    _geometry: Geometry,
    /// The material; a colour is one too.
    #[port("Shader", "S", default = Material::from(GREY))]
    _shader: Material,
    /// The width of lines, in pixels.
    #[port("Thickness", "T", default = 1.0)]
    _thickness: f64,
    /// Whether the width is one in the model, which is not supported.
    #[port("Absolute", "A", default = false)]
    _absolute: bool,
) {
}

/// Shows geometry in a material, its lines in a width. Stands for an earlier Custom Preview Lineweights of Human.
#[component(
    "ff7300b2-a4c7-4651-8fa9-79a328f41e3c",
    name = "Custom Preview Lineweights",
    nick = "PreviewLW",
    at = "Human/Display",
    old
)]
fn lineweights_before(
    /// The geometry.
    #[port("Geometry", "G")]
    _geometry: Geometry,
    /// The material; a colour is one too.
    #[port("Shader", "S", default = Material::from(GREY))]
    _shader: Material,
    /// The width of lines, in pixels.
    #[port("Thickness", "T", default = 1.0)]
    _thickness: f64,
) {
}

/// Shows geometry in a colour. Stands for Human's Custom Preview Materials; bitmaps are not supported.
#[component(
    "e407f858-6c25-4550-a010-76cfa112e6bd",
    name = "Custom Preview Materials",
    nick = "PreviewMat",
    at = "Human/Display"
)]
fn materials(
    context: &katydid_component::Context<'_>,
    /// The geometry.
    #[port("Geometry", "G")]
    _geometry: Geometry,
    /// The colour.
    #[port("Diffuse Color", "DC", default = Material::from(GREY))]
    _colour: Material,
    /// How much light passes, from 0 to 1; not supported.
    #[port("Transparency", "T", optional)]
    _transparency: Option<f64>,
    /// A picture on the geometry; not supported.
    #[port("Diffuse Bitmap", "DB", optional)]
    picture: Option<std::sync::Arc<str>>,
    /// A picture of how much light passes; not supported.
    #[port("Transparency Bitmap", "TB", optional)]
    mask: Option<std::sync::Arc<str>>,
) {
    if picture.is_some() || mask.is_some() {
        context.tell(katydid_component::Message::remark(
            "Pictures on geometry are not supported: it has its colour only",
        ));
    }
}
