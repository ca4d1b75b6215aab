//! Where the curves of an arrangement meet, each place once.

use super::meetings::{Meetings, too_much};
use super::sources::Sources;
use crate::box_pairs::near_pairs;
use crate::intersect::CurveIntersections;
use crate::offset::{Sets, gather};
use crate::{BoundingBox, Curve, Interval, Point3, Result};

/// The most pairs of parts that are looked at.
const MOST_PAIRS: usize = 4_000_000;
/// The most pairs of cuts that are compared where parts run beside each other.
const MOST_COMPARED: u64 = 50_000_000;
/// What looking for the nearest place on a curve costs, in such pairs.
const FOOT: u64 = 2000;

/// The parts cut at nodes.
#[derive(Debug)]
pub(super) struct Nodes {
    /// For each part its parameters at nodes, increasing, and the nodes; from its start to its end. None for a part
    /// that lies in one node as a whole.
    pub(super) stops: Vec<Vec<(f64, usize)>>,
    /// Where a node is.
    pub(super) places: Vec<Point3>,
}

/// A stretch of a part that runs beside one of another.
struct Beside {
    part: usize,
    range: Interval,
    other: usize,
}

struct Cuts<'a> {
    sources: &'a Sources,
    tolerance: f64,
    lists: Vec<Vec<(f64, usize)>>,
    places: Vec<Point3>,
    beside: Vec<Beside>,
    complete: bool,
}

/// All nodes at a tolerance: crossings, touches, ends of shared stretches, joints and what is near them. `None` when the tolerance is too
/// coarse for the curves: when places that are far apart, as it sees, become one, or more contacts than can be told.
///
/// # Errors
/// There are too many parts, or they meet too often.
pub(super) fn find(
    sources: &Sources,
    meetings: &mut Meetings,
    tolerance: f64,
    last: bool,
) -> Result<Option<Nodes>> {
    let mut cuts = Cuts {
        sources,
        tolerance,
        lists: vec![Vec::new(); sources.parts.len()],
        places: Vec::new(),
        beside: Vec::new(),
        complete: true,
    };
    cuts.joints();
    if !last && too_wide(&mut cuts.sets(), &cuts.places, tolerance) {
        return Ok(None);
    }
    cuts.meet(meetings)?;
    if !(cuts.complete || last) {
        return Ok(None);
    }
    cuts.carry_over()?;
    Ok(cuts.gathered(last))
}

/// Whether places have become one that are too far apart for it: one near the next, and so on.
fn too_wide(sets: &mut Sets, places: &[Point3], tolerance: f64) -> bool {
    let mut boxes: Vec<Option<BoundingBox>> = vec![None; places.len()];
    for (i, &p) in places.iter().enumerate() {
        let root = sets.root(i);
        let own = BoundingBox { min: p, max: p };
        boxes[root] = Some(boxes[root].map_or(own, |b| b.union(&own)));
    }
    boxes.iter().flatten().any(|b| b.diagonal().length() > 8.0 * tolerance)
}

