//! Values as objects of a model.

use katydid_3dm::{BlockReference, BrepObject, Model, Object};
use katydid_data::{Content, Kind, ModelObject, Value, cast};

use super::content::Blocks;

/// The objects of a model that a value becomes. Types that Rhino does not draw become none. A block that is placed is
/// put into the model with `blocks`.
pub(super) fn of(
    value: &Value,
    rules: &cast::Rules,
    model: &mut Model,
    blocks: &mut Blocks,
    pieces: &mut Vec<Object>,
) -> Result<(), String> {
    match value {
        Value::Point(p) => pieces.push(Object::Point(*p)),
        Value::Line(_) | Value::Circle(_) | Value::Arc(_) | Value::Rectangle(_) | Value::Curve(_) => {
            if let Some(Value::Curve(curve)) = cast::value(value, Kind::Curve, rules) {
                pieces.push(Object::Curve((*curve).clone()));
            }
        }
        Value::Surface(surface) => pieces.push(Object::Surface((**surface).clone())),
        Value::Brep(brep) => {
            let object = BrepObject { bounds: brep.bounds_of_faces(), ..BrepObject::from((**brep).clone()) };
            pieces.push(Object::Brep(Box::new(object)));
        }
        Value::Mesh(mesh) => pieces.push(Object::from((**mesh).clone())),
        Value::Box(_) | Value::TwistedBox(_) => match cast::value(value, Kind::Mesh, rules) {
            Some(Value::Mesh(mesh)) => pieces.push(Object::from((*mesh).clone())),
            _ => return Err("a box without volume".to_owned()),
        },
        Value::Group(group) => {
            for member in group.members.iter().flatten() {
                of(member, rules, model, blocks, pieces)?;
            }
        }
        Value::Kept(raw) => pieces.push(Object::Kept((**raw).clone())),
        Value::Content(content) => match &**content {
            Content::Object(ModelObject { geometry: Some(geometry), .. }) => {
                of(geometry, rules, model, blocks, pieces)?;
            }
            Content::Instance(instance) => {
                let definition = blocks.put(model, &instance.definition, rules)?;
                let reference = BlockReference::new(definition, instance.transform);
                pieces.push(Object::BlockReference(Box::new(reference)));
            }
            _ => {}
        },
        _ => {}
    }
    Ok(())
}
