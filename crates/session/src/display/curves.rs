//! Curves as segments.

use katydid_geometry::{Curve, Point3, PolylineLimits};
use katydid_scene::tessellated;

/// How far the segments of a curve stray from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Smoothness {
    /// As a part of the curve's size.
    distance: f64,
    /// The turn from one segment to the next, in radians.
    angle: f64,
}

/// With more curves than this in one object, each is drawn with fewer segments.
const MANY: usize = 2000;
/// And with more than this in all, while something is dragged.
const MANY_DRAGGED: usize = 60;

impl Smoothness {
    const FINE: Self = Self { distance: 2e-4, angle: 0.09 };
    const COARSE: Self = Self { distance: 1e-3, angle: 0.26 };

    /// That of an object which shows so many curves.
    pub(crate) fn for_curves(count: usize) -> Self {
        if count > MANY { Self::COARSE } else { Self::FINE }
    }

    /// That of an object which shows so many curves of `all` while something is dragged.
    pub(crate) fn dragged(count: usize, all: usize) -> Self {
        if all > MANY_DRAGGED { Self::COARSE } else { Self::for_curves(count) }
    }

    /// The points of a curve.
    pub(crate) fn points(self, curve: &Curve) -> Vec<Point3> {
        let size = curve.bounding_box().diagonal().length();
        let limits = PolylineLimits {
            distance: self.distance * size,
            angle: Some(self.angle),
            shortest: 0.1 * self.distance * size,
            longest: None,
        };
        if limits.distance > 0.0
            && let Ok(polyline) = curve.to_polyline(&limits)
            && polyline.points().len() < 200_000
        {
            return polyline.points().to_vec();
        }
        tessellated(curve, self.distance * size)
    }
}
