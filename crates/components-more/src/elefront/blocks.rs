//! Blocks: defined, placed, and taken apart.

use std::sync::Arc;

use katydid_component::{Context, List, Message, component};
use katydid_data::{BlockInstance, Value};
use katydid_geometry::{Plane, Point3, Vector3, Xform};

use crate::blocks::{block_of, instance_of, made, shown};

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

/// The place of a block, its own space where it is not placed, and the geometry that it shows there.
fn taken_apart(context: &Context<'_>, value: &Value) -> Result<(Arc<str>, Xform, Vec<Value>), Message> {
    let definition = block_of(context, value)?;
    let place = instance_of(context, value).map_or(Xform::IDENTITY, |instance| instance.transform);
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
    let plane =
        Plane::from_axes(place.point(Point3::ORIGIN), place.vector(Vector3::X), place.vector(Vector3::Y))?;
    Ok((name, plane, geometry))
}

#[cfg(test)]
mod tests {
    use katydid_3dm::{Model, ModelObject, Object};
    use katydid_component::RhinoModel;
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Plane, Point3, Vector3};

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
}
