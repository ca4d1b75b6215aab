//! glam's double-precision types.

use glam::{DMat4, DQuat, DVec2, DVec3};

use crate::{Point2, Point3, Quaternion, Vector2, Vector3, Xform};

macro_rules! both_ways {
    ($($ours:ident, $theirs:ident { $($part:ident),* });* $(;)?) => { $(
        impl From<$ours> for $theirs {
            fn from(v: $ours) -> Self {
                Self::new($(v.$part),*)
            }
        }
        impl From<$theirs> for $ours {
            fn from(v: $theirs) -> Self {
                Self::new($(v.$part),*)
            }
        }
    )* };
}

both_ways! {
    Point2, DVec2 { x, y };
    Vector2, DVec2 { x, y };
    Point3, DVec3 { x, y, z };
    Vector3, DVec3 { x, y, z };
}

impl From<Xform> for DMat4 {
    /// Both transform columns; glam stores them one after another.
    fn from(m: Xform) -> Self {
        Self::from_cols_array_2d(&m.transposed().rows)
    }
}

impl From<DMat4> for Xform {
    fn from(m: DMat4) -> Self {
        Self { rows: m.to_cols_array_2d() }.transposed()
    }
}

impl From<Quaternion> for DQuat {
    fn from(q: Quaternion) -> Self {
        Self::from_xyzw(q.x, q.y, q.z, q.w)
    }
}

impl From<DQuat> for Quaternion {
    fn from(q: DQuat) -> Self {
        Self::new(q.w, q.x, q.y, q.z)
    }
}
