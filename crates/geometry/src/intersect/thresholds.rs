//! The thresholds of intersections with curves, of planes with surfaces and of nearest places, in one place: of what they are a
//! part, and why they are as large as they are. Those of surfaces with surfaces stand in `chart/thresholds.rs`.
//!
//! Parameters are told apart by parts of their domain, or of their range; directions by sines, or by these squared; lengths by
//! parts of the size, or of the tolerance that the caller gives.

/// A step of Newton's method or a bracket that is no longer than this part of the domain is the last: a few units in the last
/// place.
pub(super) const LAST_STEP: f64 = 1e-15;
/// Newton's method on two parameters is done when both steps are no longer than this part of their ranges.
pub(super) const LAST_STEPS: f64 = 1e-13;
/// Cuts of a range of length 1 that are no further apart than this are one.
pub(super) const SAME_CUT: f64 = 1e-13;
/// A parameter beyond its range by this part of it is in it: what rounding adds to a root at an end.
pub(super) const IN_RANGE: f64 = 1e-12;
/// Stretches are begun this part of the domain inside of where they end.
pub(super) const INSIDE: f64 = 1e-11;
/// Two roots that are no further apart than this part of the domain are one root found twice.
pub(super) const SAME_ROOT: f64 = 1e-10;
/// Parameters of one place, found by two ways, agree to this part of the domain: half of the digits and one more.
pub(super) const SAME_PARAMETER: f64 = 1e-9;
/// A parameter this part of the domain away from a side is on it, after a foot was found by least squares.
pub(super) const ON_SIDE: f64 = 1e-7;
/// A stretch that ends this part of the domain before an end of a curve reaches it: the end of a touch is known to half of the
/// digits.
pub(super) const AT_END: f64 = 1e-6;
/// Parameters no further apart than this part of the domain may belong to one touch.
pub(super) const SAME_TOUCH: f64 = 1e-4;
/// Parts of curves are made no longer than this part of the piece where they are recorded as near.
pub(super) const SHORT_PART: f64 = 1e-3;
/// How much a place further along counts against its distance, when the nearest of some is chosen.
pub(super) const FURTHER: f64 = 1e-3;

/// What lies within this part of the tolerance lies on the other, and is not merely near it.
pub(super) const ON_OTHER: f64 = 1e-3;
/// A kink in the distance of the tolerance: values of a polynomial below this part of the noise are 0.
pub(super) const OF_NOISE: f64 = 1e-3;
/// Values below this part of the largest coefficient of a polynomial are 0.
pub(super) const OF_LARGEST: f64 = 1e-9;
/// Newton's method converges when its steps, as parts of the ranges, are below these: for a root, for one that is not improved
/// any more, and for one that is left when the steps end.
pub(super) const CONVERGED: f64 = 1e-8;
/// See [`CONVERGED`].
pub(super) const NO_BETTER: f64 = 1e-9;
/// See [`CONVERGED`].
pub(super) const LEFT: f64 = 1e-6;

/// Directions with a sine above this cross; below it they touch.
pub(super) const CROSSES: f64 = 1e-3;
/// Directions with no larger sine are parallel: nearly all digits.
pub(super) const PARALLEL: f64 = 1e-14;
/// The same for squared sines.
pub(super) const PARALLEL_SQUARED: f64 = 1e-28;
/// Directions whose squared sine is not above this span no plane that could tell hulls apart.
pub(super) const NO_PLANE_SQUARED: f64 = 1e-24;
/// Three directions whose volume is no larger than this part of their lengths are no coordinates.
pub(super) const NO_FRAME: f64 = 1e-9;
/// A row of differences keeps to its axis when it does so by this factor, which is above what rounding adds.
pub(super) const KEEPS: f64 = 1.000_001;
/// The difference of two bends is none when it is not above this part of both.
pub(super) const NO_BEND: f64 = 1e-9;
/// Squared lengths are compared with this part added, so that rounding does not exclude the nearest.
pub(super) const ROUNDED: f64 = 1e-9;

/// A curve stands still where its derivative is no longer than this part of its size.
pub(super) const STILL: f64 = 1e-9;
/// Where a curve folds is known to this part of its range; folds nearer than twice that are one.
pub(super) const FOLD: f64 = 1e-6;

/// Rounding of the heights of a surface above a plane: parts of its size, of its distance from the origin, and of that of the
/// plane.
pub(super) const HEIGHT_OF_SIZE: f64 = 1e-12;
/// See [`HEIGHT_OF_SIZE`].
pub(super) const HEIGHT_OF_PLACE: f64 = 1e-15;
/// See [`HEIGHT_OF_SIZE`].
pub(super) const HEIGHT_OF_PLANE: f64 = 2e-15;
/// Ends of pieces of a section that are no further apart than this part of the size are joined.
pub(super) const JOINED: f64 = 1e-7;
/// The same where the tolerance is less.
pub(super) const JOINED_LEAST: f64 = 1e-8;
/// A side that keeps within this part of the size of a plane lies in it.
pub(super) const IN_PLANE: f64 = 1e-9;
/// A plane cuts a tangent plane along a direction when the sine between them is above this.
pub(super) const CUTS: f64 = 1e-6;
/// Control points that are no further apart than this part of the size of their row fall together.
pub(super) const TOGETHER: f64 = 1e-12;
