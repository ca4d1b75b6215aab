//! Pairs of triangles merged to quads.

use std::sync::Arc;

use crate::mesh::thresholds::SAME_ANGLE;
use std::collections::HashMap;

use super::{Mesh, MeshFace};
use crate::Point3;

/// A pair of triangles that may become a quad.
struct Candidate {
    quad: [u32; 4],
    faces: [usize; 2],
    ratio: f64,
    kink: f64,
}

/// A side as a face walks it: the face, and its corners from the side's start on.
type Walk = (usize, [u32; 3]);

impl Mesh {
    /// Merges neighbouring triangles to convex quads where their normals differ by at most `angle` radians and the
    /// shorter diagonal of the quad is at least `ratio` of the longer one; gives the mesh and the number of quads made.
    ///
    /// The pairs whose diagonals are most alike are taken first, of equal ones the flatter; a triangle takes part in one
    /// pair at most. Neighbours are found across edges in the same place, also where their vertices differ. A quad
    /// stands where the first of its two triangles stood. Quads that were there stay.
    #[must_use]
    pub fn quadrangulated(&self, angle: f64, ratio: f64) -> (Self, usize) {
        let mut pairs = self.quad_candidates(angle, ratio);
        // Rounding must not choose between diagonals that are equal.
        let rank = |c: &Candidate| ((c.ratio * 1e9).round(), (c.kink * 1e9).round());
        pairs.sort_by(|a, b| {
            let ((r, k), (s, l)) = (rank(a), rank(b));
            s.total_cmp(&r).then(k.total_cmp(&l)).then(a.faces.cmp(&b.faces))
        });
        let mut state: Vec<Option<MeshFace>> = self.faces.iter().copied().map(Some).collect();
        let mut taken = vec![false; self.faces.len()];
        let mut made = 0;
        for Candidate { quad, faces: [f, g], .. } in pairs {
            if taken.get(f).is_none_or(|t| *t) || taken.get(g).is_none_or(|t| *t) {
                continue;
            }
            made += 1;
            for (k, slot) in [(f, Some(MeshFace::Quad(quad))), (g, None)] {
                if let (Some(taken), Some(state)) = (taken.get_mut(k), state.get_mut(k)) {
                    (*taken, *state) = (true, slot);
                }
            }
        }
        (Self { faces: Arc::new(state.into_iter().flatten().collect()), ..self.clone() }, made)
    }

    fn quad_candidates(&self, angle: f64, ratio: f64) -> Vec<Candidate> {
        let merged = self.merged_indices();
        let normals = self.face_normals();
        let mut sides: HashMap<(u32, u32), Vec<Walk>> = HashMap::new();
        for (f, face) in self.faces.iter().enumerate() {
            let indices = face.indices();
            for k in 0..indices.len() {
                let corner = |d: usize| indices.get((k + d) % indices.len()).copied().unwrap_or(0);
                let at = |i: u32| merged.get(i as usize).copied().unwrap_or(i);
                // Quads count as neighbours, so that an edge with three faces is no edge of a pair.
                let (a, b) = (at(corner(0)), at(corner(1)));
                sides.entry((a, b)).or_default().push((f, [corner(0), corner(1), corner(2)]));
            }
        }
        let mut pairs = Vec::new();
        for (f, face) in self.faces.iter().enumerate() {
            let MeshFace::Triangle(t) = *face else { continue };
            for k in 0..3 {
                let [a, b, c] = [t[k], t[(k + 1) % 3], t[(k + 2) % 3]];
                let at = |i: u32| merged.get(i as usize).copied().unwrap_or(i);
                let side = |a: u32, b: u32| sides.get(&(at(a), at(b))).map_or(&[][..], Vec::as_slice);
                let ([_], [(g, [_, _, d])]) = (side(a, b), side(b, a)) else { continue };
                if *g <= f || !matches!(self.faces.get(*g), Some(MeshFace::Triangle(_))) {
                    continue;
                }
                let (Some(n), Some(m)) = (normals.get(f), normals.get(*g)) else { continue };
                let Some(kink) = n.angle_to(*m).filter(|x| *x <= angle + SAME_ANGLE) else { continue };
                let quad = [a, *d, b, c];
                let corners = quad.map(|i| self.vertices.get(i as usize).copied().unwrap_or(Point3::ORIGIN));
                let [p, q, r, s] = corners;
                let (one, other) = (p.distance_to(r), q.distance_to(s));
                let alike = one.min(other) / one.max(other);
                let up = *n + *m;
                let convex = (0..4).all(|k| {
                    let [x, y, z] = [0, 1, 2].map(|d| corners[(k + d) % 4]);
                    (y - x).cross(z - y).dot(up) > 0.0
                });
                if convex && alike >= ratio - SAME_ANGLE {
                    pairs.push(Candidate { quad, faces: [f, *g], ratio: alike, kink });
                }
            }
        }
        pairs
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use crate::{Interval, Mesh, MeshFace, Plane, Point3, Rectangle};

    fn triangulated(mesh: &Mesh) -> Mesh {
        let faces = mesh.faces().iter().flat_map(|f| f.triangles()).map(MeshFace::Triangle).collect();
        Mesh::new(mesh.vertices().to_vec(), faces).unwrap()
    }

    #[test]
    fn a_grid_comes_back() {
        let side = Interval::new(0.0, 5.0);
        let grid = Mesh::plane(&Rectangle { plane: Plane::XY, x: side, y: side }, 5, 5).unwrap();
        let (quads, made) = triangulated(&grid).quadrangulated(0.035, 0.875);
        assert_eq!((made, quads.faces().len()), (25, 25));
        assert!((quads.area() - 25.0).abs() < 1e-12);
        assert!(quads.is_oriented());
        let (same, none) = grid.quadrangulated(0.035, 0.875);
        assert_eq!((same, none), (grid, 0));
        // A box: the creases stay.
        let cube = crate::Box3 { plane: Plane::XY, x: side, y: side, z: side };
        let cube = Mesh::cuboid(&cube, 3, 3, 3).unwrap().welded(PI);
        let (again, made) = triangulated(&cube).quadrangulated(0.035, 0.875);
        assert_eq!((made, again.faces().len()), (54, 54));
        assert!((again.volume() - 125.0).abs() < 1e-9);
    }

    #[test]
    fn limits_hold() {
        let points =
            [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 3.0, 0.0], [0.0, 1.0, 0.5]].map(Point3::from).to_vec();
        let faces = vec![MeshFace::Triangle([0, 1, 2]), MeshFace::Triangle([0, 2, 3])];
        let bent = Mesh::new(points, faces).unwrap();
        assert_eq!(bent.quadrangulated(0.035, 0.0).1, 0);
        assert_eq!(bent.quadrangulated(PI, 0.875).1, 0);
        assert_eq!(bent.quadrangulated(PI, 0.3).1, 1);
        assert_eq!(Mesh::default().quadrangulated(1.0, 0.5).1, 0);
    }
}
