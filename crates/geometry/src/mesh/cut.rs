//! Meshes cut along segments that lie on them.

use crate::mesh::thresholds::{EDGE_MARGIN, VANISHING};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::ControlFlow;

use spade::{ConstrainedDelaunayTriangulation, HasPosition, Triangulation};

use super::{Mesh, MeshFace};
use crate::box_tree::{BoxTree, bounds_of, boxes_meet};
use crate::{Error, Line, Point3, Result, Vector3};

/// The most points that cuts may add, in all.
const MOST: usize = 4_000_000;

/// A point of a triangle that is divided anew.
struct Site {
    position: spade::Point2<f64>,
    id: usize,
}

impl HasPosition for Site {
    type Scalar = f64;

    fn position(&self) -> spade::Point2<f64> {
        self.position
    }
}

/// Points, those within a distance of one another being one.
struct Places {
    points: Vec<Point3>,
    cell: f64,
    cells: HashMap<[i64; 3], Vec<usize>>,
}

impl Places {
    #[expect(clippy::cast_possible_truncation, reason = "places far out share the cells at the end")]
    fn cell_of(&self, p: Point3) -> [i64; 3] {
        [p.x, p.y, p.z].map(|x| ((x / self.cell).floor() as i64).clamp(-(1 << 60), 1 << 60))
    }

    /// The number of the point that is nearest within the distance, or of a new one.
    fn id_of(&mut self, p: Point3) -> usize {
        let [x, y, z] = self.cell_of(p);
        let mut best: Option<(f64, usize)> = None;
        for (a, b, c) in (0..27).map(|k| (k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1)) {
            for &id in self.cells.get(&[x + a, y + b, z + c]).into_iter().flatten() {
                let off = self.points[id].distance_to(p);
                if off <= self.cell && best.is_none_or(|best| off < best.0) {
                    best = Some((off, id));
                }
            }
        }
        best.map_or_else(|| self.add(p), |best| best.1)
    }

    fn add(&mut self, p: Point3) -> usize {
        let cell = self.cell_of(p);
        self.points.push(p);
        self.cells.entry(cell).or_default().push(self.points.len() - 1);
        self.points.len() - 1
    }
}

fn key(a: usize, b: usize) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

impl Mesh {
    /// The parts into which segments cut a mesh, as far as they lie on it within the tolerance: faces are divided along
    /// them (constrained Delaunay triangulations of the triangles that they cross), and what hangs together without
    /// crossing one is a part. A quad that is crossed counts as two triangles, and vertices in one place are one.
    /// Segments that part nothing leave the faces divided.
    ///
    /// # Errors
    /// A tolerance that is not above 0, or too many segments across one another; `go_on` said no.
    pub fn cut_along(
        &self,
        segments: &[Line],
        tolerance: f64,
        mut go_on: impl FnMut() -> bool,
    ) -> Result<Vec<Self>> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(Error::OutOfRange { what: "tolerance", value: tolerance, must: "above 0" });
        }
        let merged = self.merged_indices();
        let mut places = Places { points: Vec::new(), cell: tolerance, cells: HashMap::new() };
        // Vertices keep their own numbers, however near to one another they are.
        let mut own = vec![0; merged.len()];
        for (i, first) in merged.iter().enumerate() {
            let first = *first as usize;
            own[i] = if first == i { places.add(self.vertices()[i]) } else { own[first] };
        }
        let triangles: Vec<(usize, [usize; 3])> = (self.faces().iter().enumerate())
            .flat_map(|(f, face)| face.triangles().map(move |t| (f, t)))
            .map(|(f, t)| (f, t.map(|i| own[i as usize])))
            .collect();
        let boxes = segments.iter().map(|s| bounds_of([s.from.into(), s.to.into()]));
        let tree = BoxTree::by_place(&boxes.collect::<Vec<_>>());
        let mut cuts: Vec<Vec<[usize; 2]>> = vec![Vec::new(); triangles.len()];
        let mut on_edges: BTreeMap<[usize; 2], BTreeSet<usize>> = BTreeMap::new();
        for (t, (_, corners)) in triangles.iter().enumerate() {
            if t % 1024 == 0 && !go_on() {
                return Err(Error::Stopped);
            }
            let at = corners.map(|i| places.points[i]);
            let bounds = bounds_of(at.map(Into::into));
            let mut found = Vec::new();
            tree.visit_where(
                |own| boxes_meet(own, &bounds, tolerance),
                |s| {
                    found.extend(clipped(&segments[s], &at, tolerance));
                    ControlFlow::Continue(())
                },
            );
            for [a, b] in found {
                let ends = [a, b].map(|p| places.id_of(snapped(p, &at, tolerance)));
                if ends[0] != ends[1] {
                    cuts[t].push(ends);
                }
            }
            if places.points.len() > MOST + self.vertices().len() {
                return Err(Error::OutOfRange {
                    what: "points of cuts",
                    value: places.points.len() as f64,
                    must: "at most 4,000,000",
                });
            }
            for k in 0..3 {
                let (a, b) = (corners[k], corners[(k + 1) % 3]);
                let (p, way) = (at[k], at[(k + 1) % 3] - at[k]);
                for id in cuts[t].iter().flatten().copied().filter(|id| !corners.contains(id)) {
                    let q = places.points[id];
                    let share = (q - p).dot(way) / way.length_squared();
                    if share > 0.0 && share < 1.0 && q.distance_to(p + way * share) <= tolerance {
                        on_edges.entry(key(a, b)).or_default().insert(id);
                    }
                }
            }
        }
        let mut walls: BTreeSet<[usize; 2]> = BTreeSet::new();
        let mut faces: Vec<Vec<usize>> = Vec::new();
        let mut t = 0;
        while let Some(&(f, _)) = triangles.get(t) {
            if t % 1024 < 2 && !go_on() {
                return Err(Error::Stopped);
            }
            // The triangles of one face; a quad that is none has fewer than two.
            let count = triangles[t..].iter().take_while(|(own, _)| *own == f).count();
            let touched = (t..t + count).any(|t| {
                let (_, c) = triangles[t];
                !cuts[t].is_empty() || (0..3).any(|k| on_edges.contains_key(&key(c[k], c[(k + 1) % 3])))
            });
            if touched {
                for t in t..t + count {
                    divided(&places, triangles[t].1, &cuts[t], &on_edges, &mut walls, &mut faces)?;
                }
            } else {
                faces.push(self.faces()[f].indices().iter().map(|i| own[*i as usize]).collect());
            }
            t += count;
        }
        parted(&places.points, &faces, &walls, !self.normals().is_empty())
    }
}

