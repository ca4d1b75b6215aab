//! What scripts hand over and get back.

use katydid_data::{Colour, Complex};
use katydid_geometry::{
    Arc, BoundingBox, Box3, Circle, Ellipse, Interval, Line, Plane, Point2, Point3, Rectangle, Sphere,
    Vector3, Xform,
};
use serde_json::{Map, Value as Json};
use uuid::Uuid;

use crate::Fault;
use crate::shape::Geometry;
use crate::wire::{Wire, number};

/// A value that a script hands over or gets back. Structs are as the script has them: they may be invalid, and what
/// reads them says so.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// Nothing.
    Null,
    /// True or false.
    Bool(bool),
    /// A whole number.
    Int(i64),
    /// A number.
    Number(f64),
    /// Text.
    Text(String),
    /// Bytes.
    Bytes(Vec<u8>),
    /// A list of any values.
    List(Vec<Value>),
    /// Pairs of a key and a value, in order.
    Map(Vec<(Value, Value)>),
    /// A list of numbers.
    Numbers(Vec<f64>),
    /// A list of whole numbers.
    Ints(Vec<i64>),
    /// A list of points.
    Points(Vec<Point3>),
    /// A list of vectors.
    Vectors(Vec<Vector3>),
    /// A point in space.
    Point(Point3),
    /// A point in a plane.
    Point2(Point2),
    /// A vector.
    Vector(Vector3),
    /// A plane.
    Plane(Plane),
    /// A line from a point to a point.
    Line(Line),
    /// An interval; its order is kept.
    Interval(Interval),
    /// A transform.
    Transform(Box<Xform>),
    /// A circle.
    Circle(Box<Circle>),
    /// An ellipse.
    Ellipse(Box<Ellipse>),
    /// An arc.
    Arc(Box<Arc>),
    /// The points of a polyline.
    Polyline(Vec<Point3>),
    /// A rectangle.
    Rectangle(Box<Rectangle>),
    /// A bounding box.
    BoundingBox(Box<BoundingBox>),
    /// A box in a plane's directions.
    Box(Box<Box3>),
    /// A sphere.
    Sphere(Box<Sphere>),
    /// A colour.
    Colour(Colour),
    /// An identifier.
    Guid(Uuid),
    /// A complex number.
    Complex(Complex),
    /// A moment: 100 ns ticks since the first day of the year 1.
    Time(i64),
    /// A face of a mesh: its corners, the last twice in a triangle.
    Face([i32; 4]),
    /// A path of a data tree.
    Path(Vec<i32>),
    /// A data tree: paths, each with its items.
    Tree(Vec<(Vec<i32>, Vec<Value>)>),
    /// Geometry that stays here.
    Geometry(Geometry),
    /// An object of the script's own language, by its number there.
    Token(u64),
    /// A member of an enumeration: the name of the type and the number.
    Enum(String, i64),
    /// Something that went wrong: a kind and a message.
    Error(String, String),
}

