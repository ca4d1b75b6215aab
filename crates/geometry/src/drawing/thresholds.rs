//! The thresholds of `drawing`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// Parts of a feature that are shorter than this part of its domain are left out.
pub(super) const LEAST_SPAN: f64 = 1e-10;
/// Newton's method has come to a crossing when its step is this part of the domain.
pub(super) const STEP_DONE: f64 = 1e-14;
/// A place this part of the tolerance from the border of a face is on it.
pub(super) const ON_SHEET: f64 = 1e-3;
/// A foot is found when it misses by this part of the tolerance.
pub(super) const FOOT_FOUND: f64 = 1e-4;
