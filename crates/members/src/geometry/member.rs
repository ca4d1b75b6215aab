//! Members by name, as scripts call them.

use super::argument::Waiting;
use super::call::{Arguments, Given};
use super::table::{Endpoints, Row, fitting};
use super::{intersection, mass};
use crate::shape::{Geometry, Shape};
use crate::{Fault, Value};

/// What a member gave.
#[derive(Debug)]
pub struct MemberReply {
    /// The result, with what RhinoCommon has in `out` parameters behind it.
    pub value: Value,
    /// What the object that the member belongs to has become, where it was changed.
    pub changed: Option<Geometry>,
}

/// The class that a class inherits members from.
fn base_class(class: &str) -> Option<&'static str> {
    Some(match class {
        "LineCurve" | "ArcCurve" | "PolylineCurve" | "NurbsCurve" | "PolyCurve" | "BrepEdge" => "Curve",
        "PlaneSurface" | "NurbsSurface" | "RevSurface" | "SumSurface" | "Extrusion" | "BrepFace" => "Surface",
        "Curve" | "Surface" | "Brep" | "Mesh" | "SubD" | "Point" | "PointCloud" | "TextDot" | "Hatch" => {
            "GeometryBase"
        }
        _ => return None,
    })
}

impl Endpoints {
    /// The overloads of a member, its class's and those of the classes above it.
    fn overloads_of(&self, name: &str) -> Vec<&Row> {
        let Some((class, member)) = name.split_once('.') else { return Vec::new() };
        let mut rows = Vec::new();
        let mut class = Some(class);
        while let Some(own) = class {
            let places = self.members.get(&format!("{own}.{member}"));
            rows.extend(places.into_iter().flatten().filter_map(|&place| self.rows.get(place)));
            // A constructor is not inherited.
            class = if member == "new" { None } else { base_class(own) };
        }
        rows
    }

    /// Calls a member, `Class.Member`, with values; the object first where it belongs to one.
    ///
    /// # Errors
    /// `NotSupported` for a member that is not here, `BadRequest` for arguments that no overload takes, and as
    /// [`call`](Self::call) does.
    pub fn call_member(
        &self,
        name: &str,
        arguments: &[Value],
        waiting: &Waiting,
    ) -> Result<MemberReply, Fault> {
        if let Some(value) = property(name, arguments) {
            return Ok(MemberReply { value, changed: None });
        }
        let rows = self.overloads_of(name);
        if rows.is_empty() {
            return Err(Fault::not_supported(name));
        }
        let fitting_count: Vec<&Row> =
            rows.iter().copied().filter(|row| arguments.len() <= row.names.len()).collect();
        if fitting_count.is_empty() {
            let most = rows.iter().map(|row| row.names.len()).max().unwrap_or(0);
            let count = arguments.len();
            return Err(Fault::bad_request(format!("{name} takes at most {most} arguments, not {count}")));
        }
        let fit = fitting(&fitting_count, Arguments::Values(arguments), waiting)?;
        let Given::Value(value) = fit.given else {
            return Err(Fault::failed("JSON where a value was asked for"));
        };
        Ok(if fit.row.changes { changed(value) } else { MemberReply { value, changed: None } })
    }

    /// The members that change their object, sorted: what was read of it before no longer holds.
    pub fn changing(&self) -> Vec<String> {
        let rows = self.rows.iter().filter(|row| row.entry.is_some() && row.changes);
        let mut names: Vec<String> = rows.map(|row| row.member.clone()).collect();
        names.sort();
        names.dedup();
        names
    }

    /// The signatures of all members, sorted: `Class.Member(this Type, Type name) -> Type`.
    pub fn members(&self) -> Vec<String> {
        let answered = self.rows.iter().filter(|row| row.entry.is_some());
        let records = mass::samples().into_iter().chain([intersection::sample()]);
        let properties = records.flat_map(|record| {
            let class = record.class;
            record.fields.into_iter().map(move |(name, value)| property_signature(class, name, &value))
        });
        let mut signatures: Vec<String> = answered.map(signature).chain(properties).collect();
        signatures.sort();
        signatures.dedup();
        signatures
    }
}

fn property_signature(class: &str, name: &str, value: &Value) -> String {
    let kind = match value {
        Value::Number(_) => "Double",
        Value::Bool(_) => "Boolean",
        Value::Int(_) => "Int32",
        value => value.noun().trim_start_matches("an ").trim_start_matches("a "),
    };
    format!("{class}.get_{name}(this {class}) -> {kind}")
}

/// A property of a result that is a record.
fn property(name: &str, arguments: &[Value]) -> Option<Value> {
    let (_, member) = name.split_once('.')?;
    match arguments {
        [Value::Geometry(geometry)] => match &geometry.shape {
            Shape::Record(record) => record.field(member.strip_prefix("get_")?).cloned(),
            _ => None,
        },
        _ => None,
    }
}

/// What a member gave that changes its object: what the object becomes stands last.
fn changed(value: Value) -> MemberReply {
    match value {
        Value::List(mut items) => {
            let changed = match items.pop() {
                Some(Value::Geometry(geometry)) => Some(geometry),
                _ => None,
            };
            let value = match items.len() {
                0 => Value::Null,
                1 => items.pop().unwrap_or(Value::Null),
                _ => Value::List(items),
            };
            MemberReply { value, changed }
        }
        Value::Geometry(geometry) => MemberReply { value: Value::Null, changed: Some(geometry) },
        value => MemberReply { value, changed: None },
    }
}

fn signature(row: &Row) -> String {
    let types = row.takes.iter().map(String::as_str).chain(std::iter::repeat("Any"));
    let parameter = |(name, kind): (&&str, &str)| match *name {
        "this" => format!("this {kind}"),
        name => format!("{kind} {name}"),
    };
    let parameters: Vec<String> = row.names.iter().zip(types).map(parameter).collect();
    let gives: Vec<String> = row.gives.split(", ").map(|part| short(part).to_owned()).collect();
    let gives = match gives.as_slice() {
        // What the object becomes is not handed back.
        [result @ .., _] if row.changes && !result.is_empty() => result.join(", "),
        [_] if row.changes => "Void".into(),
        all => all.join(", "),
    };
    format!("{}({}) -> {gives}", row.member, parameters.join(", "))
}

fn short(name: &str) -> &str {
    name.rsplit_once('.').map_or(name, |(_, name)| name)
}
