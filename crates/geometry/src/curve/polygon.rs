//! Polygons: rectangles and regular ones.

use super::PolylineCurve;
use crate::{Circle, Error, Plane, Point3, Rectangle, Result};

impl Rectangle {
    /// The closed polyline of five points around it, counter-clockwise from the smallest corner; domain 0…4.
    ///
    /// # Errors
    /// A number is not finite.
    pub fn to_polyline(&self) -> Result<PolylineCurve> {
        let [a, b, c, d] = self.corners();
        PolylineCurve::new(vec![a, b, c, d, a])
    }
}

/// The closed regular polygon with `sides` corners at `radius` from the plane's origin, the first on its x axis.
///
/// # Errors
/// Fewer than 3 or more than a million sides, or a radius that is not finite and greater than 0.
pub fn regular_polygon(plane: &Plane, radius: f64, sides: usize) -> Result<PolylineCurve> {
    if !(3..=1_000_000).contains(&sides) {
        return Err(Error::OutOfRange {
            what: "number of sides",
            value: sides as f64,
            must: "from 3 to 1000000",
        });
    }
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(Error::OutOfRange { what: "radius", value: radius, must: "finite and greater than 0" });
    }
    let circle = Circle { plane: *plane, radius };
    let mut points: Vec<Point3> =
        (0..sides).map(|i| circle.at(std::f64::consts::TAU * i as f64 / sides as f64)).collect();
    points.extend(points.first().copied());
    PolylineCurve::new(points)
}
