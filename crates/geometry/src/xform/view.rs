//! From the world to the screen and back.

use crate::{Error, Interval, Plane, Result, Xform};

/// What a camera sees, in its own coordinates: it looks along −z, x to the right, y up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frustum {
    /// The range of x, for a perspective at the near distance.
    pub x: Interval,
    /// The range of y, for a perspective at the near distance.
    pub y: Interval,
    /// The distances of the near and the far plane in front of the camera; for a perspective both above 0.
    pub depth: Interval,
}

impl Xform {
    /// The map from world coordinates to those of a camera at the plane's origin that looks against its normal.
    pub fn world_to_camera(camera: &Plane) -> Self {
        Self::world_to_plane(camera)
    }

    /// The inverse of [`Xform::world_to_camera`].
    pub const fn camera_to_world(camera: &Plane) -> Self {
        Self::plane_to_world(camera)
    }

    /// The map that takes the frustum to the cube −1…1: the near plane to z = 1, the far plane to z = −1. With
    /// `perspective` it is the projective map of a frustum whose tip is the camera, else a scale.
    ///
    /// # Errors
    /// A range is empty or not finite, or a distance of a perspective not above 0.
    pub fn camera_to_clip(frustum: &Frustum, perspective: bool) -> Result<Self> {
        let Frustum { x, y, depth } = *frustum;
        for (what, range) in [("range of x", x), ("range of y", y), ("range of depth", depth)] {
            if !(range.length().is_finite() && range.length() != 0.0) {
                return Err(Error::degenerate(what, "it must be finite and not empty"));
            }
        }
        let sum = |r: Interval| r.start + r.end;
        let (n, f) = (depth.start, depth.end);
        let rows = if perspective {
            if !(n > 0.0 && f > 0.0) {
                let value = n.min(f);
                return Err(Error::OutOfRange {
                    what: "distance of a perspective",
                    value,
                    must: "greater than 0",
                });
            }
            [
                [2.0 * n / x.length(), 0.0, sum(x) / x.length(), 0.0],
                [0.0, 2.0 * n / y.length(), sum(y) / y.length(), 0.0],
                [0.0, 0.0, sum(depth) / depth.length(), 2.0 * n * f / depth.length()],
                [0.0, 0.0, -1.0, 0.0],
            ]
        } else {
            [
                [2.0 / x.length(), 0.0, 0.0, -sum(x) / x.length()],
                [0.0, 2.0 / y.length(), 0.0, -sum(y) / y.length()],
                [0.0, 0.0, 2.0 / depth.length(), sum(depth) / depth.length()],
                [0.0, 0.0, 0.0, 1.0],
            ]
        };
        let m = Self { rows };
        if m.is_finite() { Ok(m) } else { Err(Error::NotFinite("map of the frustum")) }
    }

    /// The inverse of [`Xform::camera_to_clip`].
    ///
    /// # Errors
    /// As there.
    pub fn clip_to_camera(frustum: &Frustum, perspective: bool) -> Result<Self> {
        let m = Self::camera_to_clip(frustum, perspective)?;
        m.inverse().ok_or(Error::degenerate("frustum", "its map has no inverse"))
    }

    /// The map of the cube −1…1 to a screen: x and y to the ranges from left to right and from bottom to top, z = −1
    /// (far) to the start of `depth` and z = 1 (near) to its end. Ranges may run backwards, as from the top down.
    pub fn clip_to_screen(x: Interval, y: Interval, depth: Interval) -> Self {
        let mut m = Self::IDENTITY;
        for (i, range) in [x, y, depth].into_iter().enumerate() {
            m.rows[i][i] = 0.5 * range.length();
            m.rows[i][3] = range.middle();
        }
        m
    }

    /// The inverse of [`Xform::clip_to_screen`].
    ///
    /// # Errors
    /// A range is empty.
    pub fn screen_to_clip(x: Interval, y: Interval, depth: Interval) -> Result<Self> {
        Self::clip_to_screen(x, y, depth)
            .inverse()
            .ok_or(Error::degenerate("range of the screen", "it is empty"))
    }

    /// The map that changes one coordinate (0 for x, 1 for y, 2 for z) linearly so that one range becomes another.
    ///
    /// # Errors
    /// There is no such coordinate, the first range is empty, or a number is not finite.
    pub fn interval_change(coordinate: usize, from: Interval, to: Interval) -> Result<Self> {
        if coordinate > 2 {
            return Err(Error::OutOfRange {
                what: "coordinate",
                value: coordinate as f64,
                must: "0, 1 or 2",
            });
        }
        let factor = to.length() / from.length();
        if !factor.is_finite() {
            return Err(Error::degenerate("range to change", "it is empty or not finite"));
        }
        let mut m = Self::IDENTITY;
        m.rows[coordinate][coordinate] = factor;
        m.rows[coordinate][3] = to.start - factor * from.start;
        if m.is_finite() { Ok(m) } else { Err(Error::NotFinite("range")) }
    }
}
