//! Values of a C# program and values of the member table.

use katydid_csharp::sema::{Prim, Sema, Ty};
use katydid_csharp::vm::State;
use katydid_csharp::vm::heap::Obj;
use katydid_csharp::{Cx, Engine, Value as Net};
use katydid_geometry::{BoundingBox, Circle, Interval, Line, Plane, Point2, Point3, Vector3};
use katydid_members::{Shape, Value};

use super::declare::is_of_intersections;

const GEOMETRY: &str = "Rhino.Geometry";
/// How deep values stand in one another at most.
const DEPTH: usize = 64;

/// Where values are made: while a program runs, and before.
pub(super) trait Machine {
    fn state(&mut self) -> &mut State;
    fn sema(&mut self) -> &mut Sema;
    fn made(&mut self, ty: Ty, fields: &[Net]) -> Net;
}

impl Machine for Engine {
    fn state(&mut self) -> &mut State {
        Engine::state(self)
    }
    fn sema(&mut self) -> &mut Sema {
        Engine::sema(self)
    }
    fn made(&mut self, ty: Ty, fields: &[Net]) -> Net {
        self.instance(ty, fields)
    }
}

impl Machine for Cx<'_> {
    fn state(&mut self) -> &mut State {
        self.st
    }
    fn sema(&mut self) -> &mut Sema {
        Cx::sema(self)
    }
    fn made(&mut self, ty: Ty, fields: &[Net]) -> Net {
        self.instance(ty, fields)
    }
}

fn named(m: &mut impl Machine, namespace: &str, name: &str) -> Option<Ty> {
    let def = m.sema().library(namespace, name, 0)?;
    Some(m.sema().named(def, &[]))
}

/// A list of that element type.
pub(super) fn list(m: &mut impl Machine, element: Ty, items: Vec<Net>) -> Option<Net> {
    let def = m.sema().library("System.Collections.Generic", "List", 1)?;
    let ty = m.sema().named(def, &[element]);
    Some(Net::Ref(m.state().heap.add(Obj::List(ty, items, 0))))
}

fn array(m: &mut impl Machine, element: Ty, items: Vec<Net>) -> Net {
    let ty = m.sema().array(element, 1);
    Net::Ref(m.state().heap.add(Obj::Array(ty, items, None)))
}

/// A struct of Rhino.Geometry by its fields.
fn of_fields(m: &mut impl Machine, name: &str, fields: &[Net]) -> Option<Net> {
    let ty = named(m, GEOMETRY, name)?;
    Some(m.made(ty, fields))
}

fn point(m: &mut impl Machine, p: Point3) -> Option<Net> {
    of_fields(m, "Point3d", &[p.x, p.y, p.z].map(Net::F64))
}

fn vector(m: &mut impl Machine, v: Vector3) -> Option<Net> {
    of_fields(m, "Vector3d", &[v.x, v.y, v.z].map(Net::F64))
}

fn plane(m: &mut impl Machine, own: &Plane) -> Option<Net> {
    let fields =
        [point(m, own.origin)?, vector(m, own.x_axis)?, vector(m, own.y_axis)?, vector(m, own.z_axis)?];
    of_fields(m, "Plane", &fields)
}

/// The value as a program has it; none for what it has no type for.
pub(super) fn to_csharp(m: &mut impl Machine, value: &Value) -> Option<Net> {
    Some(match value {
        Value::Null => Net::Null,
        Value::Bool(flag) => Net::Bool(*flag),
        Value::Int(whole) => i32::try_from(*whole).map_or(Net::I64(*whole), Net::I32),
        Value::Number(x) => Net::F64(*x),
        Value::Text(text) => m.state().text(text),
        Value::Point(p) => point(m, *p)?,
        Value::Vector(v) => vector(m, *v)?,
        Value::Point2(p) => of_fields(m, "Point2d", &[p.x, p.y].map(Net::F64))?,
        Value::Interval(i) => of_fields(m, "Interval", &[i.start, i.end].map(Net::F64))?,
        Value::Plane(own) => plane(m, own)?,
        Value::Line(line) => {
            let ends = [point(m, line.from)?, point(m, line.to)?];
            of_fields(m, "Line", &ends)?
        }
        Value::BoundingBox(bounds) => {
            let corners = [point(m, bounds.min)?, point(m, bounds.max)?];
            of_fields(m, "BoundingBox", &corners)?
        }
        Value::Circle(circle) => {
            let fields = [plane(m, &circle.plane)?, Net::F64(circle.radius)];
            of_fields(m, "Circle", &fields)?
        }
        Value::Polyline(points) => {
            let points = points.iter().map(|p| point(m, *p)).collect::<Option<Vec<_>>>()?;
            let element = named(m, GEOMETRY, "Point3d")?;
            let points = list(m, element, points)?;
            of_fields(m, "Polyline", &[points])?
        }
        Value::Geometry(geometry) => shape(m, &geometry.shape)?,
        other => {
            let items = other.items()?;
            let element = element_type(m, items.first())?;
            let items = items.iter().map(|item| to_csharp(m, item)).collect::<Option<Vec<_>>>()?;
            array(m, element, items)
        }
    })
}

