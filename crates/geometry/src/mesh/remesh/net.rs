use crate::mesh::thresholds::NO_FLIP;
use std::collections::{HashMap, HashSet};

use super::{Remeshed, too_many};
use crate::box_tree::{BoxTree, bounds_of};
use crate::cancellation::check;
use crate::{Error, Line, Mesh, MeshFace, Point3, Result, Vector3};

/// Whether a surface stays one when an edge collapses, of whose ends the neighbours are given.
fn stays_whole(near: &[u32], far: &[u32], sides: &[u32]) -> bool {
    // Only the corners across the edge may be neighbours of both.
    let common = near.iter().filter(|v| far.binary_search(v).is_ok()).count();
    // A closed net of four faces would fall flat.
    common == sides.len() && !(sides.len() == 2 && near.len() == 3 && far.len() == 3)
}

/// Edges are on a line within this part of the mesh's size.
const ON_LINE: f64 = 1e-9;
/// A face that is no more.
const GONE: [u32; 3] = [u32::MAX; 3];
/// Splitting halves edges: so many rounds are enough for any lengths.
const ROUNDS: usize = 64;
/// Faces may turn by this much at most (the cosine) when a vertex moves.
const LEAST_COSINE: f64 = 0.5;

/// Triangles that change, with the faces around every vertex.
pub(super) struct Net {
    points: Vec<Point3>,
    faces: Vec<[u32; 3]>,
    around: Vec<Vec<u32>>,
    /// Edges that stay, the smaller end first: borders, creases, and where more than two faces meet.
    kept: HashSet<[u32; 2]>,
    /// Those of them that are creases.
    creases: HashSet<[u32; 2]>,
    /// Vertices that an edge which stays ends at.
    on_kept: Vec<bool>,
}

