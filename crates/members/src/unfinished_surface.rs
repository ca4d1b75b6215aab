//! A NURBS surface that a script is still writing: as [`UnfinishedNurbs`](crate::UnfinishedNurbs) is for curves.

use katydid_geometry::{Direction, NurbsSurface, Point3, Surface};

use crate::Fault;
use crate::shape::Shape;

/// The most control points of a surface that a script makes.
const MOST: usize = 1_000_000;

/// Degrees, control points, weights and knots that need not make a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct UnfinishedSurface {
    pub(crate) degrees: [usize; 2],
    /// How many control points, along u and along v.
    pub(crate) counts: [usize; 2],
    /// The points, v running fastest.
    pub(crate) points: Vec<Point3>,
    /// One a point for a rational surface, or none.
    pub(crate) weights: Option<Vec<f64>>,
    /// For each direction points + degree − 1 of them, as in openNURBS.
    pub(crate) knots: [Vec<f64>; 2],
}

impl UnfinishedSurface {
    /// Points at the origin with weight 1, and knots that are all 0.
    pub(crate) fn new(degrees: [usize; 2], counts: [usize; 2], rational: bool) -> Result<Self, Fault> {
        for (degree, count) in degrees.iter().zip(counts) {
            if count <= *degree {
                return Err(Fault::bad_request(format!(
                    "a surface of degree {degree} has more than {count} points in that direction"
                )));
            }
        }
        let total = counts[0].saturating_mul(counts[1]);
        if total > MOST {
            return Err(Fault::too_large(format!("{total} control points are more than {MOST}")));
        }
        Ok(Self {
            degrees,
            counts,
            points: vec![Point3::ORIGIN; total],
            weights: rational.then(|| vec![1.0; total]),
            knots: [0, 1].map(|k| vec![0.0; counts[k] + degrees[k] - 1]),
        })
    }

    /// What a surface is made of.
    pub(crate) fn of(nurbs: &NurbsSurface) -> Self {
        Self {
            degrees: nurbs.degrees(),
            counts: nurbs.counts(),
            points: nurbs.control_points(),
            weights: nurbs.is_rational().then(|| nurbs.weights()),
            knots: Direction::BOTH.map(|along| nurbs.knots(along).to_vec()),
        }
    }

    /// The place of a control point in the list; `None` for indices that are not there.
    pub(crate) fn place(&self, i: usize, j: usize) -> Option<usize> {
        (i < self.counts[0] && j < self.counts[1]).then(|| i * self.counts[1] + j)
    }

    /// The weight of a point of the list.
    pub(crate) fn weight(&self, place: usize) -> Option<f64> {
        match &self.weights {
            Some(weights) => weights.get(place).copied(),
            None => self.points.get(place).map(|_| 1.0),
        }
    }

    /// Gives a point of the list a weight; the surface is rational from then on.
    pub(crate) fn set_weight(&mut self, place: usize, weight: f64) {
        let weights = self.weights.get_or_insert_with(|| vec![1.0; self.points.len()]);
        if let Some(own) = weights.get_mut(place) {
            *own = weight;
        }
    }

    /// The surface, once the numbers make one.
    pub(crate) fn shape(self) -> Shape {
        let knots = self.knots.clone();
        let made = match &self.weights {
            None => NurbsSurface::new(self.degrees, self.counts, self.points.clone(), knots),
            Some(weights) => {
                NurbsSurface::with_weights(self.degrees, self.counts, &self.points, weights, knots)
            }
        };
        match made {
            Ok(surface) => Shape::Surface(Surface::from(surface).into()),
            Err(_) => Shape::UnfinishedSurface(self.into()),
        }
    }
}
