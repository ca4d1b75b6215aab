//! Quaternions: turns as four numbers.

use std::ops::{Add, Div, Mul, Neg, Sub};

use katydid_elementary::Elementary;

use crate::{Error, Plane, Point3, Result, Vector3, Xform};

/// Below this angle, in radians, the way between two rotations is straight to rounding.
const STRAIGHT_ANGLE: f64 = 1e-8;
/// A map turns when its columns are unit and at right angles to this.
const ROTATION: f64 = 1e-9;

/// The quaternion w + x·i + y·j + z·k. One of length 1 stands for the rotation v ↦ q·v·q̄; q and −q for the same.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Quaternion {
    /// The real part.
    pub w: f64,
    /// The part of i.
    pub x: f64,
    /// The part of j.
    pub y: f64,
    /// The part of k.
    pub z: f64,
}

impl Quaternion {
    /// 1: the rotation that turns nothing.
    pub const IDENTITY: Self = Self::new(1.0, 0.0, 0.0, 0.0);
    /// 0.
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0, 0.0);
    /// The unit i: half a turn about x.
    pub const I: Self = Self::new(0.0, 1.0, 0.0, 0.0);
    /// The unit j: half a turn about y.
    pub const J: Self = Self::new(0.0, 0.0, 1.0, 0.0);
    /// The unit k: half a turn about z.
    pub const K: Self = Self::new(0.0, 0.0, 0.0, 1.0);

    /// The quaternion w + x·i + y·j + z·k.
    #[inline]
    pub const fn new(w: f64, x: f64, y: f64, z: f64) -> Self {
        Self { w, x, y, z }
    }

    /// The quaternion with a real part and a vector for the parts of i, j and k.
    #[inline]
    pub const fn from_parts(real: f64, v: Vector3) -> Self {
        Self::new(real, v.x, v.y, v.z)
    }

    /// The parts of i, j and k.
    #[inline]
    pub const fn vector(self) -> Vector3 {
        Vector3::new(self.x, self.y, self.z)
    }

    /// The rotation by `angle` radians about an axis, by the right-hand rule.
    ///
    /// # Errors
    /// The axis has no direction, or the angle is not finite.
    pub fn rotation(angle: f64, axis: Vector3) -> Result<Self> {
        if !angle.is_finite() {
            return Err(Error::NotFinite("rotation angle"));
        }
        let k = axis.unitized().ok_or(Error::degenerate("rotation axis", "it has no direction"))?;
        let (sin, cos) = (0.5 * angle).sine_cosine();
        Ok(Self::from_parts(cos, k * sin))
    }

    /// The rotation that turns the axes of one plane into those of another.
    pub fn between_planes(from: &Plane, to: &Plane) -> Self {
        let at_origin = |p: &Plane| p.with_origin(Point3::ORIGIN);
        let m = Xform::plane_to_plane(&at_origin(from), &at_origin(to));
        Self::from_rows(&m)
    }

    /// The rotation of a matrix; `None` when it is none within `tolerance`.
    pub fn from_xform(m: &Xform, tolerance: f64) -> Option<Self> {
        m.linear_part().is_rigid(tolerance).then(|| Self::from_rows(m)).and_then(Self::unitized)
    }

    /// By the largest of the four numbers, so that none comes out of a difference of near equals (S. Shepperd,
    /// *Quaternion from rotation matrix*, J. Guidance and Control 1, 1978).
    fn from_rows(m: &Xform) -> Self {
        let r = &m.rows;
        let trace = r[0][0] + r[1][1] + r[2][2];
        let q = if trace >= r[0][0].max(r[1][1]).max(r[2][2]) {
            Self::new(1.0 + trace, r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1])
        } else if r[0][0] >= r[1][1].max(r[2][2]) {
            Self::new(
                r[2][1] - r[1][2],
                1.0 + r[0][0] - r[1][1] - r[2][2],
                r[0][1] + r[1][0],
                r[0][2] + r[2][0],
            )
        } else if r[1][1] >= r[2][2] {
            Self::new(
                r[0][2] - r[2][0],
                r[0][1] + r[1][0],
                1.0 + r[1][1] - r[0][0] - r[2][2],
                r[1][2] + r[2][1],
            )
        } else {
            Self::new(
                r[1][0] - r[0][1],
                r[0][2] + r[2][0],
                r[1][2] + r[2][1],
                1.0 + r[2][2] - r[0][0] - r[1][1],
            )
        };
        q.unitized().unwrap_or(Self::IDENTITY)
    }

    /// The rotation as a matrix; for a quaternion of length 0 `None`.
    pub fn to_xform(self) -> Option<Xform> {
        let q = self.unitized()?;
        let column = |v: Vector3| q.turn(v);
        Some(Xform::from_columns(column(Vector3::X), column(Vector3::Y), column(Vector3::Z), Point3::ORIGIN))
    }

    /// The vector turned by this rotation; `None` for a quaternion of length 0.
    pub fn rotate(self, v: Vector3) -> Option<Vector3> {
        self.unitized().map(|q| q.turn(v))
    }

    /// v + 2·u×(u×v + w·v) with u the vector part, for a unit quaternion.
    fn turn(self, v: Vector3) -> Vector3 {
        let u = self.vector();
        v + u.cross(u.cross(v) + v * self.w) * 2.0
    }

    /// The angle in radians, 0…2π, and the unit axis of this rotation; for one that turns nothing the axis is z. `None`
    /// for a quaternion of length 0.
    pub fn angle_and_axis(self) -> Option<(f64, Vector3)> {
        let q = self.unitized()?;
        let sin = q.vector().length();
        Some((2.0 * sin.arctangent_of(q.w), q.vector().unitized().unwrap_or(Vector3::Z)))
    }

    /// The four numbers as a scalar product.
    #[inline]
    pub fn dot(self, other: Self) -> f64 {
        self.w * other.w + self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The length.
    pub fn length(self) -> f64 {
        let v = self.vector().length();
        if self.w.abs() > v { self.w.abs() * (v / self.w).hypotenuse(1.0) } else { v.hypotenuse(self.w) }
    }

    /// The quaternion of length 1 in the same direction; `None` for one without length or not finite.
    pub fn unitized(self) -> Option<Self> {
        let length = self.length();
        (length >= f64::MIN_POSITIVE && length.is_finite()).then(|| self / length)
    }

    /// w − x·i − y·j − z·k: for a unit quaternion the rotation back.
    #[inline]
    #[must_use]
    pub const fn conjugate(self) -> Self {
        Self::new(self.w, -self.x, -self.y, -self.z)
    }

    /// The inverse: q·q⁻¹ = 1. `None` for a quaternion without length.
    pub fn inverse(self) -> Option<Self> {
        let length = self.length();
        self.unitized().map(|q| q.conjugate() / length)
    }

    /// Whether all four numbers are finite.
    pub fn is_finite(self) -> bool {
        self.w.is_finite() && self.vector().is_finite()
    }

    /// e^q.
    #[must_use]
    pub fn exp(self) -> Self {
        let (angle, size) = (self.vector().length(), self.w.exponential());
        let (sin, cos) = angle.sine_cosine();
        let factor = if angle > 0.0 { sin / angle } else { 1.0 };
        Self::from_parts(size * cos, self.vector() * (size * factor))
    }

    /// The principal logarithm; of a negative real number with the direction i. `None` for a quaternion without length.
    pub fn ln(self) -> Option<Self> {
        let length = self.length();
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        let sin = self.vector().length();
        let angle = sin.arctangent_of(self.w);
        let v = if sin > 0.0 { self.vector() * (angle / sin) } else { Vector3::X * angle };
        Some(Self::from_parts(length.logarithm(), v))
    }

    /// The power q^t = e^(t·ln q); `None` for a quaternion without length.
    pub fn pow(self, t: f64) -> Option<Self> {
        Some((self.ln()? * t).exp())
    }

    /// Between two rotations along the shorter way at an even angular speed: the first at t = 0, the second at t = 1.
    /// Both are taken at length 1; `None` when one has no length.
    ///
    /// K. Shoemake, *Animating rotation with quaternion curves*, SIGGRAPH 1985.
    pub fn slerp(self, other: Self, t: f64) -> Option<Self> {
        let (a, mut b) = (self.unitized()?, other.unitized()?);
        if a.dot(b) < 0.0 {
            b = -b;
        }
        // Half of the angle between them by the lengths of sum and difference, which is exact for small angles.
        let angle = 2.0 * (a - b).length().arctangent_of((a + b).length());
        let sin = angle.sine();
        if angle < STRAIGHT_ANGLE || sin == 0.0 {
            return (a * (1.0 - t) + b * t).unitized();
        }
        (a * (((1.0 - t) * angle).sine() / sin) + b * ((t * angle).sine() / sin)).unitized()
    }

    /// This rotation turned towards another by at most `angle` radians, along the shorter way. `None` when one of them
    /// has no length.
    pub fn rotate_towards(self, other: Self, angle: f64) -> Option<Self> {
        let (a, b) = (self.unitized()?, other.unitized()?);
        let nearest = if a.dot(b) < 0.0 { -b } else { b };
        // The rotation turns by twice the angle between the quaternions.
        let whole = 4.0 * (a - nearest).length().arctangent_of((a + nearest).length());
        if whole <= angle { Some(b) } else { a.slerp(b, angle / whole) }
    }

    /// Roll about x, then pitch about y, then yaw about z, in radians: as [`Xform::rotation_zyx`].
    pub fn from_yaw_pitch_roll(yaw: f64, pitch: f64, roll: f64) -> Self {
        let about = |angle: f64, axis: Vector3| {
            let (sin, cos) = (0.5 * angle).sine_cosine();
            Self::from_parts(cos, axis * sin)
        };
        about(yaw, Vector3::Z) * about(pitch, Vector3::Y) * about(roll, Vector3::X)
    }

    /// Yaw, pitch and roll in radians of this rotation, as [`Xform::yaw_pitch_roll`]; `None` for a quaternion without
    /// length.
    pub fn yaw_pitch_roll(self) -> Option<[f64; 3]> {
        self.to_xform()?.yaw_pitch_roll(ROTATION)
    }

    /// Euler's angles Z·Y·Z of this rotation, as [`Xform::euler_zyz`]; `None` for a quaternion without length.
    pub fn euler_zyz(self) -> Option<[f64; 3]> {
        self.to_xform()?.euler_zyz(ROTATION)
    }
}

impl Mul for Quaternion {
    type Output = Self;

    /// The product; of two rotations the one that first turns by `o`, then by `self`.
    fn mul(self, o: Self) -> Self {
        let (u, v) = (self.vector(), o.vector());
        Self::from_parts(self.w * o.w - u.dot(v), v * self.w + u * o.w + u.cross(v))
    }
}

impl Add for Quaternion {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self::new(self.w + o.w, self.x + o.x, self.y + o.y, self.z + o.z)
    }
}

impl Sub for Quaternion {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self::new(self.w - o.w, self.x - o.x, self.y - o.y, self.z - o.z)
    }
}

impl Neg for Quaternion {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.w, -self.x, -self.y, -self.z)
    }
}

impl Mul<f64> for Quaternion {
    type Output = Self;
    fn mul(self, s: f64) -> Self {
        Self::new(self.w * s, self.x * s, self.y * s, self.z * s)
    }
}

impl Div<f64> for Quaternion {
    type Output = Self;
    fn div(self, s: f64) -> Self {
        Self::new(self.w / s, self.x / s, self.y / s, self.z / s)
    }
}
