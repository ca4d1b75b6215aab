use super::evaluate::{de_boor, derivatives, many};
use super::knots::{check_knots, span_index};
use crate::{Error, Interval, Point3, Result, Vector3};

/// How many parameters one task takes: some 100 µs of work.
#[cfg(feature = "parallel")]
const CHUNK: usize = 8192;

/// The control points in the form that evaluation wants: weights only where they are needed.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Controls {
    Plain(Vec<[f64; 3]>),
    Rational(Vec<[f64; 4]>),
}

/// A NURBS curve: a degree, knots in the openNURBS form (control points + degree − 1 of them), and control points.
///
/// A rational curve stores its control points homogeneous, (wx, wy, wz, w); accessors say which form they give.
/// Every value of this type is valid: the constructors check and say what is wrong.
#[derive(Debug, Clone, PartialEq)]
pub struct NurbsCurve {
    pub(crate) degree: usize,
    pub(crate) knots: Vec<f64>,
    pub(crate) controls: Controls,
}

impl NurbsCurve {
    /// The non-rational curve of a degree through its control polygon.
    ///
    /// # Errors
    /// The knots do not fit (see [`crate::check_knots`]) or a coordinate is not finite.
    pub fn new(degree: usize, points: Vec<Point3>, knots: Vec<f64>) -> Result<Self> {
        Self::from_controls(degree, Controls::Plain(points.into_iter().map(Into::into).collect()), knots)
    }

    /// The rational curve with homogeneous control points (wx, wy, wz, w).
    ///
    /// # Errors
    /// The knots do not fit, a number is not finite, or a weight is not greater than 0.
    pub fn rational(degree: usize, points: Vec<[f64; 4]>, knots: Vec<f64>) -> Result<Self> {
        Self::from_controls(degree, Controls::Rational(points), knots)
    }

    /// The rational curve with control points in space and their weights.
    ///
    /// # Errors
    /// As [`NurbsCurve::rational`], and when the counts of points and weights differ.
    pub fn with_weights(degree: usize, points: &[Point3], weights: &[f64], knots: Vec<f64>) -> Result<Self> {
        if points.len() != weights.len() {
            return Err(Error::Invalid {
                what: "NURBS curve",
                why: format!("{} control points but {} weights", points.len(), weights.len()),
            });
        }
        let points = points.iter().zip(weights).map(|(p, &w)| [p.x * w, p.y * w, p.z * w, w]).collect();
        Self::rational(degree, points, knots)
    }

    pub(crate) fn from_controls(degree: usize, controls: Controls, knots: Vec<f64>) -> Result<Self> {
        let finite = match &controls {
            Controls::Plain(p) => p.iter().flatten().all(|x| x.is_finite()),
            Controls::Rational(p) => p.iter().flatten().all(|x| x.is_finite()),
        };
        if !finite {
            return Err(Error::NotFinite("NURBS control point"));
        }
        let curve = Self { degree, knots, controls };
        check_knots(degree, curve.point_count(), &curve.knots)?;
        if let Controls::Rational(points) = &curve.controls
            && let Some(i) = points.iter().position(|p| p[3] <= 0.0)
        {
            return Err(Error::Invalid {
                what: "NURBS curve",
                why: format!("weight {i} is {}, which must be greater than 0", points[i][3]),
            });
        }
        Ok(curve)
    }

    /// The degree, at least 1.
    #[inline]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The order, degree + 1.
    #[inline]
    pub fn order(&self) -> usize {
        self.degree + 1
    }

    /// The knots in the openNURBS form: control points + degree − 1.
    #[inline]
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// The knots as textbooks write them: one more at each end, control points + degree + 1.
    pub fn textbook_knots(&self) -> Vec<f64> {
        let mut knots = Vec::with_capacity(self.knots.len() + 2);
        knots.extend(self.knots.first());
        knots.extend_from_slice(&self.knots);
        knots.extend(self.knots.last());
        knots
    }

    /// The number of control points.
    #[inline]
    pub fn point_count(&self) -> usize {
        match &self.controls {
            Controls::Plain(p) => p.len(),
            Controls::Rational(p) => p.len(),
        }
    }