/// The part of a segment over a triangle, where it is within the tolerance of its plane.
fn clipped(segment: &Line, [a, b, c]: &[Point3; 3], tolerance: f64) -> Option<[Point3; 2]> {
    let normal = (*b - *a).cross(*c - *a).unitized()?;
    let way = segment.to - segment.from;
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    // Keeps where a height over a plane is at least some value, it being linear along the segment.
    let mut keep = |start: f64, end: f64, least: f64| {
        let (s, e) = (start - least, end - least);
        if s < 0.0 && e < 0.0 {
            high = -1.0;
        } else if s < 0.0 {
            low = low.max(s / (s - e));
        } else if e < 0.0 {
            high = high.min(s / (s - e));
        }
    };
    let height = |p: Point3| normal.dot(p - *a);
    let (h, k) = (height(segment.from), height(segment.to));
    keep(h, k, -tolerance);
    keep(-h, -k, -tolerance);
    for (p, q) in [(a, b), (b, c), (c, a)] {
        let inward = normal.cross(*q - *p).unitized()?;
        keep(inward.dot(segment.from - *p), inward.dot(segment.to - *p), -EDGE_MARGIN * tolerance);
    }
    if high - low <= 0.0 || (high - low) * way.length() <= tolerance {
        return None;
    }
    let at = |t: f64| {
        let p = if t == 0.0 {
            segment.from
        } else if t == 1.0 {
            segment.to
        } else {
            segment.from + way * t
        };
        p - normal * height(p)
    };
    Some([at(low), at(high)])
}

/// A point moved to a corner or a side of a triangle that it is near.
fn snapped(p: Point3, at: &[Point3; 3], tolerance: f64) -> Point3 {
    if let Some(corner) = at.iter().find(|corner| corner.distance_to(p) <= tolerance) {
        return *corner;
    }
    for k in 0..3 {
        let (a, way) = (at[k], at[(k + 1) % 3] - at[k]);
        let foot = a + way * ((p - a).dot(way) / way.length_squared()).clamp(0.0, 1.0);
        if foot.distance_to(p) <= tolerance {
            return foot;
        }
    }
    p
}

