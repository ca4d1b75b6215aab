//! What a map does to geometry that is kept as a whole.

use katydid_3dm::{BrepObject, Extrusion, Limits, Object, PointCloud, RawObject};
use katydid_component::Message;
use katydid_data::Value;
use katydid_geometry::{Brep, Curve, Direction, Line, Surface, Xform};

/// How far a linear part may be from orthonormal to count as a rotation.
const ROUND: f64 = 1e-9;
/// The archive version whose rules the bytes follow.
const NEWEST: i32 = 80;

/// The image of an object. Breps follow moves, rotations and uniform scales, extrusions moves and rotations, point
/// clouds and text dots every affine map. Meshes for display are left out: they are made anew where they are needed.
///
/// # Errors
/// Another class or map; an object that cannot be read or made anew.
pub(super) fn transformed(raw: &RawObject, xform: &Xform) -> Result<Value, Message> {
    if xform.is_identity(0.0) {
        return Ok(Value::from(raw.clone()));
    }
    let class = raw.class_name();
    let refused = || Message::error(format!("A {class} cannot be transformed yet"));
    let this_way = || Message::error(format!("A {class} cannot be transformed in this way yet"));
    let broken =
        |error: &dyn std::fmt::Display| Message::error(format!("A {class} cannot be transformed: {error}"));
    let object = raw.parse(&Limits::default()).map_err(|error| broken(&error))?;
    let factor = xform.similarity_factor(ROUND).filter(|factor| *factor > 0.0);
    let image = match object {
        Object::Brep(brep) => {
            let factor = factor.ok_or_else(this_way)?;
            Object::Brep(Box::new(self::brep(*brep, xform, factor).ok_or_else(this_way)?))
        }
        Object::Extrusion(extrusion) if xform.is_rigid(ROUND) => {
            Object::Extrusion(Box::new(self::extrusion(*extrusion, xform)))
        }
        Object::PointCloud(cloud) if xform.is_affine() => Object::PointCloud(self::cloud(cloud, xform)),
        Object::TextDot(mut dot) if xform.is_affine() => {
            dot.point = xform.point(dot.point);
            Object::TextDot(dot)
        }
        Object::Extrusion(_) | Object::PointCloud(_) | Object::TextDot(_) => return Err(this_way()),
        _ => return Err(refused()),
    };
    image.to_raw(NEWEST, &raw.user_data).map(Value::from).map_err(|error| broken(&error))
}

/// A brep whose curves and surfaces keep their parameters on the way: trims stay what they are. None when one does not.
fn brep(object: BrepObject, xform: &Xform, factor: f64) -> Option<BrepObject> {
    let is_odd = !(object.odd_curves_3d.is_empty() && object.odd_surfaces.is_empty());
    if is_odd {
        return None;
    }
    let mut parts = object.brep.into_parts();
    for curve in parts.curves_3d.iter_mut().flatten() {
        *curve = curve_image(curve, xform)?;
    }
    for surface in parts.surfaces.iter_mut().flatten() {
        *surface = surface_image(surface, xform)?;
    }
    // Negative tolerances mean that nobody has measured.
    let grown = |tolerance: f64| if tolerance > 0.0 { tolerance * factor } else { tolerance };
    for vertex in &mut parts.vertices {
        vertex.point = xform.point(vertex.point);
        vertex.tolerance = grown(vertex.tolerance);
    }
    for edge in &mut parts.edges {
        edge.tolerance = grown(edge.tolerance);
    }
    for region in parts.regions.iter_mut().flat_map(|regions| &mut regions.regions) {
        region.bounds = None;
    }
    let brep = Brep::from_parts(parts).ok()?;
    let bounds = brep.bounds_of_faces();
    Some(BrepObject { odd_curves_2d: object.odd_curves_2d, bounds, ..BrepObject::from(brep) })
}

fn curve_image(curve: &Curve, xform: &Xform) -> Option<Curve> {
    let image = curve.transformed(xform).ok()?;
    (image.domain() == curve.domain()).then_some(image)
}

fn surface_image(surface: &Surface, xform: &Xform) -> Option<Surface> {
    let image = surface.transformed(xform).ok()?;
    let same = Direction::BOTH.iter().all(|along| image.domain(*along) == surface.domain(*along));
    same.then_some(image)
}

fn extrusion(mut extrusion: Extrusion, xform: &Xform) -> Extrusion {
    extrusion.path = Line::new(xform.point(extrusion.path.from), xform.point(extrusion.path.to));
    extrusion.up = xform.vector(extrusion.up);
    extrusion.meshes.clear();
    extrusion
}

/// The points and normals; a plane that somebody gave the cloud is not kept, nor its box.
fn cloud(mut cloud: PointCloud, xform: &Xform) -> PointCloud {
    xform.transform_points(&mut cloud.points);
    let normal_map = xform.normal_map();
    for normal in &mut cloud.normals {
        *normal = normal_map.vector(*normal).unitized().unwrap_or(*normal);
    }
    let PointCloud { points, normals, colours, values, flags, .. } = cloud;
    PointCloud { normals, colours, values, flags: flags & 1, ..PointCloud::from(points) }
}

#[cfg(test)]
mod tests {
    use katydid_3dm::TextDot;
    use katydid_geometry::{Interval, Plane, Point3, Vector3};

    use super::*;

    fn raw(object: Object) -> RawObject {
        object.to_raw(NEWEST, &[]).unwrap()
    }

    fn image(object: Object, xform: &Xform) -> Result<Object, String> {
        match transformed(&raw(object), xform) {
            Ok(Value::Kept(raw)) => Ok(raw.parse(&Limits::default()).unwrap()),
            Ok(other) => Err(format!("{other:?}")),
            Err(message) => Err(message.text),
        }
    }

    #[test]
    fn clouds_and_dots_follow_every_affine_map() {
        let mut cloud = PointCloud::from(vec![Point3::new(1.0, 2.0, 3.0)]);
        cloud.normals = vec![Vector3::Z];
        let flat = Xform::scale_non_uniform(&Plane::XY, 2.0, 3.0, 0.5);
        let Ok(Object::PointCloud(cloud)) = image(Object::PointCloud(cloud), &flat) else {
            panic!("a cloud")
        };
        assert_eq!((cloud.points, cloud.normals), (vec![Point3::new(2.0, 6.0, 1.5)], vec![Vector3::Z]));
        let dot = TextDot::new(Point3::new(1.0, 0.0, 0.0), "a");
        let Ok(Object::TextDot(dot)) = image(Object::TextDot(dot), &flat) else { panic!("a dot") };
        assert_eq!((dot.point, dot.text.as_str()), (Point3::new(2.0, 0.0, 0.0), "a"));
    }

    #[test]
    fn an_extrusion_moves_and_turns_and_nothing_else() {
        let extrusion = || {
            let path = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 5.0));
            Extrusion {
                profile: None,
                profile_count: 1,
                path,
                part: Interval::UNIT,
                up: Vector3::Y,
                is_mitred: [false; 2],
                mitre_normals: [Vector3::Z; 2],
                path_domain: Interval::UNIT,
                transposed: false,
                caps: [false; 2],
                meshes: Vec::new(),
            }
        };
        let quarter = Xform::rotation(std::f64::consts::FRAC_PI_2, Vector3::X, Point3::ORIGIN).unwrap();
        let turned = self::extrusion(extrusion(), &quarter);
        assert!(turned.path.to.distance_to(Point3::new(0.0, -5.0, 0.0)) < 1e-12);
        assert!((turned.up - Vector3::Z).length() < 1e-12);
    }
}