fn shape(m: &mut impl Machine, shape: &Shape) -> Option<Net> {
    let class = shape.class();
    let namespace = if is_of_intersections(class) { "Rhino.Geometry.Intersect" } else { GEOMETRY };
    let ty = named(m, namespace, class).or_else(|| named(m, GEOMETRY, "GeometryBase"))?;
    Some(Net::Ref(m.state().heap.add(Obj::Host(ty, Box::new(shape.clone())))))
}

/// The type of an array's elements, by the first.
fn element_type(m: &mut impl Machine, first: Option<&Value>) -> Option<Ty> {
    let known = m.sema().known;
    Some(match first {
        Some(Value::Number(_)) => known.double,
        Some(Value::Int(_)) => known.int,
        Some(Value::Bool(_)) => known.bool,
        Some(Value::Text(_)) => known.string,
        Some(Value::Point(_)) => named(m, GEOMETRY, "Point3d")?,
        Some(Value::Vector(_)) => named(m, GEOMETRY, "Vector3d")?,
        Some(Value::Plane(_)) => named(m, GEOMETRY, "Plane")?,
        Some(Value::Line(_)) => named(m, GEOMETRY, "Line")?,
        Some(Value::Geometry(geometry)) => match &geometry.shape {
            Shape::Curve(_) | Shape::Edge(..) => named(m, GEOMETRY, "Curve")?,
            Shape::Brep(_) => named(m, GEOMETRY, "Brep")?,
            Shape::Surface(_) | Shape::Face(..) => named(m, GEOMETRY, "Surface")?,
            Shape::Mesh(_) => named(m, GEOMETRY, "Mesh")?,
            _ => known.object,
        },
        _ => known.object,
    })
}

/// A number as the type that is asked for has it, and what is missing as its default.
pub(super) fn fitted(m: &mut impl Machine, value: Net, ty: Ty) -> Net {
    match (m.sema().prim(ty), value) {
        (Some(Prim::F64), Net::Null) => Net::F64(0.0),
        (Some(Prim::F64), value) => value.real().map_or(value, Net::F64),
        (Some(Prim::I32), Net::Null) => Net::I32(0),
        (Some(Prim::Bool), Net::Null) => Net::Bool(false),
        (None, Net::Null) if m.sema().is_struct(ty) => {
            let name = m.sema().full_name(ty);
            let zero = match name.rsplit('.').next() {
                Some("Point3d") => Value::Point(Point3::ORIGIN),
                Some("Vector3d") => Value::Vector(Vector3::new(0.0, 0.0, 0.0)),
                Some("Interval") => Value::Interval(Interval::new(0.0, 0.0)),
                Some("Line") => Value::Line(Line::new(Point3::ORIGIN, Point3::ORIGIN)),
                _ => Value::Plane(Plane::XY),
            };
            to_csharp(m, &zero).unwrap_or(Net::Null)
        }
        (_, value) => value,
    }
}

/// The value of the table; an error with the name of the type for what has no place there.
pub(super) fn from_csharp(m: &mut impl Machine, value: Net) -> Result<Value, String> {
    read(m, value, DEPTH)
}

