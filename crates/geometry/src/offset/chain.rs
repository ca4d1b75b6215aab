//! Parts put together to whole curves along the places where they were cut.

use crate::offset::thresholds::{INSIDE, NO_GAP, REVERSED};
use crate::thresholds;
use std::collections::HashMap;

use katydid_elementary::Elementary;

use super::RawPart;
use super::restyle::{Chain, Link};
use crate::intersect::curve_curve;
use crate::{Curve, Interval, Line, NurbsCurve, Plane, Point3, Result, Vector3};

/// A stretch of a part, from place to place.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    pub(super) part: usize,
    pub(super) range: Interval,
    pub(super) from: usize,
    pub(super) to: usize,
}

/// Sets of things that are one.
#[derive(Debug)]
pub(crate) struct Sets(Vec<usize>);

impl Sets {
    pub(crate) fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    pub(crate) fn add(&mut self) -> usize {
        self.0.push(self.0.len());
        self.0.len() - 1
    }

    pub(crate) fn root(&mut self, mut i: usize) -> usize {
        while self.0[i] != i {
            self.0[i] = self.0[self.0[i]];
            i = self.0[i];
        }
        i
    }

    pub(crate) fn join(&mut self, i: usize, j: usize) {
        let (i, j) = (self.root(i), self.root(j));
        self.0[i.max(j)] = i.min(j);
    }
}

/// Cells are so many times as wide as places are joined over: most places then touch one cell only.
const CELL: f64 = 16.0;
/// So many places in one cell are looked at, the last ones first: many on one spot are joined one after the other.
const LOOKED_AT: usize = 256;

/// Joins places no further apart than `reach`, by a grid of cells.
pub(crate) fn gather(sets: &mut Sets, places: &[Point3], reach: f64) {
    let size = CELL * reach.max(f64::MIN_POSITIVE);
    let cell = |x: f64| (x / size).floor() as i64;
    // The last place in each cell, and for each place the one before it in its cell.
    let mut last: HashMap<[i64; 3], usize> = HashMap::with_capacity(places.len());
    let mut before: Vec<Option<usize>> = Vec::with_capacity(places.len());
    for (i, p) in places.iter().enumerate() {
        let at: [f64; 3] = (*p).into();
        let [low, high] = [-reach, reach].map(|by| at.map(|x| cell(x + by)));
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let mut next = last.get(&[x, y, z]).copied();
                    for _ in 0..LOOKED_AT {
                        let Some(j) = next else { break };
                        if p.distance_to(places[j]) <= reach {
                            sets.join(i, j);
                        }
                        next = before[j];
                    }
                }
            }
        }
        before.push(last.insert(at.map(cell), i));
    }
}

/// All that the edges of a border amount to.
pub(super) struct Border<'a> {
    pub(super) parts: &'a [RawPart],
    pub(super) edges: Vec<Edge>,
    pub(super) sets: Sets,
    pub(super) plane: &'a Plane,
    /// The side on which the border goes on: 1 right, −1 left.
    pub(super) side: f64,
    /// Ends no further apart than this are one place if nothing else goes on there.
    pub(super) gap: f64,
    /// What leads nowhere and is no longer than this counts for nothing.
    pub(super) stub: f64,
}

