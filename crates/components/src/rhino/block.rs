//! Rhino / Block: blocks, and what they place.

use std::path::Path;
use std::sync::Arc;

use katydid_component::{Context, Message, RhinoModel, component};
use katydid_data::{BlockDefinition, BlockInstance, Content, ModelObject, Value};
use katydid_geometry::Xform;

use super::{content_of, unfit};

/// A value as a block placed in space.
fn instance_of(context: &Context<'_>, value: &Value) -> Result<BlockInstance, Message> {
    let content = content_of(context, value);
    match content.as_deref() {
        Some(Content::Instance(instance)) => Ok(instance.clone()),
        Some(Content::Object(ModelObject { geometry: Some(Value::Content(inner)), .. })) => match &**inner {
            Content::Instance(instance) => Ok(instance.clone()),
            _ => Err(unfit(value, "block instance")),
        },
        _ => Err(unfit(value, "block instance")),
    }
}

/// A value as a block: one, or the name of one in the model.
fn block_of(context: &Context<'_>, value: &Value) -> Result<Arc<BlockDefinition>, Message> {
    match value {
        Value::Text(name) => {
            let known = context.model().and_then(|model| model.block(name)).cloned();
            known.ok_or_else(|| Message::error(format!("No block is called {name}")))
        }
        Value::Content(content) => match &**content {
            Content::Block(block) => Ok(block.clone()),
            _ => Err(unfit(value, "block definition")),
        },
        _ => Err(unfit(value, "block definition")),
    }
}

/// The objects that a block instance shows, where it shows them, with their attributes.
///
/// Blocks inside the block stay block instances, to be exploded in turn. Objects that cannot be moved yet, such as
/// breps, are left out, unless the instance stands where the block was made.
#[component(
    "f0574152-cab4-49e4-8b48-f02326970625",
    name = "Explode Block Instance",
    nick = "Explode Block Instance",
    at = "Rhino/Block"
)]
#[output("Objects", "Objects", "The objects, in the order of the block.", kind = Content)]
fn explode_block_instance(
    context: &Context<'_>,
    /// The block instance.
    #[port("Block Instance", "Block Instance", optional)]
    instance: Option<Value>,
) -> Result<Vec<Value>, Message> {
    let Some(instance) = instance else { return Ok(Vec::new()) };
    let instance = instance_of(context, &instance)?;
    let objects = instance.definition.objects();
    context.items(objects.len())?;
    let mut placed = Vec::with_capacity(objects.len());
    for object in objects {
        let Some(geometry) = &object.geometry else { continue };
        let stays = instance.transform == Xform::IDENTITY;
        let geometry = if stays { Ok(geometry.clone()) } else { geometry.transformed(&instance.transform) };
        match geometry {
            // A copy is an object of its own.
            Ok(geometry) => {
                placed.push(Value::from(ModelObject {
                    id: None,
                    geometry: Some(geometry),
                    ..object.clone()
                }));
            }
            Err(error) => context.warn(format!("Left out: {error}")),
        }
    }
    Ok(placed)
}

/// Takes a block instance apart, and places another block, or the same one elsewhere.
///
/// An input without data leaves what the instance has. Without an instance a new one is made of the block, where the
/// block itself was made.
#[component(
    "6354d626-df14-488d-885d-ed51b2efe97f",
    name = "Model Block Instance",
    nick = "Model Block Instance",
    at = "Rhino/Block"
)]
#[output("Block Instance", "Block Instance", "The block instance.", kind = Content)]
#[output("Block Definition", "Block Definition", "The block.", kind = Content)]
#[output("Transform", "Transform", "From the block to where it is placed.")]
fn model_block_instance(
    context: &Context<'_>,
    /// The block instance.
    #[port("Block Instance", "Block Instance", optional)]
    instance: Option<Value>,
    /// The block from now on, or the name of one in the model.
    #[port("Block Definition", "Block Definition", optional)]
    definition: Option<Value>,
    /// Where it is placed from now on.
    #[port("Transform", "Transform", optional)]
    transform: Option<Xform>,
) -> Result<(Option<Value>, Option<Value>, Option<Xform>), Message> {
    let block = definition.map(|definition| block_of(context, &definition)).transpose()?;
    let mut placed = match (instance, block) {
        (Some(instance), block) => {
            let mut placed = instance_of(context, &instance)?;
            if let Some(block) = block {
                placed.definition = block;
            }
            placed
        }
        (None, Some(definition)) => BlockInstance { definition, transform: Xform::IDENTITY },
        (None, None) => return Ok((None, None, None)),
    };
    if let Some(transform) = transform {
        placed.transform = transform;
    }
    let (definition, transform) = (placed.definition.clone(), placed.transform);
    Ok((Some(Value::from(placed)), Some(Value::from(definition)), Some(transform)))
}

