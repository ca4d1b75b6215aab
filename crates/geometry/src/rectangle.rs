use crate::{Interval, Plane};

/// A rectangle in a plane, by its ranges along the plane's axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    /// The plane.
    pub plane: Plane,
    /// The range along the x axis.
    pub x: Interval,
    /// The range along the y axis.
    pub y: Interval,
}
