use std::collections::HashMap;

use super::{SubDEdge, SubDEdgeTag, SubDFace, SubDSide, SubDVertex, SubDVertexTag, consistency};
use crate::{Error, Point3, Result};

/// A consistent control net.
#[derive(Debug, Clone, PartialEq)]
pub struct SubDNet {
    pub(super) vertices: Vec<SubDVertex>,
    pub(super) edges: Vec<SubDEdge>,
    pub(super) faces: Vec<SubDFace>,
}

impl SubDNet {
    /// The net of these parts.
    ///
    /// # Errors
    /// The first thing that is wrong, with its index: a reference to what is not there, an edge and a face (or a
    /// vertex and an edge, or a vertex and a face) that do not both name each other, a face whose edges do not
    /// join, an identifier that is 0 or taken, or a number that is not finite.
    pub fn from_parts(vertices: Vec<SubDVertex>, edges: Vec<SubDEdge>, faces: Vec<SubDFace>) -> Result<Self> {
        let net = Self { vertices, edges, faces };
        consistency::check(&net).map_err(|why| Error::Invalid { what: "SubD", why })?;
        Ok(net)
    }

    /// The net of polygons over points: boundaries are creases, vertices on them crease vertices, all else smooth.
    /// Identifiers count from 1.
    ///
    /// # Errors
    /// A polygon of fewer than three corners, with a corner twice, or one that is not there; or a point that is not
    /// finite.
    pub fn from_polygons(points: Vec<Point3>, polygons: &[Vec<usize>]) -> Result<Self> {
        let invalid = |why: String| Error::Invalid { what: "SubD", why };
        let vertex = |(i, point): (usize, Point3)| {
            Ok(SubDVertex {
                id: id(i)?,
                tag: SubDVertexTag::Smooth,
                point,
                edges: Vec::new(),
                faces: Vec::new(),
            })
        };
        let mut vertices = points.into_iter().enumerate().map(vertex).collect::<Result<Vec<_>>>()?;
        // Half as many vertices and edges again as faces, each with lists of its own, and a table to find them by.
        crate::cancellation::room::<[u64; 96]>(polygons.len())?;
        let mut edges: Vec<SubDEdge> = Vec::new();
        let mut faces = Vec::with_capacity(polygons.len());
        let mut known: HashMap<[usize; 2], usize> = HashMap::new();
        for (f, polygon) in polygons.iter().enumerate() {
            crate::cancellation::check()?;
            if polygon.len() < 3 {
                return Err(invalid(format!("polygon {f} has {} corners", polygon.len())));
            }
            let mut sides = Vec::with_capacity(polygon.len());
            for (&a, &b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
                if a.max(b) >= vertices.len() || a == b {
                    return Err(invalid(format!("polygon {f} has a side from vertex {a} to {b}")));
                }
                let ends = [a.min(b), a.max(b)];
                let index = *known.entry(ends).or_insert(edges.len());
                if index == edges.len() {
                    edges.push(SubDEdge {
                        id: id(index)?,
                        tag: SubDEdgeTag::Smooth,
                        sharpness: [0.0; 2],
                        sector_coefficients: [0.0; 2],
                        vertices: [a, b],
                        faces: Vec::new(),
                    });
                    vertices[a].edges.push(SubDSide::forward(index));
                    vertices[b].edges.push(SubDSide::backward(index));
                }
                let reversed = edges[index].vertices[0] != a;
                edges[index].faces.push(SubDSide { index: f, reversed });
                sides.push(SubDSide { index, reversed });
                vertices[a].faces.push(f);
            }
            faces.push(SubDFace { id: id(f)?, edges: sides });
        }
        for edge in edges.iter_mut().filter(|edge| edge.faces.len() != 2) {
            edge.tag = SubDEdgeTag::Crease;
            for end in edge.vertices {
                vertices[end].tag = SubDVertexTag::Crease;
            }
        }
        Self::from_parts(vertices, edges, faces)
    }

    /// The vertices.
    pub fn vertices(&self) -> &[SubDVertex] {
        &self.vertices
    }

    /// The edges.
    pub fn edges(&self) -> &[SubDEdge] {
        &self.edges
    }

    /// The edges, for what does not change how parts hang together.
    pub(super) fn edges_mut(&mut self) -> &mut [SubDEdge] {
        &mut self.edges
    }

    /// The faces.
    pub fn faces(&self) -> &[SubDFace] {
        &self.faces
    }

    /// The vertices of a face in order; nothing for an index that is not there.
    pub fn corners(&self, face: usize) -> impl Iterator<Item = usize> {
        let sides = self.faces.get(face).map_or(&[] as &[SubDSide], |face| &face.edges);
        sides.iter().map(|side| self.edges[side.index].vertices[usize::from(side.reversed)])
    }
}

/// The identifier of the part at a place.
fn id(place: usize) -> Result<u32> {
    u32::try_from(place + 1)
        .map_err(|_| Error::Invalid { what: "SubD", why: format!("{place} parts are too many") })
}
