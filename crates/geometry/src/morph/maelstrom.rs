use katydid_elementary::Elementary;

use super::{Morph, finite};
use crate::{Error, Plane, Point3, Result};

/// Turns space about the normal of a plane: by the whole angle within the first radius, not at all beyond the second,
/// and linearly less in between.
#[derive(Debug, Clone, Copy)]
pub struct Maelstrom {
    plane: Plane,
    first: f64,
    second: f64,
    angle: f64,
}

impl Maelstrom {
    /// The maelstrom about a plane's origin, its angle in radians. The first radius may be the larger one: then the
    /// middle stays and the outside turns.
    ///
    /// # Errors
    /// Radii that are the same, or a number that is not finite.
    pub fn new(plane: Plane, first: f64, second: f64, angle: f64) -> Result<Self> {
        if !(plane.is_finite() && first.is_finite() && second.is_finite() && angle.is_finite()) {
            return Err(Error::NotFinite("plane, radius or angle"));
        }
        if first == second {
            return Err(Error::degenerate("radii", "they are the same"));
        }
        Ok(Self { plane, first, second, angle })
    }
}

impl Morph for Maelstrom {
    fn image(&self, p: Point3) -> Result<Point3> {
        let [x, y, z] = self.plane.coordinates(p);
        let part = ((x.hypotenuse(y) - self.second) / (self.first - self.second)).clamp(0.0, 1.0);
        if part == 0.0 {
            return finite(p);
        }
        let (sin, cos) = (self.angle * part).sine_cosine();
        finite(self.plane.at(x * cos - y * sin, x * sin + y * cos, z))
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::{Curve, Line, Tolerance};

    #[test]
    fn the_middle_turns_and_the_outside_stays() {
        let whirl = Maelstrom::new(Plane::XY, 1.0, 3.0, PI).unwrap();
        let near = |x: f64, wanted: [f64; 3]| {
            whirl.image(Point3::new(x, 0.0, 5.0)).unwrap().distance_to(wanted.into()) < 1e-12
        };
        assert!(near(0.5, [-0.5, 0.0, 5.0]) && near(2.0, [0.0, 2.0, 5.0]) && near(4.0, [4.0, 0.0, 5.0]));
        let still = Maelstrom::new(Plane::XY, 1.0, 3.0, 0.0).unwrap();
        let line: Curve = Line::new(Point3::new(-5.0, 0.0, 0.0), Point3::new(5.0, 0.0, 0.0)).into();
        let same = line.morphed(&still, &Tolerance::default()).unwrap();
        assert!(matches!(same, Curve::Line(_)));
        // A map that acts only in the middle of a line is not overlooked.
        let small = Maelstrom::new(Plane::XY, 0.3, 0.6, PI).unwrap();
        assert!(line.morphed(&small, &Tolerance::default()).unwrap().length() > 10.1);
        assert!(Maelstrom::new(Plane::XY, 1.0, 1.0, 0.0).is_err());
    }
}
