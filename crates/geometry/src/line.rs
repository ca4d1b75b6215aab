use crate::{Point3, Vector3};

/// A straight segment; its infinite line is P = from + t·direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// The start, at t = 0.
    pub from: Point3,
    /// The end, at t = 1.
    pub to: Point3,
}

impl Line {
    /// The segment between two points.
    #[inline]
    pub const fn new(from: Point3, to: Point3) -> Self {
        Self { from, to }
    }

    /// The vector from start to end.
    #[inline]
    pub fn direction(&self) -> Vector3 {
        self.to - self.from
    }

    /// The length of the segment.
    #[inline]
    pub fn length(&self) -> f64 {
        self.direction().length()
    }

    /// The point at `t`: the start at 0, the end at 1, and beyond them outside 0…1.
    #[inline]
    pub fn at(&self, t: f64) -> Point3 {
        self.from.lerp(self.to, t)
    }
}
