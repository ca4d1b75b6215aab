//! The surface as a brep of bicubic patches.

use super::SubD;
use super::limit::{Cage, Face, Kind};
use crate::brep::{Along, Builder, LoopKind, NewEdge, NewVertex, Path};
use crate::{
    Brep, Curve, Error, Interval, Line, LineCurve, NurbsCurve, NurbsSurface, Point3, Result, Vector3,
};

/// The most faces.
const MOST: usize = 100_000;
/// The most subdivisions.
const DEEPEST: u32 = 6;

impl SubD {
    /// The surface as a brep of bicubic Bézier patches, one for each face of the net once it has been subdivided, all
    /// joined. Away from creases' ends, corners and vertices with another number of edges than four the patches are the
    /// surface itself; around these they are near it, with common edges, but the normals on both sides of an edge differ
    /// a little (C. Loop and S. Schaefer, *Approximating Catmull-Clark subdivision surfaces with bicubic patches*, 2008).
    /// The net is subdivided until the middles of patches are within the tolerance of the surface.
    ///
    /// # Errors
    /// The tolerance is not above 0, the net has no faces or faces without size, or more than a hundred thousand patches
    /// or six subdivisions would be needed.
    pub fn to_brep(&self, tolerance: f64) -> Result<Brep> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(Error::OutOfRange {
                what: "tolerance",
                value: tolerance,
                must: "finite and greater than 0",
            });
        }
        if self.net().faces().is_empty() {
            return Err(Error::degenerate("SubD", "it has no faces"));
        }
        let mut cage = Cage::of(self.net()).subdivided();
        for _ in 0..DEEPEST {
            if cage.faces.len() > MOST {
                break;
            }
            let next = cage.subdivided();
            let patches = Patches::of(&cage);
            if patches.miss(&next) <= tolerance {
                return patches.joined();
            }
            cage = next;
        }
        Err(Error::Invalid {
            what: "SubD",
            why: format!(
                "more than {MOST} patches or {DEEPEST} subdivisions would be needed within the tolerance"
            ),
        })
    }
}

/// A cage of quads with the places of its vertices on the surface.
struct Patches<'a> {
    cage: &'a Cage,
    limits: Vec<Point3>,
    /// The faces at each vertex.
    around: Vec<Vec<usize>>,
}

impl<'a> Patches<'a> {
    fn of(cage: &'a Cage) -> Self {
        let mut around = vec![Vec::new(); cage.points.len()];
        for (place, face) in cage.faces.iter().enumerate() {
            for corner in &face.corners {
                around[*corner].push(place);
            }
        }
        Self { cage, limits: cage.limit_places(), around }
    }

    /// The corner of a face at a vertex.
    fn corner(face: &Face, vertex: usize) -> usize {
        face.corners.iter().position(|c| *c == vertex).unwrap_or(0)
    }

    /// The valence that the rules take for a vertex as seen from a face: the number of its edges where it is smooth,
    /// elsewhere twice the number of faces between creases.
    fn valence(&self, vertex: usize, face: usize) -> f64 {
        if matches!(self.cage.kinds[vertex], Kind::Smooth | Kind::Dart) {
            return self.around[vertex].len() as f64;
        }
        let mut sector = vec![face];
        let mut next = 0;
        while let Some(&face) = sector.get(next) {
            next += 1;
            let own = &self.cage.faces[face];
            let at = Self::corner(own, vertex);
            for side in [own.sides[at], own.sides[(at + 3) % 4]] {
                let others = self.cage.edges[side].faces.into_iter().flatten();
                let new: Vec<usize> = others.filter(|f| !sector.contains(f)).collect();
                sector.extend(new);
            }
        }
        (2 * sector.len()).max(4) as f64
    }

    /// The control point beside a vertex on an edge.
    fn edge_point(&self, vertex: usize, edge: usize) -> Point3 {
        let own = &self.cage.edges[edge];
        let other = if own.ends[0] == vertex { own.ends[1] } else { own.ends[0] };
        let (v, e) = (self.cage.points[vertex], self.cage.points[other]);
        let straight = ((v * 2.0 + e) / 3.0).to_point();
        // A crease goes on as a cubic of its own; that of a dart ends in a smooth vertex.
        let beside: Vec<usize> = match own.faces {
            Some(faces) => faces.to_vec(),
            None if self.cage.kinds[vertex] == Kind::Dart => self.around[vertex]
                .iter()
                .copied()
                .filter(|f| self.cage.faces[*f].sides.contains(&edge))
                .collect(),
            None => return straight,
        };
        let [first, second] = beside.as_slice() else { return straight };
        let n = self.valence(vertex, *first);
        let mut sum = v * (2.0 * n) + e * 4.0;
        for face in [first, second] {
            let face = &self.cage.faces[*face];
            let at = Self::corner(face, vertex);
            let [next, before] = [face.corners[(at + 1) % 4], face.corners[(at + 3) % 4]];
            let side = if next == other { before } else { next };
            sum += self.cage.points[side] * 2.0 + self.cage.points[face.corners[(at + 2) % 4]];
        }
        (sum / (2.0 * n + 10.0)).to_point()
    }

