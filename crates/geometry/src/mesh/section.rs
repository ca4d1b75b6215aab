//! Sections of meshes by planes.

use crate::mesh::thresholds::{ALONG_SECTION, LEVEL_SECTION};
use std::collections::{HashMap, HashSet};

use super::{Mesh, MeshFace};
use crate::{Error, Plane, Point3, Result, Vector3};

/// A point of a section: a vertex (twice the same index), or the crossing with the edge between two vertices.
type Node = (u32, u32);

impl Mesh {
    /// The curves in which a plane cuts the mesh, as chains of points; closed ones repeat their first point as their
    /// last. Seen against the plane's normal, a chain has what the faces look away from on its left: the outline of a
    /// solid runs counter-clockwise, that of a hollow in it clockwise.
    ///
    /// Vertices within 10⁻¹⁰ of the mesh's size of the plane count as in it, so that all faces around agree. Where edges
    /// or faces lie in the plane, the section is that just above the plane, moved into it: outlines of level bottoms
    /// are part of it. Curves of the section just below that share no piece with those come next: outlines of level tops, and
    /// both outlines at a step. Last come outlines of level parts of open meshes. Where the mesh only touches the plane,
    /// along a ridge or in a point, there is nothing. The section of a closed mesh consists of closed curves (sections
    /// above and below a plane are such, and vertices moved into the plane leave an even number of pieces at each).
    /// Vertices in exactly the same place count as one. Where a quad is cut along its diagonal a point that would lie on a
    /// straight line is left out.
    ///
    /// # Errors
    /// The plane is not finite.
    pub fn section(&self, plane: &Plane) -> Result<Vec<Vec<Point3>>> {
        if !plane.is_finite() {
            return Err(Error::NotFinite("plane"));
        }
        Ok(self.section_of(self.faces(), &self.merged_indices(), snap(self), plane))
    }

    /// The section of some faces, which are all that the plane may cut.
    pub(super) fn section_of<'f>(
        &self,
        faces: impl IntoIterator<Item = &'f MeshFace>,
        merged: &[u32],
        snap: f64,
        plane: &Plane,
    ) -> Vec<Vec<Point3>> {
        Section::new(self, faces, merged, snap, plane).curves(plane)
    }
}

/// Vertices nearer to a plane than this count as in it.
pub(super) fn snap(mesh: &Mesh) -> f64 {
    LEVEL_SECTION * mesh.bounding_box().map_or(0.0, |b| b.diagonal().length())
}

/// How the faces along an edge in the plane stand: how many above it, below it, and level.
#[derive(Debug, Clone, Copy)]
struct Flat {
    above: u32,
    below: u32,
    level: u32,
    /// The normal of a face there, of one that is not level if there is one.
    normal: Vector3,
}

struct Section<'a> {
    mesh: &'a Mesh,
    plane: &'a Plane,
    snap: f64,
    /// Faces cut through: for each segment how much more often it is walked up than down its nodes' order.
    through: HashMap<[Node; 2], i32>,
    flat: HashMap<Node, Flat>,
    diagonals: HashSet<Node>,
}

fn ordered(a: u32, b: u32) -> Node {
    (a.min(b), a.max(b))
}

