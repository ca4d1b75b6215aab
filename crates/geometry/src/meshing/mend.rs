//! Mends the mesh of a face where triangles look backwards or edges have more than two triangles.
//!
//! What is sound in the parameter plane need not be so in space: where a side of the domain is a point, two straight
//! lines to it from one place are one line in space, and what lies between them is folded flat; where the parameters run
//! almost along each other, or the surface folds back on itself within the tolerance, small triangles fall over.
//!
//! Folded pockets are taken out, crowded edges are halved, diagonals are swapped, and short edges are contracted where
//! that leaves the mesh as near to the surface. An edge may be contracted when its ends have no more neighbours in
//! common than the two opposite to it (T. Dey, H. Edelsbrunner, S. Guha, D. Nekhayev, *Topology preserving edge
//! contraction*, 1999).

use super::fill::{Filled, PlaceMap, Vertex};
use super::grid::Grid;
use super::net::Net;
use super::settings::Limits;
use crate::meshing::thresholds::NO_NORMAL_OF_FACE;
use crate::{MeshFace, Point2, Point3, Surface, Vector3};

/// The most triangles or edges of a face that are mended.
const MOST: usize = 10_000;
/// How often all that is wrong is gone through.
const PASSES: usize = 6;
/// The most triangles around a vertex.
const ROUND: usize = 256;
/// The most triangles of a pocket.
const POCKET: usize = 512;
/// Beside what looks backwards new triangles must look forwards by this cosine.
const FORWARDS: f64 = 1e-4;
/// How much of the distance new triangles may take.
const SHARE: f64 = 0.9;

/// The mesh of a face in space.
pub(super) struct Sheet {
    pub(super) vertices: Vec<Vertex>,
    /// A point for every vertex.
    pub(super) points: Vec<Point3>,
    /// A unit normal of the surface for every vertex; zero where there is none.
    pub(super) normals: Vec<Vector3>,
    /// The faces when they are other ones than before.
    pub(super) faces: Option<Vec<MeshFace>>,
}

/// The corners of a mesh face's triangles.
fn triangles(faces: &[MeshFace]) -> impl Iterator<Item = (u32, [u32; 3])> + '_ {
    faces.iter().enumerate().flat_map(|(k, f)| f.triangles().map(move |t| (k as u32, t)))
}

impl Sheet {
    fn point(&self, v: u32) -> Point3 {
        self.points.get(v as usize).copied().unwrap_or(Point3::ORIGIN)
    }

    fn normal(&self, v: u32) -> Vector3 {
        self.normals.get(v as usize).copied().unwrap_or(Vector3::ZERO)
    }

    fn uv(&self, v: u32) -> Point2 {
        self.vertices.get(v as usize).map_or(Point2::new(0.0, 0.0), |v| v.uv)
    }

    fn is_shared(&self, v: u32) -> bool {
        self.vertices.get(v as usize).is_some_and(|v| v.id.is_some())
    }

    /// What a vertex is in the mesh of the brep: the same number for all that are one point there.
    fn name(&self, v: u32) -> u64 {
        match self.vertices.get(v as usize).and_then(|v| v.id) {
            Some(id) => u64::from(id),
            None => 1 << 32 | u64::from(v),
        }
    }

    fn pair(&self, a: u32, b: u32) -> [u64; 2] {
        let (a, b) = (self.name(a), self.name(b));
        [a.min(b), a.max(b)]
    }

    /// Puts an inner vertex at other parameters.
    fn place(&mut self, v: u32, uv: Point2, surface: &Surface) {
        let v = v as usize;
        if let (Some(vertex), Some(point), Some(normal)) =
            (self.vertices.get_mut(v), self.points.get_mut(v), self.normals.get_mut(v))
        {
            vertex.uv = uv;
            *point = surface.point_at(uv.x, uv.y);
            *normal = surface.normal_at(uv.x, uv.y).unwrap_or(Vector3::ZERO);
        }
    }

    /// Whether a triangle does not look the way that all of its corners' normals do.
    fn is_suspect(&self, [a, b, c]: [u32; 3]) -> bool {
        let p = self.point(a);
        let across = (self.point(b) - p).cross(self.point(c) - p);
        [a, b, c].iter().any(|&v| across.dot(self.normal(v)) < 0.0)
    }

