//! Lenient access to JSON.

use std::borrow::Cow;

use katydid_geometry::{Plane, Point3, Vector3};
use serde_json::{Map, Value as Json};

use super::Wire;
use super::object::NEWEST_ARCHIVE;
use crate::{Fault, Value};

/// What a value looks like, for messages.
pub(super) fn kind(json: &Json) -> &'static str {
    match json {
        Json::Null => "null",
        Json::Bool(_) => "true or false",
        Json::Number(_) => "a number",
        Json::String(_) => "text",
        Json::Array(_) => "a list",
        Json::Object(_) => "an object",
    }
}

/// The JSON inside a string that holds an object or a list; anything else as it is.
pub(crate) fn unwrapped(json: &Json) -> Cow<'_, Json> {
    if let Json::String(text) = json
        && text.trim_start().starts_with(['{', '['])
        && let Ok(inner) = serde_json::from_str(text)
    {
        return Cow::Owned(inner);
    }
    Cow::Borrowed(json)
}

/// The members of an object, found in any case of their names. Where a name stands twice in different cases the exact
/// one is meant.
#[derive(Debug, Clone, Copy)]
pub struct Members<'a>(&'a Map<String, Json>);

impl<'a> Members<'a> {
    /// The members of a value that is an object.
    ///
    /// # Errors
    /// It is something else.
    pub fn of(json: &'a Json) -> Result<Self, Fault> {
        match json {
            Json::Object(map) => Ok(Self(map)),
            other => Err(Fault::bad_request(format!("is {}, not an object", kind(other)))),
        }
    }

    /// A member, if it is there and not null.
    pub fn get(&self, name: &str) -> Option<&'a Json> {
        let found = self.0.get(name).or_else(|| {
            self.0.iter().find_map(|(key, value)| key.eq_ignore_ascii_case(name).then_some(value))
        });
        found.filter(|value| !value.is_null())
    }

    /// The first of several members that is there.
    pub fn first(&self, names: &[&str]) -> Option<&'a Json> {
        names.iter().find_map(|name| self.get(name))
    }

    /// A member that must be there.
    ///
    /// # Errors
    /// It is not there, or cannot be read; the message begins with its name.
    pub fn read<T: Read>(&self, name: &str) -> Result<T, Fault> {
        let json = self.get(name).ok_or_else(|| Fault::bad_request(format!("has no {name}")))?;
        T::read(json).map_err(|fault| inside(name, fault))
    }

    /// A member that may be missing.
    ///
    /// # Errors
    /// It is there and cannot be read.
    pub fn read_or<T: Read>(&self, name: &str, default: T) -> Result<T, Fault> {
        match self.get(name) {
            Some(json) => T::read(json).map_err(|fault| inside(name, fault)),
            None => Ok(default),
        }
    }
}

/// Names the member that a fault lies in.
pub(super) fn inside(name: &str, fault: Fault) -> Fault {
    Fault { message: format!("its {name} {}", fault.message), cause: fault.cause }
}

/// What can stand in JSON: plain values, values with a form, lists of them.
pub trait Read: Sized {
    /// Reads a value.
    ///
    /// # Errors
    /// In words that follow the name of what is read: "is no number".
    fn read(json: &Json) -> Result<Self, Fault>;

    /// Reads a value of a script.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    fn of_value(value: &Value) -> Result<Self, Fault> {
        Self::read(&value.to_json(NEWEST_ARCHIVE)?)
    }

    /// What signatures call the type.
    fn type_name() -> String {
        "Object".into()
    }
}

impl<T: Wire> Read for T {
    fn read(json: &Json) -> Result<Self, Fault> {
        T::from_json(&unwrapped(json))
    }

    fn of_value(value: &Value) -> Result<Self, Fault> {
        match T::from_script(value) {
            Some(read) => read,
            None => T::read(&value.to_json(NEWEST_ARCHIVE)?),
        }
    }

    fn type_name() -> String {
        short_name(T::TYPE).into()
    }
}

/// The name of a .NET type without its namespace.
pub(crate) fn short_name(name: &'static str) -> &'static str {
    name.rsplit_once('.').map_or(name, |(_, name)| name)
}

/// The three numbers of a point or vector: `{"X", "Y", "Z"}` or `[x, y, z]`; z may be missing.
pub(super) fn triple(json: &Json) -> Result<[f64; 3], Fault> {
    match json {
        Json::Array(items) => {
            if !(2..=3).contains(&items.len()) {
                return Err(Fault::bad_request(format!("is a list of {} items, not of 3", items.len())));
            }
            let mut numbers = [0.0; 3];
            for (number, item) in numbers.iter_mut().zip(items) {
                *number = f64::read(item)?;
            }
            Ok(numbers)
        }
        other => {
            let members = Members::of(other)?;
            Ok([members.read("X")?, members.read("Y")?, members.read_or("Z", 0.0)?])
        }
    }
}

/// A plane among an object's members: as a plane, or as a centre and a normal, as some clients have circles.
pub(super) fn plane_of(members: &Members<'_>, names: &[&str], normal: &str) -> Result<Plane, Fault> {
    if let Some(json) = members.first(names) {
        let name = names.first().copied().unwrap_or("Plane");
        return Plane::read(json).map_err(|fault| inside(name, fault));
    }
    let centre: Point3 = members.read("Center")?;
    let normal: Vector3 = members.read_or(normal, Vector3::Z)?;
    Plane::from_normal(centre, normal).map_err(|error| Fault::bad_request(error.to_string()))
}
