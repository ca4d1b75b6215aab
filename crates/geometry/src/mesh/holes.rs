//! Holes of meshes closed with faces.

use std::collections::{BTreeMap, BTreeSet};

use super::{Mesh, MeshFace};
use crate::{Error, Point3, Result, Vector3};

/// Up to so many corners a hole is closed with the least area; a larger one corner by corner.
const FEW: usize = 120;

impl Mesh {
    /// The borders that close, each as vertices in the order in which faces that close it run. What comes together in
    /// one point, or does not run one way, is left out.
    pub fn holes(&self) -> Vec<Vec<u32>> {
        let merged = self.merged_indices();
        let place = |i: u32| merged.get(i as usize).copied().unwrap_or(i);
        let mut uses: BTreeMap<[u32; 2], (usize, [u32; 2])> = BTreeMap::new();
        for face in self.faces() {
            let corners = face.indices();
            for (k, &a) in corners.iter().enumerate() {
                let b = corners[(k + 1) % corners.len()];
                let (p, q) = (place(a), place(b));
                if p != q {
                    // A face on the other side runs the other way.
                    let entry = uses.entry([p.min(q), p.max(q)]).or_insert((0, [b, a]));
                    entry.0 += 1;
                }
            }
        }
        let mut next: BTreeMap<u32, Vec<[u32; 2]>> = BTreeMap::new();
        let mut arriving: BTreeMap<u32, usize> = BTreeMap::new();
        for [a, b] in uses.into_values().filter(|(count, _)| *count == 1).map(|(_, way)| way) {
            next.entry(place(a)).or_default().push([a, b]);
            *arriving.entry(place(b)).or_default() += 1;
        }
        let mut seen = BTreeSet::new();
        let mut out = Vec::new();
        for &start in next.keys() {
            let mut ring = Vec::new();
            let mut at = start;
            while seen.insert(at) {
                let one = next.get(&at).filter(|ways| ways.len() == 1 && arriving.get(&at) == Some(&1));
                let Some([a, b]) = one.and_then(|ways| ways.first()).copied() else { break };
                ring.push(a);
                at = place(b);
                if at == start {
                    out.push(std::mem::take(&mut ring));
                    break;
                }
            }
        }
        out
    }

    /// The mesh with faces over some of its [holes](Self::holes), triangles that fit its own in direction; vertices stay
    /// as they are, normals are computed anew where there were some. Small holes are closed with the least area
    /// (Barequet and Sharir, *Filling gaps in the boundary of a polyhedron*, 1995), large ones by cutting off the
    /// flattest corner again and again.
    ///
    /// # Errors
    /// A vertex that does not exist, or a ring of fewer than three.
    pub fn with_holes_closed(&self, holes: &[Vec<u32>]) -> Result<Self> {
        let mut faces = self.faces().to_vec();
        for ring in holes {
            let at = |i: &u32| self.vertices().get(*i as usize).copied();
            let points: Option<Vec<Point3>> = ring.iter().map(at).collect();
            let points = points.filter(|points| points.len() >= 3);
            let points = points.ok_or_else(|| Error::degenerate("hole", "it has not three corners"))?;
            let triangles = if ring.len() <= FEW { least_area(&points) } else { corner_by_corner(&points) };
            faces.extend(triangles.iter().map(|corners| MeshFace::Triangle(corners.map(|k| ring[k]))));
        }
        let (vertices, colours) = (self.vertices().to_vec(), self.colours().to_vec());
        let closed = Self::from_parts(vertices, faces, Vec::new(), colours)?;
        Ok(if self.normals().is_empty() { closed } else { closed.with_normals() })
    }
}

fn doubled(a: Point3, b: Point3, c: Point3) -> Vector3 {
    (b - a).cross(c - a)
}

/// The triangulation of a ring with the least area, found from the short stretches of it to the long ones.
fn least_area(points: &[Point3]) -> Vec<[usize; 3]> {
    let n = points.len();
    // The least area over the stretch from i to j, and where its triangle has its third corner.
    let mut best = vec![(0.0_f64, 0_usize); n * n];
    for width in 2..n {
        for i in 0..n - width {
            let j = i + width;
            let mut least = (f64::INFINITY, i + 1);
            for m in i + 1..j {
                let own = doubled(points[i], points[m], points[j]).length();
                let area = best[i * n + m].0 + best[m * n + j].0 + own;
                if area < least.0 {
                    least = (area, m);
                }
            }
            best[i * n + j] = least;
        }
    }
    let mut out = Vec::with_capacity(n - 2);
    let mut open = vec![(0, n - 1)];
    while let Some((i, j)) = open.pop() {
        if j < i + 2 {
            continue;
        }
        let m = best[i * n + j].1;
        out.push([i, m, j]);
        open.extend([(i, m), (m, j)]);
    }
    out
}

