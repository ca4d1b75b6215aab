//! Vertices, edges and faces of shells, by place.

use std::collections::HashMap;

use super::place::Space;
use super::support::Support;
use crate::{Error, Result};
use katydid_geometry::{BoundingBox, Curve, Line, LineCurve, Point3};

/// An edge walked along or against.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Use {
    pub(super) edge: usize,
    pub(super) reversed: bool,
}

pub(super) struct Edge {
    pub(super) curve: Curve,
    pub(super) vertices: [usize; 2],
}

pub(super) struct Face {
    pub(super) id: u64,
    pub(super) support: Support,
    /// Its loops, with the face to the left seen against the support's normal.
    pub(super) loops: Vec<Vec<Use>>,
    /// Whether its normal is opposite to the support's.
    pub(super) reversed: bool,
}

/// The parts of shells.
#[derive(Default)]
pub(super) struct Topology {
    pub(super) points: Vec<Point3>,
    pub(super) edges: Vec<Edge>,
    pub(super) faces: Vec<Face>,
    known_vertices: HashMap<u64, usize>,
    known_edges: HashMap<u64, Option<usize>>,
    known_sides: HashMap<(u64, u64), usize>,
}

impl Topology {
    pub(super) fn edge(&self, place: usize) -> Result<&Edge> {
        let why =
            katydid_geometry::Error::Degenerate { what: "loop", why: "it names an edge that is not there" };
        self.edges.get(place).ok_or_else(|| why.into())
    }

    /// Adds the faces of a shell, turned over if wanted.
    pub(super) fn add_shell(&mut self, space: &Space<'_>, id: u64, turned: bool) -> Result<()> {
        let record = space.file.record(id)?;
        match record.keyword {
            "ORIENTED_CLOSED_SHELL" | "ORIENTED_OPEN_SHELL" => {
                let inner = space.file.record(record.reference(2)?)?;
                if inner.keyword.starts_with("ORIENTED") {
                    return Err(record.refuse("an oriented shell of an oriented shell"));
                }
                self.add_shell(space, inner.id, turned == record.flag(3)?)
            }
            "CLOSED_SHELL" | "OPEN_SHELL" | "CONNECTED_FACE_SET" => {
                for face in record.references(1)? {
                    self.add_face(space, face, turned, 0)?;
                }
                Ok(())
            }
            _ => Err(record.refuse("it is no shell")),
        }
    }

    pub(super) fn add_face(&mut self, space: &Space<'_>, id: u64, turned: bool, depth: usize) -> Result<()> {
        let record = space.file.record(id)?;
        match record.keyword {
            "ADVANCED_FACE" | "FACE_SURFACE" => {}
            "ORIENTED_FACE" if depth == 0 => {
                return self.add_face(space, record.reference(2)?, turned == record.flag(3)?, 1);
            }
            _ => return Err(record.refuse("faces of this type are not supported")),
        }
        let same = record.flag(3)?;
        let mut loops = Vec::new();
        for bound in record.references(1)? {
            let bound = space.file.record(bound)?;
            let mut uses = self.uses(space, bound.reference(1)?)?;
            if bound.flag(2)? != same {
                uses.reverse();
                uses.iter_mut().for_each(|one| one.reversed = !one.reversed);
            }
            if !uses.is_empty() {
                loops.push(uses);
            }
        }
        let edges = loops.iter().flatten().filter_map(|one| self.edges.get(one.edge));
        let hull = edges.map(|edge| edge.curve.bounding_box()).reduce(|a, b| BoundingBox::union(&a, &b));
        let support = space.support(record.reference(2)?, hull, 0)?;
        self.faces.push(Face { id, support, loops, reversed: same == turned });
        Ok(())
    }

    /// The edges of a loop; none of one that is a vertex.
    fn uses(&mut self, space: &Space<'_>, id: u64) -> Result<Vec<Use>> {
        let record = space.file.record(id)?;
        let mut uses = Vec::new();
        match record.keyword {
            "VERTEX_LOOP" => {}
            "EDGE_LOOP" => {
                for oriented in record.references(1)? {
                    let oriented = space.file.record(oriented)?;
                    if oriented.keyword != "ORIENTED_EDGE" {
                        return Err(oriented.refuse("it is no edge of a loop"));
                    }
                    let forward = oriented.flag(4)?;
                    if let Some(edge) = self.edge_of(space, oriented.reference(3)?)? {
                        uses.push(Use { edge, reversed: !forward });
                    }
                }
            }
            "POLY_LOOP" => {
                let points = record.references(1)?;
                let next = points.iter().cycle().skip(1);
                for (a, b) in points.iter().zip(next) {
                    uses.extend(self.side(space, *a, *b)?);
                }
            }
            _ => return Err(record.refuse("loops of this type are not supported")),
        }
        Ok(uses)
    }

    fn vertex(&mut self, space: &Space<'_>, id: u64, point: u64) -> Result<usize> {
        if let Some(place) = self.known_vertices.get(&id) {
            return Ok(*place);
        }
        self.points.push(space.point(point)?);
        self.known_vertices.insert(id, self.points.len() - 1);
        Ok(self.points.len() - 1)
    }

