//! Values as bytes.

use katydid_geometry::{Interval, Plane, Point3, Vector3};

use crate::value::Value;
use crate::{Fault, Handles};

/// The bytes of a value. Geometry that has no number yet gets one.
///
/// # Errors
/// A list is longer than 32 bits say, or the script holds too much.
pub fn encode(value: &Value, handles: &mut Handles) -> Result<Vec<u8>, Fault> {
    let mut out = Out { bytes: Vec::new(), handles };
    out.value(value)?;
    Ok(out.bytes)
}

struct Out<'a> {
    bytes: Vec<u8>,
    handles: &'a mut Handles,
}

impl Out<'_> {
    fn count(&mut self, count: usize) -> Result<(), Fault> {
        let count = u32::try_from(count).map_err(|_| Fault::too_large("a list of more than 32 bits"))?;
        self.bytes.extend(count.to_le_bytes());
        Ok(())
    }

    fn text(&mut self, text: &str) -> Result<(), Fault> {
        self.count(text.len())?;
        self.bytes.extend(text.as_bytes());
        Ok(())
    }

    fn numbers(&mut self, numbers: &[f64]) {
        self.bytes.extend(numbers.iter().flat_map(|x| x.to_le_bytes()));
    }

    fn point(&mut self, p: &Point3) {
        self.numbers(&[p.x, p.y, p.z]);
    }

    fn vector(&mut self, v: &Vector3) {
        self.numbers(&[v.x, v.y, v.z]);
    }

    fn plane(&mut self, plane: &Plane) {
        self.point(&plane.origin);
        [plane.x_axis, plane.y_axis, plane.z_axis].iter().for_each(|axis| self.vector(axis));
    }

    fn intervals(&mut self, intervals: &[Interval]) {
        intervals.iter().for_each(|i| self.numbers(&[i.start, i.end]));
    }

    fn path(&mut self, path: &[i32]) -> Result<(), Fault> {
        self.count(path.len())?;
        self.bytes.extend(path.iter().flat_map(|i| i.to_le_bytes()));
        Ok(())
    }

    fn values(&mut self, values: &[Value]) -> Result<(), Fault> {
        self.count(values.len())?;
        values.iter().try_for_each(|value| self.value(value))
    }

    fn value(&mut self, value: &Value) -> Result<(), Fault> {
        self.bytes.push(tag(value));
        match value {
            Value::Null | Value::Bool(_) => {}
            Value::Int(whole) | Value::Time(whole) => self.bytes.extend(whole.to_le_bytes()),
            Value::Number(x) => self.numbers(&[*x]),
            Value::Text(text) => self.text(text)?,
            Value::Bytes(bytes) => {
                self.count(bytes.len())?;
                self.bytes.extend(bytes);
            }
            Value::List(items) => self.values(items)?,
            Value::Map(pairs) => {
                self.count(pairs.len())?;
                for (key, value) in pairs {
                    self.value(key)?;
                    self.value(value)?;
                }
            }
            Value::Numbers(column) => {
                self.count(column.len())?;
                self.numbers(column);
            }
            Value::Ints(column) => {
                self.count(column.len())?;
                self.bytes.extend(column.iter().flat_map(|whole| whole.to_le_bytes()));
            }
            Value::Points(column) | Value::Polyline(column) => {
                self.count(column.len())?;
                column.iter().for_each(|point| self.point(point));
            }
            Value::Vectors(column) => {
                self.count(column.len())?;
                column.iter().for_each(|vector| self.vector(vector));
            }
            Value::Point(point) => self.point(point),
            Value::Point2(point) => self.numbers(&[point.x, point.y]),
            Value::Vector(vector) => self.vector(vector),
            Value::Plane(plane) => self.plane(plane),
            Value::Line(line) => {
                self.point(&line.from);
                self.point(&line.to);
            }
            Value::Interval(interval) => self.intervals(&[*interval]),
            Value::Transform(xform) => self.numbers(xform.rows.as_flattened()),
            Value::Circle(circle) => {
                self.plane(&circle.plane);
                self.numbers(&[circle.radius]);
            }
            Value::Ellipse(ellipse) => {
                self.plane(&ellipse.plane);
                self.numbers(&[ellipse.rx, ellipse.ry]);
            }
            Value::Arc(arc) => {
                self.plane(&arc.circle.plane);
                self.numbers(&[arc.circle.radius]);
                self.intervals(&[arc.angle]);
            }
            Value::Rectangle(rectangle) => {
                self.plane(&rectangle.plane);
                self.intervals(&[rectangle.x, rectangle.y]);
            }
            Value::BoundingBox(bounds) => {
                self.point(&bounds.min);
                self.point(&bounds.max);
            }
            Value::Box(shape) => {
                self.plane(&shape.plane);
                self.intervals(&[shape.x, shape.y, shape.z]);
            }
            Value::Sphere(sphere) => {
                self.plane(&sphere.plane);
                self.numbers(&[sphere.radius]);
            }
            Value::Colour(colour) => self.bytes.extend([colour.a, colour.r, colour.g, colour.b]),
            Value::Guid(id) => self.bytes.extend(id.as_bytes()),
            Value::Complex(z) => self.numbers(&[z.re, z.im]),
            Value::Face(corners) => self.bytes.extend(corners.iter().flat_map(|i| i.to_le_bytes())),
            Value::Path(path) => self.path(path)?,
            Value::Tree(branches) => {
                self.count(branches.len())?;
                for (path, items) in branches {
                    self.path(path)?;
                    self.values(items)?;
                }
            }
            Value::Geometry(geometry) => {
                let id = match geometry.id {
                    0 => self.handles.add_geometry(geometry)?,
                    id => id,
                };
                self.bytes.extend(id.to_le_bytes());
                self.text(geometry.shape.class())?;
            }
            Value::Token(token) => self.bytes.extend(token.to_le_bytes()),
            Value::Enum(name, whole) => {
                self.text(name)?;
                self.bytes.extend(whole.to_le_bytes());
            }
            Value::Error(kind, message) => {
                self.text(kind)?;
                self.text(message)?;
            }
        }
        Ok(())
    }
}

