//! The thresholds of `serde_forms`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// Axes that are read are unit and at right angles to this: as many digits are written at least.
pub(super) const ROTATION: f64 = 1e-9;
