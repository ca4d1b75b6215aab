//! Meshes made anew of triangles of about one size.

mod imprint;
mod net;
mod quads;
mod seams;
mod target;

use super::{Mesh, MeshFace};
use crate::cancellation::check_now;
use crate::mesh::polygon::polygon_faces;
use crate::{Error, Line, Point3, Result};
use net::Net;
pub use quads::{GuideKind, QuadOptions};
use target::Target;

/// What [`Mesh::remeshed`] shall reach.
#[derive(Debug, Clone, PartialEq)]
pub struct RemeshOptions {
    /// The length of all edges, about; greater than 0.
    pub length: f64,
    /// How often edges are split, collapsed and flipped and vertices smoothed, one after the other.
    pub iterations: usize,
    /// Edges where faces meet at more than this angle between their normals, in radians, stay edges.
    pub crease: Option<f64>,
    /// Places where the mesh shall have a vertex: the nearest is moved there.
    pub points: Vec<Point3>,
    /// The most faces that there may be on the way.
    pub limit: usize,
}

/// A mesh of triangles of about one size.
#[derive(Debug, Clone, PartialEq)]
pub struct Remeshed {
    /// The triangles.
    pub mesh: Mesh,
    /// The edges that stayed because faces meet there at an angle.
    pub creases: Vec<Line>,
}

impl Mesh {
    /// The same shape in triangles whose edges are all about as long as wanted.
    ///
    /// M. Botsch, L. Kobbelt, *A remeshing approach to multiresolution modeling*, 2004: edges longer than 4/3 of the
    /// length are split, those shorter than 4/5 collapsed, others flipped where that brings the numbers of edges at
    /// vertices nearer to six (four at the border), and vertices moved to the middle of their neighbours along the
    /// surface, then pulled to it: to `target`, or to this mesh as it was. Borders, and creases if wanted, keep their
    /// places: their vertices move only along them. Vertices in one place count as one.
    ///
    /// # Errors
    /// The length is not greater than 0 and finite, the mesh has no faces with an area, or it would take more than
    /// `limit` faces.
    pub fn remeshed(&self, options: &RemeshOptions, target: Option<&Self>) -> Result<Remeshed> {
        let length = options.length;
        if !(length > 0.0 && length.is_finite()) {
            let must = "finite and greater than 0";
            return Err(Error::OutOfRange { what: "edge length", value: length, must });
        }
        // An equilateral triangle has √3/4 times the square of its side.
        let expected = self.area() / (0.25 * 3.0_f64.sqrt() * length * length);
        if !(expected <= options.limit as f64) {
            return Err(too_many());
        }
        let mut net = Net::new(self, options.crease)?;
        let own = Target::new(self, net.lines())?;
        let other = target.map(|t| Target::new(t, Vec::new())).transpose()?;
        let surface = other.as_ref().unwrap_or(&own);
        for _ in 0..options.iterations {
            net.split_long(|_| 4.0 / 3.0 * length, options.limit)?;
            net.collapse_short(|_| 4.0 / 5.0 * length, |_| 4.0 / 3.0 * length);
            net.flip();
            net.smooth(|p| surface.nearest(p), |p| own.nearest_on_line(p));
            for &p in options.points.iter().filter(|p| p.is_finite()) {
                check_now()?;
                net.pull_nearest_to(p);
            }
            check_now()?;
        }
        net.finish()
    }

    /// The dual: a vertex in the middle of every face, and around every vertex inside the mesh a face, in triangles and
    /// quads where it has more than four corners. Vertices on the border have none.
    ///
    /// # Errors
    /// More faces than an index can count.
    pub fn dual(&self) -> Result<Self> {
        let merged = self.merged_indices();
        let corner = |i: u32| merged.get(i as usize).copied().unwrap_or(i);
        // At every vertex the faces with the corners before and after.
        let mut around: Vec<Vec<[u32; 3]>> = vec![Vec::new(); self.vertices().len()];
        for (face, f) in self.faces().iter().zip(0..) {
            let ring: Vec<u32> = face.indices().iter().map(|&i| corner(i)).collect();
            let n = ring.len();
            for k in 0..n {
                if let Some(list) = around.get_mut(ring[k] as usize) {
                    list.push([ring[(k + 1) % n], f, ring[(k + n - 1) % n]]);
                }
            }
        }
        let mut faces: Vec<MeshFace> = Vec::new();
        let mut ring = Vec::new();
        for wedges in &around {
            ring.clear();
            let Some(&[start, first, mut at]) = wedges.first() else { continue };
            ring.push(first);
            while at != start && ring.len() <= wedges.len() {
                let Some(&[_, f, next]) = wedges.iter().find(|w| w[0] == at) else { break };
                ring.push(f);
                at = next;
            }
            if at == start && ring.len() == wedges.len() {
                polygon_faces(&ring, &mut faces);
            }
        }
        Self::new(self.face_centers(), faces).map(Self::with_normals)
    }
}

