//! Bytes as values.

use katydid_data::{Colour, Complex};
use katydid_geometry::{
    Arc, BoundingBox, Box3, Circle, Ellipse, Interval, Line, Plane, Point2, Point3, Rectangle, Sphere,
    Vector3, Xform,
};
use uuid::Uuid;

use super::{DEEPEST, Error};
use crate::Handles;
use crate::shape::Shape;
use crate::value::Value;

/// The value that bytes are; geometry by the numbers that the script holds.
///
/// # Errors
/// The bytes are no value, or name geometry that is not held.
pub fn decode(bytes: &[u8], handles: &Handles) -> Result<Value, Error> {
    let mut bytes = Bytes { bytes, at: 0, handles, values: 0 };
    let value = bytes.value(0)?;
    if bytes.at < bytes.bytes.len() { Err(bytes.broken("bytes behind the value")) } else { Ok(value) }
}

struct Bytes<'a> {
    bytes: &'a [u8],
    at: usize,
    handles: &'a Handles,
    /// How many values have been read.
    values: usize,
}

/// The most values of a message: a value is larger here than its tag is there.
const MOST_VALUES: usize = 16_000_000;

type Read<T> = Result<T, Error>;

impl<'a> Bytes<'a> {
    fn broken(&self, what: impl Into<String>) -> Error {
        Error::Broken { at: self.at, what: what.into() }
    }

