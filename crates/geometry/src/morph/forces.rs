use super::{Morph, finite};
use crate::{Point3, Result, Vector3, cancellation};

/// Pushes space by forces at points, each the less the farther away: a point moves by the sum of the forces, each times
/// the falloff at its distance.
pub struct Forces<'a> {
    forces: &'a [(Point3, Vector3)],
    falloff: Box<dyn Fn(f64) -> f64 + 'a>,
}

impl<'a> Forces<'a> {
    /// Forces with a falloff by distance. Where it is not finite the image is an error.
    pub fn new(forces: &'a [(Point3, Vector3)], falloff: impl Fn(f64) -> f64 + 'a) -> Self {
        Self { forces, falloff: Box::new(falloff) }
    }
}

impl Morph for Forces<'_> {
    fn image(&self, p: Point3) -> Result<Point3> {
        cancellation::check()?;
        finite(self.forces.iter().fold(p, |sum, (q, force)| sum + *force * (self.falloff)(p.distance_to(*q))))
    }
}
