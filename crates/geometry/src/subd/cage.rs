//! Control nets made and changed: from meshes, of boxes, with other tags.

use std::collections::HashMap;

use super::{SubDEdge, SubDEdgeTag, SubDNet, SubDVertex, SubDVertexTag};
use crate::{Box3, Error, Mesh, MeshFace, Point3, Result};

/// Which edges of a mesh become creases, and which vertices corners.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct FromMesh {
    /// Whether edges where the mesh is not welded, so that two faces have vertices of their own in one place, become
    /// creases. Borders always are.
    pub creases: bool,
    /// Whether vertices on the border of a single face become corners.
    pub corners: bool,
}

impl SubDNet {
    /// The net whose vertices and faces are those of a mesh; vertices in exactly one place become one. Faces lose sides
    /// without length; those with fewer than three sides left, or with a place that they use twice, are left out.
    ///
    /// # Errors
    /// The mesh has no faces with three corners.
    pub fn from_mesh(mesh: &Mesh, options: &FromMesh) -> Result<Self> {
        if mesh.faces().is_empty() {
            return Err(Error::degenerate("mesh", "it has no faces"));
        }
        let merged = mesh.merged_indices();
        let mut place_of: HashMap<u32, usize> = HashMap::new();
        let mut points = Vec::new();
        let mut polygons = Vec::with_capacity(mesh.faces().len());
        // For each edge of the merged mesh the vertices of the mesh at its ends, face by face.
        let mut ends: HashMap<[usize; 2], Vec<[u32; 2]>> = HashMap::new();
        for face in mesh.faces() {
            crate::cancellation::check()?;
            // A side without length, as at the poles of a sphere, is none.
            let root = |i: u32| merged.get(i as usize).copied().unwrap_or(i);
            let mut corners: Vec<u32> = face.indices().to_vec();
            corners.dedup_by_key(|i| root(*i));
            if corners.len() > 1 && corners.first().map(|i| root(*i)) == corners.last().map(|i| root(*i)) {
                corners.pop();
            }
            let mut different: Vec<u32> = corners.iter().map(|i| root(*i)).collect();
            different.sort_unstable();
            different.dedup();
            if different.len() < 3 || different.len() < corners.len() {
                continue;
            }
            let mut polygon: Vec<(usize, u32)> = Vec::with_capacity(4);
            for i in corners {
                let root = root(i);
                let place = *place_of.entry(root).or_insert_with(|| {
                    points.extend(mesh.vertices().get(root as usize).copied());
                    points.len() - 1
                });
                polygon.push((place, i));
            }
            for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
                let (low, high) = if a.0 < b.0 { (a, b) } else { (b, a) };
                ends.entry([low.0, high.0]).or_default().push([low.1, high.1]);
            }
            polygons.push(polygon.into_iter().map(|p| p.0).collect());
        }
        if polygons.is_empty() {
            return Err(Error::degenerate("mesh", "none of its faces has three corners"));
        }
        let mut net = Self::from_polygons(points, &polygons)?;
        if options.creases {
            let split: Vec<usize> = (net.edges.iter().enumerate())
                .filter(|(_, edge)| {
                    let [a, b] = edge.vertices;
                    let sides = ends.get(&[a.min(b), a.max(b)]);
                    sides.is_some_and(|sides| sides.windows(2).any(|w| w.first() != w.last()))
                })
                .map(|(place, _)| place)
                .collect();
            net = net.with_edge_tag(&split, SubDEdgeTag::Crease)?;
        }
        if options.corners {
            let corners: Vec<usize> = (net.vertices.iter().enumerate())
                .filter(|(_, vertex)| vertex.faces.len() == 1)
                .map(|(place, _)| place)
                .collect();
            net = net.with_vertex_tag(&corners, SubDVertexTag::Corner)?;
        }
        Ok(net)
    }

    /// The net of the surface of a box with `count` by `count` quads on each side, turned outward; with creases its
    /// twelve edges are sharp and its eight corners are corners.
    ///
    /// # Errors
    /// The box is flat or not finite, or there are no quads or more than 1,000 along an edge.
    pub fn of_box(shape: &Box3, count: usize, creases: bool) -> Result<Self> {
        if !(1..=1_000).contains(&count) {
            return Err(Error::OutOfRange {
                what: "quads along an edge",
                value: count as f64,
                must: "1 to 1,000",
            });
        }
        let sides = Mesh::cuboid(shape, count, count, count)?;
        Self::from_mesh(&sides, &FromMesh { creases, corners: false })
    }

    /// The net with another tag on some edges. The tags of vertices follow: one crease ends in a dart, two go through,
    /// more meet in a corner; corners stay. Borders and edges of more than two faces stay creases.
    ///
    /// # Errors
    /// An edge does not exist.
    pub fn with_edge_tag(mut self, edges: &[usize], tag: SubDEdgeTag) -> Result<Self> {
        let mut touched = Vec::new();
        for &place in edges {
            let edge = self.edges.get_mut(place).ok_or_else(|| none("edge", place))?;
            if edge.faces.len() == 2 {
                edge.tag = tag;
                edge.sector_coefficients = [0.0; 2];
            }
            touched.extend(edge.vertices);
        }
        for place in touched {
            self.retag(place);
        }
        self.checked()
    }

    /// The net with another tag on some vertices. A vertex without creases cannot be a crease or a dart: it stays as
    /// it is.
    ///
    /// # Errors
    /// A vertex does not exist.
    pub fn with_vertex_tag(mut self, vertices: &[usize], tag: SubDVertexTag) -> Result<Self> {
        for &place in vertices {
            let creases = self.creases_at(place);
            let vertex = self.vertices.get_mut(place).ok_or_else(|| none("vertex", place))?;
            vertex.tag = match (tag, creases) {
                (SubDVertexTag::Crease, n) if n != 2 => vertex.tag,
                (SubDVertexTag::Dart, n) if n != 1 => vertex.tag,
                (SubDVertexTag::Smooth, n) if n > 0 => vertex.tag,
                (tag, _) => tag,
            };
            let ends: Vec<usize> = vertex.edges.iter().map(|side| side.index).collect();
            for edge in ends {
                if let Some(edge) = self.edges.get_mut(edge) {
                    edge.sector_coefficients = [0.0; 2];
                }
            }
        }
        self.checked()
    }

    fn creases_at(&self, vertex: usize) -> usize {
        let ends = self.vertices.get(vertex).map_or(&[] as &[super::SubDSide], |v| &v.edges);
        let tags = ends.iter().filter_map(|side| self.edges.get(side.index));
        tags.filter(|edge| edge.tag == SubDEdgeTag::Crease).count()
    }

    fn retag(&mut self, place: usize) {
        let creases = self.creases_at(place);
        let Some(vertex) = self.vertices.get_mut(place) else { return };
        if vertex.tag == SubDVertexTag::Corner && creases > 0 {
            return;
        }
        vertex.tag = match creases {
            0 => SubDVertexTag::Smooth,
            1 => SubDVertexTag::Dart,
            2 => SubDVertexTag::Crease,
            _ => SubDVertexTag::Corner,
        };
    }

    fn checked(self) -> Result<Self> {
        Self::from_parts(self.vertices, self.edges, self.faces)
    }

    /// The net itself as a mesh. Faces of more than four corners become triangles around their middle.
    ///
    /// # Errors
    /// There are more vertices than a mesh has numbers.
    pub fn to_mesh(&self) -> Result<Mesh> {
        let mut points: Vec<Point3> = self.vertices.iter().map(|v: &SubDVertex| v.point).collect();
        let mut faces = Vec::with_capacity(self.faces.len());
        let number = |i: usize| {
            u32::try_from(i)
                .map_err(|_| Error::Invalid { what: "mesh", why: "it has too many vertices".into() })
        };
        for face in 0..self.faces.len() {
            let corners = self.corners(face).map(number).collect::<Result<Vec<u32>>>()?;
            match *corners.as_slice() {
                [a, b, c] => faces.push(MeshFace::Triangle([a, b, c])),
                [a, b, c, d] => faces.push(MeshFace::Quad([a, b, c, d])),
                _ => {
                    let middle = number(points.len())?;
                    points.push(self.face_middle(face));
                    let next = corners.iter().cycle().skip(1);
                    faces.extend(corners.iter().zip(next).map(|(a, b)| MeshFace::Triangle([*a, *b, middle])));
                }
            }
        }
        Mesh::new(points, faces)
    }

    /// The mean of a face's corners.
    pub fn face_middle(&self, face: usize) -> Point3 {
        let (mut sum, mut count) = (crate::Vector3::ZERO, 0.0);
        for corner in self.corners(face) {
            sum += self.vertices.get(corner).map_or(crate::Vector3::ZERO, |v| v.point.to_vector());
            count += 1.0;
        }
        if count > 0.0 { (sum / count).to_point() } else { Point3::ORIGIN }
    }

    /// Where an edge is; `None` for one that is not there.
    pub fn edge_line(&self, edge: usize) -> Option<crate::Line> {
        let edge: &SubDEdge = self.edges.get(edge)?;
        let [a, b] = edge.vertices.map(|v| self.vertices.get(v).map(|v| v.point));
        Some(crate::Line::new(a?, b?))
    }
}

