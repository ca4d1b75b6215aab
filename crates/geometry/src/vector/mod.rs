mod angle;
mod decompose;
mod thresholds;

use crate::vector::thresholds::SAFE_SQUARE;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A direction with a magnitude. It has no place: all arrows of equal direction and length are one vector.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Vector3 {
    /// First component.
    pub x: f64,
    /// Second component.
    pub y: f64,
    /// Third component.
    pub z: f64,
}

impl Vector3 {
    /// The vector without length or direction.
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);
    /// The unit vector along x.
    pub const X: Self = Self::new(1.0, 0.0, 0.0);
    /// The unit vector along y.
    pub const Y: Self = Self::new(0.0, 1.0, 0.0);
    /// The unit vector along z.
    pub const Z: Self = Self::new(0.0, 0.0, 1.0);

    /// The vector with the three components.
    #[inline]
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    /// The scalar product a·b = |a||b| cos θ.
    #[inline]
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The vector product a×b: perpendicular to both by the right-hand rule, |a||b| sin θ long.
    #[inline]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// The length squared, a·a.
    #[inline]
    pub fn length_squared(self) -> f64 {
        self.dot(self)
    }

    /// The length; NaN when a component is. Scaled by the largest component where squaring would overflow or underflow.
    #[inline]
    pub fn length(self) -> f64 {
        let squared = self.length_squared();
        if squared > SAFE_SQUARE[0] && squared < SAFE_SQUARE[1] {
            return squared.sqrt();
        }
        if squared.is_nan() {
            // `max` would pass over the component that is not a number.
            return squared;
        }
        let largest = self.x.abs().max(self.y.abs()).max(self.z.abs());
        if largest == 0.0 || !largest.is_finite() {
            return largest;
        }
        let v = Self::new(self.x / largest, self.y / largest, self.z / largest);
        largest * v.length_squared().sqrt()
    }

    /// The vector of length 1 in the same direction; `None` for a vector without direction (zero, NaN, infinite).
    #[inline]
    pub fn unitized(self) -> Option<Self> {
        let length = self.length();
        // Below the smallest normal number the quotient has no correct digits (openNURBS refuses there too).
        (length >= f64::MIN_POSITIVE && length.is_finite()).then(|| self / length)
    }

    /// Whether all three components are finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }
}

impl From<[f64; 3]> for Vector3 {
    fn from([x, y, z]: [f64; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl From<Vector3> for [f64; 3] {
    fn from(v: Vector3) -> Self {
        [v.x, v.y, v.z]
    }
}

impl Add for Vector3 {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.x + o.x, self.y + o.y, self.z + o.z)
    }
}

impl AddAssign for Vector3 {
    #[inline]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}

impl Sub for Vector3 {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::new(self.x - o.x, self.y - o.y, self.z - o.z)
    }
}

impl SubAssign for Vector3 {
    #[inline]
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}

impl Neg for Vector3 {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl Mul<f64> for Vector3 {
    type Output = Self;
    #[inline]
    fn mul(self, s: f64) -> Self {
        Self::new(self.x * s, self.y * s, self.z * s)
    }
}

impl Mul<Vector3> for f64 {
    type Output = Vector3;
    #[inline]
    fn mul(self, v: Vector3) -> Vector3 {
        v * self
    }
}

impl Div<f64> for Vector3 {
    type Output = Self;
    #[inline]
    fn div(self, s: f64) -> Self {
        Self::new(self.x / s, self.y / s, self.z / s)
    }
}
