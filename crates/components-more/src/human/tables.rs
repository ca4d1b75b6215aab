//! Tables and objects of the Rhino model.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::{Colour, Material, Path, Tree, TreeBuilder, Value};

use crate::elefront::{model, objects};
use crate::model_objects::is_true;
use crate::wildcard::takes;

/// The layers of the Rhino model. The model is the file given with `--model`. Stands for Human's Layer Table; linetypes, materials and
/// what is for print are not supported: they are null.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd331",
    name = "Layer Table",
    nick = "LayerTable",
    at = "Human/Document Info"
)]
#[output("Layers", "L", "The own name of each layer.")]
#[output("Full Layer Paths", "LF", "Its path (`Outer::Inner`).")]
#[output("Layer Colors", "C", "Its colour.")]
#[output("Linetypes", "LT", "Null; not supported.")]
#[output("Material Names", "M", "Null; not supported.")]
#[output("Visible", "V", "Whether it is seen.")]
#[output("Print Width", "PW", "Null; not supported.")]
#[output("Print Color", "PC", "Null; not supported.")]
fn layer_table(
    context: &Context<'_>,
    /// Whether to read the layers.
    #[port("Update", "U", default = true)]
    update: bool,
    /// Not used: the model does not change while a definition runs.
    #[port("Auto-Update", "AU", default = false)]
    _auto: bool,
) -> Result<
    (
        Vec<Shared<str>>,
        Vec<Shared<str>>,
        Vec<Option<Colour>>,
        Vec<Option<Shared<str>>>,
        Vec<Option<Shared<str>>>,
        Vec<bool>,
        Vec<Option<f64>>,
        Vec<Option<Colour>>,
    ),
    Message,
> {
    let layers = if update { model(context)?.layers() } else { &[] };
    context.items(layers.len().saturating_mul(8))?;
    let count = layers.len();
    Ok((
        layers.iter().map(|layer| layer.name().into()).collect(),
        layers.iter().map(|layer| layer.path.clone()).collect(),
        layers.iter().map(|layer| layer.colour).collect(),
        vec![None; count],
        vec![None; count],
        layers.iter().map(|layer| !layer.hidden).collect(),
        vec![None; count],
        vec![None; count],
    ))
}

/// The materials of the Rhino model. The model is the file given with `--model`. Stands for Human's Material Table.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd332",
    name = "Material Table",
    nick = "MatTable",
    at = "Human/Document Info"
)]
#[output("Material Name", "MN", "The name of each material.")]
#[output("Shader", "S", "How it looks.")]
#[output("Diffuse", "Kd", "The colour of the lit surface.")]
#[output("Specular", "Ks", "The colour of its highlights.")]
#[output("Emission", "Ke", "The colour it gives off without light.")]
#[output("Alpha", "A", "1 is opaque, 0 cannot be seen.")]
#[output("Gloss", "G", "0 is dull, 1 is polished.")]
fn material_table(
    context: &Context<'_>,
    /// Whether to read the materials.
    #[port("update", "U", default = true)]
    update: bool,
) -> Result<
    (
        Vec<Shared<str>>,
        Vec<Option<Material>>,
        Vec<Option<Colour>>,
        Vec<Option<Colour>>,
        Vec<Option<Colour>>,
        Vec<Option<f64>>,
        Vec<Option<f64>>,
    ),
    Message,
> {
    let materials = if update { model(context)?.materials() } else { &[] };
    context.items(materials.len().saturating_mul(7))?;
    let looks: Vec<Option<Material>> = materials.iter().map(|material| material.look).collect();
    let colours = |part: fn(&Material) -> Colour| looks.iter().map(|look| look.as_ref().map(part)).collect();
    let numbers = |part: fn(&Material) -> f64| looks.iter().map(|look| look.as_ref().map(part)).collect();
    Ok((
        materials.iter().map(|material| material.name.clone()).collect(),
        looks.clone(),
        colours(|look| look.diffuse),
        colours(|look| look.specular),
        colours(|look| look.emission),
        numbers(|look| 1.0 - look.transparency),
        numbers(|look| look.shine),
    ))
}

/// The linetypes of the Rhino model. The model is the file given with `--model`. Stands for Human's Linetype Table; that gaps are
/// negative is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd334",
    name = "Linetype Table",
    nick = "LT Table",
    at = "Human/Document Info"
)]
#[output("Linetypes", "LT", "The name of each linetype.", kind = Text)]
#[output(
    "Linetype Pattern",
    "pat",
    "A branch for each: its dashes, and its gaps as negative numbers, in millimetres; none where the line is continuous.",
    kind = Number
)]
fn linetype_table(
    context: &Context<'_>,
    /// Whether to read the linetypes.
    #[port("Update", "U", kind = Boolean, default = true)]
    update: &Tree,
) -> Result<(Tree, Tree), Message> {
    let linetypes = if is_true(Some(update)) { model(context)?.linetypes() } else { &[] };
    context.items(linetypes.iter().map(|linetype| linetype.segments.len() + 1).sum())?;
    let mut patterns = TreeBuilder::<f64>::new();
    for (path, linetype) in (0..).zip(linetypes) {
        patterns.branch(Path::from([path]));
        linetype.segments.iter().for_each(|length| patterns.push(Some(*length)));
    }
    let names = linetypes.iter().map(|linetype| linetype.name.clone()).collect();
    Ok((Tree::list::<Shared<str>>(names), patterns.finish()))
}

