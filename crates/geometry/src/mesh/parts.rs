//! Meshes taken apart: some of the faces, without some vertices, the pieces that hang together.

use super::tree::MeshTree;
use super::{Mesh, MeshFace};
use crate::hash::{Table, table};
use crate::{Containment, Result};

/// The entries whose number is not `None`.
fn pick<T: Copy>(items: &[T], number: &[Option<u32>]) -> Vec<T> {
    items.iter().zip(number).filter(|(_, n)| n.is_some()).map(|(x, _)| *x).collect()
}

impl Mesh {
    /// Some faces with the vertices they use, those in the order they have here.
    ///
    /// # Errors
    /// A face index out of range.
    pub fn part(&self, faces: &[MeshFace]) -> Result<Self> {
        let mut number: Vec<Option<u32>> = vec![None; self.vertices.len()];
        for &i in faces.iter().flat_map(|f| f.indices()) {
            if let Some(place) = number.get_mut(i as usize) {
                *place = Some(0);
            }
        }
        for (place, next) in number.iter_mut().flatten().zip(0..) {
            *place = next;
        }
        // An index out of range stays so, and is refused with the others.
        let new = |i: u32| number.get(i as usize).copied().flatten().unwrap_or(u32::MAX);
        Self::from_parts(
            pick(&self.vertices, &number),
            faces.iter().map(|f| f.map(new)).collect(),
            pick(&self.normals, &number),
            pick(&self.colours, &number),
        )
    }

    /// The mesh without the vertices that `gone` names, and without those that no face uses then. A face that loses a
    /// corner goes; with `shrink`, a quad that loses one becomes a triangle.
    ///
    /// # Errors
    /// None for a mesh that a constructor made.
    pub fn without_vertices(&self, gone: impl Fn(usize) -> bool, shrink: bool) -> Result<Self> {
        let keep = |face: &MeshFace| {
            let left: Vec<u32> = face.indices().iter().copied().filter(|&i| !gone(i as usize)).collect();
            match *left.as_slice() {
                _ if left.len() == face.indices().len() => Some(*face),
                [a, b, c] if shrink => Some(MeshFace::Triangle([a, b, c])),
                _ => None,
            }
        };
        self.part(&self.faces.iter().filter_map(keep).collect::<Vec<_>>())
    }

    /// The pieces that hang together along edges, in the order of their first faces. Vertices in the same place count
    /// as one.
    ///
    /// # Errors
    /// None for a mesh that a constructor made.
    pub fn pieces(&self) -> Result<Vec<Self>> {
        let (piece, count) = self.piece_numbers();
        let mut sorted: Vec<Vec<MeshFace>> = vec![Vec::new(); count];
        for (face, k) in self.faces.iter().zip(&piece) {
            if let Some(list) = sorted.get_mut(*k) {
                list.push(*face);
            }
        }
        sorted.iter().map(|faces| self.part(faces)).collect()
    }

    /// The number of the piece that each face belongs to, and the number of pieces.
    fn piece_numbers(&self) -> (Vec<usize>, usize) {
        let merged = self.merged_indices();
        // Faces of one edge are joined in a forest; a root is a piece (union by path halving: R. Tarjan, *Data
        // Structures and Network Algorithms*, 1983, ch. 2).
        let mut parent: Vec<usize> = (0..self.faces.len()).collect();
        fn root(parent: &mut [usize], mut i: usize) -> usize {
            while let Some(&p) = parent.get(i) {
                if p == i {
                    break;
                }
                let above = parent.get(p).copied().unwrap_or(p);
                if let Some(slot) = parent.get_mut(i) {
                    *slot = above;
                }
                i = above;
            }
            i
        }
        let mut along: Table<(u32, u32), usize> = table(2 * self.faces.len());
        for (f, face) in self.faces.iter().enumerate() {
            let indices = face.indices();
            for (&i, &j) in indices.iter().zip(indices.iter().cycle().skip(1)) {
                let at = |i: u32| merged.get(i as usize).copied().unwrap_or(i);
                let (a, b) = (at(i), at(j));
                let other = *along.entry((a.min(b), a.max(b))).or_insert(f);
                let (r, s) = (root(&mut parent, f), root(&mut parent, other));
                // The earlier face stays the root, so that pieces come in the order of their first faces.
                if let Some(slot) = parent.get_mut(r.max(s)) {
                    *slot = r.min(s);
                }
            }
        }
        let mut number: Vec<Option<usize>> = vec![None; self.faces.len()];
        let mut count = 0;
        let pieces = (0..self.faces.len())
            .map(|f| {
                let r = root(&mut parent, f);
                let Some(slot) = number.get_mut(r) else { return 0 };
                *slot.get_or_insert_with(|| {
                    count += 1;
                    count - 1
                })
            })
            .collect();
        (pieces, count)
    }