impl<'a> Section<'a> {
    fn new<'f>(
        mesh: &'a Mesh,
        faces: impl IntoIterator<Item = &'f MeshFace>,
        merged: &[u32],
        snap: f64,
        plane: &'a Plane,
    ) -> Self {
        let (through, flat, diagonals) = (HashMap::new(), HashMap::new(), HashSet::new());
        let mut this = Self { mesh, plane, snap, through, flat, diagonals };
        for face in faces {
            let corners = face.indices();
            let above = corners.iter().any(|&i| this.height(i) >= 0.0);
            let below = corners.iter().any(|&i| this.height(i) <= 0.0);
            if !(above && below) {
                continue;
            }
            let merge = |i: u32| merged.get(i as usize).copied().unwrap_or(i);
            if let &[a, _, c, _] = corners {
                this.diagonals.insert(ordered(merge(a), merge(c)));
            }
            for triangle in face.triangles() {
                this.cut(triangle.map(merge), plane);
            }
        }
        this
    }

    /// All curves: those just above the plane, then those below and around level faces that are not among them.
    fn curves(&self, plane: &Plane) -> Vec<Vec<Point3>> {
        let mut through: Vec<[Node; 2]> = self
            .through
            .iter()
            .filter(|(_, n)| **n != 0)
            .map(|([p, q], n)| if *n > 0 { [*p, *q] } else { [*q, *p] })
            .collect();
        let mut flat: Vec<(Node, Flat)> = self.flat.iter().map(|(e, f)| (*e, *f)).collect();
        // In the order of indices, so that the answer does not depend on hashing.
        through.sort_unstable();
        flat.sort_unstable_by_key(|f| f.0);
        let counts: [fn(&Flat) -> u32; 3] = [|f| f.above, |f| f.below, |f| f.level];
        let mut given: HashSet<[Node; 2]> = HashSet::new();
        let mut out = Vec::new();
        for (k, count) in counts.into_iter().enumerate() {
            let mut segments = if k < 2 { through.clone() } else { Vec::new() };
            for ((a, b), f) in flat.iter().filter(|(_, f)| count(f) % 2 == 1) {
                segments.push(self.directed([(*a, *a), (*b, *b)], f.normal, plane));
            }
            let pair = |w: &[Node]| if w[0] < w[1] { [w[0], w[1]] } else { [w[1], w[0]] };
            for chain in chains(&segments, |n| self.point(n)) {
                if k == 0 || !chain.windows(2).any(|w| given.contains(&pair(w))) {
                    out.push(self.points_of(&chain));
                    given.extend(chain.windows(2).map(pair));
                }
            }
        }
        out
    }

    fn height(&self, i: u32) -> f64 {
        let height = self.mesh.vertices().get(i as usize).map_or(0.0, |p| self.plane.signed_distance(*p));
        if height.abs() <= self.snap { 0.0 } else { height }
    }

    fn vertex(&self, i: u32) -> Point3 {
        self.mesh.vertices().get(i as usize).copied().unwrap_or(Point3::ORIGIN)
    }

    fn point(&self, (a, b): Node) -> Point3 {
        let (p, q) = (self.vertex(a), self.vertex(b));
        if a == b {
            return p;
        }
        let (h, k) = (self.height(a), self.height(b));
        p.lerp(q, h / (h - k))
    }

    /// A segment turned so that the solid behind a face with that normal is on its left.
    fn directed(&self, [p, q]: [Node; 2], normal: Vector3, plane: &Plane) -> [Node; 2] {
        let along = plane.z_axis.cross(normal);
        if (self.point(q) - self.point(p)).dot(along) >= 0.0 { [p, q] } else { [q, p] }
    }

    fn cut(&mut self, corners: [u32; 3], plane: &Plane) {
        let [a, b, c] = corners;
        if a == b || b == c || c == a {
            return;
        }
        let h = corners.map(|i| self.height(i));
        let normal = (self.vertex(b) - self.vertex(a)).cross(self.vertex(c) - self.vertex(a));
        if h.iter().filter(|h| **h == 0.0).count() >= 2 {
            for k in 0..3 {
                let (i, j, other) = (k, (k + 1) % 3, (k + 2) % 3);
                if h[i] == 0.0 && h[j] == 0.0 {
                    let nothing = Flat { above: 0, below: 0, level: 0, normal };
                    let edge = self.flat.entry(ordered(corners[i], corners[j])).or_insert(nothing);
                    edge.above += u32::from(h[other] > 0.0);
                    edge.below += u32::from(h[other] < 0.0);
                    edge.level += u32::from(h[other] == 0.0);
                    // A level face has no side to look to in the plane.
                    if h[other] != 0.0 {
                        edge.normal = normal;
                    }
                }
            }
            return;
        }
        let mut ends: Vec<Node> = Vec::with_capacity(2);
        for k in 0..3 {
            let (i, j) = (k, (k + 1) % 3);
            if h[i] == 0.0 {
                ends.push((corners[i], corners[i]));
            } else if h[i] * h[j] < 0.0 {
                ends.push(ordered(corners[i], corners[j]));
            }
        }
        let &[p, q] = ends.as_slice() else { return };
        // Two faces on one another that look away from each other are nothing; others count once.
        let [p, q] = self.directed([p, q], normal, plane);
        let (pair, sign) = if p < q { ([p, q], 1) } else { ([q, p], -1) };
        *self.through.entry(pair).or_insert(0) += sign;
    }

    /// The points of a chain, without those where a diagonal is crossed in a straight line.
    fn points_of(&self, chain: &[Node]) -> Vec<Point3> {
        let n = chain.len();
        let closed = n > 3 && chain.first() == chain.last();
        let straight = |before: Point3, p: Point3, after: Point3| {
            let along = after - before;
            let reach = along.length();
            (p - before).cross(along).length() <= ALONG_SECTION * reach * reach
                && (p - before).dot(after - p) >= 0.0
        };
        let mut out: Vec<Point3> = Vec::with_capacity(n);
        for (i, node) in chain.iter().enumerate() {
            let p = self.point(*node);
            let inner = i > 0 && i + 1 < n;
            if inner && node.0 != node.1 && self.diagonals.contains(node) {
                let before = out.last().copied().unwrap_or(p);
                if straight(before, p, self.point(chain[i + 1])) {
                    continue;
                }
            }
            out.push(p);
        }
        // The chain may have started on a diagonal.
        if closed && out.len() > 4 && chain[0].0 != chain[0].1 && self.diagonals.contains(&chain[0]) {
            let m = out.len();
            if straight(out[m - 2], out[0], out[1]) {
                out.pop();
                out.remove(0);
                out.extend(out.first().copied());
            }
        }
        out
    }
}