impl Border<'_> {
    fn end(&self, e: &Edge, last: bool) -> Point3 {
        self.parts[e.part].curve.point_at(if last { e.range.end } else { e.range.start })
    }

    fn tangent(&self, e: &Edge, last: bool) -> Vector3 {
        let t = if last { e.range.end } else { e.range.start };
        self.parts[e.part].curve.tangent_on_side(t, last).unwrap_or(Vector3::ZERO)
    }

    /// Arrivals and departures by place.
    fn degrees(&self) -> Vec<[i32; 2]> {
        let mut out = vec![[0; 2]; self.sets.0.len()];
        for e in &self.edges {
            out[e.from][1] += 1;
            out[e.to][0] += 1;
        }
        out
    }

    fn settle(&mut self) {
        for k in 0..self.edges.len() {
            let Edge { from, to, .. } = self.edges[k];
            let (from, to) = (self.sets.root(from), self.sets.root(to));
            (self.edges[k].from, self.edges[k].to) = (from, to);
        }
    }

    /// Takes away what leads nowhere from a place where something else goes on, short ones first.
    fn prune(&mut self) {
        let lengths = |edges: &[Edge]| -> Vec<f64> {
            edges.iter().map(|e| self.end(e, false).distance_to(self.end(e, true))).collect()
        };
        let mut order: Vec<(f64, Edge)> = lengths(&self.edges).into_iter().zip(self.edges.clone()).collect();
        order.sort_by(|x, y| x.0.total_cmp(&y.0));
        let mut degrees = self.degrees();
        let mut gone = true;
        while gone {
            gone = false;
            order.retain(|&(length, ref e)| {
                let ([into_from, out_of_from], [into_to, out_of_to]) = (degrees[e.from], degrees[e.to]);
                let short = i32::from(length <= self.stub);
                let nowhere =
                    out_of_to == 0 && into_from > 0 && out_of_from + short > into_from.max(1 + short);
                let from_nowhere =
                    into_from == 0 && out_of_to > 0 && into_to + short > out_of_to.max(1 + short);
                if nowhere || from_nowhere {
                    degrees[e.from][1] -= 1;
                    degrees[e.to][0] -= 1;
                    gone = true;
                }
                !(nowhere || from_nowhere)
            });
        }
        self.edges = order.into_iter().map(|(_, e)| e).collect();
        self.edges.sort_by(|x, y| x.part.cmp(&y.part).then(x.range.start.total_cmp(&y.range.start)));
    }

    /// Joins loose ends to loose beginnings within the gap, nearest first.
    fn link(&mut self) {
        let degrees = self.degrees();
        let loose = |last: bool| -> Vec<(usize, Point3)> {
            let place = |e: &Edge| if last { e.to } else { e.from };
            let open = |e: &&Edge| {
                let [arrive, leave] = degrees[place(e)];
                if last { leave < arrive } else { arrive < leave }
            };
            self.edges.iter().filter(open).map(|e| (place(e), self.end(e, last))).collect()
        };
        let (ends, starts) = (loose(true), loose(false));
        let mut pairs = Vec::new();
        for (place, p) in ends.iter().take(4096) {
            for (other, q) in starts.iter().take(4096) {
                let gap = p.distance_to(*q);
                if gap <= self.gap && place != other {
                    pairs.push((gap, *place, *other));
                }
            }
        }
        pairs.sort_by(|x, y| x.0.total_cmp(&y.0));
        let mut taken = std::collections::HashSet::new();
        for (_, place, other) in pairs {
            if !taken.contains(&place) && !taken.contains(&other) {
                taken.extend([place, other]);
                self.sets.join(place, other);
            }
        }
    }

    /// The curves, each from its first edge on, in the order of the parts; what is no longer than `least` is left
    /// out.
    pub(super) fn chains(mut self, least: f64) -> Result<Vec<Chain>> {
        self.settle();
        self.prune();
        self.link();
        self.settle();
        let degrees = self.degrees();
        let mut leaving: Vec<Vec<usize>> = vec![Vec::new(); degrees.len()];
        for (k, e) in self.edges.iter().enumerate() {
            leaving[e.from].push(k);
        }
        let mut used = vec![false; self.edges.len()];
        let mut chains: Vec<(Vec<usize>, bool)> = Vec::new();
        // Open ones first: they begin where more leaves than arrives.
        let begins = |e: &Edge| degrees[e.from][1] > degrees[e.from][0];
        let mut starts: Vec<usize> = (0..self.edges.len()).filter(|&k| begins(&self.edges[k])).collect();
        starts.extend(0..self.edges.len());
        for first in starts {
            if used[first] {
                continue;
            }
            used[first] = true;
            let (mut chain, mut here) = (vec![first], first);
            loop {
                let place = self.edges[here].to;
                // Back where it has been: that much is a closed curve of its own. So no curve meets itself at a cut.
                if let Some(k) = chain.iter().position(|&k| self.edges[k].from == place) {
                    chains.push((chain.split_off(k), true));
                    let Some(&before) = chain.last() else { break };
                    here = before;
                }
                let arriving = self.tangent(&self.edges[here], true);
                let next = leaving[place]
                    .iter()
                    .copied()
                    .filter(|&k| !used[k])
                    .min_by(|&j, &k| self.turn(arriving, j).total_cmp(&self.turn(arriving, k)));
                let Some(next) = next else { break };
                used[next] = true;
                chain.push(next);
                here = next;
            }
            if !chain.is_empty() {
                chains.push((chain, false));
            }
        }
        chains.sort_by_key(|c| c.0.iter().min().copied());
        let mut out = Vec::new();
        for (chain, closed) in chains {
            out.extend(self.chain(&chain, closed, least)?);
        }
        Ok(out)
    }

    /// How far an edge turns away from the side where the border goes on; where loops touch, each stays its own.
    fn turn(&self, arriving: Vector3, k: usize) -> f64 {
        let leaving = self.tangent(&self.edges[k], false);
        let angle = arriving.cross(leaving).dot(self.plane.z_axis).arctangent_of(arriving.dot(leaving));
        if angle.abs() > std::f64::consts::PI - REVERSED { std::f64::consts::PI } else { angle * self.side }
    }

    fn chain(&self, chain: &[usize], closed: bool, least: f64) -> Result<Option<Chain>> {
        let mut runs: Vec<(usize, Interval)> = Vec::new();
        for &k in chain {
            let e = &self.edges[k];
            match runs.last_mut() {
                Some((part, range)) if *part == e.part && range.end == e.range.start => {
                    range.end = e.range.end
                }
                _ => runs.push((e.part, e.range)),
            }
        }
        if closed
            && runs.len() > 1
            && let (Some(&first), Some(last)) = (runs.first(), runs.last().copied())
            && first.0 == last.0
            && last.1.end == first.1.start
        {
            runs.pop();
            runs[0].1.start = last.1.start;
        }
        let mut links: Vec<Link> = Vec::with_capacity(runs.len());
        for (part, range) in runs {
            let RawPart { curve, corner, .. } = &self.parts[part];
            let whole = range == curve.domain();
            let mut curve = if whole { curve.clone() } else { curve.trimmed(range)? };
            // A gap within the tolerance is bridged, not hidden.
            if let Some(before) = links.last_mut()
                && before.curve.end().distance_to(curve.start()) > self.epsilon()
            {
                let link = linked(&mut before.curve, &mut curve)?;
                links.push(Link::plain(link));
            }
            links.push(Link { curve, corner: *corner, whole });
        }
        let length: f64 = links.iter().map(|l| l.curve.length()).sum();
        if !(length > least) {
            return Ok(None);
        }
        for k in 1..links.len() {
            let (before, after) = links.split_at_mut(k);
            if let (Some(before), Some(after)) = (before.last_mut(), after.first_mut()) {
                meet(&mut before.curve, &mut after.curve)?;
            }
        }
        if closed {
            self.close(&mut links)?;
        }
        Ok(Some(Chain { links, closed }))
    }

    /// Lets the last link end where the first starts.
    fn close(&self, links: &mut Vec<Link>) -> Result<()> {
        let gap = |links: &[Link]| match links {
            [first, .., last] => last.curve.end().distance_to(first.curve.start()),
            [only] => only.curve.end().distance_to(only.curve.start()),
            [] => 0.0,
        };
        if links.len() == 1 && gap(links) > self.epsilon() {
            let halves = links[0].curve.split_at(&[links[0].curve.domain().middle()])?;
            *links = halves.into_iter().map(Link::plain).collect();
        }
        let wide = gap(links) > self.epsilon();
        match links.as_mut_slice() {
            [first, .., last] if wide => {
                let link = linked(&mut last.curve, &mut first.curve)?;
                links.push(Link::plain(link));
            }
            [first, .., last] => meet(&mut last.curve, &mut first.curve)?,
            [only] => {
                let start = only.curve.start();
                if let Curve::Nurbs(c) = &mut only.curve {
                    *c = with_end(c, true, start)?;
                }
            }
            [] => {}
        }
        Ok(())
    }

    /// A gap no larger than this is none.
    fn epsilon(&self) -> f64 {
        NO_GAP * self.gap
    }
}

