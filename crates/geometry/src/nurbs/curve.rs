use super::evaluate::{de_boor, derivatives, divided, find_span, jet};
use super::knots::{check_knots, span_index};
use crate::{Error, Interval, Point3, Result, Vector3};

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
        // Whatever takes long makes curves or surfaces all the time.
        crate::cancellation::check()?;
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
        self.point_in(find_span(&self.knots, self.degree, t), t)
    }

    /// The position at `t`, as a vector from the origin, and the derivatives of order 1…K − 1, without allocation; at
    /// a knot those of the span that begins there, with `from_below` of the span that ends there.
    ///
    /// ```
    /// use katydid_geometry::{NurbsCurve, Point3, Vector3};
    /// # fn main() -> katydid_geometry::Result<()> {
    /// let parabola = NurbsCurve::bezier(&[[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [2.0, 0.0, 0.0]].map(Point3::from))?;
    /// let [position, velocity, acceleration] = parabola.jet_at(0.5, false);
    /// assert_eq!(position, Vector3::new(1.0, 1.0, 0.0));
    /// assert_eq!(velocity, Vector3::new(2.0, 0.0, 0.0));
    /// assert_eq!(acceleration, Vector3::new(0.0, -8.0, 0.0));
    /// # Ok(())
    /// # }
    /// ```
    #[inline]
    pub fn jet_at<const K: usize>(&self, t: f64, from_below: bool) -> [Vector3; K] {
        let j = match from_below {
            true => span_index(&self.knots, self.degree, t, true),
            false => find_span(&self.knots, self.degree, t),
        };
        self.jet(j, t)
    }

    /// The position at `t`, as a vector from the origin, and then the derivatives of order 1, 2, … as far as there
    /// are places (65 at most; the rest stay as they are), without allocation. Sides as in [`NurbsCurve::jet_at`].
    ///
    /// Rational curves by the quotient rule (P&T, algorithm A4.2).
    pub fn derivatives_into(&self, t: f64, from_below: bool, out: &mut [Vector3]) {
        let out = match out.len() {
            0..=65 => out,
            _ => &mut out[..65],
        };
        match out {
            [a, b] => return [*a, *b] = self.jet_at(t, from_below),
            [a, b, c] => return [*a, *b, *c] = self.jet_at(t, from_below),
            [a, b, c, d] => return [*a, *b, *c, *d] = self.jet_at(t, from_below),
            _ => {}
        }
        let j = span_index(&self.knots, self.degree, t, from_below);
        match &self.controls {
            Controls::Plain(p) => {
                let mut d = [[0.0; 3]; 65];
                derivatives(self.degree, &self.knots, p, j, t, &mut d[..out.len()]);
                for (slot, d) in out.iter_mut().zip(d) {
                    *slot = d.into();
                }
            }
            Controls::Rational(p) => {
                let mut d = [[0.0; 4]; 65];
                derivatives(self.degree, &self.knots, p, j, t, &mut d[..out.len()]);
                let w = d[0][3];
                for k in 0..out.len() {
                    let mut v = Vector3::new(d[k][0], d[k][1], d[k][2]);
                    let mut choose = 1.0;
                    for i in 1..=k {
                        choose = choose * (k - i + 1) as f64 / i as f64;
                        v -= out[k - i] * (choose * d[i][3]);
                    }
                    out[k] = v / w;
                }
            }
        }
    }

    /// The point at `t` and the derivatives of order 1…`count`; at a knot those of the span that begins there, with
    /// `from_below` of the span that ends there. Derivatives of order above 64 are not given.
    ///
    /// Rational curves by the quotient rule (P&T, algorithm A4.2).
    pub fn derivatives(&self, t: f64, count: usize, from_below: bool) -> (Point3, Vec<Vector3>) {
        let mut out = vec![Vector3::ZERO; count.min(64) + 1];
        self.derivatives_into(t, from_below, &mut out);
        let point = out.remove(0).to_point();
        (point, out)
    }

    /// The position and K − 1 derivatives in span `j`, without allocation.
    #[inline]
    pub(crate) fn jet<const K: usize>(&self, j: usize, t: f64) -> [Vector3; K] {
        match &self.controls {
            Controls::Plain(p) => jet(self.degree, &self.knots, p, j, t).map(Vector3::from),
            Controls::Rational(p) => divided(&jet(self.degree, &self.knots, p, j, t)).map(Vector3::from),
        }
    }

    /// The point in span `j`.
    #[inline]
    pub(crate) fn point_in(&self, j: usize, t: f64) -> Point3 {
        match &self.controls {
            Controls::Plain(p) => de_boor(self.degree, &self.knots, p, j, t).into(),
            Controls::Rational(p) => project(de_boor(self.degree, &self.knots, p, j, t)),
        }
    }

    /// The first derivative in span `j`.
    #[cfg(test)]
    #[inline]
    pub(crate) fn velocity(&self, j: usize, t: f64) -> Vector3 {
        let [_, velocity] = self.jet(j, t);
        velocity
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
}

/// The point of homogeneous coordinates.
#[inline]
pub(crate) fn project(p: [f64; 4]) -> Point3 {
    Point3::new(p[0] / p[3], p[1] / p[3], p[2] / p[3])
}
