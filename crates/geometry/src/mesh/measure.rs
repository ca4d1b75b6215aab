//! Normals, areas, volume and bounds of meshes.

use super::{Mesh, MeshFace};
use crate::{BoundingBox, Point3, Vector3};

impl Mesh {
    /// The corners of a face; `None` for an index out of range.
    pub fn face_points(&self, face: usize) -> Option<Vec<Point3>> {
        let indices = self.faces().get(face)?.indices();
        Some(indices.iter().filter_map(|&i| self.vertices().get(i as usize).copied()).collect())
    }

    fn corner(&self, i: u32) -> Vector3 {
        self.vertices().get(i as usize).map_or(Vector3::ZERO, |p| p.to_vector())
    }

    /// Twice the area vector of a face: normal to it, and for a quad the cross product of its diagonals.
    fn doubled_area(&self, face: &MeshFace) -> Vector3 {
        match *face {
            MeshFace::Triangle([a, b, c]) => {
                let a = self.corner(a);
                (self.corner(b) - a).cross(self.corner(c) - a)
            }
            MeshFace::Quad([a, b, c, d]) => {
                (self.corner(c) - self.corner(a)).cross(self.corner(d) - self.corner(b))
            }
        }
    }

    /// The unit normal of every face, a quad's from its diagonals; zero for a face without area.
    pub fn face_normals(&self) -> Vec<Vector3> {
        self.faces().iter().map(|f| self.doubled_area(f).unitized().unwrap_or(Vector3::ZERO)).collect()
    }

    /// The mean of the corners of every face.
    pub fn face_centers(&self) -> Vec<Point3> {
        let mean = |f: &MeshFace| {
            let n = f.indices().len() as f64;
            f.indices().iter().map(|&i| self.corner(i) / n).sum::<Vector3>().to_point()
        };
        self.faces().iter().map(mean).collect()
    }

    /// A unit normal a vertex: the face normals around it, weighted by the angle at the vertex (G. Thürmer, C.
    /// Wüthrich, *Computing vertex normals from polygonal facets*, 1998). Zero where no face with area touches.
    pub fn vertex_normals(&self) -> Vec<Vector3> {
        let mut sums = vec![Vector3::ZERO; self.vertices().len()];
        for (face, normal) in self.faces().iter().zip(self.face_normals()) {
            let indices = face.indices();
            let n = indices.len();
            for (k, &i) in indices.iter().enumerate() {
                let (before, after) = (indices[(k + n - 1) % n], indices[(k + 1) % n]);
                let here = self.corner(i);
                let angle = (self.corner(before) - here).angle_to(self.corner(after) - here);
                if let (Some(angle), Some(sum)) = (angle, sums.get_mut(i as usize)) {
                    *sum += normal * angle;
                }
            }
        }
        sums.into_iter().map(|v| v.unitized().unwrap_or(Vector3::ZERO)).collect()
    }

    /// The mesh with its vertex normals computed.
    #[must_use]
    pub fn with_normals(mut self) -> Self {
        self.normals = self.vertex_normals();
        self
    }

    /// All triangles: quads cut from first to third corner.
    pub fn triangles(&self) -> impl Iterator<Item = [Point3; 3]> + '_ {
        self.faces().iter().flat_map(|f| f.triangles()).map(|t| t.map(|i| self.corner(i).to_point()))
    }

    /// The area, of quads that of their two triangles.
    pub fn area(&self) -> f64 {
        self.triangles().map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length()).sum()
    }

    /// The area and its centroid; the centroid is `None` without area.
    pub fn area_and_centroid(&self) -> (f64, Option<Point3>) {
        let (mut area, mut moment) = (0.0, Vector3::ZERO);
        for [a, b, c] in self.triangles() {
            let part = 0.5 * (b - a).cross(c - a).length();
            area += part;
            moment += (a.to_vector() + b.to_vector() + c.to_vector()) * (part / 3.0);
        }
        (area, (area > 0.0).then(|| (moment / area).to_point()))
    }

    /// The volume inside a closed mesh, positive when its faces look outwards, and the centroid; `None` without
    /// volume. By signed tetrahedra about the middle of the mesh; for an open mesh the numbers mean nothing.
    pub fn volume_and_centroid(&self) -> (f64, Option<Point3>) {
        let Some(bounds) = self.bounding_box() else { return (0.0, None) };
        let o = bounds.center();
        let (mut volume, mut moment) = (0.0, Vector3::ZERO);
        for [a, b, c] in self.triangles() {
            let (a, b, c) = (a - o, b - o, c - o);
            let part = a.dot(b.cross(c)) / 6.0;
            volume += part;
            moment += (a + b + c) * (part / 4.0);
        }
        (volume, (volume != 0.0).then(|| o + moment / volume))
    }

    /// The volume: see [`Mesh::volume_and_centroid`].
    pub fn volume(&self) -> f64 {
        self.volume_and_centroid().0
    }

    /// The box around the vertices; `None` for a mesh without vertices.
    pub fn bounding_box(&self) -> Option<BoundingBox> {
        BoundingBox::from_points(self.vertices().iter().copied())
    }
}
