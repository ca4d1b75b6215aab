//! How a value of one type becomes one of another: the conversions that happen when a wire reaches a port.
//!
//! One table, a function for each type aimed at. Sources: the rules that pictures of Grasshopper prove, and
//! public knowledge of its parameters where no picture settles it.

mod curve;
mod number;
mod parse;
mod place;

use std::sync::Arc as Shared;

use katydid_geometry::{Tolerance, Units};

use crate::{
    Column, Compound, Content, Gather, Geometry, Items, Kind, Material, ModelObject, Path, Value, text,
};

pub(crate) use place::bounds;

pub use parse::{
    colour as parse_colour, domain as parse_domain, number as parse_number, point as parse_point,
};

/// What some conversions need to know of the document.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rules {
    /// How near a curve must be to a line, arc or circle to become one.
    pub tolerance: Tolerance,
    /// The unit that texts of lengths carry.
    pub units: Units,
}

/// `value` as `kind`; `None` when there is no way from one to the other.
pub fn value(value: &Value, kind: Kind, rules: &Rules) -> Option<Value> {
    if value.kind() == kind {
        return Some(value.clone());
    }
    // What is computed from a brep of one untrimmed face is computed from its surface; the brep itself stays whole.
    if let (Value::Kept(brep), Kind::Domain2 | Kind::Plane | Kind::Box) = (value, kind) {
        let bare = brep.bare_surface().ok().flatten()?;
        return self::value(&Value::from(bare.surface), kind, rules);
    }
    if let (Value::Brep(brep), Kind::Domain2 | Kind::Plane) = (value, kind) {
        let [_] = brep.faces() else { return None };
        return self::value(&Value::from(brep.face_surface(0)?.clone()), kind, rules);
    }
    if let Value::Content(content) = value {
        return self::content(value, content, kind, rules);
    }
    match kind {
        Kind::Generic => Some(value.clone()),
        Kind::Geometry => geometry(value),
        Kind::Boolean => number::boolean(value).map(Value::Boolean),
        Kind::Integer => number::integer(value).map(Value::Integer),
        Kind::Number => number::number(value).map(Value::Number),
        Kind::Complex => number::complex(value).map(Value::Complex),
        Kind::Text => {
            let style = text::Style { units: rules.units, tolerance: rules.tolerance };
            Some(Value::text(text::value(value, &style)))
        }
        Kind::Colour => number::colour(value).map(Value::Colour),
        Kind::Time => None,
        Kind::Guid => match value {
            Value::Text(text) => uuid::Uuid::parse_str(text.trim()).ok().map(Value::Guid),
            _ => None,
        },
        Kind::Domain => number::domain(value).map(Value::Domain),
        Kind::Domain2 => number::domain2(value).map(|d| Value::Domain2(Shared::new(d))),
        Kind::Path => match value {
            Value::Text(text) => text.parse().ok().map(Value::Path),
            Value::Integer(i) => Some(Value::Path(Path::from([*i]))),
            Value::Number(_) => number::integer(value).map(|i| Value::Path(Path::from([i]))),
            _ => None,
        },
        Kind::Point => place::point(value, rules).map(Value::Point),
        Kind::Vector => place::vector(value, rules).map(Value::Vector),
        Kind::Plane => place::plane(value, rules).map(|p| Value::Plane(Shared::new(p))),
        Kind::Line => curve::line(value, rules).map(|l| Value::Line(Shared::new(l))),
        Kind::Circle => curve::circle(value, rules).map(|c| Value::Circle(Shared::new(c))),
        Kind::Arc => curve::arc(value, rules).map(|a| Value::Arc(Shared::new(a))),
        Kind::Rectangle => curve::rectangle(value, rules).map(|r| Value::Rectangle(Shared::new(r))),
        Kind::Box => place::bounding_box(value).map(|b| Value::Box(Shared::new(b))),
        Kind::TwistedBox => match value {
            Value::Box(b) => Some(Value::from(katydid_geometry::TwistedBox::from(**b))),
            _ => None,
        },
        Kind::Curve => curve::curve(value).map(|c| Value::Curve(Shared::new(c))),
        Kind::Mesh => place::mesh(value).map(|m| Value::Mesh(Shared::new(m))),
        Kind::MeshFace => match value {
            Value::Text(text) => parse::mesh_face(text).map(Value::MeshFace),
            _ => None,
        },
        Kind::Surface | Kind::Brep => match value {
            // A surface without trims is a brep of one face.
            Value::Surface(_) => Some(value.clone()),
            Value::Brep(brep) => (brep.faces().len() == 1).then(|| value.clone()),
            Value::Kept(_) => kept(value, kind),
            Value::Box(_) if kind == Kind::Brep => value.brep()?.ok().map(Value::from),
            _ => curve::surface(value, rules).map(Value::from),
        },
        Kind::SubD | Kind::PointCloud => kept(value, kind),
        // A compound is a transform: it stays whole, so that it can be taken apart later.
        Kind::Transform => match value {
            Value::Compound(_) => Some(value.clone()),
            Value::Vector(v) => Some(Value::Transform(Shared::new(katydid_geometry::Xform::translation(*v)))),
            Value::Matrix(m) if (m.rows(), m.columns()) == (4, 4) => {
                let rows = std::array::from_fn(|i| std::array::from_fn(|j| m.get(i, j).unwrap_or_default()));
                Some(Value::Transform(Shared::new(katydid_geometry::Xform { rows })))
            }
            _ => None,
        },
        Kind::Matrix => match value {
            Value::Transform(_) | Value::Compound(_) => {
                let matrix = katydid_geometry::Matrix::new(4, 4, value.as_transform()?.rows.concat());
                matrix.ok().map(|m| Value::Matrix(Shared::new(m)))
            }
            _ => None,
        },
        Kind::Material => number::colour(value).map(|c| Value::Material(Shared::new(Material::from(c)))),
        Kind::Compound => match value {
            Value::Transform(x) => Some(Value::from(Compound { parts: vec![**x] })),
            _ => None,
        },
        Kind::Location => parse::location(value).map(Value::Location),
        Kind::Content => geometry(value).map(|geometry| Value::from(ModelObject::new(geometry))),
        Kind::LoftOptions
        | Kind::MeshSettings
        | Kind::Projection
        | Kind::Field
        | Kind::Symbol
        | Kind::Group
        | Kind::Kept => None,
    }
}

