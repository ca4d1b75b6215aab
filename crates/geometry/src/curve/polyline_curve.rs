use crate::{Error, Interval, Point3, Result};

/// A chain of straight segments with a parameter at every vertex.
///
/// There are at least two vertices and as many parameters, and the parameters increase.
#[derive(Debug, Clone, PartialEq)]
pub struct PolylineCurve {
    points: Vec<Point3>,
    parameters: Vec<f64>,
}

impl PolylineCurve {
    /// The polyline with parameters 0, 1, 2, … at its vertices.
    ///
    /// # Errors
    /// Fewer than two points, or a coordinate that is not finite.
    pub fn new(points: Vec<Point3>) -> Result<Self> {
        let parameters = (0..points.len()).map(|i| i as f64).collect();
        Self::with_parameters(points, parameters)
    }

    /// The polyline with a given parameter at each vertex.
    ///
    /// # Errors
    /// Fewer than two points, another count of parameters, parameters that do not increase, or a number that is
    /// not finite.
    pub fn with_parameters(points: Vec<Point3>, parameters: Vec<f64>) -> Result<Self> {
        if points.len() < 2 {
            return Err(Error::Invalid {
                what: "polyline",
                why: format!("it needs at least 2 points, got {}", points.len()),
            });
        }
        if parameters.len() != points.len() {
            return Err(Error::Invalid {
                what: "polyline",
                why: format!("{} points but {} parameters", points.len(), parameters.len()),
            });
        }
        if !points.iter().all(|p| p.is_finite()) {
            return Err(Error::NotFinite("polyline point"));
        }
        if !parameters.iter().all(|t| t.is_finite()) {
            return Err(Error::NotFinite("polyline parameter"));
        }
        if parameters.windows(2).any(|w| w[0] >= w[1]) {
            return Err(Error::Invalid { what: "polyline", why: "its parameters do not increase".into() });
        }
        Ok(Self { points, parameters })
    }

    /// Parts that are known to fit.
    pub(super) fn from_checked(points: Vec<Point3>, parameters: Vec<f64>) -> Self {
        Self { points, parameters }
    }

    /// The vertices; a closed polyline repeats its first vertex at the end.
    #[inline]
    pub fn points(&self) -> &[Point3] {
        &self.points
    }

    /// The parameter of each vertex.
    #[inline]
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// The number of segments.
    #[inline]
    pub fn segment_count(&self) -> usize {
        self.points.len() - 1
    }

    /// The parameters of the first and last vertex.
    pub fn domain(&self) -> Interval {
        match (self.parameters.first(), self.parameters.last()) {
            (Some(&a), Some(&b)) => Interval::new(a, b),
            _ => Interval::UNIT,
        }
    }

    /// The index of the segment that holds parameter `t`: at a vertex the one that begins there, outside the
    /// domain the first or last.
    pub fn segment_at(&self, t: f64) -> usize {
        self.parameters.partition_point(|&p| p <= t).saturating_sub(1).min(self.segment_count() - 1)
    }

    /// The point at parameter `t`; beyond the domain the end segments go on straight.
    pub fn point_at(&self, t: f64) -> Point3 {
        let i = self.segment_at(t);
        let x = Interval::new(self.parameters[i], self.parameters[i + 1]).normalized(t);
        if x == 1.0 {
            return self.points[i + 1];
        }
        self.points[i].lerp(self.points[i + 1], x)
    }

    /// Points and parameters, for code that takes the polyline apart.
    pub fn into_parts(self) -> (Vec<Point3>, Vec<f64>) {
        (self.points, self.parameters)
    }
}
