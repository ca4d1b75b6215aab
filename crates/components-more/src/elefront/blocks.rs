//! Blocks: defined, placed, and taken apart.

use std::sync::Arc;

use katydid_component::{Context, List, Message, component};
use katydid_data::{BlockInstance, Value};
use katydid_geometry::{Plane, Point3, Vector3, Xform};

use super::criteria::any;
use super::objects;
use crate::blocks::{block_of, instance_of, made, placed, shown};

/// Where a block is placed from its own space.
fn onto(plane: &Plane) -> Xform {
    Xform::plane_to_plane(&Plane::XY, plane)
}

/// A block of geometry with attributes, placed where the geometry is, so that it can be baked. Stands for EleFront's Define Block; that
/// it is placed on its base plane is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd241",
    name = "Define Block",
    nick = "Block",
    at = "EleFront/05 Blocks"
)]
#[output("Block", "B", "The block.", kind = Content)]
fn define_block(
    context: &Context<'_>,
    /// The geometry.
    #[port("Geometry", "G")]
    geometry: List<Value>,
    /// The attributes of each; the last are for all that follow.
    #[port("Attributes", "A", optional)]
    attributes: List<Value>,
    /// The name.
    #[port("Block Name", "N")]
    name: Arc<str>,
    /// The plane that becomes the XY plane of the block.
    #[port("Base Plane", "P", default = Plane::XY)]
    base: Plane,
) -> Result<Value, Message> {
    context.items(geometry.len())?;
    let attributes: Vec<Value> = attributes.present().collect();
    let block = made(&name, geometry.present(), &attributes, &base)?;
    Ok(Value::from(BlockInstance { definition: Arc::new(block), transform: onto(&base) }))
}

/// Places a block on a plane: one of the Rhino model, by its name, or one that is defined here. Stands for EleFront's Insert Block.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd242",
    name = "Insert Block",
    nick = "Insert",
    at = "EleFront/05 Blocks"
)]
#[output("Block", "B", "The block where it is placed.", kind = Content)]
fn insert_block(
    context: &Context<'_>,
    /// The name, or the block.
    #[port("Block Name", "N")]
    name: Value,
    /// The plane that the XY plane of the block comes to lie on.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
) -> Result<Value, Message> {
    let definition = block_of(context, &name)?;
    Ok(Value::from(BlockInstance { definition, transform: onto(&plane) }))
}

/// The map from the space of a block to where it is placed.
fn place_of(context: &Context<'_>, value: &Value) -> Xform {
    instance_of(context, value).map_or(Xform::IDENTITY, |instance| instance.transform)
}

/// The plane that a map lays the XY plane on.
fn plane_of(place: &Xform) -> Result<Plane, Message> {
    Ok(Plane::from_axes(place.point(Point3::ORIGIN), place.vector(Vector3::X), place.vector(Vector3::Y))?)
}

/// The name of a block, its place, its own space where it is not placed, and the geometry that it shows there.
fn taken_apart(context: &Context<'_>, value: &Value) -> Result<(Arc<str>, Xform, Vec<Value>), Message> {
    let definition = block_of(context, value)?;
    let place = place_of(context, value);
    let objects = shown(context, &definition, &place)?;
    Ok((definition.name.clone(), place, objects.into_iter().filter_map(|object| object.geometry).collect()))
}

/// The name of a block, its place as a map, and the geometry that it shows there. Blocks inside it stay blocks. Stands for EleFront's
/// Explode Block.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd243",
    name = "Explode Block",
    nick = "ExpBlock",
    at = "EleFront/05 Blocks"
)]
#[output("Name", "N", "The name.")]
#[output("Transform", "X", "The map from the space of the block to where it is placed.")]
#[output("Geometry", "G", "The geometry.", kind = Generic)]
fn explode_block(
    context: &Context<'_>,
    /// The block, or its name in the Rhino model.
    #[port("Block", "B")]
    block: Value,
) -> Result<(Arc<str>, Xform, Vec<Value>), Message> {
    taken_apart(context, &block)
}

