//! Geometry as scripts hold it: by a number, while the geometry itself stays here.

use std::sync::Arc;

use katydid_3dm::{BrepObject, MeshObject, Object, SubDObject};
use katydid_geometry::subd::SubD;
use katydid_geometry::{Brep, Curve, Mesh, Point3, Surface};
use serde_json::Value as Json;

use crate::unfinished::UnfinishedNurbs;
use crate::unfinished_surface::UnfinishedSurface;
use crate::user_strings::UserStrings;
use crate::value::Value;
use crate::wire::{curve_type, encode_object, surface_type, type_name};
use crate::{Fault, wire};

/// Geometry of a value: what it is, and under which number the script knows it.
#[derive(Debug, Clone, PartialEq)]
pub struct Geometry {
    /// The number; 0 before the script has got it.
    pub id: u64,
    /// What it is.
    pub shape: Shape,
    /// The texts that it carries.
    pub strings: UserStrings,
}

impl Geometry {
    /// Becomes what a member made of it. It keeps the texts, unless that brings its own.
    pub fn become_changed(&mut self, changed: Self) {
        self.shape = changed.shape;
        if changed.strings.is_known() {
            self.strings = changed.strings;
        }
    }
}

impl From<Shape> for Geometry {
    /// That a script has not got yet, without texts.
    fn from(shape: Shape) -> Self {
        Self { id: 0, shape, strings: UserStrings::default() }
    }
}

/// What a number stands for. Copies share it.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// A point as an object.
    Point(Point3),
    /// A curve.
    Curve(Arc<Curve>),
    /// A surface.
    Surface(Arc<Surface>),
    /// A Brep.
    Brep(Arc<Brep>),
    /// A face of a Brep, by its place.
    Face(Arc<Brep>, usize),
    /// An edge of a Brep, by its place.
    Edge(Arc<Brep>, usize),
    /// A mesh.
    Mesh(Arc<Mesh>),
    /// A subdivision surface.
    SubD(Arc<SubD>),
    /// A vertex, an edge or a face of a subdivision surface, by its place.
    SubDPart(Arc<SubD>, SubDPart, usize),
    /// Any other object of a model.
    Other(Arc<Object>),
    /// An object of a class that holds nothing yet, such as a `PolyCurve` without segments.
    Empty(&'static str),
    /// A NURBS curve whose points or knots are not all set yet.
    Unfinished(Arc<UnfinishedNurbs>),
    /// A NURBS surface whose points or knots are not all set yet.
    UnfinishedSurface(Arc<UnfinishedSurface>),
    /// One of the lists of an object, by the list's class and the object's number. A list that is handed over is its object.
    List(&'static str, u64),
    /// A result of several named values.
    Record(Arc<Record>),
}

/// A kind of parts of a subdivision surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SubDPart {
    /// A vertex of its control net.
    Vertex,
    /// An edge.
    Edge,
    /// A face.
    Face,
}

impl SubDPart {
    /// The class in RhinoCommon.
    pub const fn class(self) -> &'static str {
        match self {
            Self::Vertex => "SubDVertex",
            Self::Edge => "SubDEdge",
            Self::Face => "SubDFace",
        }
    }

    /// How many of them there are.
    pub(crate) fn count(self, subd: &SubD) -> usize {
        let net = subd.net();
        match self {
            Self::Vertex => net.vertices().len(),
            Self::Edge => net.edges().len(),
            Self::Face => net.faces().len(),
        }
    }

    /// The number that openNURBS knows one by; 0 where there is none.
    pub(crate) fn id(self, subd: &SubD, place: usize) -> usize {
        let net = subd.net();
        let id = match self {
            Self::Vertex => net.vertices().get(place).map(|own| own.id),
            Self::Edge => net.edges().get(place).map(|own| own.id),
            Self::Face => net.faces().get(place).map(|own| own.id),
        };
        id.and_then(|id| usize::try_from(id).ok()).unwrap_or(0)
    }
}

/// A result of several named values, such as `AreaMassProperties`.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// The class in RhinoCommon.
    pub class: &'static str,
    /// Its properties.
    pub fields: Vec<(&'static str, Value)>,
}

impl Record {
    /// A result, as a value.
    pub fn value(class: &'static str, fields: Vec<(&'static str, Value)>) -> Value {
        Shape::Record(Arc::new(Self { class, fields })).into()
    }

    /// A property.
    pub fn field(&self, name: &str) -> Option<&Value> {
        self.fields.iter().find_map(|(own, value)| (*own == name).then_some(value))
    }
}

