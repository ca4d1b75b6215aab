//! Breps of meshes: a face for each face.

use std::collections::HashMap;

use super::planar::add_planar_face;
use super::{Along, Brep, Builder, LoopKind, NewEdge, NewVertex, Path};
use crate::{
    Curve, Direction, Error, Line, LineCurve, Mesh, NurbsSurface, Plane, Point3, Result, Surface, Tolerance,
    Vector3, cancellation,
};

/// Vertices and edges that the faces of a mesh share.
struct Net {
    builder: Builder,
    vertices: HashMap<[u64; 3], NewVertex>,
    edges: HashMap<[[u64; 3]; 2], NewEdge>,
}

/// The bits of a place; 0 and −0 are the same.
fn key(p: Point3) -> [u64; 3] {
    [p.x, p.y, p.z].map(|x| (x + 0.0).to_bits())
}

fn straight(from: Point3, to: Point3) -> Curve {
    LineCurve::new(Line::new(from, to)).into()
}

impl Net {
    fn vertex(&mut self, p: Point3) -> NewVertex {
        *self.vertices.entry(key(p)).or_insert_with(|| self.builder.vertex(p))
    }

    /// The edge between two places, and whether it runs from the second to the first.
    fn edge(&mut self, from: Point3, to: Point3) -> (NewEdge, bool) {
        if let Some(edge) = self.edges.get(&[key(to), key(from)]) {
            return (*edge, true);
        }
        if let Some(edge) = self.edges.get(&[key(from), key(to)]) {
            return (*edge, false);
        }
        let ends = [self.vertex(from), self.vertex(to)];
        let edge = self.builder.edge(straight(from, to), ends);
        self.edges.insert([key(from), key(to)], edge);
        (edge, false)
    }

    /// A trimmed plane within straight sides; it must not be thinner than the tolerance.
    fn flat(&mut self, plane: &Plane, corners: &[Point3]) -> Result<()> {
        let sides = corners.iter().zip(corners.iter().cycle().skip(1));
        let rim = sides
            .map(|(a, b)| {
                let (edge, backwards) = self.edge(*a, *b);
                let curve = if backwards { straight(*b, *a) } else { straight(*a, *b) };
                (edge, backwards, curve)
            })
            .collect();
        add_planar_face(&mut self.builder, plane, &[rim])
    }

    /// A bilinear surface between four corners.
    fn twisted(&mut self, corners: [Point3; 4]) -> Result<()> {
        let [a, b, c, d] = corners;
        let surface = Surface::from(NurbsSurface::from_corners(a, b, c, d)?);
        let [u, v] = [Direction::U, Direction::V].map(|direction| surface.domain(direction));
        let at = |u: f64, v: f64| Point3::new(u, v, 0.0);
        let square = [at(u.start, v.start), at(u.end, v.start), at(u.end, v.end), at(u.start, v.end)];
        let face = self.builder.face(surface, false);
        let mut paths = Vec::with_capacity(4);
        for k in 0..4 {
            let next = (k + 1) % 4;
            let (edge, backwards) = self.edge(corners[k], corners[next]);
            paths
                .push(Path { curve: straight(square[k], square[next]), along: Along::Edge(edge, backwards) });
        }
        self.builder.bound(face, LoopKind::Outer, paths)
    }
}

impl Brep {
    /// The brep with a face for each face of a mesh: trimmed planes for triangles and flat quads, bilinear surfaces for
    /// twisted ones. Faces that meet in the same two places share an edge, whether the mesh is welded or not. Faces
    /// thinner than the tolerance are left out.
    ///
    /// # Errors
    /// No face of the mesh encloses an area, or the tolerance is not above 0.
    pub fn from_mesh(mesh: &Mesh, tolerance: &Tolerance) -> Result<Self> {
        let limit = tolerance.positive_distance()?;
        let mut net = Net { builder: Builder::new(), vertices: HashMap::new(), edges: HashMap::new() };
        let mut made = 0_usize;
        for face in mesh.faces() {
            cancellation::check()?;
            let mut corners: Vec<Point3> =
                face.indices().iter().filter_map(|&k| mesh.vertices().get(k as usize).copied()).collect();
            corners.dedup_by(|a, b| a.distance_to(*b) <= limit);
            while corners.len() > 1 && corners[0].distance_to(corners[corners.len() - 1]) <= limit {
                corners.pop();
            }
            let Some(plane) = plane_of(&corners, limit) else { continue };
            match <[Point3; 4]>::try_from(corners.as_slice()) {
                Ok(four) if four.iter().any(|p| plane.signed_distance(*p).abs() > limit) => {
                    net.twisted(four)?;
                }
                _ => net.flat(&plane, &corners)?,
            }
            made += 1;
        }
        if made == 0 {
            return Err(Error::degenerate("mesh", "no face of it encloses an area"));
        }
        net.builder.finish(limit)
    }
}

