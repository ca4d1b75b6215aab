//! What follows from curves, surfaces and the order of trims: vertices and flags.
//!
//! Files of early versions, and code that builds a brep face by face, know which trims share an edge but not where
//! the vertices are. The order in which vertices are numbered is that of openNURBS.

use super::iso::iso_of;
use super::{Iso, Parts, TrimKind, Vertex};
use crate::Point3;

/// Trims around a vertex that are visited before a walk is given up.
const LONGEST_WALK: usize = 512;
/// What stands for a number that was never computed.
const UNSET: f64 = -1.234_321_012_343_21e308;

/// One end of a trim: its start (0) or its end (1).
type TrimEnd = (usize, usize);

/// How a walk around a vertex ended.
enum Walked {
    /// Back where it began.
    Closed,
    /// At a naked edge.
    Boundary,
    /// At a trim without an edge or loop.
    Stuck,
}

impl Parts {
    /// Finds out for every trim of every face whether it runs along a line of constant parameter.
    pub fn set_iso(&mut self) {
        let flags: Vec<Iso> = (self.trims.iter())
            .map(|trim| match (self.trim_surface(trim), self.trim_curve(trim)) {
                (Some(surface), Some(curve)) => iso_of(surface, curve, trim.part.range),
                _ => trim.iso,
            })
            .collect();
        for (trim, iso) in self.trims.iter_mut().zip(flags) {
            trim.iso = iso;
        }
    }

    /// Finds out for every trim what its edge is for its face. Trims without an edge count as singular.
    pub fn set_kinds(&mut self) {
        let kinds: Vec<TrimKind> = (0..self.trims.len()).map(|trim| self.kind_of(trim)).collect();
        for (trim, kind) in self.trims.iter_mut().zip(kinds) {
            trim.kind = kind;
        }
    }

    fn kind_of(&self, place: usize) -> TrimKind {
        let Some(trim) = self.trims.get(place) else { return TrimKind::Unknown };
        let Some(edge) = trim.edge else { return TrimKind::Singular };
        let others = self.edges.get(edge).map_or(&[] as &[usize], |edge| &edge.trims);
        match others {
            [] => TrimKind::Unknown,
            [only] if *only == place => TrimKind::Boundary,
            [_] => TrimKind::Unknown,
            _ => {
                let same_loop = |other: &usize| {
                    *other != place && self.trims.get(*other).is_some_and(|t| t.in_loop == trim.in_loop)
                };
                if others.iter().any(same_loop) { TrimKind::Seam } else { TrimKind::Mated }
            }
        }
    }

    /// Makes the vertices anew: one wherever trims and edges meet, in the middle of the ends of its edges. The
    /// kinds of trims must be known.
    pub fn set_vertices(&mut self) {
        self.vertices.clear();
        self.edges.iter_mut().for_each(|edge| edge.vertices = [None; 2]);
        self.trims.iter_mut().for_each(|trim| trim.vertices = [None; 2]);
        let loops: Vec<usize> = self.faces.iter().flat_map(|face| face.loops.clone()).collect();
        for place in loops {
            let trims = self.loops.get(place).map(|chain| chain.trims.clone()).unwrap_or_default();
            for trim in trims {
                if self.trims.get(trim).is_some_and(|trim| trim.vertices[0].is_none()) {
                    let vertex = self.vertices.len();
                    self.vertices.push(Vertex::new(Point3::new(UNSET, UNSET, UNSET), UNSET));
                    self.set_around((trim, 0), vertex);
                }
            }
        }
        self.place_vertices();
        self.join_ends_of_closed_edges();
    }

    /// Gives one vertex to all ends of trims and edges around it: one way round, then from the first naked edge the
    /// other way.
    fn set_around(&mut self, start: TrimEnd, vertex: usize) {
        if !matches!(self.walk(start, vertex), Walked::Boundary) {
            return;
        }
        let Some((before, naked)) = self.turned_back(start, vertex) else { return };
        if naked {
            return;
        }
        let mut here = before;
        if !self.is_singular(here.0) {
            let Some(edge) = self.edge_of(here.0) else { return };
            if self.trim_count(edge) == 1 {
                self.set_end(here, vertex);
                return;
            }
            let Some(across) = self.across(here) else { return };
            here = across;
        }
        self.walk(here, vertex);
    }

    /// Where the walk in the other sense begins, and whether it ends at once at a naked edge.
    fn turned_back(&mut self, start: TrimEnd, vertex: usize) -> Option<(TrimEnd, bool)> {
        let mut here = start;
        if self.is_singular(here.0) {
            while self.is_singular(here.0) {
                if here.0 != start.0 {
                    self.set_singular(here.0, vertex);
                }
                here = (self.beside(here.0, false)?, 1);
                if here.0 == start.0 {
                    break;
                }
            }
            if self.edge_of(here.0).is_some() {
                self.set_end(here, vertex);
            }
        }
        let edge = self.edge_of(here.0)?;
        if self.trim_count(edge) < 2 {
            return Some((here, true));
        }
        let across = self.across(here)?;
        Some((self.turned(across)?, false))
    }