fn read(m: &mut impl Machine, value: Net, depth: usize) -> Result<Value, String> {
    let Some(depth) = depth.checked_sub(1) else {
        return Err(format!("a value more than {DEPTH} deep"));
    };
    let handle = match value {
        Net::Null => return Ok(Value::Null),
        Net::Bool(flag) => return Ok(Value::Bool(flag)),
        Net::F32(_) | Net::F64(_) => return Ok(Value::Number(value.real().unwrap_or(f64::NAN))),
        Net::Char(unit) => return Ok(Value::Text(String::from_utf16_lossy(&[unit]))),
        Net::Ref(handle) => handle,
        other => {
            let whole = other.whole().and_then(|whole| i64::try_from(whole).ok());
            return whole.map(Value::Int).ok_or_else(|| "a reference".to_owned());
        }
    };
    let (ty, fields) = match m.state().heap.get(handle) {
        Obj::Str(units) => return Ok(Value::Text(String::from_utf16_lossy(units))),
        Obj::Array(_, items, None) | Obj::List(_, items, _) => {
            let items = items.clone();
            let items = items.into_iter().map(|item| read(m, item, depth)).collect::<Result<_, _>>()?;
            return Ok(Value::list(items));
        }
        Obj::Host(ty, data) => match data.downcast_ref::<Shape>() {
            Some(shape) => return Ok(shape.clone().into()),
            None => (*ty, Vec::new()),
        },
        Obj::Inst(ty, fields) => (*ty, fields.to_vec()),
        other => return Err(kind_of(other).to_owned()),
    };
    let name = m.sema().full_name(ty);
    let parts =
        |m: &mut _| fields.iter().map(|field| read(m, *field, depth)).collect::<Result<Vec<Value>, String>>();
    let start = name.split(['<', '`']).next().unwrap_or_default();
    Ok(match (start, fields.len()) {
        ("Grasshopper.DataTree", 2) => tree(parts(m)?),
        (start, _) if start.starts_with("Rhino.Geometry.") || start == "Grasshopper.Kernel.Data.GH_Path" => {
            structure(start.rsplit('.').next().unwrap_or_default(), &parts(m)?).ok_or(name)?
        }
        _ => return Err(name),
    })
}

fn kind_of(object: &Obj) -> &'static str {
    match object {
        Obj::Delegate(..) => "a delegate",
        Obj::Gen(_) => "an iterator",
        Obj::Array(..) => "an array of several dimensions",
        _ => "an object",
    }
}

/// A tree of its paths and its branches.
fn tree(parts: Vec<Value>) -> Value {
    let mut parts = parts.into_iter().map(|part| part.items().unwrap_or_default());
    let (paths, branches) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
    let path = |path: Value| if let Value::Path(path) = path { path } else { Vec::new() };
    let branches = branches.into_iter().map(|branch| branch.items().unwrap_or_default());
    Value::Tree(paths.into_iter().map(path).zip(branches).collect())
}

/// A struct of its fields.
fn structure(name: &str, parts: &[Value]) -> Option<Value> {
    Some(match (name, parts) {
        ("Point3d", [Value::Number(x), Value::Number(y), Value::Number(z)]) => {
            Value::Point(Point3::new(*x, *y, *z))
        }
        ("Vector3d", [Value::Number(x), Value::Number(y), Value::Number(z)]) => {
            Value::Vector(Vector3::new(*x, *y, *z))
        }
        ("Point2d", [Value::Number(x), Value::Number(y)]) => Value::Point2(Point2::new(*x, *y)),
        ("Interval", [Value::Number(a), Value::Number(b)]) => Value::Interval(Interval::new(*a, *b)),
        ("Plane", [Value::Point(origin), Value::Vector(x), Value::Vector(y), Value::Vector(z)]) => {
            Value::Plane(Plane { origin: *origin, x_axis: *x, y_axis: *y, z_axis: *z })
        }
        ("Line", [Value::Point(from), Value::Point(to)]) => Value::Line(Line::new(*from, *to)),
        ("BoundingBox", [Value::Point(min), Value::Point(max)]) => {
            Value::BoundingBox(Box::new(BoundingBox { min: *min, max: *max }))
        }
        ("Circle", [Value::Plane(plane), Value::Number(radius)]) => {
            Value::Circle(Box::new(Circle { plane: *plane, radius: *radius }))
        }
        ("Polyline", [points]) => {
            let points = points.items()?;
            let point = |value: Value| if let Value::Point(p) = value { Some(p) } else { None };
            Value::Polyline(points.into_iter().map(point).collect::<Option<_>>()?)
        }
        ("GH_Path", [indices]) => {
            let index = |value: Value| if let Value::Int(i) = value { i32::try_from(i).ok() } else { None };
            Value::Path(indices.items()?.into_iter().map(index).collect::<Option<_>>()?)
        }
        _ => return None,
    })
}