fn key(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

impl Net {
    pub(super) fn new(mesh: &Mesh, crease: Option<f64>) -> Result<Self> {
        let merged = mesh.merged_indices();
        let corner = |i: u32| merged.get(i as usize).copied().unwrap_or(i);
        let points = mesh.vertices().to_vec();
        let area = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|i| points.get(i as usize).copied().unwrap_or_default());
            (b - a).cross(c - a).length()
        };
        let faces: Vec<[u32; 3]> = mesh
            .faces()
            .iter()
            .flat_map(|f| f.triangles())
            .map(|t| t.map(corner))
            .filter(|t| area(t) > 0.0)
            .collect();
        if faces.is_empty() {
            return Err(Error::degenerate("mesh to remesh", "it has no faces with an area"));
        }
        let mut around = vec![Vec::new(); points.len()];
        for (t, f) in faces.iter().zip(0..) {
            t.iter().for_each(|&i| around[i as usize].push(f));
        }
        let on_kept = vec![false; points.len()];
        let mut net = Self { points, faces, around, kept: HashSet::new(), creases: HashSet::new(), on_kept };
        for [a, b] in net.edges() {
            let sides = net.sides(a, b);
            let bent = |limit: f64| match sides.as_slice() {
                &[f, g] => net.normal(f).angle_to(net.normal(g)).is_some_and(|x| x > limit),
                _ => false,
            };
            let creased = crease.is_some_and(bent);
            if creased {
                net.creases.insert([a, b]);
            }
            if sides.len() != 2 || creased {
                net.keep(a, b);
            }
        }
        Ok(net)
    }

    /// As [`Net::new`]; edges that lie on the given lines stay too.
    pub(super) fn with_lines(mesh: &Mesh, crease: Option<f64>, lines: &[Line]) -> Result<Self> {
        let mut net = Self::new(mesh, crease)?;
        if lines.is_empty() {
            return Ok(net);
        }
        let boxes: Vec<_> = lines.iter().map(|l| bounds_of([l.from, l.to].map(Into::into))).collect();
        let tree = BoxTree::by_place(&boxes);
        let size = mesh.bounding_box().map_or(0.0, |b| b.diagonal().length());
        let on_line = |p: Point3| {
            let mut nearest = f64::INFINITY;
            tree.visit_near(&p.into(), (ON_LINE * size).powi(2), |i| {
                if let Some(line) = lines.get(i) {
                    let foot = line.at(line.closest_parameter(p).clamp(0.0, 1.0));
                    nearest = nearest.min((foot - p).length_squared());
                }
                nearest
            });
            nearest <= (ON_LINE * size).powi(2)
        };
        let mut near: HashMap<u32, bool> = HashMap::new();
        for [a, b] in net.edges() {
            let ends = [a, b].map(|v| *near.entry(v).or_insert_with(|| on_line(net.at(v))));
            if ends == [true; 2] && on_line(net.middle(a, b)) {
                net.keep(a, b);
            }
        }
        Ok(net)
    }

    /// An edge stays from now on.
    pub(super) fn keep(&mut self, a: u32, b: u32) {
        self.kept.insert(key(a, b));
        (self.on_kept[a as usize], self.on_kept[b as usize]) = (true, true);
    }

    pub(super) fn at(&self, i: u32) -> Point3 {
        self.points[i as usize]
    }

    fn length(&self, a: u32, b: u32) -> f64 {
        self.at(a).distance_to(self.at(b))
    }

    fn middle(&self, a: u32, b: u32) -> Point3 {
        self.at(a).lerp(self.at(b), 0.5)
    }

    /// The doubled area vector of a face.
    fn normal(&self, f: u32) -> Vector3 {
        self.normal_of(self.faces[f as usize])
    }

    fn normal_of(&self, t: [u32; 3]) -> Vector3 {
        let [a, b, c] = t.map(|i| self.at(i));
        (b - a).cross(c - a)
    }

    /// All edges, the smaller end first, in order.
    pub(super) fn edges(&self) -> Vec<[u32; 2]> {
        let sides = self.faces.iter().filter(|t| **t != GONE);
        let mut out: Vec<[u32; 2]> = sides.flat_map(|&[a, b, c]| [key(a, b), key(b, c), key(c, a)]).collect();
        out.sort_unstable();
        out.dedup();
        out
    }

    /// The faces along an edge.
    pub(super) fn sides(&self, a: u32, b: u32) -> Vec<u32> {
        self.around[a as usize].iter().copied().filter(|&f| self.faces[f as usize].contains(&b)).collect()
    }

    /// The vertices that edges join to one.
    pub(super) fn neighbours(&self, v: u32) -> Vec<u32> {
        let mut out: Vec<u32> = self.around[v as usize]
            .iter()
            .flat_map(|&f| self.faces[f as usize])
            .filter(|&w| w != v)
            .collect();
        out.sort_unstable();
        out.dedup();
        out
    }

    /// The other ends of the edges at a vertex that stay.
    pub(super) fn kept_neighbours(&self, v: u32) -> Vec<u32> {
        if !self.on_kept[v as usize] {
            return Vec::new();
        }
        self.neighbours(v).into_iter().filter(|&w| self.kept.contains(&key(v, w))).collect()
    }

    /// The segments of the edges that stay.
    pub(super) fn lines(&self) -> Vec<Line> {
        let mut all: Vec<[u32; 2]> = self.kept.iter().copied().collect();
        all.sort_unstable();
        all.into_iter().map(|[a, b]| Line::new(self.at(a), self.at(b))).collect()
    }

    pub(super) fn split_long(&mut self, longest: impl Fn(Point3) -> f64, limit: usize) -> Result<()> {
        for _ in 0..ROUNDS {
            let mut done = true;
            for [a, b] in self.edges() {
                check()?;
                if self.length(a, b) > longest(self.middle(a, b)) {
                    self.split(a, b);
                    done = false;
                }
                if self.faces.len() > limit.saturating_mul(4) {
                    return Err(too_many());
                }
            }
            if done {
                break;
            }
        }
        Ok(())
    }

    fn split(&mut self, a: u32, b: u32) {
        self.split_at(a, b, self.middle(a, b));
    }

    /// Splits an edge by a new vertex at a place.
    pub(super) fn split_at(&mut self, a: u32, b: u32, place: Point3) {
        let m = self.points.len() as u32;
        self.points.push(place);
        self.around.push(Vec::new());
        self.on_kept.push(false);
        for f in self.sides(a, b) {
            let half = self.faces[f as usize].map(|i| if i == a { m } else { i });
            let own = &mut self.faces[f as usize];
            *own = own.map(|i| if i == b { m } else { i });
            let new = self.faces.len() as u32;
            self.faces.push(half);
            // The half at b is new: it takes the old face's place there, and comes to the corner across.
            for &i in &half {
                if i == b {
                    self.around[b as usize].iter_mut().filter(|g| **g == f).for_each(|g| *g = new);
                } else {
                    self.around[i as usize].push(new);
                }
            }
            self.around[m as usize].push(f);
        }
        if self.kept.remove(&key(a, b)) {
            self.keep(a, m);
            self.keep(m, b);
        }
        if self.creases.remove(&key(a, b)) {
            self.creases.extend([key(a, m), key(m, b)]);
        }
    }

    pub(super) fn collapse_short(
        &mut self,
        shortest: impl Fn(Point3) -> f64,
        longest: impl Fn(Point3) -> f64,
    ) {
        for [a, b] in self.edges() {
            // Whoever has this done looks whether to go on.
            if check().is_err() {
                return;
            }
            if self.around[a as usize].is_empty() || self.around[b as usize].is_empty() {
                continue;
            }
            let sides = self.sides(a, b);
            if sides.is_empty() || self.length(a, b) >= shortest(self.middle(a, b)) {
                continue;
            }
            if let Some((stays, goes, place)) = self.collapse_to(a, b, &sides)
                && self.may_collapse(stays, goes, place, &sides, longest(place))
            {
                self.collapse(stays, goes, place, &sides);
            }
        }
    }

    /// Which end of an edge stays, and where, when it collapses.
    fn collapse_to(&self, a: u32, b: u32, sides: &[u32]) -> Option<(u32, u32, Point3)> {
        let (at_a, at_b) = (self.kept_neighbours(a), self.kept_neighbours(b));
        let middle = self.at(a).lerp(self.at(b), 0.5);
        match (at_a.len(), at_b.len()) {
            (0, 0) => Some((a, b, middle)),
            (_, 0) => Some((a, b, self.at(a))),
            (0, _) => Some((b, a, self.at(b))),
            // Along an edge that stays, from a vertex on it to any other.
            (_, 2) if at_b.contains(&a) && self.goes_straight(b, &at_b) => Some((a, b, self.at(a))),
            (2, _) if at_a.contains(&b) && self.goes_straight(a, &at_a) => Some((b, a, self.at(b))),
            _ => None,
        }
        .filter(|_| sides.len() <= 2)
    }

    /// Whether the edges that stay go on about straight at a vertex.
    pub(super) fn goes_straight(&self, v: u32, ends: &[u32]) -> bool {
        let [p, q] = ends else { return false };
        let (d, e) = (self.at(v) - self.at(*p), self.at(*q) - self.at(v));
        d.angle_to(e).is_none_or(|x| x < 0.5)
    }

    fn may_collapse(&self, stays: u32, goes: u32, place: Point3, sides: &[u32], longest: f64) -> bool {
        let (near, far) = (self.neighbours(stays), self.neighbours(goes));
        if !stays_whole(&near, &far, sides) {
            return false;
        }
        let too_long = |v: &u32| *v != stays && *v != goes && self.at(*v).distance_to(place) > longest;
        if near.iter().any(too_long) || far.iter().any(too_long) {
            return false;
        }
        [stays, goes].iter().all(|&v| {
            self.around[v as usize]
                .iter()
                .filter(|f| !sides.contains(f))
                .all(|&f| self.turns_little(f, v, place))
        })
    }

    /// Makes one vertex of the ends of an edge wherever they are, if the net stays a surface and the edges that stay
    /// keep their course: the one that stays, and the one that is no more.
    pub(super) fn merge(&mut self, a: u32, b: u32) -> Option<[u32; 2]> {
        let sides = self.sides(a, b);
        if sides.is_empty() {
            return None;
        }
        let (stays, goes, place) = self.collapse_to(a, b, &sides)?;
        let whole = stays_whole(&self.neighbours(stays), &self.neighbours(goes), &sides);
        (whole && !self.flattens(stays, goes, &sides)).then(|| {
            self.collapse(stays, goes, place, &sides);
            [stays, goes]
        })
    }

    /// Whether a face would lie along an edge that stays, with all its corners on it.
    fn flattens(&self, stays: u32, goes: u32, sides: &[u32]) -> bool {
        let kept = |a: u32, b: u32| {
            let own = |v: u32| if v == stays { [stays, goes] } else { [v, v] };
            own(a).iter().any(|&x| own(b).iter().any(|&y| x != y && self.is_kept(x, y)))
        };
        self.around[goes as usize].iter().filter(|f| !sides.contains(f)).any(|&f| {
            let t = self.faces[f as usize].map(|i| if i == goes { stays } else { i });
            (0..3).any(|k| {
                let (v, p, q) = (t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
                kept(v, p) && kept(v, q) && self.goes_straight(v, &[p, q])
            })
        })
    }

    /// Whether a face keeps its side, and some area, when a corner moves.
    fn turns_little(&self, f: u32, corner: u32, place: Point3) -> bool {
        let t = self.faces[f as usize];
        let [a, b, c] = t.map(|i| if i == corner { place } else { self.at(i) });
        let (old, new) = (self.normal(f), (b - a).cross(c - a));
        let sides = (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
        new.length() > NO_FLIP * sides && old.dot(new) > LEAST_COSINE * old.length() * new.length()
    }

    fn collapse(&mut self, stays: u32, goes: u32, place: Point3, sides: &[u32]) {
        for &f in sides {
            for i in std::mem::replace(&mut self.faces[f as usize], GONE) {
                self.around[i as usize].retain(|g| *g != f);
            }
        }
        for w in self.kept_neighbours(goes).into_iter().chain([stays]) {
            self.kept.remove(&key(goes, w));
            let creased = self.creases.remove(&key(goes, w));
            if w != stays {
                self.keep(stays, w);
                if creased {
                    self.creases.insert(key(stays, w));
                }
            }
        }
        let moved = std::mem::take(&mut self.around[goes as usize]);
        for &f in &moved {
            let own = &mut self.faces[f as usize];
            *own = own.map(|i| if i == goes { stays } else { i });
        }
        self.around[stays as usize].extend(moved);
        self.points[stays as usize] = place;
    }

    /// Flips edges where that brings the numbers of neighbours nearer to what they should be.
    pub(super) fn flip(&mut self) {
        for [a, b] in self.edges() {
            // Whoever has this done looks whether to go on.
            if check().is_err() {
                return;
            }
            if self.kept.contains(&[a, b]) {
                continue;
            }
            let sides = self.sides(a, b);
            let &[f, g] = sides.as_slice() else { continue };
            let across = |f: u32| self.faces[f as usize].into_iter().find(|&i| i != a && i != b);
            let (Some(c), Some(d)) = (across(f), across(g)) else { continue };
            if c == d || !self.sides(c, d).is_empty() {
                continue;
            }
            let excess = |v: u32, change: i64| {
                let ideal = if self.on_kept[v as usize] { 4 } else { 6 };
                (self.neighbours(v).len() as i64 + change - ideal).pow(2)
            };
            let before: i64 = [a, b, c, d].iter().map(|&v| excess(v, 0)).sum();
            let after = excess(a, -1) + excess(b, -1) + excess(c, 1) + excess(d, 1);
            if after >= before {
                continue;
            }
            // Face f keeps its sense: a goes over to b in one, b to a in the other.
            let new_f = self.faces[f as usize].map(|i| if i == b { d } else { i });
            let new_g = self.faces[g as usize].map(|i| if i == a { c } else { i });
            let old = self.normal(f) + self.normal(g);
            let sound = |t: [u32; 3]| {
                let n = self.normal_of(t);
                n.dot(old) > 0.8 * n.length() * old.length() && n.length() > 0.05 * old.length()
            };
            if !(sound(new_f) && sound(new_g)) {
                continue;
            }
            self.faces[f as usize] = new_f;
            self.faces[g as usize] = new_g;
            self.around[b as usize].retain(|x| *x != f);
            self.around[a as usize].retain(|x| *x != g);
            self.around[d as usize].push(f);
            self.around[c as usize].push(g);
        }
    }

    /// Moves vertices towards the middle of their neighbours, along the surface or along the edges that stay.
    pub(super) fn smooth(
        &mut self,
        on_surface: impl Fn(Point3) -> Point3,
        on_line: impl Fn(Point3) -> Point3,
    ) {
        for v in 0..self.points.len() as u32 {
            if self.around[v as usize].is_empty() {
                continue;
            }
            if check().is_err() {
                return;
            }
            let (here, ends) = (self.at(v), self.kept_neighbours(v));
            let place = match ends.as_slice() {
                [] => {
                    let near = self.neighbours(v);
                    let n = near.len() as f64;
                    let middle = near.iter().map(|&w| self.at(w) - here).sum::<Vector3>() / n;
                    let normal: Vector3 = self.around[v as usize].iter().map(|&f| self.normal(f)).sum();
                    let level = normal.unitized().map_or(middle, |n| middle - n * n.dot(middle));
                    on_surface(here + level)
                }
                [p, q] if self.goes_straight(v, &ends) => on_line(self.at(*p).lerp(self.at(*q), 0.5)),
                _ => continue,
            };
            if place.is_finite() && self.around[v as usize].iter().all(|&f| self.turns_little(f, v, place)) {
                self.points[v as usize] = place;
            }
        }
    }

    /// Moves the vertex nearest to a place there, unless it holds an edge that stays.
    pub(super) fn pull_nearest_to(&mut self, p: Point3) {
        let free = (0..self.points.len() as u32)
            .filter(|&v| !self.around[v as usize].is_empty() && !self.on_kept[v as usize]);
        let nearest = free.min_by(|&v, &w| self.at(v).distance_to(p).total_cmp(&self.at(w).distance_to(p)));
        if let Some(v) = nearest {
            self.move_to(v, p);
        }
    }

    /// Moves a vertex, unless a face would turn over or lose its area: whether it did.
    pub(super) fn move_to(&mut self, v: u32, place: Point3) -> bool {
        let may = self.around[v as usize].iter().all(|&f| self.turns_little(f, v, place));
        if may {
            self.points[v as usize] = place;
        }
        may
    }

    /// The vertices that have faces.
    pub(super) fn vertices(&self) -> Vec<u32> {
        (0..self.points.len() as u32).filter(|&v| !self.around[v as usize].is_empty()).collect()
    }

    /// How many vertices there are, those that are no more included.
    pub(super) fn vertex_count(&self) -> usize {
        self.points.len()
    }

    /// The unit normal at a vertex.
    pub(super) fn normal_at(&self, v: u32) -> Vector3 {
        let sum: Vector3 = self.around[v as usize].iter().map(|&f| self.normal(f)).sum();
        sum.unitized().unwrap_or(Vector3::Z)
    }

    /// A third of the area of the faces at a vertex.
    pub(super) fn area_at(&self, v: u32) -> f64 {
        self.around[v as usize].iter().map(|&f| self.normal(f).length()).sum::<f64>() / 6.0
    }

    /// Whether an edge stays.
    pub(super) fn is_kept(&self, a: u32, b: u32) -> bool {
        self.kept.contains(&key(a, b))
    }

    /// The faces with their numbers.
    pub(super) fn triangles(&self) -> impl Iterator<Item = (u32, [u32; 3])> + '_ {
        self.faces.iter().zip(0..).filter(|(t, _)| **t != GONE).map(|(t, f)| (f, *t))
    }

    /// The corners of the two faces along an edge, without the edge, in the sense of the faces.
    pub(super) fn joined(&self, f: u32, g: u32, [a, b]: [u32; 2]) -> Option<[u32; 4]> {
        let own = self.faces[f as usize];
        let across = |f: u32| self.faces[f as usize].into_iter().find(|&i| i != a && i != b);
        let (c, d) = (across(f)?, across(g)?);
        let start = own.iter().position(|&i| i == c)?;
        let (first, second) = (own[(start + 1) % 3], own[(start + 2) % 3]);
        (c != d).then_some([c, first, d, second])
    }

    pub(super) fn finish(self) -> Result<Remeshed> {
        let mut numbers = vec![0_u32; self.points.len()];
        let mut vertices = Vec::new();
        for (i, list) in self.around.iter().enumerate() {
            if !list.is_empty() {
                numbers[i] = vertices.len() as u32;
                vertices.push(self.points[i]);
            }
        }
        let faces = self.faces.iter().filter(|t| **t != GONE);
        let faces = faces.map(|t| MeshFace::Triangle(t.map(|i| numbers[i as usize]))).collect();
        let mut creases: Vec<[u32; 2]> = self.creases.iter().copied().collect();
        creases.sort_unstable();
        let creases = creases.into_iter().map(|[a, b]| Line::new(self.at(a), self.at(b))).collect();
        Ok(Remeshed { mesh: Mesh::new(vertices, faces)?.with_normals(), creases })
    }
}
