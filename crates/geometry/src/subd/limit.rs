//! The surface itself as a mesh: a net is subdivided a few times, then its vertices go to their places on the limit.
//!
//! Rules: Catmull and Clark (1978) inside; creases, corners and darts with weights by sector after Biermann, Levin and
//! Zorin, Piecewise smooth subdivision surfaces with normal control (2000), as Rhino's SubD has them; edges that are sharp
//! for a few subdivisions after DeRose, Kass and Truong, Subdivision surfaces in character animation (1998). Places on the
//! limit after Halstead, Kass and DeRose, Efficient, fair interpolation using Catmull-Clark surfaces (1993).

use std::f64::consts::{PI, TAU};

use katydid_elementary::Elementary;

use super::{SubD, SubDEdgeTag, SubDNet, SubDVertexTag};
use crate::{Mesh, MeshFace, Point3, Result, Vector3};

/// A mesh is not made larger than this; it has fewer levels then.
const MOST_FACES: usize = 4_000_000;
/// The weight of the other end of an edge where nothing special is at this one.
const EVEN: f64 = 0.5;

impl SubD {
    /// How often the finest net is subdivided where the surface is measured by a mesh: seven times, less often where that
    /// makes too many faces.
    pub fn fine_levels(&self) -> u32 {
        const MOST_FACES: usize = 200_000;
        let faces = self.net().faces().len();
        (3..=7).rev().find(|levels| faces.saturating_mul(1 << (2 * levels)) <= MOST_FACES).unwrap_or(2)
    }

    /// The surface as a mesh of quads whose vertices lie on it: its finest net subdivided up to `levels` times, at least
    /// once, and less often where that would be more than four million faces. At darts the vertices are near the surface,
    /// the nearer the more levels. Faces that meet at a crease share its vertices.
    ///
    /// # Errors
    /// The net has no faces, or coordinates that overflow.
    ///
    /// ```
    /// use katydid_geometry::{Point3, subd::{SubD, SubDNet}};
    ///
    /// let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    /// let points = square.map(|(x, y)| Point3::new(x, y, 0.0)).to_vec();
    /// let subd = SubD::new(SubDNet::from_polygons(points, &[vec![0, 1, 2, 3]])?);
    /// assert_eq!(subd.limit_mesh(3)?.faces().len(), 64);
    /// # Ok::<(), katydid_geometry::Error>(())
    /// ```
    pub fn limit_mesh(&self, levels: u32) -> Result<Mesh> {
        let room = |faces: usize| crate::cancellation::room::<[u64; 160]>(faces);
        room(self.net().faces().len())?;
        let mut cage = Cage::of(self.net()).subdivided();
        for _ in 1..levels {
            if cage.faces.len() > MOST_FACES / 4 {
                break;
            }
            room(cage.faces.len())?;
            cage = cage.subdivided();
        }
        cage.on_limit()
    }
}

/// What a vertex does, once edges whose sharpness is used up no longer count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Smooth,
    Dart,
    Crease,
    Corner,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    pub(super) ends: [usize; 2],
    /// The faces on both sides; nothing for a crease.
    pub(super) faces: Option<[usize; 2]>,
    sharpness: [f64; 2],
    /// The weight of the opposite end, at each end.
    weights: [f64; 2],
}

/// A face by its corners; side i joins corner i and the next.
#[derive(Debug, Clone)]
pub(super) struct Face {
    pub(super) corners: Vec<usize>,
    pub(super) sides: Vec<usize>,
}

/// A control net as far as subdivision needs it.
pub(super) struct Cage {
    pub(super) points: Vec<Vector3>,
    pub(super) kinds: Vec<Kind>,
    pub(super) edges: Vec<Edge>,
    pub(super) faces: Vec<Face>,
}