    /// For every vertex whether others are the same point of the brep's mesh: along seams and where sides are points.
    fn repeated(&self) -> Vec<bool> {
        let mut ids: Vec<u32> = self.vertices.iter().filter_map(|v| v.id).collect();
        ids.sort_unstable();
        let twice: Vec<u32> =
            ids.windows(2).filter(|w| w.first() == w.last()).filter_map(|w| w.first().copied()).collect();
        if twice.is_empty() {
            return Vec::new();
        }
        self.vertices.iter().map(|v| v.id.is_some_and(|id| twice.binary_search(&id).is_ok())).collect()
    }

    /// Pairs of names that more than two triangles meet at, in order: only where vertices are repeated.
    fn crowded(&self, faces: &[MeshFace], repeated: &[bool]) -> Vec<[u64; 2]> {
        let is_repeated = |v: u32| repeated.get(v as usize) == Some(&true);
        let mut pairs: Vec<[u64; 2]> = Vec::new();
        for face in faces.iter().filter(|_| !repeated.is_empty()) {
            let round = face.indices();
            for (k, &a) in round.iter().enumerate() {
                let b = round.get((k + 1) % round.len()).copied().unwrap_or(a);
                if is_repeated(a) || is_repeated(b) {
                    pairs.push(self.pair(a, b));
                }
            }
        }
        pairs.sort_unstable();
        pairs.chunk_by(|a, b| a == b).filter(|c| c.len() > 2).filter_map(|c| c.first().copied()).collect()
    }
}

/// Mends a face's mesh, if there is anything wrong with it; left as far as it is when `stop` says so. Of a face with
/// more that is wrong than [`MOST`] the rest stays: it is folded, and no triangle can help it.
pub(super) fn mend(
    surface: &Surface,
    grid: &Grid,
    limits: &Limits,
    filled: &Filled,
    sheet: &mut Sheet,
    stop: &dyn Fn() -> bool,
) {
    let suspects: Vec<[u32; 3]> =
        triangles(&filled.faces).map(|t| t.1).filter(|&t| sheet.is_suspect(t)).collect();
    let repeated = sheet.repeated();
    let crowded = sheet.crowded(&filled.faces, &repeated);
    if suspects.is_empty() && crowded.is_empty() {
        return;
    }
    let mut work = Work {
        surface,
        grid,
        limits,
        net: Net::default(),
        counts: PlaceMap::default(),
        repeated,
        beside: PlaceMap::default(),
        sheet,
    };
    // Looked at more closely most are sound: a surface's own cusps.
    if crowded.is_empty() && !suspects.iter().any(|&t| work.look(t) < 0.0) {
        return;
    }
    for (face, corners) in triangles(&filled.faces) {
        work.add(face, corners);
    }
    let mut changed = false;
    let mut near: Vec<u32> = (0..work.net.len() as u32).collect();
    near.retain(|&t| work.pairs(t).iter().any(|pair| crowded.binary_search(pair).is_ok()));
    let whole = work.net.len() as u32;
    for &pair in crowded.iter().take(MOST).take_while(|_| !stop()) {
        changed |= work.thin_out(pair, &near, whole);
    }
    let mut left: Vec<u32> = (0..work.net.len() as u32).collect();
    left.retain(|&t| work.net.get(t).is_some_and(|c| work.sheet.is_suspect(c)));
    for _ in 0..PASSES {
        let before = work.net.changes();
        left.truncate(MOST);
        left.retain(|&t| match work.net.get(t) {
            Some(corners) if !stop() && work.look(corners) < 0.0 => {
                !(work.swap(t) || work.shift(t) || work.contract(t))
            }
            _ => false,
        });
        if work.net.changes() == before {
            break;
        }
        changed = true;
        left = work.net.recent(&left);
    }
    if changed {
        let faces = work.net.faces(&filled.faces);
        sheet.take(faces);
    }
}

