use std::ops::{Add, AddAssign, Sub, SubAssign};

use crate::{Point3, Vector2};

/// A location in a plane, in its own coordinates: the parameters of a surface, or a point of a drawing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Point2 {
    /// First coordinate.
    pub x: f64,
    /// Second coordinate.
    pub y: f64,
}

impl Point2 {
    /// The origin.
    pub const ORIGIN: Self = Self::new(0.0, 0.0);

    /// The point at the two coordinates.
    #[inline]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The vector from the origin to this point.
    #[inline]
    pub const fn to_vector(self) -> Vector2 {
        Vector2::new(self.x, self.y)
    }

    /// The point in space at height 0.
    #[inline]
    pub const fn to_point3(self) -> Point3 {
        Point3::new(self.x, self.y, 0.0)
    }

    /// The distance to another point.
    #[inline]
    pub fn distance_to(self, other: Self) -> f64 {
        (other - self).length()
    }

    /// The point at `t` on the way to `other`: this point at 0, the other at 1.
    #[inline]
    pub fn lerp(self, other: Self, t: f64) -> Self {
        Self::new((1.0 - t) * self.x + t * other.x, (1.0 - t) * self.y + t * other.y)
    }

    /// Whether both coordinates are finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl Vector2 {
    /// The point at the tip of this vector when it starts at the origin.
    #[inline]
    pub const fn to_point(self) -> Point2 {
        Point2::new(self.x, self.y)
    }
}

impl From<[f64; 2]> for Point2 {
    fn from([x, y]: [f64; 2]) -> Self {
        Self::new(x, y)
    }
}

impl From<Point2> for [f64; 2] {
    fn from(p: Point2) -> Self {
        [p.x, p.y]
    }
}

impl Add<Vector2> for Point2 {
    type Output = Self;
    #[inline]
    fn add(self, v: Vector2) -> Self {
        Self::new(self.x + v.x, self.y + v.y)
    }
}

impl AddAssign<Vector2> for Point2 {
    #[inline]
    fn add_assign(&mut self, v: Vector2) {
        *self = *self + v;
    }
}

impl Sub<Vector2> for Point2 {
    type Output = Self;
    #[inline]
    fn sub(self, v: Vector2) -> Self {
        Self::new(self.x - v.x, self.y - v.y)
    }
}

impl SubAssign<Vector2> for Point2 {
    #[inline]
    fn sub_assign(&mut self, v: Vector2) {
        *self = *self - v;
    }
}

impl Sub for Point2 {
    type Output = Vector2;
    #[inline]
    fn sub(self, other: Self) -> Vector2 {
        Vector2::new(self.x - other.x, self.y - other.y)
    }
}