impl Cage {
    pub(super) fn of(net: &SubDNet) -> Self {
        let edge = |edge: &super::SubDEdge| {
            let faces = match edge.faces.as_slice() {
                [a, b] if edge.tag != SubDEdgeTag::Crease => Some([a.index, b.index]),
                _ => None,
            };
            Edge {
                ends: edge.vertices,
                faces,
                sharpness: edge.sharpness.map(|s| s.max(0.0)),
                weights: edge.sector_coefficients,
            }
        };
        let edges: Vec<Edge> = net.edges().iter().map(edge).collect();
        let faces: Vec<Face> = (net.faces().iter().enumerate())
            .map(|(i, face)| Face {
                corners: net.corners(i).collect(),
                sides: face.edges.iter().map(|side| side.index).collect(),
            })
            .collect();
        let kind = |vertex: &super::SubDVertex| {
            let creases = vertex.edges.iter().filter(|side| edges[side.index].faces.is_none()).count();
            match (vertex.tag, creases) {
                (SubDVertexTag::Corner, _) => Kind::Corner,
                (_, 0) => Kind::Smooth,
                (_, 1) => Kind::Dart,
                (_, 2) => Kind::Crease,
                _ => Kind::Corner,
            }
        };
        let kinds = net.vertices().iter().map(kind).collect();
        let points = net.vertices().iter().map(|vertex| vertex.point.to_vector()).collect();
        let mut cage = Self { points, kinds, edges, faces };
        cage.weigh(net);
        cage
    }

    /// Gives the ends of edges that lie on creases, corners and darts their weights where the net does not say.
    fn weigh(&mut self, net: &SubDNet) {
        for (at, vertex) in net.vertices().iter().enumerate() {
            for side in &vertex.edges {
                let end = usize::from(side.reversed);
                let stored = self.edges[side.index].weights[end];
                let is_plain = self.kinds[at] == Kind::Smooth || self.edges[side.index].faces.is_none();
                let weight = if is_plain {
                    EVEN
                } else if stored > 0.0 && stored < 1.0 {
                    1.0 - stored
                } else {
                    0.5 - self.angle(at, vertex, side.index).cosine() / 3.0
                };
                self.edges[side.index].weights[end] = weight;
            }
        }
    }

    /// What the vertices at the ends of an edge do, and the weights of these ends in its middle; nothing for a crease.
    pub(super) fn coefficients(&self, edge: usize) -> Option<([Kind; 2], [f64; 2])> {
        let edge = self.edges.get(edge).filter(|edge| edge.faces.is_some())?;
        Some((edge.ends.map(|end| self.kinds[end]), edge.weights.map(|weight| 1.0 - weight)))
    }

    /// The angle that each face takes of the sector around a vertex that an edge lies in, in the surface's parameters.
    fn angle(&self, at: usize, vertex: &super::SubDVertex, edge: usize) -> f64 {
        let mut sector: Vec<usize> = self.edges[edge].faces.into_iter().flatten().collect();
        // From face to face across the smooth edges that end here.
        loop {
            let joined = vertex.edges.iter().filter_map(|side| self.edges[side.index].faces);
            let new = joined.flat_map(|[a, b]| [(a, b), (b, a)]);
            let mut new = new.filter(|(from, to)| sector.contains(from) && !sector.contains(to));
            let Some((_, to)) = new.next() else { break };
            drop(new);
            sector.push(to);
        }
        let count = sector.len().max(1) as f64;
        match self.kinds[at] {
            Kind::Smooth | Kind::Dart => TAU / count,
            Kind::Crease => PI / count,
            Kind::Corner => sector.iter().map(|face| self.corner_angle(at, *face)).sum::<f64>() / count,
        }
    }

    /// The angle of a face at one of its corners.
    fn corner_angle(&self, at: usize, face: usize) -> f64 {
        let corners = &self.faces[face].corners;
        let Some(i) = corners.iter().position(|corner| *corner == at) else { return 0.0 };
        let n = corners.len();
        let to = |i: usize| self.points[corners[i % n]] - self.points[at];
        let (a, b) = (to(i + 1), to(i + n - 1));
        a.cross(b).length().arctangent_of(a.dot(b))
    }

