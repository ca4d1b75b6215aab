//! Every leaf of the search is shown to hold nothing, or is crossed by a curve that was followed.

use super::search::{Leaf, Search};
use crate::chart::thresholds::{MET, ROOM};
use crate::trace::{Box4, Condition, End, Followed, Four, Limits, Pair, Place, followed};
use crate::{Direction, Result, cancellation};

/// The curves, as they are found.
pub(super) struct Curves {
    pub(super) found: Vec<Followed>,
    pub(super) limits: Limits,
    /// Whether the search for ends on the sides came to its end.
    pub(super) complete: bool,
}

impl Curves {
    /// Follows what begins on the sides of the domains: a side's curve and the other surface have these points in common.
    ///
    /// # Errors
    /// The work was stopped.
    pub(super) fn add_from_sides(&mut self, search: &mut Search<'_>) -> Result<()> {
        let pair = search.pair;
        for s in 0..2 {
            for d in Direction::BOTH {
                for at_end in [false, true] {
                    let (own, other) = (pair.charts[s], pair.charts[1 - s]);
                    if own.is_collapsed(d.index(), at_end) {
                        continue;
                    }
                    let domain = own.domain(d.index());
                    let value = if at_end { domain.end } else { domain.start };
                    let side = own.nurbs().isocurve(d.other(), value)?;
                    if !boxes_meet(&side, other) {
                        continue;
                    }
                    let both = search.meets(&side.into(), 1 - s, MET * pair.noise);
                    self.complete &= both.complete;
                    let stretches = both.overlaps.iter().map(|o| (o.t.middle(), mean(o.from, o.to)));
                    let points = both.crossings.iter().map(|c| (c.t, [c.u, c.v])).chain(stretches);
                    for (t, uv) in points {
                        let mut x: Four = [0.0; 4];
                        (x[2 * s + d.index()], x[2 * s + 1 - d.index()]) = (value, t);
                        (x[2 - 2 * s], x[3 - 2 * s]) = (uv[0], uv[1]);
                        let parameter = 2 * s + d.index();
                        self.add(search, x, Condition::Fixed { parameter, value }, None)?;
                    }
                }
            }
        }
        Ok(())
    }

    /// Drops what begins and ends on a seam where another curve passes: a step may go over a seam and back by less than what
    /// is seen between its places.
    fn drop_held_at_seams(&mut self, pair: &Pair<'_>) {
        let is_held = |own: usize, place: &Place| {
            let others = || self.found.iter().enumerate().filter(|(k, _)| *k != own).map(|(_, c)| c);
            let across = |k: usize| {
                let (domain, x) = (pair.domain(k), place.x[k]);
                pair.charts[k / 2].period(k % 2)?;
                let mut image = place.x;
                image[k] = if x <= domain.start + pair.slack(k) {
                    domain.end
                } else if x >= domain.end - pair.slack(k) {
                    domain.start
                } else {
                    return None;
                };
                Some(image)
            };
            (0..4).filter_map(across).any(|x| others().any(|c| c.passes(pair, x, place.point)))
        };
        let doubles: Vec<bool> = (self.found.iter().enumerate())
            .map(|(k, c)| {
                let ends = [c.places.first(), c.places.last()];
                c.ends == [End::Border; 2] && ends.into_iter().flatten().all(|end| is_held(k, end))
            })
            .collect();
        let mut doubles = doubles.into_iter();
        self.found.retain(|_| !doubles.next().unwrap_or(false));
    }

    /// Follows the curve through a common point near parameters, unless it is known. Whether there is such a point, and in
    /// the box where one is given: Newton's method may go elsewhere from a place between two curves, and what it finds there
    /// tells nothing of the box.
    fn add(
        &mut self,
        search: &Search<'_>,
        near: Four,
        condition: Condition,
        within: Option<&Box4>,
    ) -> Result<bool> {
        let pair = search.pair;
        let Some(x) = pair.polished(near, condition) else { return Ok(false) };
        if pair.beyond(x).iter().any(Option::is_some) {
            return Ok(false);
        }
        let x = pair.clamped(x);
        if within.is_some_and(|b| (0..4).any(|k| x[k] < b[k][0] || x[k] > b[k][1])) {
            return Ok(false);
        }
        // At a tangent place nothing begins: the search has it among what is undecided.
        let Some(start) = pair.place(x) else { return Ok(true) };
        if self.found.iter().any(|c| c.holds(x, start.point)) {
            return Ok(true);
        }
        self.add_through(&pair, start)?;
        Ok(true)
    }

    /// Follows the curve through a place.
    ///
    /// # Errors
    /// The work was stopped.
    pub(super) fn add_through(&mut self, pair: &Pair<'_>, start: Place) -> Result<()> {
        let curve = followed(pair, start, &self.limits)?;
        if curve.places.len() > 1 {
            self.found.push(curve);
        }
        Ok(())
    }

    /// Goes through the leaves, and follows what runs through them and is not known.
    ///
    /// # Errors
    /// The work was stopped.
    pub(super) fn add_from_leaves(&mut self, search: &mut Search<'_>, leaves: Vec<Leaf>) -> Result<()> {
        let mut stack = leaves;
        stack.reverse();
        while let Some(leaf) = stack.pop() {
            cancellation::check()?;
            let wide = search.wide(leaf.bounds);
            if self.found.iter().any(|c| c.enters(&wide)) {
                continue;
            }
            let middle: Four = leaf.bounds.map(|[a, b]| 0.5 * (a + b));
            let jets = search.pair.jets(middle);
            let through = (jets[0][0] + jets[1][0]) * 0.5;
            let known =
                self.add(search, middle, Condition::Slice { through, across: leaf.along }, Some(&wide))?;
            if !known {
                let mut parts = search.parts(&leaf);
                parts.reverse();
                stack.append(&mut parts);
            }
        }
        self.drop_held_at_seams(&search.pair);
        Ok(())
    }

    /// The places where curves could not be followed further.
    pub(super) fn stuck(&self) -> Vec<Place> {
        let at = |c: &Followed, k: usize| if k == 0 { c.places.first() } else { c.places.last() }.copied();
        self.found
            .iter()
            .flat_map(|c| {
                (0..2).filter(|k| c.ends[*k] == End::Stuck).filter_map(|k| at(c, k)).collect::<Vec<_>>()
            })
            .collect()
    }
}

fn mean(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
}

/// Whether the boxes of a side and a surface have anything in common.
fn boxes_meet(side: &crate::NurbsCurve, other: &crate::chart::Chart) -> bool {
    let Some(a) = crate::BoundingBox::from_points(side.control_points()) else { return false };
    let b = other.nurbs().hull_box().inflated(ROOM * other.size());
    [
        (a.min.x, a.max.x, b.min.x, b.max.x),
        (a.min.y, a.max.y, b.min.y, b.max.y),
        (a.min.z, a.max.z, b.min.z, b.max.z),
    ]
    .iter()
    .all(|(low, high, from, to)| low <= to && from <= high)
}