fn none(what: &'static str, place: usize) -> Error {
    Error::Invalid { what: "SubD", why: format!("there is no {what} {place}") }
}

#[cfg(test)]
mod tests {
    use super::FromMesh;
    use crate::subd::{SubD, SubDEdgeTag, SubDNet, SubDVertexTag};
    use crate::{Box3, Interval, Mesh, Plane};

    fn block() -> Box3 {
        let side = Interval::new(-1.0, 1.0);
        Box3 { plane: Plane::XY, x: side, y: side, z: side }
    }

    #[test]
    fn boxes() {
        let round = SubDNet::of_box(&block(), 1, false).unwrap();
        assert_eq!((round.vertices().len(), round.edges().len(), round.faces().len()), (8, 12, 6));
        assert!(round.edges().iter().all(|e| e.tag == SubDEdgeTag::Smooth));
        // By Halstead, Kass and DeRose a corner of a cube, of valence 3, goes to (9 v + 4 Σ e + Σ f) / 24 = v / 2.
        let limit = SubD::new(round.clone()).limit_mesh(3).unwrap();
        let corner = crate::Point3::new(0.5, 0.5, 0.5);
        assert!(limit.vertices().iter().any(|p| p.distance_to(corner) < 1e-9));
        let mesh = round.to_mesh().unwrap();
        assert!(mesh.is_closed() && (mesh.volume() - 8.0).abs() < 1e-12);
        let sharp = SubDNet::of_box(&block(), 2, true).unwrap();
        assert_eq!(sharp.faces().len(), 24);
        assert_eq!(sharp.edges().iter().filter(|e| e.tag == SubDEdgeTag::Crease).count(), 24);
        assert_eq!(sharp.vertices().iter().filter(|v| v.tag == SubDVertexTag::Corner).count(), 8);
        // With all edges creases and all corners corners the surface is the box.
        let same = SubD::new(sharp).limit_mesh(3).unwrap();
        assert!((same.volume() - 8.0).abs() < 1e-9 && same.is_closed());
        assert!(SubDNet::of_box(&block(), 0, true).is_err());
    }

