//! The thresholds of `nurbs`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// An arc has another span when it exceeds the last quarter turn by this part of it.
pub(super) const OPEN_QUARTER: f64 = 1e-9;
/// First derivatives on both sides of a knot that differ by no more than this part make no kink.
pub(super) const KINK: f64 = 1e-9;
/// Knots that should increase do so by this part of them at least.
pub(super) const KNOT_STEP: f64 = 1e-12;
/// Steps between parameters are no shorter than this part of their sum, so that points that coincide have parameters
/// of their own.
pub(super) const LEAST_CHORD: f64 = 1e-12;
/// A pivot that is this part of the largest is rounding.
pub(super) const NO_PIVOT: f64 = 1e-14;
/// Steps of knots that differ by no more than this part of the domain are equal.
pub(super) const PERIODIC_KNOTS: f64 = 1e-10;
/// Control points that differ by no more than this part of the size are equal.
pub(super) const PERIODIC_POINTS: f64 = 1e-12;
/// Weights that differ by no more than this part are equal.
pub(super) const EQUAL_WEIGHTS: f64 = 1e-15;
/// Weights of two curves that differ by no more than this part are one but for the rounding of knots put in.
pub(super) const SAME_WEIGHTS: f64 = 1e-12;
/// Rounding of a reduced degree as a part of the size of the control points.
pub(super) const REDUCTION_ROUNDING: f64 = 1e-13;
/// Knots that differ by no more than this part of their size are one.
pub(super) const SAME_KNOT: f64 = 1e-14;
/// Rounding of a knot's removal as a part of the size and the place of the control points.
pub(super) const REMOVAL_ROUNDING: f64 = 1e-14;
/// A second derivative that moves a point by no more than this part of the size over the span is none.
pub(super) const STRAIGHT_SPAN: f64 = 1e-8;
/// Sections whose parameters differ by no more than this part stand at one place.
pub(super) const SKIN_STEP: f64 = 1e-9;
/// A bound must exceed what was found by this part of the size to be looked at.
pub(super) const BOUND_SLACK: f64 = 1e-12;
/// Control points that differ by more than this part of the size are different.
pub(super) const COLUMN_DIFFERENCE: f64 = 1e-9;
/// Control points that leave a plane by no more than this part of their distance from the origin lie in it whatever
/// the tolerance.
pub(super) const PLANAR_ROUNDING: f64 = 1e-15;
