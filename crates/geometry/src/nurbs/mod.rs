//! NURBS curves: storage, evaluation and the algorithms on control points and knots.

mod blossom;
mod conic;
mod construction;
mod curve;
mod evaluate;
mod interpolate;
mod knots;
mod moebius;
mod pieces;
mod properties;
mod refine;
mod spans;
mod uniform;

pub use construction::{DeBoor, DeBoorStep, bezier_to_hermite, de_casteljau, hermite_to_bezier};
#[cfg(feature = "serde")]
pub(crate) use curve::Controls;
pub use curve::NurbsCurve;
pub(crate) use curve::project;
pub use interpolate::KnotSpacing;
pub use knots::{MAX_DEGREE, check_knots, span_index};
pub use uniform::{clamped_uniform_knots, periodic_uniform_knots};