    /// The cage of four times as many faces: vertices, then a point of each edge, then one of each face.
    pub(super) fn subdivided(&self) -> Self {
        let (vertices, edges) = (self.points.len(), self.edges.len());
        let middles: Vec<Vector3> = self.faces.iter().map(|face| self.middle(face)).collect();
        let mut points = self.moved(&middles);
        points.extend(self.edges.iter().map(|edge| self.edge_point(edge, &middles)));
        points.extend_from_slice(&middles);
        let mut kinds = self.kinds.clone();
        kinds.extend(self.edges.iter().map(|e| if e.faces.is_none() { Kind::Crease } else { Kind::Smooth }));
        kinds.resize(points.len(), Kind::Smooth);

        // Where the first of each face's new faces and inner edges stands.
        let mut first = Vec::with_capacity(self.faces.len());
        let mut count = 0;
        for face in &self.faces {
            first.push(count);
            count += face.sides.len();
        }
        let mut new = Self {
            points,
            kinds,
            edges: Vec::with_capacity(2 * edges + count),
            faces: Vec::with_capacity(count),
        };
        // The new face of a face at a corner.
        let face_at = |face: usize, corner: usize| {
            let place = self.faces[face].corners.iter().position(|c| *c == corner).unwrap_or(0);
            first[face] + place
        };
        for (i, edge) in self.edges.iter().enumerate() {
            let [s, t] = edge.sharpness;
            for (end, sharpness) in [(0, [s, (s + t) / 2.0]), (1, [t, (s + t) / 2.0])] {
                new.edges.push(Edge {
                    ends: [edge.ends[end], vertices + i],
                    faces: edge.faces.map(|faces| faces.map(|face| face_at(face, edge.ends[end]))),
                    sharpness: sharpness.map(|s| (s - 1.0).max(0.0)),
                    weights: [edge.weights[end], EVEN],
                });
            }
        }
        for (f, face) in self.faces.iter().enumerate() {
            let n = face.sides.len();
            for (i, side) in face.sides.iter().enumerate() {
                new.edges.push(Edge {
                    ends: [vertices + edges + f, vertices + side],
                    faces: Some([first[f] + i, first[f] + (i + 1) % n]),
                    sharpness: [0.0; 2],
                    weights: [EVEN; 2],
                });
            }
            for (i, corner) in face.corners.iter().enumerate() {
                let before = (i + n - 1) % n;
                let half = |side: usize| 2 * side + usize::from(self.edges[side].ends[1] == *corner);
                let (to, from) = (face.sides[i], face.sides[before]);
                new.faces.push(Face {
                    corners: vec![*corner, vertices + to, vertices + edges + f, vertices + from],
                    sides: vec![
                        half(to),
                        2 * edges + first[f] + i,
                        2 * edges + first[f] + before,
                        half(from),
                    ],
                });
            }
        }
        new
    }

    fn middle(&self, face: &Face) -> Vector3 {
        let sum = face.corners.iter().fold(Vector3::ZERO, |sum, corner| sum + self.points[*corner]);
        sum / face.corners.len() as f64
    }

    fn edge_point(&self, edge: &Edge, middles: &[Vector3]) -> Vector3 {
        let [a, b] = edge.ends.map(|end| self.points[end]);
        let half = (a + b) / 2.0;
        let Some(faces) = edge.faces else { return half };
        let [s, t] = edge.sharpness;
        let sharpness = ((s + t) / 2.0).min(1.0);
        if sharpness >= 1.0 {
            return half;
        }
        let around = (middles[faces[0]] + middles[faces[1]]) / 2.0;
        let even = (half + around) / 2.0;
        // From a tagged end the point is moved along the edge, by how far the other end's weight is from even.
        let smooth = match edge.ends.map(|end| self.kinds[end] != Kind::Smooth) {
            [true, false] => even + (b - a) * (0.75 * (edge.weights[0] - EVEN)),
            [false, true] => even + (a - b) * (0.75 * (edge.weights[1] - EVEN)),
            _ => even,
        };
        smooth + (half - smooth) * sharpness
    }

