//! `/rhino/…`: functions of RhinoCommon.

use std::sync::Arc;

use super::body::Received;
use super::refusal::Refusal;
use super::sent::{HTML, Sent};
use super::service::Service;
use super::solve::Asking;

/// Calls a function.
pub(crate) async fn call(
    _service: Arc<Service>,
    _asking: Asking,
    parts: &[String],
    _body: Received,
) -> Result<Sent, Refusal> {
    Err(Refusal::unsupported(&parts.join("/")))
}

/// A page that explains a function.
pub(crate) fn help(parts: &[String]) -> Result<Sent, Refusal> {
    Err(Refusal::unsupported(&parts.join("/")))
}

/// A page that lists all functions.
pub(crate) fn list() -> Sent {
    Sent::new(HTML, "<!doctype html>")
}