/// Divides a triangle along its cuts and at the points on its sides.
fn divided(
    places: &Places,
    corners: [usize; 3],
    cuts: &[[usize; 2]],
    on_edges: &BTreeMap<[usize; 2], BTreeSet<usize>>,
    walls: &mut BTreeSet<[usize; 2]>,
    faces: &mut Vec<Vec<usize>>,
) -> Result<()> {
    let [a, b, c] = corners.map(|i| places.points[i]);
    let broken = || Error::degenerate("cut", "a face cannot be divided");
    let frame = ((b - a).unitized(), (b - a).cross(c - a).unitized());
    let (Some(x), Some(normal)) = frame else {
        // Nothing lies in a face without area.
        faces.push(corners.to_vec());
        return Ok(());
    };
    let (y, size) = (normal.cross(x), (b - a).length().max((c - a).length()));
    let flat = |id: usize| {
        let way: Vector3 = places.points[id] - a;
        let settled = |v: f64| if v.abs() < VANISHING { 0.0 } else { v };
        spade::Point2::new(settled(way.dot(x) / size), settled(way.dot(y) / size))
    };
    let mut sides: Vec<BTreeSet<usize>> = Vec::with_capacity(3);
    let mut ids: BTreeSet<usize> = corners.iter().copied().chain(cuts.iter().flatten().copied()).collect();
    for k in 0..3 {
        let mut side: BTreeSet<usize> =
            on_edges.get(&key(corners[k], corners[(k + 1) % 3])).cloned().unwrap_or_default();
        side.extend([corners[k], corners[(k + 1) % 3]]);
        ids.extend(&side);
        sides.push(side);
    }
    let mut net: ConstrainedDelaunayTriangulation<Site> = ConstrainedDelaunayTriangulation::new();
    let mut handles = HashMap::new();
    for &id in &ids {
        let handle = net.insert(Site { position: flat(id), id }).map_err(|_| broken())?;
        handles.insert(id, handle);
    }
    for [from, to] in cuts {
        let (Some(&from), Some(&to)) = (handles.get(from), handles.get(to)) else { continue };
        if from != to && net.can_add_constraint(from, to) {
            net.add_constraint(from, to);
        } else if from != to {
            return Err(Error::degenerate("cut", "segments cross one another within a face"));
        }
    }
    for edge in net.undirected_edges().filter(|edge| edge.is_constraint_edge()) {
        let [p, q] = edge.vertices().map(|v| v.data().id);
        walls.insert(key(p, q));
    }
    for face in net.inner_faces() {
        let ring = face.vertices().map(|v| v.data().id);
        // What lies between a side and points that are on it but for rounding is nothing.
        if !sides.iter().any(|side| ring.iter().all(|id| side.contains(id))) {
            faces.push(ring.to_vec());
        }
    }
    Ok(())
}

