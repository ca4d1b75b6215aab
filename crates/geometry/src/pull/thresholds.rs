//! The thresholds of `pull`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// A meeting that is this part of the size from a way belongs to it.
pub(super) const NEAR_WAY: f64 = 1e-6;
/// A meeting that is further than this part of the size from its line is none.
pub(super) const MISSES: f64 = 1e-9;
/// A place of the surface this near to the line, as a part of the size, lies on it.
pub(super) const ON_LINE: f64 = 1e-10;
/// Newton's method has come to the line when it misses it by this part of the size.
pub(super) const FOUND: f64 = 1e-13;
/// A line whose cosine with the normal is no larger runs along the surface.
pub(super) const ALONG_SURFACE: f64 = 1e-6;
/// Ends that are no further apart than this part of the size are one, if the tolerance does not say less.
pub(super) const SAME_END: f64 = 1e-6;
/// Ends that are no further apart than this, in model units, are one whatever the tolerance.
pub(super) const LEAST_GAP: f64 = 1e-9;
/// A curve whose height changes by no more than this part of the tolerance is level.
pub(super) const LEVEL: f64 = 1e-3;
/// A corner that turns by no more radians has no gap to fill.
pub(super) const NO_TURN: f64 = 1e-6;
/// The tolerance, in model units, of offsets that are told to be exact.
pub(super) const EXACT_OFFSET: f64 = 1e-9;
/// The tolerance of angles is no less than this many radians.
pub(super) const LEAST_ANGLE: f64 = 1e-6;
