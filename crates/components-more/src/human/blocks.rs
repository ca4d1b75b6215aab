//! Blocks: made, and exploded.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{BlockInstance, ModelObject, Path, Tree, Value};
use katydid_geometry::Plane;

use crate::blocks::{instance_of, made, no_block, shown};
use crate::branches::Branches;

/// Blocks in blocks beyond this depth are not followed.
const DEEPEST: i32 = 50;

/// Attributes of an object without its geometry.
fn attributes_of(object: &ModelObject) -> Value {
    Value::from(ModelObject { geometry: None, ..object.clone() })
}

/// Makes a block of geometry with attributes. There is no document that it is put into: the block itself is the result, which has its
/// name as text; EleFront's Insert Block places it. Stands for Human's Define Block.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd321",
    name = "Define Block",
    nick = "DefBlock",
    at = "Human/Creation"
)]
#[output("Block Name", "BN", "The block.", kind = Content)]
fn define_block(
    context: &Context<'_>,
    /// The name.
    #[port("Block Name", "BN")]
    name: Shared<str>,
    /// The geometry.
    #[port("Geometry", "G")]
    geometry: List<Value>,
    /// The attributes of each; the last are for all that follow.
    #[port("Attributes", "A", optional)]
    attributes: List<Value>,
    /// The plane that becomes the XY plane of the block.
    #[port("Block Origin", "BO", default = Plane::XY)]
    origin: Plane,
    /// Not used: there is no document with a block of that name.
    #[port("Overwrite", "O", default = false)]
    _overwrite: bool,
) -> Result<Value, Message> {
    context.items(geometry.len())?;
    let attributes: Vec<Value> = attributes.present().collect();
    Ok(Value::from(made(&name, geometry.present(), &attributes, &origin)?))
}

/// The objects that a block shows, where it shows them, with their attributes. Blocks inside the block stay blocks. Stands for Human's
/// Explode Blocks.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd322",
    name = "Explode Blocks",
    nick = "BlockExplode",
    at = "Human/Reference"
)]
#[output("Geometry", "geo", "The geometry of each object.", kind = Generic)]
#[output("Attributes", "att", "The attributes of each.", kind = Content)]
fn explode_blocks(
    context: &Context<'_>,
    /// The block that is placed.
    #[port("Block Objects", "block")]
    block: Value,
) -> Result<(Vec<Value>, Vec<Value>), Message> {
    let instance = instance_of(context, &block).ok_or_else(|| no_block(&block))?;
    let objects = shown(context, &instance.definition, &instance.transform)?;
    Ok(objects.iter().filter_map(|object| Some((object.geometry.clone()?, attributes_of(object)))).unzip())
}

/// The objects that blocks show with those of the blocks inside them, in a tree: a branch for each block, whose path is that of the
/// block around it with one number more, the place of the block in it. That numbering is our reading. Stands for Human's Explode
/// Blocks Recursively.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd323",
    name = "Explode Blocks Recursively",
    nick = "BlockExplode R",
    at = "Human/Reference"
)]
#[output("Geometry", "geo", "The geometry of each object.", kind = Generic)]
#[output("Attributes", "att", "The attributes of each.", kind = Content)]
fn explode_recursively(
    context: &Context<'_>,
    /// The blocks that are placed.
    #[port("Block Objects", "block", kind = Generic)]
    blocks: &Tree,
) -> Result<(Tree, Tree), Message> {
    let mut found = Exploded { context, geometry: Branches::default(), attributes: Branches::default() };
    for branch in blocks.branches() {
        for (place, block) in branch.iter().enumerate() {
            let Some(block) = block else { continue };
            let instance = instance_of(context, &block).ok_or_else(|| no_block(&block))?;
            found.follow(&instance, &branch.path().child(place), 0)?;
        }
    }
    Ok((found.geometry.tree(), found.attributes.tree()))
}

/// What is found on the way.
struct Exploded<'a, 'b> {
    context: &'a Context<'b>,
    geometry: Branches,
    attributes: Branches,
}

