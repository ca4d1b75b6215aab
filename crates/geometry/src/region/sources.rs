//! The curves that go into an arrangement, in its plane and in smooth parts.

use crate::region::thresholds::ON_PLANE;
use std::ops::Range;

use super::winding::Outline;
use crate::{BoundingBox, Curve, Error, Plane, Point3, Result, Xform};

/// A curve in the plane.
#[derive(Debug)]
pub(super) struct Source {
    pub(super) curve: Curve,
    /// How often it runs around a point; an open curve around none.
    pub(super) outline: Option<Outline>,
    /// Which parts are its.
    pub(super) parts: Range<usize>,
}

/// A smooth part of a source: a line, an arc, or a NURBS curve without kinks.
#[derive(Debug)]
pub(super) struct Part {
    pub(super) curve: Curve,
    pub(super) source: usize,
    pub(super) bounds: BoundingBox,
}

/// All curves of an arrangement.
#[derive(Debug)]
pub(super) struct Sources {
    /// The plane, its origin near the curves.
    pub(super) plane: Plane,
    /// The largest absolute coordinate: what rounding is measured by.
    pub(super) scale: f64,
    pub(super) list: Vec<Source>,
    pub(super) parts: Vec<Part>,
}

/// The curve projected into the plane, or itself when it lies there as exactly as numbers allow.
pub(super) fn in_plane(curve: &Curve, plane: &Plane) -> Result<Curve> {
    let height = curve.extent_along(plane.z_axis);
    let own = plane.origin.to_vector().dot(plane.z_axis);
    let away = (height.start - own).abs().max((height.end - own).abs());
    let bounds = curve.bounding_box();
    let scale = reach(&bounds).max(own.abs());
    if away <= ON_PLANE * scale {
        Ok(curve.clone())
    } else {
        curve.transformed(&Xform::planar_projection(plane))
    }
}

/// The largest absolute coordinate in a box.
fn reach(bounds: &BoundingBox) -> f64 {
    let (a, b) = (bounds.min, bounds.max);
    [a.x, a.y, a.z, b.x, b.y, b.z].into_iter().fold(0.0, |m: f64, x| m.max(x.abs()))
}

impl Sources {
    /// Takes closed curves, projected into the plane. Ends of a curve may be as far apart as the tolerance.
    ///
    /// # Errors
    /// A curve is open, or a number overflows.
    pub(super) fn new<'a>(
        curves: impl IntoIterator<Item = &'a Curve>,
        plane: &Plane,
        tolerance: f64,
    ) -> Result<Self> {
        let sources = Self::with_open(curves, plane, tolerance)?;
        if sources.list.iter().any(|source| source.outline.is_none()) {
            return Err(Error::degenerate("region", "one of its curves is open and has no inside"));
        }
        Ok(sources)
    }

    /// Takes open curves too, which enclose nothing.
    ///
    /// # Errors
    /// A number overflows.
    pub(super) fn with_open<'a>(
        curves: impl IntoIterator<Item = &'a Curve>,
        plane: &Plane,
        tolerance: f64,
    ) -> Result<Self> {
        let mut flat = Vec::new();
        let mut all: Option<BoundingBox> = None;
        for curve in curves {
            let ends_meet = curve.start().distance_to(curve.end()) <= tolerance;
            let is_closed = curve.is_closed() || ends_meet && !matches!(curve, Curve::Line(_));
            let bounds = curve.bounding_box();
            if !(bounds.min.is_finite() && bounds.max.is_finite()) {
                return Err(Error::NotFinite("curve of the region"));
            }
            let curve = in_plane(curve, plane)?;
            let bounds = curve.bounding_box();
            all = Some(all.map_or(bounds, |b| b.union(&bounds)));
            flat.push((curve, is_closed));
        }
        let all = all.unwrap_or(BoundingBox { min: plane.origin, max: plane.origin });
        let middle: Point3 = all.min.lerp(all.max, 0.5);
        let mut out = Self {
            plane: plane.with_origin(plane.closest_point(middle)),
            scale: reach(&all),
            list: Vec::with_capacity(flat.len()),
            parts: Vec::new(),
        };
        for (curve, is_closed) in flat {
            let first = out.parts.len();
            for part in curve.smooth_parts()? {
                let bounds = part.bounding_box();
                out.parts.push(Part { curve: part, source: out.list.len(), bounds });
            }
            let outline = is_closed.then(|| Outline::new(&curve, &out.plane));
            out.list.push(Source { curve, outline, parts: first..out.parts.len() });
        }
        Ok(out)
    }
}