    /// The solids that a closed mesh bounds: its pieces, with each hollow, a piece that looks inwards, kept with the
    /// smallest piece around it. A piece that looks inwards and has none around it stands alone.
    ///
    /// # Errors
    /// More vertices than an index can count.
    pub fn solids(&self) -> Result<Vec<Self>> {
        let pieces = self.pieces()?;
        let volumes: Vec<f64> = pieces.iter().map(Self::volume).collect();
        if volumes.iter().all(|v| *v >= 0.0) {
            return Ok(pieces);
        }
        let outer: Vec<usize> =
            (0..pieces.len()).filter(|&i| volumes.get(i).is_some_and(|v| *v >= 0.0)).collect();
        let trees: Vec<Option<MeshTree>> = outer.iter().map(|&i| pieces.get(i).map(MeshTree::new)).collect();
        let mut groups: Vec<Vec<Self>> = vec![Vec::new(); pieces.len()];
        for (i, piece) in pieces.iter().enumerate() {
            let is_outer = volumes.get(i).is_some_and(|v| *v >= 0.0);
            let around = |tree: &MeshTree| {
                let sample = piece.vertices.first();
                sample.is_some_and(|p| tree.containment(*p, 0.0) == Containment::Inside)
            };
            let found = outer.iter().zip(&trees).filter(|(_, t)| t.as_ref().is_some_and(around));
            let size = |j: usize| volumes.get(j).copied().unwrap_or(f64::INFINITY);
            let owner = found.map(|(j, _)| *j).min_by(|a, b| size(*a).total_cmp(&size(*b)));
            let target = if is_outer { i } else { owner.unwrap_or(i) };
            if let Some(group) = groups.get_mut(target) {
                group.push(piece.clone());
            }
        }
        groups.iter().filter(|g| !g.is_empty()).map(|g| Self::join(g)).collect()
    }
}

#[cfg(test)]
mod tests {
    use crate::{Mesh, MeshFace, Plane, Point3};

    #[test]
    fn taken_apart() {
        let ball = |r: f64, x: f64| {
            let plane = Plane { origin: Point3::new(x, 0.0, 0.0), ..Plane::XY };
            Mesh::sphere(&plane, r, 8, 6).unwrap()
        };
        let both = Mesh::join(&[ball(1.0, 0.0), ball(2.0, 5.0)]).unwrap();
        let pieces = both.pieces().unwrap();
        assert_eq!(pieces.len(), 2);
        assert_eq!(pieces[1].vertices(), ball(2.0, 5.0).vertices());
        let hollow = Mesh::join(&[ball(2.0, 0.0), ball(1.0, 9.0), ball(1.0, 0.0).flipped()]).unwrap();
        let solids = hollow.solids().unwrap();
        assert_eq!(solids.len(), 2);
        assert!((solids[0].volume() - (ball(2.0, 0.0).volume() - ball(1.0, 0.0).volume())).abs() < 1e-12);
        assert!(Mesh::default().pieces().unwrap().is_empty());
    }

    #[test]
    fn without_some_vertices() {
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [2.0, 0.0, 0.0]];
        let faces = vec![MeshFace::Quad([0, 1, 2, 3]), MeshFace::Triangle([1, 4, 2])];
        let mesh = Mesh::new(points.map(Point3::from).to_vec(), faces).unwrap();
        let shrunk = mesh.without_vertices(|i| i == 3, true).unwrap();
        assert_eq!(shrunk.faces(), [MeshFace::Triangle([0, 1, 2]), MeshFace::Triangle([1, 3, 2])]);
        let cut = mesh.without_vertices(|i| i == 3, false).unwrap();
        assert_eq!((cut.vertices().len(), cut.faces().len()), (3, 1));
        assert!(mesh.without_vertices(|_| true, true).unwrap().vertices().is_empty());
        assert!(mesh.part(&[MeshFace::Triangle([0, 1, 77])]).is_err());
    }
}
