//! Thresholds of Kangaroo's solvers, each with its reason.

/// How near points are one particle where nothing is given, in units of the model: what files of Kangaroo 2 store.
pub(super) const TOLERANCE: f64 = 1e-4;
/// The mean square of a step, in square units, at which particles are at rest where nothing is given: what Kangaroo's own
/// help says.
pub(super) const REST: f64 = 1e-15;
/// The same for the solver that keeps its steps to itself.
pub(super) const ZOMBIE_REST: f64 = 1e-10;
/// A solver without a limit of its own takes at most so many steps in one solve: more would hardly be waited for.
pub(super) const MOST_STEPS: usize = 20_000;
/// It also takes at most so many pulls of a goal on a particle: about ten seconds of work.
pub(super) const MOST_PULLS: usize = 400_000_000;
/// Lengths below this, in units, have no direction: it only keeps divisions from overflow.
pub(super) const SHORTEST: f64 = 1e-12;
/// A solve takes at most so many steps while a hand drags: the next follows at once, and one sees the form give way.
pub(super) const HELD_STEPS: usize = 30;
/// It also takes at most so many pulls then: hundredths of a second of work.
pub(super) const HELD_PULLS: usize = 1_000_000;
/// The strength of a hand where nothing is given: a tenth of what anchors have, which so hold against it.
pub(super) const GRAB_STRENGTH: f64 = 1000.0;
/// The strength of what shall hold: Kangaroo's anchors have it.
pub(super) const HOLD: f64 = 10_000.0;
/// More pairs of points than this are not looked at one by one.
pub(super) const MOST_PAIRS: usize = 20_000_000;
/// More thick segments than this, all in one place, would take longer than anybody waits for one step.
pub(super) const MOST_COLLIDERS: usize = 20_000;
/// A determinant below this part of the product of what it is made of is rounding: points in one line have no circle, points
/// in one plane no sphere, parallel segments no one place where they are nearest.
pub(super) const DEPENDENT: f64 = 1e-12;
/// A turn below this angle, in radians, changes nothing any more.
pub(super) const SMALLEST_TURN: f64 = 1e-13;
/// Two segments that turn back on each other count as so long together, as a part of the sum of their lengths.
pub(super) const FOLDED: f64 = 1e-3;
/// The part of a segment's length that it must leave the other's line by, for both to lie in one plane alone.
pub(super) const STRAIGHT: f64 = 1e-9;
/// Corners of unrolled strips within this part of the model's size are one corner.
pub(super) const SAME_CORNER: f64 = 1e-9;
/// The edge of a cell of a search by cells where nothing has a size: it only keeps divisions from overflow.
pub(super) const SMALLEST_CELL: f64 = 1e-300;
/// A place within this distance of a curve, in units of the model, is on it: neither side pulls.
pub(super) const ON_CURVE: f64 = 1e-9;
/// What is kept at rest has given way where it changes by more than this part of itself: less is left of coming to rest.
pub(super) const GIVES_WAY: f64 = 1e-6;
