//! The Curve tab.

mod analysis;
mod arcs;
mod connect;
mod division;
mod evaluate;
mod fillet;
mod offset;
mod on_surface;
mod onto;
mod places;
mod polyline;
mod primitive;
mod proximity;
mod rebuild;
mod region;
mod spline;
mod tangent;
mod touching;
mod util;

use std::sync::Arc as Shared;

use katydid_component::Message;
use katydid_geometry::{Curve, Error, Interval};

/// A curve as an output gives it.
fn shared(curve: impl Into<Curve>) -> Shared<Curve> {
    Shared::new(curve.into())
}

/// Shapes that cannot be made are no fault of the definition: a warning, and no result.
fn warning(error: Error) -> Message {
    Message::warning(error.to_string())
}

/// A curve with its length and domain.
fn measured(curve: impl Into<Curve>) -> (Shared<Curve>, f64, Interval) {
    let curve = shared(curve);
    let (length, domain) = (curve.length(), curve.domain());
    (curve, length, domain)
}
