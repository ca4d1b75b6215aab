use crate::{Box3, Error, Mesh, MeshFace, Point3, Result};

/// A box with eight free corners.
///
/// The corners come in the order (0,0,0), (1,0,0), (1,1,0), (0,1,0), then the same four at height 1: the bottom
/// counter-clockwise, then the top likewise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwistedBox {
    /// The corners.
    pub corners: [Point3; 8],
}

impl TwistedBox {
    /// The box of eight corners.
    ///
    /// # Errors
    /// A corner is not finite.
    pub fn new(corners: [Point3; 8]) -> Result<Self> {
        if corners.iter().all(|p| p.is_finite()) {
            Ok(Self { corners })
        } else {
            Err(Error::NotFinite("corner of a twisted box"))
        }
    }

    /// The point at box coordinates, 0…1 inside: the trilinear blend of the corners, which goes on outside.
    pub fn at(&self, u: f64, v: f64, w: f64) -> Point3 {
        // Differences from the first corner keep far-away boxes exact.
        let origin = self.corners[0];
        let (x, y, z) = ([1.0 - u, u], [1.0 - v, v], [1.0 - w, w]);
        let weights = [
            x[0] * y[0] * z[0],
            x[1] * y[0] * z[0],
            x[1] * y[1] * z[0],
            x[0] * y[1] * z[0],
            x[0] * y[0] * z[1],
            x[1] * y[0] * z[1],
            x[1] * y[1] * z[1],
            x[0] * y[1] * z[1],
        ];
        self.corners.iter().zip(weights).skip(1).fold(origin, |sum, (&corner, w)| sum + (corner - origin) * w)
    }

    /// Its six sides as quads between its corners; their normals point outwards from a box that is not turned over.
    ///
    /// # Errors
    /// A corner is not finite.
    pub fn to_mesh(&self) -> Result<Mesh> {
        let sides = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
        Mesh::new(self.corners.to_vec(), sides.map(MeshFace::Quad).to_vec())
    }
}

impl From<Box3> for TwistedBox {
    fn from(b: Box3) -> Self {
        Self { corners: b.corners() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Interval, Plane};

    #[test]
    fn a_box_is_a_twisted_box() {
        let side = |a: f64| Interval::new(a, a + 2.0);
        let b = Box3 { plane: Plane::YZ, x: side(0.0), y: side(1.0), z: side(-4.0) };
        let t = TwistedBox::from(b);
        for [u, v, w] in [[0.0, 0.0, 0.0], [0.2, 0.7, 0.4], [1.0, 1.0, 1.0], [2.0, -1.0, 0.5]] {
            assert!(t.at(u, v, w).distance_to(b.at(u, v, w)) < 1e-14);
        }
        assert!((t.to_mesh().unwrap().volume() - 8.0).abs() < 1e-12);
        assert!(TwistedBox::new([Point3::new(f64::NAN, 0.0, 0.0); 8]).is_err());
    }
}
