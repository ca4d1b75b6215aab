//! The thresholds that all of the kernel has in common: of what they are a part, and why they are as large as they are.
//! Those of one module stand in its own `thresholds.rs`.
//!
//! A tolerance is the caller's ([`Tolerance`](crate::Tolerance)) and says what may be seen. A threshold is the kernel's: it tells
//! rounding from a difference, and is a part of something whose size is known, so that results do not hang on units.

/// Parameters that differ by no more than this part of their range are one: what is found by halving and by Newton's
/// method is known a thousand times better, and nobody draws anything as small.
pub(crate) const SAME_PARAMETER: f64 = 1e-9;
/// A parameter is known to this part of its range when nothing but rounding of a few steps is between two ways to it.
pub(crate) const EXACT_PARAMETER: f64 = 1e-12;
/// Points that are no further apart than this part of the size of what they lie on are one: far above rounding, far
/// below what a model's tolerance is.
pub(crate) const SAME_POINT: f64 = 1e-9;
/// What coordinates, areas and determinants computed in some steps may be off by, as a part of the size of what they
/// are computed from.
pub(crate) const ROUNDING: f64 = 1e-12;
/// What one formula of a few operations may be off by, as a part of the largest of its terms.
pub(crate) const FEW_ROUNDINGS: f64 = 1e-14;
/// Directions with no larger sine between them (or radians, which is the same here) are parallel: a line as long as
/// the model leaves the other by what [`SAME_POINT`] does not tell.
pub(crate) const PARALLEL: f64 = 1e-9;
/// A product of unit vectors that is no longer than this has no direction but that of its rounding.
pub(crate) const NO_DIRECTION: f64 = 1e-12;
/// An angle that lacks no more than this many radians of a whole turn is one, and may exceed it as much: the ends of
/// circles are computed by some additions.
pub(crate) const WHOLE_TURN: f64 = 1e-12;
/// A polynomial whose value is this part of its largest coefficient is 0 there: a few units in the last place.
pub(crate) const POLYNOMIAL_ZERO: f64 = 1e-15;
/// A step of Newton's method that is this part of the range is the last: the next one would be below the last place.
pub(crate) const NEWTON_DONE: f64 = 1e-15;
/// Divisors are no less than this: quotients of what is 0 stay numbers.
pub(crate) const LEAST_DIVISOR: f64 = 1e-300;
/// A limit may be exceeded by this part of it: what rounding makes of the limit itself is no reason to divide once
/// more.
pub(crate) const OVER_LIMIT: f64 = 1e-9;
/// The step by which derivatives are told by differences, as a part of the range: the third root of rounding, which
/// balances rounding and curvature.
pub(crate) const DIFFERENCE_STEP: f64 = 1e-5;
/// [`ROUNDING`] of a length, squared.
pub(crate) const NO_LENGTH_SQUARED: f64 = 1e-24;
