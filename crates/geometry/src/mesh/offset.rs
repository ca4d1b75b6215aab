//! Meshes moved along their normals, and given a thickness.

use super::{Mesh, MeshFace};
use crate::linear::symmetric_eigen;
use crate::{Error, Point3, Result, Vector3};

/// A direction in which the planes at a vertex agree this well is none to move along: there they only make noise.
const FLAT: f64 = 0.02;
/// No vertex moves farther than this many times the distance, however sharp the corner.
const LONGEST: f64 = 4.0;

impl Mesh {
    /// The mesh at a distance, outwards when positive. The faces are the same; each vertex moves to where the planes of
    /// its faces are after they have moved, in the sense of least squares (normals weighted by the angle at the
    /// vertex): flat and convex corners keep the distance exactly, and a box stays a box. At most four times the
    /// distance, so that needles do not shoot out. Vertices in the same place move together; faces that turn over
    /// where the mesh is narrower than the distance stay.
    ///
    /// # Errors
    /// The distance is not finite, or a vertex leaves for infinity.
    pub fn offset(&self, distance: f64) -> Result<Self> {
        if !distance.is_finite() {
            return Err(Error::NotFinite("offset distance"));
        }
        let merged = self.merged_indices();
        // Σ w n nᵀ and Σ w n by place: the normal equations of n · x = distance over the faces.
        let mut sums = vec![([[0.0_f64; 3]; 3], Vector3::ZERO); self.vertices.len()];
        for (face, normal) in self.faces.iter().zip(self.face_normals()) {
            let indices = face.indices();
            let n = indices.len();
            for (k, &i) in indices.iter().enumerate() {
                let at = |i: u32| self.vertices.get(i as usize).copied().unwrap_or(Point3::ORIGIN);
                let here = at(i);
                let [before, after] = [(k + n - 1) % n, (k + 1) % n].map(|k| at(indices[k]) - here);
                let Some(angle) = before.angle_to(after) else { continue };
                let place = merged.get(i as usize).and_then(|&m| sums.get_mut(m as usize));
                let Some((matrix, sum)) = place else { continue };
                let v = [normal.x, normal.y, normal.z];
                for (row, a) in matrix.iter_mut().zip(v) {
                    row.iter_mut().zip(v).for_each(|(x, b)| *x += angle * a * b);
                }
                *sum += normal * angle;
            }
        }
        let moves: Vec<Vector3> = sums.iter().map(|(m, b)| corner(*m, *b)).collect();
        let shift = |(p, m): (&Point3, &u32)| {
            *p + moves.get(*m as usize).copied().unwrap_or(Vector3::ZERO) * distance
        };
        let vertices = self.vertices.iter().zip(&merged).map(shift).collect();
        Ok(Self::from_parts(vertices, self.faces.to_vec(), Vec::new(), self.colours.clone())?.with_normals())
    }

    /// The mesh given a thickness: itself turned round, its offset, and a quad along each naked edge. For a positive
    /// distance the result looks outwards, for a negative one it is turned so that it does. An open mesh becomes a
    /// closed one, a closed one a hollow shell.
    ///
    /// # Errors
    /// As [`Mesh::offset`]; more vertices than an index can count.
    pub fn thickened(&self, distance: f64) -> Result<Self> {
        let far = self.offset(distance)?;
        let near = Self { normals: Vec::new(), ..self.clone() };
        let both = Self::join(&[near.flipped(), Self { normals: Vec::new(), ..far }])?;
        let shift = u32::try_from(self.vertices.len()).unwrap_or(u32::MAX);
        let mut faces = both.faces.to_vec();
        let naked = self.edges().into_iter().filter(|e| e.faces == 1);
        faces.extend(naked.map(|e| {
            // The edge is named in the direction in which its face walks it.
            let [a, b] = e.vertices;
            MeshFace::Quad([a, b, b.saturating_add(shift), a.saturating_add(shift)])
        }));
        let whole = Self::from_parts(both.vertices, faces, Vec::new(), both.colours)?;
        Ok(if distance < 0.0 { whole.flipped() } else { whole }.with_normals())
    }
}

/// The shortest x with n · x = 1 for the normals n that were summed, by least squares over the directions in which
/// they are not flat.
fn corner(matrix: [[f64; 3]; 3], sum: Vector3) -> Vector3 {
    let (values, vectors) = symmetric_eigen(matrix);
    let most = values[2];
    if !(most > 0.0) {
        return Vector3::ZERO;
    }
    let mut x = Vector3::ZERO;
    for (value, v) in values.into_iter().zip(vectors) {
        if value > FLAT * most {
            let v = Vector3::new(v[0], v[1], v[2]);
            x += v * (v.dot(sum) / value);
        }
    }
    let length = x.length();
    if length > LONGEST { x * (LONGEST / length) } else { x }
}

#[cfg(test)]
mod tests {
    use crate::{Box3, Interval, Mesh, Plane, Point3, Rectangle, Vector3};

    #[test]
    fn a_box_stays_a_box() {
        let side = Interval::new(0.0, 4.0);
        let plane = Plane::from_normal(Point3::new(1.0, 2.0, 3.0), Vector3::new(1.0, -2.0, 2.0)).unwrap();
        let cube = Mesh::cuboid(&Box3 { plane, x: side, y: side, z: side }, 4, 4, 4).unwrap();
        for d in [0.5, -0.5, 0.0] {
            let grown = cube.offset(d).unwrap();
            assert!((grown.volume() - (4.0 + 2.0 * d).powi(3)).abs() < 1e-9, "{}", grown.volume());
            assert!(grown.is_closed());
        }
        assert!(cube.offset(f64::INFINITY).is_err());
    }

    #[test]
    fn a_sheet_gets_thick() {
        let side = Interval::new(0.0, 3.0);
        let sheet = Mesh::plane(&Rectangle { plane: Plane::XY, x: side, y: side }, 3, 3).unwrap();
        for d in [0.5, -0.25_f64] {
            let plate = sheet.thickened(d).unwrap();
            assert!(plate.is_closed() && plate.is_oriented());
            assert!((plate.volume() - 9.0 * d.abs()).abs() < 1e-12);
        }
        let ball = Mesh::sphere(&Plane::XY, 2.0, 24, 16).unwrap();
        let grown = ball.offset(0.5).unwrap();
        for (p, q) in ball.vertices().iter().zip(grown.vertices()) {
            assert!((p.distance_to(*q) - 0.5).abs() < 0.01);
        }
        let shell = ball.thickened(0.5).unwrap();
        assert!((shell.volume() - (grown.volume() - ball.volume())).abs() < 1e-9);
        assert_eq!(Mesh::default().offset(1.0).unwrap(), Mesh::default());
    }
}
