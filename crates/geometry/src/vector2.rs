use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use katydid_elementary::Elementary;

use crate::Vector3;

/// A direction with a magnitude in a plane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Vector2 {
    /// First component.
    pub x: f64,
    /// Second component.
    pub y: f64,
}

impl Vector2 {
    /// The vector without length or direction.
    pub const ZERO: Self = Self::new(0.0, 0.0);
    /// The unit vector along x.
    pub const X: Self = Self::new(1.0, 0.0);
    /// The unit vector along y.
    pub const Y: Self = Self::new(0.0, 1.0);

    /// The vector with the two components.
    #[inline]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The vector in space with no third component.
    #[inline]
    pub const fn to_vector3(self) -> Vector3 {
        Vector3::new(self.x, self.y, 0.0)
    }

    /// The scalar product |a||b| cos θ.
    #[inline]
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// |a||b| sin θ with the sign of the turn from this vector to `other`: positive to the left. It is the area of the
    /// parallelogram between them.
    #[inline]
    pub fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// The length squared.
    #[inline]
    pub fn length_squared(self) -> f64 {
        self.dot(self)
    }

    /// The length, without overflow.
    #[inline]
    pub fn length(self) -> f64 {
        self.x.hypotenuse(self.y)
    }

    /// The vector of length 1 in the same direction; `None` for a vector without direction.
    #[inline]
    pub fn unitized(self) -> Option<Self> {
        let length = self.length();
        (length >= f64::MIN_POSITIVE && length.is_finite()).then(|| self / length)
    }

    /// This vector turned left by a quarter.
    #[inline]
    #[must_use]
    pub const fn perpendicular(self) -> Self {
        Self::new(-self.y, self.x)
    }

    /// This vector turned left by `angle` radians.
    #[must_use]
    pub fn rotated(self, angle: f64) -> Self {
        let (sin, cos) = angle.sine_cosine();
        Self::new(self.x * cos - self.y * sin, self.x * sin + self.y * cos)
    }

    /// The angle in radians from this vector to `other`, −π…π, positive to the left; `None` when one of them has no
    /// direction.
    pub fn signed_angle_to(self, other: Self) -> Option<f64> {
        let (a, b) = (self.unitized()?, other.unitized()?);
        Some(a.cross(b).arctangent_of(a.dot(b)))
    }

    /// Whether both components are finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl From<[f64; 2]> for Vector2 {
    fn from([x, y]: [f64; 2]) -> Self {
        Self::new(x, y)
    }
}

impl From<Vector2> for [f64; 2] {
    fn from(v: Vector2) -> Self {
        [v.x, v.y]
    }
}

impl Add for Vector2 {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.x + o.x, self.y + o.y)
    }
}

impl AddAssign for Vector2 {
    #[inline]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}

impl Sub for Vector2 {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::new(self.x - o.x, self.y - o.y)
    }
}

impl SubAssign for Vector2 {
    #[inline]
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}

impl Neg for Vector2 {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}

impl Mul<f64> for Vector2 {
    type Output = Self;
    #[inline]
    fn mul(self, s: f64) -> Self {
        Self::new(self.x * s, self.y * s)
    }
}

impl Mul<Vector2> for f64 {
    type Output = Vector2;
    #[inline]
    fn mul(self, v: Vector2) -> Vector2 {
        v * self
    }
}

impl Div<f64> for Vector2 {
    type Output = Self;
    #[inline]
    fn div(self, s: f64) -> Self {
        Self::new(self.x / s, self.y / s)
    }
}
