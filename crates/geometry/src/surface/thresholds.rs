//! The thresholds of `surface`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// Areas are not asked for more exactly than this part of them: their sums do not give more.
pub(super) const FINEST_AREA: f64 = 1e-13;
/// Areas are found to this part of them when nobody says how exactly.
pub(super) const AREA_SHARE: f64 = 1e-10;
/// The distance, in model units, below which openNURBS takes points as one: 2⁻³² rounded up.
pub(super) const COINCIDENT: f64 = 2.4e-10;
/// The same as a part of the distance from the origin: 2⁻⁴² rounded up.
pub(super) const COINCIDENT_OF_PLACE: f64 = 2.3e-13;
/// Places of a patch of 0…1 this near to a pole are looked at by themselves.
pub(super) const AT_POLE: f64 = 1e-9;
/// Cells of a patch of 0…1 whose side is no longer are not halved that way.
pub(super) const SHORTEST_SIDE: f64 = 1e-9;
/// The first step, in a patch of 0…1, by which it is told whether the distance falls.
pub(super) const FIRST_FALL: f64 = 1e-8;
/// Squared distances of minima that differ by no more than this part are equal.
pub(super) const SAME_MINIMUM: f64 = 1e-11;
/// Rounding of a squared distance as a part of the square of the reach: its sums have some twenty terms.
pub(super) const PATCH_NOISE: f64 = 4e-15;
/// A bound must be below the best squared distance by this part to be worth a search.
pub(super) const MINIMUM_MARGIN: f64 = 4e-13;
/// Sides of cells of a patch of 0…1 that are no longer are below the last places of their ends.
pub(super) const NARROWEST_SIDE: f64 = 1e-14;
/// A determinant must be above 0 by this part of its terms to be told from rounding.
pub(super) const DEFINITE: f64 = 1e-12;
/// What is added to the diagonal where the matrix is not definite, as a part of its trace.
pub(super) const LIFT: f64 = 1e-3;
/// A step that is no longer and does not help is the last.
pub(super) const NO_GAIN_STEP: f64 = 1e-9;
/// After a Newton step this small the next one is below rounding.
pub(super) const NEWTON_SMALL: f64 = 1e-8;
/// Principal curvatures that differ by no more than this part of their mean are equal: all directions are principal.
pub(super) const SAME_CURVATURE: f64 = 1e-14;
/// A foot whose last step was shorter than this part of the domain is found.
pub(super) const SETTLED_FOOT: f64 = 1e-9;
/// Only a foot that is nearer by this part of the distance takes the place of the known one.
pub(super) const NEARER_ONLY: f64 = 1e-9;
/// The first step by which a foot that was found by search is polished is no wider than this part of the domain: it
/// is nearly there.
pub(super) const FOOT_STEP: f64 = 1e-5;
/// A metric less a bend that is this part of the metric is lost in rounding: the foot is at a centre of curvature.
pub(super) const FLAT_TO_ROUNDING: f64 = 1e-6;
/// A cosine that is no larger is that of a right angle.
pub(super) const RIGHT_ANGLE: f64 = 1e-6;
/// A derivative that is this part of the other one has no direction of its own: half of the digits.
pub(super) const ANISOTROPY: f64 = 1.5e-8;
/// A product of two unit derivatives that is no longer has no direction.
pub(super) const NORMAL_LENGTH: f64 = 1e-9;
/// A term of the normal's series that is this part of its scale is 0.
pub(super) const NORMAL_SERIES: f64 = 1e-10;
/// Points whose least spread, squared, is this part of the largest do not tell a centre.
pub(super) const FLAT_SCATTER: f64 = 1e-9;
/// A surface is of a kind whatever the tolerance when it leaves it by this part of the size.
pub(super) const RECOGNISED: f64 = 1e-13;
/// The sine or cosine that rounding leaves where a 0 belongs.
pub(super) const EXACT_RIGHT_ANGLE: f64 = 4e-16;
/// A surface of revolution that lacks no more radians of a whole turn closes.
pub(super) const FULL_REVOLUTION: f64 = 1e-10;
/// Circles of a surface whose heights differ by no more than this part of the size do not tell a slope.
pub(super) const SAME_HEIGHT: f64 = 1e-6;
/// A slope that is no more is that of a cylinder.
pub(super) const CONE_SLOPE: f64 = 1e-6;
/// The damping of the first step when a way on a surface is tightened.
pub(super) const FIRST_DAMPING: f64 = 1e-6;
/// The damping is not less than this: the step is Newton's own.
pub(super) const LEAST_DAMPING: f64 = 1e-12;
/// A metric whose determinant is this part of the product of its diagonal has no inverse: sines of 1e-9.
pub(super) const NO_DETERMINANT: f64 = 1e-18;
