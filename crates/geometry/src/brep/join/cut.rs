//! Naked edges cut where others end on them.

use super::super::edges::taken;
use super::super::{CurvePart, Parts, Vertex};
use crate::thresholds;
use crate::{BoundingBox, ClosestOnCurve, Curve, Interval, Point3, Result, Surface, cancellation};

/// Places of a trim that are looked at for the one nearest to a point.
const PLACES: usize = 64;

impl Parts {
    /// The naked edges, with boxes a tolerance wider than they are.
    pub(super) fn naked(&self, limit: f64) -> Vec<(usize, BoundingBox)> {
        let live = self.edges.iter().enumerate().filter(|(_, e)| !e.deleted && e.trims.len() == 1);
        live.filter_map(|(place, edge)| Some((place, self.edge_curve(edge)?.bounding_box().inflated(limit))))
            .collect()
    }

    /// Cuts naked edges at the vertices of other naked edges that lie on them within the limit.
    pub(super) fn cut_at_foreign_vertices(&mut self, limit: f64) -> Result<()> {
        let naked = self.naked(limit);
        let mut points: Vec<(usize, Point3)> = Vec::new();
        for (edge, _) in &naked {
            let ends = self.edges.get(*edge).map(|e| e.vertices).unwrap_or_default();
            points.extend(ends.iter().flatten().filter_map(|v| Some((*v, self.vertices.get(*v)?.point))));
        }
        points.sort_by(|a, b| a.1.x.total_cmp(&b.1.x).then(a.0.cmp(&b.0)));
        points.dedup_by_key(|p| p.0);
        for (edge, bounds) in naked {
            cancellation::check()?;
            let cuts = self.cuts_of(edge, &bounds, &points, limit)?;
            // From the end, so that the first part keeps its place.
            for t in cuts.into_iter().rev() {
                self.cut_edge(edge, t)?;
            }
        }
        Ok(())
    }

    /// The parameters at which an edge is to be cut, increasing.
    fn cuts_of(
        &self,
        place: usize,
        bounds: &BoundingBox,
        points: &[(usize, Point3)],
        limit: f64,
    ) -> Result<Vec<f64>> {
        let Some(edge) = self.edges.get(place) else { return Ok(Vec::new()) };
        let Some(curve) = self.edge_curve(edge) else { return Ok(Vec::new()) };
        let ends = [edge.part.domain.start, edge.part.domain.end].map(|t| edge.part.point_at(curve, t));
        let first = points.partition_point(|(_, p)| p.x < bounds.min.x);
        let near = points.iter().skip(first).take_while(|(_, p)| p.x <= bounds.max.x);
        let near: Vec<Point3> = near
            .filter(|(v, p)| bounds.contains(*p) && !edge.vertices.contains(&Some(*v)))
            .map(|(_, p)| *p)
            .filter(|p| ends.iter().all(|end| end.distance_to(*p) > limit))
            .collect();
        if near.is_empty() {
            return Ok(Vec::new());
        }
        let own = taken(curve, &edge.part)?;
        let index = ClosestOnCurve::new(&own);
        let mut cuts = Vec::new();
        for p in near {
            let foot = index.nearest(p)?;
            if foot.distance <= limit && ends.iter().all(|end| end.distance_to(foot.point) > limit) {
                cuts.push((foot.parameter, foot.point));
            }
        }
        cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
        cuts.dedup_by(|b, a| a.1.distance_to(b.1) <= limit);
        Ok(cuts.into_iter().map(|(t, _)| t).collect())
    }

    /// Cuts an edge and all its trims at a parameter inside: the edge keeps the part before, a new edge gets the rest.
    pub(in super::super) fn cut_edge(&mut self, place: usize, t: f64) -> Result<()> {
        let Some(edge) = self.edges.get(place).cloned() else { return Ok(()) };
        let Some(curve) = self.edge_curve(&edge) else { return Ok(()) };
        let own = taken(curve, &edge.part)?;
        let domain = own.domain();
        let [before, after] = [Interval::new(domain.start, t), Interval::new(t, domain.end)];
        let halves = [own.trimmed(before)?, own.trimmed(after)?];
        let point = own.point_at(t);
        let mut trims = Vec::with_capacity(edge.trims.len());
        for &trim in &edge.trims {
            let Some(cut) = self.trim_halves(trim, point)? else { return Ok(()) };
            trims.push((trim, cut));
        }
        let vertex = self.vertices.len();
        let rest = self.edges.len();
        self.vertices.push(Vertex { edges: vec![place, rest], ..Vertex::new(point, 0.0) });
        if let Some(end) = edge.vertices[1].and_then(|v| self.vertices.get_mut(v)) {
            // Of a closed edge the start stays.
            if let Some(at) = end.edges.iter().rposition(|e| *e == place)
                && let Some(named) = end.edges.get_mut(at)
            {
                *named = rest;
            }
        }
        let mut second = edge.clone();
        let [first_part, second_part] = halves.map(|half| {
            let part = CurvePart::whole(self.curves_3d.len(), half.domain());
            self.curves_3d.push(Some(half));
            part
        });
        second.part = second_part;
        second.vertices = [Some(vertex), edge.vertices[1]];
        second.trims.clear();
        self.edges.push(second);
        if let Some(first) = self.edges.get_mut(place) {
            first.part = first_part;
            first.vertices = [edge.vertices[0], Some(vertex)];
        }
        for (trim, cut) in trims {
            self.cut_trim(trim, cut, vertex, [place, rest]);
        }
        Ok(())
    }