/// Faces as meshes of those that hang together by edges that are no walls.
fn parted(
    points: &[Point3],
    faces: &[Vec<usize>],
    walls: &BTreeSet<[usize; 2]>,
    normals: bool,
) -> Result<Vec<Mesh>> {
    let mut group: Vec<usize> = (0..faces.len()).collect();
    let root = |group: &mut Vec<usize>, mut at: usize| {
        while group[at] != at {
            group[at] = group[group[at]];
            at = group[at];
        }
        at
    };
    let mut first: HashMap<[usize; 2], usize> = HashMap::new();
    for (f, ring) in faces.iter().enumerate() {
        for (k, &p) in ring.iter().enumerate() {
            let side = key(p, ring[(k + 1) % ring.len()]);
            if walls.contains(&side) {
                continue;
            }
            let other = *first.entry(side).or_insert(f);
            let (a, b) = (root(&mut group, f), root(&mut group, other));
            group[a.max(b)] = a.min(b);
        }
    }
    let mut parts: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for f in 0..faces.len() {
        parts.entry(root(&mut group, f)).or_default().push(f);
    }
    let too_many = || Error::degenerate("cut", "there are too many points");
    let part = |list: Vec<usize>| {
        let mut numbers: HashMap<usize, u32> = HashMap::new();
        let (mut vertices, mut made) = (Vec::new(), Vec::with_capacity(list.len()));
        for f in list {
            let mut corners = Vec::with_capacity(4);
            for &id in &faces[f] {
                let next = u32::try_from(vertices.len()).map_err(|_| too_many())?;
                let number = *numbers.entry(id).or_insert(next);
                if number == next {
                    vertices.push(points[id]);
                }
                corners.push(number);
            }
            match *corners.as_slice() {
                [a, b, c] => made.push(MeshFace::Triangle([a, b, c])),
                [a, b, c, d] => made.push(MeshFace::Quad([a, b, c, d])),
                _ => {}
            }
        }
        let mesh = Mesh::new(vertices, made)?;
        Ok(if normals { mesh.with_normals() } else { mesh })
    };
    parts.into_values().map(part).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::intersect::mesh_mesh;
    use crate::{BoundingBox, Box3, Interval, MeshTree, Plane, Rectangle};

    fn cube(at: [f64; 3], n: usize) -> Mesh {
        let min = Point3::from(at);
        let bounds = BoundingBox { min, max: min + Vector3::new(2.0, 2.0, 2.0) };
        Mesh::cuboid(&Box3::from(bounds), n, n, n).unwrap()
    }

    fn lines(chains: &[Vec<Point3>]) -> Vec<Line> {
        chains.iter().flat_map(|c| c.windows(2).map(|w| Line::new(w[0], w[1]))).collect()
    }

    fn areas(parts: &[Mesh]) -> Vec<f64> {
        let mut areas: Vec<f64> = parts.iter().map(Mesh::area).collect();
        areas.sort_by(f64::total_cmp);
        areas
    }

    fn cut(mesh: &Mesh, by: &Mesh) -> Vec<Mesh> {
        let found = mesh_mesh(&MeshTree::new(mesh), &MeshTree::new(by), 1e-7).unwrap();
        mesh.cut_along(&lines(&found), 1e-7, || true).unwrap()
    }

    #[test]
    fn boxes_through_each_other() {
        for n in [1, 3] {
            let parts = cut(&cube([0.0; 3], n), &cube([1.1, 1.2, 1.3], 2));
            // Three rectangles of the corner inside: 0.9 by 0.8 by 0.7.
            let inner = 0.9 * 0.8 + 0.8 * 0.7 + 0.7 * 0.9;
            let found = areas(&parts);
            assert_eq!(found.len(), 2, "{found:?}");
            assert!((found[0] - inner).abs() < 1e-9 && (found[1] - 24.0 + inner).abs() < 1e-9, "{found:?}");
            // One border each, and no gaps beside it.
            for part in &parts {
                assert_eq!(part.holes().len(), 1);
                assert!(part.is_oriented());
            }
        }
    }

    #[test]
    fn balls_are_cut_by_sheets_and_balls() {
        let ball = Mesh::sphere(&Plane::XY, 2.0, 40, 20).unwrap();
        let wide = Interval::new(-5.0, 5.0);
        let frame = Plane::from_normal(Point3::new(0.1, 0.2, 0.3), Vector3::new(1.0, 2.0, 3.0)).unwrap();
        let sheet = Mesh::plane(&Rectangle { plane: frame, x: wide, y: wide }, 7, 5).unwrap();
        let parts = cut(&ball, &sheet);
        assert_eq!(parts.len(), 2);
        assert!((areas(&parts).iter().sum::<f64>() - ball.area()).abs() < 1e-6);
        let halves = ball.split_by_plane(&frame, 0.0).unwrap();
        let (found, wanted) = (areas(&parts), areas(&halves));
        assert!(found.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-6), "{found:?} {wanted:?}");
        // The sheet itself: a disc and what is around.
        let parts = cut(&sheet, &ball);
        assert_eq!(parts.len(), 2);
        assert!((areas(&parts).iter().sum::<f64>() - 100.0).abs() < 1e-6);
        assert!(parts.iter().all(|part| part.holes().len() <= 2 && part.is_manifold()));
        let other = Mesh::sphere(&Plane::XY.with_origin(Point3::new(1.3, 0.4, 0.2)), 1.7, 30, 17).unwrap();
        let parts = cut(&ball, &other);
        assert_eq!(parts.len(), 2);
        assert!(parts.iter().all(|part| part.holes().len() == 1));
    }

    #[test]
    fn sheets_are_cut_along_lines() {
        let side = Interval::new(0.0, 3.0);
        let sheet = Mesh::plane(&Rectangle { plane: Plane::XY, x: side, y: side }, 3, 3).unwrap();
        let p = |x: f64, y: f64| Point3::new(x, y, 0.0);
        // Along the edges of faces, and across them.
        let parts = sheet.cut_along(&[Line::new(p(1.0, -1.0), p(1.0, 4.0))], 1e-6, || true).unwrap();
        assert_eq!(areas(&parts).iter().map(|a| a.round()).collect::<Vec<_>>(), [3.0, 6.0]);
        let ring = [p(0.5, 0.4), p(2.6, 0.7), p(1.2, 2.5), p(0.5, 0.4)];
        let ring: Vec<Line> = ring.windows(2).map(|w| Line::new(w[0], w[1])).collect();
        let parts = sheet.cut_along(&ring, 1e-6, || true).unwrap();
        let inner = 0.5 * (2.1_f64 * 2.1 - 0.3 * 0.7);
        let found = areas(&parts);
        assert!(found.len() == 2 && (found[0] - inner).abs() < 1e-6, "{found:?} {inner}");
        // What does not go through parts nothing, and what is above is no cut.
        let short = [Line::new(p(0.5, 0.5), p(1.5, 1.6))];
        assert_eq!(sheet.cut_along(&short, 1e-6, || true).unwrap().len(), 1);
        let above = [Line::new(Point3::new(1.0, -1.0, 0.5), Point3::new(1.0, 4.0, 0.5))];
        assert_eq!(sheet.cut_along(&above, 1e-6, || true).unwrap().len(), 1);
        assert!(sheet.cut_along(&short, 0.0, || true).is_err());
        assert!(sheet.cut_along(&short, 1e-6, || false).is_err());
    }
}
