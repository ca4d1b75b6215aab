//! Borders of meshes brought together: vertices that nearly meet, and vertices that lie on edges.

use crate::mesh::thresholds::BESIDE_ENDS;
use std::collections::HashMap;
use std::ops::ControlFlow;

use super::{Mesh, MeshFace};
use crate::box_tree::{BoxTree, bounds_of, boxes_meet};
use crate::{Error, Point3, Result};

/// The most times that edges are split and looked at again.
const ROUNDS: usize = 64;

/// Which vertices are brought together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Healing {
    /// Those on borders.
    Borders,
    /// All of them.
    Everything,
}

impl Mesh {
    /// The mesh with vertices that lie within a distance of one another in one place, that of the first of them, and
    /// with naked edges split at naked vertices that lie within the distance of them. Faces that lose a corner become
    /// triangles, or go. Also how many vertices moved and how many edges were split.
    ///
    /// # Errors
    /// The distance is not above 0, or everything goes; `go_on` said no.
    pub fn healed(
        &self,
        distance: f64,
        what: Healing,
        mut go_on: impl FnMut() -> bool,
    ) -> Result<(Self, usize)> {
        if !(distance > 0.0 && distance.is_finite()) {
            return Err(Error::OutOfRange { what: "distance", value: distance, must: "above 0" });
        }
        let (places, moved) = self.drawn_together(distance, what);
        let merged = Self::new(places.clone(), self.faces().to_vec())?.merged_indices();
        let at = |i: u32| merged.get(i as usize).copied().unwrap_or(i);
        let mut faces: Vec<MeshFace> = Vec::with_capacity(self.faces().len());
        for face in self.faces() {
            let mut corners: Vec<u32> = Vec::with_capacity(4);
            for &i in face.indices() {
                if !corners.iter().any(|own| at(*own) == at(i)) {
                    corners.push(i);
                }
            }
            match *corners.as_slice() {
                [a, b, c, d] => faces.push(MeshFace::Quad([a, b, c, d])),
                [a, b, c] => faces.push(MeshFace::Triangle([a, b, c])),
                _ => {}
            }
        }
        let mut split = 0;
        for _ in 0..ROUNDS {
            if !go_on() {
                return Err(Error::Stopped);
            }
            let found = split_once(&places, &mut faces, &at, distance);
            split += found;
            if found == 0 {
                break;
            }
        }
        if moved + split == 0 {
            return Ok((self.clone(), 0));
        }
        if faces.is_empty() {
            return Err(Error::degenerate("mesh", "nothing of it is larger than the distance"));
        }
        let healed = Self::from_parts(places, faces, Vec::new(), self.colours().to_vec())?;
        let kept = healed.part(healed.faces())?;
        Ok((if self.normals().is_empty() { kept } else { kept.with_normals() }, moved + split))
    }

    /// The vertices in their new places, and how many of them moved.
    fn drawn_together(&self, distance: f64, what: Healing) -> (Vec<Point3>, usize) {
        let merged = self.merged_indices();
        let mut taking = vec![what == Healing::Everything; self.vertices().len()];
        for edge in self.edges().iter().filter(|edge| edge.faces == 1) {
            edge.vertices.iter().for_each(|i| taking[*i as usize] = true);
        }
        let mut grid = Grid::new(distance);
        let mut places = self.vertices().to_vec();
        let mut moved = 0;
        for (i, own) in merged.iter().enumerate() {
            let own = *own as usize;
            if own != i {
                places[i] = places[own];
            } else if taking[i] {
                let p = places[i];
                let found = grid.near(p).find(|(_, q)| q.distance_to(p) <= distance);
                match found {
                    Some((_, q)) => places[i] = q,
                    None => grid.add(i, p),
                }
            }
            moved += usize::from(places[i] != self.vertices()[i]);
        }
        (places, moved)
    }
}

/// Points by the cells of a grid.
struct Grid {
    cell: f64,
    points: HashMap<[i64; 3], Vec<(usize, Point3)>>,
}

impl Grid {
    fn new(cell: f64) -> Self {
        Self { cell, points: HashMap::new() }
    }

    #[expect(clippy::cast_possible_truncation, reason = "places far out share the cells at the end")]
    fn cell_of(&self, p: Point3) -> [i64; 3] {
        [p.x, p.y, p.z].map(|x| ((x / self.cell).floor() as i64).clamp(-(1 << 60), 1 << 60))
    }

    fn add(&mut self, index: usize, p: Point3) {
        self.points.entry(self.cell_of(p)).or_default().push((index, p));
    }

