//! The curvature along a curve, span by span.

use crate::curve::thresholds::OPEN_QUARTER;
use std::f64::consts::FRAC_PI_2;

use super::Curve;
use super::evaluate::curvature;
use super::piece::{Piece, Shape};
use crate::{Point3, Vector3};

/// A place of a curve with its curvature.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CurvatureSample {
    /// Where, in the domain of the whole curve.
    pub parameter: f64,
    /// The point there.
    pub point: Point3,
    /// The curvature vector: towards the centre of the osculating circle, 1/radius long. At an end of a span it is
    /// that of the span.
    pub curvature: Vector3,
}

/// How often steps are doubled over one span at most: an arc of several turns has that many quarters.
const MOST_QUARTERS: usize = 64;

/// How many stretches a comb counts a piece as; none where it is straight.
fn stretches(piece: &Piece<'_>) -> usize {
    match piece.shape {
        Shape::Segment(..) => 0,
        Shape::Span(curve, _) if curve.degree() < 2 => 0,
        Shape::Span(..) => 1,
        Shape::Arc(arc) => {
            let quarters = (arc.angle.length().abs() / FRAC_PI_2 - OPEN_QUARTER).ceil();
            (quarters.max(1.0) as usize).min(MOST_QUARTERS)
        }
    }
}

impl Curve {
    /// How many spans bend: spans of NURBS curves of degree 2 and more, and begun quarters of arcs.
    pub fn bending_spans(&self) -> usize {
        self.pieces().iter().map(stretches).sum()
    }

    /// The curvature along the curve: a list for each smooth piece that bends, in order, with `steps` even steps of the
    /// parameter a span (see [`Curve::bending_spans`]) and both its ends. Where the curvature jumps between two pieces
    /// the place comes twice, once with the curvature of each.
    pub fn curvature_samples(&self, steps: usize) -> Vec<Vec<CurvatureSample>> {
        let steps = steps.clamp(1, 10_000);
        let sample = |piece: &Piece<'_>, along: f64| {
            let own = piece.own.at(along);
            let [point, d1, d2] = piece.jet(own);
            CurvatureSample {
                parameter: piece.whole_parameter(own),
                point: point.to_point(),
                curvature: curvature(d1, d2),
            }
        };
        let pieces = self.pieces();
        let bending = pieces.iter().map(|piece| (piece, steps * stretches(piece))).filter(|(_, n)| *n > 0);
        bending.map(|(piece, n)| (0..=n).map(|i| sample(piece, i as f64 / n as f64)).collect()).collect()
    }
}
