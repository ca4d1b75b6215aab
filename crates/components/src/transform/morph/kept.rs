//! What a bending map does to geometry that is kept as a whole.

use katydid_3dm::{Limits, Object, PointCloud, RawObject, SubDObject};
use katydid_component::{Context, Message};
use katydid_data::Value;
use katydid_geometry::Point3;
use katydid_geometry::morph::Morph;

use super::Manner;

/// The archive version whose rules the bytes follow.
const NEWEST: i32 = 80;

/// The image: of Breps and extrusions the computed Brep, of SubDs their nets mapped, of clouds their points.
///
/// # Errors
/// A class that no map can bend, or an object that cannot be read.
pub(super) fn deformed(
    context: &Context<'_>,
    value: &Value,
    raw: &RawObject,
    morph: &dyn Morph,
    manner: Manner,
) -> Result<Value, Message> {
    if let Some(brep) = value.brep() {
        return super::solid(context, &*brep.map_err(Message::error)?, morph, manner);
    }
    let class = raw.class_name();
    let broken =
        |error: &dyn std::fmt::Display| Message::error(format!("A {class} cannot be deformed: {error}"));
    let object = raw.parse(&Limits::default()).map_err(|error| broken(&error))?;
    if let Some(curve) = object.curve() {
        return super::deformed(context, &Value::from(curve.into_owned()), morph, manner, 0);
    }
    let image = match object {
        Object::Point(p) => return Ok(Value::Point(morph.image(p)?)),
        Object::Mesh(mesh) => return Ok(Value::from(mesh.to_mesh()?.morphed(morph)?)),
        Object::SubD(subd) => Object::SubD(Box::new(self::subd(*subd, morph)?)),
        Object::PointCloud(cloud) => Object::PointCloud(self::cloud(cloud, morph)?),
        Object::TextDot(mut dot) => {
            dot.point = morph.image(dot.point)?;
            Object::TextDot(dot)
        }
        _ => return Err(Message::error(format!("A {class} cannot be deformed; only moved as a whole"))),
    };
    image.to_raw(NEWEST, &raw.user_data).map(Value::from).map_err(|error| broken(&error))
}

/// The vertices of the net mapped; what was computed from them is left out.
fn subd(mut subd: SubDObject, morph: &dyn Morph) -> Result<SubDObject, Message> {
    for level in &mut subd.levels {
        for vertex in &mut level.vertices {
            let image = morph.image(Point3::from(vertex.point))?;
            vertex.point = [image.x, image.y, image.z];
        }
        let parts = (level.vertices.iter_mut().map(|vertex| &mut vertex.part))
            .chain(level.edges.iter_mut().map(|edge| &mut edge.part))
            .chain(level.faces.iter_mut().map(|face| &mut face.part));
        for part in parts {
            (part.saved_point, part.displacement) = (None, None);
        }
    }
    subd.symmetry = None;
    subd.packing.hash = None;
    Ok(subd)
}

/// The points mapped, with their colours and values; normals are left out.
fn cloud(mut cloud: PointCloud, morph: &dyn Morph) -> Result<PointCloud, Message> {
    for point in &mut cloud.points {
        *point = morph.image(*point)?;
    }
    let PointCloud { points, colours, values, flags, .. } = cloud;
    Ok(PointCloud { colours, values, flags: flags & 1, ..PointCloud::from(points) })
}
