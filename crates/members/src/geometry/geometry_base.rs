//! What all geometry has: boxes, and whether it is the same.

use katydid_geometry::{BoundingBox, Xform};

use super::answer::Outcome;
use super::table::Endpoints;
use crate::Fault;
use crate::wire::GeometryBase;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("geometrybase/getboundingbox-geometrybase_bool", |g: GeometryBase, _: bool| {
        bounds(&g, &Xform::IDENTITY)
    });
    table.add("geometrybase/getboundingbox-geometrybase_transform", |g: GeometryBase, x: Xform| {
        bounds(&g, &x)
    });
    table.add("geometrybase/geometryequals-geometrybase_geometrybase", |a: GeometryBase, b: GeometryBase| {
        Ok(a == b)
    });
}

/// The smallest box around geometry after a transform.
pub(super) fn bounds(geometry: &GeometryBase, xform: &Xform) -> Outcome<BoundingBox> {
    let found = match geometry {
        GeometryBase::Point(p) => BoundingBox::from_points([xform.point(*p)]),
        GeometryBase::Curve(curve) => Some(curve.transformed(xform)?.bounding_box()),
        GeometryBase::Surface(surface) => Some(surface.transformed(xform)?.bounding_box()?),
        GeometryBase::Brep(brep) => brep.transformed(xform)?.bounds_of_faces(),
        GeometryBase::Mesh(mesh) => mesh.transformed(xform)?.bounding_box(),
        // Its limit surface lies within the hull of a fine mesh of it, to a thousandth of its size.
        GeometryBase::SubD(subd) => subd.0.limit_mesh(4)?.transformed(xform)?.bounding_box(),
        GeometryBase::Other(object) => match &**object {
            katydid_3dm::Object::PointCloud(cloud) => {
                BoundingBox::from_points(cloud.points.iter().map(|p| xform.point(*p)))
            }
            katydid_3dm::Object::TextDot(dot) => BoundingBox::from_points([xform.point(dot.point)]),
            other => return Err(Fault::not_supported(format!("the box of a {}", other.class_name()))),
        },
    };
    found.ok_or_else(|| Fault::bad_request("geometry is empty"))
}