    #[test]
    fn tags_follow() {
        let net = SubDNet::of_box(&block(), 1, false).unwrap();
        let net = net.with_edge_tag(&[0], SubDEdgeTag::Crease).unwrap();
        let darts = net.vertices().iter().filter(|v| v.tag == SubDVertexTag::Dart).count();
        assert_eq!(darts, 2);
        let net = net.with_edge_tag(&[0], SubDEdgeTag::Smooth).unwrap();
        assert!(net.vertices().iter().all(|v| v.tag == SubDVertexTag::Smooth));
        assert!(net.clone().with_edge_tag(&[99], SubDEdgeTag::Smooth).is_err());
        let net = net.with_vertex_tag(&[3], SubDVertexTag::Corner).unwrap();
        assert_eq!(net.vertices()[3].tag, SubDVertexTag::Corner);
        let at = net.vertices()[3].point;
        let limit = SubD::new(net).limit_mesh(2).unwrap();
        assert!(limit.vertices().iter().any(|p| p.distance_to(at) < 1e-12));
    }

    #[test]
    fn sheets_have_corners() {
        let flat =
            crate::Rectangle { plane: Plane::XY, x: Interval::new(0.0, 4.0), y: Interval::new(0.0, 2.0) };
        let mesh = Mesh::plane(&flat, 4, 2).unwrap();
        let net = SubDNet::from_mesh(&mesh, &FromMesh { creases: true, corners: true }).unwrap();
        assert_eq!(net.vertices().iter().filter(|v| v.tag == SubDVertexTag::Corner).count(), 4);
        let limit = SubD::new(net).limit_mesh(2).unwrap();
        assert!((limit.area() - 8.0).abs() < 1e-9);
        assert!(SubDNet::from_mesh(&Mesh::default(), &FromMesh::default()).is_err());
    }
}
