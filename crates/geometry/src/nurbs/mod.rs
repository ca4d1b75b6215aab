//! NURBS curves: storage, evaluation and the algorithms on control points and knots.

mod curve;
mod evaluate;
mod knots;

pub use curve::NurbsCurve;
pub use knots::{MAX_DEGREE, check_knots, span_index};
