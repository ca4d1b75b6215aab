//! Previews with colours and line weights, and objects of other models.

use std::sync::Arc;

use katydid_component::{Context, Message, RhinoModel, component};
use katydid_data::{Colour, Geometry, Material, Value};

use crate::wildcard::takes;

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
    context: &Context<'_>,
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
    picture: Option<Arc<str>>,
    /// A picture of how much light passes; not supported.
    #[port("Transparency Bitmap", "TB", optional)]
    mask: Option<Arc<str>>,
) {
    if picture.is_some() || mask.is_some() {
        context.tell(Message::remark("Pictures on geometry are not supported: it has its colour only"));
    }
}

/// The objects of a .3dm file. Which files may be read is set where the definition runs. Stands for Human's Read 3dm File; that
/// the filter takes the path of a layer or its own name, and `*` for any text, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd301",
    name = "Read 3dm File",
    nick = "Read3dm",
    at = "Human/Reference"
)]
#[output("Objects", "O", "The geometry.")]
#[output("Layer Names", "L", "The path of the layer of each.")]
#[output("Attributes", "A", "Each object with its attributes.", kind = Content)]
#[output("Units", "U", "The unit of length of the file.")]
fn read_3dm_file(
    context: &Context<'_>,
    /// The path of the file.
    #[port("File Path", "FP")]
    path: Arc<str>,
    /// Only objects on layers of this name; all when there is none.
    #[port("Layer Filter", "L", optional)]
    filter: Option<Arc<str>>,
) -> Result<(Vec<Geometry>, Vec<Arc<str>>, Vec<Value>, Vec<Arc<str>>), Message> {
    let bytes = context.read_file(&path)?;
    let model =
        RhinoModel::read(&bytes).map_err(|why| Message::error(format!("{path} cannot be read: {why}")))?;
    context.items(model.objects().len().saturating_mul(3))?;
    let (mut shapes, mut layers, mut contents) = (Vec::new(), Vec::new(), Vec::new());
    let mut left_out = 0_usize;
    for object in model.objects() {
        let own = object.layer.rsplit("::").next().unwrap_or_default();
        let wanted = |filter: &Arc<str>| takes(filter, &object.layer) || takes(filter, own);
        if !filter.as_ref().is_none_or(wanted) {
            continue;
        }
        let Some(shape) = &object.geometry else {
            left_out += 1;
            continue;
        };
        shapes.push(Geometry(shape.clone()));
        layers.push(Arc::from(object.layer.as_str()));
        contents.push(object.content.clone());
    }
    if left_out > 0 {
        context.warn(format!("{left_out} objects are of types that are not supported"));
    }
    Ok((shapes, layers, contents, vec![Arc::from(model.units.name())]))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    #[test]
    fn files_that_may_not_be_read_are_refused() {
        assert!(Trial::of("Read 3dm File").item("model.3dm").message().contains("cannot be read"));
    }
}
