//! Values as objects of a model.

use katydid_3dm::{BlockReference, BrepObject, Model, Object};
use katydid_data::{Content, Kind, ModelObject, Value, cast};
use katydid_geometry::{Box3, Brep, Interval, Plane, PlaneSurface, Surface, Vector3};

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
        Value::Brep(brep) => pieces.push(brep_object(brep)),
        Value::Mesh(mesh) => pieces.push(Object::from((**mesh).clone())),
        Value::Box(shape) => match (flat(shape), value.brep()) {
            (Some(sheet), _) => pieces.push(Object::Surface(sheet)),
            (_, Some(Ok(brep))) => pieces.push(brep_object(&brep)),
            _ => return Err("a box without volume".to_owned()),
        },
        Value::TwistedBox(_) => match cast::value(value, Kind::Mesh, rules) {
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

fn brep_object(brep: &Brep) -> Object {
    Object::Brep(Box::new(BrepObject { bounds: brep.bounds_of_faces(), ..BrepObject::from(brep.clone()) }))
}

/// The rectangle that a box without height is, whichever of its sides is 0.
fn flat(shape: &Box3) -> Option<Surface> {
    let Plane { origin, x_axis, y_axis, z_axis } = shape.plane;
    let along = |x: Vector3, y: Vector3, z: Vector3, height: f64| Plane {
        origin: origin + z * height,
        x_axis: x,
        y_axis: y,
        z_axis: z,
    };
    let [x, y, z] = [shape.x, shape.y, shape.z].map(Interval::ordered);
    let (plane, u, v) = match [x, y, z].map(|side| side.length() > 0.0) {
        [true, true, false] => (along(x_axis, y_axis, z_axis, z.start), x, y),
        [false, true, true] => (along(y_axis, z_axis, x_axis, x.start), y, z),
        [true, false, true] => (along(z_axis, x_axis, y_axis, y.start), z, x),
        _ => return None,
    };
    PlaneSurface::new(plane, u, v).ok().map(Surface::from)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

    use super::*;

    /// Boxes become solids as in Grasshopper, and those without height rectangles.
    #[test]
    fn boxes_are_solids() {
        let baked = |sides: [f64; 3]| {
            let [x, y, z] = sides.map(|s| Interval::new(0.0, s));
            let value = Value::from(Box3 { plane: Plane::XZ, x, y, z });
            let (mut model, mut blocks, mut pieces) = (Model::default(), Blocks::default(), Vec::new());
            of(&value, &cast::Rules::default(), &mut model, &mut blocks, &mut pieces).map(|()| pieces)
        };
        let solid = baked([2.0, -3.0, 4.0]);
        let Ok([Object::Brep(solid)]) = solid.as_deref() else { panic!("a Brep") };
        assert!(solid.brep.is_solid() && solid.brep.is_valid());
        for sides in [[0.0, 3.0, 4.0], [3.0, 0.0, 4.0], [3.0, -4.0, 0.0]] {
            let sheet = baked(sides);
            let Ok([Object::Surface(sheet)]) = sheet.as_deref() else { panic!("a surface") };
            assert!((sheet.area().unwrap().area - 12.0).abs() < 1e-12);
        }
        assert!(baked([0.0, 3.0, 0.0]).is_err());
    }
}
