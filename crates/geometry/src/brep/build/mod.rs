//! Breps built vertex by vertex, edge by edge and face by face.

mod ends;

pub(crate) use crate::curve::with_ends;

use super::validity::refusal;
use super::{Brep, CurvePart, Edge, Face, Loop, LoopKind, Parts, Trim, TrimKind, Vertex};
use crate::{Curve, Error, Point3, Result, Surface, cancellation};

/// Gaps up to this part of a loop's size are closed.
const LARGEST_GAP: f64 = 1e-3;

/// A vertex of a brep that is being built.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct NewVertex(pub(super) usize);

/// An edge of a brep that is being built.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct NewEdge(pub(super) usize);

/// A face of a brep that is being built.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct NewFace(pub(super) usize);

/// What a piece of a loop runs along in space.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Along {
    /// An edge, or the edge walked backwards.
    Edge(NewEdge, bool),
    /// A point: the surface is singular there.
    Point(NewVertex),
}

/// A piece of a loop: a curve in the parameter plane of the face's surface (z is 0), and what it is in space.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    /// The curve, x being u and y being v.
    pub curve: Curve,
    /// What it runs along.
    pub along: Along,
}

/// Puts a brep together so that it cannot be inconsistent: parts name each other both ways, flags and tolerances
/// follow from the geometry, and [`Builder::finish`] gives nothing that has a fault.
///
/// ```
/// use katydid_geometry::brep::{Along, Builder, LoopKind, Path};
/// use katydid_geometry::{Circle, Curve, Interval, Plane, PlaneSurface};
/// # fn main() -> katydid_geometry::Result<()> {
/// let circle: Curve = Circle::new(Plane::XY, 2.0)?.into();
/// let range = Interval::new(-2.0, 2.0);
/// let mut builder = Builder::new();
/// let start = builder.vertex(circle.start());
/// let rim = builder.edge(circle.clone(), [start; 2]);
/// let disc = builder.face(PlaneSurface::new(Plane::XY, range, range)?.into(), false);
/// builder.bound(disc, LoopKind::Outer, vec![Path { curve: circle, along: Along::Edge(rim, false) }])?;
/// let disc = builder.finish(1e-3)?;
/// assert!(disc.is_valid() && !disc.is_solid());
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Default)]
pub struct Builder {
    pub(super) parts: Parts,
}

impl Builder {
    /// A builder of a brep that has nothing yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// A builder that goes on with a brep. Its parts keep their places, which are those of [`Builder::known_edge`].
    pub fn from_brep(brep: Brep) -> Self {
        Self { parts: brep.into_parts() }
    }

    /// An edge that the brep of [`Builder::from_brep`] has.
    pub fn known_edge(&self, place: usize) -> Option<NewEdge> {
        (place < self.parts.edges.len()).then_some(NewEdge(place))
    }

    /// A vertex that the brep of [`Builder::from_brep`] has.
    pub fn known_vertex(&self, place: usize) -> Option<NewVertex> {
        (place < self.parts.vertices.len()).then_some(NewVertex(place))
    }

    /// A new vertex.
    pub fn vertex(&mut self, point: Point3) -> NewVertex {
        self.parts.vertices.push(Vertex::new(point, 0.0));
        NewVertex(self.parts.vertices.len() - 1)
    }

    /// A new edge along a curve between two vertices; the same one twice for a closed curve.
    pub fn edge(&mut self, curve: Curve, ends: [NewVertex; 2]) -> NewEdge {
        let place = self.parts.edges.len();
        let part = CurvePart::whole(self.parts.curves_3d.len(), curve.domain());
        self.parts.curves_3d.push(Some(curve));
        for end in ends {
            if let Some(vertex) = self.parts.vertices.get_mut(end.0) {
                vertex.edges.push(place);
            }
        }
        self.parts.edges.push(Edge {
            part,
            vertices: ends.map(|v| Some(v.0)),
            trims: Vec::new(),
            tolerance: 0.0,
            deleted: false,
        });
        NewEdge(place)
    }

    /// A new face on a surface, without loops yet; when reversed its normal is opposite to the surface's.
    pub fn face(&mut self, surface: Surface, reversed: bool) -> NewFace {
        self.parts.faces.push(Face::new(self.parts.surfaces.len(), reversed));
        self.parts.surfaces.push(Some(surface));
        NewFace(self.parts.faces.len() - 1)
    }