/// The objects of the Rhino model on a layer and of a name. `*` stands for any text, `?` for one character; capitals do not matter,
/// and a layer is told by its path or its own name, which is our reading. The model is the file given with `--model`. Stands for
/// Human's Dynamic Geometry Pipeline; the types chosen in its menu are not supported.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd333",
    name = "Dynamic Geometry Pipeline",
    nick = "DPipeline",
    at = "Human/Reference"
)]
#[output("Geometry Out", "G", "The objects.", kind = Content)]
fn dynamic_pipeline(
    context: &Context<'_>,
    /// The layer.
    #[port("Layer Filter", "lay", default = "*")]
    layer: Shared<str>,
    /// The name.
    #[port("Name Filter", "name", default = "*")]
    name: Shared<str>,
) -> Result<Vec<Value>, Message> {
    objects(context, |object| {
        let on_layer = match object.layer.as_deref() {
            Some(known) => takes(&layer, &known.path) || takes(&layer, known.name()),
            None => takes(&layer, ""),
        };
        on_layer && takes(&name, &object.name)
    })
}

#[cfg(test)]
mod tests {
    use katydid_3dm::{Attributes, Layer, Linetype, Material, Model, ModelObject, Object};
    use katydid_component::RhinoModel;
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::Point3;

    fn model() -> RhinoModel {
        let walls = Layer { colour: [10, 20, 30, 255], ..Layer::new("Walls") };
        let layers = vec![walls, Layer { visible: false, ..Layer::new("Roof") }];
        let paint = Material { transparency: 0.25, ..Material::new("Paint", [200, 30, 30, 255]) };
        let linetypes = vec![Linetype::new("Straight", &[]), Linetype::new("Dashed", &[4.0, 2.0])];
        let mut model = Model { layers, linetypes, materials: vec![paint], ..Model::default() };
        for (x, name, layer) in [(1.0, "north", 0), (2.0, "south", 0), (3.0, "north", 1)] {
            let attributes = Attributes { name: name.into(), layer: Some(layer), ..Attributes::default() };
            let point = Object::Point(Point3::new(x, 0.0, 0.0));
            model.objects.push(ModelObject { attributes, ..ModelObject::from(point) });
        }
        RhinoModel::new(model)
    }

    #[test]
    fn layers_of_the_model() {
        let out = Trial::of("Layer Table").model(model()).run().outputs;
        assert_eq!(texts(&out[0]), ["{0;0}: Walls, Roof"]);
        assert_eq!(texts(&out[1]), ["{0;0}: Walls, Roof"]);
        assert_eq!(texts(&out[2])[0].split(", ").next(), Some("{0;0}: 10,20,30"));
        assert_eq!(texts(&out[3]), ["{0;0}: null, null"]);
        assert_eq!(texts(&out[5]), ["{0;0}: True, False"]);
        assert_eq!(Trial::of("Layer Table").item(false).run().outputs[0].item_count(), 0);
    }

    #[test]
    fn materials_of_the_model() {
        let out = Trial::of("Material Table").model(model()).run().outputs;
        assert_eq!(texts(&out[0]), ["{0;0}: Paint"]);
        assert_eq!(texts(&out[2]), ["{0;0}: 200,30,30"]);
        assert_eq!(texts(&out[5]), ["{0;0}: 0.75"]);
    }

    #[test]
    fn linetypes_of_the_model() {
        let out = Trial::of("Linetype Table").model(model()).run().outputs;
        assert_eq!(texts(&out[0]), ["{0}: Straight, Dashed"]);
        assert_eq!(texts(&out[1]), ["{0}:", "{1}: 4, -2"]);
        assert_eq!(Trial::of("Linetype Table").item(false).run().outputs[0].item_count(), 0);
    }

    #[test]
    fn objects_by_layer_and_name() {
        let count = |layer: &str, name: &str| {
            let found = Trial::of("Dynamic Geometry Pipeline").item(layer).item(name).model(model());
            found.run().outputs[0].item_count()
        };
        assert_eq!(count("*", "*"), 3);
        assert_eq!(count("walls", "*"), 2);
        assert_eq!(count("*", "north"), 2);
        assert_eq!(count("Roof", "n?rth"), 1);
        assert_eq!(count("Roof", "south"), 0);
    }

    #[test]
    fn without_a_model() {
        for name in ["Layer Table", "Material Table", "Linetype Table", "Dynamic Geometry Pipeline"] {
            assert!(Trial::of(name).message().starts_with("Needs the Rhino model"), "{name}");
        }
    }
}
