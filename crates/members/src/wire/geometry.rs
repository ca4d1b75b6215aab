//! Curves, surfaces, breps, meshes and SubDs: what arguments and results of endpoints are.

use katydid_3dm::{BrepObject, MeshObject, ModelObject, Object, SubDObject};
use katydid_geometry::subd::SubD;
use katydid_geometry::{
    Arc, Box3, Brep, Circle, Curve, Line, Mesh, Point3, PolylineCurve, Surface, construct,
};
use serde_json::Value as Json;

use super::object::{encode_object, is_object_form, parsed, type_name};
use super::read::Members;
use super::structs::polyline;
use super::{Wire, made, no};
use crate::Fault;

/// Any object: what a parameter of type `GeometryBase` takes.
#[derive(Debug, Clone, PartialEq)]
#[expect(missing_docs, reason = "each variant is the type of the same name")]
pub enum GeometryBase {
    Point(Point3),
    Curve(Curve),
    Surface(Surface),
    Brep(Brep),
    Mesh(Mesh),
    SubD(Subdivision),
    /// A class that is read but has no part in computing.
    Other(Box<Object>),
}

/// A subdivision surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Subdivision(pub SubD);

/// What an object is called when it is not what was asked for.
fn found(object: &Object) -> String {
    format!("it is a {}", type_name(object).trim_start_matches("Rhino.Geometry."))
}

fn curve_of(object: &Object) -> Option<Curve> {
    object.curve().map(std::borrow::Cow::into_owned)
}

/// A brep, of whichever class it was; the object where it is no such thing.
fn brep_of(object: Object) -> Result<Result<Brep, Fault>, Box<Object>> {
    match object {
        Object::Brep(object) => Ok(Ok(object.brep)),
        Object::Extrusion(extrusion) => Ok(match extrusion.to_brep() {
            Some(object) => Ok(object.brep),
            None => Err(no::<Brep>("the extrusion is no sound one")),
        }),
        other => match other.surface() {
            Some(surface) => Ok(made(Brep::from_surface(surface.into_owned()))),
            None => Err(Box::new(other)),
        },
    }
}

impl Wire for Curve {
    const TYPE: &'static str = "Rhino.Geometry.Curve";
    const NAME: &'static str = "a curve";

    /// An object, a list of points (a polyline), or the struct of a line, an arc or a circle.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        if let Some(points) = polyline(json) {
            return points.map(Self::from).map_err(no::<Self>);
        }
        let members = Members::of(json).map_err(no::<Self>)?;
        if !is_object_form(json) {
            if members.get("From").is_some() {
                return Line::from_json(json).map(Self::from);
            }
            if members.first(&["AngleDomain", "Angle", "StartAngle"]).is_some() {
                return Arc::from_json(json).map(Self::from);
            }
            if members.get("Radius").is_some() {
                return Circle::from_json(json).map(Self::from);
            }
        }
        let object = parsed(json).map_err(no::<Self>)?;
        curve_of(&object).ok_or_else(|| no::<Self>(found(&object)))
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        encode_object(&Object::Curve(self.clone()).into(), archive)
    }
}

impl Wire for PolylineCurve {
    const TYPE: &'static str = "Rhino.Geometry.PolylineCurve";
    const NAME: &'static str = "a polyline";

    /// A list of points, or a curve that is made of straight pieces.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        let curve = Curve::from_json(json).map_err(no::<Self>)?;
        match curve {
            Curve::Polyline(polyline) => Ok(polyline),
            other => match other.as_polyline() {
                Some(points) => made(Self::new(points)),
                None => Err(no::<Self>("it is curved")),
            },
        }
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        Curve::from(self.clone()).to_json(archive)
    }
}

impl Wire for Surface {
    const TYPE: &'static str = "Rhino.Geometry.Surface";
    const NAME: &'static str = "a surface";

    /// An object that is a surface, or a brep of one face that is not trimmed.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        let object = parsed(json).map_err(no::<Self>)?;
        object.surface().map(std::borrow::Cow::into_owned).ok_or_else(|| no::<Self>(found(&object)))
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        encode_object(&Object::Surface(self.clone()).into(), archive)
    }
}

impl Wire for Brep {
    const TYPE: &'static str = "Rhino.Geometry.Brep";
    const NAME: &'static str = "a brep";

    /// An object that is a brep, an extrusion or a surface, or the struct of a box.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        if !is_object_form(json) && Members::of(json).is_ok_and(|m| m.first(&["X", "Min"]).is_some()) {
            return made(construct::box_brep(&Box3::from_json(json).map_err(no::<Self>)?));
        }
        let object = parsed(json).map_err(no::<Self>)?;
        brep_of(object).unwrap_or_else(|other| Err(no::<Self>(found(&other))))
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        encode_object(&Object::Brep(Box::new(BrepObject::from(self.clone()))).into(), archive)
    }
}

impl Wire for Mesh {
    const TYPE: &'static str = "Rhino.Geometry.Mesh";
    const NAME: &'static str = "a mesh";

    fn from_json(json: &Json) -> Result<Self, Fault> {
        match parsed(json).map_err(no::<Self>)? {
            Object::Mesh(object) => made(object.to_mesh()),
            other => Err(no::<Self>(found(&other))),
        }
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        encode_object(&Object::Mesh(Box::new(MeshObject::from(self))).into(), archive)
    }
}

impl Wire for Subdivision {
    const TYPE: &'static str = "Rhino.Geometry.SubD";
    const NAME: &'static str = "a SubD";

    fn from_json(json: &Json) -> Result<Self, Fault> {
        match parsed(json).map_err(no::<Self>)? {
            Object::SubD(object) => object.to_subd().map(Self).map_err(no::<Self>),
            other => Err(no::<Self>(found(&other))),
        }
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        encode_object(&Object::SubD(Box::new(SubDObject::from(&self.0))).into(), archive)
    }
}

impl Wire for GeometryBase {
    const TYPE: &'static str = "Rhino.Geometry.GeometryBase";
    const NAME: &'static str = "geometry";

    /// An object of any class, or what a curve or a point can be read from.
    fn from_json(json: &Json) -> Result<Self, Fault> {
        if !is_object_form(json) {
            if let Ok(point) = Point3::from_json(json) {
                return Ok(Self::Point(point));
            }
            if let Ok(curve) = Curve::from_json(json) {
                return Ok(Self::Curve(curve));
            }
        }
        let object = parsed(json).map_err(no::<Self>)?;
        if let Some(curve) = curve_of(&object) {
            return Ok(Self::Curve(curve));
        }
        Ok(match object {
            Object::Point(point) => Self::Point(point),
            Object::Mesh(mesh) => Self::Mesh(made_of(mesh.to_mesh())?),
            Object::SubD(subd) => Self::SubD(Subdivision(made_of(subd.to_subd())?)),
            Object::Surface(surface) => Self::Surface(surface),
            object => match brep_of(object) {
                Ok(brep) => Self::Brep(brep?),
                Err(other) => Self::Other(other),
            },
        })
    }

    fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        match self {
            Self::Point(point) => encode_object(&Object::Point(*point).into(), archive),
            Self::Curve(curve) => curve.to_json(archive),
            Self::Surface(surface) => surface.to_json(archive),
            Self::Brep(brep) => brep.to_json(archive),
            Self::Mesh(mesh) => mesh.to_json(archive),
            Self::SubD(subd) => subd.to_json(archive),
            Self::Other(object) => encode_object(&ModelObject::from((**object).clone()), archive),
        }
    }
}

fn made_of<T>(value: katydid_geometry::Result<T>) -> Result<T, Fault> {
    value.map_err(no::<GeometryBase>)
}
