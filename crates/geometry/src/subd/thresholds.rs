//! The thresholds of `subd`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// A fit must be better by this to be another one.
pub(super) const BETTER: f64 = 1e-12;
/// A cosine must be larger by this to be a better one.
pub(super) const BETTER_COSINE: f64 = 1e-9;
/// A net has settled when it moves by this part of the mean length.
pub(super) const SETTLED: f64 = 1e-9;
