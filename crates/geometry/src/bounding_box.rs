use crate::Point3;

/// A box along the world axes that holds something. It is never empty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundingBox {
    /// The smallest coordinates.
    pub min: Point3,
    /// The largest coordinates.
    pub max: Point3,
}