/// The name of a block, the plane that it is placed on, and the geometry that it shows there. Stands for EleFront's Deconstruct Block;
/// that the geometry is where the block is placed is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd244",
    name = "Deconstruct Block",
    nick = "DeBlock",
    at = "EleFront/05 Blocks"
)]
#[output("Name", "N", "The name.")]
#[output("Plane", "P", "The plane; the XY plane for a block that is not placed.")]
#[output("Geometry", "G", "The geometry.", kind = Generic)]
fn deconstruct_block(
    context: &Context<'_>,
    /// The block, or its name in the Rhino model.
    #[port("Block", "B")]
    block: Value,
) -> Result<(Arc<str>, Plane, Vec<Value>), Message> {
    let (name, place, geometry) = taken_apart(context, &block)?;
    Ok((name, plane_of(&place)?, geometry))
}

/// The blocks that are placed in the Rhino model under some names. `*` stands for any text, `?` for one character; capitals do not
/// matter. Stands for EleFront's Reference Block by Name.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd245",
    name = "Reference Block by Name",
    nick = "RefBlock",
    at = "EleFront/01 Reference"
)]
#[output("Block Instances", "B", "The blocks.", kind = Content)]
fn reference_block(
    context: &Context<'_>,
    /// The names.
    #[port("Block Name", "[]BN")]
    names: List<Arc<str>>,
) -> Result<Vec<Value>, Message> {
    objects(context, |object| {
        let geometry = object.geometry.as_ref();
        geometry.and_then(placed).is_some_and(|instance| any(&names, &instance.definition.name))
    })
}

/// The name of a block and where it is placed. Blocks of other files are read as parts of the model: the path of a file is null. Stands
/// for EleFront's Get Block Info; that every block is `Embedded` is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd246",
    name = "Get Block Info",
    nick = "Block Info",
    at = "EleFront/05 Blocks"
)]
#[output("Name", "N", "The name.")]
#[output("Plane", "P", "The plane that it is placed on; the XY plane for a block that is not placed.")]
#[output("Transform", "X", "The map from the space of the block to where it is placed.")]
#[output("Block Type", "T", "Embedded.")]
#[output("FilePath", "F", "Null; not supported.")]
#[output("Active", "D", "Whether the Rhino model has a block of that name.")]
fn block_info(
    context: &Context<'_>,
    /// The block, or its name in the Rhino model.
    #[port("Block", "B")]
    block: Value,
) -> Result<(Arc<str>, Plane, Xform, Arc<str>, Option<Arc<str>>, bool), Message> {
    let name = block_of(context, &block)?.name.clone();
    let place = place_of(context, &block);
    let is_known = context.model().is_some_and(|model| model.block(&name).is_some());
    Ok((name, plane_of(&place)?, place, "Embedded".into(), None, is_known))
}

