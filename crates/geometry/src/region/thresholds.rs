//! The thresholds of `region`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// A corner of a hull that turns by a smaller sine is none.
pub(super) const CONVEX_TURN: f64 = 1e-14;
/// Crossings are looked for to this part of the size, if the tolerance is not less.
pub(super) const MEETS_FINE: f64 = 1e-11;
/// No tolerance below this part of the scale is tried: crossings are off by as much.
pub(super) const FINEST: f64 = 4e-12;
/// Crossings with a circle about a node are found to this part of the scale.
pub(super) const CIRCLE_CROSSING: f64 = 1e-13;
/// A curve that leaves the plane by this part of the scale lies in it.
pub(super) const ON_PLANE: f64 = 1e-13;
/// A place this part of a range from its ends is inside.
pub(super) const INSIDE: f64 = 1e-6;
