//! Where pictures of curves cross.

use crate::drawing::thresholds::{LEAST_SPAN, STEP_DONE};
use crate::thresholds;
use std::ops::ControlFlow;

use katydid_elementary::Elementary;

use super::feature::{Feature, distance};
use super::occluder::Occluders;
use crate::Result;
use crate::box_tree::{Bounds, BoxTree, bounds_of};
use crate::silhouette::{each, go_on_or_stop};

/// So many segments of a picture after one another are one thing to be placed in the tree: neighbours lie near each other.
const RUN: usize = 8;

/// Segments of pictures in a tree.
pub(super) struct Segments {
    /// The feature and the number of its sample at the start.
    of: Vec<(u32, u32)>,
    tree: BoxTree,
}

/// The box of a segment, this much wider.
pub(super) fn box_of(a: [f64; 2], b: [f64; 2], margin: f64) -> Bounds {
    let [low, high] = bounds_of([[a[0], a[1], 0.0], [b[0], b[1], 0.0]]);
    [low.map(|x| x - margin), high.map(|x| x + margin)]
}

fn meet(a: &Bounds, b: &Bounds) -> bool {
    (0..2).all(|c| a[0][c] <= b[1][c] && b[0][c] <= a[1][c])
}

impl Segments {
    /// Of all features, in boxes this much wider.
    pub(super) fn new(features: &[Feature], margin: f64) -> Self {
        let (mut of, mut boxes) = (Vec::new(), Vec::new());
        for (feature, i) in features.iter().zip(0_u32..) {
            for (w, k) in feature.samples.windows(2).zip(0_u32..) {
                of.push((i, k));
                boxes.push(box_of(w[0].at, w[1].at, margin));
            }
        }
        Self { of, tree: BoxTree::in_runs(&boxes, RUN) }
    }

    /// Visits the segments whose boxes meet a box: the feature, and the number of its segment.
    pub(super) fn near(&self, bounds: &Bounds, mut visit: impl FnMut(usize, usize) -> ControlFlow<()>) {
        self.tree.visit_where(
            |b| meet(b, bounds),
            |i| match self.of.get(i) {
                Some(&(feature, segment)) => visit(feature as usize, segment as usize),
                None => ControlFlow::Continue(()),
            },
        );
    }
}

/// Where a feature can become hidden.
#[derive(Debug)]
pub(super) struct Split {
    /// The parameters between which nothing of the picture crosses it that could hide it, and it goes through no surface;
    /// ends included.
    pub(super) stops: Vec<f64>,
    /// Whether that is certain.
    pub(super) complete: bool,
}

/// Where each feature can become hidden.
pub(super) fn splits(
    features: &[Feature],
    segments: &Segments,
    occluders: &Occluders,
    tolerance: f64,
    go_on: &(dyn Fn() -> bool + Sync),
) -> Result<Vec<Split>> {
    // Where a curve ends another may begin to be covered by it.
    let ends: Vec<[f64; 2]> = features
        .iter()
        .filter(|f| !f.is_closed())
        .flat_map(|f| [f.samples.first(), f.samples.last()])
        .flatten()
        .map(|s| s.at)
        .collect();
    let boxes: Vec<Bounds> = ends.iter().map(|p| box_of(*p, *p, tolerance)).collect();
    let ends_tree = BoxTree::by_place(&boxes);
    let index: Vec<usize> = (0..features.len()).collect();
    each(&index, |&i| {
        go_on_or_stop(go_on)?;
        let Some(feature) = features.get(i) else { return Ok(Split { stops: Vec::new(), complete: true }) };
        let domain = feature.domain();
        let mut stops = vec![domain.start, domain.end];
        stops.extend(feature.folds());
        let pierced = occluders.pierced(feature)?;
        stops.extend(pierced.stops);
        for (k, w) in feature.samples.windows(2).enumerate() {
            let own = box_of(w[0].at, w[1].at, tolerance);
            segments.near(&own, |j, l| {
                let neighbours = i == j && k.abs_diff(l) <= 1;
                if let Some(other) = features.get(j).filter(|f| f.kind.is_silhouette() && !neighbours)
                    && let Some([t, s]) = crossing(feature, k, other, l, tolerance)
                    && other.depth(s) >= feature.depth(t) - tolerance
                {
                    stops.push(t);
                }
                ControlFlow::Continue(())
            });
            ends_tree.visit_where(
                |b| meet(b, &own),
                |e| {
                    if let Some(q) = ends.get(e) {
                        let share = share_of(w[0].at, w[1].at, *q).clamp(0.0, 1.0);
                        let t = feature.nearest(*q, w[0].t + (w[1].t - w[0].t) * share);
                        if distance(feature.jet(t).0, *q) <= tolerance {
                            stops.push(t);
                        }
                    }
                    ControlFlow::Continue(())
                },
            );
        }
        stops.sort_by(f64::total_cmp);
        let least = LEAST_SPAN * domain.length();
        stops.dedup_by(|b, a| *b - *a <= least);
        if let Some(last) = stops.last_mut() {
            *last = domain.end;
        }
        Ok(Split { stops, complete: pierced.complete })
    })
}

