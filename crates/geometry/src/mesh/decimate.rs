//! Meshes with fewer faces.

use crate::mesh::thresholds::{LENGTH_COST, NO_QUADRIC};
use std::cmp::Ordering;
use std::collections::{BinaryHeap, HashMap};

use super::{Mesh, MeshFace};
use crate::{Error, Point3, Result, Vector3};

/// How far a mesh is reduced.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Decimation {
    /// The number of triangles to come down to.
    pub faces: usize,
    /// The greatest distance, root of the mean square, of a new vertex from the planes it stands for, in model units;
    /// infinite for no limit.
    pub max_error: f64,
}

/// A naked edge holds on by planes across it that weigh this much more than its face.
const RIM_WEIGHT: f64 = 100.0;
/// A triangle may turn by no more than this (as a cosine) when a corner moves.
const LEAST_TURN: f64 = 0.2;

/// The sum of squared distances to planes, each by its weight: xᵀAx + 2b·x + c.
#[derive(Clone, Copy, Default)]
struct Quadric {
    a: [f64; 6],
    b: Vector3,
    c: f64,
    weight: f64,
}

impl Quadric {
    fn plane(n: Vector3, p: Vector3, weight: f64) -> Self {
        let d = -n.dot(p);
        let a = [n.x * n.x, n.x * n.y, n.x * n.z, n.y * n.y, n.y * n.z, n.z * n.z].map(|x| x * weight);
        Self { a, b: n * (d * weight), c: d * d * weight, weight }
    }

    fn add(&mut self, other: &Self) {
        self.a.iter_mut().zip(other.a).for_each(|(x, y)| *x += y);
        self.b += other.b;
        self.c += other.c;
        self.weight += other.weight;
    }

    fn times(&self, x: Vector3) -> Vector3 {
        let [xx, xy, xz, yy, yz, zz] = self.a;
        Vector3::new(
            xx * x.x + xy * x.y + xz * x.z,
            xy * x.x + yy * x.y + yz * x.z,
            xz * x.x + yz * x.y + zz * x.z,
        )
    }

    fn at(&self, x: Vector3) -> f64 {
        (x.dot(self.times(x)) + 2.0 * self.b.dot(x) + self.c).max(0.0)
    }

    /// The place of the least sum; `None` where it is not determined well.
    fn best(&self) -> Option<Vector3> {
        let [xx, xy, xz, yy, yz, zz] = self.a;
        let (r, s, t) = (Vector3::new(xx, xy, xz), Vector3::new(xy, yy, yz), Vector3::new(xz, yz, zz));
        let det = r.dot(s.cross(t));
        let trace = xx + yy + zz;
        if !(det.abs() > NO_QUADRIC * trace * trace * trace) {
            return None;
        }
        // The matrix is symmetric: its inverse has the cross products of its rows as rows.
        let b = -self.b;
        let x = Vector3::new(s.cross(t).dot(b), t.cross(r).dot(b), r.cross(s).dot(b)) / det;
        x.is_finite().then_some(x)
    }
}

/// An edge that may be pulled together.
struct Collapse {
    cost: f64,
    ends: [u32; 2],
    place: Vector3,
    /// The ages of both ends when this was found: later ones have made it worthless.
    ages: [u32; 2],
}

