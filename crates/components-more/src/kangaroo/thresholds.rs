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
/// The strength of what shall hold: Kangaroo's anchors have it.
pub(super) const HOLD: f64 = 10_000.0;
/// More pairs of points than this are not looked at one by one.
pub(super) const MOST_PAIRS: usize = 20_000_000;
/// More thick segments than this, all in one place, would take longer than anybody waits for one step.
pub(super) const MOST_COLLIDERS: usize = 20_000;
