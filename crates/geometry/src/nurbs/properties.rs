//! Questions to control points, weights and knots, and changes of weights.

use super::NurbsCurve;
use super::curve::Controls;
use crate::nurbs::thresholds::{EQUAL_WEIGHTS, PERIODIC_KNOTS, PERIODIC_POINTS};
use crate::{Error, Point3, Result, Xform};

impl NurbsCurve {
    /// The Greville abscissae, one a control point: means of `degree` consecutive knots. Each is the parameter at
    /// which its control point acts most.
    pub fn greville_abscissae(&self) -> Vec<f64> {
        self.knots
            .windows(self.degree)
            .map(|w| {
                // Equal knots give themselves, not a rounded mean.
                let (first, last) = (w[0], w[self.degree - 1]);
                if first == last { first } else { w.iter().sum::<f64>() / self.degree as f64 }
            })
            .collect()
    }

    /// Whether both ends have full knot multiplicity: the curve begins and ends in its end control points.
    pub fn is_clamped(&self) -> bool {
        let (n, p) = (self.knots.len(), self.degree);
        self.knots[0] == self.knots[p - 1] && self.knots[n - p] == self.knots[n - 1]
    }

    /// Whether the curve closes smoothly: its degree is at least 2, its first `degree` control points are repeated
    /// at the end, and the knots repeat with the period of the domain.
    pub fn is_periodic(&self) -> bool {
        let (n, p) = (self.point_count(), self.degree);
        if p < 2 || n < p + 2 {
            return false;
        }
        let shift = n - p;
        let tolerance = PERIODIC_KNOTS * self.domain().length();
        let knots_repeat = (0..2 * (p - 1)).all(|i| {
            let step = |k: usize| self.knots[k + 1] - self.knots[k];
            (step(i) - step(i + shift)).abs() <= tolerance
        });
        if !knots_repeat {
            return false;
        }
        let points = self.homogeneous_points();
        let size = points.iter().flatten().fold(1.0_f64, |m, x| m.max(x.abs()));
        (0..p).all(|i| {
            points[i].iter().zip(&points[i + shift]).all(|(a, b)| (a - b).abs() <= PERIODIC_POINTS * size)
        })
    }

    /// The length of the polygon through the control points.
    pub fn control_polygon_length(&self) -> f64 {
        self.control_points().windows(2).map(|w| w[0].distance_to(w[1])).sum()
    }

    /// The control points as a user edits them: those that a periodic curve repeats are left out.
    pub fn distinct_control_points(&self) -> Vec<Point3> {
        let mut points = self.control_points();
        if self.is_periodic() {
            points.truncate(self.point_count() - self.degree);
        }
        points
    }

    /// The same curve with weights, all 1 when it had none.
    #[must_use]
    pub fn to_rational(&self) -> Self {
        let controls = Controls::Rational(self.homogeneous_points());
        Self { degree: self.degree, knots: self.knots.clone(), controls }
    }

    /// The same curve without weights, when they are all equal; otherwise `None`.
    pub fn to_non_rational(&self) -> Option<Self> {
        match &self.controls {
            Controls::Plain(_) => Some(self.clone()),
            Controls::Rational(points) => {
                let w = points.first()?[3];
                points.iter().all(|p| (p[3] - w).abs() <= EQUAL_WEIGHTS * w).then(|| {
                    let plain = points.iter().map(|p| [p[0] / p[3], p[1] / p[3], p[2] / p[3]]).collect();
                    Self { degree: self.degree, knots: self.knots.clone(), controls: Controls::Plain(plain) }
                })
            }
        }
    }

    /// The curve with another weight at control point `i`, which stays where it is; rational from then on.
    ///
    /// # Errors
    /// There is no such control point, or the weight is not a finite number greater than 0.
    pub fn with_weight(&self, i: usize, weight: f64) -> Result<Self> {
        if !(weight > 0.0 && weight.is_finite()) {
            return Err(Error::OutOfRange {
                what: "weight",
                value: weight,
                must: "finite and greater than 0",
            });
        }
        let place = self.control_point(i).ok_or(Error::OutOfRange {
            what: "control point index",
            value: i as f64,
            must: "less than the number of control points",
        })?;
        let mut points = self.homogeneous_points();
        if let Some(p) = points.get_mut(i) {
            *p = [place.x * weight, place.y * weight, place.z * weight, weight];
        }
        Self::rational(self.degree, points, self.knots.clone())
    }

    /// The exact image: control points are mapped, homogeneous ones where the curve is rational or the map
    /// projective.
    ///
    /// # Errors
    /// A projective map sends part of the curve's hull to infinity, or a number overflows.
    pub fn transformed(&self, xform: &Xform) -> Result<Self> {
        let controls = match &self.controls {
            Controls::Plain(points) if xform.is_affine() => {
                Controls::Plain(points.iter().map(|&p| xform.point(p.into()).into()).collect())
            }
            _ => Controls::Rational(
                self.homogeneous_points()
                    .iter()
                    .map(|p| xform.rows.map(|r| r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3] * p[3]))
                    .collect(),
            ),
        };
        Self::from_controls(self.degree, controls, self.knots.clone())
    }
}