/// Where on the line through two points the nearest place to a third is: 0 at the first, 1 at the second.
pub(super) fn share_of(a: [f64; 2], b: [f64; 2], q: [f64; 2]) -> f64 {
    let d = [b[0] - a[0], b[1] - a[1]];
    let square = d[0] * d[0] + d[1] * d[1];
    if square > 0.0 { ((q[0] - a[0]) * d[0] + (q[1] - a[1]) * d[1]) / square } else { 0.0 }
}

/// The parameters where two pictures cross near two of their segments.
fn crossing(one: &Feature, k: usize, other: &Feature, l: usize, tolerance: f64) -> Option<[f64; 2]> {
    let [a, b] = [one.samples.get(k)?, one.samples.get(k + 1)?];
    let [c, d] = [other.samples.get(l)?, other.samples.get(l + 1)?];
    let (r, s) = ([b.at[0] - a.at[0], b.at[1] - a.at[1]], [d.at[0] - c.at[0], d.at[1] - c.at[1]]);
    let det = r[0] * s[1] - r[1] * s[0];
    let lengths = [r[0].hypotenuse(r[1]), s[0].hypotenuse(s[1])];
    // Curves that run along each other are split where they end.
    if det.abs() <= thresholds::PARALLEL * lengths[0] * lengths[1] {
        return None;
    }
    let q = [c.at[0] - a.at[0], c.at[1] - a.at[1]];
    let x = (q[0] * s[1] - q[1] * s[0]) / det;
    let y = (q[0] * r[1] - q[1] * r[0]) / det;
    // Chords are within the tolerance of their curves, and may pass each other where those cross.
    let slack = lengths.map(|length| tolerance / length);
    let within = |x: f64, slack: f64| -slack <= x && x <= 1.0 + slack;
    if !(within(x, slack[0]) && within(y, slack[1])) {
        return None;
    }
    let (first, second) = (one.domain(), other.domain());
    let mut t = (a.t + (b.t - a.t) * x).clamp(first.start, first.end);
    let mut u = (c.t + (d.t - c.t) * y).clamp(second.start, second.end);
    for _ in 0..8 {
        let ((p, dp), (q, dq)) = (one.jet(t), other.jet(u));
        let miss = [q[0] - p[0], q[1] - p[1]];
        let det = dp[1] * dq[0] - dp[0] * dq[1];
        if det == 0.0 || !det.is_finite() {
            break;
        }
        let dt = (miss[1] * dq[0] - miss[0] * dq[1]) / det;
        let du = (dp[0] * miss[1] - dp[1] * miss[0]) / det;
        t = (t + dt).clamp(first.start, first.end);
        u = (u + du).clamp(second.start, second.end);
        if dt.abs() <= STEP_DONE * first.length() && du.abs() <= STEP_DONE * second.length() {
            break;
        }
    }
    (distance(one.jet(t).0, other.jet(u).0) <= 2.0 * tolerance).then_some([t, u])
}