impl Exploded<'_, '_> {
    fn follow(&mut self, instance: &BlockInstance, path: &Path, depth: i32) -> Result<(), Message> {
        if depth > DEEPEST {
            return Err(Message::error(format!("Blocks lie in one another deeper than {DEEPEST}")));
        }
        let objects = shown(self.context, &instance.definition, &instance.transform)?;
        for (place, object) in objects.iter().enumerate() {
            let Some(geometry) = &object.geometry else { continue };
            match instance_of(self.context, geometry) {
                Some(inner) => self.follow(&inner, &path.child(place), depth + 1)?,
                None => {
                    self.geometry.push(path.clone(), Some(geometry.clone()));
                    self.attributes.push(path.clone(), Some(attributes_of(object)));
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::{BlockDefinition, BlockInstance, ModelObject, Value};
    use katydid_geometry::{Plane, Point3, Vector3, Xform};

    fn placed(block: BlockDefinition, x: f64) -> Value {
        let transform = Xform::translation(Vector3::new(x, 0.0, 0.0));
        Value::from(BlockInstance { definition: block.into(), transform })
    }

    /// A block of a point at x = 1, and one of that block, moved by 10, with a point at x = 2.
    fn nested() -> Value {
        let named =
            ModelObject { name: "knob".into(), ..ModelObject::new(Point3::new(1.0, 0.0, 0.0).into()) };
        let inner = placed(BlockDefinition::new("Inner", vec![named]), 10.0);
        let outer = vec![ModelObject::new(inner), ModelObject::new(Point3::new(2.0, 0.0, 0.0).into())];
        placed(BlockDefinition::new("Outer", outer), 100.0)
    }

    #[test]
    fn a_block_is_made_and_exploded() {
        let made = Trial::of_guid("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd321")
            .item("Pin")
            .list([Point3::new(5.0, 0.0, 0.0), Point3::new(6.0, 0.0, 0.0)])
            .item(Value::from(ModelObject { name: "tip".into(), ..ModelObject::default() }))
            .item(Plane::XY.with_origin(Point3::new(5.0, 0.0, 0.0)));
        let block = made.run().outputs[0].clone();
        assert_eq!(texts(&block), ["{0}: Pin"]);
        let at = Plane::XY.with_origin(Point3::new(0.0, 3.0, 0.0));
        let inserted = Trial::of("Insert Block").tree(block).item(at).run().outputs[0].clone();
        let exploded = Trial::of("Explode Blocks").tree(inserted).run().outputs;
        assert_eq!(texts(&exploded[0]), ["{0;0}: {0, 3, 0}, {1, 3, 0}"]);
        let names = Trial::of("Object Attributes").tree(exploded[1].clone());
        assert_eq!(names.texts(0), ["{0;0}: tip, tip"]);
    }

    #[test]
    fn blocks_in_blocks_make_a_tree() {
        let flat = Trial::of("Explode Blocks").item(nested()).texts(0);
        assert_eq!(flat, ["{0;0}: Block Instance (Inner), {102, 0, 0}"]);
        let deep = Trial::of("Explode Blocks Recursively").item(nested()).run().outputs;
        assert_eq!(texts(&deep[0]), ["{0;0}: {102, 0, 0}", "{0;0;0}: {111, 0, 0}"]);
        let names = Trial::of("Object Attributes").tree(deep[1].clone());
        assert_eq!(names.texts(0), ["{0;0}: null", "{0;0;0}: knob"]);
    }

    #[test]
    fn what_is_no_block() {
        let told = |name: &str| Trial::of(name).item(Point3::ORIGIN).message();
        assert_eq!(told("Explode Blocks"), "A Point is no block");
        assert_eq!(told("Explode Blocks Recursively"), "A Point is no block");
        let id = "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6fd321";
        let define = |name: &str| Trial::of_guid(id).item(name);
        assert_eq!(define(" ").item(Point3::ORIGIN).message(), "The block has no name");
        let none = define("Pin").gaps([None::<Point3>]);
        assert_eq!(none.message(), "The block Pin has no geometry");
    }
}
