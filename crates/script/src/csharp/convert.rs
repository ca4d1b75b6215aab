//! Values of a C# program and values of the member table.

use katydid_csharp::sema::{Prim, Sema, Ty};
use katydid_csharp::vm::State;
use katydid_csharp::vm::heap::Obj;
use katydid_csharp::{Cx, Engine, Value as Net};
use katydid_members::{Geometry, Shape, Value};

use super::declare::namespace;
use super::structs;

pub(super) const GEOMETRY: &str = "Rhino.Geometry";
/// How deep values stand in one another at most.
const DEPTH: usize = 64;

/// Where values are made: while a program runs, and before.
pub(super) trait Machine {
    fn state(&mut self) -> &mut State;
    fn sema(&mut self) -> &mut Sema;
    fn made(&mut self, ty: Ty, fields: &[Net]) -> Net;
    /// A struct whose fields are all zero.
    fn zero(&mut self, ty: Ty) -> Net;
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
    fn zero(&mut self, ty: Ty) -> Net {
        self.default_of(ty)
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
    fn zero(&mut self, ty: Ty) -> Net {
        self.default_of(ty)
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
    Some(Net::Ref(m.state().heap.add(Obj::List(ty, items.into(), 0))))
}

fn array(m: &mut impl Machine, element: Ty, items: Vec<Net>) -> Net {
    let ty = m.sema().array(element, 1);
    Net::Ref(m.state().heap.add(Obj::Array(ty, items.into(), None)))
}

/// The value as a program has it; none for what it has no type for.
pub(super) fn to_csharp(m: &mut impl Machine, value: &Value) -> Option<Net> {
    Some(match value {
        Value::Null => Net::Null,
        Value::Bool(flag) => Net::Bool(*flag),
        Value::Int(whole) | Value::Enum(_, whole) => i32::try_from(*whole).map_or(Net::I64(*whole), Net::I32),
        Value::Number(x) => Net::F64(*x),
        Value::Text(text) => m.state().text(text),
        Value::Geometry(own) => geometry(m, own)?,
        Value::Map(pairs) => pairs_of_texts(m, pairs)?,
        Value::Path(indices) => {
            let int = m.sema().known.int;
            let indices = indices.iter().map(|i| Net::I32(*i)).collect();
            let indices = array(m, int, indices);
            let ty = named(m, "Grasshopper.Kernel.Data", "GH_Path")?;
            m.made(ty, &[indices])
        }
        Value::Colour(c) => {
            let argb = u32::from_be_bytes([c.a, c.r, c.g, c.b]);
            with_fields(m, "System.Drawing", "Color", &[(0, Net::U32(argb)), (2, Net::Bool(true))])?
        }
        Value::Guid(id) => {
            let (first, second) = id.as_u64_pair();
            with_fields(m, "System", "Guid", &[(0, Net::U64(first)), (1, Net::U64(second))])?
        }
        Value::Time(ticks) => with_fields(m, "System", "DateTime", &[(0, Net::I64(*ticks))])?,
        Value::Complex(z) => {
            built(m, "System.Numerics", "Complex", &[Value::Number(z.re), Value::Number(z.im)])?
        }
        Value::Polyline(points) => {
            let points =
                points.iter().map(|p| to_csharp(m, &Value::Point(*p))).collect::<Option<Vec<_>>>()?;
            let element = named(m, GEOMETRY, "Point3d")?;
            let points = list(m, element, points)?;
            let ty = named(m, GEOMETRY, "Polyline")?;
            m.made(ty, &[points])
        }
        other => {
            if let Some((namespace, name, fields)) = structs::fields(other) {
                return built(m, namespace, name, &fields);
            }
            let items = other.items()?;
            let element = element_type(m, items.iter().find(|item| **item != Value::Null))?;
            let items = items.iter().map(|item| to_csharp(m, item)).collect::<Option<Vec<_>>>()?;
            array(m, element, items)
        }
    })
}

/// A struct of the library with some of its fields set.
fn with_fields(m: &mut impl Machine, namespace: &str, name: &str, values: &[(usize, Net)]) -> Option<Net> {
    let ty = named(m, namespace, name)?;
    let made = m.zero(ty);
    if let Net::Ref(handle) = made
        && let Some(Obj::Inst(_, fields)) = m.state().heap.get_mut(handle)
    {
        for (place, value) in values {
            *fields.get_mut(*place)? = *value;
        }
    }
    Some(made)
}

/// A struct of its fields.
fn built(m: &mut impl Machine, namespace: &str, name: &str, fields: &[Value]) -> Option<Net> {
    let ty = named(m, namespace, name)?;
    let fields = fields.iter().map(|field| to_csharp(m, field)).collect::<Option<Vec<_>>>()?;
    Some(m.made(ty, &fields))
}

/// A map of texts as its keys and texts in turn.
fn pairs_of_texts(m: &mut impl Machine, pairs: &[(Value, Value)]) -> Option<Net> {
    let texts = pairs.iter().flat_map(|(key, text)| [key, text]);
    let texts = texts.map(|text| Some(m.state().text(text.as_text()?))).collect::<Option<Vec<_>>>()?;
    let string = m.sema().known.string;
    Some(array(m, string, texts))
}

fn geometry(m: &mut impl Machine, own: &Geometry) -> Option<Net> {
    let class = own.shape.class();
    let ty = named(m, namespace(class), class).or_else(|| named(m, GEOMETRY, "GeometryBase"))?;
    Some(Net::Ref(m.state().heap.add(Obj::Host(ty, Box::new(Geometry { id: 0, ..own.clone() })))))
}

/// The type of an array's elements, by the first that is not null.
fn element_type(m: &mut impl Machine, first: Option<&Value>) -> Option<Ty> {
    let known = m.sema().known;
    Some(match first {
        Some(Value::Number(_)) => known.double,
        Some(Value::Int(_)) => known.int,
        Some(Value::Bool(_)) => known.bool,
        Some(Value::Text(_)) => known.string,
        Some(Value::Geometry(geometry)) => match &geometry.shape {
            Shape::Curve(_) => named(m, GEOMETRY, "Curve")?,
            Shape::Surface(_) => named(m, GEOMETRY, "Surface")?,
            Shape::Record(record) => named(m, namespace(record.class), record.class).unwrap_or(known.object),
            shape => named(m, GEOMETRY, shape.class()).unwrap_or(known.object),
        },
        Some(value) => {
            let nested = match value.items() {
                Some(items) if structs::fields(value).is_none() => {
                    let element = element_type(m, items.first())?;
                    Some(m.sema().array(element, 1))
                }
                _ => None,
            };
            match (nested, structs::fields(value)) {
                (Some(nested), _) => nested,
                (None, Some((namespace, name, _))) => named(m, namespace, name).unwrap_or(known.object),
                (None, None) => known.object,
            }
        }
        None => known.object,
    })
}

/// A number as the type that is asked for has it, and what is missing as its default.
pub(super) fn fitted(m: &mut impl Machine, value: Net, ty: Ty) -> Net {
    match (m.sema().prim(ty), value) {
        (Some(Prim::F64), Net::Null) => Net::F64(0.0),
        (Some(Prim::F64), value) => value.real().map_or(value, Net::F64),
        (Some(Prim::I32), Net::Null) => Net::I32(0),
        (Some(Prim::Bool), Net::Null) => Net::Bool(false),
        // A struct is no reference: what is missing is one whose fields are all zero, as .NET's default.
        (None, Net::Null) if m.sema().is_struct(ty) => m.zero(ty),
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
        array_or_list @ (Obj::Array(_, _, None) | Obj::List(..)) => {
            let items = match array_or_list {
                Obj::Array(_, items, _) => items.to_values(),
                Obj::List(_, items, _) => items.to_values(),
                _ => Vec::new(),
            };
            let items = items.into_iter().map(|item| read(m, item, depth)).collect::<Result<_, _>>()?;
            return Ok(Value::list(items));
        }
        Obj::Host(ty, data) => match data.downcast_ref::<Geometry>() {
            Some(own) => return Ok(Value::Geometry(own.clone())),
            None => (*ty, Vec::new()),
        },
        Obj::Inst(ty, fields) => (*ty, fields.to_vec()),
        Obj::Decimal(_) => {
            let real = m.state().heap.real_of_decimal(value);
            return Ok(real.map_or(Value::Null, Value::Number));
        }
        other => return Err(kind_of(other).to_owned()),
    };
    let name = m.sema().full_name(ty);
    if let ("System.Guid", [Net::U64(first), Net::U64(second)]) = (name.as_str(), fields.as_slice()) {
        return Ok(Value::Guid(uuid::Uuid::from_u64_pair(*first, *second)));
    }
    let parts =
        |m: &mut _| fields.iter().map(|field| read(m, *field, depth)).collect::<Result<Vec<Value>, String>>();
    let start = name.split(['<', '`']).next().unwrap_or_default();
    let short = start.rsplit('.').next().unwrap_or_default();
    Ok(match start {
        "Grasshopper.DataTree" => {
            let own: Vec<Net> = fields.iter().take(2).copied().collect();
            tree(own.into_iter().map(|field| read(m, field, depth)).collect::<Result<_, _>>()?)
        }
        // A list of an object stands for its object.
        _ if start.starts_with("Rhino.Geometry.Collections.") => match fields.first() {
            Some(owner) => read(m, *owner, depth)?,
            None => return Err(name),
        },
        _ if start.starts_with("Grasshopper.Kernel.Types.GH_") => match fields.first() {
            Some(held) => read(m, *held, depth)?,
            None => return Err(name),
        },
        "Rhino.Geometry.MeshingParameters"
        | "Rhino.Geometry.Cylinder"
        | "Rhino.Geometry.Cone"
        | "Rhino.Geometry.Torus"
        | "Rhino.Geometry.Ray3d" => {
            let names = field_names(m, ty);
            Value::Map(names.into_iter().map(Value::Text).zip(parts(m)?).collect())
        }
        _ => structs::of_fields(short, &parts(m)?).ok_or(name)?,
    })
}

/// The names of the fields of a type's objects.
fn field_names(m: &mut impl Machine, ty: Ty) -> Vec<String> {
    let sema = m.sema();
    let fields = sema.def_of(ty).map(|def| sema.def(def).fields.clone()).unwrap_or_default();
    fields.into_iter().map(|field| sema.field(field).name.to_string()).collect()
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
