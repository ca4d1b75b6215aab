//! Data of a definition as values of a script.

use std::sync::Arc;

use katydid_3dm::Limits;
use katydid_data::cast::{self, Rules};
use katydid_data::{Content, ModelObject, Value as Data};
use katydid_definition::document::TypeHint;
use katydid_geometry::Brep;
use katydid_members::{Shape, Value};

use crate::keeper::{Kept, Shown};

/// Turns data into values, and counts what could not be.
#[derive(Debug)]
pub(crate) struct Inward<'a> {
    pub(crate) rules: &'a Rules,
    /// The process that the values go to: objects of another one are not there.
    pub(crate) process: u64,
    /// What could not be handed over, each once.
    pub(crate) lost: Vec<String>,
}

impl Inward<'_> {
    /// A value, or null for what is missing or cannot be handed over.
    pub(crate) fn value(&mut self, item: Option<Data>, hint: TypeHint) -> Value {
        let Some(item) = item else { return Value::Null };
        let cast = match hint.kind {
            Some(kind) => cast::value(&item, kind, self.rules),
            None => Some(item.clone()),
        };
        let Some(cast) = cast else {
            let to = hint.kind.map_or(String::new(), |kind| kind.to_string());
            self.lose(format!("Data conversion failed from {} to {to}", item.kind()));
            return Value::Null;
        };
        match self.known(&cast, hint) {
            Some(value) => with_strings(value, &item),
            None => {
                self.lose(format!("{} is not supported as data of a script", item.kind()));
                Value::Null
            }
        }
    }

    fn lose(&mut self, what: String) {
        if !self.lost.contains(&what) {
            self.lost.push(what);
        }
    }

    fn known(&mut self, item: &Data, hint: TypeHint) -> Option<Value> {
        Some(match item {
            Data::Boolean(flag) => Value::Bool(*flag),
            Data::Integer(whole) => Value::Int((*whole).into()),
            Data::Number(x) => Value::Number(*x),
            Data::Complex(z) => Value::Complex(*z),
            Data::Text(text) => Value::Text(text.to_string()),
            Data::Colour(colour) => Value::Colour(*colour),
            Data::Time(moment) => Value::Time(moment.ticks),
            Data::Guid(id) => Value::Guid(*id),
            Data::Domain(domain) => Value::Interval(*domain),
            Data::Domain2(domain) => {
                Value::map([("U", Value::Interval(domain.u)), ("V", Value::Interval(domain.v))])
            }
            Data::Path(path) => Value::Path(path.elements().to_vec()),
            Data::Point(point) if hint.is("GeometryBase") => Shape::Point(*point).into(),
            Data::Point(point) => Value::Point(*point),
            Data::Vector(vector) => Value::Vector(*vector),
            Data::Plane(plane) => Value::Plane(**plane),
            Data::Line(line) => Value::Line(**line),
            Data::Circle(circle) => Value::Circle(Box::new(**circle)),
            Data::Arc(arc) => Value::Arc(Box::new(**arc)),
            Data::Rectangle(rectangle) => Value::Rectangle(Box::new(**rectangle)),
            Data::Box(shape) => Value::Box(Box::new(**shape)),
            Data::Transform(_) | Data::Compound(_) => Value::Transform(Box::new(item.as_transform()?)),
            Data::Curve(curve) if hint.is("Polyline") => Value::Polyline(curve.as_polyline()?),
            Data::Curve(curve) => Shape::Curve(curve.clone()).into(),
            Data::Surface(surface) if hint.is("Surface") => Shape::Surface(surface.clone()).into(),
            // Grasshopper hands a surface over as the Brep that it keeps it as.
            Data::Surface(surface) => {
                Shape::Brep(Arc::new(Brep::from_surface((**surface).clone()).ok()?)).into()
            }
            Data::Brep(brep) if hint.is("Surface") && brep.faces().len() == 1 => {
                Shape::Face(brep.clone(), 0).into()
            }
            Data::Brep(brep) => Shape::Brep(brep.clone()).into(),
            Data::Mesh(mesh) => Shape::Mesh(mesh.clone()).into(),
            Data::MeshFace(face) => face_value(face),
            Data::Kept(raw) => match item.brep() {
                Some(brep) => Shape::Brep(brep.ok()?).into(),
                None => Shape::Other(Arc::new(raw.parse(&Limits::default()).ok()?)).into(),
            },
            // Of an object of a model a script gets the geometry.
            Data::Content(content) => match &**content {
                Content::Object(ModelObject { geometry: Some(geometry), .. }) => {
                    self.known(geometry, hint)?
                }
                content => self.content(content)?,
            },
            _ => return None,
        })
    }

    fn content(&mut self, content: &Content) -> Option<Value> {
        match content {
            Content::Token(token) => {
                if token.0.as_any().is::<Shown>() {
                    self.lose("An object of a C# script is not supported as data of another script".into());
                    return Some(Value::Null);
                }
                let kept = token.0.as_any().downcast_ref::<Kept>()?;
                if kept.process() == self.process {
                    return Some(Value::Token(token.0.number()));
                }
                self.lose("The object was lost with the Python process that made it: solve again".into());
                Some(Value::Null)
            }
            _ => None,
        }
    }
}

/// Geometry with the texts that it carries, or that stand in its user data.
fn with_strings(value: Value, item: &Data) -> Value {
    let Value::Geometry(mut geometry) = value else { return value };
    let texts: Vec<(String, String)> = match item {
        Data::Kept(raw) => raw.user_data.iter().find_map(|data| data.strings().ok()?).unwrap_or_default(),
        item => item.carried_texts().iter().map(|(key, text)| (key.to_string(), text.to_string())).collect(),
    };
    if !texts.is_empty() {
        geometry.strings = texts.into_iter().collect();
    }
    Value::Geometry(geometry)
}

fn face_value(face: &katydid_geometry::MeshFace) -> Value {
    let corner = |i: u32| i32::try_from(i).unwrap_or(-1);
    let corners: Vec<i32> = face.indices().iter().map(|i| corner(*i)).collect();
    match *corners.as_slice() {
        [a, b, c] => Value::Face([a, b, c, c]),
        [a, b, c, d] => Value::Face([a, b, c, d]),
        _ => Value::Null,
    }
}