    /// The inner control point of a face beside one of its corners.
    fn inner_point(&self, face: usize, corner: usize) -> Point3 {
        let own = &self.cage.faces[face];
        let at = |d: usize| self.cage.points[own.corners[(corner + d) % 4]];
        let n = self.valence(own.corners[corner], face);
        ((at(0) * n + (at(1) + at(3)) * 2.0 + at(2)) / (n + 5.0)).to_point()
    }

    /// The control points of a face's patch, u from corner 0 to 1 and v from corner 0 to 3, v running fastest.
    fn patch(&self, face: usize) -> [Point3; 16] {
        let own = &self.cage.faces[face];
        let mut net = [Point3::ORIGIN; 16];
        // Of corner k: where it is in the net, and the steps along the sides that leave and reach it.
        let places: [(usize, isize, isize); 4] = [(0, 4, 1), (12, 1, -4), (15, -4, -1), (3, -1, 4)];
        for (k, (place, along, back)) in places.into_iter().enumerate() {
            let vertex = own.corners[k];
            let at = |steps: isize| place.wrapping_add_signed(steps);
            net[place] = self.limits[vertex];
            net[at(along)] = self.edge_point(vertex, own.sides[k]);
            net[at(back)] = self.edge_point(vertex, own.sides[(k + 3) % 4]);
            net[at(along + back)] = self.inner_point(face, k);
        }
        net
    }

    /// How far the middles of patches are from the surface, whose points the next cage's vertices of faces have.
    fn miss(&self, next: &Cage) -> f64 {
        let limits = next.limit_places();
        let first = self.cage.points.len() + self.cage.edges.len();
        let mut worst = 0.0_f64;
        for face in 0..self.cage.faces.len() {
            let net = self.patch(face);
            // Bernstein's polynomials of degree 3 at a half: 1, 3, 3 and 1 eighths.
            let share = [0.125, 0.375, 0.375, 0.125];
            let middle = (0..16)
                .fold(Vector3::ZERO, |sum, k| sum + net[k].to_vector() * (share[k / 4] * share[k % 4]));
            if let Some(limit) = limits.get(first + face) {
                worst = worst.max(limit.distance_to(middle.to_point()));
            }
        }
        worst
    }

    fn joined(&self) -> Result<Brep> {
        let mut builder = Builder::new();
        let vertices: Vec<NewVertex> = self.limits.iter().map(|p| builder.vertex(*p)).collect();
        let mut edges: Vec<Option<NewEdge>> = vec![None; self.cage.edges.len()];
        for face in 0..self.cage.faces.len() {
            self.add_face(face, &mut builder, &vertices, &mut edges)?;
        }
        builder.finish(f64::INFINITY)
    }

    fn add_face(
        &self,
        face: usize,
        builder: &mut Builder,
        vertices: &[NewVertex],
        edges: &mut [Option<NewEdge>],
    ) -> Result<()> {
        let own = &self.cage.faces[face];
        let surface = NurbsSurface::bezier([4, 4], &self.patch(face))?;
        let flat = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(u, v)| Point3::new(u, v, 0.0));
        let mut paths = Vec::with_capacity(4);
        for k in 0..4 {
            let (side, from) = (own.sides[k], own.corners[k]);
            let ends = self.cage.edges[side].ends;
            let edge = match edges[side] {
                Some(known) => known,
                None => {
                    let [a, b] = ends;
                    let points =
                        [self.limits[a], self.edge_point(a, side), self.edge_point(b, side), self.limits[b]];
                    let curve: Curve = NurbsCurve::bezier(&points)?.into();
                    *edges[side].insert(builder.edge(curve, [vertices[a], vertices[b]]))
                }
            };
            let line = Line::new(flat[k], flat[(k + 1) % 4]);
            let curve = LineCurve { line, domain: Interval::UNIT }.into();
            paths.push(Path { curve, along: Along::Edge(edge, ends[0] != from) });
        }
        let face = builder.face(surface.into(), false);
        builder.bound(face, LoopKind::Outer, paths)
    }
}

#[cfg(test)]
mod tests {
    use crate::subd::{FromMesh, MultiPipe, MultiPipeCap, MultiPipeNetwork, SubD, SubDEdgeTag, SubDNet};
    use crate::{Box3, Interval, Mesh, MeshFace, Plane, Point3};

