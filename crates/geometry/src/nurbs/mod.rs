//! NURBS curves and surfaces: storage, evaluation and the algorithms on control points and knots.

mod batch;
mod bezier;
mod blossom;
mod compatible;
mod conic;
mod construction;
mod curve;
mod deviation;
mod evaluate;
mod fit;
mod interpolate;
mod knots;
mod lanes;
mod least_squares;
mod moebius;
mod nets;
mod pieces;
mod properties;
mod reduce;
mod refine;
mod remove;
mod shape;
mod skin;
mod spans;
mod surface;
mod surface_bounds;
mod surface_construct;
mod surface_edit;
mod surface_evaluate;
mod surface_grid;
mod surface_interpolate;
mod surface_properties;
mod surface_refine;
mod surface_through;
mod uniform;
mod weights;

pub(crate) use bezier::span_to_bezier;
pub use compatible::compatible_curves;
pub use construction::{DeBoor, DeBoorStep, bezier_to_hermite, de_casteljau, hermite_to_bezier};
pub use curve::NurbsCurve;
pub(crate) use curve::{Controls, project};
pub use deviation::Approximation;
pub(crate) use evaluate::basis;
pub use interpolate::KnotSpacing;
pub use knots::{MAX_DEGREE, check_knots, span_index};
pub use least_squares::{ExactCondition, LeastSquares, placed_knots};
pub(crate) use nets::Nets;
pub(crate) use skin::{
    Skinning, curve_through, section_parameters, skinned, surface_through, surface_through_pieces,
};
pub(crate) use surface::check_net;
pub use surface::{Direction, NurbsSurface, Quadrant};
pub(crate) use surface_evaluate::MAX_ORDER;
pub use surface_evaluate::SurfaceDerivatives;
pub use surface_properties::Side;
pub use uniform::{clamped_uniform_knots, periodic_uniform_knots};