impl PartialEq for Collapse {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Collapse {}

impl PartialOrd for Collapse {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Collapse {
    /// The cheapest is the greatest, as a heap gives the greatest first.
    fn cmp(&self, other: &Self) -> Ordering {
        other.cost.total_cmp(&self.cost).then(other.ends.cmp(&self.ends))
    }
}

/// The mesh while it is reduced: triangles between places.
struct Work {
    points: Vec<Vector3>,
    quadrics: Vec<Quadric>,
    ages: Vec<u32>,
    /// All places are relative to this, the middle of the mesh: sums of squares far from 0 lose digits.
    center: Vector3,
    /// Places on edges with more than two faces stay.
    fixed: Vec<bool>,
    /// The naked places, which only move along the rim.
    rim: Vec<bool>,
    triangles: Vec<Option<[u32; 3]>>,
    around: Vec<Vec<u32>>,
    heap: BinaryHeap<Collapse>,
    left: usize,
}

impl Mesh {
    /// The mesh with edges pulled together until `faces` triangles are left, those first that change the shape least
    /// (M. Garland, P. Heckbert, *Surface simplification using quadric error metrics*, SIGGRAPH 1997), with naked edges
    /// held by planes across them. Quads are cut to triangles, vertices in the same place become one; colours are those
    /// of the vertices that stay, normals are computed anew. An edge is left alone when pulling it would turn a face
    /// over, change how the mesh hangs together, or pass `max_error`; so more faces may be left than asked for.
    ///
    /// `go_on` is asked now and then; the work ends early when it says no.
    ///
    /// # Errors
    /// `max_error` is negative or NaN.
    pub fn decimated(&self, options: &Decimation, mut go_on: impl FnMut() -> bool) -> Result<Self> {
        if !(options.max_error >= 0.0) {
            return Err(Error::OutOfRange {
                what: "greatest error",
                value: options.max_error,
                must: "0 or more",
            });
        }
        let mut work = Work::new(self);
        let mut steps = 0_u32;
        while work.left > options.faces {
            steps = steps.wrapping_add(1);
            if steps.is_multiple_of(1024) && !go_on() {
                break;
            }
            let Some(next) = work.heap.pop() else { break };
            work.pull(&next, options.max_error);
        }
        work.finish(self)
    }
}

impl Work {
    fn new(mesh: &Mesh) -> Self {
        let merged = mesh.merged_indices();
        let place = |i: u32| merged.get(i as usize).copied().unwrap_or(i);
        let n = mesh.vertices.len();
        let center = mesh.bounding_box().map_or(Vector3::ZERO, |b| b.center().to_vector());
        let points: Vec<Vector3> = mesh.vertices.iter().map(|p| p.to_vector() - center).collect();
        let mut triangles = Vec::with_capacity(mesh.faces.len());
        for t in mesh.faces.iter().flat_map(|f| f.triangles()) {
            let t = t.map(place);
            if t[0] != t[1] && t[1] != t[2] && t[2] != t[0] {
                triangles.push(Some(t));
            }
        }
        let left = triangles.len();
        let mut work = Self {
            points,
            quadrics: vec![Quadric::default(); n],
            ages: vec![0; n],
            center,
            fixed: vec![false; n],
            rim: vec![false; n],
            triangles,
            around: vec![Vec::new(); n],
            heap: BinaryHeap::new(),
            left,
        };
        let mut edges: HashMap<[u32; 2], (u32, Vector3)> = HashMap::new();
        let mut order = Vec::new();
        for (k, t) in work.triangles.iter().enumerate() {
            let Some(t) = *t else { continue };
            let [a, b, c] = t.map(|i| work.points.get(i as usize).copied().unwrap_or(Vector3::ZERO));
            let doubled = (b - a).cross(c - a);
            let normal = doubled.unitized().unwrap_or(Vector3::ZERO);
            let flat = Quadric::plane(normal, a, 0.5 * doubled.length());
            for (i, j) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                if let (Some(list), Some(q)) =
                    (work.around.get_mut(i as usize), work.quadrics.get_mut(i as usize))
                {
                    list.push(k as u32);
                    q.add(&flat);
                }
                let key = [i.min(j), i.max(j)];
                let entry = edges.entry(key).or_insert_with(|| {
                    order.push(key);
                    (0, normal)
                });
                entry.0 += 1;
            }
        }
        for key in &order {
            let Some(&(faces, normal)) = edges.get(key) else { continue };
            let [i, j] = key.map(|v| v as usize);
            if faces == 1 {
                let (Some(&a), Some(&b)) = (work.points.get(i), work.points.get(j)) else { continue };
                let across = (b - a).cross(normal).unitized().unwrap_or(Vector3::ZERO);
                let wall = Quadric::plane(across, a, RIM_WEIGHT * (b - a).length_squared());
                for v in [i, j] {
                    if let (Some(q), Some(rim)) = (work.quadrics.get_mut(v), work.rim.get_mut(v)) {
                        q.add(&wall);
                        *rim = true;
                    }
                }
            } else if faces > 2 {
                for v in [i, j] {
                    if let Some(fixed) = work.fixed.get_mut(v) {
                        *fixed = true;
                    }
                }
            }
        }
        order.iter().for_each(|key| work.offer(key[0], key[1]));
        work
    }