/// Reads a Rhino model (.3dm) as one block of all its objects, in the units of that model, from its origin.
///
/// The block is always a copy of the file, whatever the update type says: there is no document that would be told of
/// changes to the file. Blocks in the file stay blocks in the block.
#[component(
    "c4e64c79-9e77-410c-96f5-877928c65850",
    name = "Import Model Block Definition",
    nick = "Import Model Block Definition",
    at = "Rhino/Block"
)]
#[output("Block Definition", "Block Definition", "The block.", kind = Content)]
fn import_model_block_definition(
    context: &Context<'_>,
    /// The path of the model; one that is not absolute starts where the definition lies.
    #[port("File Path", "File Path")]
    file: Arc<str>,
    /// Not used: how a document follows changes to the file.
    #[port("Update Type", "Update Type", default = 0)]
    _update: i32,
    /// The name; without one that of the file.
    #[port("Name", "Name", optional)]
    name: Option<Arc<str>>,
    /// What it is.
    #[port("Description", "Description", optional)]
    description: Option<Arc<str>>,
    /// A web address.
    #[port("URL", "URL", optional)]
    url: Option<Arc<str>>,
    /// What the web address is called.
    #[port("URL Description", "URL Description", optional)]
    url_description: Option<Arc<str>>,
) -> Result<Value, Message> {
    let bytes = context.read_file(&file)?;
    let model = RhinoModel::read(&bytes)
        .map_err(|error| Message::error(format!("{file} cannot be read: {error}")))?;
    let object = |object: &katydid_component::RhinoObject| match &object.content {
        Value::Content(content) => match &**content {
            Content::Object(object) => Some(object.clone()),
            _ => None,
        },
        _ => None,
    };
    let objects: Vec<ModelObject> = model.objects().iter().filter_map(object).collect();
    context.items(objects.len())?;
    let stem = Path::new(&*file).file_stem().map(|stem| stem.to_string_lossy());
    let name = name.unwrap_or_else(|| stem.unwrap_or_default().into());
    let mut block = BlockDefinition::new(name, objects);
    block.description = description.unwrap_or_default();
    block.url = url.unwrap_or_default();
    block.url_description = url_description.unwrap_or_default();
    Ok(Value::from(block))
}

#[cfg(test)]
mod tests {
    use katydid_3dm::{Attributes, BlockReference, Layer, Model, ModelObject, Object};
    use katydid_component::{Files, RhinoModel, testing::Trial};
    use katydid_data::Value;
    use katydid_geometry::{Line, Point3, Vector3, Xform};
    use uuid::Uuid;

