//! The thresholds of `offset`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// Parts of a span of 0…1 between inversions that are no longer are left out.
pub(super) const SHORTEST_SPAN: f64 = 1e-12;
/// A leg of the control polygon that is this part of its reach has no length.
pub(super) const STANDS_STILL: f64 = 1e-9;
/// Terms that are the square of the error are rounding to this part of them.
pub(super) const OFFSET_ROUNDING: f64 = 1e-6;
/// A turn that lacks no more than this many radians of half a turn goes straight back.
pub(super) const REVERSED: f64 = 1e-7;
/// A gap that is no more than this part of the largest one to close is none.
pub(super) const NO_GAP: f64 = 1e-2;
/// A place this part of the domain from both ends is inside.
pub(super) const INSIDE: f64 = 1e-6;
/// A corner opens enough to be sharp when 1 + the cosine between its normals is above this: its tip is no further
/// away than 45 distances.
pub(super) const SHARPEST: f64 = 1e-3;
/// The tolerance, in model units, of offsets that are told to be exact.
pub(super) const EXACT_OFFSET: f64 = 1e-9;
/// The tolerance of angles, in radians, of offsets that are told to be exact.
pub(super) const EXACT_ANGLE: f64 = 1e-7;
/// A curve whose plane's normal has no larger angle with the given one, in radians, is parallel to it.
pub(super) const LEVEL: f64 = 1e-6;
/// Offset lines meet when 1 + the cosine between their normals is above this.
pub(super) const TURNS_BACK: f64 = 1e-9;
/// Crossings are looked for to this part of the size, if the tolerance does not ask for less.
pub(super) const FINE_OF_SIZE: f64 = 1e-10;
/// Cuts that are no further apart than this part of the size are one, if the tolerance does not ask for less.
pub(super) const CUT_OF_SIZE: f64 = 2e-9;
/// Cuts whose parameters differ by no more than this part of the domain are one.
pub(super) const CUT_PARAMETER: f64 = 1e-10;
/// A turn with a smaller sine has no side.
pub(super) const CUSP_SIDE: f64 = 1e-7;
/// Roots that are nearer than this to the ends of a span of 0…1 are the ends.
pub(super) const INSIDE_UNIT: f64 = 1e-6;