impl Sheet {
    /// Takes other faces, and leaves out inner vertices that none of them has.
    fn take(&mut self, mut faces: Vec<MeshFace>) {
        let mut keep: Vec<bool> = self.vertices.iter().map(|v| v.id.is_some()).collect();
        for &v in faces.iter().flat_map(MeshFace::indices) {
            if let Some(slot) = keep.get_mut(v as usize) {
                *slot = true;
            }
        }
        let mut count = 0_u32;
        let new: Vec<u32> = (keep.iter())
            .map(|&keep| {
                count += u32::from(keep);
                count.saturating_sub(1)
            })
            .collect();
        let mut kept = keep.iter();
        self.vertices.retain(|_| kept.next() == Some(&true));
        kept = keep.iter();
        self.points.retain(|_| kept.next() == Some(&true));
        kept = keep.iter();
        self.normals.retain(|_| kept.next() == Some(&true));
        faces.iter_mut().for_each(|f| *f = f.map(|v| new.get(v as usize).copied().unwrap_or(0)));
        self.faces = Some(faces);
    }
}

/// A face's mesh at work.
struct Work<'a> {
    surface: &'a Surface,
    grid: &'a Grid,
    limits: &'a Limits,
    net: Net,
    /// How many triangles meet at every edge, by names.
    counts: PlaceMap<[u64; 2], u32>,
    /// For every vertex whether others are the same point; none where no vertex is.
    repeated: Vec<bool>,
    /// Triangles to the left of directed sides with a repeated end, by names; some are no longer there.
    beside: PlaceMap<[u64; 2], u32>,
    sheet: &'a mut Sheet,
}