    /// The points of the vertices after a subdivision.
    fn moved(&self, middles: &[Vector3]) -> Vec<Vector3> {
        let rings = self.rings();
        let mut faces = vec![(Vector3::ZERO, 0.0); self.points.len()];
        for (face, middle) in self.faces.iter().zip(middles) {
            for corner in &face.corners {
                let (sum, count) = &mut faces[*corner];
                (*sum, *count) = (*sum + *middle, *count + 1.0);
            }
        }
        let moved = |(at, ring): (usize, &Ring)| {
            let point = self.points[at];
            let (sum, count) = faces[at];
            let on_crease = point * 0.75 + ring.creases * 0.125;
            let n = ring.count;
            if n == 0.0 || count == 0.0 {
                return point;
            }
            let smooth = || (point * (n - 2.0) + ring.neighbours / n + sum / count) / n;
            match self.kinds[at] {
                Kind::Corner => point,
                Kind::Crease if ring.sharp > 0.0 => {
                    on_crease + (point - on_crease) * ring.sharpness().min(1.0)
                }
                Kind::Crease => on_crease,
                Kind::Smooth | Kind::Dart => {
                    let smooth = smooth();
                    // Sharp edges count as creases, as far as they are sharp.
                    let creases = ring.sharp + ring.crease_count;
                    let sharp = match creases {
                        c if c < 2.0 => smooth,
                        2.0 => point * 0.75 + (ring.creases + ring.sharp_ends) * 0.125,
                        _ => point,
                    };
                    smooth + (sharp - smooth) * ring.sharpness().min(1.0)
                }
            }
        };
        rings.iter().enumerate().map(moved).collect()
    }

    /// What lies around each vertex along its edges.
    fn rings(&self) -> Vec<Ring> {
        let mut rings = vec![Ring::default(); self.points.len()];
        for edge in &self.edges {
            for (end, [at, other]) in [(0, edge.ends), (1, [edge.ends[1], edge.ends[0]])] {
                let (ring, point) = (&mut rings[at], self.points[other]);
                ring.neighbours += point;
                ring.count += 1.0;
                if edge.faces.is_none() {
                    ring.creases += point;
                    ring.crease_count += 1.0;
                } else if edge.sharpness[end] > 0.0 {
                    ring.sharp_ends += point;
                    ring.sharp += 1.0;
                    ring.total_sharpness += edge.sharpness[end];
                }
            }
        }
        rings
    }

    /// The ends of an edge.
    pub(super) fn ends(&self, edge: usize) -> Option<[usize; 2]> {
        Some(self.edges.get(edge)?.ends)
    }

    /// The places on the limit surface of the vertices of a cage of quads.
    pub(super) fn limit_places(&self) -> Vec<Point3> {
        let rings = self.rings();
        let mut opposite = vec![Vector3::ZERO; self.points.len()];
        for face in &self.faces {
            for (i, corner) in face.corners.iter().enumerate() {
                opposite[*corner] += self.points[face.corners[(i + 2) % 4]];
            }
        }
        let place = |(at, ring): (usize, &Ring)| {
            let (point, n) = (self.points[at], ring.count);
            let place = match self.kinds[at] {
                _ if n == 0.0 => point,
                Kind::Corner => point,
                Kind::Crease => (point * 4.0 + ring.creases) / 6.0,
                Kind::Smooth | Kind::Dart => {
                    (point * (n * n) + ring.neighbours * 4.0 + opposite[at]) / (n * (n + 5.0))
                }
            };
            Point3::ORIGIN + place
        };
        rings.iter().enumerate().map(place).collect()
    }

    /// A cage of quads with its vertices on the limit surface.
    fn on_limit(&self) -> Result<Mesh> {
        let vertices = self.limit_places();
        let index = |i: usize| u32::try_from(i).unwrap_or(u32::MAX);
        let quad = |face: &Face| match *face.corners.as_slice() {
            [a, b, c, d] => Some(MeshFace::Quad([a, b, c, d].map(index))),
            _ => None,
        };
        Mesh::new(vertices, self.faces.iter().filter_map(quad).collect())
    }
}

/// Sums over the edges that end at a vertex.
#[derive(Debug, Clone, Copy, Default)]
struct Ring {
    neighbours: Vector3,
    count: f64,
    creases: Vector3,
    crease_count: f64,
    sharp_ends: Vector3,
    sharp: f64,
    total_sharpness: f64,
}

impl Ring {
    fn sharpness(&self) -> f64 {
        if self.sharp > 0.0 { self.total_sharpness / self.sharp } else { 0.0 }
    }
}