    /// The straight edge between two points of a polygon.
    fn side(&mut self, space: &Space<'_>, a: u64, b: u64) -> Result<Option<Use>> {
        let key = (a.min(b), a.max(b));
        if let Some(edge) = self.known_sides.get(&key) {
            return Ok(Some(Use { edge: *edge, reversed: a != key.0 }));
        }
        let vertices = [self.vertex(space, key.0, key.0)?, self.vertex(space, key.1, key.1)?];
        let line = Line::new(self.points[vertices[0]], self.points[vertices[1]]);
        if line.length() == 0.0 {
            return Ok(None);
        }
        self.edges.push(Edge { curve: LineCurve::new(line).into(), vertices });
        self.known_sides.insert(key, self.edges.len() - 1);
        Ok(Some(Use { edge: self.edges.len() - 1, reversed: a != key.0 }))
    }

    /// The place of an edge; none for one without length.
    fn edge_of(&mut self, space: &Space<'_>, id: u64) -> Result<Option<usize>> {
        if let Some(known) = self.known_edges.get(&id) {
            return Ok(*known);
        }
        let record = space.file.record(id)?;
        if record.keyword != "EDGE_CURVE" {
            return Err(record.refuse("edges of this type are not supported"));
        }
        let mut vertices = [0; 2];
        for (place, vertex) in vertices.iter_mut().enumerate() {
            let vertex_record = space.file.record(record.reference(place + 1)?)?;
            if vertex_record.keyword != "VERTEX_POINT" {
                return Err(vertex_record.refuse("vertices of this type are not supported"));
            }
            *vertex = self.vertex(space, vertex_record.id, vertex_record.reference(1)?)?;
        }
        let ends = vertices.map(|vertex| self.points[vertex]);
        let carrier = space.carrier(record.reference(3)?, 0)?;
        let same = record.flag(4)?;
        let known = match carrier.between(ends, same, space.tolerance) {
            Ok(curve) => {
                let size = curve.bounding_box().diagonal().length();
                let is_long =
                    size > 1e-9 * (1.0 + ends[0].to_vector().length()) || vertices[0] != vertices[1];
                is_long.then_some(curve)
            }
            // A line from a point to itself.
            Err(_) if vertices[0] == vertices[1] => None,
            Err(error) => return Err(record.refuse(error)),
        };
        let place = known.map(|curve| {
            self.edges.push(Edge { curve, vertices });
            self.edges.len() - 1
        });
        self.known_edges.insert(id, place);
        Ok(place)
    }

    /// Takes the faces without loops out, which are whole surfaces.
    pub(super) fn take_whole(&mut self) -> Vec<Face> {
        let (whole, bounded) =
            std::mem::take(&mut self.faces).into_iter().partition(|f: &Face| f.loops.is_empty());
        self.faces = bounded;
        whole
    }

    /// Divides an edge at a point in all loops; gives the faces that have it.
    pub(super) fn split(&mut self, place: usize, at: Point3) -> Result<Vec<usize>> {
        let edge = self.edge(place)?;
        let domain = edge.curve.domain();
        let t = edge.curve.closest_point(at)?.parameter;
        let [a, b] = edge.vertices;
        let slack = 1e-9 * domain.length();
        if t <= domain.start + slack || t >= domain.end - slack {
            let why = format!("an edge cannot be divided at parameter {t}");
            return Err(katydid_geometry::Error::Invalid { what: "loop", why }.into());
        }
        let first = edge.curve.trimmed(katydid_geometry::Interval::new(domain.start, t))?;
        let second = edge.curve.trimmed(katydid_geometry::Interval::new(t, domain.end))?;
        self.points.push(second.start());
        let middle = self.points.len() - 1;
        let new = self.edges.len();
        self.edges[place] = Edge { curve: first, vertices: [a, middle] };
        self.edges.push(Edge { curve: second, vertices: [middle, b] });
        let mut touched = Vec::new();
        for (k, face) in self.faces.iter_mut().enumerate() {
            if !face.loops.iter().flatten().any(|one| one.edge == place) {
                continue;
            }
            touched.push(k);
            for uses in &mut face.loops {
                let parts = |one: Use| match (one.edge == place, one.reversed) {
                    (false, _) => vec![one],
                    (true, false) => vec![one, Use { edge: new, ..one }],
                    (true, true) => vec![Use { edge: new, ..one }, one],
                };
                *uses = uses.iter().flat_map(|one| parts(*one)).collect();
            }
        }
        Ok(touched)
    }
}

impl From<&Topology> for Option<BoundingBox> {
    fn from(topology: &Topology) -> Self {
        topology.edges.iter().map(|edge| edge.curve.bounding_box()).reduce(|a, b| a.union(&b))
    }
}

/// The error of a shell without faces.
pub(super) fn no_faces(id: u64) -> Error {
    Error::entity(id, "it has no faces")
}
