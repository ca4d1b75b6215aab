//! The functions of RhinoCommon that clients call by path: `curve/getlength-curve_double` and so on. The table of them is
//! `katydid-members`; a request's bounds hold here.

pub use katydid_members::geometry::{CallReply, Endpoints, Query, Waiting, endpoints};

use crate::{Bounds, Fault};

/// Calls the function of a path with the arguments of a body.
///
/// # Errors
/// `NotFound` for a path that nobody has, `NotSupported` for one that is known and not here, `BadRequest` for a body
/// or an argument that makes no sense, `Cancelled` when the asker has left, and `TimedOut`
/// when the time is over: both are looked for between the parts of what may take long.
pub fn call(path: &str, query: &Query, body: &[u8], bounds: &Bounds) -> Result<CallReply, Fault> {
    let waiting = Waiting::new(&bounds.limits, bounds.memory.as_ref(), &bounds.cancel);
    endpoints().call(path, query, body, &waiting)
}