    fn point(&self, i: u32) -> Vector3 {
        self.points.get(i as usize).copied().unwrap_or(Vector3::ZERO)
    }

    fn age(&self, i: u32) -> u32 {
        self.ages.get(i as usize).copied().unwrap_or(u32::MAX)
    }

    /// The triangles at a place that are still there.
    fn fan(&self, i: u32) -> impl Iterator<Item = (u32, [u32; 3])> + '_ {
        let list = self.around.get(i as usize).map_or(&[][..], Vec::as_slice);
        list.iter().filter_map(|&k| Some((k, (*self.triangles.get(k as usize)?)?)))
    }

    /// The places joined to a place, in order.
    fn ring(&self, i: u32) -> Vec<u32> {
        let mut ring: Vec<u32> = self.fan(i).flat_map(|(_, t)| t).filter(|&j| j != i).collect();
        ring.sort_unstable();
        ring.dedup();
        ring
    }

    /// Puts an edge on the heap with the best place for it.
    fn offer(&mut self, i: u32, j: u32) {
        let held = |v: u32| self.fixed.get(v as usize).copied().unwrap_or(true);
        if held(i) || held(j) {
            return;
        }
        let (Some(p), Some(q)) = (self.quadrics.get(i as usize), self.quadrics.get(j as usize)) else {
            return;
        };
        let mut sum = *p;
        sum.add(q);
        let (a, b) = (self.point(i), self.point(j));
        let reach = (b - a).length();
        let middle = (a + b) * 0.5;
        let best = sum.best().filter(|x| (*x - middle).length() <= 2.0 * reach);
        let cost = |x: &Vector3| sum.at(*x);
        let found = best.into_iter().chain([middle, a, b]).min_by(|x, y| cost(x).total_cmp(&cost(y)));
        if let Some(place) = found {
            // A little for length, so that flat regions, where all costs nothing, lose their shortest edges first.
            let cost = sum.at(place) + LENGTH_COST * sum.weight * reach * reach;
            let ages = [self.age(i), self.age(j)];
            self.heap.push(Collapse { cost, ends: [i, j], place, ages });
        }
    }

    /// Pulls an edge together, if that is still possible and allowed.
    fn pull(&mut self, edge: &Collapse, max_error: f64) {
        let [i, j] = edge.ends;
        if edge.ages != [self.age(i), self.age(j)] {
            return;
        }
        let (Some(p), Some(q)) = (self.quadrics.get(i as usize), self.quadrics.get(j as usize)) else {
            return;
        };
        let mut sum = *p;
        sum.add(q);
        if sum.at(edge.place) > max_error * max_error * sum.weight {
            return;
        }
        let shared = self.fan(i).filter(|(_, t)| t.contains(&j)).count();
        let on_rim = |v: u32| self.rim.get(v as usize).copied().unwrap_or(false);
        // Two places of the rim may meet only along it, else the mesh would be pinched.
        if shared == 0 || shared > 2 || (on_rim(i) && on_rim(j) && shared != 1) {
            return;
        }
        // The places that both know must be the corners opposite to the edge (T. Dey and others, *Topology preserving
        // edge contraction*, 1999: the link condition).
        let (a, b) = (self.ring(i), self.ring(j));
        if a.iter().filter(|v| b.binary_search(v).is_ok()).count() != shared {
            return;
        }
        // A tetrahedron would fold to nothing.
        if a.len() <= 3 && b.len() <= 3 && shared == 2 {
            return;
        }
        for (v, other) in [(i, j), (j, i)] {
            for (_, t) in self.fan(v).filter(|(_, t)| !t.contains(&other)) {
                let old = t.map(|k| self.point(k));
                let new = t.map(|k| if k == v { edge.place } else { self.point(k) });
                let normal = |[a, b, c]: [Vector3; 3]| (b - a).cross(c - a);
                let (n, m) = (normal(old), normal(new));
                if !(m.dot(n) >= LEAST_TURN * m.length() * n.length()) || m.length_squared() == 0.0 {
                    return;
                }
            }
        }
        let rim = on_rim(i) || on_rim(j);
        let gone: Vec<(u32, [u32; 3])> = self.fan(j).collect();
        for (k, t) in gone {
            let Some(slot) = self.triangles.get_mut(k as usize) else { continue };
            if t.contains(&i) {
                *slot = None;
                self.left = self.left.saturating_sub(1);
            } else {
                *slot = Some(t.map(|v| if v == j { i } else { v }));
                if let Some(list) = self.around.get_mut(i as usize) {
                    list.push(k);
                }
            }
        }
        let at = i as usize;
        if let (Some(p), Some(q), Some(r)) =
            (self.points.get_mut(at), self.quadrics.get_mut(at), self.rim.get_mut(at))
        {
            (*p, *q, *r) = (edge.place, sum, rim);
        }
        for v in [at, j as usize] {
            if let Some(age) = self.ages.get_mut(v) {
                *age = age.wrapping_add(1);
            }
        }
        let live: Vec<u32> = self.fan(i).map(|(k, _)| k).collect();
        if let Some(list) = self.around.get_mut(at) {
            *list = live;
        }
        if let Some(list) = self.around.get_mut(j as usize) {
            *list = Vec::new();
        }
        for v in self.ring(i) {
            self.offer(i.min(v), i.max(v));
        }
    }

