//! RhinoCommon's JSON forms of values, both ways: structs such as points, lines and planes, and the form of objects
//! `{"version", "archive3dm", "opennurbs", "data"}`, whose data is one openNURBS class object.
//!
//! Reading is lenient where clients differ: names of members in any case, members that are not known, points as
//! `[x, y, z]`, JSON inside a string, numbers as strings. What cannot be is refused in words: numbers that are not
//! finite, objects of another class than asked for, lengths past the end.

mod geometry;
mod numbers;
mod object;
mod read;
mod script;
mod settings;
mod solids;
mod structs;
mod values;

pub use geometry::{GeometryBase, Subdivision};
pub(crate) use numbers::number;
pub(crate) use object::{curve_type, surface_type, type_name};
pub use object::{decode_object, encode_object};
pub(crate) use read::unwrapped;
pub use read::{Members, Read};
pub use script::Script;
pub use settings::MeshingParameters;
pub use structs::Ray;
pub use values::{Encoded, encode};

use serde_json::Value as Json;

use crate::Fault;

/// A type that has a JSON form of RhinoCommon's.
pub trait Wire: Script {
    /// The full name of the .NET type.
    const TYPE: &'static str;

    /// What messages call it, with its article: "a plane".
    const NAME: &'static str;

    /// Reads the form, and every other form that clients are known to send.
    ///
    /// # Errors
    /// What is wrong with it, in words that follow the name of an argument: "is no plane: ...".
    fn from_json(json: &Json) -> Result<Self, Fault>;

    /// The form; objects for an archive of the given version.
    ///
    /// # Errors
    /// The version cannot carry the object.
    fn to_json(&self, archive: i32) -> Result<Json, Fault>;
}

/// That JSON is no value of a type, and why.
pub(crate) fn no<T: Wire>(why: impl std::fmt::Display) -> Fault {
    Fault::bad_request(format!("is not {}: {why}", T::NAME))
}

/// What the kernel makes of what was read.
pub(crate) fn made<T: Wire>(value: katydid_geometry::Result<T>) -> Result<T, Fault> {
    value.map_err(no::<T>)
}