impl Shape {
    /// The class in RhinoCommon.
    pub fn class(&self) -> &'static str {
        let name = match self {
            Self::Point(_) => "Point",
            Self::Curve(curve) => curve_type(curve),
            Self::Surface(surface) => surface_type(surface),
            Self::Brep(_) => "Brep",
            Self::Face(..) => "BrepFace",
            Self::Edge(..) => "BrepEdge",
            Self::Mesh(_) => "Mesh",
            Self::SubD(_) => "SubD",
            Self::Other(object) => type_name(object),
            Self::Empty(class) | Self::List(class, _) => class,
            Self::Unfinished(_) => "NurbsCurve",
            Self::UnfinishedSurface(_) => "NurbsSurface",
            Self::SubDPart(_, part, _) => part.class(),
            Self::Record(record) => record.class,
        };
        name.trim_start_matches("Rhino.Geometry.")
    }

    /// The curve that it is, or has.
    pub fn curve(&self) -> Option<Arc<Curve>> {
        match self {
            Self::Curve(curve) => Some(curve.clone()),
            Self::Edge(brep, place) => brep.edge_as_curve(*place).ok().flatten().map(Arc::new),
            Self::Other(object) => object.curve().map(|curve| Arc::new(curve.into_owned())),
            _ => None,
        }
    }

    /// The surface that it is, or lies on.
    pub fn surface(&self) -> Option<Arc<Surface>> {
        match self {
            Self::Surface(surface) => Some(surface.clone()),
            Self::Face(brep, place) => brep.face_surface(*place).map(|surface| Arc::new(surface.clone())),
            Self::Brep(brep) => brep.as_surface().map(|(surface, _)| Arc::new(surface.clone())),
            Self::Other(object) => object.surface().map(|surface| Arc::new(surface.into_owned())),
            _ => None,
        }
    }

    /// The Brep that it is, or that it makes.
    pub fn brep(&self) -> Option<Result<Arc<Brep>, Fault>> {
        Some(match self {
            Self::Brep(brep) => Ok(brep.clone()),
            Self::Surface(surface) => {
                Brep::from_surface((**surface).clone()).map(Arc::new).map_err(wire::no::<Brep>)
            }
            Self::Face(brep, place) => brep.sub_brep(&[*place]).map(Arc::new).map_err(wire::no::<Brep>),
            Self::Other(object) => match &**object {
                Object::Extrusion(extrusion) => extrusion
                    .to_brep()
                    .map(|made| Arc::new(made.brep))
                    .ok_or_else(|| wire::no::<Brep>("the extrusion is no sound one")),
                _ => return None,
            },
            _ => return None,
        })
    }

    /// The object of a model that it is.
    ///
    /// # Errors
    /// It is a result, which no model holds.
    pub fn object(&self) -> Result<Object, Fault> {
        Ok(match self {
            Self::Point(point) => Object::Point(*point),
            Self::Curve(curve) => Object::Curve((**curve).clone()),
            Self::Surface(surface) => Object::Surface((**surface).clone()),
            Self::Mesh(mesh) => Object::Mesh(Box::new(MeshObject::from(&**mesh))),
            Self::SubD(subd) => Object::SubD(Box::new(SubDObject::from(&**subd))),
            Self::Other(object) => (**object).clone(),
            Self::Edge(..) => match self.curve() {
                Some(curve) => Object::Curve((*curve).clone()),
                None => return Err(Fault::failed("the edge has no curve")),
            },
            Self::Brep(_) | Self::Face(..) => match self.brep() {
                Some(brep) => Object::Brep(Box::new(BrepObject::from((*brep?).clone()))),
                None => return Err(Fault::failed("the face has no surface")),
            },
            Self::Unfinished(_) => {
                return Err(Fault::bad_request("is a NurbsCurve whose knots do not rise yet"));
            }
            Self::UnfinishedSurface(_) => {
                return Err(Fault::bad_request("is a NurbsSurface whose knots do not rise yet"));
            }
            Self::Empty(_) | Self::List(..) | Self::Record(_) | Self::SubDPart(..) => {
                return Err(Fault::bad_request(format!("is a {}, which no model holds", self.class())));
            }
        })
    }

    /// As the server's JSON has it.
    pub(crate) fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        if let Self::Record(record) = self {
            let fields = record
                .fields
                .iter()
                .map(|(name, value)| value.to_json(archive).map(|json| ((*name).to_owned(), json)));
            return fields.collect::<Result<_, _>>().map(Json::Object);
        }
        encode_object(&self.object()?.into(), archive)
    }
}

impl From<Shape> for Value {
    fn from(shape: Shape) -> Self {
        Self::Geometry(shape.into())
    }
}