/// Directed segments put together: open chains first, from their loose ends, then what is left runs round.
fn chains(segments: &[[Node; 2]], point: impl Fn(Node) -> Point3) -> Vec<Vec<Node>> {
    let mut around: HashMap<Node, Vec<usize>> = HashMap::with_capacity(segments.len());
    for (i, [p, q]) in segments.iter().enumerate() {
        around.entry(*p).or_default().push(i);
        around.entry(*q).or_default().push(i);
    }
    let degree = |n: &Node| around.get(n).map_or(0, Vec::len);
    let is_loose = |i: &usize| segments[*i].iter().any(|n| degree(n) % 2 == 1);
    let order: Vec<usize> = (0..segments.len()).filter(is_loose).chain(0..segments.len()).collect();
    let mut used = vec![false; segments.len()];
    let mut out = Vec::new();
    for first in order {
        if used[first] {
            continue;
        }
        let [p, q] = segments[first];
        let backwards = degree(&p) % 2 == 0 && degree(&q) % 2 == 1;
        let start = if backwards { q } else { p };
        let mut chain = vec![start];
        let mut against = 0_usize;
        let mut here = start;
        // A segment that leads on in its own direction comes first;
        // where two do, the straighter one.
        let next = |here: Node, before: Option<Node>, used: &[bool]| -> Option<usize> {
            let free = || around.get(&here).into_iter().flatten().copied().filter(|&i| !used[i]);
            let mut along = free().filter(|&i| segments[i][usize::from(backwards)] == here);
            match (along.next(), along.next(), before) {
                (None, ..) => free().next(),
                (Some(only), None, _) | (Some(only), _, None) => Some(only),
                (Some(a), Some(b), Some(before)) => {
                    let came = point(here) - point(before);
                    let straight = |i: usize| {
                        let [p, q] = segments[i];
                        let to = if p == here { q } else { p };
                        came.unitized()
                            .zip((point(to) - point(here)).unitized())
                            .map_or(0.0, |(u, v)| u.dot(v))
                    };
                    [a, b].into_iter().max_by(|&i, &j| straight(i).total_cmp(&straight(j)))
                }
            }
        };
        while let Some(i) = next(here, chain.len().checked_sub(2).and_then(|k| chain.get(k).copied()), &used)
        {
            used[i] = true;
            let [p, q] = segments[i];
            against += usize::from(p != here);
            here = if p == here { q } else { p };
            chain.push(here);
            if here == start {
                break;
            }
        }
        if 2 * against > chain.len() - 1 {
            chain.reverse();
        }
        out.push(chain);
    }
    out
}