    /// A chair of a line and a point, placed twice; a row of two chairs as a block, placed once, turned over.
    fn model() -> Model {
        let mut model = Model { layers: vec![Layer::new("Wood")], ..Model::default() };
        let along = |x| Xform::translation(Vector3::new(x, 0.0, 0.0));
        let line = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 2.0));
        let attributes = Attributes { name: "leg".into(), layer: Some(0), ..Attributes::default() };
        let leg = ModelObject { attributes, ..ModelObject::from(Object::Curve(line.into())) };
        let knob = ModelObject::from(Object::Point(Point3::new(0.0, 1.0, 0.0)));
        let chair = model.add_block("Chair", vec![leg, knob]);
        let row = model.add_block("Row", vec![reference(chair, along(0.0)), reference(chair, along(5.0))]);
        model.objects.push(reference(chair, along(1.0)));
        model.objects.push(reference(row, Xform::scale(Point3::ORIGIN, 2.0)));
        model
    }

    fn reference(block: Uuid, by: Xform) -> ModelObject {
        ModelObject::from(Object::BlockReference(Box::new(BlockReference::new(block, by))))
    }

    #[test]
    fn an_instance_explodes_into_its_objects() {
        let model = RhinoModel::new(model());
        assert_eq!((model.objects().len(), model.blocks().len()), (2, 2));
        let explode = |value: Value| Trial::of("Explode Block Instance").item(value).run().outputs;
        let chair = explode(model.objects()[0].content.clone());
        let chair = chair[0].clone();
        let geometry = Trial::of("Geometry").tree(chair.clone());
        assert_eq!(geometry.texts(0), ["{0;0}: Line-like Curve, {1, 1, 0}"]);
        let line =
            Trial::of("End Points").tree(Trial::of("Curve").tree(chair.clone()).run().outputs[0].clone());
        assert_eq!(line.texts(1), ["{0;0}: {1, 0, 2}, null"]);
        // The attributes come along.
        assert_eq!(Trial::of("Model Object").tree(chair).texts(3), ["{0;0}: Wood, Wood"]);
        // Of the row the chairs come out as blocks, where they stand.
        let row = explode(model.objects()[1].content.clone());
        assert_eq!(katydid_component::testing::texts(&row[0]).len(), 1);
        let second = Trial::of("Explode Block Instance").tree(row[0].clone()).run().outputs;
        let geometry = Trial::of("Geometry").tree(second[0].clone()).texts(0);
        assert_eq!(
            geometry,
            ["{0;0;0}: Line-like Curve, {0, 2, 0}", "{0;0;1}: Line-like Curve, {10, 2, 0}",]
        );
    }

    #[test]
    fn a_block_is_placed_by_name_and_moved() {
        let at = Xform::translation(Vector3::new(0.0, 0.0, 3.0));
        let trial = || {
            Trial::of("Model Block Instance")
                .default()
                .item("chair")
                .item(Value::from(at))
                .model(RhinoModel::new(model()))
        };
        assert_eq!(trial().texts(0), ["{0}: Block Instance (Chair)"]);
        assert_eq!(trial().texts(1), ["{0}: Chair"]);
        let placed = trial().run().outputs[0].clone();
        let moved = Trial::of("Move").tree(placed).item(Vector3::new(1.0, 0.0, 0.0)).run().outputs;
        let out = Trial::of("Explode Block Instance").tree(moved[0].clone()).run().outputs;
        let geometry = Trial::of("Geometry").tree(out[0].clone());
        assert_eq!(geometry.texts(0), ["{0;0}: Line-like Curve, {1, 1, 3}"]);
        let missing = Trial::of("Model Block Instance").default().item("stool");
        assert_eq!(missing.message(), "No block is called stool");
        assert_eq!(Trial::of("Explode Block Instance").item(1.0).message(), "A Number is no block instance");
    }

    #[test]
    fn a_file_becomes_a_block() {
        let folder = std::env::temp_dir().join(format!("katydid-block-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join("set.3dm"), model().write(70).unwrap()).unwrap();
        let import = |file: &str| {
            Trial::of("Import Model Block Definition").files(Files::Inside(folder.clone())).item(file)
        };
        assert_eq!(import("set.3dm").texts(0), ["{0}: set"]);
        assert_eq!(import("set.3dm").default().item("Set of chairs").texts(0), ["{0}: Set of chairs"]);
        let block = import("set.3dm").run().outputs[0].clone();
        let placed = Trial::of("Model Block Instance").default().tree(block).run().outputs[0].clone();
        let out = Trial::of("Explode Block Instance").tree(placed).texts(0);
        assert_eq!(out, ["{0;0}: Block Instance (Chair), Block Instance (Row)"]);
        assert!(import("none.3dm").message().contains("none.3dm"));
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn a_block_inside_itself_ends() {
        let mut model = model();
        let row = model.blocks[1].id;
        let id = model.add_block("Loop", vec![reference(row, Xform::IDENTITY)]);
        let members = model.blocks[2].members.clone();
        model.blocks[1].members.extend(members);
        model.objects.push(reference(id, Xform::IDENTITY));
        let model = RhinoModel::new(model);
        assert_eq!(model.blocks().len(), 3);
    }
}