    fn block(creases: bool, count: usize) -> SubD {
        let side = Interval::new(-1.0, 1.0);
        let shape = Box3 { plane: Plane::XY, x: side, y: side, z: side };
        SubD::new(SubDNet::of_box(&shape, count, creases).unwrap())
    }

    /// Every point of a fine mesh of the surface lies on the brep.
    fn check_near(subd: &SubD, tolerance: f64) -> crate::Brep {
        let brep = subd.to_brep(tolerance).unwrap();
        assert_eq!(brep.faults(), []);
        let closest = crate::brep::ClosestOnBrep::new(std::sync::Arc::new(brep.clone())).unwrap();
        for p in subd.limit_mesh(4).unwrap().vertices().iter().step_by(7) {
            let apart = closest.nearest(*p).unwrap().point.distance_to(*p);
            assert!(apart <= 3.0 * tolerance, "{apart}");
        }
        brep
    }

    #[test]
    fn a_rounded_box() {
        let round = block(false, 1);
        let brep = check_near(&round, 1e-3);
        assert!(brep.is_solid());
        let (mesh, exact) =
            (round.limit_mesh(6).unwrap().volume(), brep.volume_properties(1e-6, || true).unwrap());
        assert!((exact.amount / mesh - 1.0).abs() < 2e-3, "{} {mesh}", exact.amount);
    }

    #[test]
    fn sharp_boxes_stay_boxes() {
        let brep = check_near(&block(true, 2), 1e-6);
        assert!(brep.is_solid());
        let volume = brep.volume_properties(1e-9, || true).unwrap().amount;
        assert!((volume - 8.0).abs() < 1e-9, "{volume}");
    }

    /// A regular net over a plane grid with heights of a paraboloid: C-C is the uniform cubic spline, whose points over
    /// the vertices are those of the paraboloid plus a third for each direction's second difference of 2: 1/3 each.
    #[test]
    fn regular_nets_are_exact() {
        let n = 8_u32;
        let at = |i: u32, j: u32| Point3::new(f64::from(i), f64::from(j), f64::from(i * i + j * j));
        let points: Vec<Point3> =
            (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j))).map(|(i, j)| at(i, j)).collect();
        let quad = |i: u32, j: u32| {
            MeshFace::Quad([
                i * (n + 1) + j,
                (i + 1) * (n + 1) + j,
                (i + 1) * (n + 1) + j + 1,
                i * (n + 1) + j + 1,
            ])
        };
        let faces = (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).map(|(i, j)| quad(i, j)).collect();
        let net = SubDNet::from_mesh(
            &Mesh::new(points, faces).unwrap(),
            &FromMesh { corners: true, ..FromMesh::default() },
        )
        .unwrap();
        let brep = SubD::new(net).to_brep(1e-9).unwrap();
        assert_eq!((brep.faces().len(), brep.is_solid()), (256, false));
        // Uniform cubic splines give parabolas back, 1/3 higher for each direction.
        for face in 0..brep.faces().len() {
            let p = brep.face_surface(face).unwrap().point_at(0.3, 0.6);
            let inside = [p.x, p.y].iter().all(|x| *x > 2.0 && *x < 6.0);
            let wanted = p.x * p.x + p.y * p.y + 2.0 / 3.0;
            assert!(!inside || (p.z - wanted).abs() < 1e-9, "{p:?} {wanted}");
        }
    }

    #[test]
    fn creases_darts_and_pipes() {
        let net = block(false, 2).net().clone();
        let some: Vec<usize> = vec![0, 5, 6, 11];
        let creased = SubD::new(net.with_edge_tag(&some, SubDEdgeTag::Crease).unwrap());
        assert!(creased.to_brep(0.01).unwrap().is_solid());
        let p = |x: f64, y: f64, z: f64| Point3::new(x, y, z);
        let lines = [p(5.0, 0.0, 0.0), p(0.0, 5.0, 0.0), p(0.0, 0.0, 5.0), p(-3.0, -3.0, -3.0)];
        let star = MultiPipeNetwork::of_lines(&lines.map(|q| [Point3::ORIGIN, q]), 1e-3).unwrap();
        for caps in [MultiPipeCap::Open, MultiPipeCap::Round, MultiPipeCap::Flat] {
            let pipe = MultiPipe { caps, radii: vec![0.4], ..MultiPipe::default() };
            let brep = SubD::new(pipe.around(&star).unwrap()).to_brep(0.01).unwrap();
            assert_eq!(brep.is_solid(), caps != MultiPipeCap::Open);
        }
        assert!(block(false, 1).to_brep(0.0).is_err() && block(false, 1).to_brep(1e-14).is_err());
    }
}
