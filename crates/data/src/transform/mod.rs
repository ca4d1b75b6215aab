//! What a map does to any geometry.

mod drawn;
mod error;
mod kept;

use std::sync::Arc as Shared;

use katydid_geometry::{Box3, Brep, Curve, Interval, Plane, Rectangle, TwistedBox, Vector3, Xform};

pub use self::error::TransformError;
use crate::{Content, Group, ModelObject, Value};

/// Groups in groups beyond this depth are refused.
const DEEPEST: usize = 100;

impl Value {
    /// The image under a map. It keeps its type where the map allows: a circle that is stretched becomes a curve.
    ///
    /// # Errors
    /// A type that cannot be transformed, or a map that leaves nothing of the type.
    pub fn transformed(&self, xform: &Xform) -> Result<Self, TransformError> {
        at_depth(self, xform, 0)
    }

    /// What stands for it as a Brep: the six faces of a box, the walls of an extrusion.
    ///
    /// # Errors
    /// It stands for none.
    pub fn solid(&self) -> Result<Shared<Brep>, TransformError> {
        match self.brep() {
            Some(brep) => brep.map_err(TransformError::NoBrep),
            None => Err(TransformError::NoBrep(format!("A {} has no faces", self.kind()))),
        }
    }
}

fn at_depth(value: &Value, xform: &Xform, depth: usize) -> Result<Value, TransformError> {
    Ok(match value {
        Value::Point(p) => Value::Point(xform.point(*p)),
        Value::Vector(v) => Value::Vector(xform.vector(*v)),
        Value::Plane(plane) => Value::from(plane.transformed(xform)?),
        Value::Line(line) => Value::from(line.transformed(xform)),
        Value::Circle(circle) => match circle.transformed(xform) {
            Some(image) => Value::from(image),
            None => Value::from(Curve::from(**circle).transformed(xform)?),
        },
        Value::Arc(arc) => match arc.transformed(xform) {
            Some(image) => Value::from(image),
            None => Value::from(Curve::from(**arc).transformed(xform)?),
        },
        Value::Rectangle(r) => match rectangle(r, xform) {
            Some(image) => Value::from(image),
            None => Value::from(Curve::from(r.to_polyline()?).transformed(xform)?),
        },
        Value::Box(b) => match cuboid(b, xform) {
            Some(image) => Value::from(image),
            None => Value::from(value.solid()?.transformed(xform)?),
        },
        Value::TwistedBox(b) => Value::from(TwistedBox { corners: b.corners.map(|p| xform.point(p)) }),
        Value::Curve(curve) => Value::from(curve.transformed(xform)?),
        Value::Surface(surface) => Value::from(surface.transformed(xform)?),
        Value::Brep(brep) => Value::from(brep.transformed(xform)?),
        Value::Mesh(mesh) => Value::from(mesh.transformed(xform)?),
        Value::Group(group) => {
            if depth > DEEPEST {
                return Err(TransformError::TooDeep);
            }
            let member = |m: &Option<Value>| m.as_ref().map(|m| at_depth(m, xform, depth + 1)).transpose();
            let members = group.members.iter().map(member).collect::<Result<_, TransformError>>()?;
            Value::Group(Shared::new(Group { members }))
        }
        Value::Content(content) => match &**content {
            Content::Instance(instance) => Value::from(instance.transformed(xform)),
            Content::Object(ModelObject { geometry: Some(geometry), geometry_text, .. }) => {
                ModelObject::carrying(at_depth(geometry, xform, depth + 1)?, geometry_text.clone())
            }
            other => return Err(TransformError::Unsupported(other.type_name().to_string())),
        },
        Value::Kept(object) => kept::transformed(object, xform)?,
        other => return Err(TransformError::Unsupported(other.kind().to_string())),
    })
}

/// The images of the axes as unit vectors with the factors they grow by, when they stay at right angles.
fn axes<const N: usize>(axes: [Vector3; N], xform: &Xform) -> Option<[(Vector3, f64); N]> {
    if !xform.is_affine() {
        return None;
    }
    let images = axes.map(|axis| xform.vector(axis));
    let units = images.map(|v| v.unitized().map(|u| (u, v.length())));
    let mut out = [(Vector3::ZERO, 0.0); N];
    for (place, unit) in out.iter_mut().zip(units) {
        *place = unit?;
    }
    let square = (0..N).all(|i| {
        (0..i).all(|j| match (out.get(i), out.get(j)) {
            (Some(a), Some(b)) => a.0.dot(b.0).abs() <= 1e-12,
            _ => false,
        })
    });
    square.then_some(out)
}

fn stretched(range: Interval, factor: f64) -> Interval {
    Interval::new(range.start * factor, range.end * factor)
}

