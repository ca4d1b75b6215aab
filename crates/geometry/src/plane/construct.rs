//! Planes from what is known of them.

use crate::linear::symmetric_eigen;
use crate::thresholds;
use crate::{Error, Plane, Point3, Result, Vector3};

impl Plane {
    /// The plane through `origin` with a normal; its x axis is [`Vector3::perpendicular`] of the normal.
    ///
    /// # Errors
    /// When the normal has no direction or a number is not finite.
    pub fn from_normal(origin: Point3, normal: Vector3) -> Result<Self> {
        if !origin.is_finite() {
            return Err(Error::NotFinite("plane origin"));
        }
        let z = normal.unitized().ok_or(Error::degenerate("normal", "it has no direction"))?;
        let x = z.perpendicular().ok_or(Error::degenerate("normal", "it has no direction"))?;
        Ok(Self { origin, x_axis: x, y_axis: z.cross(x), z_axis: z })
    }

    /// The plane through three points: origin in the first, x towards the second, the third on the side of +y.
    ///
    /// # Errors
    /// When the points lie on a line or coincide.
    pub fn from_points(a: Point3, b: Point3, c: Point3) -> Result<Self> {
        if !(a.is_finite() && b.is_finite() && c.is_finite()) {
            return Err(Error::NotFinite("plane point"));
        }
        Self::from_axes(a, b - a, c - a)
            .map_err(|_| Error::degenerate("three points", "they lie on one line"))
    }

    /// The plane a·x + b·y + c·z + d = 0, with its origin at the point nearest to the world's.
    ///
    /// # Errors
    /// When a, b and c are all 0 or a number is not finite.
    pub fn from_equation([a, b, c, d]: [f64; 4]) -> Result<Self> {
        let n = Vector3::new(a, b, c);
        let length = n.length();
        let unit = n.unitized().ok_or(Error::degenerate("plane equation", "a, b and c are all 0"))?;
        Self::from_normal((unit * (-d / length)).to_point(), unit)
    }

    /// The plane that fits points best: the sum of squared distances is least. The origin is their mean, and x the
    /// direction in which they spread most. With it the largest distance of a point from the plane.
    ///
    /// # Errors
    /// Fewer than three points, or all of them on one line.
    pub fn fit(points: &[Point3]) -> Result<(Self, f64)> {
        if points.len() < 3 {
            return Err(Error::OutOfRange {
                what: "number of points",
                value: points.len() as f64,
                must: "at least 3",
            });
        }
        let (mean, values, axes) = principal_axes(points)?;
        if values[1] <= values[2] * thresholds::NO_LENGTH_SQUARED {
            return Err(Error::degenerate("points", "they lie on one line"));
        }
        let plane = Self::from_axes(mean, axes[2], axes[1])?;
        let deviation = points.iter().map(|&p| plane.signed_distance(p).abs()).fold(0.0, f64::max);
        Ok((plane, deviation))
    }
}

/// The mean of points, and the eigenvalues (ascending) and unit eigenvectors of their scatter matrix.
pub(crate) fn principal_axes(points: &[Point3]) -> Result<(Point3, [f64; 3], [Vector3; 3])> {
    if points.is_empty() {
        return Err(Error::degenerate("points", "there are none"));
    }
    if !points.iter().all(|p| p.is_finite()) {
        return Err(Error::NotFinite("point"));
    }
    let n = points.len() as f64;
    let mean = points.iter().map(|p| p.to_vector() / n).sum::<Vector3>().to_point();
    let mut m = [[0.0; 3]; 3];
    for &p in points {
        let d: [f64; 3] = (p - mean).into();
        for i in 0..3 {
            for j in 0..3 {
                m[i][j] += d[i] * d[j];
            }
        }
    }
    if !m.iter().flatten().all(|x| x.is_finite()) {
        return Err(Error::NotFinite("square of a distance between points"));
    }
    let (values, vectors) = symmetric_eigen(m);
    Ok((mean, values, vectors.map(Vector3::from)))
}