impl Value {
    /// What messages call it, with its article.
    pub fn noun(&self) -> &'static str {
        match self {
            Self::Null => "null",
            Self::Bool(_) => "true or false",
            Self::Int(_) => "a whole number",
            Self::Number(_) => "a number",
            Self::Text(_) => "text",
            Self::Bytes(_) => "bytes",
            Self::List(_) | Self::Numbers(_) | Self::Ints(_) | Self::Points(_) | Self::Vectors(_) => "a list",
            Self::Map(_) => "a map",
            Self::Point(_) => "a Point3d",
            Self::Point2(_) => "a Point2d",
            Self::Vector(_) => "a Vector3d",
            Self::Plane(_) => "a Plane",
            Self::Line(_) => "a Line",
            Self::Interval(_) => "an Interval",
            Self::Transform(_) => "a Transform",
            Self::Circle(_) => "a Circle",
            Self::Ellipse(_) => "an Ellipse",
            Self::Arc(_) => "an Arc",
            Self::Polyline(_) => "a Polyline",
            Self::Rectangle(_) => "a Rectangle3d",
            Self::BoundingBox(_) => "a BoundingBox",
            Self::Box(_) => "a Box",
            Self::Sphere(_) => "a Sphere",
            Self::Colour(_) => "a colour",
            Self::Guid(_) => "a Guid",
            Self::Complex(_) => "a complex number",
            Self::Time(_) => "a date and time",
            Self::Face(_) => "a mesh face",
            Self::Path(_) => "a path",
            Self::Tree(_) => "a tree",
            Self::Geometry(_) => "geometry",
            Self::Token(_) => "an object of the script's own",
            Self::Enum(..) => "a member of an enumeration",
            Self::Error(..) => "an error",
        }
    }

    /// A list, in the narrowest form that holds its items.
    pub fn list(items: Vec<Self>) -> Self {
        macro_rules! column {
            ($($kind:ident => $column:ident),*) => {
                match items.first() {
                    $(Some(Self::$kind(_)) if items.iter().all(|item| matches!(item, Self::$kind(_))) => {
                        let held = items.into_iter().filter_map(|item| match item {
                            Self::$kind(held) => Some(held),
                            _ => None,
                        });
                        Self::$column(held.collect())
                    })*
                    _ => Self::List(items),
                }
            };
        }
        column!(Number => Numbers, Int => Ints, Point => Points, Vector => Vectors)
    }

    /// The items of any list, a column's too; `None` for what is no list.
    pub fn items(&self) -> Option<Vec<Self>> {
        Some(match self {
            Self::List(items) => items.clone(),
            Self::Numbers(column) => column.iter().copied().map(Self::Number).collect(),
            Self::Ints(column) => column.iter().copied().map(Self::Int).collect(),
            Self::Points(column) | Self::Polyline(column) => {
                column.iter().copied().map(Self::Point).collect()
            }
            Self::Vectors(column) => column.iter().copied().map(Self::Vector).collect(),
            _ => return None,
        })
    }

    /// The text that it is.
    pub fn as_text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The value of a key of a map.
    pub fn get(&self, key: &str) -> Option<&Self> {
        match self {
            Self::Map(pairs) => {
                pairs.iter().find_map(|(own, value)| (own.as_text() == Some(key)).then_some(value))
            }
            _ => None,
        }
    }

    /// A map of named values.
    pub fn map<const N: usize>(pairs: [(&str, Self); N]) -> Self {
        Self::Map(pairs.into_iter().map(|(key, value)| (Self::from(key), value)).collect())
    }

    /// As the server's JSON has it, so that what is read from JSON alone is read from values too.
    ///
    /// # Errors
    /// It has no JSON form.
    pub fn to_json(&self, archive: i32) -> Result<Json, Fault> {
        let no_form = || Err(Fault::bad_request(format!("is {}", self.noun())));
        let list = |items: Vec<Self>| {
            items.iter().map(|item| item.to_json(archive)).collect::<Result<_, _>>().map(Json::Array)
        };
        match self {
            Self::Null => Ok(Json::Null),
            Self::Bool(flag) => Ok(Json::from(*flag)),
            Self::Int(whole) | Self::Enum(_, whole) => Ok(Json::from(*whole)),
            Self::Number(x) => Ok(number(*x)),
            Self::Text(text) => Ok(Json::from(text.as_str())),
            Self::Guid(id) => Ok(Json::from(id.to_string())),
            Self::Map(pairs) => {
                let mut map = Map::new();
                for (key, value) in pairs {
                    let Self::Text(key) = key else { return no_form() };
                    map.insert(key.clone(), value.to_json(archive)?);
                }
                Ok(Json::Object(map))
            }
            Self::Point(held) => held.to_json(archive),
            Self::Point2(held) => held.to_json(archive),
            Self::Vector(held) => held.to_json(archive),
            Self::Plane(held) => held.to_json(archive),
            Self::Line(held) => held.to_json(archive),
            Self::Interval(held) => held.to_json(archive),
            Self::Transform(held) => held.to_json(archive),
            Self::Circle(held) => held.to_json(archive),
            Self::Ellipse(held) => held.to_json(archive),
            Self::Arc(held) => held.to_json(archive),
            Self::Rectangle(held) => held.to_json(archive),
            Self::BoundingBox(held) => held.to_json(archive),
            Self::Box(held) => held.to_json(archive),
            Self::Sphere(held) => held.to_json(archive),
            Self::Colour(held) => held.to_json(archive),
            Self::Geometry(geometry) => geometry.shape.to_json(archive),
            _ => match self.items() {
                Some(items) => list(items),
                None => no_form(),
            },
        }
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

/// JSON that a function gives as it is.
impl From<Json> for Value {
    fn from(json: Json) -> Self {
        match json {
            Json::Null => Self::Null,
            Json::Bool(flag) => Self::Bool(flag),
            Json::Number(number) => match number.as_i64() {
                Some(whole) => Self::Int(whole),
                None => Self::Number(number.as_f64().unwrap_or(f64::NAN)),
            },
            Json::String(text) => Self::Text(text),
            Json::Array(items) => Self::list(items.into_iter().map(Self::from).collect()),
            Json::Object(map) => {
                Self::Map(map.into_iter().map(|(key, value)| (Self::Text(key), value.into())).collect())
            }
        }
    }
}