    fn near(&self, p: Point3) -> impl Iterator<Item = (usize, Point3)> + '_ {
        let [x, y, z] = self.cell_of(p);
        let beside = (-1..=1).flat_map(|a| (-1..=1).flat_map(move |b| (-1..=1).map(move |c| [a, b, c])));
        let cells = beside.filter_map(move |[a, b, c]| self.points.get(&[x + a, y + b, z + c]));
        cells.flatten().copied()
    }
}

/// Splits each face at most once, at the naked vertex that is nearest to one of its naked edges; how many were split.
fn split_once(
    places: &[Point3],
    faces: &mut Vec<MeshFace>,
    at: &impl Fn(u32) -> u32,
    distance: f64,
) -> usize {
    let mut uses: HashMap<[u32; 2], usize> = HashMap::new();
    let sides = |face: &MeshFace| {
        let corners = face.indices();
        let ring = corners.iter().zip(corners.iter().cycle().skip(1));
        ring.map(|(a, b)| [*a, *b]).collect::<Vec<[u32; 2]>>()
    };
    let key = |[a, b]: [u32; 2]| [at(a).min(at(b)), at(a).max(at(b))];
    for face in faces.iter() {
        for side in sides(face) {
            *uses.entry(key(side)).or_default() += 1;
        }
    }
    let is_naked = |side: [u32; 2]| uses.get(&key(side)) == Some(&1);
    let mut naked: Vec<u32> =
        faces.iter().flat_map(&sides).filter(|side| is_naked(*side)).flatten().collect();
    naked.sort_by_key(|i| at(*i));
    naked.dedup_by_key(|i| at(*i));
    let boxes = naked.iter().map(|i| bounds_of([places[*i as usize].into()]));
    let tree = BoxTree::by_place(&boxes.collect::<Vec<_>>());
    let mut count = 0;
    let mut out = Vec::with_capacity(faces.len());
    for face in faces.iter() {
        let mut best: Option<(f64, usize, u32)> = None;
        for (k, side) in sides(face).into_iter().enumerate().filter(|(_, side)| is_naked(*side)) {
            let [a, b] = side.map(|i| places[i as usize]);
            let (way, length) = (b - a, (b - a).length());
            let (bounds, margin) = (bounds_of([a.into(), b.into()]), distance.min(BESIDE_ENDS * length));
            tree.visit_where(
                |own| boxes_meet(own, &bounds, distance),
                |found| {
                    let v = naked[found];
                    let p = places[v as usize];
                    let along = (p - a).dot(way) / (length * length);
                    let off = p.distance_to(a + way * along);
                    let own = face.indices().iter().any(|i| at(*i) == at(v));
                    let inside = along * length > margin && (1.0 - along) * length > margin;
                    if !own && inside && off <= distance && best.is_none_or(|best| off < best.0) {
                        best = Some((off, k, v));
                    }
                    ControlFlow::Continue(())
                },
            );
        }
        let Some((_, k, v)) = best else {
            out.push(*face);
            continue;
        };
        count += 1;
        let corners = face.indices();
        let n = corners.len();
        // A fan from the vertex on the edge over the corners that follow.
        for step in 1..n {
            out.push(MeshFace::Triangle([v, corners[(k + step) % n], corners[(k + step + 1) % n]]));
        }
    }
    *faces = out;
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Interval, Plane, Rectangle};

    fn sheet(x: [f64; 2], y: [f64; 2], parts: [usize; 2]) -> Mesh {
        let r = Rectangle { plane: Plane::XY, x: Interval::new(x[0], x[1]), y: Interval::new(y[0], y[1]) };
        Mesh::plane(&r, parts[0], parts[1]).unwrap()
    }

    #[test]
    fn sheets_with_gaps_are_closed() {
        // Along the seam one has a vertex halfway, and they are a little apart.
        let apart =
            Mesh::join(&[sheet([0.0, 1.0], [0.0, 1.0], [1, 2]), sheet([1.01, 2.0], [0.0, 1.0], [1, 1])])
                .unwrap();
        assert_eq!(apart.edges().iter().filter(|e| e.faces == 1).count(), 10);
        for what in [Healing::Borders, Healing::Everything] {
            let (healed, changes) = apart.healed(0.05, what, || true).unwrap();
            assert_eq!(changes, 3);
            assert_eq!(healed.edges().iter().filter(|e| e.faces == 1).count(), 7);
            assert!((healed.area() - 2.0).abs() < 1e-9 && healed.is_oriented());
            let (again, none) = healed.healed(0.05, what, || true).unwrap();
            assert!(none == 0 && again == healed);
        }
        let (kept, none) = apart.healed(0.005, Healing::Borders, || true).unwrap();
        assert!(none == 0 && kept == apart);
        assert!(apart.healed(0.0, Healing::Borders, || true).is_err());
        assert!(apart.healed(f64::NAN, Healing::Borders, || true).is_err());
        assert!(apart.healed(0.05, Healing::Borders, || false).is_err());
    }
}