fn tag(value: &Value) -> u8 {
    match value {
        Value::Null => b'N',
        Value::Bool(true) => b'T',
        Value::Bool(false) => b'F',
        Value::Int(_) => b'i',
        Value::Number(_) => b'd',
        Value::Text(_) => b's',
        Value::Bytes(_) => b'b',
        Value::List(_) => b'l',
        Value::Map(_) => b'm',
        Value::Numbers(_) => b'D',
        Value::Ints(_) => b'J',
        Value::Points(_) => b'P',
        Value::Vectors(_) => b'W',
        Value::Point(_) => b'p',
        Value::Point2(_) => b'2',
        Value::Vector(_) => b'v',
        Value::Plane(_) => b'q',
        Value::Line(_) => b'n',
        Value::Interval(_) => b'I',
        Value::Transform(_) => b'X',
        Value::Circle(_) => b'c',
        Value::Ellipse(_) => b'e',
        Value::Arc(_) => b'a',
        Value::Polyline(_) => b'O',
        Value::Rectangle(_) => b'R',
        Value::BoundingBox(_) => b'B',
        Value::Box(_) => b'x',
        Value::Sphere(_) => b'S',
        Value::Colour(_) => b'C',
        Value::Guid(_) => b'g',
        Value::Complex(_) => b'z',
        Value::Time(_) => b't',
        Value::Face(_) => b'f',
        Value::Path(_) => b'u',
        Value::Tree(_) => b'U',
        Value::Geometry(_) => b'G',
        Value::Token(_) => b'y',
        Value::Enum(..) => b'k',
        Value::Error(..) => b'E',
    }
}
