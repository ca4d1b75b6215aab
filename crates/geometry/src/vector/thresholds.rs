//! The thresholds of `vector`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// Between these squares of lengths neither underflow nor overflow has taken digits.
pub(super) const SAFE_SQUARE: [f64; 2] = [1e-290, 1e290];
