//! Values of a script as data of a definition.

use std::collections::HashMap;
use std::sync::Arc;

use katydid_3dm::{Object, SubDObject};
use katydid_data::{DateTime, Domain2, ModelObject, Path, Token, Value as Data};
use katydid_geometry::{BoundingBox, Box3, Curve, MeshFace, Plane, PolylineCurve, Surface};
use katydid_members::{Geometry, Shape, Value};

use crate::keeper::{Keepers, Shown};

/// The kind of a value of tag error that stands for an object of a C# script, by its text.
pub(crate) const SHOWN: &str = "shown";

/// Turns values into data, and counts what could not be.
#[derive(Debug)]
pub(crate) struct Outward<'a> {
    pub(crate) keepers: &'a Keepers,
    /// How the script's language writes objects of its own, by their numbers.
    pub(crate) texts: &'a HashMap<u64, String>,
    /// What could not be taken over, each once.
    pub(crate) lost: Vec<String>,
}

impl Outward<'_> {
    /// An item; none for null and for what cannot be taken over.
    pub(crate) fn item(&mut self, value: &Value) -> Option<Data> {
        if *value == Value::Null {
            return None;
        }
        let data = self.known(value);
        if data.is_none() {
            let what = match value {
                Value::Geometry(geometry) => geometry.shape.class().to_owned(),
                other => other.noun().trim_start_matches("a ").trim_start_matches("an ").to_owned(),
            };
            let what = format!("{what} is not supported as a script's result");
            if !self.lost.contains(&what) {
                self.lost.push(what);
            }
        }
        data
    }

    fn known(&mut self, value: &Value) -> Option<Data> {
        Some(match value {
            Value::Bool(flag) => Data::Boolean(*flag),
            Value::Int(whole) | Value::Enum(_, whole) => match i32::try_from(*whole) {
                Ok(whole) => Data::Integer(whole),
                #[expect(clippy::cast_precision_loss, reason = "beyond 32 bits a number is what is left")]
                Err(_) => Data::Number(*whole as f64),
            },
            Value::Number(x) => Data::Number(*x),
            Value::Text(text) => Data::Text(text.as_str().into()),
            Value::Point(point) => Data::Point(*point),
            Value::Point2(point) => Data::Point(katydid_geometry::Point3::new(point.x, point.y, 0.0)),
            Value::Vector(vector) => Data::Vector(*vector),
            Value::Plane(plane) => Data::Plane(Arc::new(*plane)),
            Value::Line(line) => Data::Line(Arc::new(*line)),
            Value::Interval(interval) => Data::Domain(*interval),
            Value::Transform(xform) => Data::Transform(Arc::new(**xform)),
            Value::Circle(circle) => Data::Circle(Arc::new(**circle)),
            Value::Arc(arc) => Data::Arc(Arc::new(**arc)),
            Value::Ellipse(ellipse) => curve(ellipse.to_nurbs().ok()?),
            Value::Polyline(points) => curve(PolylineCurve::new(points.clone()).ok()?),
            Value::Rectangle(rectangle) => Data::Rectangle(Arc::new(**rectangle)),
            Value::BoundingBox(bounds) => Data::Box(Arc::new(boxed(bounds)?)),
            Value::Box(shape) => Data::Box(Arc::new(**shape)),
            Value::Sphere(sphere) => Data::from(Surface::from(sphere.to_revolution())),
            Value::Colour(colour) => Data::Colour(*colour),
            Value::Guid(id) => Data::Guid(*id),
            Value::Complex(z) => Data::Complex(*z),
            Value::Time(ticks) => Data::Time(DateTime { ticks: *ticks }),
            Value::Face(corners) => Data::MeshFace(face(*corners)?),
            Value::Path(path) => Data::Path(Path::from(path.as_slice())),
            Value::Map(_) => domain2(value)?,
            Value::Token(number) => {
                let text = self.texts.get(number).map(String::as_str);
                Token(self.keepers.kept(*number, text)).into()
            }
            Value::Error(kind, text) if kind == SHOWN => Token(Arc::new(Shown(text.clone()))).into(),
            Value::Geometry(geometry) => carrying(shape(&geometry.shape)?, geometry),
            _ => return None,
        })
    }
}

/// Geometry with the texts that it carries.
fn carrying(data: Data, geometry: &Geometry) -> Data {
    let pairs = geometry.strings.pairs().iter();
    let texts = pairs.map(|(key, text)| (key.as_str().into(), text.as_str().into())).collect();
    ModelObject::carrying(data, texts)
}

fn curve(curve: impl Into<Curve>) -> Data {
    Data::Curve(Arc::new(curve.into()))
}

fn boxed(bounds: &BoundingBox) -> Option<Box3> {
    Box3::around(&Plane::XY, [bounds.min, bounds.max])
}

fn face([a, b, c, d]: [i32; 4]) -> Option<MeshFace> {
    let index = |i: i32| u32::try_from(i).ok();
    let (a, b, c, d) = (index(a)?, index(b)?, index(c)?, index(d)?);
    Some(if c == d { MeshFace::Triangle([a, b, c]) } else { MeshFace::Quad([a, b, c, d]) })
}

fn domain2(map: &Value) -> Option<Data> {
    match (map.get("U"), map.get("V")) {
        (Some(Value::Interval(u)), Some(Value::Interval(v))) => {
            Some(Data::Domain2(Arc::new(Domain2 { u: *u, v: *v })))
        }
        _ => None,
    }
}

fn shape(shape: &Shape) -> Option<Data> {
    Some(match shape {
        Shape::Point(point) => Data::Point(*point),
        Shape::Curve(curve) => Data::Curve(curve.clone()),
        Shape::Edge(..) => Data::Curve(shape.curve()?),
        Shape::Surface(surface) => Data::Surface(surface.clone()),
        Shape::Brep(brep) => match brep.as_surface() {
            Some((surface, false)) => Data::from(surface.clone()),
            _ => Data::Brep(brep.clone()),
        },
        Shape::Face(..) => Data::Brep(shape.brep()?.ok()?),
        Shape::Mesh(mesh) => Data::Mesh(mesh.clone()),
        Shape::SubD(subd) => Data::from_object(Object::SubD(Box::new(SubDObject::from(&**subd))), &[])?,
        Shape::Other(object) => Data::from_object((**object).clone(), &[])?,
        Shape::Empty(_)
        | Shape::Unfinished(_)
        | Shape::UnfinishedSurface(_)
        | Shape::SubDPart(..)
        | Shape::List(..)
        | Shape::Record(_) => return None,
    })
}
