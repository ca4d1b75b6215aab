//! Where lines in one direction meet a surface, prepared for many of them.

use std::ops::ControlFlow;

use crate::box_tree::{Bounds, BoxTree, bounds_of, squared_distance_to};
use crate::intersect::curve_with_surface_within;
use crate::{
    BoundingBox, ClosestOnSurface, Curve, Direction, Error, Interval, Line, Point3, Result, Surface, Vector3,
};

/// A line of which more pairs of parts are looked at lies next to the surface; others need some hundreds.
const MOST_VISITS: u64 = 20_000;
/// How near a line must come to the surface at first, as a part of the size; Newton's method finds the place after that.
const NEAR: f64 = 1e-6;
/// A surface of more patches is searched as a whole.
const MOST_PATCHES: usize = 1 << 14;

/// A surface cut at its knots, its patches in boxes across a direction: a line in that direction is met with those alone
/// whose boxes it enters.
pub(crate) struct LineIndex {
    pub(super) direction: Vector3,
    /// Two directions across.
    pub(super) across: [Vector3; 2],
    pub(super) bounds: BoundingBox,
    patches: Vec<Surface>,
    tree: BoxTree,
    /// Gives the parameters of a surface that has others than its NURBS form.
    own: Option<ClosestOnSurface>,
}

/// Where a line meets a surface.
pub(super) struct Met {
    /// The parameters of the places.
    pub(super) places: Vec<[f64; 2]>,
    /// Whether the line runs in the surface for a while, or too near to it to tell.
    pub(super) along: bool,
}

impl LineIndex {
    /// # Errors
    /// The direction has no length, or the surface has no NURBS form.
    pub(crate) fn new(surface: &Surface, direction: Vector3) -> Result<Self> {
        let none = || Error::degenerate("direction", "it has no length");
        let direction = direction.unitized().ok_or_else(none)?;
        let x = direction.perpendicular().ok_or_else(none)?;
        let across = [x, direction.cross(x)];
        let whole = Surface::from(surface.to_nurbs()?);
        let patches = patches(&whole)?;
        let seen = |patch: &Surface| -> Result<Bounds> {
            let points = patch.to_nurbs()?.control_points();
            Ok(bounds_of(points.into_iter().map(|p| place(across, p))))
        };
        let boxes = patches.iter().map(seen).collect::<Result<Vec<Bounds>>>()?;
        let own = match surface {
            Surface::Nurbs(_) => None,
            other => Some(ClosestOnSurface::new(other)?),
        };
        let bounds = surface.bounding_box()?;
        Ok(Self { direction, across, bounds, patches, tree: BoxTree::by_place(&boxes), own })
    }

    /// Where the line through a point meets the surface, as far as `reach` to both sides, in a figure of a given size.
    pub(super) fn meet(&self, p: Point3, reach: f64, size: f64) -> Result<Met> {
        let (q, near) = (place(self.across, p), NEAR * size);
        let mut entered = Vec::new();
        self.tree.visit_where(
            |bounds| squared_distance_to(bounds, &q) <= near * near,
            |patch| {
                entered.push(patch);
                ControlFlow::Continue(())
            },
        );
        entered.sort_unstable();
        let line: Curve = Line::new(p - self.direction * reach, p + self.direction * reach).into();
        let mut met = Met { places: Vec::new(), along: false };
        for patch in entered.into_iter().filter_map(|i| self.patches.get(i)) {
            let found = curve_with_surface_within(&line, patch, near, MOST_VISITS)?;
            met.along |= !found.complete || !found.overlaps.is_empty();
            for hit in &found.crossings {
                met.places.push(match &self.own {
                    Some(own) => own.nearest(hit.point).map(|near| [near.u, near.v])?,
                    None => [hit.u, hit.v],
                });
            }
        }
        Ok(met)
    }
}

/// Coordinates across the direction.
fn place(across: [Vector3; 2], p: Point3) -> [f64; 3] {
    let [x, y] = across.map(|a| p.to_vector().dot(a));
    [x, y, 0.0]
}

/// The parts of a NURBS surface between its knots.
fn patches(whole: &Surface) -> Result<Vec<Surface>> {
    let [us, vs] = Direction::BOTH.map(|d| whole.span_parameters(d));
    if us.len().saturating_mul(vs.len()) > MOST_PATCHES {
        return Ok(vec![whole.clone()]);
    }
    let ranges = |knots: &[f64]| -> Vec<Interval> {
        knots.windows(2).map(|w| Interval::new(w[0], w[1])).filter(|range| range.is_increasing()).collect()
    };
    let (us, vs) = (ranges(&us), ranges(&vs));
    let mut out = Vec::with_capacity(us.len() * vs.len());
    for u in us {
        let row = whole.trimmed(Direction::U, u)?;
        for v in &vs {
            out.push(row.trimmed(Direction::V, *v)?);
        }
    }
    Ok(out)
}
