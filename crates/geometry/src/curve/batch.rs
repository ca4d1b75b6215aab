//! Curves of any kind at many parameters.

use super::Curve;
use crate::{Point3, Vector3};

impl Curve {
    /// The points at many parameters: [`Curve::point_at`] for each, within a few units in the last place. NURBS curves
    /// are fastest when the parameters are sorted, and take long lists in parallel with the `parallel` feature.
    pub fn points_at(&self, parameters: &[f64]) -> Vec<Point3> {
        let mut out = vec![Point3::ORIGIN; parameters.len()];
        self.points_into(parameters, &mut out);
        out
    }

    /// [`Curve::points_at`] without allocation: as many points as there are both parameters and places.
    pub fn points_into(&self, parameters: &[f64], out: &mut [Point3]) {
        match self {
            Self::Nurbs(c) => c.points_into(parameters, out),
            _ => {
                for (slot, &t) in out.iter_mut().zip(parameters) {
                    *slot = self.point_at(t);
                }
            }
        }
    }

    /// The position at `t`, as a vector from the origin, and the derivatives of order 1…K − 1, without allocation; at
    /// a joint those of the piece that begins there, with `from_below` of the piece that ends there.
    pub fn jet_at<const K: usize>(&self, t: f64, from_below: bool) -> [Vector3; K] {
        match self {
            Self::Nurbs(c) => c.jet_at(t, from_below),
            _ => {
                let mut out = [Vector3::ZERO; K];
                self.derivatives_into(t, from_below, &mut out);
                out
            }
        }
    }

    /// At many parameters the position, as a vector from the origin, and K − 1 derivatives: [`Curve::jet_at`] for
    /// each, at joints of the piece that begins there.
    pub fn jets_at<const K: usize>(&self, parameters: &[f64]) -> Vec<[Vector3; K]> {
        match self {
            Self::Nurbs(c) => c.jets_at(parameters),
            _ => parameters.iter().map(|&t| self.jet_at(t, false)).collect(),
        }
    }
}