    /// Whether the curve carries weights. They may still all be equal.
    #[inline]
    pub fn is_rational(&self) -> bool {
        matches!(self.controls, Controls::Rational(_))
    }

    /// Control point `i` in space: divided by its weight.
    pub fn control_point(&self, i: usize) -> Option<Point3> {
        match &self.controls {
            Controls::Plain(p) => p.get(i).map(|&p| p.into()),
            Controls::Rational(p) => p.get(i).map(|&p| project(p)),
        }
    }

    /// The control points in space.
    pub fn control_points(&self) -> Vec<Point3> {
        match &self.controls {
            Controls::Plain(p) => p.iter().map(|&p| p.into()).collect(),
            Controls::Rational(p) => p.iter().map(|&p| project(p)).collect(),
        }
    }

    /// Control point `i` in homogeneous form, (wx, wy, wz, w).
    pub fn homogeneous_point(&self, i: usize) -> Option<[f64; 4]> {
        match &self.controls {
            Controls::Plain(p) => p.get(i).map(|&[x, y, z]| [x, y, z, 1.0]),
            Controls::Rational(p) => p.get(i).copied(),
        }
    }

    /// The control points in homogeneous form.
    pub fn homogeneous_points(&self) -> Vec<[f64; 4]> {
        match &self.controls {
            Controls::Plain(p) => p.iter().map(|&[x, y, z]| [x, y, z, 1.0]).collect(),
            Controls::Rational(p) => p.clone(),
        }
    }

    /// The weight of control point `i`, 1 in a non-rational curve.
    pub fn weight(&self, i: usize) -> Option<f64> {
        self.homogeneous_point(i).map(|p| p[3])
    }

    /// The weights of all control points.
    pub fn weights(&self) -> Vec<f64> {
        match &self.controls {
            Controls::Plain(p) => vec![1.0; p.len()],
            Controls::Rational(p) => p.iter().map(|p| p[3]).collect(),
        }
    }

    /// The parameters of start and end: `knots[degree − 1]` and `knots[control points − 1]`.
    pub fn domain(&self) -> Interval {
        let at = |i: usize| self.knots.get(i).copied().unwrap_or(0.0);
        Interval::new(at(self.degree - 1), at(self.knots.len() - self.degree))
    }

    /// The point at `t`. Outside the domain the polynomial of the first or last span goes on.
    #[inline]
    pub fn point_at(&self, t: f64) -> Point3 {
        let j = span_index(&self.knots, self.degree, t, false);
        match &self.controls {
            Controls::Plain(p) => de_boor(self.degree, &self.knots, p, j, t).into(),
            Controls::Rational(p) => project(de_boor(self.degree, &self.knots, p, j, t)),
        }
    }

    /// The point at `t` and the derivatives of order 1…`count`; at a knot those of the span that begins there, with
    /// `from_below` of the span that ends there. Derivatives of order above 64 are not given.
    ///
    /// Rational curves by the quotient rule (P&T, algorithm A4.2).
    pub fn derivatives(&self, t: f64, count: usize, from_below: bool) -> (Point3, Vec<Vector3>) {
        let count = count.min(64);
        let j = span_index(&self.knots, self.degree, t, from_below);
        match &self.controls {
            Controls::Plain(p) => {
                let mut d = vec![[0.0; 3]; count + 1];
                derivatives(self.degree, &self.knots, p, j, t, &mut d);
                (d[0].into(), d[1..].iter().map(|&v| v.into()).collect())
            }
            Controls::Rational(p) => {
                let mut d = vec![[0.0; 4]; count + 1];
                derivatives(self.degree, &self.knots, p, j, t, &mut d);
                let point = project(d[0]);
                let mut out: Vec<Vector3> = Vec::with_capacity(count);
                for k in 1..=count {
                    let mut v = Vector3::new(d[k][0], d[k][1], d[k][2]) - point.to_vector() * d[k][3];
                    let mut choose = 1.0;
                    for i in 1..k {
                        choose = choose * (k - i + 1) as f64 / i as f64;
                        v -= out[k - i - 1] * (choose * d[i][3]);
                    }
                    out.push(v / d[0][3]);
                }
                (point, out)
            }
        }
    }

