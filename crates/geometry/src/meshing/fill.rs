//! The mesh inside the outline of a face: its cells where they lie inside whole, and triangles between them and the
//! outline.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use super::clip::{Contact, contact, touches};
use super::corner_cutting::cut_corners;
use super::grid::{Grid, Node};
use super::outline::Outline;
use super::ring::{self, Ring};
use super::settings::Limits;
use crate::{MeshFace, Point2, Result, Surface};

/// A hash of one number: places are spread already but for their order.
#[derive(Default)]
pub(super) struct PlaceHasher(u64);

impl Hasher for PlaceHasher {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for &b in bytes {
            self.write_u64(u64::from(b));
        }
    }

    fn write_u64(&mut self, x: u64) {
        self.0 = (self.0.rotate_left(5) ^ x).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        self.0 ^= self.0 >> 32;
    }
}

pub(super) type PlaceMap<K, V> = HashMap<K, V, BuildHasherDefault<PlaceHasher>>;

/// A vertex of a face's mesh.
#[derive(Debug, Clone, Copy)]
pub(super) struct Vertex {
    pub(super) uv: Point2,
    /// Its place among the points of the brep's mesh, when it lies on an edge.
    pub(super) id: Option<u32>,
}

/// The mesh of a face in its parameter plane.
#[derive(Default)]
pub(super) struct Filled {
    pub(super) vertices: Vec<Vertex>,
    pub(super) faces: Vec<MeshFace>,
    /// Points on edges that are in one place of the parameter plane.
    pub(super) welds: Vec<[u32; 2]>,
    /// Trims whose segments cross others.
    pub(super) crossing: Vec<u32>,
}

/// What becomes of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum State {
    /// It lies outside, or is halved.
    Outside,
    /// It is part of the mesh as it is.
    Clean,
    /// The outline passes through.
    Cut,
}

/// Where the work stands.
pub(super) struct Filling<'a> {
    pub(super) grid: &'a Grid,
    pub(super) outline: &'a Outline,
    /// What makes parameters comparable: lengths of a usual cell are about 1.
    pub(super) scale: [f64; 2],
    pub(super) states: Vec<State>,
    pub(super) vertices: Vec<Vertex>,
    /// Vertices at places of the grid.
    places: PlaceMap<u64, u32>,
    /// For every corner of the outline its vertex.
    corners: Vec<u32>,
    /// For cells that the outline runs along: the corners on their sides and the ranges it covers.
    sided: PlaceMap<u64, Vec<u32>>,
    /// Whether a vertex may be on the border between clean cells and the rest.
    marked: Vec<bool>,
    /// Vertices that belong to no clean cell and not to the outline.
    pub(super) loose: Vec<u32>,
}

fn key(i: u32, j: u32) -> u64 {
    u64::from(i) << 32 | u64::from(j)
}

/// Fills the outline of a face.
///
/// # Errors
/// Numbers beyond what a triangulation takes.
pub(super) fn fill(surface: &Surface, grid: &Grid, outline: &Outline, limits: &Limits) -> Result<Filled> {
    let mut filling = Filling {
        grid,
        outline,
        scale: scale(surface, grid),
        states: Vec::new(),
        vertices: Vec::new(),
        places: PlaceMap::default(),
        corners: Vec::new(),
        sided: PlaceMap::default(),
        marked: Vec::new(),
        loose: Vec::new(),
    };
    let mut out = Filled::default();
    filling.add_corners(&mut out.welds);
    filling.judge_cells();
    filling.add_places();
    let mut sides = Vec::new();
    filling.add_cells(&mut out.faces, &mut sides);
    for k in 0..outline.corners.len() {
        let (a, b) = (filling.corner(k), filling.corner(outline.next(k)));
        if a != b {
            sides.push([a.min(b), a.max(b)]);
        }
    }
    let ring = Ring { filling: &mut filling, sides: odd(sides), limits };
    out.crossing = ring::fill(ring, &mut out.faces)?;
    out.vertices = filling.vertices;
    Ok(out)
}