#[cfg(test)]
mod tests {
    use crate::{Box3, Interval, Mesh, MeshFace, Plane, Point3, Vector3};

    fn area(loops: &[Vec<Point3>], plane: &Plane) -> f64 {
        loops
            .iter()
            .map(|l| {
                let v: Vec<[f64; 3]> = l.iter().map(|p| plane.coordinates(*p)).collect();
                0.5 * v.windows(2).map(|w| w[0][0] * w[1][1] - w[1][0] * w[0][1]).sum::<f64>()
            })
            .sum()
    }

    fn cuboid(x: f64, y: f64, z: f64, n: usize) -> Mesh {
        let side = |s| Interval::new(0.0, s);
        Mesh::cuboid(&Box3 { plane: Plane::XY, x: side(x), y: side(y), z: side(z) }, n, n, n).unwrap()
    }

    fn level(z: f64) -> Plane {
        Plane::XY.offset(z)
    }

    #[test]
    fn boxes_have_rectangles() {
        let mesh = cuboid(3.0, 2.0, 4.0, 4);
        // Between rows of vertices, through a row, and through the bottom and the top, which lie in the plane.
        for z in [0.3, 1.0, 2.0, 0.0, 4.0] {
            let loops = mesh.section(&level(z)).unwrap();
            assert_eq!(loops.len(), 1, "{z}");
            assert_eq!(loops[0].first(), loops[0].last());
            assert!((area(&loops, &level(z)) - 6.0).abs() < 1e-12, "{z} {}", area(&loops, &level(z)));
        }
        assert!(mesh.section(&level(4.1)).unwrap().is_empty());
        // Diagonals of quads leave no points on straight sides: 4 sides of 4 faces.
        assert_eq!(mesh.section(&level(0.3)).unwrap()[0].len(), 17);
        assert!(mesh.section(&Plane { origin: Point3::new(f64::NAN, 0.0, 0.0), ..Plane::XY }).is_err());
        // Along an edge only: a ridge is touched.
        let ridge = Plane::from_normal(Point3::ORIGIN, Vector3::new(1.0, 0.0, 1.0)).unwrap();
        assert!(mesh.section(&ridge).unwrap().is_empty());
    }

    #[test]
    fn hollows_count_against() {
        let outer = cuboid(4.0, 4.0, 4.0, 2);
        let inner = cuboid(2.0, 2.0, 2.0, 3).flipped();
        let shift = crate::Xform::translation(Vector3::new(1.0, 1.0, 1.0));
        let both = Mesh::join(&[outer, inner.transformed(&shift).unwrap()]).unwrap();
        let loops = both.section(&level(1.7)).unwrap();
        assert_eq!(loops.len(), 2);
        assert!((area(&loops, &level(1.7)) - 12.0).abs() < 1e-12);
    }

