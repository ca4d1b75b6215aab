//! Triangles of a face that know their neighbours in the parameter plane.

use super::fill::PlaceMap;
use crate::MeshFace;

/// Triangles with the mesh faces that they are from.
#[derive(Default)]
pub(super) struct Net {
    /// The corners of every triangle; none for one that was removed.
    corners: Vec<Option<[u32; 3]>>,
    /// For every triangle the mesh face that it is part of; none like it for a new one.
    faces: Vec<u32>,
    /// For every directed side the triangle to the left of it.
    left: PlaceMap<u64, u32>,
    /// Mesh faces that are no longer whole.
    broken: Vec<u32>,
    /// How many triangles were there before the first change.
    first: Option<usize>,
    seen: usize,
}

fn key(a: u32, b: u32) -> u64 {
    u64::from(a) << 32 | u64::from(b)
}

impl Net {
    /// How many triangles there are and were.
    pub(super) fn len(&self) -> usize {
        self.corners.len()
    }

    /// The corners of a triangle.
    pub(super) fn get(&self, t: u32) -> Option<[u32; 3]> {
        self.corners.get(t as usize).copied().flatten()
    }

    /// Adds a triangle of a mesh face.
    pub(super) fn add(&mut self, face: u32, corners: [u32; 3]) {
        let t = self.corners.len() as u32;
        let [a, b, c] = corners;
        for (a, b) in [(a, b), (b, c), (c, a)] {
            self.left.insert(key(a, b), t);
        }
        self.corners.push(Some(corners));
        self.faces.push(face);
    }

    /// Removes a triangle, and says its corners.
    pub(super) fn remove(&mut self, t: u32) -> Option<[u32; 3]> {
        let corners = self.corners.get_mut(t as usize)?.take()?;
        self.first.get_or_insert(self.faces.len());
        self.broken.extend(self.faces.get(t as usize).filter(|f| **f != u32::MAX));
        let [a, b, c] = corners;
        for (a, b) in [(a, b), (b, c), (c, a)] {
            if self.left.get(&key(a, b)) == Some(&t) {
                self.left.remove(&key(a, b));
            }
        }
        Some(corners)
    }

    /// The triangle on the other side of a triangle's side.
    pub(super) fn across(&self, a: u32, b: u32) -> Option<u32> {
        self.left.get(&key(b, a)).copied()
    }

    /// How many triangles were added or removed.
    pub(super) fn changes(&self) -> usize {
        self.corners.len() + self.broken.len()
    }

    /// These and all triangles added since this was asked last.
    pub(super) fn recent(&mut self, left: &[u32]) -> Vec<u32> {
        let from = self.seen.max(self.first.unwrap_or(self.corners.len()));
        self.seen = self.corners.len();
        left.iter().copied().chain(from as u32..self.corners.len() as u32).collect()
    }

    /// The mesh faces: those still whole as they were, and triangles.
    pub(super) fn faces(mut self, before: &[MeshFace]) -> Vec<MeshFace> {
        self.broken.sort_unstable();
        self.broken.dedup();
        let mut out = Vec::with_capacity(before.len());
        let mut broken = self.broken.iter().copied().peekable();
        for (k, &face) in before.iter().enumerate() {
            if broken.next_if_eq(&(k as u32)).is_none() {
                out.push(face);
            }
        }
        for (corners, face) in self.corners.iter().zip(&self.faces) {
            let is_loose = *face == u32::MAX || self.broken.binary_search(face).is_ok();
            out.extend(corners.filter(|_| is_loose).map(MeshFace::Triangle));
        }
        out
    }
}
