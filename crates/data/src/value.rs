use std::sync::Arc as Shared;

use katydid_3dm::{Limits, Object, RawObject, UserData};
use katydid_geometry::{
    Arc, Box3, Brep, Circle, Curve, Field, Interval, Line, Matrix, Mesh, MeshFace, Plane, Point3, Rectangle,
    Surface, TwistedBox, Vector3, Xform,
};
use uuid::Uuid;

use crate::{
    Colour, Complex, Compound, Content, DateTime, Domain2, Group, Kind, Location, LoftOptions, Material,
    MeshSettings, Path, Projection, QuadSettings, Symbol,
};

/// The archive version whose rules the bytes of kept objects follow.
const NEWEST: i32 = 80;

/// One item of data of any type. Large contents are shared: a clone costs a counter.
///
/// There is no null here: a place without a value is `Option<Value>::None`.
#[derive(Debug, Clone, PartialEq)]
#[expect(missing_docs, reason = "each variant is the Kind of the same name")]
pub enum Value {
    Boolean(bool),
    Integer(i32),
    Number(f64),
    Complex(Complex),
    Text(Shared<str>),
    Colour(Colour),
    Time(DateTime),
    Guid(Uuid),
    Domain(Interval),
    Domain2(Shared<Domain2>),
    Path(Path),
    Point(Point3),
    Vector(Vector3),
    Plane(Shared<Plane>),
    Line(Shared<Line>),
    Circle(Shared<Circle>),
    Arc(Shared<Arc>),
    Rectangle(Shared<Rectangle>),
    Box(Shared<Box3>),
    TwistedBox(Shared<TwistedBox>),
    Curve(Shared<Curve>),
    Surface(Shared<Surface>),
    Brep(Shared<Brep>),
    Mesh(Shared<Mesh>),
    MeshFace(MeshFace),
    Transform(Shared<Xform>),
    Compound(Shared<Compound>),
    Matrix(Shared<Matrix>),
    Field(Shared<Field>),
    Location(Location),
    Symbol(Shared<Symbol>),
    Material(Shared<Material>),
    LoftOptions(Shared<LoftOptions>),
    MeshSettings(Shared<MeshSettings>),
    QuadSettings(Shared<QuadSettings>),
    Projection(Shared<Projection>),
    Group(Shared<Group>),
    Kept(Shared<RawObject>),
    Content(Shared<Content>),
}

impl Value {
    /// The type of this value.
    pub fn kind(&self) -> Kind {
        match self {
            Self::Boolean(_) => Kind::Boolean,
            Self::Integer(_) => Kind::Integer,
            Self::Number(_) => Kind::Number,
            Self::Complex(_) => Kind::Complex,
            Self::Text(_) => Kind::Text,
            Self::Colour(_) => Kind::Colour,
            Self::Time(_) => Kind::Time,
            Self::Guid(_) => Kind::Guid,
            Self::Domain(_) => Kind::Domain,
            Self::Domain2(_) => Kind::Domain2,
            Self::Path(_) => Kind::Path,
            Self::Point(_) => Kind::Point,
            Self::Vector(_) => Kind::Vector,
            Self::Plane(_) => Kind::Plane,
            Self::Line(_) => Kind::Line,
            Self::Circle(_) => Kind::Circle,
            Self::Arc(_) => Kind::Arc,
            Self::Rectangle(_) => Kind::Rectangle,
            Self::Box(_) => Kind::Box,
            Self::TwistedBox(_) => Kind::TwistedBox,
            Self::Curve(_) => Kind::Curve,
            Self::Surface(_) => Kind::Surface,
            Self::Brep(_) => Kind::Brep,
            Self::Mesh(_) => Kind::Mesh,
            Self::MeshFace(_) => Kind::MeshFace,
            Self::Transform(_) => Kind::Transform,
            Self::Compound(_) => Kind::Compound,
            Self::Matrix(_) => Kind::Matrix,
            Self::Field(_) => Kind::Field,
            Self::Location(_) => Kind::Location,
            Self::Symbol(_) => Kind::Symbol,
            Self::Material(_) => Kind::Material,
            Self::LoftOptions(_) => Kind::LoftOptions,
            Self::MeshSettings(_) => Kind::MeshSettings,
            Self::QuadSettings(_) => Kind::QuadSettings,
            Self::Projection(_) => Kind::Projection,
            Self::Group(_) => Kind::Group,
            Self::Kept(_) => Kind::Kept,
            Self::Content(_) => Kind::Content,
        }
    }

    /// The texts that geometry carries itself; none for other values, and for geometry without any.
    pub fn carried_texts(&self) -> &[(Shared<str>, Shared<str>)] {
        match self {
            Self::Content(content) => match &**content {
                Content::Object(object) => &object.geometry_text,
                _ => &[],
            },
            _ => &[],
        }
    }