    #[test]
    fn sections_add_up_to_the_volume() {
        let mut mesh = Mesh::sphere(&Plane::XY, 1.0, 24, 16).unwrap();
        // Bumps, so that there are hollows and several loops.
        let moved: Vec<Point3> = mesh
            .vertices()
            .iter()
            .map(|p| {
                let v = p.to_vector();
                let bump = 1.0 + 0.4 * (5.0 * p.x + 1.0).sin() * (4.0 * p.y).cos() * (6.0 * p.z).sin();
                (v * bump).to_point()
            })
            .collect();
        mesh = Mesh::new(moved, mesh.faces().to_vec()).unwrap();
        for direction in [Vector3::Z, Vector3::new(1.0, 2.0, -0.5), Vector3::new(0.3, -1.0, 0.1)] {
            let n = 2000;
            let reach = 2.0;
            let mut volume = 0.0;
            for k in 0..n {
                let h = -reach + 2.0 * reach * (f64::from(k) + 0.5) / f64::from(n);
                let plane = Plane::from_normal(Point3::ORIGIN, direction).unwrap().offset(h);
                let loops = mesh.section(&plane).unwrap();
                assert!(loops.iter().all(|l| l.len() > 3 && l.first() == l.last()));
                volume += area(&loops, &plane) * 2.0 * reach / f64::from(n);
            }
            let want = mesh.volume();
            assert!((volume - want).abs() < 1e-3 * want.abs(), "{volume} {want}");
        }
    }

    #[test]
    fn planes_through_vertices() {
        // Vertices on integer places only: every plane of these goes through many.
        let ball = Mesh::sphere(&Plane::XY, 5.0, 12, 8).unwrap();
        let grid: Vec<Point3> =
            ball.vertices().iter().map(|p| Point3::new(p.x.round(), p.y.round(), p.z.round())).collect();
        let mesh = Mesh::new(grid, ball.faces().to_vec()).unwrap();
        assert!(mesh.is_closed());
        for direction in
            [Vector3::X, Vector3::Y, Vector3::Z, Vector3::new(1.0, 1.0, 0.0), Vector3::new(1.0, 1.0, 1.0)]
        {
            for k in -6..=6 {
                let p = (direction * (f64::from(k) / direction.length_squared())).to_point();
                let plane = Plane::from_normal(p, direction).unwrap();
                for l in mesh.section(&plane).unwrap() {
                    assert!(l.len() > 2 && l.first() == l.last(), "{direction:?} {k} {l:?}");
                }
            }
        }
    }

    #[test]
    fn steps_and_level_meshes() {
        // A tower on a slab: just above the plane the tower, just below the slab.
        let slab = cuboid(4.0, 4.0, 1.0, 1);
        let shift = crate::Xform::translation(Vector3::new(1.0, 1.0, 1.0));
        let tower = cuboid(2.0, 2.0, 1.0, 1).transformed(&shift).unwrap();
        let both = Mesh::join(&[slab, tower]).unwrap();
        let loops = both.section(&level(1.0)).unwrap();
        let areas: Vec<f64> = loops.iter().map(|l| area(std::slice::from_ref(l), &level(1.0))).collect();
        assert_eq!(areas, [4.0, 16.0]);
        let flat = Mesh::plane(
            &crate::Rectangle { plane: Plane::XY, x: Interval::new(0.0, 3.0), y: Interval::new(0.0, 2.0) },
            3,
            2,
        );
        let outline = flat.unwrap().section(&level(0.0)).unwrap();
        assert_eq!(outline.len(), 1);
        assert!((area(&outline, &level(0.0)).abs() - 6.0).abs() < 1e-12);
    }

    #[test]
    fn open_meshes_have_open_sections() {
        let p = |x: f64, z: f64| Point3::new(x, 0.0, z);
        let wall = Mesh::new(
            vec![p(0.0, 0.0), p(1.0, 0.0), p(2.0, 0.0), p(0.0, 1.0), p(1.0, 1.0), p(2.0, 1.0)],
            vec![MeshFace::Quad([0, 1, 4, 3]), MeshFace::Quad([1, 2, 5, 4])],
        );
        let wall = wall.unwrap();
        let cut = wall.section(&level(0.5)).unwrap();
        assert_eq!(cut, [vec![p(0.0, 0.5), p(1.0, 0.5), p(2.0, 0.5)]]);
        // Its lower border lies in the plane.
        assert_eq!(wall.section(&level(0.0)).unwrap(), [vec![p(0.0, 0.0), p(1.0, 0.0), p(2.0, 0.0)]]);
    }
}
