//! The thresholds of `construct`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// The tolerance to which the seam of a baseball is put together, as a part of its radius.
pub(super) const BALL_TOLERANCE: f64 = 1e-5;
/// The tolerance to which the faces of a round solid are joined, as a part of its radius.
pub(super) const ROUND_TOLERANCE: f64 = 1e-7;
/// Boxes whose thin directions have no larger sine between them do not cross.
pub(super) const CROSSING_SINE: f64 = 1e-6;
/// Crossings of curves that are no further apart than this part of the domain do not follow each other.
pub(super) const CROSSING_RANGE: f64 = 1e-6;
/// Shares of lengths and of domains that differ by no more than this are equal: lengths are measured to some 1e-9.
pub(super) const SAME_SHARE: f64 = 1e-7;
/// A normal that is missing is looked for this part of the way to the middle of the domain.
pub(super) const BESIDE_SINGULARITY: f64 = 1e-6;
/// Derivatives on both sides that differ by more than this part of their length make a kink.
pub(super) const KINK: f64 = 1e-6;
/// Second derivatives on both sides that differ by more than this part of the first, over the width of a span, are a
/// leap of curvature.
pub(super) const KINK_OF_CURVATURE: f64 = 1e-4;
/// A wall that leans to within this many radians of the plane has no height.
pub(super) const UPRIGHT: f64 = 1e-6;
/// A revolution that lacks no more radians of a whole turn is one.
pub(super) const NO_ANGLE: f64 = 1e-10;
/// What a ruling's length adds to the cost of a way: ways that cost the same else are told apart by it.
pub(super) const WAY_COST: f64 = 1e-7;
/// A section that stands within this part of a run from one of its ends stands at the end.
pub(super) const AT_RUN_END: f64 = 1e-6;
/// A rail that turns by more than this many radians at a joint has a corner there.
pub(super) const KINK_ANGLE: f64 = 1e-4;
/// A direction whose part across the rail is less than this part of it cannot be kept upright.
pub(super) const UPRIGHT_PART: f64 = 1e-6;
/// Tangents whose sum is no longer are opposite: no plane halves their angle.
pub(super) const OPPOSITE: f64 = 1e-6;
/// The sine of a turn that is below rounding: nothing is turned.
pub(super) const NO_TURN: f64 = 1e-15;
/// The cosine of two axes that are one is 1 less this, which is 1 to the last place: frames that are off by rounding
/// count as open, and their rims meet all the same.
pub(super) const SAME_AXIS: f64 = 1e-18;
/// A frame whose volume is this part of the product of its axes is flat.
pub(super) const NO_WIDTH: f64 = 1e-9;
/// Places on the rails that are nearer than this part of them are one.
pub(super) const SAME_PLACE_ON_RAILS: f64 = 1e-6;
/// Sections stand at least this part of the rails apart to be stops of their own.
pub(super) const ROOM_ON_RAILS: f64 = 1e-4;