fn too_many() -> Error {
    let why = "the mesh would have more faces than it may: a larger length takes fewer".into();
    Error::Invalid { what: "edge length", why }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Box3, Interval, Plane};

    fn options(length: f64, crease: Option<f64>) -> RemeshOptions {
        RemeshOptions { length, iterations: 10, crease, points: Vec::new(), limit: 1_000_000 }
    }

    fn lengths(mesh: &Mesh) -> (f64, f64, f64) {
        let all: Vec<f64> =
            mesh.edges().iter().filter_map(|e| mesh.edge_line(e)).map(|l| l.length()).collect();
        let (low, high) = all.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), &l| (a.min(l), b.max(l)));
        (low, all.iter().sum::<f64>() / all.len() as f64, high)
    }

    fn cube() -> Mesh {
        let side = Interval::new(-1.0, 1.0);
        Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 2, 2, 2).unwrap()
    }

    #[test]
    fn a_cube_keeps_its_edges() {
        let done = cube().remeshed(&options(0.3, Some(0.5)), None).unwrap();
        let mesh = &done.mesh;
        assert!(mesh.is_closed() && mesh.is_manifold() && mesh.is_oriented());
        assert!((mesh.volume() - 8.0).abs() < 1e-9, "{}", mesh.volume());
        let (low, mean, high) = lengths(mesh);
        assert!((mean / 0.3 - 1.0).abs() < 0.15 && low > 0.1 && high < 0.55, "{low} {mean} {high}");
        let creases: f64 = done.creases.iter().map(|l| l.length()).sum();
        assert!((creases - 24.0).abs() < 1e-9);
        // Without creases corners are rounded off.
        let round = cube().remeshed(&options(0.3, None), None).unwrap();
        assert!(round.creases.is_empty() && round.mesh.is_closed());
        assert!(round.mesh.volume() < 7.99);
    }

    #[test]
    fn coarser_finer_and_with_a_border() {
        let sphere = Mesh::sphere(&Plane::XY, 2.0, 40, 20).unwrap();
        for length in [0.8, 0.2] {
            let mesh = sphere.remeshed(&options(length, None), None).unwrap().mesh;
            assert!(mesh.is_closed() && mesh.is_manifold() && mesh.is_oriented());
            let (_, mean, high) = lengths(&mesh);
            assert!((mean / length - 1.0).abs() < 0.2 && high < 1.9 * length, "{mean} {high}");
            assert!(mesh.check().is_ok());
        }
        let square =
            crate::Rectangle { plane: Plane::XY, x: Interval::new(0.0, 3.0), y: Interval::new(0.0, 2.0) };
        let mut wanted = options(0.25, Some(0.5));
        wanted.points = vec![Point3::new(1.0, 1.0, 0.0)];
        let mesh = Mesh::plane(&square, 7, 3).unwrap().remeshed(&wanted, None).unwrap().mesh;
        assert!((mesh.area() - 6.0).abs() < 1e-9);
        assert!(mesh.vertices().iter().any(|p| p.distance_to(Point3::new(1.0, 1.0, 0.0)) < 1e-12));
        assert!(mesh.face_normals().iter().all(|n| n.z > 0.99));
    }

    #[test]
    fn refused_and_odd() {
        assert!(cube().remeshed(&options(0.0, None), None).is_err());
        assert!(cube().remeshed(&options(f64::NAN, None), None).is_err());
        assert!(cube().remeshed(&options(1e-4, None), None).is_err());
        assert!(Mesh::default().remeshed(&options(1.0, None), None).is_err());
        let huge = cube().remeshed(&options(50.0, None), None).unwrap();
        assert!(!huge.mesh.faces().is_empty());
        // Three faces along one edge.
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]];
        let faces = [[0, 1, 2], [1, 0, 3], [0, 1, 4]].map(MeshFace::Triangle).to_vec();
        let fan = Mesh::new(points.map(Point3::from).to_vec(), faces).unwrap();
        let done = fan.remeshed(&options(0.2, Some(0.5)), None).unwrap();
        assert!((done.mesh.area() - 1.5).abs() < 1e-9);
    }

    #[test]
    fn duals() {
        let dual = Mesh::sphere(&Plane::XY, 1.0, 8, 5).unwrap().dual().unwrap();
        assert!(dual.is_closed() && dual.is_oriented() && dual.volume() > 0.0);
        assert_eq!(dual.vertices().len(), 40);
        let square = crate::Rectangle { plane: Plane::XY, x: Interval::UNIT, y: Interval::UNIT };
        let flat = Mesh::plane(&square, 3, 3).unwrap().dual().unwrap();
        assert_eq!((flat.vertices().len(), flat.faces().len()), (9, 4));
        assert!(flat.face_normals().iter().all(|n| n.z > 0.99));
    }
}
