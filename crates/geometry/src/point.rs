use std::ops::{Add, AddAssign, Sub, SubAssign};

use crate::Vector3;

/// Coordinates no further apart are one to openNURBS, in model units: 2⁻³².
const COINCIDENT: f64 = 2.328_306_436_538_696_3e-10;
/// The same as a part of both coordinates together: 2⁻⁴².
const COINCIDENT_OF_PLACE: f64 = 2.273_736_754_432_320_6e-13;

/// A location in space. Points are not vectors: a point plus a vector is a point, and the difference of two
/// points is a vector.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Point3 {
    /// First coordinate.
    pub x: f64,
    /// Second coordinate.
    pub y: f64,
    /// Third coordinate.
    pub z: f64,
}

impl Point3 {
    /// The origin.
    pub const ORIGIN: Self = Self::new(0.0, 0.0, 0.0);

    /// The point at the three coordinates.
    #[inline]
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    /// The vector from the origin to this point.
    #[inline]
    pub const fn to_vector(self) -> Vector3 {
        Vector3::new(self.x, self.y, self.z)
    }

    /// The distance to another point.
    #[inline]
    pub fn distance_to(self, other: Self) -> f64 {
        (other - self).length()
    }

    /// Whether two points are the same to openNURBS's eyes: each coordinate within 2⁻³², or 2⁻⁴² of both together.
    pub fn coincides(self, other: Self) -> bool {
        let near = |x: f64, y: f64| {
            let d = (x - y).abs();
            d <= COINCIDENT || d <= COINCIDENT_OF_PLACE * (x.abs() + y.abs())
        };
        near(self.x, other.x) && near(self.y, other.y) && near(self.z, other.z)
    }

    /// The point at `t` on the way to `other`: this point at 0, the other at 1.
    #[inline]
    pub fn lerp(self, other: Self, t: f64) -> Self {
        Self::new(
            (1.0 - t) * self.x + t * other.x,
            (1.0 - t) * self.y + t * other.y,
            (1.0 - t) * self.z + t * other.z,
        )
    }

    /// Whether all three coordinates are finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }
}

impl Point3 {
    /// The mean of points; `None` for none.
    pub fn mean(points: &[Self]) -> Option<Self> {
        let n = points.len() as f64;
        (!points.is_empty()).then(|| points.iter().map(|p| p.to_vector() / n).sum::<Vector3>().to_point())
    }

    /// Whether three points lie on a line: the distance of the one in the middle from the line through the outer two is
    /// at most `tolerance`.
    pub fn are_collinear(a: Self, b: Self, c: Self, tolerance: f64) -> bool {
        let sides = [(b - a).length(), (c - b).length(), (a - c).length()];
        let longest = sides.iter().copied().fold(0.0, f64::max);
        longest <= tolerance || (b - a).cross(c - a).length() <= tolerance * longest
    }
}

impl Vector3 {
    /// The point at the tip of this vector when it starts at the origin.
    #[inline]
    pub const fn to_point(self) -> Point3 {
        Point3::new(self.x, self.y, self.z)
    }
}

impl From<[f64; 3]> for Point3 {
    fn from([x, y, z]: [f64; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl From<Point3> for [f64; 3] {
    fn from(p: Point3) -> Self {
        [p.x, p.y, p.z]
    }
}

impl Add<Vector3> for Point3 {
    type Output = Self;
    #[inline]
    fn add(self, v: Vector3) -> Self {
        Self::new(self.x + v.x, self.y + v.y, self.z + v.z)
    }
}

impl AddAssign<Vector3> for Point3 {
    #[inline]
    fn add_assign(&mut self, v: Vector3) {
        *self = *self + v;
    }
}

impl Sub<Vector3> for Point3 {
    type Output = Self;
    #[inline]
    fn sub(self, v: Vector3) -> Self {
        Self::new(self.x - v.x, self.y - v.y, self.z - v.z)
    }
}

impl SubAssign<Vector3> for Point3 {
    #[inline]
    fn sub_assign(&mut self, v: Vector3) {
        *self = *self - v;
    }
}

impl Sub for Point3 {
    type Output = Vector3;
    #[inline]
    fn sub(self, other: Self) -> Vector3 {
        Vector3::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}