    /// Bounds a face by a loop: counter-clockwise in the parameter plane for the outer one, which comes first, and
    /// clockwise for holes. Small gaps between ends of curves are closed.
    ///
    /// # Errors
    /// A face, edge or vertex of another builder, a loop without pieces, a curve out of the parameter plane, or
    /// curves that do not meet: their ends are further apart than a thousandth of the loop's size.
    pub fn bound(&mut self, face: NewFace, kind: LoopKind, paths: Vec<Path>) -> Result<()> {
        self.bound_closing(face, kind, paths, LARGEST_GAP)
    }

    /// [`Builder::bound`] with gaps closed that are up to a part of the loop's size: for edges that lie farther from the
    /// surface, as they do in files.
    ///
    /// # Errors
    /// As [`Builder::bound`].
    pub fn bound_closing(
        &mut self,
        face: NewFace,
        kind: LoopKind,
        mut paths: Vec<Path>,
        largest_gap: f64,
    ) -> Result<()> {
        cancellation::check()?;
        ends::close_gaps(&mut paths, largest_gap)?;
        let in_loop = self.parts.loops.len();
        let owner = self.parts.faces.get_mut(face.0).ok_or_else(|| foreign("face"))?;
        owner.loops.push(in_loop);
        let mut trims = Vec::with_capacity(paths.len());
        for path in paths {
            trims.push(self.trim(path, in_loop)?);
        }
        self.parts.loops.push(Loop { trims, kind, face: Some(face.0), deleted: false });
        Ok(())
    }

    fn trim(&mut self, path: Path, in_loop: usize) -> Result<usize> {
        let place = self.parts.trims.len();
        let (edge, reversed, vertices) = match path.along {
            Along::Edge(edge, reversed) => {
                let own = self.parts.edges.get_mut(edge.0).ok_or_else(|| foreign("edge"))?;
                own.trims.push(place);
                let [start, end] = own.vertices;
                (Some(edge.0), reversed, if reversed { [end, start] } else { [start, end] })
            }
            Along::Point(vertex) => (None, false, [Some(vertex.0); 2]),
        };
        let part = CurvePart::whole(self.parts.curves_2d.len(), path.curve.domain());
        self.parts.curves_2d.push(Some(path.curve));
        self.parts.trims.push(Trim {
            part,
            edge,
            reversed,
            vertices,
            kind: if edge.is_some() { TrimKind::Unknown } else { TrimKind::Singular },
            iso: Default::default(),
            in_loop: Some(in_loop),
            tolerance: [0.0; 2],
            older_tolerances: [0.0; 2],
            deleted: false,
        });
        Ok(place)
    }

    /// The brep, with flags set and the tolerances of edges and vertices measured. A closed one whose faces agree
    /// is turned so that its normals point outwards.
    ///
    /// # Errors
    /// The brep would have faults, which are told from outside, or an edge would be further than `limit` from a trim's image.
    pub fn finish(mut self, limit: f64) -> Result<Brep> {
        // What is looked up on the way takes about as much as what is put together.
        let parts = self.parts.trims.len().saturating_add(self.parts.edges.len());
        cancellation::room::<Trim>(parts)?;
        self.parts.set_kinds();
        self.parts.set_iso();
        self.parts.measure_tolerances();
        cancellation::check_now()?;
        if let Some(edge) = self.parts.edges.iter().find(|e| !(e.tolerance <= limit)) {
            return Err(refusal::of_distance(edge.tolerance));
        }
        let brep = Brep::from_parts(self.parts).map_err(|_| refusal::of_parts())?;
        brep.checked().map(Brep::turned_outward)
    }
}

fn foreign(what: &str) -> Error {
    Error::Invalid { what: "brep", why: format!("a {what} of another builder") }
}

impl Brep {
    /// The brep itself, unless it has faults.
    ///
    /// # Errors
    /// What is wrong, as it looks from outside; [`Brep::faults`] names the parts.
    pub(crate) fn checked(self) -> Result<Self> {
        let faults = self.faults();
        if faults.is_empty() {
            return Ok(self);
        }
        Err(refusal::of_faults(&faults))
    }
}
