//! The thresholds of `meshing`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// Places at the sides of a cell of 0…1 are looked at this far inside it, where derivatives are those of the cell.
pub(super) const PROBE_INSET: f64 = 1e-6;
/// A metric whose determinant is this part of the product of its diagonal has collapsed: sines of 1e-9.
pub(super) const NO_METRIC: f64 = 1e-18;
/// A trim that ends this part of the domain from a side ends on it.
pub(super) const AT_SIDE: f64 = 1e-7;
/// A face is flat when it leaves a plane by this part of the distance allowed.
pub(super) const FLAT_FACE: f64 = 1e-3;
/// An edge that is this part of the distance allowed is a point.
pub(super) const NO_EDGE: f64 = 1e-9;
/// Places of a trim that differ by no more than this part of its range are one.
pub(super) const SAME_PLACE_ON_TRIM: f64 = 1e-13;
/// A product of derivatives that is this part of the square of the longer has no direction.
pub(super) const NO_NORMAL: f64 = 1e-7;
/// A corner that is this part of a value from an aligned line is on it.
pub(super) const ON_LINE: f64 = 1e-6;
/// An area that is this part of the whole is none.
pub(super) const SLIVER: f64 = 1e-12;
/// Stops of an edge that are nearer than this part of it are one.
pub(super) const SAME_STOP: f64 = 1e-7;
/// Bounds may be exceeded by this part: they are no sharper than that.
pub(super) const BOUND_SLACK: f64 = 1e-6;
/// A count of parts is rounded down when it exceeds a whole number by no more.
pub(super) const COUNT_SLACK: f64 = 1e-6;
/// A triangle whose area is this part of the square of its longest side has no normal.
pub(super) const NO_NORMAL_OF_FACE: f64 = 1e-9;
/// Cells are not longer than this many times their width.
pub(super) const RATIO: [f64; 2] = [1e-6, 1e6];
/// Weights that differ by no more than this part are equal.
pub(super) const EVEN_WEIGHTS: f64 = 1e-14;
/// Numbers below this have products that vanish in exact predicates; they are 0.
pub(super) const VANISHING: f64 = 1e-40;
/// Meshes are not finer than this part of the size.
pub(super) const FINEST: f64 = 1e-9;
/// Without a distance edges are short when they are this part of the size.
pub(super) const SHORT_OF_SIZE: f64 = 1e-6;
/// What is narrow at a side lies between these parts of the domain.
pub(super) const NARROW_PARTS: [f64; 2] = [1e-8, 1e-6];
/// A trim that leaves a line by no more than this part of the domain runs along it; one that is no longer than that
/// has no direction.
pub(super) const NARROWEST: f64 = 1e-8;
/// A trim whose width across is more than this part of its length, both as parts of the domains, is no line of
/// constant parameter.
pub(super) const WAVERS: f64 = 1e-2;
/// A foot on a trim is found when the slope is this part of its terms.
pub(super) const FOOT_DONE: f64 = 1e-13;
/// A foot on a trim is not looked for by steps that are no longer than this part of it.
pub(super) const FOOT_STEP: f64 = 1e-14;