    /// Walks from trim to trim around a vertex.
    fn walk(&mut self, start: TrimEnd, vertex: usize) -> Walked {
        let mut here = start;
        for step in 0..LONGEST_WALK {
            if step > 0 && here == start {
                return Walked::Closed;
            }
            if self.is_singular(here.0) {
                self.set_singular(here.0, vertex);
                let Some(next) = self.turned((here.0, 1 - here.1)) else { return Walked::Stuck };
                here = next;
                if here == start {
                    return Walked::Closed;
                }
                if !self.is_singular(here.0) {
                    here = self.across(here).unwrap_or(here);
                }
                continue;
            }
            if !self.set_end(here, vertex) {
                return Walked::Stuck;
            }
            let Some(next) = self.turned(here) else { return Walked::Stuck };
            here = next;
            if self.is_singular(here.0) {
                continue;
            }
            let Some(edge) = self.edge_of(here.0) else { return Walked::Stuck };
            match self.trim_count(edge) {
                0 => return Walked::Boundary,
                1 => {
                    self.set_end(here, vertex);
                    return Walked::Boundary;
                }
                _ => match self.across(here) {
                    Some(across) => here = across,
                    None => return Walked::Stuck,
                },
            }
        }
        Walked::Boundary
    }

    fn is_singular(&self, trim: usize) -> bool {
        self.trims.get(trim).is_some_and(|trim| trim.kind == TrimKind::Singular)
    }

    fn edge_of(&self, trim: usize) -> Option<usize> {
        self.trims.get(trim)?.edge.filter(|edge| *edge < self.edges.len())
    }

    fn trim_count(&self, edge: usize) -> usize {
        self.edges.get(edge).map_or(0, |edge| edge.trims.len())
    }

    fn set_singular(&mut self, trim: usize, vertex: usize) {
        if let Some(trim) = self.trims.get_mut(trim) {
            trim.vertices = [Some(vertex); 2];
        }
    }

    /// The end of a neighbour in the loop that meets this end of a trim.
    fn turned(&self, (trim, end): TrimEnd) -> Option<TrimEnd> {
        Some((self.beside(trim, end == 1)?, 1 - end))
    }

    /// The trim after or before a trim in its loop.
    fn beside(&self, trim: usize, after: bool) -> Option<usize> {
        let chain = &self.loops.get(self.trims.get(trim)?.in_loop?)?.trims;
        let at = chain.iter().position(|t| *t == trim)?;
        let step = if after { 1 } else { chain.len().checked_sub(1)? };
        chain.get((at + step) % chain.len()).copied()
    }

    /// The same end of the edge on another of its trims.
    fn across(&self, (trim, end): TrimEnd) -> Option<TrimEnd> {
        let edge = self.edges.get(self.edge_of(trim)?)?;
        let [first, second, ..] = edge.trims.as_slice() else { return None };
        let other = if *first == trim { *second } else { *first };
        let turned = self.trims.get(trim)?.reversed != self.trims.get(other)?.reversed;
        Some((other, if turned { 1 - end } else { end }))
    }

    /// The naked trim that goes on at an end of a naked one, and its end there: found by going round the vertex.
    pub(super) fn next_naked(&self, start: TrimEnd) -> Option<TrimEnd> {
        let mut here = start;
        for _ in 0..LONGEST_WALK {
            let next = self.turned(here)?;
            if self.is_singular(next.0) {
                here = (next.0, 1 - next.1);
                continue;
            }
            let edge = self.edge_of(next.0)?;
            if self.trim_count(edge) == 1 {
                return Some(next);
            }
            here = self.across(next)?;
        }
        None
    }

    /// Gives a vertex to the end of the edge at the end of a trim, and to all trims there.
    fn set_end(&mut self, (trim, end): TrimEnd, vertex: usize) -> bool {
        let Some(place) = self.edge_of(trim) else { return false };
        let reversed = self.trims.get(trim).is_some_and(|trim| trim.reversed);
        let end = if reversed { 1 - end } else { end };
        let Some(edge) = self.edges.get_mut(place) else { return false };
        let Some(own) = edge.vertices.get_mut(end) else { return false };
        if *own != Some(vertex) {
            *own = Some(vertex);
            if let Some(vertex) = self.vertices.get_mut(vertex) {
                vertex.edges.push(place);
            }
        }
        for trim in &edge.trims {
            if let Some(trim) = self.trims.get_mut(*trim) {
                let end = if trim.reversed { 1 - end } else { end };
                if let Some(own) = trim.vertices.get_mut(end) {
                    *own = Some(vertex);
                }
            }
        }
        true
    }