/// Lets two curves with a gap of next to nothing between them meet exactly.
fn meet(before: &mut Curve, after: &mut Curve) -> Result<()> {
    let (end, start) = (before.end(), after.start());
    if end == start {
        return Ok(());
    }
    match (&mut *before, &mut *after) {
        (Curve::Line(c), _) => c.line.to = start,
        (_, Curve::Line(c)) => c.line.from = end,
        (Curve::Nurbs(c), _) => *c = with_end(c, true, start)?,
        (_, Curve::Nurbs(c)) => *c = with_end(c, false, end)?,
        _ => {}
    }
    Ok(())
}

/// A clamped curve with another end, near to its own.
fn with_end(curve: &NurbsCurve, last: bool, end: Point3) -> Result<NurbsCurve> {
    let mut points = curve.control_points();
    if let Some(p) = if last { points.last_mut() } else { points.first_mut() } {
        *p = end;
    }
    let knots = curve.knots().to_vec();
    if curve.is_rational() {
        return NurbsCurve::with_weights(curve.degree(), &points, &curve.weights(), knots);
    }
    NurbsCurve::new(curve.degree(), points, knots)
}

/// The segment from the end of one curve to the start of another. Where it would lead back beside one of them, as
/// across the mouth of a swallowtail too thin to show a crossing, that is cut off beside the other's end; where it
/// crosses one of them, at the crossing.
fn linked(before: &mut Curve, after: &mut Curve) -> Result<Curve> {
    let link = |before: &Curve, after: &Curve| Line::new(before.end(), after.start());
    let inside = |curve: &Curve, t: f64| {
        let domain = curve.domain();
        let epsilon = INSIDE * domain.length();
        domain.start + epsilon < t && t < domain.end - epsilon
    };
    // Another arm may be as near.
    let gap = before.end().distance_to(after.start());
    let short = |curve: &Curve, range: Interval| {
        let places = (0..8).map(|k| curve.point_at(range.at(f64::from(k) / 7.0))).collect::<Vec<_>>();
        places.windows(2).map(|w| w[0].distance_to(w[1])).sum::<f64>() <= 8.0 * gap
    };
    let back = |curve: &Curve, at_end: bool, line: Line| {
        let t = if at_end { curve.domain().end } else { curve.domain().start };
        curve.tangent_on_side(t, at_end).is_some_and(|d| d.dot(line.direction()) < 0.0)
    };
    if back(before, true, link(before, after)) {
        let t = before.closest_point(after.start())?.parameter;
        if inside(before, t) && short(before, Interval::new(t, before.domain().end)) {
            *before = before.trimmed(Interval::new(before.domain().start, t))?;
        }
    }
    if back(after, false, link(before, after)) {
        let t = after.closest_point(before.end())?.parameter;
        if inside(after, t) && short(after, Interval::new(after.domain().start, t)) {
            *after = after.trimmed(Interval::new(t, after.domain().end))?;
        }
    }
    let crossings = |curve: &Curve, line: Line| -> Result<Vec<f64>> {
        let found = curve_curve(curve, &line.into(), thresholds::SAME_POINT * line.length())?.crossings;
        Ok(found.into_iter().map(|c| c.a).collect())
    };
    let last = crossings(before, link(before, after))?.into_iter().fold(before.domain().end, f64::min);
    if inside(before, last) {
        *before = before.trimmed(Interval::new(before.domain().start, last))?;
    }
    let first = crossings(after, link(before, after))?.into_iter().fold(after.domain().start, f64::max);
    if inside(after, first) {
        *after = after.trimmed(Interval::new(first, after.domain().end))?;
    }
    Ok(link(before, after).into())
}

