//! From contacts of parts to crossings, touches and stretches in the surface.

use super::super::thresholds::{AT_END, CROSSES, FURTHER, ON_OTHER, ON_SIDE, SAME_PARAMETER, SAME_ROOT};
use super::{Contact, Search, SurfaceCrossing, SurfaceIntersections, SurfaceOverlap};
use crate::curve::Piece;
use crate::intersect::ContactKind;
use crate::intersect::search::NOISE;
use crate::{Interval, Point3};

/// A place beside a patch by no more than this part of its width may have its foot on it.
const BESIDE: f64 = 1e-3;

impl Search<'_, '_> {
    fn piece_at(&self, t: f64) -> Option<&Piece<'_>> {
        let pieces = &self.tree.pieces;
        pieces.get(pieces.partition_point(|p| p.whole.end <= t).min(pieces.len().wrapping_sub(1)))
    }

    fn point(&self, t: f64) -> Point3 {
        self.piece_at(t).map_or(Point3::ORIGIN, |p| p.point(p.own_parameter(t)))
    }

    /// The nearest place of the surface to the curve at `t`, from places found before.
    fn gap_at(&self, t: f64, near: &[Contact]) -> ([f64; 2], f64) {
        let q = self.point(t);
        let mut best = ([0.0; 2], f64::INFINITY);
        let off = |c: &Contact| (c.t[0] - t).max(t - c.t[1]).max(0.0) + FURTHER * (c.best - t).abs();
        let mut nearest: [Option<&Contact>; 2] = [None; 2];
        for c in near {
            if nearest[0].is_none_or(|d| off(c) < off(d)) {
                nearest = [Some(c), nearest[0]];
            } else if nearest[1].is_none_or(|d| off(c) < off(d)) {
                nearest[1] = Some(c);
            }
        }
        for c in nearest.into_iter().flatten() {
            for i in self.patches.patches_over(c.uv, BESIDE) {
                let d = self.patches.patch(i).domain;
                let found = self.foot(i, q, [d[0].clamp(c.uv[0]), d[1].clamp(c.uv[1])]);
                if found.1 < best.1 {
                    best = found;
                }
            }
            if best.1 <= ON_OTHER * self.tolerance {
                break;
            }
        }
        best
    }

    pub(super) fn read(&mut self, domain: Interval) -> SurfaceIntersections {
        let (mut crossings, mut overlaps) = (Vec::new(), Vec::new());
        let mut contacts = std::mem::take(&mut self.contacts);
        contacts.sort_by(|x, y| {
            (x.t[0] - x.reach).total_cmp(&(y.t[0] - y.reach)).then(x.uv[0].total_cmp(&y.uv[0]))
        });
        // One place: neighbours along the curve whose points of the surface are near each other.
        let mut places: Vec<([f64; 2], Vec<Contact>)> = Vec::new();
        for c in contacts {
            let joined = places.iter_mut().rev().take(16).find(|(t, members)| {
                let reach = members.iter().map(|m| m.reach).fold(c.reach, f64::max);
                t[0] <= c.t[1] + reach
                    && c.t[0] <= t[1] + reach
                    && (members.iter().all(|m| !m.root)
                        || !c.root
                        || members.iter().any(|m| (m.best - c.best).abs() <= SAME_ROOT * domain.length()))
            });
            match joined {
                Some((t, members)) => {
                    *t = [t[0].min(c.t[0]), t[1].max(c.t[1])];
                    members.push(c);
                }
                None => places.push((c.t, vec![c])),
            }
        }
        for (t, members) in &places {
            if !self.overlap(*t, members, domain, &mut overlaps) {
                crossings.extend(self.place(*t, members));
            }
        }
        crossings.sort_by(|x: &SurfaceCrossing, y| {
            x.t.total_cmp(&y.t).then(x.u.total_cmp(&y.u)).then(x.v.total_cmp(&y.v))
        });
        crossings.dedup_by(|later, first| {
            (later.t - first.t).abs() <= SAME_PARAMETER * domain.length()
                && later.point.distance_to(first.point) <= 4.0 * self.tolerance
        });
        overlaps.sort_by(|x: &SurfaceOverlap, y| x.t.start.total_cmp(&y.t.start));
        let covers = |t: f64| {
            overlaps.iter().any(|o| {
                let more = AT_END * domain.length();
                o.t.start - more <= t
                    && t <= o.t.end + more
                    && [o.t.clamp(t)]
                        .iter()
                        .all(|&s| self.point(s).distance_to(self.point(t)) <= 8.0 * self.tolerance)
            })
        };
        crossings.retain(|c| !covers(c.t));
        let (complete, visits) = (self.complete, self.visits);
        SurfaceIntersections { crossings, overlaps, complete, visits }
    }

    /// The stretch of a place that lies in the surface: one that ends where the curve or the surface does, or, where
    /// they part, one that before was far nearer than a touch is.
    fn overlap(
        &self,
        t: [f64; 2],
        members: &[Contact],
        domain: Interval,
        out: &mut Vec<SurfaceOverlap>,
    ) -> bool {
        let range = Interval::new(t[0], t[1]);
        let steps = 64;
        let places: Vec<f64> = (0..=steps).map(|k| range.at(f64::from(k) / f64::from(steps))).collect();
        let length: f64 = places.windows(2).map(|w| self.point(w[0]).distance_to(self.point(w[1]))).sum();
        if !(length > 4.0 * self.tolerance) {
            return false;
        }
        let reach = members.iter().map(|m| m.reach).fold(0.0, f64::max);
        let shut = |t: f64| {
            let slack = SAME_PARAMETER * domain.length() + reach;
            let ([u, v], _) = self.gap_at(t, members);
            let border = |d: Interval, x: f64| (x - d.start).min(d.end - x) <= ON_SIDE * d.length();
            t - domain.start <= slack
                || domain.end - t <= slack
                || border(self.domain[0], u)
                || border(self.domain[1], v)
        };
        let limit = if shut(t[0]) && shut(t[1]) { self.tolerance } else { ON_OTHER * self.tolerance };
        let limit = limit.max(NOISE * self.tree.scale.max(self.patches.scale));
        let within: Vec<bool> = places.iter().map(|&t| self.gap_at(t, members).1 <= limit).collect();
        let mut best = (0, 0);
        let mut k = 0;
        while k < within.len() {
            let end = (k..within.len()).find(|&i| !within[i]).unwrap_or(within.len());
            if end - k > best.1 - best.0 {
                best = (k, end);
            }
            k = end + 1;
        }
        if best.1 - best.0 < within.len() / 4 {
            return false;
        }
        // The ends to the last bit: joints and ends of the curve where they are near, else by halving.
        let refine = |good: f64, bad: Option<f64>| {
            let Some(mut bad) = bad else { return good };
            let mut good = good;
            for _ in 0..50 {
                let middle = 0.5 * (good + bad);
                if self.gap_at(middle, members).1 <= limit { good = middle } else { bad = middle }
            }
            good
        };
        let snap = |t: f64| {
            let stops = self.tree.pieces.iter().flat_map(|p| [p.whole.start, p.whole.end]);
            let near = stops.min_by(|x, y| (x - t).abs().total_cmp(&(y - t).abs())).unwrap_or(t);
            if self.point(near).distance_to(self.point(t)) <= 4.0 * self.tolerance { near } else { t }
        };
        let start = refine(places[best.0], best.0.checked_sub(1).map(|i| places[i]));
        let end = refine(places[best.1 - 1], places.get(best.1).copied());
        let (start, end) = (snap(start), snap(end));
        if !(start < end) {
            return false;
        }
        let (from, to) = (self.gap_at(start, members).0, self.gap_at(end, members).0);
        out.push(SurfaceOverlap { t: Interval::new(start, end), from, to });
        true
    }

    /// The crossing or touch of a place.
    fn place(&self, t: [f64; 2], members: &[Contact]) -> Option<SurfaceCrossing> {
        let finish = |t: f64, uv: [f64; 2], gap: f64, kind: ContactKind| {
            let q = self.point(t);
            let (uv, gap) = match self.gap_at(t, members) {
                (better, g) if g < gap => (better, g),
                _ => (uv, gap),
            };
            let s = self.patches.patches_over(uv, 0.0).next().map(|i| self.patches.patch(i));
            let point = s.map_or(q, |s| q.lerp(s.jet(uv)[0].to_point(), 0.5));
            SurfaceCrossing { t, u: uv[0], v: uv[1], point, gap, kind }
        };
        if let Some(c) = members.iter().filter(|c| c.root).min_by(|x, y| x.gap.total_cmp(&y.gap)) {
            return Some(finish(c.best, c.uv, c.gap, ContactKind::Transversal));
        }
        // The least gap by golden section around the nearest place found.
        let steps = 32;
        let wide = members.iter().map(|m| m.reach).fold(t[1] - t[0], f64::max);
        let (first, last) = self.tree.pieces.first().zip(self.tree.pieces.last())?;
        let range = Interval::new((t[0] - wide).max(first.whole.start), (t[1] + wide).min(last.whole.end));
        let gap = |t: f64| self.gap_at(t, members).1;
        let samples = (0..=steps).map(|k| range.at(f64::from(k) / f64::from(steps)));
        let start =
            samples.chain(members.iter().map(|m| m.best)).min_by(|&x, &y| gap(x).total_cmp(&gap(y)))?;
        let width = range.length() / f64::from(steps);
        let (mut low, mut high) = ((start - width).max(range.start), (start + width).min(range.end));
        for _ in 0..60 {
            let (x, y) = (low + 0.382 * (high - low), low + 0.618 * (high - low));
            if gap(x) <= gap(y) { high = y } else { low = x }
        }
        let middle = 0.5 * (low + high);
        let best =
            [start, middle, range.start, range.end].into_iter().min_by(|&x, &y| gap(x).total_cmp(&gap(y)))?;
        let (uv, least) = self.gap_at(best, members);
        if !(least <= self.tolerance) {
            return None;
        }
        let kind = self.kind(best, uv);
        Some(finish(best, uv, least, kind))
    }

    /// Tangent when the curve's direction lies in the tangent plane.
    fn kind(&self, t: f64, uv: [f64; 2]) -> ContactKind {
        let direction = self.piece_at(t).and_then(|p| p.jet(p.own_parameter(t))[1].unitized());
        let patch = self.patches.patches_over(uv, 0.0).next().map(|i| self.patches.patch(i));
        let normal = patch.and_then(|p| {
            let [_, su, sv] = p.jet(uv);
            su.cross(sv).unitized()
        });
        match (direction, normal) {
            (Some(d), Some(n)) if d.dot(n).abs() > CROSSES => ContactKind::Transversal,
            _ => ContactKind::Tangent,
        }
    }
}
