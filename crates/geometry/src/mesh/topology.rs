//! Edges of a mesh, and whether it is closed, manifold and oriented.

use super::Mesh;
use crate::hash::{Table, table};
use crate::{Error, Line, Result};

/// An edge between two places of a mesh, whichever of the vertices there its faces use.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MeshEdge {
    /// The vertices at its ends, each the first of those in its place.
    pub vertices: [u32; 2],
    /// The number of faces along it: 1 for a naked edge, 2 inside, 3 and more where the mesh is not manifold.
    pub faces: usize,
    /// Whether two faces walk it in opposite directions, as neighbours that look to the same side do.
    pub oriented: bool,
}

impl Mesh {
    /// For every vertex the first vertex in exactly the same place: topology takes them as one.
    pub fn merged_indices(&self) -> Vec<u32> {
        let mut first: Table<[u64; 3], u32> = table(self.vertices().len());
        self.vertices()
            .iter()
            .zip(0_u32..)
            .map(|(p, i)| {
                // 0 and −0 are the same place.
                let key = [p.x + 0.0, p.y + 0.0, p.z + 0.0].map(f64::to_bits);
                *first.entry(key).or_insert(i)
            })
            .collect()
    }

    /// All edges, in the order in which the faces name them first.
    pub fn edges(&self) -> Vec<MeshEdge> {
        let merged = self.merged_indices();
        let mut found: Table<(u32, u32), usize> = table(2 * self.faces().len());
        let mut out: Vec<(MeshEdge, i64)> = Vec::new();
        for face in self.faces() {
            let indices = face.indices();
            for (k, &i) in indices.iter().enumerate() {
                let a = merged.get(i as usize).copied().unwrap_or(i);
                let next = indices[(k + 1) % indices.len()];
                let b = merged.get(next as usize).copied().unwrap_or(next);
                if a == b {
                    continue;
                }
                let at = *found.entry((a.min(b), a.max(b))).or_insert(out.len());
                if at == out.len() {
                    out.push((MeshEdge { vertices: [a, b], faces: 0, oriented: false }, 0));
                }
                if let Some((edge, balance)) = out.get_mut(at) {
                    edge.faces += 1;
                    *balance += if edge.vertices[0] == a { 1 } else { -1 };
                }
            }
        }
        out.into_iter()
            .map(|(edge, balance)| MeshEdge { oriented: edge.faces == 2 && balance == 0, ..edge })
            .collect()
    }

    /// The segment along an edge; `None` when it is not of this mesh.
    pub fn edge_line(&self, edge: &MeshEdge) -> Option<Line> {
        let at = |i: u32| self.vertices().get(i as usize).copied();
        Some(Line::new(at(edge.vertices[0])?, at(edge.vertices[1])?))
    }

    /// Whether every edge has exactly two faces or more: nothing leaks. A mesh without faces is open.
    pub fn is_closed(&self) -> bool {
        !self.faces().is_empty() && self.edges().iter().all(|e| e.faces >= 2)
    }

    /// Whether no edge has more than two faces.
    pub fn is_manifold(&self) -> bool {
        self.edges().iter().all(|e| e.faces <= 2)
    }

    /// Whether all neighbours look to the same side.
    pub fn is_oriented(&self) -> bool {
        self.edges().iter().all(|e| e.faces == 1 || e.oriented)
    }

    /// Checks more than the constructor does: that there are faces, none repeats a corner, and none is without area.
    ///
    /// # Errors
    /// The first face at fault and why.
    pub fn check(&self) -> Result<()> {
        let invalid = |why: String| Err(Error::Invalid { what: "mesh", why });
        if self.faces().is_empty() {
            return invalid("it has no faces".into());
        }
        for (i, face) in self.faces().iter().enumerate() {
            let indices = face.indices();
            if (1..indices.len()).any(|k| indices[..k].contains(&indices[k])) {
                return invalid(format!("face {i} uses a vertex twice"));
            }
        }
        if let Some(i) = self.face_normals().iter().position(|n| n.length_squared() == 0.0) {
            return invalid(format!("face {i} has no area"));
        }
        Ok(())
    }
}