/// The image of a rectangle where its sides stay at right angles.
fn rectangle(r: &Rectangle, xform: &Xform) -> Option<Rectangle> {
    let [(x, sx), (y, sy)] = axes([r.plane.x_axis, r.plane.y_axis], xform)?;
    let plane = Plane::from_axes(xform.point(r.plane.origin), x, y).ok()?;
    Some(Rectangle { plane, x: stretched(r.x, sx), y: stretched(r.y, sy) })
}

/// The image of a box where its edges stay at right angles. Planes are right-handed, so that a mirrored box lies on the
/// other side of its plane.
fn cuboid(b: &Box3, xform: &Xform) -> Option<Box3> {
    let [(x, sx), (y, sy), (z, sz)] = axes([b.plane.x_axis, b.plane.y_axis, b.plane.z_axis], xform)?;
    let plane = Plane::from_axes(xform.point(b.plane.origin), x, y).ok()?;
    let depth = stretched(b.z, sz);
    let z = if plane.z_axis.dot(z) < 0.0 { Interval::new(-depth.end, -depth.start) } else { depth };
    Some(Box3 { plane, x: stretched(b.x, sx), y: stretched(b.y, sy), z })
}

#[cfg(test)]
mod tests {
    use katydid_geometry::{Circle, Point3};

    use super::*;

    #[test]
    fn a_circle_stays_one_only_where_angles_stay() {
        let circle = Value::from(Circle { plane: Plane::XY, radius: 2.0 });
        let twice = circle.transformed(&Xform::scale(Point3::ORIGIN, 2.0)).unwrap();
        assert!(matches!(twice, Value::Circle(c) if c.radius == 4.0));
        let oval = circle.transformed(&Xform::scale_non_uniform(&Plane::XY, 2.0, 1.0, 1.0)).unwrap();
        let Value::Curve(oval) = oval else { panic!("a curve") };
        assert!(oval.closest_point(Point3::new(4.0, 0.0, 0.0)).unwrap().distance < 1e-12);
    }

    #[test]
    fn boxes_and_rectangles_keep_their_type_where_corners_stay_square() {
        let unit = Interval::new(0.0, 1.0);
        let b = Box3 { plane: Plane::XY, x: unit, y: unit, z: unit };
        let stretch = Xform::scale_non_uniform(&Plane::XY, 2.0, 3.0, 4.0);
        let Value::Box(image) = Value::from(b).transformed(&stretch).unwrap() else { panic!("a box") };
        assert_eq!(image.corners()[6], Point3::new(2.0, 3.0, 4.0));
        let Value::Box(image) = Value::from(b).transformed(&Xform::mirror(&Plane::XY)).unwrap() else {
            panic!()
        };
        assert_eq!(image.corners()[0].z, -1.0);
        let shear = Xform::shear(&Plane::XY, [[1.0, 0.0], [0.0, 0.0], [0.0, 0.0]]);
        let Value::Brep(sheared) = Value::from(b).transformed(&shear).unwrap() else { panic!("a brep") };
        assert!(sheared.is_valid() && sheared.is_solid());
        assert!((sheared.volume_properties(1e-9, || true).unwrap().amount - 1.0).abs() < 1e-12);
        let r = Rectangle { plane: Plane::XY, x: unit, y: unit };
        assert!(matches!(Value::from(r).transformed(&stretch).unwrap(), Value::Rectangle(_)));
        assert!(matches!(Value::from(r).transformed(&shear).unwrap(), Value::Curve(_)));
    }

    #[test]
    fn geometry_takes_its_texts_along() {
        let texts = vec![("key".into(), "text".into())];
        let point = ModelObject::carrying(Value::Point(Point3::ORIGIN), texts.clone());
        let moved = point.transformed(&Xform::translation(Vector3::X)).unwrap();
        assert_eq!(moved, ModelObject::carrying(Value::Point(Point3::new(1.0, 0.0, 0.0)), texts));
        assert_eq!(moved.carried_texts().len(), 1);
    }

    #[test]
    fn groups_move_whole_and_numbers_do_not() {
        let group = Group { members: vec![Some(Value::Point(Point3::ORIGIN)), None] };
        let moved = Value::from(group).transformed(&Xform::translation(Vector3::X)).unwrap();
        let Value::Group(moved) = moved else { panic!("a group") };
        assert_eq!(moved.members, [Some(Value::Point(Point3::new(1.0, 0.0, 0.0))), None]);
        assert!(
            Value::Number(1.0)
                .transformed(&Xform::IDENTITY)
                .unwrap_err()
                .to_string()
                .contains("cannot be transformed")
        );
        let v = Value::Vector(Vector3::Y).transformed(&Xform::translation(Vector3::X)).unwrap();
        assert_eq!(v, Value::Vector(Vector3::Y));
    }
}