impl Cuts<'_> {
    fn place(&mut self, p: Point3) -> usize {
        self.places.push(p);
        self.places.len() - 1
    }

    fn curve(&self, part: usize) -> &Curve {
        &self.sources.parts[part].curve
    }

    /// The end of a part and the start of the next are one place, however far apart they are. An open curve has two ends.
    fn joints(&mut self) {
        for source in &self.sources.list {
            let count = source.parts.len();
            for (k, part) in source.parts.clone().enumerate() {
                let before = source.parts.start + (k + count - 1) % count;
                let place = self.places.len();
                self.places.push(self.curve(part).start());
                let (start, end) = (self.curve(part).domain().start, self.curve(before).domain().end);
                self.lists[part].push((start, place));
                if k == 0 && source.outline.is_none() {
                    self.places.push(self.curve(before).end());
                    self.lists[before].push((end, place + 1));
                } else {
                    self.lists[before].push((end, place));
                }
            }
        }
    }

    /// Crossings are found as exactly as numbers allow. What comes within the tolerance without crossing matters only
    /// where a part ends.
    fn meet(&mut self, meetings: &mut Meetings) -> Result<()> {
        let parts = &self.sources.parts;
        for (i, part) in parts.iter().enumerate() {
            if !matches!(part.curve, Curve::Line(_) | Curve::Arc(_)) {
                let found = meetings.of(self.sources, (i, i), self.tolerance)?;
                self.take(i, i, &found);
            }
        }
        let boxes: Vec<BoundingBox> = parts.iter().map(|p| p.bounds).collect();
        let pairs = near_pairs(&boxes, None, self.tolerance, MOST_PAIRS).ok_or_else(too_much)?;
        for &(i, j) in &pairs {
            let found = meetings.of(self.sources, (i, j), self.tolerance)?;
            self.take(i, j, &found);
        }
        // Ends near another part.
        for &(i, j) in &pairs {
            for (i, j) in [(i, j), (j, i)] {
                let (near, other) = (boxes[j].inflated(self.tolerance), &parts[j].curve);
                let range = other.domain();
                for end in 0..2 {
                    let Some(&(_, place)) = self.lists[i].get(end) else { continue };
                    let p = self.places[place];
                    let own = self.lists[j].iter().take(2).any(|s| s.1 == place);
                    if own || !near.contains(p) {
                        continue;
                    }
                    if let Some(foot) = other.closest_point_within(p, self.tolerance)?
                        && range.start < foot.parameter
                        && foot.parameter < range.end
                    {
                        self.lists[j].push((foot.parameter, place));
                    }
                }
            }
        }
        Ok(())
    }

    fn take(&mut self, i: usize, j: usize, found: &CurveIntersections) {
        self.complete &= found.complete;
        for c in &found.crossings {
            let place = self.place(c.point);
            self.lists[i].push((c.a, place));
            self.lists[j].push((c.b, place));
        }
        for o in &found.overlaps {
            for (s, t) in [(o.a.start, o.b.start), (o.a.end, o.b.end)] {
                let place = self.place(self.curve(i).point_at(s));
                self.lists[i].push((s, place));
                self.lists[j].push((t, place));
            }
            self.beside.push(Beside { part: i, range: o.a.ordered(), other: j });
            self.beside.push(Beside { part: j, range: o.b.ordered(), other: i });
        }
    }

    /// What cuts one of two parts that run beside each other cuts the other too.
    fn carry_over(&mut self) -> Result<()> {
        let beside = std::mem::take(&mut self.beside);
        // The points of the cuts of each part that others run beside.
        let mut known: Vec<Vec<Point3>> = vec![Vec::new(); self.lists.len()];
        for b in &beside {
            if known[b.other].is_empty() {
                let curve = self.curve(b.other);
                known[b.other] = self.lists[b.other].iter().map(|s| curve.point_at(s.0)).collect();
            }
        }
        let mut compared = 0_u64;
        // A cut goes on from the other to a third.
        for _ in 0..4 {
            let mut added = false;
            for b in &beside {
                let inner: Vec<(f64, usize)> = self.lists[b.part]
                    .iter()
                    .copied()
                    .filter(|s| b.range.start < s.0 && s.0 < b.range.end)
                    .collect();
                for (t, place) in inner {
                    compared += known[b.other].len() as u64;
                    if compared > MOST_COMPARED {
                        return Err(too_much());
                    }
                    let p = self.curve(b.part).point_at(t);
                    if known[b.other].iter().any(|q| q.distance_to(p) <= self.tolerance) {
                        continue;
                    }
                    compared += FOOT;
                    if let Some(foot) = self.curve(b.other).closest_point_within(p, 2.0 * self.tolerance)? {
                        self.lists[b.other].push((foot.parameter, place));
                        known[b.other].push(foot.point);
                        added = true;
                    }
                }
            }
            if !added {
                break;
            }
        }
        Ok(())
    }

    /// Places within the tolerance of each other.
    fn sets(&self) -> Sets {
        let mut sets = Sets::new(self.places.len());
        gather(&mut sets, &self.places, self.tolerance);
        sets
    }

    /// The parts cut at the nodes.
    fn gathered(mut self, last: bool) -> Option<Nodes> {
        let mut sets = self.sets();
        if !last && too_wide(&mut sets, &self.places, self.tolerance) {
            return None;
        }
        let mut stops = Vec::with_capacity(self.lists.len());
        for (part, mut list) in std::mem::take(&mut self.lists).into_iter().enumerate() {
            let curve = self.curve(part);
            let domain = curve.domain();
            list.sort_by(|x, y| x.0.total_cmp(&y.0));
            let mut out: Vec<(f64, usize)> = Vec::with_capacity(list.len());
            for (t, place) in list {
                let node = sets.root(place);
                match out.last_mut() {
                    Some(before) if before.1 == node && self.collapsed(curve, before.0, t) => {
                        if t == domain.end && before.0 > domain.start {
                            before.0 = t;
                        }
                    }
                    _ => out.push((t, node)),
                }
            }
            if out.len() < 2 {
                out.clear();
            }
            // A part whose last stretch lies in the node of its start ends there.
            if let Some(end) = out.last_mut() {
                end.0 = domain.end;
            }
            stops.push(out);
        }
        Some(Nodes { stops, places: self.places })
    }

    /// Whether a stretch between two visits of a node is nothing but the way from one place in it to another. A curl,
    /// which comes back to where it began, is left to be cut out.
    fn collapsed(&self, curve: &Curve, from: f64, to: f64) -> bool {
        let widest = excursion(curve, Interval::new(from, to));
        let step = curve.point_at(from).distance_to(curve.point_at(to));
        widest <= WITHIN * self.tolerance && (step > 0.05 * widest || widest <= 0.05 * self.tolerance)
    }
}

/// How many tolerances a stretch may leave a node and still belong to it.
pub(super) const WITHIN: f64 = 4.0;

/// How far a stretch goes from its start.
pub(super) fn excursion(curve: &Curve, range: Interval) -> f64 {
    let start = curve.point_at(range.start);
    (1..=8).map(|k| curve.point_at(range.at(f64::from(k) / 8.0)).distance_to(start)).fold(0.0, f64::max)
}
