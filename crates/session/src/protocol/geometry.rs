use serde::{Deserialize, Serialize};
use uuid::Uuid;

/// Where geometry comes from that somebody gives to an input in a viewport.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "from", rename_all = "camelCase")]
pub enum GeometrySource {
    /// An object of the Rhino model, by its id: the input refers to it and holds no copy.
    Model { object: Uuid },
    /// An item of the data that an output has now: a copy is kept.
    Item { port: Uuid, path: String, index: u32 },
    /// Something drawn in the viewport.
    Drawn { drawing: Drawing },
}

/// What is drawn in a viewport, in model units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "is", rename_all = "camelCase")]
pub enum Drawing {
    /// A point.
    Point { at: [f64; 3] },
    /// An arrow: only its length and direction are kept.
    Vector { along: [f64; 3] },
    /// A plane.
    Plane { plane: PlaneView },
    /// A straight segment.
    Line { ends: [[f64; 3]; 2] },
    /// Straight segments end to end; closed where the last point is the first.
    Polyline { points: Vec<[f64; 3]> },
    /// A cubic curve through points, as Interpolate makes it.
    Interpolated { points: Vec<[f64; 3]>, closed: bool },
    /// A circle about the origin of a plane.
    Circle { plane: PlaneView, radius: f64 },
    /// A rectangle with a corner at the origin of a plane and sides of these lengths along its axes.
    Rectangle { plane: PlaneView, size: [f64; 2] },
}

/// A plane. The axes need not have length 1; y is turned until it is at a right angle to x.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct PlaneView {
    /// The origin.
    pub origin: [f64; 3],
    /// The direction of the x axis.
    pub x: [f64; 3],
    /// The direction of the y axis.
    pub y: [f64; 3],
}
