//! NURBS curves and surfaces: storage, evaluation and the algorithms on control points and knots.

mod batch;
mod bezier;
mod blossom;
mod conic;
mod construction;
mod curve;
mod deviation;
mod evaluate;
mod fit;
mod interpolate;
mod knots;
mod least_squares;
mod moebius;
mod pieces;
mod properties;
mod reduce;
mod refine;
mod remove;
mod shape;
mod spans;
mod surface;
mod surface_evaluate;
mod uniform;

pub use construction::{DeBoor, DeBoorStep, bezier_to_hermite, de_casteljau, hermite_to_bezier};
pub use curve::NurbsCurve;
pub(crate) use curve::project;
pub use deviation::Approximation;
pub use interpolate::KnotSpacing;
pub use knots::{MAX_DEGREE, check_knots, span_index};
pub use least_squares::{ExactCondition, LeastSquares, placed_knots};
pub use surface::{Direction, NurbsSurface, Quadrant};
pub use surface_evaluate::SurfaceDerivatives;
pub use uniform::{clamped_uniform_knots, periodic_uniform_knots};
