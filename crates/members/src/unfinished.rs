//! A NURBS curve that a script is still writing: RhinoCommon's constructor gives one whose knots are all 0, and points and
//! knots are set one by one. [`NurbsCurve`] holds sound curves only, so what is not sound yet stands here.

use katydid_geometry::{Curve, NurbsCurve, Point3};

use crate::Fault;
use crate::shape::Shape;

/// Degree, control points, weights and knots that need not make a curve.
#[derive(Debug, Clone, PartialEq)]
pub struct UnfinishedNurbs {
    pub(crate) degree: usize,
    pub(crate) points: Vec<Point3>,
    /// One a point for a rational curve, or none.
    pub(crate) weights: Option<Vec<f64>>,
    /// Points + degree − 1 of them, as in openNURBS.
    pub(crate) knots: Vec<f64>,
}

impl UnfinishedNurbs {
    /// Points at the origin with weight 1, and knots that are all 0.
    pub(crate) fn new(degree: usize, count: usize, rational: bool) -> Result<Self, Fault> {
        if count <= degree {
            return Err(Fault::bad_request(format!(
                "a curve of degree {degree} has more than {count} points"
            )));
        }
        Ok(Self {
            degree,
            points: vec![Point3::ORIGIN; count],
            weights: rational.then(|| vec![1.0; count]),
            knots: vec![0.0; count + degree - 1],
        })
    }

    /// What a curve is made of.
    pub(crate) fn of(nurbs: &NurbsCurve) -> Self {
        let points = nurbs.control_points();
        let weight = |i| nurbs.weight(i).unwrap_or(1.0);
        let weights = nurbs.is_rational().then(|| (0..points.len()).map(weight).collect());
        Self { degree: nurbs.degree(), points, weights, knots: nurbs.knots().to_vec() }
    }

    /// The weight of a point; `None` beyond the last.
    pub(crate) fn weight(&self, place: usize) -> Option<f64> {
        match &self.weights {
            Some(weights) => weights.get(place).copied(),
            None => self.points.get(place).map(|_| 1.0),
        }
    }

    /// Gives a point a weight; the curve is rational from then on. Whether there is such a point.
    pub(crate) fn set_weight(&mut self, place: usize, weight: f64) -> bool {
        let weights = self.weights.get_or_insert_with(|| vec![1.0; self.points.len()]);
        weights.get_mut(place).map(|own| *own = weight).is_some()
    }

    /// The curve, once the numbers make one.
    pub(crate) fn shape(self) -> Shape {
        let made = match &self.weights {
            None => NurbsCurve::new(self.degree, self.points.clone(), self.knots.clone()),
            Some(weights) => NurbsCurve::with_weights(self.degree, &self.points, weights, self.knots.clone()),
        };
        match made {
            Ok(curve) => Shape::Curve(Curve::from(curve).into()),
            Err(_) => Shape::Unfinished(self.into()),
        }
    }
}
