use katydid_elementary::Elementary;

use super::{Morph, finite};
use crate::{Arc, Error, Line, Plane, Point3, Result, Vector3};

/// Bends space so that a straight axis becomes an arc of the same length.
///
/// The axis starts where the arc starts and runs along the arc's tangent there. What lies behind the start stays; what
/// lies beyond the end is carried on rigidly.
#[derive(Debug, Clone, Copy)]
pub struct Bend {
    /// The start of the arc: x along its tangent, y towards its centre.
    frame: Plane,
    radius: f64,
    length: f64,
}

impl Bend {
    /// The bend into an arc.
    ///
    /// # Errors
    /// An arc that is not finite, or without radius or length.
    pub fn new(arc: &Arc) -> Result<Self> {
        let (center, start) = (arc.circle.center(), arc.start());
        let (radius, length) = (arc.circle.radius, arc.length());
        let sound = |x: f64| x > 0.0 && x.is_finite();
        if !(start.is_finite() && center.is_finite() && sound(radius) && sound(length)) {
            return Err(Error::degenerate("bending arc", "it has no radius, no length or is not finite"));
        }
        let way = arc.circle.plane.z_axis * arc.angle.length().signum();
        let inwards = center - start;
        Ok(Self { frame: Plane::from_axes(start, inwards.cross(way), inwards)?, radius, length })
    }

    /// The axis that becomes the arc.
    pub fn axis(&self) -> Line {
        Line::new(self.frame.origin, self.frame.origin + self.frame.x_axis * self.length)
    }
}

impl Morph for Bend {
    fn image(&self, p: Point3) -> Result<Point3> {
        let [s, inwards, side] = self.frame.coordinates(p);
        let along = s.clamp(0.0, self.length);
        let (sin, cos) = (along / self.radius).sine_cosine();
        let Plane { x_axis: x, y_axis: y, z_axis: z, .. } = self.frame;
        let center = self.frame.origin + y * self.radius;
        let (outwards, tangent): (Vector3, Vector3) = (x * sin - y * cos, x * cos + y * sin);
        finite(center + outwards * (self.radius - inwards) + tangent * (s - along) + z * side)
    }

    fn seams(&self) -> Vec<Plane> {
        let axis = self.axis();
        [axis.from, axis.to].iter().filter_map(|&p| Plane::from_normal(p, self.frame.x_axis).ok()).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;
    use crate::{Circle, Curve, Interval, Tolerance};

    #[test]
    fn the_axis_becomes_the_arc() {
        let circle = Circle::new(Plane::XY, 2.0).unwrap();
        let arc = Arc::new(circle, Interval::new(0.0, FRAC_PI_2)).unwrap();
        let bend = Bend::new(&arc).unwrap();
        let axis: Curve = bend.axis().into();
        let image = axis.morphed(&bend, &Tolerance::default()).unwrap();
        assert!(matches!(&image, Curve::Arc(_)), "{image:?}");
        assert!((image.length() - arc.length()).abs() < 1e-9);
        assert!(image.start().distance_to(Point3::new(2.0, 0.0, 0.0)) < 1e-9);
        assert!(image.end().distance_to(Point3::new(0.0, 2.0, 0.0)) < 1e-9);
        // Beyond the end it goes on straight, behind the start nothing moves.
        let beyond = bend.image(Point3::new(2.0, arc.length() + 1.0, 3.0)).unwrap();
        assert!(beyond.distance_to(Point3::new(-1.0, 2.0, 3.0)) < 1e-12);
        let behind = Point3::new(7.0, -1.0, 1.0);
        assert!(bend.image(behind).unwrap().distance_to(behind) < 1e-12);
        let long: Curve = Line::new(Point3::new(2.0, -1.0, 0.0), Point3::new(2.0, 6.0, 0.0)).into();
        assert!((long.morphed(&bend, &Tolerance::default()).unwrap().length() - 7.0).abs() < 1e-9);
    }
}
