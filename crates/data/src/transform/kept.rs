//! What a map does to geometry that is kept as a whole.

use katydid_3dm::{BrepObject, Extrusion, Limits, Object, PointCloud, RawObject, StoredPart, SubDObject};
use katydid_geometry::{Brep, Curve, Direction, Line, Surface, Vector3, Xform};

use super::{TransformError, drawn};
use crate::Value;

/// How far a linear part may be from orthonormal to count as a rotation.
const ROUND: f64 = 1e-9;
/// The archive version whose rules the bytes follow.
const NEWEST: i32 = 80;

/// The image of an object. It stays what it is where the map allows: Breps under moves, rotations and uniform scales,
/// extrusions under moves and rotations; under other maps both become computed Breps. Meshes for display are left out:
/// they are made anew where they are needed.
///
/// # Errors
/// A class that nothing is known of; an object that cannot be read or made anew.
pub(super) fn transformed(raw: &RawObject, xform: &Xform) -> Result<Value, TransformError> {
    if xform.is_identity(0.0) {
        return Ok(Value::from(raw.clone()));
    }
    let class = raw.class_name();
    let broken = |error: &dyn std::fmt::Display| TransformError::Unreadable {
        class: class.to_string(),
        reason: error.to_string(),
    };
    let object = raw.parse(&Limits::default()).map_err(|error| broken(&error))?;
    if let Some(curve) = object.curve() {
        return Ok(Value::from(curve.transformed(xform)?));
    }
    let image = match object {
        Object::Point(p) => return Ok(Value::Point(xform.point(p))),
        Object::Brep(object) => {
            let factor = xform.similarity_factor(ROUND).filter(|factor| *factor > 0.0);
            match factor.and_then(|factor| brep(&object, xform, factor)) {
                Some(image) => Object::Brep(Box::new(image)),
                None => return computed(&object.brep, xform).map_err(|error| broken(&error)),
            }
        }
        Object::Extrusion(extrusion) if xform.is_rigid(ROUND) => {
            Object::Extrusion(Box::new(self::extrusion(*extrusion, xform)))
        }
        Object::Extrusion(extrusion) => {
            let solid = extrusion.to_brep().ok_or_else(|| broken(&"its profile or path is no sound one"))?;
            return computed(&solid.brep, xform).map_err(|error| broken(&error));
        }
        Object::Mesh(mesh) => return Ok(Value::from(mesh.to_mesh()?.transformed(xform)?)),
        Object::SubD(subd) => Object::SubD(Box::new(self::subd(*subd, xform))),
        Object::PointCloud(cloud) => Object::PointCloud(self::cloud(cloud, xform)),
        Object::TextDot(mut dot) => {
            dot.point = xform.point(dot.point);
            Object::TextDot(dot)
        }
        other => match other.surface() {
            Some(surface) => return Ok(Value::from(surface.transformed(xform)?)),
            None => match drawn::transformed(other, xform)? {
                Some(image) => image,
                None => return Err(TransformError::Unsupported(class.to_string())),
            },
        },
    };
    image.to_raw(NEWEST, &raw.user_data).map(Value::from).map_err(|error| broken(&error))
}

/// The image of a solid as the kernel computes it.
fn computed(brep: &Brep, xform: &Xform) -> katydid_geometry::Result<Value> {
    Ok(Value::from(brep.transformed(xform)?))
}

/// A brep whose curves and surfaces keep their parameters on the way: trims stay what they are. None when one does not,
/// or the kernel does not have it.
fn brep(object: &BrepObject, xform: &Xform, factor: f64) -> Option<BrepObject> {
    let mut parts = object.brep.parts().clone();
    // What differs in the stored forms beyond what the kernel has is boxes and flags, which are made anew.
    let curves =
        object.odd_curves_3d.keys().all(|place| parts.curves_3d.get(*place).is_some_and(Option::is_some));
    let surfaces =
        object.odd_surfaces.keys().all(|place| parts.surfaces.get(*place).is_some_and(Option::is_some));
    if !(curves && surfaces) {
        return None;
    }
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
    Some(BrepObject { odd_curves_2d: object.odd_curves_2d.clone(), bounds, ..BrepObject::from(brep) })
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

/// The net's points, and what is stored beside them. The surface goes where its net goes under every affine map.
fn subd(mut subd: SubDObject, xform: &Xform) -> SubDObject {
    let point = |p: &mut [f64; 3]| {
        let image = xform.point((*p).into());
        *p = [image.x, image.y, image.z];
    };
    let part = |part: &mut StoredPart| {
        if let Some(p) = &mut part.saved_point {
            point(p);
        }
        if let Some(by) = &mut part.displacement {
            let image = xform.vector(Vector3::new(by[0], by[1], by[2]));
            *by = [image.x, image.y, image.z];
        }
    };
    for level in &mut subd.levels {
        for vertex in &mut level.vertices {
            point(&mut vertex.point);
            part(&mut vertex.part);
        }
        level.edges.iter_mut().for_each(|edge| part(&mut edge.part));
        level.faces.iter_mut().for_each(|face| part(&mut face.part));
    }
    // Planes of symmetry and hashes belong to the old place.
    subd.symmetry = None;
    subd.packing.hash = None;
    subd
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
            Err(error) => Err(error.to_string()),
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
    fn an_extrusion_moves_and_turns() {
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