    /// Puts every vertex in the middle of the ends of its edges.
    fn place_vertices(&mut self) {
        for place in 0..self.vertices.len() {
            let edges = self.vertices.get(place).map(|v| v.edges.clone()).unwrap_or_default();
            let ends: Vec<Point3> = edges.iter().filter_map(|edge| self.end_at(*edge, place)).collect();
            if let Some(vertex) = self.vertices.get_mut(place).filter(|_| !ends.is_empty()) {
                let sum = ends.iter().fold([0.0; 3], |[x, y, z], p| [x + p.x, y + p.y, z + p.z]);
                let scale = 1.0 / ends.len() as f64;
                vertex.point = Point3::from(sum.map(|x| scale * x));
            }
        }
    }

    /// Where an edge meets a vertex: at its start when both ends do.
    fn end_at(&self, edge: usize, vertex: usize) -> Option<Point3> {
        let edge = self.edges.get(edge)?;
        let curve = self.edge_curve(edge)?;
        let domain = edge.part.domain;
        let at = if edge.vertices[0] == Some(vertex) { domain.start } else { domain.end };
        let meets = edge.vertices.contains(&Some(vertex));
        meets.then(|| edge.part.point_at(curve, at))
    }

    /// An edge that closes in space has one vertex, even if no face says so.
    fn join_ends_of_closed_edges(&mut self) {
        let mut pairs: Vec<[usize; 2]> = Vec::new();
        for edge in &self.edges {
            let [Some(a), Some(b)] = edge.vertices else { continue };
            if a != b && self.is_closed_edge(edge) {
                pairs.push([a.min(b), a.max(b)]);
            }
        }
        if pairs.is_empty() {
            return;
        }
        pairs.sort_unstable();
        // The vertex that each one becomes: the smallest it is chained to.
        let mut becomes: Vec<usize> = (0..self.vertices.len()).collect();
        let root = |becomes: &[usize], mut v: usize| {
            while let Some(&next) = becomes.get(v).filter(|next| **next != v) {
                v = next;
            }
            v
        };
        for [a, b] in pairs {
            let (a, b) = (root(&becomes, a), root(&becomes, b));
            if let Some(place) = becomes.get_mut(a.max(b)) {
                *place = a.min(b);
            }
        }
        let roots: Vec<usize> = (0..becomes.len()).map(|v| root(&becomes, v)).collect();
        for (v, &keeps) in roots.iter().enumerate() {
            if keeps != v
                && let Some(vertex) = self.vertices.get_mut(v)
            {
                let edges = std::mem::take(&mut vertex.edges);
                if let Some(kept) = self.vertices.get_mut(keeps) {
                    kept.edges.extend(edges);
                }
            }
        }
        self.renumber_vertices(&roots);
    }

    /// Drops the vertices that became others.
    fn renumber_vertices(&mut self, roots: &[usize]) {
        let mut places = Vec::with_capacity(roots.len());
        let mut kept = 0;
        for (v, root) in roots.iter().enumerate() {
            places.push(kept);
            kept += usize::from(v == *root);
        }
        let mut v = 0;
        self.vertices.retain(|_| {
            v += 1;
            roots.get(v - 1) == Some(&(v - 1))
        });
        let new = |old: &mut Option<usize>| {
            *old = old.and_then(|v| roots.get(v)).and_then(|root| places.get(*root)).copied();
        };
        self.edges.iter_mut().flat_map(|edge| &mut edge.vertices).for_each(new);
        self.trims.iter_mut().flat_map(|trim| &mut trim.vertices).for_each(new);
    }

    /// Whether an edge ends where it starts.
    pub(super) fn is_closed_edge(&self, edge: &super::Edge) -> bool {
        let Some(curve) = self.edge_curve(edge) else { return false };
        let part = &edge.part;
        if part.range == curve.domain() {
            return curve.is_closed();
        }
        part.point_at(curve, part.domain.start).coincides(part.point_at(curve, part.domain.end))
    }

    /// Takes the tolerances of trims and edges from those of older programs, and those of vertices from the ends of
    /// their edges.
    pub fn set_tolerances_from_older(&mut self) {
        for trim in &mut self.trims {
            let [flat, space] = trim.older_tolerances;
            trim.tolerance = [flat; 2];
            if let Some(edge) = trim.edge.and_then(|edge| self.edges.get_mut(edge)) {
                edge.tolerance = edge.tolerance.max(space);
            }
        }
        for place in 0..self.vertices.len() {
            let Some(vertex) = self.vertices.get(place) else { continue };
            let mut tolerance = vertex.tolerance;
            for edge in &vertex.edges {
                let Some(own) = self.edges.get(*edge) else { continue };
                tolerance = tolerance.max(own.tolerance);
                let Some(curve) = self.edge_curve(own) else { continue };
                let end = if own.vertices[0] == Some(place) { curve.start() } else { curve.end() };
                if own.vertices.contains(&Some(place)) {
                    tolerance = tolerance.max(vertex.point.distance_to(end));
                }
            }
            if let Some(vertex) = self.vertices.get_mut(place) {
                vertex.tolerance = tolerance;
            }
        }
    }
}
