//! The thresholds of `brep/fillet`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// A patch of a sphere keeps this many radians from its poles.
pub(super) const FROM_POLE: f64 = 1e-3;
/// A face lies in a plane when it leaves it by no more than this part of the size: what carriers inside NURBS
/// surfaces are known to.
pub(super) const FLAT_CARRIER: f64 = 1e-10;
/// A face whose normal has no larger cosine with a straight edge runs along it: the section there has no end.
pub(super) const ALONG_FACE: f64 = 1e-3;
/// An end of an edge whose slant has no larger sine is square.
pub(super) const LEAST_SLANT: f64 = 1e-6;
/// Radii that differ by no more than this part of the larger are equal.
pub(super) const EQUAL_RADII: f64 = 1e-6;
/// Boxes of curves that may meet are taken larger by this part of their size.
pub(super) const BOX_REACH: f64 = 1e-5;
/// The step along an edge, as a part of its domain, by which the turn of a section is told at an end.
pub(super) const SECTION_STEP: f64 = 1e-3;
/// The step along a strip, as a part of it, by which it is told how fast the centre of the ball moves.
pub(super) const TANGENT_STEP: f64 = 1e-6;
/// A contact is on the same side of the axis as the edge when the product of its arm with that of the edge is above
/// this part of the square of the latter.
pub(super) const FORWARD: f64 = 1e-6;
/// The step along an edge, as a part of its domain, by which it is told whether contacts move forward: small beside
/// any bend, large beside rounding.
pub(super) const BEND_STEP: f64 = 1e-4;
/// Faces that meet at an angle of no more radians are taken as smooth there, whatever the tolerance says.
pub(super) const LEAST_ANGLE: f64 = 1e-6;
/// Two contacts of a ball that are no further apart than this part of its radius are one.
pub(super) const DISTINCT: f64 = 1e-6;
/// Faces whose normals have no larger sine between them touch along the edge.
pub(super) const TOUCH_SINE: f64 = 1e-3;
