//! The thresholds of `silhouette`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// The step along a trim, as a part of its domain, by which it is told how its image moves.
pub(super) const SIGHT_STEP: f64 = 1e-6;
/// The place of a trim beside a point is found when the last step is this part of the one by which derivatives are
/// told.
pub(super) const FOOT_FOUND: f64 = 1e-3;
/// The step along a trim, as a part of its domain, by which it is told where its face lies.
pub(super) const ASIDE: f64 = 1e-4;
/// Kinds of edges are told this part of the domain from their ends, where other faces are near.
pub(super) const INSIDE_ENDS: f64 = 1e-5;
/// Where the silhouette passes from patch to patch is known to this part of the patch.
pub(super) const STRETCH: f64 = 1e-12;
/// Ends of silhouettes that are no further apart than this part of the size are one, if the tolerance does not say
/// less.
pub(super) const SAME_END: f64 = 1e-7;
/// A direction that is this part of the terms it is a difference of is not told.
pub(super) const NO_WAY: f64 = 1e-6;
/// A part of a unit vector across another one that is no longer has no direction worth the name: half of the digits
/// are gone.
pub(super) const LEVEL_SINE: f64 = 1e-6;
