//! Circles, arcs and ellipses.

use super::plain::increasing;
use super::structure;
use crate::{Arc, Circle, Ellipse, Error, Interval, Plane};

structure!(Circle { plane: Plane, radius: f64 } | c | Circle::new(c.plane, c.radius).map(drop));
structure!(Ellipse { plane: Plane, rx: f64, ry: f64 } | e | Ellipse::new(e.plane, e.rx, e.ry).map(drop));
structure!(
    Arc { circle: Circle, angle: Interval } | a | {
        increasing("angle of an arc", a.angle)?;
        if a.angle.length() <= std::f64::consts::TAU * (1.0 + 4.0 * f64::EPSILON) {
            return Ok(());
        }
        Err(Error::OutOfRange {
            what: "angle of an arc",
            value: a.angle.length(),
            must: "at most a full turn",
        })
    }
);
