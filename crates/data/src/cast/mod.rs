//! How a value of one type becomes one of another: the conversions that happen when a wire reaches a port.
//!
//! One table of rows ([`Way`]): from which types, to which, what it gives, and how sure we are that Grasshopper does the
//! same. Help, messages and tests are made of the same rows. Sources: the rules that pictures of Grasshopper prove,
//! files that could not have worked otherwise, and public knowledge of its parameters.

mod curve;
mod general;
mod number;
mod parse;
mod place;
mod shape;
mod table;
mod way;

use std::sync::Arc as Shared;

use katydid_geometry::{Tolerance, Units};

use crate::{Column, Content, DateTime, Gather, Geometry, Items, Kind, Value};

pub(crate) use place::bounds;

pub use parse::{
    colour as parse_colour, domain as parse_domain, number as parse_number, point as parse_point,
    time as parse_time,
};
pub use table::{all, way, ways_to};
pub use way::{Sure, Way};

/// What some conversions need to know of the document.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rules {
    /// How near a curve must be to a line, arc or circle to become one.
    pub tolerance: Tolerance,
    /// The unit that texts of lengths carry.
    pub units: Units,
    /// The moment that the text `Now` stands for; none where there is no clock.
    pub now: Option<DateTime>,
}

/// `value` as `kind`; `None` when there is no way from one to the other.
pub fn value(value: &Value, kind: Kind, rules: &Rules) -> Option<Value> {
    traced(value, kind, rules).map(|(made, _)| made)
}

/// `value` as `kind`, and the row of the table by which it came; no row where it was of that type before.
fn traced(value: &Value, kind: Kind, rules: &Rules) -> Option<(Value, Option<&'static Way>)> {
    let from = value.cast_kind();
    if from == kind {
        return Some((value.clone(), None));
    }
    if let Value::Content(content) = value {
        return self::content(value, content, kind, rules).map(|made| (made, None));
    }
    let way = table::way(from, kind)?;
    (way.convert)(value, rules).map(|made| (made, Some(way)))
}

/// Where geometry is asked for, an object is its geometry; a block placed in space stays one.
fn content(value: &Value, content: &Content, kind: Kind, rules: &Rules) -> Option<Value> {
    let by_table = || (table::way(Kind::Content, kind)?.convert)(value, rules);
    match (content, kind) {
        (_, Kind::Generic | Kind::Text) => by_table(),
        (_, Kind::Content) => Some(value.clone()),
        (Content::Object(object), Kind::Guid) => object.id.map(Value::Guid),
        // Texts that geometry carries itself go where it goes.
        (Content::Object(object), Kind::Geometry) if !object.geometry_text.is_empty() => {
            object.geometry.is_some().then(|| value.clone())
        }
        // The geometry of an object is never an object, so that this goes no deeper.
        (Content::Object(object), _) => self::value(object.geometry.as_ref()?, kind, rules),
        (Content::Instance(_), Kind::Geometry) => Some(value.clone()),
        (Content::Instance(instance), Kind::Transform) => Some(Value::from(instance.transform)),
        (Content::Instance(_), Kind::Box) => (table::way(Kind::Geometry, kind)?.convert)(value, rules),
        (Content::Layer(layer), Kind::Colour) => layer.colour.map(Value::Colour),
        _ => None,
    }
}

impl Value {
    /// The type that conversions go by: that of what it is, of geometry that is kept as a program wrote it that of its
    /// class.
    fn cast_kind(&self) -> Kind {
        let Self::Kept(object) = self else { return self.kind() };
        match object.class_name().as_str() {
            "Brep" | "Extrusion" => Kind::Brep,
            "SubD" => Kind::SubD,
            "PointCloud" => Kind::PointCloud,
            name if name.ends_with("Surface") => Kind::Surface,
            _ => Kind::Kept,
        }
    }
}

/// A column cast to a type, and what could not be cast.
#[derive(Debug, Clone)]
pub struct Cast {
    /// The column; a failed item is null.
    pub column: Column,
    /// The type of the first item that could not be cast, and how many could not.
    pub failed: Option<(Kind, usize)>,
    /// The first conversion among them that is our own reading: nothing tells what Grasshopper does.
    pub ours: Option<(Kind, &'static Way)>,
}

impl Cast {
    fn sure(column: Column) -> Self {
        Self { column, failed: None, ours: None }
    }
}

/// Every item of a column as `kind`. A column that is of that type already is shared, not copied.
pub fn column(column: &Column, kind: Kind, rules: &Rules) -> Cast {
    if kind == Kind::Generic || column.kind() == kind {
        return Cast::sure(column.clone());
    }
    let whole_already = match kind {
        Kind::Geometry => column.kind().is_geometry(),
        Kind::Brep => column.kind() == Kind::Surface,
        Kind::Transform => column.kind() == Kind::Compound,
        _ => false,
    };
    if whole_already {
        return Cast::sure(column.clone());
    }
    if let Some(items) = whole(column.items(), kind) {
        let nulls = column.null_mask().map(<[bool]>::to_vec);
        return Cast::sure(Column::new(items, nulls));
    }
    let mut failed: Option<(Kind, usize)> = None;
    let mut ours = None;
    let mut cast = Gather::<Value>::with_capacity(column.len());
    for item in column.iter() {
        let Some(item) = item else {
            cast.push(None);
            continue;
        };
        // Whoever has this done looks whether to go on.
        if katydid_geometry::CancellationToken::is_over() {
            cast.push(None);
            continue;
        }
        let result = match traced(&item, kind, rules) {
            Some((made, way)) => {
                if let Some(way) = way.filter(|way| way.sure == Sure::Ours) {
                    ours.get_or_insert((item.kind(), way));
                }
                Some(made)
            }
            None => {
                failed.get_or_insert((item.kind(), 0)).1 += 1;
                None
            }
        };
        cast.push(result);
    }
    let column = if kind == Kind::Geometry {
        let mut geometry = Gather::<Geometry>::with_capacity(cast.len());
        cast.finish().iter().for_each(|item| geometry.push(item.map(Geometry)));
        geometry.finish()
    } else {
        cast.finish()
    };
    Cast { column, failed, ours }
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
        (Items::Points(x), Kind::Number) => Items::Numbers(map(x, |p| p.to_vector().length())),
        (Items::Vectors(x), Kind::Number) => Items::Numbers(map(x, katydid_geometry::Vector3::length)),
        _ => return None,
    })
}

#[cfg(test)]
mod table_tests;
#[cfg(test)]
mod tests;
