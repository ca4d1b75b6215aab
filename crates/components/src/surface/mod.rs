//! The Surface tab.

mod analysis;
mod boundary;
mod boxes;
mod caps;
mod curvature;
mod edges;
mod extrude;
mod fillet;
mod frame;
mod freeform;
mod fuse;
mod inside;
mod loft;
mod measure;
mod multipipe;
mod offset;
mod parts;
mod pipe;
mod primitive;
pub(crate) mod sphere;
pub(crate) mod subd;
mod sweep;
#[cfg(test)]
mod trial;
mod trims;
mod util;

use std::sync::Arc as Shared;

use katydid_component::Message;
use katydid_data::Value;
use katydid_geometry::{Direction, Error, Interval, Point3, Surface};

/// A surface as an output gives it.
fn shared(surface: impl Into<Surface>) -> Shared<Surface> {
    Shared::new(surface.into())
}

/// Shapes that cannot be made are no fault of the definition: a warning, and no result.
fn warning(error: Error) -> Message {
    Message::warning(error.to_string())
}

/// A surface over other domains.
fn over(surface: impl Into<Surface>, u: Interval, v: Interval) -> Result<Surface, Error> {
    surface.into().with_domain(Direction::U, u)?.with_domain(Direction::V, v)
}

/// What a value is called in messages: what is kept as a program wrote it by its class.
pub(crate) fn named(value: &Value) -> String {
    match value {
        Value::Kept(raw) => raw.class_name(),
        other => other.kind().to_string(),
    }
}

/// A pair of parameters, which a point carries as its x and y.
fn uv(point: Point3) -> Result<(f64, f64), Message> {
    if point.x.is_finite() && point.y.is_finite() {
        Ok((point.x, point.y))
    } else {
        Err(Message::error("The parameters are not finite"))
    }
}
