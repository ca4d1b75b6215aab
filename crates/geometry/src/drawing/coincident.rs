//! Curves that have the same picture.

use std::ops::ControlFlow;

use katydid_elementary::Elementary;

use super::crossing::{Segments, box_of, share_of};
use super::feature::{Feature, distance};
use crate::Interval;

/// The pictures of all curves, prepared for questions.
pub(super) struct Pictures<'a> {
    features: &'a [Feature],
    segments: &'a Segments,
    tolerance: f64,
}

/// Places of a piece that must all be covered, as shares of it.
const PLACES: [f64; 3] = [0.5, 0.2, 0.8];
/// The sine of the angle between curves that may run along each other.
const ALONG: f64 = 0.1;

impl<'a> Pictures<'a> {
    pub(super) fn new(features: &'a [Feature], segments: &'a Segments, tolerance: f64) -> Self {
        Self { features, segments, tolerance }
    }

    /// Whether a nearer curve has the picture of a piece, or an earlier one in the same place.
    pub(super) fn is_covered(&self, index: usize, feature: &Feature, range: Interval) -> bool {
        PLACES.iter().all(|x| self.covers(index, feature, range.at(*x)))
    }

    fn covers(&self, index: usize, feature: &Feature, t: f64) -> bool {
        let (p, d) = feature.jet(t);
        let depth = feature.depth(t);
        let length = d[0].hypotenuse(d[1]);
        let mut found = false;
        self.segments.near(&box_of(p, p, self.tolerance), |j, k| {
            let Some(other) = self.features.get(j) else {
                return ControlFlow::Continue(());
            };
            let (Some(a), Some(b)) = (other.samples.get(k), other.samples.get(k + 1)) else {
                return ControlFlow::Continue(());
            };
            let share = share_of(a.at, b.at, p).clamp(0.0, 1.0);
            let s = other.nearest(p, a.t + (b.t - a.t) * share);
            let (q, e) = other.jet(s);
            let sine = (d[0] * e[1] - d[1] * e[0]).abs();
            let along = sine <= ALONG * length * e[0].hypotenuse(e[1]);
            if along && distance(p, q) <= self.tolerance {
                let nearer = other.depth(s) - depth;
                let slack = 4.0 * self.tolerance;
                found = nearer > slack || (nearer >= -slack && j < index);
            }
            if found { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        found
    }
}
