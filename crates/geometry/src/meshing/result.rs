//! What meshing gives.

use crate::{Mesh, MeshFace, Point2, Point3, Result, Vector3};

/// The mesh of a brep: for every face a mesh of its own, and points that neighbours share.
#[derive(Debug, Clone, PartialEq)]
pub struct BrepMesh {
    points: Vec<Point3>,
    faces: Vec<FaceMesh>,
}

/// The mesh of one face of a brep.
#[derive(Debug, Clone, PartialEq)]
pub struct FaceMesh {
    /// The face's place in the brep.
    pub face: usize,
    /// For every vertex its place in [`BrepMesh::points`].
    pub places: Vec<u32>,
    /// For every vertex its parameters on the face's surface.
    pub parameters: Vec<Point2>,
    /// For every vertex the unit normal of the face, which is opposite to the surface's when the face is reversed;
    /// zero where there is none.
    pub normals: Vec<Vector3>,
    /// The polygons, by places among the face's own vertices, counter-clockwise about the normal.
    pub faces: Vec<MeshFace>,
}

impl BrepMesh {
    pub(super) fn new(points: Vec<Point3>, faces: Vec<FaceMesh>, welds: &[[u32; 2]]) -> Self {
        let mut mesh = Self { points, faces };
        mesh.weld(welds);
        mesh
    }

    /// Makes one of points that are in one place of a face's parameter plane.
    fn weld(&mut self, welds: &[[u32; 2]]) {
        if welds.is_empty() {
            return;
        }
        let mut becomes: Vec<u32> = (0..self.points.len() as u32).collect();
        let root = |becomes: &[u32], mut k: u32| {
            while let Some(&next) = becomes.get(k as usize).filter(|next| **next != k) {
                k = next;
            }
            k
        };
        for &[a, b] in welds {
            let (a, b) = (root(&becomes, a), root(&becomes, b));
            if let Some(slot) = becomes.get_mut(a.max(b) as usize) {
                *slot = a.min(b);
            }
        }
        for face in &mut self.faces {
            face.places.iter_mut().for_each(|p| *p = root(&becomes, *p));
        }
    }

    /// The points: those at vertices and along edges, which faces share, and then those inside faces.
    pub fn points(&self) -> &[Point3] {
        &self.points
    }

    /// The meshes of the faces.
    pub fn faces(&self) -> &[FaceMesh] {
        &self.faces
    }

    /// The number of triangles, with quads cut in two.
    pub fn triangle_count(&self) -> usize {
        self.faces.iter().flat_map(|f| &f.faces).map(|f| f.indices().len() - 2).sum()
    }

    /// One mesh in which faces share the vertices along their edges: closed for a solid. It has no normals, because
    /// one vertex has those of all its faces.
    ///
    /// # Errors
    /// More than 2³² − 1 vertices.
    pub fn welded(&self) -> Result<Mesh> {
        // Points of edges that no face uses are left out.
        let mut used = vec![false; self.points.len()];
        let place = |face: &FaceMesh, v: u32| face.places.get(v as usize).copied().unwrap_or(0);
        for face in &self.faces {
            for &v in face.faces.iter().flat_map(|f| f.indices()) {
                if let Some(slot) = used.get_mut(place(face, v) as usize) {
                    *slot = true;
                }
            }
        }
        let mut count = 0_u32;
        let new: Vec<u32> = (used.iter())
            .map(|used| {
                count += u32::from(*used);
                count.saturating_sub(1)
            })
            .collect();
        let vertices = self.points.iter().zip(&used).filter(|x| *x.1).map(|x| *x.0).collect();
        let renamed =
            |face: &FaceMesh, f: &MeshFace| f.map(|v| new.get(place(face, v) as usize).copied().unwrap_or(0));
        let faces =
            self.faces.iter().flat_map(|face| face.faces.iter().map(move |f| renamed(face, f))).collect();
        Mesh::new(vertices, faces)
    }

    /// The mesh of one face by its place in [`BrepMesh::faces`], with normals; none when there is no such face.
    pub fn face_mesh(&self, place: usize) -> Option<Result<Mesh>> {
        let face = self.faces.get(place)?;
        Some(Mesh::from_parts(self.points_of(face), face.faces.clone(), face.normals.clone(), Vec::new()))
    }

    fn points_of(&self, face: &FaceMesh) -> Vec<Point3> {
        face.places.iter().map(|&p| self.points.get(p as usize).copied().unwrap_or(Point3::ORIGIN)).collect()
    }

    /// The meshes of all faces appended to each other, each with vertices and normals of its own: along an edge there
    /// are two vertices in exactly the same place.
    ///
    /// # Errors
    /// More than 2³² − 1 vertices.
    pub fn to_mesh(&self) -> Result<Mesh> {
        let (mut vertices, mut faces, mut normals) = (Vec::new(), Vec::new(), Vec::new());
        for face in &self.faces {
            let start = vertices.len() as u32;
            vertices.extend(self.points_of(face));
            normals.extend_from_slice(&face.normals);
            faces.extend(face.faces.iter().map(|f| f.map(|v| v.saturating_add(start))));
        }
        Mesh::from_parts(vertices, faces, normals, Vec::new())
    }
}
