//! Paths seen from above: how far away they are, on which side, and how high.

use katydid_component::{Context, List, Message};
use katydid_geometry::{Curve, Point3, PolylineLimits};

/// Curves are followed by segments that stray less than this part of a cell from them.
const STRAY: f64 = 0.02;
/// More segments than this would be looked at for hours.
const MOST_SEGMENTS: usize = 1_000_000;

/// The place of a path that is nearest to a point, seen from above.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Near {
    pub(super) distance: f64,
    pub(super) height: f64,
    /// Whether the point is on the left of the path.
    pub(super) is_left: bool,
}

/// Curves as segments.
#[derive(Debug, Default)]
pub(super) struct Paths {
    segments: Vec<[Point3; 2]>,
}

impl Paths {
    /// # Errors
    /// A curve cannot be followed, or there are too many segments.
    pub(super) fn new<'a>(
        context: &Context<'_>,
        curves: impl Iterator<Item = &'a Curve>,
        cell: [f64; 2],
    ) -> Result<Self, Message> {
        let limits = PolylineLimits::within(cell[0].min(cell[1]) * STRAY);
        let mut paths = Self::default();
        for curve in curves {
            context.check()?;
            let polyline = curve.to_polyline(&limits)?;
            paths
                .segments
                .extend(polyline.points().windows(2).filter_map(|pair| <[Point3; 2]>::try_from(pair).ok()));
            if paths.segments.len() > MOST_SEGMENTS {
                return Err(Message::error("The curves are too long for cells as small as these"));
            }
        }
        if paths.segments.is_empty() {
            return Err(Message::warning("There is no path"));
        }
        Ok(paths)
    }

    pub(super) fn of_list(
        context: &Context<'_>,
        curves: &List<'_, std::sync::Arc<Curve>>,
        cell: [f64; 2],
    ) -> Result<Self, Message> {
        let curves: Vec<std::sync::Arc<Curve>> = curves.present().collect();
        Self::new(context, curves.iter().map(std::sync::Arc::as_ref), cell)
    }

    /// The nearest place within a distance.
    pub(super) fn near(&self, [x, y]: [f64; 2], most: f64) -> Option<Near> {
        let mut best: Option<(f64, Near)> = None;
        let limit = most * most;
        for [a, b] in &self.segments {
            let (dx, dy) = (b.x - a.x, b.y - a.y);
            let square = dx * dx + dy * dy;
            let along = if square > 0.0 { ((x - a.x) * dx + (y - a.y) * dy) / square } else { 0.0 };
            let t = along.clamp(0.0, 1.0);
            let (off_x, off_y) = (x - a.x - t * dx, y - a.y - t * dy);
            let gap = off_x * off_x + off_y * off_y;
            if gap <= limit && best.is_none_or(|(least, _)| gap < least) {
                let is_left = dx * (y - a.y) - dy * (x - a.x) >= 0.0;
                best = Some((gap, Near { distance: gap.sqrt(), height: a.z + t * (b.z - a.z), is_left }));
            }
        }
        best.map(|(_, near)| near)
    }

    /// Whether closed paths go round a point, by the number of times that they cross a ray from it.
    pub(super) fn surround(&self, [x, y]: [f64; 2]) -> bool {
        let crossings = self
            .segments
            .iter()
            .filter(|[a, b]| (a.y > y) != (b.y > y) && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        crossings.count() % 2 == 1
    }
}
