//! A common area in the domains of both surfaces: which parts of them it holds.

use super::overlap::Overlaps;
use crate::Point3;
use crate::chart::thresholds::SAME_PARAMETER;
use crate::trace::{Box4, Pair};

/// So many places of an image stand for it between two of its knots.
const STEPS: usize = 4;

/// The borders of a common area in both domains, as closed polygons.
pub(super) struct Area {
    loops: [Vec<Vec<[f64; 2]>>; 2],
    /// What is no further from the border than this is on it, by parameter.
    near: [f64; 4],
}

/// How a part of a domain lies to an area.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Lies {
    Inside,
    Outside,
    Across,
}

impl Area {
    /// `None` where a surface closes: its borders need not be closed in the domain.
    pub(super) fn new(pair: &Pair<'_>, found: &Overlaps) -> Option<Self> {
        if !found.complete || (0..4).any(|k| pair.charts[k / 2].period(k % 2).is_some()) {
            return None;
        }
        let loops = [0, 1].map(|s| {
            let borders = found.contacts.iter().flat_map(|c| &c.border);
            borders
                .map(|border| border.iter().flat_map(|branch| places(&branch.parameters[s])).collect())
                .collect()
        });
        let near = std::array::from_fn(|k| SAME_PARAMETER * pair.domain(k).length());
        Some(Self { loops, near })
    }

    /// How both parts of a box lie.
    pub(super) fn lies(&self, b: &Box4) -> [Lies; 2] {
        let grown = |k: usize| [b[k][0] - self.near[k], b[k][1] + self.near[k]];
        [0, 1].map(|s| lies(&self.loops[s], [grown(2 * s), grown(2 * s + 1)]))
    }
}

fn places(image: &crate::NurbsCurve) -> Vec<[f64; 2]> {
    let mut knots = image.knots().to_vec();
    knots.dedup();
    knots
        .windows(2)
        .flat_map(|w| (0..STEPS).map(move |i| w[0] + (w[1] - w[0]) * i as f64 / STEPS as f64))
        .map(|t| image.point_at(t))
        .map(|Point3 { x, y, .. }| [x, y])
        .collect()
}

fn lies(loops: &[Vec<[f64; 2]>], range: [[f64; 2]; 2]) -> Lies {
    let center = range.map(|[a, b]| 0.5 * (a + b));
    let mut inside = false;
    for polygon in loops {
        let Some(mut from) = polygon.last().copied() else { continue };
        for &to in polygon {
            if crosses(from, to, range) {
                return Lies::Across;
            }
            // A ray along u.
            if (from[1] > center[1]) != (to[1] > center[1]) {
                let at = from[0] + (to[0] - from[0]) * (center[1] - from[1]) / (to[1] - from[1]);
                inside ^= at > center[0];
            }
            from = to;
        }
    }
    if inside { Lies::Inside } else { Lies::Outside }
}

/// Whether a segment enters a rectangle: clipped by both ranges, something is left of it.
fn crosses(from: [f64; 2], to: [f64; 2], range: [[f64; 2]; 2]) -> bool {
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    for k in 0..2 {
        let d = to[k] - from[k];
        if d == 0.0 {
            if from[k] < range[k][0] || from[k] > range[k][1] {
                return false;
            }
            continue;
        }
        let (a, b) = ((range[k][0] - from[k]) / d, (range[k][1] - from[k]) / d);
        (low, high) = (low.max(a.min(b)), high.min(a.max(b)));
    }
    low <= high
}