impl Work<'_> {
    fn add(&mut self, face: u32, corners: [u32; 3]) {
        for [a, b] in sides(corners) {
            *self.counts.entry(self.sheet.pair(a, b)).or_insert(0) += 1;
            if self.is_repeated(a) || self.is_repeated(b) {
                self.beside.insert([self.sheet.name(a), self.sheet.name(b)], self.net.len() as u32);
            }
        }
        self.net.add(face, corners);
    }

    fn is_repeated(&self, v: u32) -> bool {
        self.repeated.get(v as usize) == Some(&true)
    }

    /// The triangle on the other side of a triangle's side. Where a side of the domain is a point, it has another of
    /// the vertices there.
    fn across(&self, a: u32, b: u32) -> Option<u32> {
        if let Some(t) = self.net.across(a, b) {
            return Some(t);
        }
        if self.is_repeated(a) == self.is_repeated(b) {
            return None;
        }
        let names = [self.sheet.name(b), self.sheet.name(a)];
        let t = *self.beside.get(&names)?;
        let same = if self.is_repeated(a) { b } else { a };
        let corners = self.net.get(t)?;
        let is_there = sides(corners).iter().any(|&[x, y]| [self.sheet.name(x), self.sheet.name(y)] == names);
        (is_there && corners.contains(&same)).then_some(t)
    }

    /// The triangles around a vertex, counter-clockwise from one of them; none when they do not close.
    fn fan(&self, x: u32, start: u32) -> Option<Vec<u32>> {
        let mut out = vec![start];
        let mut t = start;
        while out.len() < ROUND {
            let corners = self.net.get(t)?;
            let k = corners.iter().position(|&v| v == x)?;
            t = self.across(*corners.get((k + 2) % 3)?, x)?;
            if t == start {
                return Some(out);
            }
            out.push(t);
        }
        None
    }

    fn remove(&mut self, t: u32) {
        let Some(corners) = self.net.remove(t) else { return };
        for [a, b] in sides(corners) {
            if let Some(n) = self.counts.get_mut(&self.sheet.pair(a, b)) {
                *n = n.saturating_sub(1);
            }
        }
    }

    fn count(&self, a: u32, b: u32) -> u32 {
        self.counts.get(&self.sheet.pair(a, b)).copied().unwrap_or(0)
    }

    /// The names of a triangle's sides.
    fn pairs(&self, t: u32) -> Vec<[u64; 2]> {
        let corners = self.net.get(t);
        corners.into_iter().flat_map(sides).map(|[a, b]| self.sheet.pair(a, b)).collect()
    }

    fn middle(&self, corners: [u32; 3]) -> Point2 {
        let [p, q, r] = corners.map(|v| self.sheet.uv(v));
        Point2::new((p.x + q.x + r.x) / 3.0, (p.y + q.y + r.y) / 3.0)
    }

    /// The cosine of the angle between a triangle and the surface: below 0 when it looks backwards; 0 when it has no
    /// height to speak of.
    fn look(&self, corners: [u32; 3]) -> f64 {
        let [a, b, c] = corners.map(|v| self.sheet.point(v));
        let across = (b - a).cross(c - a);
        let long = (b - a).length().max((c - a).length()).max((c - b).length());
        if across.length() <= NO_NORMAL_OF_FACE * long * long {
            return 0.0;
        }
        let uv = self.middle(corners);
        match (self.surface.normal_at(uv.x, uv.y), across.unitized()) {
            (Some(n), Some(across)) => across.dot(n),
            _ => 1.0,
        }
    }

    /// How far a triangle's points are from those at their parameters, by a few looks; only along the normal where its
    /// parameters say little: beside a side that is a point.
    fn off(&self, corners: [u32; 3]) -> f64 {
        const PLACES: [[f64; 3]; 7] = [
            [0.5, 0.5, 0.0],
            [0.0, 0.5, 0.5],
            [0.5, 0.0, 0.5],
            [1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0],
            [0.7, 0.15, 0.15],
            [0.15, 0.7, 0.15],
            [0.15, 0.15, 0.7],
        ];
        let flat = corners.map(|v| self.sheet.uv(v));
        let space = corners.map(|v| self.sheet.point(v));
        let is_pointed = corners.iter().any(|&v| self.is_repeated(v));
        let looks = PLACES.iter().map(|w| {
            let at = |x: [f64; 3]| x[0] * w[0] + x[1] * w[1] + x[2] * w[2];
            let uv = Point2::new(at(flat.map(|p| p.x)), at(flat.map(|p| p.y)));
            let p = Point3::new(at(space.map(|p| p.x)), at(space.map(|p| p.y)), at(space.map(|p| p.z)));
            let off = p - self.surface.point_at(uv.x, uv.y);
            let normal = if is_pointed { self.surface.normal_at(uv.x, uv.y) } else { None };
            normal.map_or(off.length(), |n| off.dot(n).abs())
        });
        looks.fold(0.0, f64::max)
    }

    /// Whether a new triangle is as near to the surface as it has to be, or nearer than those before it.
    fn is_near(&self, corners: [u32; 3], before: f64) -> bool {
        let flat = corners.map(|v| self.sheet.uv(v));
        let range = |x: [f64; 3]| {
            [x.iter().copied().fold(f64::MAX, f64::min), x.iter().copied().fold(f64::MIN, f64::max)]
        };
        let bend = self.grid.bend([range(flat.map(|p| p.x)), range(flat.map(|p| p.y))]);
        let is_bound = bend.triangle_distance(flat.map(|p| [p.x, p.y])) <= self.limits.distance
            && corners.iter().all(|&v| !self.sheet.is_shared(v));
        is_bound || self.off(corners) <= before
    }

    /// How good triangles are that would replace others of which so many look backwards: the least cosine; none when
    /// they are no better.
    fn worth(&self, old: &[[u32; 3]], new: &[[u32; 3]]) -> Option<f64> {
        let backwards = old.iter().filter(|&&t| self.look(t) < 0.0).count();
        let (mut wrong, mut least) = (0, f64::INFINITY);
        for &t in new {
            let look = self.look(t);
            least = least.min(look);
            wrong += usize::from(look < FORWARDS);
            if wrong >= backwards {
                return None;
            }
        }
        let before = old.iter().map(|&t| self.off(t)).fold(SHARE * self.limits.distance, f64::max);
        new.iter().all(|&t| self.is_near(t, before)).then_some(least)
    }

    /// Swaps the side of a triangle that makes the best of it and its neighbour, if any does.
    fn swap(&mut self, t: u32) -> bool {
        let Some(own) = self.net.get(t) else { return false };
        let mut best: Option<(f64, u32, [[u32; 3]; 2])> = None;
        for k in 0..3 {
            let (a, b, c) = (own[k], own[(k + 1) % 3], own[(k + 2) % 3]);
            let Some(other) = self.across(a, b) else { continue };
            let Some(theirs) = self.net.get(other) else { continue };
            let ends = [a, b].map(|v| self.sheet.name(v));
            let Some(&d) = theirs.iter().find(|v| !ends.contains(&self.sheet.name(**v))) else { continue };
            // A chord between points of edges might be one of another face too.
            let is_chord = self.sheet.is_shared(c) && self.sheet.is_shared(d);
            if is_chord || self.count(c, d) > 0 {
                continue;
            }
            let new = [[c, a, d], [d, b, c]];
            if let Some(worth) = self.worth(&[own, theirs], &new)
                && best.is_none_or(|b| worth > b.0)
            {
                best = Some((worth, other, new));
            }
        }
        let Some((_, other, new)) = best else { return false };
        self.replace(&[t, other], &new);
        true
    }

    /// Shifts an inner corner of a triangle towards the middle of those around it, where that is for the best.
    fn shift(&mut self, t: u32) -> bool {
        let Some(own) = self.net.get(t) else { return false };
        let mut best: Option<(f64, u32, Point2, Vec<u32>)> = None;
        for x in own {
            let Some(fan) = self.fan(x, t).filter(|_| !self.sheet.is_shared(x)) else { continue };
            let triangles: Vec<[u32; 3]> = fan.iter().filter_map(|&f| self.net.get(f)).collect();
            let round: Vec<Point2> =
                triangles.iter().filter_map(|f| after(*f, x)).map(|v| self.sheet.uv(v)).collect();
            let n = round.len() as f64;
            let sum = round.iter().fold([0.0; 2], |s, p| [s[0] + p.x, s[1] + p.y]);
            let (from, middle) = (self.sheet.uv(x), Point2::new(sum[0] / n, sum[1] / n));
            let before = (triangles.iter()).fold((0, 0.0_f64), |(count, off), &f| {
                (count + usize::from(self.look(f) < 0.0), off.max(self.off(f)))
            });
            for share in [0.25, 0.5, 1.0] {
                let to = from.lerp(middle, share);
                self.sheet.place(x, to, self.surface);
                let looks: Vec<f64> = triangles.iter().map(|&f| self.look(f)).collect();
                let worth = looks.iter().copied().fold(f64::INFINITY, f64::min);
                if looks.iter().filter(|look| **look < FORWARDS).count() < before.0
                    && best.as_ref().is_none_or(|b| worth > b.0)
                    && triangles.iter().all(|&f| self.is_near(f, before.1.max(SHARE * self.limits.distance)))
                {
                    best = Some((worth, x, to, fan.clone()));
                }
            }
            self.sheet.place(x, from, self.surface);
        }
        let Some((_, x, to, fan)) = best else { return false };
        self.sheet.place(x, to, self.surface);
        let new: Vec<[u32; 3]> = fan.iter().filter_map(|&f| self.net.get(f)).collect();
        self.replace(&fan, &new);
        true
    }

    fn replace(&mut self, old: &[u32], new: &[[u32; 3]]) {
        old.iter().for_each(|&t| self.remove(t));
        new.iter().for_each(|&t| self.add(u32::MAX, t));
    }

    /// Contracts an edge at an inner corner of a triangle, where that is for the best.
    fn contract(&mut self, t: u32) -> bool {
        type Found = (f64, Vec<u32>, Vec<[u32; 3]>);
        let Some(own) = self.net.get(t) else { return false };
        let mut best: Option<Found> = None;
        for x in own.into_iter().filter(|&x| !self.sheet.is_shared(x)) {
            let Some(fan) = self.fan(x, t) else { continue };
            let old: Vec<[u32; 3]> = fan.iter().filter_map(|&f| self.net.get(f)).collect();
            // The corners around, in order.
            let round: Vec<u32> = old.iter().filter_map(|f| after(*f, x)).collect();
            let mut names: Vec<u64> = round.iter().map(|&v| self.sheet.name(v)).collect();
            names.sort_unstable();
            if names.windows(2).any(|w| w[0] == w[1]) {
                continue;
            }
            for &y in &round {
                if self.sheet.point(x).distance_to(self.sheet.point(y)) > self.limits.distance {
                    continue;
                }
                let new: Vec<[u32; 3]> = (old.iter())
                    .filter(|f| !f.contains(&y))
                    .map(|f| f.map(|v| if v == x { y } else { v }))
                    .collect();
                // Edges that come to be, must not be there already, nor be chords between edges of the brep.
                let place = round.iter().position(|&v| v == y).unwrap_or(0);
                let n = round.len();
                let is_free = round.iter().enumerate().all(|(k, &v)| {
                    let beside = k == place || k == (place + 1) % n || (k + 1) % n == place;
                    beside || (self.count(v, y) == 0 && !(self.sheet.is_shared(v) && self.sheet.is_shared(y)))
                });
                if !is_free || new.len() + 2 != old.len() {
                    continue;
                }
                if let Some(worth) = self.worth(&old, &new)
                    && best.as_ref().is_none_or(|b| worth > b.0)
                {
                    best = Some((worth, fan.clone(), new));
                }
            }
        }
        let Some((_, fan, new)) = best else { return false };
        self.replace(&fan, &new);
        true
    }

    /// Leaves two triangles at an edge that has more: takes out what lies folded flat between two of its places in the
    /// parameter plane, else halves it in one of them.
    /// They are among those `near` and those from `new` on.
    fn thin_out(&mut self, pair: [u64; 2], near: &[u32], new: u32) -> bool {
        let meets = |work: &Self, t: u32| {
            let corners = work.net.get(t)?;
            sides(corners).into_iter().find(|&[a, b]| work.sheet.pair(a, b) == pair)
        };
        let mut changed = false;
        for _ in 0..PASSES {
            let added = new..self.net.len() as u32;
            let at: Vec<u32> =
                near.iter().copied().chain(added).filter(|&t| meets(self, t).is_some()).collect();
            if at.len() <= 2 {
                break;
            }
            if let Some(pocket) = at.iter().find_map(|&t| self.pocket(t, pair)) {
                pocket.into_iter().for_each(|t| self.remove(t));
            } else {
                let inner = at.iter().find_map(|&t| {
                    let [a, b] = meets(self, t)?;
                    Some((t, self.net.across(a, b)?, [a, b]))
                });
                let Some((t, other, side)) = inner else { break };
                self.halve([t, other], side);
            }
            changed = true;
        }
        changed
    }

    /// What is reached from a triangle without crossing edges of these names, if it is closed: every edge of it has two
    /// of its triangles.
    fn pocket(&self, start: u32, pair: [u64; 2]) -> Option<Vec<u32>> {
        let mut found = vec![start];
        let mut met: PlaceMap<[u64; 2], u32> = PlaceMap::default();
        let mut next = 0;
        while let Some(&t) = found.get(next) {
            next += 1;
            for [a, b] in sides(self.net.get(t)?) {
                let name = self.sheet.pair(a, b);
                *met.entry(name).or_insert(0) += 1;
                if name == pair {
                    continue;
                }
                if let Some(other) = self.net.across(a, b)
                    && !found.contains(&other)
                {
                    found.push(other);
                }
            }
            if found.len() > POCKET {
                return None;
            }
        }
        met.values().all(|&n| n == 2).then_some(found)
    }

    /// Halves an edge between two triangles.
    fn halve(&mut self, pair: [u32; 2], [a, b]: [u32; 2]) {
        let uv = self.sheet.uv(a).lerp(self.sheet.uv(b), 0.5);
        let middle = self.sheet.vertices.len() as u32;
        self.sheet.vertices.push(Vertex { uv, id: None });
        self.sheet.points.push(self.surface.point_at(uv.x, uv.y));
        self.sheet.normals.push(self.surface.normal_at(uv.x, uv.y).unwrap_or(Vector3::ZERO));
        let old = pair.map(|t| self.net.get(t));
        let new: Vec<[u32; 3]> = (old.into_iter().flatten())
            .flat_map(|t| [a, b].map(|end| t.map(|v| if v == end { middle } else { v })))
            .collect();
        self.replace(&pair, &new);
    }
}

/// The directed sides of a triangle.
fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The corner after one.
fn after(corners: [u32; 3], x: u32) -> Option<u32> {
    let k = corners.iter().position(|&v| v == x)?;
    corners.get((k + 1) % 3).copied()
}
