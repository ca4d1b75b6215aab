//! One object of any class.

use katydid_3dm::Object;
use serde_json::{Value, json};

use crate::annotation;
use crate::brep::brep;
use crate::curve::curve;
use crate::mesh::{mesh, subd};
use crate::numbers::{point, points, vectors};
use crate::surface::surface;

pub(crate) fn geometry(object: &Object) -> Value {
    let detail = match object {
        Object::Point(p) => json!({"point": point(*p)}),
        Object::PointCloud(cloud) => {
            json!({"points": points(&cloud.points), "normals": vectors(&cloud.normals),
                "colours": cloud.colours, "values": cloud.values})
        }
        Object::Curve(c) => curve(c),
        Object::Surface(s) => surface(s),
        Object::Mesh(m) => mesh(m),
        Object::CurveForm(form) => form.to_curve().map_or(json!({}), |c| curve(&c)),
        Object::SurfaceForm(form) => form.to_surface().map_or(json!({}), |s| surface(&s)),
        Object::Brep(b) => brep(b),
        Object::Extrusion(e) => {
            json!({"start": point(e.path.at(e.part.start)), "end": point(e.path.at(e.part.end)),
            "profiles": e.profile_count, "caps": e.caps, "mitred": e.is_mitred})
        }
        Object::SubD(s) => subd(s),
        Object::Annotation(a) => annotation::annotation(a),
        Object::Annotation5(a) => annotation::annotation_5(a),
        Object::Annotation2(a) => annotation::annotation_2(a),
        Object::Hatch(hatch) => annotation::hatch(hatch),
        Object::TextDot(dot) => annotation::text_dot(dot),
        Object::Light(light) => annotation::light(light),
        Object::BlockReference(block) => annotation::block_reference(block),
        Object::ClippingPlane(clipping) => annotation::clipping_plane(clipping),
        _ => json!({}),
    };
    json!({"class": object.class_name(), "kept": matches!(object, Object::Kept(_)), "detail": detail})
}