/// What makes the sides of a usual cell about 1, without stretching shapes in space too far.
fn scale(surface: &Surface, grid: &Grid) -> [f64; 2] {
    const STRETCH: f64 = 6.0;
    let range = [0, 1].map(|d| {
        let lines = &grid.lines[d];
        match lines.as_slice() {
            [first, .., last] => (*first, *last, (last - first) / (lines.len() - 1) as f64),
            _ => (0.0, 0.0, 1.0),
        }
    });
    let middle = range.map(|(first, last, _)| 0.5 * (first + last));
    let d = surface.derivatives(middle[0], middle[1], 1, crate::Quadrant::NorthEast);
    let bend = grid.bend(range.map(|(first, last, _)| [first, last]));
    let speed = [0, 1].map(|k| {
        let here = if k == 0 { d.get(1, 0).length() } else { d.get(0, 1).length() };
        let speed = here.max(0.1 * bend.speed[k]);
        if speed > 0.0 && speed.is_finite() { speed } else { 1.0 }
    });
    let mut cell = [0, 1].map(|k| range[k].2 * speed[k]);
    for k in 0..2 {
        cell[k] = cell[k].clamp(cell[1 - k] / STRETCH, cell[1 - k] * STRETCH);
    }
    [speed[0] / cell[0], speed[1] / cell[1]]
}

/// Pairs that are there an odd number of times, in order.
fn odd(mut pairs: Vec<[u32; 2]>) -> Vec<[u32; 2]> {
    pairs.sort_unstable();
    pairs
        .chunk_by(|a, b| a == b)
        .filter(|same| same.len() % 2 == 1)
        .filter_map(|same| same.first().copied())
        .collect()
}