#[cfg(test)]
mod tests {
    use katydid_3dm::{BlockReference, Model, ModelObject, Object};
    use katydid_component::RhinoModel;
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Plane, Point3, Vector3, Xform};

    const DEFINE: &str = "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd241";

    fn at(x: f64, y: f64) -> Plane {
        Plane::XY.with_origin(Point3::new(x, y, 0.0))
    }

    fn defined() -> katydid_data::Tree {
        let points = [Point3::new(5.0, 0.0, 0.0), Point3::new(6.0, 0.0, 0.0)];
        let made = Trial::of_guid(DEFINE).list(points).default().item("Pin").item(at(5.0, 0.0)).run();
        assert!(made.messages.is_empty(), "{:?}", made.messages);
        made.outputs[0].clone()
    }

    #[test]
    fn a_block_is_placed_where_its_geometry_is() {
        let out = Trial::of("Explode Block").tree(defined()).run().outputs;
        assert_eq!(texts(&out[0]), ["{0}: Pin"]);
        assert_eq!(texts(&out[2]), ["{0;0}: {5, 0, 0}, {6, 0, 0}"]);
        let Some(map) = out[1].column().get(0).and_then(|map| map.as_transform()) else { panic!("a map") };
        assert_eq!(map.point(Point3::ORIGIN), Point3::new(5.0, 0.0, 0.0));
    }

    #[test]
    fn a_block_is_placed_on_a_plane() {
        let turned = Plane::from_axes(Point3::new(0.0, 2.0, 0.0), Vector3::Y, -Vector3::X).unwrap();
        let inserted = Trial::of("Insert Block").tree(defined()).item(turned).run().outputs[0].clone();
        let out = Trial::of("Deconstruct Block").tree(inserted).run().outputs;
        assert_eq!(texts(&out[2]), ["{0;0}: {0, 2, 0}, {0, 3, 0}"]);
        let Some(Value::Plane(plane)) = out[1].column().get(0) else { panic!("a plane") };
        assert_eq!((plane.origin, plane.x_axis), (Point3::new(0.0, 2.0, 0.0), Vector3::Y));
    }

    #[test]
    fn blocks_of_the_model_are_found_by_name() {
        let mut model = Model::default();
        model.add_block("Chair", vec![ModelObject::from(Object::Point(Point3::new(1.0, 0.0, 0.0)))]);
        let model = || RhinoModel::new(model.clone());
        let insert = |name: &str| Trial::of("Insert Block").item(name).item(at(0.0, 3.0)).model(model());
        assert_eq!(insert("chair").texts(0), ["{0}: Block Instance (Chair)"]);
        assert_eq!(insert("Stool").message(), "No block is called Stool");
        assert_eq!(Trial::of("Explode Block").item("Chair").model(model()).texts(2), ["{0;0}: {1, 0, 0}"]);
        assert_eq!(Trial::of("Explode Block").item(Point3::ORIGIN).message(), "A Point is no block");
    }

    #[test]
    fn what_is_known_of_blocks() {
        let of = |k: usize| Trial::of("Get Block Info").tree(defined()).texts(k);
        assert_eq!((of(0), of(3)), (vec!["{0}: Pin".to_owned()], vec!["{0}: Embedded".to_owned()]));
        assert_eq!((of(4), of(5)), (vec!["{0}: null".to_owned()], vec!["{0}: False".to_owned()]));
        let out = Trial::of("Get Block Info").tree(defined()).run().outputs;
        let Some(Value::Plane(plane)) = out[1].column().get(0) else { panic!("a plane") };
        assert_eq!(plane.origin, Point3::new(5.0, 0.0, 0.0));
        assert_eq!(Trial::of("Get Block Info").item(Point3::ORIGIN).message(), "A Point is no block");
    }

    #[test]
    fn placed_blocks_of_the_model_are_found() {
        let mut model = Model::default();
        for name in ["Chair", "Table"] {
            let block = model.add_block(name, vec![ModelObject::from(Object::Point(Point3::ORIGIN))]);
            let place = Xform::translation(Vector3::X);
            model.objects.push(Object::BlockReference(Box::new(BlockReference::new(block, place))).into());
        }
        let find = |name: &str| {
            Trial::of("Reference Block by Name").item(name).model(RhinoModel::new(model.clone()))
        };
        let count = |name: &str| find(name).run().outputs[0].item_count();
        assert_eq!((count("chair"), count("*"), count("Stool")), (1, 2, 0));
        let out = Trial::of("Get Block Info").tree(find("Chair").run().outputs[0].clone());
        let out = out.model(RhinoModel::new(model.clone())).run().outputs;
        assert_eq!((texts(&out[0]), texts(&out[5])), (vec!["{0}: Chair".into()], vec!["{0}: True".into()]));
        let told = Trial::of("Reference Block by Name").item("*").message();
        assert!(told.starts_with("Needs the Rhino model"), "{told}");
    }
}