/// The plane at the first corner of a polygon across its mean normal; `None` for one thinner than the limit.
fn plane_of(corners: &[Point3], limit: f64) -> Option<Plane> {
    let first = *corners.first()?;
    let spokes: Vec<Vector3> = corners.iter().skip(1).map(|p| *p - first).collect();
    let normal = spokes.windows(2).fold(Vector3::ZERO, |sum, pair| sum + pair[0].cross(pair[1]));
    let widest = spokes.iter().map(|v| v.length()).fold(0.0, f64::max);
    // Twice the area over the length is the width.
    (normal.length() > limit * widest).then(|| Plane::from_normal(first, normal).ok())?
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Box3, Interval, MeshFace, TwistedBox};

    #[test]
    fn meshes_of_solids_are_solids() {
        let side = Interval::new(0.0, 2.0);
        let cube = Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 2, 1, 3).unwrap();
        let brep = Brep::from_mesh(&cube, &Tolerance::default()).unwrap();
        assert!(brep.is_valid() && brep.is_solid());
        assert_eq!(brep.faces().len(), cube.faces().len());
        let volume = brep.volume_properties(1e-9, || true).unwrap().amount;
        assert!((volume - 8.0).abs() < 1e-9, "{volume}");
        let ball = Mesh::sphere(&Plane::XY, 1.0, 8, 6).unwrap();
        let brep = Brep::from_mesh(&ball, &Tolerance::default()).unwrap();
        assert!(brep.is_valid() && brep.is_solid());
    }

    #[test]
    fn twisted_quads_are_bilinear() {
        let mut corners = TwistedBox::from(Box3 {
            plane: Plane::XY,
            x: Interval::UNIT,
            y: Interval::UNIT,
            z: Interval::UNIT,
        })
        .corners;
        corners[6] = Point3::new(1.5, 1.5, 2.0);
        let shape = TwistedBox { corners };
        let brep = Brep::from_mesh(&shape.to_mesh().unwrap(), &Tolerance::default()).unwrap();
        assert!(brep.is_valid() && brep.is_solid());
        // The volume between the trilinear sides, by the determinant of their map: 3-point Gauss rules are exact.
        let nodes =
            [(0.5 - 0.15_f64.sqrt(), 5.0 / 18.0), (0.5, 4.0 / 9.0), (0.5 + 0.15_f64.sqrt(), 5.0 / 18.0)];
        let mut exact = 0.0;
        for (u, a) in nodes {
            for (v, b) in nodes {
                for (w, c) in nodes {
                    let h = 1e-3;
                    let du = (shape.at(u + h, v, w) - shape.at(u - h, v, w)) / (2.0 * h);
                    let dv = (shape.at(u, v + h, w) - shape.at(u, v - h, w)) / (2.0 * h);
                    let dw = (shape.at(u, v, w + h) - shape.at(u, v, w - h)) / (2.0 * h);
                    exact += a * b * c * du.cross(dv).dot(dw);
                }
            }
        }
        let volume = brep.volume_properties(1e-9, || true).unwrap().amount;
        assert!((volume - exact).abs() < 1e-6, "{volume} {exact}");
    }

    #[test]
    fn thin_faces_are_left_out() {
        let p = |x: f64, y: f64| Point3::new(x, y, 0.0);
        let mesh = Mesh::new(
            vec![p(0.0, 0.0), p(1.0, 0.0), p(0.0, 1.0), p(2.0, 0.0)],
            vec![MeshFace::Triangle([0, 1, 2]), MeshFace::Triangle([0, 1, 3])],
        )
        .unwrap();
        let brep = Brep::from_mesh(&mesh, &Tolerance::default()).unwrap();
        assert_eq!(brep.faces().len(), 1);
        let line = Mesh::new(mesh.vertices().to_vec(), vec![MeshFace::Triangle([0, 1, 3])]).unwrap();
        assert!(Brep::from_mesh(&line, &Tolerance::default()).is_err());
    }
}