#[cfg(test)]
mod tests {
    use super::{Sets, gather};
    use crate::Point3;

    #[test]
    fn all_near_places_become_one() {
        let reach = 0.01;
        // A column of places one above the other, each with some beside it, over and over.
        let column = (0..2000).map(|i: i32| {
            let (row, turn) = (f64::from(i % 500), f64::from(i / 500));
            Point3::new(3.0 + 0.004 * turn, 0.016 * row, -1.0)
        });
        // And some anywhere, many of them on one spot.
        let others = (0..600).map(|i: i32| {
            let x = f64::from(i % 400) * 1.7;
            Point3::new(0.3 * x.sin(), 0.3 * (1.3 * x).cos(), 0.02 * (0.4 * x).sin())
        });
        let spot = std::iter::repeat_n(Point3::new(-5.0, 0.01, 0.0), 700);
        let places: Vec<Point3> = column.chain(others).chain(spot).collect();
        let (mut found, mut want) = (Sets::new(places.len()), Sets::new(places.len()));
        gather(&mut found, &places, reach);
        for i in 0..places.len() {
            for j in 0..i {
                if places[i].distance_to(places[j]) <= reach {
                    want.join(i, j);
                }
            }
        }
        let roots = |sets: &mut Sets| -> Vec<usize> { (0..places.len()).map(|i| sets.root(i)).collect() };
        let want = roots(&mut want);
        assert_eq!(roots(&mut found), want);
        assert!(want.iter().enumerate().filter(|(i, r)| i == *r).count() > 700);
    }
}