    /// The transform, single or compound; `None` for a value of another type.
    pub fn as_transform(&self) -> Option<Xform> {
        match self {
            Self::Transform(x) => Some(**x),
            Self::Compound(c) => Some(c.whole()),
            _ => None,
        }
    }

    /// An object of a Rhino model, with its user data; `None` for a class that no value holds.
    ///
    /// A brep of one face that has no trims is a surface; other classes that are not computed with are kept whole.
    pub fn from_object(object: Object, user_data: &[UserData]) -> Option<Self> {
        match object {
            Object::Point(p) => Some(Self::Point(p)),
            Object::Curve(curve) => Some(Self::from(curve)),
            Object::Surface(surface) => Some(Self::from(surface)),
            Object::Mesh(mesh) => match mesh.to_mesh() {
                Ok(mesh) => Some(Self::from(mesh)),
                Err(_) => Object::Mesh(mesh).to_raw(NEWEST, user_data).ok().map(Self::from),
            },
            Object::Kept(raw) => Some(match raw.untrimmed_surface() {
                Ok(Some(surface)) => Self::from(surface),
                _ => Self::from(raw),
            }),
            other => {
                other.curve().map(|curve| Self::from(curve.into_owned())).or_else(|| match other.surface() {
                    Some(surface) => Some(Self::from(surface.into_owned())),
                    None => other.to_raw(NEWEST, user_data).ok().map(Self::from),
                })
            }
        }
    }

    /// An object on its own, as it came.
    ///
    /// # Errors
    /// The bytes are broken, or hold numbers that no curve, surface or mesh has.
    pub fn from_raw(raw: RawObject) -> Result<Option<Self>, katydid_3dm::Error> {
        Ok(match raw.parse_shape(&Limits::default())? {
            object @ (Object::Brep(_) | Object::Extrusion(_)) => {
                Some(object.surface().map_or_else(|| Self::from(raw), |s| Self::from(s.into_owned())))
            }
            object => match Self::from_object(object, &raw.user_data) {
                // What is not computed with stays as it came, user data and all.
                Some(Self::Kept(_)) | None => Some(Self::from(raw)),
                value => value,
            },
        })
    }

    /// Where shared geometry lies in memory: the same for clones of one value, and for nothing else while they live.
    /// None for values that are not shared.
    pub fn address(&self) -> Option<usize> {
        Some(match self {
            Self::Curve(c) => Shared::as_ptr(c).addr(),
            Self::Surface(s) => Shared::as_ptr(s).addr(),
            Self::Brep(b) => Shared::as_ptr(b).addr(),
            Self::Mesh(m) => Shared::as_ptr(m).addr(),
            Self::Kept(k) => Shared::as_ptr(k).addr(),
            Self::Content(c) => Shared::as_ptr(c).addr(),
            _ => return None,
        })
    }

    /// A text value.
    pub fn text(text: impl Into<Shared<str>>) -> Self {
        Self::Text(text.into())
    }
}

macro_rules! from {
    ($($type:ty, $variant:ident;)*) => {
        $(impl From<$type> for Value {
            fn from(value: $type) -> Self {
                Self::$variant(value.into())
            }
        })*
    };
}

from! {
    bool, Boolean;
    i32, Integer;
    f64, Number;
    Complex, Complex;
    &str, Text;
    String, Text;
    Shared<str>, Text;
    Colour, Colour;
    DateTime, Time;
    Uuid, Guid;
    Interval, Domain;
    Domain2, Domain2;
    Path, Path;
    Point3, Point;
    Vector3, Vector;
    Plane, Plane;
    Line, Line;
    Circle, Circle;
    Arc, Arc;
    Rectangle, Rectangle;
    Box3, Box;
    TwistedBox, TwistedBox;
    Curve, Curve;
    Shared<Curve>, Curve;
    Surface, Surface;
    Shared<Surface>, Surface;
    Shared<Brep>, Brep;
    Mesh, Mesh;
    Shared<Mesh>, Mesh;
    MeshFace, MeshFace;
    Xform, Transform;
    Compound, Compound;
    Shared<Compound>, Compound;
    Matrix, Matrix;
    Shared<Matrix>, Matrix;
    Field, Field;
    Shared<Field>, Field;
    Location, Location;
    Symbol, Symbol;
    Shared<Symbol>, Symbol;
    Material, Material;
    LoftOptions, LoftOptions;
    MeshSettings, MeshSettings;
    QuadSettings, QuadSettings;
    Projection, Projection;
    Group, Group;
    Shared<Group>, Group;
    RawObject, Kept;
    Shared<RawObject>, Kept;
    Content, Content;
    Shared<Content>, Content;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_stays_small() {
        // Columns of mixed values hold millions of these.
        assert!(size_of::<Value>() <= 32);
    }
}
