//! Curves as segments.

use katydid_geometry::{BoundingBox, Curve, Point3, PolylineLimits};
use katydid_scene::tessellated;

use super::runs::{self, Limits};

/// How far the segments of a curve stray from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Smoothness {
    /// As a part of the curve's size.
    distance: f64,
    /// The turn from one segment to the next, in radians.
    angle: f64,
    /// Whether spans that bend little are one segment: else each ends one.
    is_dragged: bool,
}

/// With more curves than this in one object, each is drawn with fewer segments.
const MANY: usize = 2000;
/// And with more than this in all, while something is dragged.
const MANY_DRAGGED: usize = 60;

impl Smoothness {
    const FINE: Self = Self { distance: 2e-4, angle: 0.09, is_dragged: false };
    const DRAGGED: Self = Self { distance: 2e-3, angle: 0.3, is_dragged: true };
    const COARSE: Self = Self { distance: 1e-3, angle: 0.26, is_dragged: false };

    /// That of an object which shows so many curves.
    pub(crate) fn for_curves(count: usize) -> Self {
        if count > MANY { Self::COARSE } else { Self::FINE }
    }

    /// That of an object which shows so many curves of `all` while something is dragged.
    pub(crate) fn dragged(count: usize, all: usize) -> Self {
        if all > MANY_DRAGGED { Self::DRAGGED } else { Self::for_curves(count) }
    }

    /// The points of a curve.
    pub(crate) fn points(self, curve: &Curve) -> Vec<Point3> {
        let size = size(curve);
        if self.is_dragged {
            let mut points = Vec::new();
            runs::add(curve, Limits { distance: self.distance * size, angle: self.angle }, &mut points);
            if points.len() > 1 && size > 0.0 {
                return points;
            }
        }
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

/// The size of a curve, by the points that it is made of: the tight box of a long spline takes longer than to draw it.
fn size(curve: &Curve) -> f64 {
    bounds(curve).map_or(0.0, |all| all.diagonal().length())
}

fn bounds(curve: &Curve) -> Option<BoundingBox> {
    match curve {
        Curve::Nurbs(curve) => BoundingBox::from_points(curve.control_points()),
        Curve::Poly(curve) => curve.segments().iter().filter_map(bounds).reduce(|all, next| all.union(&next)),
        Curve::Line(_) | Curve::Arc(_) | Curve::Polyline(_) => Some(curve.bounding_box()),
    }
}
