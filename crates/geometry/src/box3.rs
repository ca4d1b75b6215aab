use crate::{Interval, Plane};

/// A box in a frame, by its ranges along the three axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Box3 {
    /// The frame.
    pub plane: Plane,
    /// The range along the x axis.
    pub x: Interval,
    /// The range along the y axis.
    pub y: Interval,
    /// The range along the z axis.
    pub z: Interval,
}
