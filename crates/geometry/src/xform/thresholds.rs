//! The thresholds of `xform`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// A cosine or sine that is no larger locks the other two angles together: only their sum is told.
pub(super) const LOCKED: f64 = 1e-12;
/// A determinant, or a pivot, that is this part of what it is computed from is rounding.
pub(super) const NO_INVERSE: f64 = 1e-15;
/// A map turns when its columns are unit and at right angles to this.
pub(super) const ROTATION: f64 = 1e-9;
/// Columns whose product is this part of their lengths are at right angles to the last place.
pub(super) const JACOBI: f64 = 1e-16;
/// Unit vectors whose sine is no larger are parallel to the last place: nothing is turned, or half a turn.
pub(super) const NO_TURN: f64 = 1e-15;
