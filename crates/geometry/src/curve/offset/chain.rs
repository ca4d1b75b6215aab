//! Parts put together to whole curves along the places where they were cut.

use crate::curve::join::chained;
use crate::intersect::curve_curve;
use crate::{Curve, Interval, Line, LineCurve, Plane, Point3, Result, Vector3};

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

/// Joins places no further apart than `reach`: a sweep along x.
pub(crate) fn gather(sets: &mut Sets, places: &[Point3], reach: f64) {
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by(|&i, &j| places[i].x.total_cmp(&places[j].x));
    for (k, &i) in order.iter().enumerate() {
        let rest = order.get(k + 1..).unwrap_or(&[]);
        // Many on one spot are joined one after the other; looking a little further finds those beside.
        for &j in rest.iter().take_while(|&&j| places[j].x - places[i].x <= reach).take(256) {
            if places[i].distance_to(places[j]) <= reach {
                sets.join(i, j);
            }
        }
    }
}

/// All that the edges of a border amount to.
pub(super) struct Border<'a> {
    pub(super) parts: &'a [&'a Curve],
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
        self.parts[e.part].point_at(if last { e.range.end } else { e.range.start })
    }

    fn tangent(&self, e: &Edge, last: bool) -> Vector3 {
        let t = if last { e.range.end } else { e.range.start };
        self.parts[e.part].tangent_on_side(t, last).unwrap_or(Vector3::ZERO)
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
    pub(super) fn curves(mut self, least: f64) -> Result<Vec<Curve>> {
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
            let (mut chain, mut closed, mut here) = (vec![first], false, first);
            loop {
                let place = self.edges[here].to;
                let arriving = self.tangent(&self.edges[here], true);
                let next = leaving[place]
                    .iter()
                    .copied()
                    .filter(|&k| !used[k] || k == first)
                    .min_by(|&j, &k| self.turn(arriving, j).total_cmp(&self.turn(arriving, k)));
                match next {
                    Some(k) if k == first => {
                        closed = true;
                        break;
                    }
                    Some(k) => {
                        used[k] = true;
                        chain.push(k);
                        here = k;
                    }
                    None => break,
                }
            }
            chains.push((chain, closed));
        }
        chains.sort_by_key(|c| c.0.iter().min().copied());
        let mut out = Vec::new();
        for (chain, closed) in chains {
            if let Some(curve) = self.curve(&chain, closed, least)? {
                out.push(curve);
            }
        }
        Ok(out)
    }

    /// How far an edge turns away from the side where the border goes on; where loops touch, each stays its own.
    fn turn(&self, arriving: Vector3, k: usize) -> f64 {
        let leaving = self.tangent(&self.edges[k], false);
        let angle = arriving.cross(leaving).dot(self.plane.z_axis).atan2(arriving.dot(leaving));
        if angle.abs() > std::f64::consts::PI - 1e-7 { std::f64::consts::PI } else { angle * self.side }
    }

    fn curve(&self, chain: &[usize], closed: bool, least: f64) -> Result<Option<Curve>> {
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
        let mut pieces: Vec<Curve> = Vec::with_capacity(runs.len());
        for (part, range) in runs {
            let whole = self.parts[part];
            let piece = if range == whole.domain() { whole.clone() } else { whole.trimmed(range)? };
            // A gap within the tolerance is bridged, not hidden.
            let mut piece = piece;
            if let Some(before) = pieces.last_mut()
                && before.end().distance_to(piece.start()) > 1e-2 * self.gap
            {
                let link = linked(before, &mut piece)?;
                pieces.push(link);
            }
            pieces.push(piece);
        }
        let length: f64 = pieces.iter().map(Curve::length).sum();
        if !(length > least) {
            return Ok(None);
        }
        if closed && let (Some(first), Some(last)) = (pieces.first().cloned(), pieces.last().cloned()) {
            let (from, to) = (last.end(), first.start());
            let count = pieces.len();
            if from.distance_to(to) > 1e-2 * self.gap {
                pieces.push(Line::new(from, to).into());
            } else if count > 1 && from != to {
                // A straight end meets the start exactly.
                if let Curve::Line(LineCurve { line, domain }) = last {
                    pieces[count - 1] = LineCurve { line: Line::new(line.from, to), domain }.into();
                } else if let Curve::Line(LineCurve { line, domain }) = first {
                    pieces[0] = LineCurve { line: Line::new(from, line.to), domain }.into();
                }
            }
        }
        Ok(Some(chained(pieces, 1e-2 * self.gap)))
    }
}

/// The segment from the end of one curve to the start of another; where it turns back over one of them, that is cut
/// off at the crossing.
fn linked(before: &mut Curve, after: &mut Curve) -> Result<Curve> {
    let link = |before: &Curve, after: &Curve| Curve::from(Line::new(before.end(), after.start()));
    let crossings = |curve: &Curve, line: &Curve| -> Result<Vec<f64>> {
        let found = curve_curve(curve, line, 1e-9 * line.length())?.crossings;
        Ok(found.into_iter().map(|c| c.a).collect())
    };
    let own = before.domain();
    let hair = 1e-6 * own.length();
    let first = crossings(before, &link(before, after))?.into_iter().fold(own.end, f64::min);
    if own.start + hair < first && first < own.end - hair {
        *before = before.trimmed(Interval::new(own.start, first))?;
    }
    let own = after.domain();
    let hair = 1e-6 * own.length();
    let last = crossings(after, &link(before, after))?.into_iter().fold(own.start, f64::max);
    if own.start + hair < last && last < own.end - hair {
        *after = after.trimmed(Interval::new(last, own.end))?;
    }
    Ok(link(before, after))
}
