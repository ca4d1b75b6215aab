//! The functions of RhinoCommon that clients call by path: `curve/getlength-curve_double` and so on.
//!
//! [`Endpoints`] is a table. Its paths and the names of their parameters are those of `signatures.txt`; what each one
//! does is a plain function of typed arguments, entered in the table by the module of its class. Decoding, encoding,
//! faults, help pages and the choice among overloads follow from the types, and no function does any of it by itself.

mod answer;
mod argument;
mod brep;
mod brep_cut;
mod brep_face;
mod brep_make;
mod brep_mend;
mod brep_sweep;
mod call;
mod choice;
mod curve;
mod curve_edit;
mod curve_ends;
mod curve_length;
mod curve_local;
mod curve_make;
mod curve_onto;
mod curve_region;
mod function;
mod geometry_base;
mod help;
mod intersection;
mod intersection_mesh;
mod intersection_ray;
mod mass;
mod mesh;
mod mesh_edit;
mod mesh_make;
mod mesh_mend;
mod mesh_pieces;
mod mesh_round;
mod nurbs_curve;
mod nurbs_edit;
mod nurbs_surface;
mod query;
mod smoothing;
mod subd;
mod surface;
mod surface_curve;
mod surface_edit;
mod table;

pub use call::CallReply;
pub use query::Query;
pub use table::Endpoints;

use crate::{Bounds, Fault};

/// Calls the function of a path with the arguments of a body.
///
/// # Errors
/// `NotFound` for a path that nobody has, `NotSupported` for one that is known and not here, `BadRequest` for a body
/// or an argument that makes no sense, `Cancelled` when the asker has left, and `TimedOut`
/// when the time is over: both are looked for between the parts of what may take long.
pub fn call(path: &str, query: &Query, body: &[u8], bounds: &Bounds) -> Result<CallReply, Fault> {
    table::endpoints().call(path, query, body, bounds)
}

/// The table that all calls share.
pub fn endpoints() -> &'static Endpoints {
    table::endpoints()
}
