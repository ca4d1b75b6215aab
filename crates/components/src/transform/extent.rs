//! How far geometry reaches along the axes of a plane.

use katydid_3dm::{Limits, Object, RawObject};
use katydid_data::{Content, Kind, ModelObject, Value, cast};
use katydid_geometry::{Box3, Plane, Point3};

use crate::surface::subd::subd_of;

/// Groups in groups beyond this depth are left out.
const DEEPEST: usize = 100;

/// The smallest box along a plane's axes around geometry: exact for curves and surfaces too, of a SubD that around a fine
/// mesh with vertices on it. `None` for what has no extent.
pub(crate) fn around(value: &Value, plane: &Plane) -> Option<Box3> {
    Box3::around(plane, corners(value, plane, 0))
}

fn corners(value: &Value, plane: &Plane, depth: usize) -> Vec<Point3> {
    match value {
        Value::Point(p) => vec![*p],
        // A plane reaches everywhere; what it is used for is its place.
        Value::Plane(plane) => vec![plane.origin],
        Value::Line(line) => vec![line.from, line.to],
        Value::Rectangle(r) => r.corners().to_vec(),
        Value::Box(b) => b.corners().to_vec(),
        Value::TwistedBox(b) => b.corners.to_vec(),
        Value::Mesh(mesh) => mesh.vertices().to_vec(),
        Value::Curve(curve) => curve.bounding_box_in(plane).corners().to_vec(),
        Value::Surface(surface) => {
            surface.bounding_box_in(plane).map_or_else(|_| Vec::new(), |b| b.corners().to_vec())
        }
        Value::Brep(brep) => {
            brep.bounding_box_in(plane).map_or_else(|_| Vec::new(), |b| b.corners().to_vec())
        }
        Value::Kept(raw) => match (value.brep(), subd_of(value)) {
            (Some(Ok(brep)), _) => {
                brep.bounding_box_in(plane).map_or_else(|_| Vec::new(), |b| b.corners().to_vec())
            }
            (_, Some(Ok(subd))) => subd
                .limit_mesh(subd.fine_levels())
                .map_or_else(|_| Vec::new(), |mesh| mesh.vertices().to_vec()),
            _ => places(raw),
        },
        Value::Circle(_) | Value::Arc(_) => match cast::value(value, Kind::Curve, &cast::Rules::default()) {
            Some(Value::Curve(curve)) => curve.bounding_box_in(plane).corners().to_vec(),
            _ => Vec::new(),
        },
        Value::Content(content) => match &**content {
            // Round the box of the block, not round each of its objects: blocks in blocks may show millions.
            Content::Instance(instance) => instance.bounds().map_or_else(Vec::new, |b| b.corners().to_vec()),
            Content::Object(ModelObject { geometry: Some(geometry), .. }) => {
                corners(geometry, plane, depth + 1)
            }
            _ => Vec::new(),
        },
        Value::Group(group) if depth < DEEPEST => {
            group.members.iter().flatten().flat_map(|m| corners(m, plane, depth + 1)).collect()
        }
        _ => Vec::new(),
    }
}

/// The points of a cloud, or the place of a dot.
fn places(raw: &RawObject) -> Vec<Point3> {
    match raw.parse(&Limits::default()) {
        Ok(Object::PointCloud(cloud)) => cloud.points,
        Ok(Object::TextDot(dot)) => vec![dot.point],
        Ok(Object::Point(p)) => vec![p],
        _ => Vec::new(),
    }
}