    /// The point and the first two derivatives in span `j`, without allocation.
    pub(crate) fn jet(&self, j: usize, t: f64) -> [Vector3; 3] {
        match &self.controls {
            Controls::Plain(p) => {
                let mut d = [[0.0; 3]; 3];
                derivatives(self.degree, &self.knots, p, j, t, &mut d);
                d.map(Vector3::from)
            }
            Controls::Rational(p) => {
                let mut d = [[0.0; 4]; 3];
                derivatives(self.degree, &self.knots, p, j, t, &mut d);
                let v = d.map(|[x, y, z, _]| Vector3::new(x, y, z));
                let [w0, w1, w2] = d.map(|d| d[3]);
                let c0 = v[0] / w0;
                let c1 = (v[1] - c0 * w1) / w0;
                let c2 = (v[2] - c1 * (2.0 * w1) - c0 * w2) / w0;
                [c0, c1, c2]
            }
        }
    }

    /// The first derivative in span `j`.
    #[cfg(test)]
    pub(crate) fn velocity(&self, j: usize, t: f64) -> Vector3 {
        match &self.controls {
            Controls::Plain(p) => {
                let mut d = [[0.0; 3]; 2];
                derivatives(self.degree, &self.knots, p, j, t, &mut d);
                d[1].into()
            }
            Controls::Rational(p) => {
                let mut d = [[0.0; 4]; 2];
                derivatives(self.degree, &self.knots, p, j, t, &mut d);
                let point = project(d[0]).to_vector();
                (Vector3::new(d[1][0], d[1][1], d[1][2]) - point * d[1][3]) / d[0][3]
            }
        }
    }

    /// The control points in space that act in span `j`: their hull holds it.
    pub(crate) fn span_hull(&self, j: usize) -> impl Iterator<Item = Point3> + '_ {
        (j..=j + self.degree).filter_map(|i| self.control_point(i))
    }

    /// The homogeneous control points of the Bézier form of span `j`.
    pub(crate) fn bezier_points(&self, j: usize) -> Vec<[f64; 4]> {
        let (a, b) = (self.knots[j + self.degree - 1], self.knots[j + self.degree]);
        let p = self.degree;
        let knots: Vec<f64> = std::iter::repeat_n(a, p).chain(std::iter::repeat_n(b, p)).collect();
        match &self.controls {
            Controls::Plain(points) => {
                let piece = super::blossom::over_knots(p, &self.knots, points, &knots);
                piece.unwrap_or_default().iter().map(|&[x, y, z]| [x, y, z, 1.0]).collect()
            }
            Controls::Rational(points) => {
                super::blossom::over_knots(p, &self.knots, points, &knots).unwrap_or_default()
            }
        }
    }

    /// The indices of the spans that are not empty.
    pub(crate) fn spans(&self) -> impl Iterator<Item = usize> + '_ {
        let p = self.degree;
        (0..self.knots.len() + 1 - 2 * p).filter(move |&j| self.knots[j + p - 1] < self.knots[j + p])
    }

    /// The points at many parameters, fastest when they are sorted. Long lists run in parallel with the `parallel`
    /// feature; the result is the same to the last bit.
    pub fn points_at(&self, parameters: &[f64]) -> Vec<Point3> {
        #[cfg(feature = "parallel")]
        if parameters.len() >= 2 * CHUNK {
            use rayon::prelude::*;
            return parameters.par_chunks(CHUNK).flat_map_iter(|part| self.points_of(part)).collect();
        }
        self.points_of(parameters)
    }

    fn points_of(&self, parameters: &[f64]) -> Vec<Point3> {
        let mut out = Vec::with_capacity(parameters.len());
        match &self.controls {
            Controls::Plain(p) => many(self.degree, &self.knots, p, parameters, |p| out.push(p.into())),
            Controls::Rational(p) => many(self.degree, &self.knots, p, parameters, |p| out.push(project(p))),
        }
        out
    }
}

/// The point of homogeneous coordinates.
#[inline]
pub(crate) fn project(p: [f64; 4]) -> Point3 {
    Point3::new(p[0] / p[3], p[1] / p[3], p[2] / p[3])
}
