//! Many points at once.

use crate::{Point3, Vector3, Xform};

impl Xform {
    /// Replaces each point by its image, as [`Xform::point`] gives it.
    ///
    /// One pass over memory, which bounds it: more threads would wait for the same memory.
    pub fn transform_points(&self, points: &mut [Point3]) {
        if !self.is_affine() {
            points.iter_mut().for_each(|p| *p = self.point(*p));
            return;
        }
        let [x, y, z, _] = self.rows;
        for p in points {
            let q = *p;
            let at = |r: &[f64; 4]| r[0] * q.x + r[1] * q.y + r[2] * q.z + r[3];
            *p = Point3::new(at(&x), at(&y), at(&z));
        }
    }

    /// Replaces each vector by its image, as [`Xform::vector`] gives it: translation does not move them.
    pub fn transform_vectors(&self, vectors: &mut [Vector3]) {
        for v in vectors {
            *v = self.vector(*v);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::{Point3, Vector3, Xform};

    #[test]
    fn many_points_are_as_one() -> crate::Result<()> {
        let mut projective = Xform::IDENTITY;
        projective.rows[3] = [0.1, 0.0, -0.2, 1.5];
        let turn = Xform::rotation(0.3, Vector3::new(1.0, 2.0, 3.0), Point3::new(4.0, 5.0, 6.0))?;
        for xform in [Xform::IDENTITY, turn, projective] {
            let points: Vec<_> = (0..100).map(|i| Point3::new(f64::from(i), 1.0, -2.5)).collect();
            let mut images = points.clone();
            xform.transform_points(&mut images);
            assert!(points.iter().zip(&images).all(|(p, q)| xform.point(*p) == *q));
        }
        Ok(())
    }
}
