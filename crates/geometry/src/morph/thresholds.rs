//! The thresholds of `morph`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// Curves meet a seam when they come this near to its plane, in model units.
pub(super) const AT_SEAM: f64 = 1e-9;
/// A direction whose part across another one is no longer gives no side.
pub(super) const NO_SIDE: f64 = 1e-6;
