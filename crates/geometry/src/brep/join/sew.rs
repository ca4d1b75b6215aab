//! Pairs of naked edges made one.

mod unions;

use super::super::Parts;
use super::super::edges::taken;
use crate::{ClosestOnCurve, Curve, Point3, Result, cancellation};
use unions::Unions;

/// Places of an edge that are looked at to see whether another runs beside it.
const PLACES: usize = 9;

/// A naked edge as a curve.
struct Rim {
    place: usize,
    curve: Curve,
    ends: [Point3; 2],
    closed: bool,
}

/// Two rims that run together, and how far apart they are.
struct Pair {
    first: usize,
    second: usize,
    backwards: bool,
    apart: f64,
}

impl Parts {
    /// Joins pairs of naked edges that run together within the limit, nearest pairs first.
    ///
    /// # Errors
    /// It was given up.
    pub(super) fn sew(&mut self, limit: f64) -> Result<()> {
        let mut rims = Vec::new();
        let mut boxes = Vec::new();
        for (place, bounds) in self.naked(limit) {
            cancellation::check()?;
            let Some(edge) = self.edges.get(place) else { continue };
            let Some(curve) = self.edge_curve(edge).and_then(|curve| taken(curve, &edge.part).ok()) else {
                continue;
            };
            let closed = edge.vertices[0] == edge.vertices[1];
            rims.push(Rim { place, ends: [curve.start(), curve.end()], curve, closed });
            boxes.push(bounds);
        }
        let mut order: Vec<usize> = (0..rims.len()).collect();
        order.sort_by(|a, b| boxes[*a].min.x.total_cmp(&boxes[*b].min.x).then(a.cmp(b)));
        let mut pairs = Vec::new();
        for (k, &a) in order.iter().enumerate() {
            for &b in order.iter().skip(k + 1).take_while(|b| boxes[**b].min.x <= boxes[a].max.x) {
                cancellation::check()?;
                let (low, high) = (a.min(b), a.max(b));
                if let Some((backwards, apart)) = beside(&rims[low], &rims[high], limit) {
                    pairs.push(Pair { first: low, second: high, backwards, apart });
                }
            }
        }
        pairs.sort_by(|a, b| {
            a.apart.total_cmp(&b.apart).then(a.first.cmp(&b.first)).then(a.second.cmp(&b.second))
        });
        let mut used = vec![false; rims.len()];
        let mut same = Unions::of(self);
        for pair in pairs {
            cancellation::check()?;
            if used[pair.first] || used[pair.second] {
                continue;
            }
            let [a, b] = [rims[pair.first].place, rims[pair.second].place];
            if self.make_one(a, b, pair.backwards, &mut same) {
                used[pair.first] = true;
                used[pair.second] = true;
            }
        }
        self.unite_vertices(&same);
        Ok(())
    }

    /// Joins two naked edges that run together within the limit; whether they did.
    pub(in super::super) fn sew_two(&mut self, a: usize, b: usize, limit: f64) -> bool {
        let rim = |place: usize| {
            let edge = self.edges.get(place).filter(|edge| edge.trims.len() == 1 && !edge.deleted)?;
            let curve = self.edge_curve(edge).and_then(|curve| taken(curve, &edge.part).ok())?;
            let closed = edge.vertices[0] == edge.vertices[1];
            Some(Rim { place, ends: [curve.start(), curve.end()], curve, closed })
        };
        let (Some(first), Some(second)) = (rim(a), rim(b)) else { return false };
        let Some((backwards, _)) = beside(&first, &second, limit).filter(|_| a != b) else { return false };
        let mut same = Unions::of(self);
        let made = self.make_one(a, b, backwards, &mut same);
        self.unite_vertices(&same);
        made
    }

    /// Gives the trims of edge `b` to edge `a`; not when an open edge would lose one of its two vertices by it.
    fn make_one(&mut self, a: usize, b: usize, backwards: bool, same: &mut Unions) -> bool {
        let (Some(first), Some(second)) = (self.edges.get(a), self.edges.get(b)) else { return false };
        let ([Some(s), Some(e)], [Some(p), Some(q)]) = (first.vertices, second.vertices) else {
            return false;
        };
        let (p, q) = if backwards { (q, p) } else { (p, q) };
        if same.would_collapse(self, [[s, p], [e, q]]) {
            return false;
        }
        same.unite(s, p);
        same.unite(e, q);
        let Some(gone) = self.edges.get_mut(b) else { return false };
        let moved = std::mem::take(&mut gone.trims);
        gone.deleted = true;
        gone.part.curve = None;
        gone.vertices = [None; 2];
        for trim in &moved {
            if let Some(trim) = self.trims.get_mut(*trim) {
                trim.edge = Some(a);
                trim.reversed = trim.reversed != backwards;
            }
        }
        if let Some(kept) = self.edges.get_mut(a) {
            kept.trims.extend(moved);
        }
        true
    }

    /// Replaces vertices by those that they became one with.
    fn unite_vertices(&mut self, same: &Unions) {
        let new = |old: &mut Option<usize>| *old = old.map(|v| same.root(v));
        self.edges.iter_mut().flat_map(|edge| &mut edge.vertices).for_each(new);
        self.trims.iter_mut().flat_map(|trim| &mut trim.vertices).for_each(new);
        self.vertices.iter_mut().for_each(|vertex| vertex.edges.clear());
        for (place, edge) in self.edges.iter().enumerate() {
            for vertex in edge.vertices.iter().flatten() {
                if let Some(vertex) = self.vertices.get_mut(*vertex) {
                    vertex.edges.push(place);
                }
            }
        }
    }
}

/// Whether two rims run together, the second backwards or not, and how far apart they are at most.
fn beside(a: &Rim, b: &Rim, limit: f64) -> Option<(bool, f64)> {
    if a.closed != b.closed {
        return None;
    }
    let ends = |p: Point3, q: Point3| a.ends[0].distance_to(p).max(a.ends[1].distance_to(q));
    let (with, against) = (ends(b.ends[0], b.ends[1]), ends(b.ends[1], b.ends[0]));
    if !(with.min(against) <= limit) {
        return None;
    }
    let index = ClosestOnCurve::new(&b.curve);
    let mut worst = with.min(against);
    let mut places = Vec::with_capacity(PLACES);
    for k in 1..=PLACES {
        let p = a.curve.point_at(a.curve.domain().at(k as f64 / (PLACES + 1) as f64));
        let near = index.nearest_within(p, limit).ok()??;
        worst = worst.max(near.distance);
        places.push(near.parameter);
    }
    // Which way the second one runs shows in the order of the feet, where the ends do not tell.
    let backwards = if a.closed || (with <= limit && against <= limit) {
        let forward = places.windows(2).filter(|w| w[0] < w[1]).count();
        2 * forward < places.len() - 1
    } else {
        against < with
    };
    // And nothing of the second may be away from the first.
    let index = ClosestOnCurve::new(&a.curve);
    for k in 1..=PLACES {
        let p = b.curve.point_at(b.curve.domain().at(k as f64 / (PLACES + 1) as f64));
        index.nearest_within(p, limit).ok()??;
    }
    Some((backwards, worst))
}
