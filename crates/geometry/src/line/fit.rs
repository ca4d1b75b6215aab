//! Lines through points, and planes through lines.

use crate::plane::principal_axes;
use crate::{Error, Line, Plane, Point3, Result};

impl Line {
    /// The line that fits points best: along the direction in which they spread most, limited by the extreme
    /// projections, from the first point towards the last.
    ///
    /// # Errors
    /// Fewer than two points, or all of them in one place.
    pub fn fit(points: &[Point3]) -> Result<Self> {
        let (mean, values, axes) = principal_axes(points)?;
        if !(values[2] > 0.0) {
            return Err(Error::degenerate("points", "they are all in one place"));
        }
        let mut direction = axes[2];
        if let (Some(&first), Some(&last)) = (points.first(), points.last())
            && (last - first).dot(direction) < 0.0
        {
            direction = -direction;
        }
        let along = points.iter().map(|&p| (p - mean).dot(direction));
        let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), t| (a.min(t), b.max(t)));
        Ok(Self::new(mean + direction * low, mean + direction * high))
    }
}

impl Plane {
    /// The plane through a line and a point beside it: origin at the line's start, x along the line.
    ///
    /// # Errors
    /// When the line has no length or the point lies on it.
    pub fn from_line_and_point(line: &Line, p: Point3) -> Result<Self> {
        Self::from_points(line.from, line.to, p)
    }
}
