//! Meshes joined, welded, flipped and transformed.

use std::sync::Arc;

use super::Mesh;
use crate::mesh::thresholds::{CREASE, SAME_ANGLE};
use crate::{Error, Point3, Result, Vector3, Xform};

impl Mesh {
    /// One mesh of the vertices and faces of all, in order; nothing is welded. Normals and colours are kept where
    /// every mesh has them (missing normals are computed when some mesh has them).
    ///
    /// # Errors
    /// More vertices than an index can count.
    pub fn join(meshes: &[Self]) -> Result<Self> {
        let (mut vertices, mut faces) = (Vec::new(), Vec::new());
        let (mut normals, mut colours) = (Vec::new(), Vec::new());
        let any_normals = meshes.iter().any(|m| !m.normals().is_empty());
        let all_colours = meshes.iter().all(|m| m.colours().len() == m.vertices().len());
        for mesh in meshes {
            let shift = u32::try_from(vertices.len() + mesh.vertices().len())
                .map_err(|_| Error::Invalid {
                    what: "joined mesh",
                    why: "it has more vertices than an index can count".into(),
                })?
                .saturating_sub(mesh.vertices().len() as u32);
            vertices.extend_from_slice(mesh.vertices());
            faces.extend(mesh.faces().iter().map(|f| f.map(|i| i + shift)));
            if any_normals {
                if mesh.normals().is_empty() {
                    normals.extend(mesh.vertex_normals());
                } else {
                    normals.extend_from_slice(mesh.normals());
                }
            }
            if all_colours {
                colours.extend_from_slice(mesh.colours());
            }
        }
        Self::from_parts(vertices, faces, normals, colours)
    }

    /// The mesh with all faces turned round, and normals with them.
    #[must_use]
    pub fn flipped(&self) -> Self {
        Self {
            vertices: self.vertices.clone(),
            faces: Arc::new(self.faces.iter().map(|f| f.flipped()).collect()),
            normals: self.normals.iter().map(|&n| -n).collect(),
            colours: self.colours.clone(),
        }
    }

    /// The image. A map that mirrors turns the faces round, so that outside stays outside; normals are mapped as
    /// normals are, by the inverse transpose.
    ///
    /// # Errors
    /// A vertex is sent to infinity.
    pub fn transformed(&self, xform: &Xform) -> Result<Self> {
        let vertices: Vec<Point3> = self.vertices.iter().map(|&p| xform.point(p)).collect();
        if let Some(i) = vertices.iter().position(|p| !p.is_finite()) {
            return Err(Error::Invalid { what: "mesh", why: format!("vertex {i} is not finite") });
        }
        let mirrors = xform.determinant() < 0.0;
        let faces = match mirrors {
            true => Arc::new(self.faces.iter().map(|f| f.flipped()).collect()),
            false => self.faces.clone(),
        };
        let normals = match xform.inverse() {
            _ if self.normals.is_empty() => Vec::new(),
            Some(inverse) if xform.is_affine() => {
                let m = inverse.transposed();
                self.normals.iter().map(|&n| m.vector(n).unitized().unwrap_or(Vector3::ZERO)).collect()
            }
            _ => Vec::new(),
        };
        if normals.iter().any(|n| !n.is_finite()) {
            return Err(Error::NotFinite("mesh normal"));
        }
        let had_normals = !self.normals.is_empty();
        let image = Self { vertices, faces, normals, colours: self.colours.clone() };
        Ok(if had_normals && image.normals.is_empty() { image.with_normals() } else { image })
    }

    /// The mesh with other colours: those given, repeated in order when there are fewer than vertices; none removes
    /// them.
    #[must_use]
    pub fn with_colours(&self, colours: &[[u8; 4]]) -> Self {
        let colours = colours.iter().copied().cycle().take(self.vertices.len()).collect();
        Self { colours, ..self.clone() }
    }

    /// Vertices in the same place become one where the faces that meet there differ by at most `angle` radians in
    /// their normals; normals are computed anew, colours are those of the first vertex.
    ///
    /// Faces are linked across the edges and vertices they share, so an angle of π welds everything and one of 0
    /// only what is flat.
    #[must_use]
    pub fn welded(&self, angle: f64) -> Self {
        let merged = self.merged_indices();
        let normals = self.face_normals();
        // Corners by place; within a place, corners whose face normals are within the angle belong together.
        let mut corners: Vec<Vec<(usize, usize)>> = vec![Vec::new(); self.vertices.len()];
        for (f, face) in self.faces.iter().enumerate() {
            for (k, &i) in face.indices().iter().enumerate() {
                if let Some(list) = merged.get(i as usize).and_then(|&m| corners.get_mut(m as usize)) {
                    list.push((f, k));
                }
            }
        }
        let mut faces = self.faces.to_vec();
        let (mut vertices, mut colours) = (Vec::new(), Vec::new());
        for list in corners.iter().filter(|l| !l.is_empty()) {
            let mut groups: Vec<Vec<(usize, usize)>> = Vec::new();
            for &(f, k) in list {
                let near = |&(g, _): &(usize, usize)| {
                    normals[f].angle_to(normals[g]).is_none_or(|x| x <= angle + SAME_ANGLE)
                        || self.faces[f].indices()[k] == self.vertex_of(g, list)
                };
                // All groups that this corner touches become one.
                let (mut joined, apart): (Vec<_>, Vec<_>) =
                    groups.into_iter().partition(|group| group.iter().any(near));
                let mut group: Vec<_> = joined.drain(..).flatten().collect();
                group.push((f, k));
                groups = apart;
                groups.push(group);
            }
            groups.sort();
            for group in groups {
                let Some(&(f, k)) = group.first() else { continue };
                let old = self.faces[f].indices()[k] as usize;
                let new = vertices.len() as u32;
                vertices.push(self.vertices[old]);
                colours.extend(self.colours.get(old));
                for (f, k) in group {
                    faces[f].set(k, new);
                }
            }
        }
        Self { vertices, faces: Arc::new(faces), normals: Vec::new(), colours }.with_normals()
    }

    /// The vertex that face `g` uses in the place of a list of corners.
    fn vertex_of(&self, g: usize, list: &[(usize, usize)]) -> u32 {
        list.iter().find(|c| c.0 == g).map_or(u32::MAX, |&(f, k)| self.faces[f].indices()[k])
    }

    /// The mesh with every edge split where the normals of its faces differ by at least `angle` radians: each face
    /// gets a vertex of its own there. Normals are computed anew.
    #[must_use]
    pub fn unwelded(&self, angle: f64) -> Self {
        let mut vertices = Vec::new();
        let mut colours = Vec::new();
        let mut faces = self.faces.to_vec();
        for face in &mut faces {
            for k in 0..face.indices().len() {
                let old = face.indices()[k] as usize;
                face.set(k, vertices.len() as u32);
                vertices.push(self.vertices[old]);
                colours.extend(self.colours.get(old));
            }
        }
        let apart = Self { vertices, faces: Arc::new(faces), normals: Vec::new(), colours };
        apart.welded((angle - CREASE).max(0.0))
    }
}
