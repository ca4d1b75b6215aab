//! The thresholds of `cloud`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// A corner this part from the border of the square that stands for the whole plane is on it.
pub(super) const AT_BORDER: f64 = 1e-9;