    fn finish(self, mesh: &Mesh) -> Result<Mesh> {
        let vertices: Vec<Point3> = self.points.iter().map(|p| (*p + self.center).to_point()).collect();
        let faces: Vec<MeshFace> = self.triangles.into_iter().flatten().map(MeshFace::Triangle).collect();
        let whole = Mesh::from_parts(vertices, Vec::new(), Vec::new(), mesh.colours.clone())?;
        Ok(whole.part(&faces)?.with_normals())
    }
}

#[cfg(test)]
mod tests {
    use super::Decimation;
    use crate::{Box3, Interval, Mesh, MeshFace, Plane, Point3, Rectangle};

    fn reduced(mesh: &Mesh, faces: usize, max_error: f64) -> Mesh {
        mesh.decimated(&Decimation { faces, max_error }, || true).unwrap()
    }

    #[test]
    fn flat_parts_cost_nothing() {
        let side = Interval::new(0.0, 4.0);
        let cube = Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 8, 8, 8).unwrap();
        let least = reduced(&cube, 12, 1e-6);
        assert_eq!((least.vertices().len(), least.faces().len()), (8, 12));
        assert!((least.volume() - 64.0).abs() < 1e-6, "{}", least.volume());
        assert!(least.is_closed() && least.is_oriented());
        let sheet = Mesh::plane(&Rectangle { plane: Plane::XY, x: side, y: side }, 9, 9).unwrap();
        let two = reduced(&sheet, 2, 1e-6);
        assert_eq!(two.faces().len(), 2);
        assert!((two.area() - 16.0).abs() < 1e-6);
    }

    #[test]
    fn a_ball_stays_a_ball() {
        let ball = Mesh::sphere(&Plane::XY, 1.0, 48, 32).unwrap();
        let small = reduced(&ball, 400, f64::INFINITY);
        assert!(small.faces().len() <= 400 && small.faces().len() >= 390);
        assert!(small.is_closed() && small.is_oriented() && small.is_manifold());
        assert!((small.volume() - ball.volume()).abs() < 0.02 * ball.volume());
        assert!(small.vertices().iter().all(|p| (p.to_vector().length() - 1.0).abs() < 0.03));
        // It does not fold up, however few faces are asked for, and an error of nothing changes nothing.
        let last = reduced(&ball, 0, f64::INFINITY);
        assert!(last.is_closed() && last.faces().len() >= 4);
        assert!(reduced(&ball, 0, 1e-9).faces().len() > 2000);
        assert!(ball.decimated(&Decimation { faces: 1, max_error: f64::NAN }, || true).is_err());
    }

    #[test]
    fn odd_meshes() {
        assert_eq!(reduced(&Mesh::default(), 0, 1.0).faces().len(), 0);
        // Three faces along one edge stay as they are.
        let points = [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, -1.0, 0.0]];
        let faces =
            (2..5).map(|k| MeshFace::Triangle([0, 1, k])).chain([MeshFace::Triangle([0, 0, 1])]).collect();
        let fan = Mesh::new(points.map(Point3::from).to_vec(), faces).unwrap();
        assert_eq!(reduced(&fan, 0, 10.0).faces().len(), 3);
    }
}