    /// The two parts of a trim's curve at the place whose image is nearest to a point.
    fn trim_halves(&self, place: usize, point: Point3) -> Result<Option<[Curve; 2]>> {
        let Some(trim) = self.trims.get(place) else { return Ok(None) };
        let (Some(flat), Some(surface)) = (self.trim_curve(trim), self.trim_surface(trim)) else {
            return Ok(None);
        };
        let own = taken(flat, &trim.part)?;
        let at = nearest_image(&own, surface, point);
        let domain = own.domain();
        let least = thresholds::SAME_PARAMETER * domain.length();
        if !(at > domain.start + least && at < domain.end - least) {
            return Ok(None);
        }
        Ok(Some([own.trimmed(Interval::new(domain.start, at))?, own.trimmed(Interval::new(at, domain.end))?]))
    }

    /// Replaces a trim by its two halves, which meet in a vertex and run along the two parts of an edge.
    fn cut_trim(&mut self, place: usize, halves: [Curve; 2], vertex: usize, edges: [usize; 2]) {
        let Some(old) = self.trims.get(place).cloned() else { return };
        let new = self.trims.len();
        let [first, second] = halves.map(|half| {
            let part = CurvePart::whole(self.curves_2d.len(), half.domain());
            self.curves_2d.push(Some(half));
            part
        });
        let [early, late] = if old.reversed { [edges[1], edges[0]] } else { edges };
        let mut tail = old.clone();
        tail.part = second;
        tail.edge = Some(late);
        tail.vertices = [Some(vertex), old.vertices[1]];
        self.trims.push(tail);
        if let Some(head) = self.trims.get_mut(place) {
            head.part = first;
            head.edge = Some(early);
            head.vertices = [old.vertices[0], Some(vertex)];
        }
        if let Some(chain) = old.in_loop.and_then(|l| self.loops.get_mut(l))
            && let Some(at) = chain.trims.iter().position(|t| *t == place)
        {
            chain.trims.insert(at + 1, new);
        }
        for edge in edges {
            if let Some(edge) = self.edges.get_mut(edge) {
                edge.trims.retain(|t| *t != place);
            }
        }
        for (edge, trim) in [(early, place), (late, new)] {
            if let Some(edge) = self.edges.get_mut(edge) {
                edge.trims.push(trim);
            }
        }
    }
}

/// The parameter of a curve in the parameter plane whose image on the surface is nearest to a point.
fn nearest_image(flat: &Curve, surface: &Surface, point: Point3) -> f64 {
    let domain = flat.domain();
    let distance = |t: f64| {
        let uv = flat.point_at(t);
        surface.point_at(uv.x, uv.y).distance_to(point)
    };
    let at = |k: usize| domain.at(k as f64 / PLACES as f64);
    let best = (0..=PLACES).min_by(|a, b| distance(at(*a)).total_cmp(&distance(at(*b)))).unwrap_or(0);
    let (mut low, mut high) = (at(best.saturating_sub(1)), at((best + 1).min(PLACES)));
    // Golden section: each step keeps 0.618 of the range.
    const RATIO: f64 = 0.618_033_988_749_894_9;
    let (mut a, mut b) = (high - RATIO * (high - low), low + RATIO * (high - low));
    let (mut fa, mut fb) = (distance(a), distance(b));
    for _ in 0..80 {
        if fa <= fb {
            (high, b, fb) = (b, a, fa);
            a = high - RATIO * (high - low);
            fa = distance(a);
        } else {
            (low, a, fa) = (a, b, fb);
            b = low + RATIO * (high - low);
            fb = distance(b);
        }
    }
    0.5 * (low + high)
}