impl Filling<'_> {
    /// The vertex of a corner of the outline.
    pub(super) fn corner(&self, k: usize) -> u32 {
        self.corners.get(k).copied().unwrap_or(0)
    }

    /// A new vertex.
    pub(super) fn add(&mut self, uv: Point2, id: Option<u32>) -> u32 {
        self.vertices.push(Vertex { uv, id });
        self.marked.push(id.is_some());
        self.vertices.len() as u32 - 1
    }

    /// The corners of the outline; those in one place of the plane are one vertex.
    fn add_corners(&mut self, welds: &mut Vec<[u32; 2]>) {
        let mut known: PlaceMap<[u64; 2], u32> = PlaceMap::default();
        let bits = |x: f64| if x == 0.0 { 0 } else { x.to_bits() };
        for corner in &self.outline.corners {
            let vertex = *known.entry([bits(corner.uv.x), bits(corner.uv.y)]).or_insert_with(|| {
                self.vertices.push(Vertex { uv: corner.uv, id: Some(corner.id) });
                self.marked.push(true);
                self.vertices.len() as u32 - 1
            });
            self.corners.push(vertex);
            let id = self.vertices.get(vertex as usize).and_then(|v| v.id);
            if let Some(id) = id.filter(|id| *id != corner.id) {
                welds.push([id, corner.id]);
            }
        }
        for (k, corner) in self.outline.corners.iter().enumerate() {
            if let (Some(i), Some(j)) = (self.grid.place(0, corner.uv.x), self.grid.place(1, corner.uv.y)) {
                self.places.insert(key(i, j), self.corner(k));
            }
        }
    }

    /// Tells what becomes of every cell.
    fn judge_cells(&mut self) {
        let (grid, outline) = (self.grid, self.outline);
        self.states = vec![State::Outside; grid.nodes.len()];
        let mut touched: Vec<(usize, u32)> = Vec::new();
        for k in 0..outline.corners.len() {
            let Some([a, b]) = outline.segment(k) else { continue };
            let around = [[a.uv.x.min(b.uv.x), a.uv.x.max(b.uv.x)], [a.uv.y.min(b.uv.y), a.uv.y.max(b.uv.y)]];
            grid.visit(around, |own| touches(a.uv, b.uv, own), |node, _| touched.push((node, k as u32)));
        }
        touched.sort_unstable();
        let mut rest = touched.as_slice();
        for (k, node) in grid.nodes.iter().enumerate() {
            if node.halves.is_some() {
                continue;
            }
            while rest.first().is_some_and(|t| t.0 < k) {
                rest = rest.get(1..).unwrap_or(&[]);
            }
            let count = rest.iter().take_while(|t| t.0 == k).count();
            let here = rest.get(..count).unwrap_or(&[]);
            let own = grid.rectangle(node);
            let mut along = Vec::new();
            let mut cut = false;
            for &(_, s) in here {
                let Some([a, b]) = outline.segment(s as usize) else { continue };
                match contact(a.uv, b.uv, own) {
                    Contact::Through => cut = true,
                    Contact::Along => along.push(s),
                    Contact::Corner => {}
                }
            }
            let middle = Point2::new(0.5 * (own[0][0] + own[0][1]), 0.5 * (own[1][0] + own[1][1]));
            let state = match (cut, outline.contains(middle)) {
                (true, _) => State::Cut,
                (false, true) => State::Clean,
                (false, false) => State::Outside,
            };
            if let Some(slot) = self.states.get_mut(k) {
                *slot = state;
            }
            if state == State::Clean && !along.is_empty() {
                self.sided.insert(k as u64, along);
            }
        }
    }

    fn leaves(&self, wanted: State) -> impl Iterator<Item = (usize, Node)> + '_ {
        let list = self.states.iter().zip(&self.grid.nodes).enumerate();
        list.filter(move |(_, (state, _))| **state == wanted).map(|(k, (_, node))| (k, *node))
    }

    /// Makes vertices at the corners of cells: of clean ones all, of those that are cut what lies well inside.
    fn add_places(&mut self) {
        let grid = self.grid;
        let corners = |node: &Node| {
            let [[i0, i1], [j0, j1]] = node.range;
            [(i0, j0), (i1, j0), (i1, j1), (i0, j1)]
        };
        let clean: Vec<Node> = self.leaves(State::Clean).map(|x| x.1).collect();
        self.places.reserve(clean.len());
        for node in &clean {
            for (i, j) in corners(node) {
                if !self.places.contains_key(&key(i, j)) {
                    let uv = Point2::new(grid.parameter(0, i), grid.parameter(1, j));
                    let vertex = self.add(uv, None);
                    self.places.insert(key(i, j), vertex);
                }
            }
        }
        let cut: Vec<Node> = self.leaves(State::Cut).map(|x| x.1).collect();
        for node in &cut {
            for (i, j) in corners(node) {
                if self.places.contains_key(&key(i, j)) {
                    continue;
                }
                let uv = Point2::new(grid.parameter(0, i), grid.parameter(1, j));
                if self.outline.contains(uv) && (self.is_on_clean(uv) || self.is_clear(uv, node)) {
                    let vertex = self.add(uv, None);
                    self.places.insert(key(i, j), vertex);
                    self.loose.push(vertex);
                }
            }
        }
        // Whatever lies on the sides of cells that are cut may border on clean ones.
        let mut side = Vec::new();
        for node in &cut {
            let round = corners(node);
            for k in 0..4 {
                side.clear();
                self.side_places(round[k], round[(k + 1) % 4], &mut side);
                for (i, j) in side.iter().copied().chain([round[k]]) {
                    let vertex = self.places.get(&key(i, j)).copied();
                    if let Some(slot) = vertex.and_then(|v| self.marked.get_mut(v as usize)) {
                        *slot = true;
                    }
                }
            }
        }
    }

    /// Whether a clean cell touches a point.
    fn is_on_clean(&self, uv: Point2) -> bool {
        let mut found = false;
        self.grid.visit(
            [[uv.x, uv.x], [uv.y, uv.y]],
            |_| true,
            |k, _| found |= self.states.get(k) == Some(&State::Clean),
        );
        found
    }

    /// Whether a point keeps its distance from the outline, by the size of a cell.
    fn is_clear(&self, uv: Point2, node: &Node) -> bool {
        const CLEARANCE: f64 = 0.3;
        let own = self.grid.rectangle(node);
        let reach = [0, 1].map(|d| CLEARANCE * (own[d][1] - own[d][0]));
        let around = [[uv.x - reach[0], uv.x + reach[0]], [uv.y - reach[1], uv.y + reach[1]]];
        self.outline.none_touches(around)
    }

    /// The places with vertices between two on one line, in order; the ends not among them.
    fn side_places(&self, a: (u32, u32), b: (u32, u32), out: &mut Vec<(u32, u32)>) {
        let middle = |x: u32, y: u32| x.min(y) + x.abs_diff(y) / 2;
        let m = (middle(a.0, b.0), middle(a.1, b.1));
        if m == a || m == b || !self.places.contains_key(&key(m.0, m.1)) {
            return;
        }
        self.side_places(a, m, out);
        out.push(m);
        self.side_places(m, b, out);
    }

    /// Adds the clean cells to the mesh, and to `sides` those of their sides that the rest may border on.
    fn add_cells(&mut self, faces: &mut Vec<MeshFace>, sides: &mut Vec<[u32; 2]>) {
        let clean: Vec<(usize, Node)> = self.leaves(State::Clean).collect();
        faces.reserve(clean.len());
        let mut round = Vec::new();
        for (k, node) in clean {
            self.round(k, &node, &mut round);
            for (n, &a) in round.iter().enumerate() {
                let b = round.get((n + 1) % round.len()).copied().unwrap_or(a);
                let marked = |v: u32| self.marked.get(v as usize).copied().unwrap_or(false);
                if marked(a) && marked(b) {
                    sides.push([a.min(b), a.max(b)]);
                }
            }
            cut_corners(&self.vertices, self.scale, &round, faces);
        }
    }

    /// The vertices around a clean cell, counter-clockwise from its corner of smallest parameters.
    fn round(&self, k: usize, node: &Node, out: &mut Vec<u32>) {
        out.clear();
        let [[i0, i1], [j0, j1]] = node.range;
        let corners = [(i0, j0), (i1, j0), (i1, j1), (i0, j1)];
        let along = self.sided.get(&(k as u64));
        let mut side = Vec::new();
        for n in 0..4 {
            let (a, b) = (corners[n], corners[(n + 1) % 4]);
            out.extend(self.places.get(&key(a.0, a.1)));
            side.clear();
            self.side_places(a, b, &mut side);
            match along {
                None => out.extend(side.iter().filter_map(|&(i, j)| self.places.get(&key(i, j)))),
                Some(along) => self.covered_side(a, b, &side, along, out),
            }
        }
    }

    /// The vertices along a side that the outline runs along in part: where it does, its corners.
    fn covered_side(
        &self,
        a: (u32, u32),
        b: (u32, u32),
        side: &[(u32, u32)],
        along: &[u32],
        out: &mut Vec<u32>,
    ) {
        // The direction that varies, and the parameter that does not.
        let d = usize::from(a.0 == b.0);
        let constant = if d == 0 { self.grid.parameter(1, a.1) } else { self.grid.parameter(0, a.0) };
        let place =
            |p: (u32, u32)| if d == 0 { self.grid.parameter(0, p.0) } else { self.grid.parameter(1, p.1) };
        let (from, to) = (place(a), place(b));
        let split = |uv: Point2| if d == 0 { (uv.x, uv.y) } else { (uv.y, uv.x) };
        let (mut covered, mut found): (Vec<[f64; 2]>, Vec<(f64, u32)>) = Default::default();
        for &s in along {
            let Some([p, q]) = self.outline.segment(s as usize) else { continue };
            let ((x, across), (y, other)) = (split(p.uv), split(q.uv));
            if across != constant || other != constant {
                continue;
            }
            covered.push([x.min(y), x.max(y)]);
            for (t, k) in [(x, s as usize), (y, self.outline.next(s as usize))] {
                if t > from.min(to) && t < from.max(to) {
                    found.push((t, self.corner(k)));
                }
            }
        }
        for &p in side {
            let t = place(p);
            if !covered.iter().any(|c| c[0] < t && t < c[1])
                && let Some(&v) = self.places.get(&key(p.0, p.1))
            {
                found.push((t, v));
            }
        }
        found.sort_by(|x, y| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1)));
        found.dedup();
        if from > to {
            found.reverse();
        }
        out.extend(found.iter().map(|x| x.1));
    }
}