/// A triangulation that cuts off, again and again, the corner that looks most along the normal of the ring, of those
/// that no other corner lies in.
fn corner_by_corner(points: &[Point3]) -> Vec<[usize; 3]> {
    let middle = points.iter().map(|p| p.to_vector()).sum::<Vector3>() / points.len() as f64;
    let middle = middle.to_point();
    let turned = |k: usize| doubled(middle, points[k], points[(k + 1) % points.len()]);
    let normal = (0..points.len()).map(turned).sum::<Vector3>().unitized().unwrap_or(Vector3::Z);
    let mut left: Vec<usize> = (0..points.len()).collect();
    let mut out = Vec::with_capacity(points.len() - 2);
    while left.len() > 3 {
        let n = left.len();
        let corner = |k: usize| [left[(k + n - 1) % n], left[k], left[(k + 1) % n]];
        let is_free = |k: usize| {
            let [a, b, c] = corner(k).map(|i| points[i]);
            let inside = |p: Point3| {
                [[a, b], [b, c], [c, a]].iter().all(|[s, t]| doubled(*s, *t, p).dot(normal) > 0.0)
            };
            !left.iter().any(|i| !corner(k).contains(i) && inside(points[*i]))
        };
        let rating = |k: usize| {
            let [a, b, c] = corner(k).map(|i| points[i]);
            let reach = (b - a).length().max((c - b).length()).max((a - c).length());
            doubled(a, b, c).dot(normal) / (reach * reach).max(f64::MIN_POSITIVE)
        };
        let mut order: Vec<(f64, usize)> = (0..n).map(|k| (rating(k), k)).collect();
        order.sort_by(|a, b| b.0.total_cmp(&a.0));
        let best = order.iter().find(|(rating, k)| *rating > 0.0 && is_free(*k)).or(order.first());
        let Some(&(_, k)) = best else { break };
        out.push(corner(k));
        left.remove(k);
    }
    if let [a, b, c] = *left.as_slice() {
        out.push([a, b, c]);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BoundingBox, Plane};

    #[test]
    fn boxes_without_faces_are_closed_again() {
        let bounds = BoundingBox { min: Point3::ORIGIN, max: Point3::new(1.0, 2.0, 3.0) };
        let whole = Mesh::cuboid(&bounds.into(), 2, 3, 2).unwrap();
        // Without all faces at the top, and one at the bottom.
        let lid = |face: &MeshFace| face.indices().iter().all(|i| whole.vertices()[*i as usize].z > 2.9);
        let kept: Vec<MeshFace> = whole.faces().iter().filter(|face| !lid(face)).copied().collect();
        let low = kept.iter().position(|f| f.indices().iter().all(|i| whole.vertices()[*i as usize].z < 0.1));
        let kept: Vec<MeshFace> =
            kept.iter().enumerate().filter(|(k, _)| Some(*k) != low).map(|(_, face)| *face).collect();
        let open = whole.part(&kept).unwrap();
        assert_eq!(open.holes().len(), 2);
        let closed = open.with_holes_closed(&open.holes()).unwrap();
        assert!(closed.is_closed() && closed.is_oriented());
        assert!((closed.volume() - 6.0).abs() < 1e-12 && (closed.area() - 22.0).abs() < 1e-12);
        assert!(whole.holes().is_empty());
    }

    /// The border of a round sheet with many corners: closed it is flat, and twice the area.
    #[test]
    fn large_holes_are_closed() {
        for around in [16_usize, 300] {
            let ball = Mesh::sphere(&Plane::XY, 1.0, around, 8).unwrap();
            let upper: Vec<MeshFace> = ball
                .faces()
                .iter()
                .filter(|face| face.indices().iter().all(|i| ball.vertices()[*i as usize].z > -1e-9))
                .copied()
                .collect();
            let dome = ball.part(&upper).unwrap();
            let closed = dome.with_holes_closed(&dome.holes()).unwrap();
            assert!(closed.is_closed() && closed.is_oriented(), "{around}");
            let n = around as f64;
            let disc = 0.5 * n * (std::f64::consts::TAU / n).sin();
            assert!((closed.area() - dome.area() - disc).abs() < 1e-9, "{around}");
        }
    }
}