    fn take(&mut self, count: usize) -> Read<&'a [u8]> {
        let end = self.at.checked_add(count);
        match end.and_then(|end| self.bytes.get(self.at..end)) {
            Some(bytes) => {
                self.at += count;
                Ok(bytes)
            }
            None => Err(self.broken("the message ends within a value")),
        }
    }

    fn array<const N: usize>(&mut self) -> Read<[u8; N]> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(N)?);
        Ok(array)
    }

    /// A count of things of at least `size` bytes each: no more than there are bytes for.
    fn count(&mut self, size: usize) -> Read<usize> {
        let count = u32::from_le_bytes(self.array()?) as usize;
        if count.saturating_mul(size) > self.bytes.len() - self.at {
            return Err(self.broken(format!("{count} items, more than there are bytes for")));
        }
        Ok(count)
    }

    fn number(&mut self) -> Read<f64> {
        self.array().map(f64::from_le_bytes)
    }

    fn whole(&mut self) -> Read<i64> {
        self.array().map(i64::from_le_bytes)
    }

    fn short(&mut self) -> Read<i32> {
        self.array().map(i32::from_le_bytes)
    }

    fn id(&mut self) -> Read<u64> {
        self.array().map(u64::from_le_bytes)
    }

    fn text(&mut self) -> Read<String> {
        let count = self.count(1)?;
        let bytes = self.take(count)?;
        match std::str::from_utf8(bytes) {
            Ok(text) => Ok(text.to_owned()),
            Err(_) => Err(self.broken("text that is not UTF-8")),
        }
    }

    fn point(&mut self) -> Read<Point3> {
        Ok(Point3::new(self.number()?, self.number()?, self.number()?))
    }

    fn vector(&mut self) -> Read<Vector3> {
        Ok(Vector3::new(self.number()?, self.number()?, self.number()?))
    }

    fn plane(&mut self) -> Read<Plane> {
        Ok(Plane {
            origin: self.point()?,
            x_axis: self.vector()?,
            y_axis: self.vector()?,
            z_axis: self.vector()?,
        })
    }

    fn interval(&mut self) -> Read<Interval> {
        Ok(Interval::new(self.number()?, self.number()?))
    }

    fn list<T>(&mut self, size: usize, one: impl Fn(&mut Self) -> Read<T>) -> Read<Vec<T>> {
        let count = self.count(size)?;
        (0..count).map(|_| one(self)).collect()
    }

    fn path(&mut self) -> Read<Vec<i32>> {
        self.list(4, Self::short)
    }

    fn transform(&mut self) -> Read<Xform> {
        let mut rows = [[0.0; 4]; 4];
        for cell in rows.as_flattened_mut() {
            *cell = self.number()?;
        }
        Ok(Xform { rows })
    }

    fn value(&mut self, depth: usize) -> Read<Value> {
        if depth > DEEPEST {
            return Err(self.broken(format!("values nest deeper than {DEEPEST}")));
        }
        self.values += 1;
        if self.values > MOST_VALUES {
            return Err(self.broken(format!("more than {MOST_VALUES} values in one message")));
        }
        let [tag] = self.array()?;
        Ok(match tag {
            b'N' => Value::Null,
            b'T' => Value::Bool(true),
            b'F' => Value::Bool(false),
            b'i' => Value::Int(self.whole()?),
            b'd' => Value::Number(self.number()?),
            b's' => Value::Text(self.text()?),
            b'b' => Value::Bytes(self.list(1, |b| b.array().map(|[byte]| byte))?),
            b'l' => Value::List(self.list(1, |b| b.value(depth + 1))?),
            b'm' => Value::Map(self.list(2, |b| Ok((b.value(depth + 1)?, b.value(depth + 1)?)))?),
            b'D' => Value::Numbers(self.list(8, Self::number)?),
            b'J' => Value::Ints(self.list(8, Self::whole)?),
            b'P' => Value::Points(self.list(24, Self::point)?),
            b'W' => Value::Vectors(self.list(24, Self::vector)?),
            b'O' => Value::Polyline(self.list(24, Self::point)?),
            b'u' => Value::Path(self.path()?),
            b'U' => Value::Tree(self.list(8, |b| Ok((b.path()?, b.list(1, |b| b.value(depth + 1))?)))?),
            b'G' => self.geometry()?,
            b'y' => Value::Token(self.id()?),
            b'k' => Value::Enum(self.text()?, self.whole()?),
            b'E' => Value::Error(self.text()?, self.text()?),
            b't' => Value::Time(self.whole()?),
            b'g' => Value::Guid(Uuid::from_bytes(self.array()?)),
            b'f' => Value::Face([self.short()?, self.short()?, self.short()?, self.short()?]),
            b'C' => {
                let [a, r, g, b] = self.array()?;
                Value::Colour(Colour::argb(a, r, g, b))
            }
            other => self.structure(other)?,
        })
    }

    /// A struct of numbers alone.
    fn structure(&mut self, tag: u8) -> Read<Value> {
        Ok(match tag {
            b'p' => Value::Point(self.point()?),
            b'v' => Value::Vector(self.vector()?),
            b'2' => Value::Point2(Point2::new(self.number()?, self.number()?)),
            b'q' => Value::Plane(self.plane()?),
            b'n' => Value::Line(Line { from: self.point()?, to: self.point()? }),
            b'I' => Value::Interval(self.interval()?),
            b'X' => Value::Transform(Box::new(self.transform()?)),
            b'c' => Value::Circle(Box::new(Circle { plane: self.plane()?, radius: self.number()? })),
            b'e' => {
                let (plane, rx, ry) = (self.plane()?, self.number()?, self.number()?);
                Value::Ellipse(Box::new(Ellipse { plane, rx, ry }))
            }
            b'a' => {
                let circle = Circle { plane: self.plane()?, radius: self.number()? };
                Value::Arc(Box::new(Arc { circle, angle: self.interval()? }))
            }
            b'R' => {
                let (plane, x, y) = (self.plane()?, self.interval()?, self.interval()?);
                Value::Rectangle(Box::new(Rectangle { plane, x, y }))
            }
            b'B' => Value::BoundingBox(Box::new(BoundingBox { min: self.point()?, max: self.point()? })),
            b'x' => {
                let (plane, x, y) = (self.plane()?, self.interval()?, self.interval()?);
                Value::Box(Box::new(Box3 { plane, x, y, z: self.interval()? }))
            }
            b'S' => Value::Sphere(Box::new(Sphere { plane: self.plane()?, radius: self.number()? })),
            b'z' => Value::Complex(Complex { re: self.number()?, im: self.number()? }),
            other => return Err(self.broken(format!("the tag {other} is none"))),
        })
    }

    fn geometry(&mut self) -> Read<Value> {
        let id = self.id()?;
        let class = self.text()?;
        let id = match self.handles.get(id) {
            Some(Shape::List(_, of)) => *of,
            _ => id,
        };
        match self.handles.geometry(id) {
            Some(geometry) => Ok(Value::Geometry(geometry)),
            None => Err(self.broken(format!("the {class} {id} is not held any more"))),
        }
    }
}
