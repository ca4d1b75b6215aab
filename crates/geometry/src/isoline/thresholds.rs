//! The thresholds of `isoline`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// A squared distance from a ball is no less than this, so that charges stay numbers.
pub(super) const LEAST_SQUARE: f64 = 1e-100;
/// A value this part of the level from it is on it.
pub(super) const ON_LEVEL: f64 = 1e-9;
/// A side of a cell, of 0…1, that is no longer is not halved again.
pub(super) const SHORTEST: f64 = 1e-14;
