//! Straight segments.

mod boxes;
mod fit;

use crate::{BoundingBox, Point3, Vector3, Xform};

/// A straight segment; its infinite line is P = from + t·direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// The start, at t = 0.
    pub from: Point3,
    /// The end, at t = 1.
    pub to: Point3,
}

impl Line {
    /// The part of the line without ends that lies in front of a box, seen along the plane across it: beyond, the line is
    /// nowhere near what the box holds. `None` for a line without length or a number that is not finite.
    pub fn beside(&self, bounds: &BoundingBox) -> Option<Self> {
        let direction = self.unit_direction()?;
        let along = bounds.corners().map(|p| (p - self.from).dot(direction));
        let low = along.into_iter().fold(f64::INFINITY, f64::min);
        let high = along.into_iter().fold(f64::NEG_INFINITY, f64::max);
        // A little more than the box, so that what touches its sides is met.
        let margin = (high - low).max(self.length());
        let part = Self::new(self.from + direction * (low - margin), self.from + direction * (high + margin));
        part.is_finite().then_some(part)
    }

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

    /// The unit vector from start to end; `None` for a segment without length.
    #[inline]
    pub fn unit_direction(&self) -> Option<Vector3> {
        self.direction().unitized()
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

    /// The point halfway.
    #[inline]
    pub fn midpoint(&self) -> Point3 {
        self.at(0.5)
    }

    /// The parameter of the point on the infinite line that is nearest to `p`; 0 for a segment without length.
    pub fn closest_parameter(&self, p: Point3) -> f64 {
        let d = self.direction();
        let squared = d.length_squared();
        if !(squared > 0.0) {
            return 0.0;
        }
        // Measured from the nearer end, as openNURBS does: the other end would cost digits.
        let (a, b) = (p - self.from, p - self.to);
        if a.length_squared() <= b.length_squared() { a.dot(d) / squared } else { 1.0 + b.dot(d) / squared }
    }

    /// The point of the segment nearest to `p`.
    pub fn closest_point(&self, p: Point3) -> Point3 {
        self.at(self.closest_parameter(p).clamp(0.0, 1.0))
    }

    /// The distance from `p` to the segment.
    pub fn distance_to(&self, p: Point3) -> f64 {
        self.closest_point(p).distance_to(p)
    }

    /// The segment from its end to its start.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self::new(self.to, self.from)
    }

    /// The segment lengthened by `at_start` and `at_end` (shortened where they are negative); unchanged when it has
    /// no direction.
    #[must_use]
    pub fn extended(&self, at_start: f64, at_end: f64) -> Self {
        match self.unit_direction() {
            Some(d) => Self::new(self.from - d * at_start, self.to + d * at_end),
            None => *self,
        }
    }

    /// The segment between the images of the ends.
    #[must_use]
    pub fn transformed(&self, xform: &Xform) -> Self {
        Self::new(xform.point(self.from), xform.point(self.to))
    }

    /// Whether both ends are finite.
    pub fn is_finite(&self) -> bool {
        self.from.is_finite() && self.to.is_finite()
    }
}