/// Where geometry is asked for, an object is its geometry; a block placed in space stays one.
fn content(value: &Value, content: &Content, kind: Kind, rules: &Rules) -> Option<Value> {
    match (content, kind) {
        (_, Kind::Generic | Kind::Content) => Some(value.clone()),
        (_, Kind::Text) => {
            let style = text::Style { units: rules.units, tolerance: rules.tolerance };
            Some(Value::text(text::value(value, &style)))
        }
        (Content::Object(object), Kind::Guid) => object.id.map(Value::Guid),
        // The geometry of an object is never an object, so that this goes no deeper.
        (Content::Object(object), _) => self::value(object.geometry.as_ref()?, kind, rules),
        (Content::Instance(_), Kind::Geometry) => Some(value.clone()),
        (Content::Instance(instance), Kind::Transform) => Some(Value::from(instance.transform)),
        (Content::Instance(_), Kind::Box) => place::bounding_box(value).map(|b| Value::Box(Shared::new(b))),
        (Content::Layer(layer), Kind::Colour) => layer.colour.map(Value::Colour),
        _ => None,
    }
}

/// Any geometric value, unchanged; a text that reads as a point becomes one.
fn geometry(value: &Value) -> Option<Value> {
    match value {
        Value::Text(text) => parse::point(text).map(Value::Point),
        other if other.kind().is_geometry() => Some(other.clone()),
        _ => None,
    }
}

/// Geometry that is kept whole fits the port its class belongs to.
fn kept(value: &Value, kind: Kind) -> Option<Value> {
    let Value::Kept(object) = value else { return None };
    let fits = match (kind, object.class_name().as_str()) {
        (Kind::Brep, "Brep" | "Extrusion") | (Kind::SubD, "SubD") | (Kind::PointCloud, "PointCloud") => true,
        (Kind::Surface, name) => name.ends_with("Surface") || matches!(name, "Brep" | "Extrusion"),
        (Kind::Brep, name) => name.ends_with("Surface"),
        _ => false,
    };
    fits.then(|| value.clone())
}

/// A column cast to a type, and what could not be cast.
#[derive(Debug, Clone)]
pub struct Cast {
    /// The column; a failed item is null.
    pub column: Column,
    /// The type of the first item that could not be cast, and how many could not.
    pub failed: Option<(Kind, usize)>,
}

/// Every item of a column as `kind`. A column that is of that type already is shared, not copied.
pub fn column(column: &Column, kind: Kind, rules: &Rules) -> Cast {
    if kind == Kind::Generic || column.kind() == kind {
        return Cast { column: column.clone(), failed: None };
    }
    let whole_already = match kind {
        Kind::Geometry => column.kind().is_geometry(),
        Kind::Brep => column.kind() == Kind::Surface,
        Kind::Transform => column.kind() == Kind::Compound,
        _ => false,
    };
    if whole_already {
        return Cast { column: column.clone(), failed: None };
    }
    if let Some(items) = whole(column.items(), kind) {
        let nulls = column.null_mask().map(<[bool]>::to_vec);
        return Cast { column: Column::new(items, nulls), failed: None };
    }
    let mut failed: Option<(Kind, usize)> = None;
    let mut cast = Gather::<Value>::with_capacity(column.len());
    for item in column.iter() {
        let Some(item) = item else {
            cast.push(None);
            continue;
        };
        let result = value(&item, kind, rules);
        if result.is_none() {
            failed.get_or_insert((item.kind(), 0)).1 += 1;
        }
        cast.push(result);
    }
    let cast = if kind == Kind::Geometry {
        let mut geometry = Gather::<Geometry>::with_capacity(cast.len());
        cast.finish().iter().for_each(|item| geometry.push(item.map(Geometry)));
        geometry.finish()
    } else {
        cast.finish()
    };
    Cast { column: cast, failed }
}

/// The conversions that cannot fail, over whole runs.
fn whole(items: &Items, kind: Kind) -> Option<Items> {
    fn map<A: Copy, B>(items: &[A], f: impl Fn(A) -> B) -> Shared<Vec<B>> {
        Shared::new(items.iter().copied().map(f).collect())
    }
    Some(match (items, kind) {
        (Items::Integers(x), Kind::Number) => Items::Numbers(map(x, f64::from)),
        (Items::Booleans(x), Kind::Number) => Items::Numbers(map(x, |b| f64::from(u8::from(b)))),
        (Items::Booleans(x), Kind::Integer) => Items::Integers(map(x, i32::from)),
        (Items::Integers(x), Kind::Boolean) => Items::Booleans(map(x, |i| i != 0)),
        (Items::Numbers(x), Kind::Boolean) => Items::Booleans(map(x, |n| n != 0.0)),
        (Items::Points(x), Kind::Vector) => Items::Vectors(map(x, katydid_geometry::Point3::to_vector)),
        (Items::Vectors(x), Kind::Point) => Items::Points(map(x, katydid_geometry::Vector3::to_point)),
        _ => return None,
    })
}

#[cfg(test)]
mod tests;
