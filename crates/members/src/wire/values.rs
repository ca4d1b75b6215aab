//! Values of a solution as a reply has them: the name of a type and JSON.

use katydid_3dm::{BrepObject, MeshObject, ModelObject, Object};
use katydid_data::{Colour, Value};
use katydid_geometry::{
    Arc, Box3, Circle, Interval, Line, MeshFace, Plane, Point3, Rectangle, Vector3, Xform,
};
use serde_json::{Value as Json, json};

use super::Wire;
use super::numbers::number;
use super::object::{curve_type, encode_object, restated, type_name};

/// A value as a reply has it.
#[derive(Debug, Clone, PartialEq)]
pub struct Encoded {
    /// The full name of the .NET type, such as `System.Double`.
    pub type_name: &'static str,
    /// The form.
    pub json: Json,
}

impl Encoded {
    fn new(type_name: &'static str, json: Json) -> Option<Self> {
        Some(Self { type_name, json })
    }

    fn of<T: Wire>(value: &T) -> Option<Self> {
        Self::new(T::TYPE, value.to_json(0).ok()?)
    }

    fn object(object: &ModelObject, archive: i32) -> Option<Self> {
        Self::new(type_name(&object.geometry), encode_object(object, archive).ok()?)
    }
}

/// A value as a reply has it, objects for an archive of the given version. `None` for a value that has no form there:
/// paths, matrices, fields, groups and such.
///
/// A surface is the brep of one face that it is in Rhino's replies. Colours, domains, transforms and moments are
/// written too, which Rhino.Compute leaves out.
pub fn encode(value: &Value, archive: i32) -> Option<Encoded> {
    match value {
        Value::Boolean(flag) => Encoded::new("System.Boolean", Json::from(*flag)),
        Value::Integer(whole) => Encoded::new("System.Int32", Json::from(*whole)),
        Value::Number(x) => Encoded::new("System.Double", number(*x)),
        Value::Text(text) => Encoded::new("System.String", Json::from(&**text)),
        Value::Complex(z) => Encoded::new(
            "System.Numerics.Complex",
            json!({ "Real": number(z.re), "Imaginary": number(z.im) }),
        ),
        Value::Guid(id) => Encoded::new("System.Guid", Json::from(id.to_string())),
        Value::Time(moment) => {
            Encoded::new("System.DateTime", Json::from(moment.to_string().replacen(' ', "T", 1)))
        }
        Value::Colour(colour) => Encoded::of::<Colour>(colour),
        Value::Domain(domain) => Encoded::of::<Interval>(domain),
        Value::Point(point) => Encoded::of::<Point3>(point),
        Value::Vector(vector) => Encoded::of::<Vector3>(vector),
        Value::Plane(plane) => Encoded::of::<Plane>(plane),
        Value::Line(line) => Encoded::of::<Line>(line),
        Value::Circle(circle) => Encoded::of::<Circle>(circle),
        Value::Arc(arc) => Encoded::of::<Arc>(arc),
        Value::Rectangle(rectangle) => Encoded::of::<Rectangle>(rectangle),
        Value::Box(shape) => Encoded::of::<Box3>(shape),
        Value::Transform(_) | Value::Compound(_) => Encoded::of::<Xform>(&value.as_transform()?),
        Value::MeshFace(face) => Encoded::new("Rhino.Geometry.MeshFace", mesh_face(face)),
        Value::Curve(curve) => {
            let object = Object::Curve((**curve).clone()).into();
            Encoded::new(curve_type(curve), encode_object(&object, archive).ok()?)
        }
        Value::Surface(_) | Value::Brep(_) => {
            let brep = value.brep()?.ok()?;
            let object = Object::Brep(Box::new(BrepObject::from((*brep).clone())));
            Encoded::object(&object.into(), archive)
        }
        Value::Mesh(mesh) => {
            Encoded::object(&Object::Mesh(Box::new(MeshObject::from(&**mesh))).into(), archive)
        }
        Value::Kept(raw) if raw.archive_version == archive => {
            let kept = Object::Kept((**raw).clone());
            let json = encode_object(&kept.into(), archive).ok()?;
            Encoded::new(type_name(&restated(raw).geometry), json)
        }
        Value::Kept(raw) => Encoded::object(&restated(raw), archive),
        _ => None,
    }
}

/// The four corners of a face; the last two are one in a triangle.
fn mesh_face(face: &MeshFace) -> Json {
    let [a, b, c, d] = match *face {
        MeshFace::Triangle([a, b, c]) => [a, b, c, c],
        MeshFace::Quad(corners) => corners,
    };
    json!({ "A": a, "B": b, "C": c, "D": d })
}
