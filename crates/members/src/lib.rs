//! The functions of RhinoCommon by class and member: one table of plain typed functions.
//!
//! A compute server calls them by path with JSON ([`geometry::Endpoints::call`]); a script calls them by name with values
//! ([`Host`]), over a pipe in the form that [`codec`] describes. Decoding, overloads, faults and help follow from the types
//! of each function, so that no list of functions stands beside the table.
//!
//! ```
//! use katydid_members::{Call, Host, Value};
//! use katydid_geometry::Point3;
//!
//! let mut host = Host::new();
//! let ends = [Point3::ORIGIN, Point3::new(3.0, 4.0, 0.0)].map(Value::Point);
//! let line = host.call(&Call::new("LineCurve.new", ends.to_vec()))?;
//! assert_eq!(host.call(&Call::new("Curve.GetLength", vec![line]))?, Value::Number(5.0));
//! # Ok::<(), katydid_members::Fault>(())
//! ```

pub mod codec;
mod fault;
pub mod geometry;
mod handles;
mod host;
mod shape;
mod unfinished;
mod unfinished_surface;
mod user_strings;
mod value;
pub mod wire;

pub use fault::{Cause, Fault};
pub use handles::Handles;
pub use host::{Call, Host, Registry, serve};
pub use shape::{Geometry, Record, Shape, SubDPart};
pub use unfinished::UnfinishedNurbs;
pub use unfinished_surface::UnfinishedSurface;
pub use user_strings::UserStrings;
pub use value::Value;
