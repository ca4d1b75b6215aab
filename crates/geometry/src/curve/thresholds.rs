//! The thresholds of `curve`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// Pieces of a biarc are not divided when their ends are nearer than this part of the tolerance.
pub(super) const TOO_SHORT: f64 = 1e-3;
/// A bend that leaves the chord by this part of it is none.
pub(super) const STRAIGHT_BEND: f64 = 1e-10;
/// The damping of the first step towards the wanted point.
pub(super) const FIRST_DAMPING: f64 = 1e-6;
/// The damping is not less than this: the step is Newton's own.
pub(super) const LEAST_DAMPING: f64 = 1e-12;
/// Two units in the last place of what is compared.
pub(super) const UNITS_IN_LAST_PLACE: f64 = 4e-16;
/// A plane that no area orients is turned so that its normal is along z, else y, else x: the weights by which the
/// later ones count.
pub(super) const TIE_BREAK: [f64; 2] = [1e-6, 1e-3];
/// An axis whose part in the plane is not longer gives no direction there.
pub(super) const NO_X_AXIS: f64 = 1e-6;
/// An arc that was told from points is a whole circle when it lacks no more than this many radians.
pub(super) const ABOUT_WHOLE_TURN: f64 = 1e-6;
/// Curvatures (one over model units) that differ by no more are equal: what a polyline of the model's size would not
/// show.
pub(super) const STRAIGHT_END_FLOOR: f64 = 1e-9;
/// Curvatures at a joint that differ by no more than this part of the larger are equal to the eye.
pub(super) const SAME_BEND: f64 = 1e-3;
/// Boxes of arcs are wider by this part, for the rounding of one product.
pub(super) const WIDER_BOX: f64 = 1e-15;
/// A limit for the squared distance is larger by this part, so that its own place is below it.
pub(super) const NEAREST_LIMIT: f64 = 1e-12;
/// Rounding of a squared distance as a part of the square of the reach: its sums have some ten terms.
pub(super) const PART_NOISE: f64 = 2e-15;
/// A slope that is this part of its terms is 0: the foot lies at the end.
pub(super) const SLOPE_NOISE: f64 = 1e-15;
/// Squared distances that differ by no more than this part are one minimum.
pub(super) const RELATIVE_TIE: f64 = 1e-13;
/// A bound must be below the best squared distance by this part to be worth a search.
pub(super) const MINIMUM_MARGIN: f64 = 4e-13;
/// After a Newton step this small the next one is below rounding.
pub(super) const NEWTON_SMALL: f64 = 1e-8;
/// An arc has another quarter turn when it exceeds the last one by this part of it.
pub(super) const OPEN_QUARTER: f64 = 1e-9;
/// The distance, in model units, below which openNURBS takes points as one: 2⁻³² rounded up.
pub(super) const COINCIDENT: f64 = 2.4e-10;
/// Derivatives that differ by no more than this part are equal: half of the digits.
pub(super) const SAME_DERIVATIVE: f64 = 1e-8;
/// Curvatures that differ by no more than this part look equal in shading.
pub(super) const SAME_CURVATURE: f64 = 1e-3;
/// Rounding of a point as a part of its distance from the origin.
pub(super) const POINT_NOISE: f64 = 1e-15;
/// Rounding of a derivative as a part of those below it, for each time the domain magnifies it.
pub(super) const DERIVATIVE_NOISE: f64 = 1e-13;
/// Rounding of higher derivatives, in terms of the speed over the span.
pub(super) const DERIVATIVE_FLOOR: f64 = 1e-10;
/// Curvatures on both sides that differ by more than this part make a leap.
pub(super) const LEAP_OF_CURVATURE: f64 = 1e-6;
/// Curvatures (one over model units) that differ by no more are equal whatever their size.
pub(super) const STRAIGHT_CURVATURE: f64 = 1e-12;
/// Deviations of pieces that differ by no more than this part are even.
pub(super) const EVEN_SPREAD: f64 = 1e-5;
/// A curve that leaves its chord by this part of its length is straight.
pub(super) const NO_DEVIATION: f64 = 1e-12;
/// A search by halving ends when its range is this part of its upper end.
pub(super) const SEARCH_DONE: f64 = 1e-10;
/// A range that is more than this part of a piece is no speck.
pub(super) const LEAST_TRIM: f64 = 1e-6;
/// An elliptic arc that lacks no more than this many radians is a whole ellipse.
pub(super) const WHOLE_ELLIPSE: f64 = 1e-6;
/// Angles of an arc that was told from points may exceed a turn by this many radians.
pub(super) const OVER_TURN: f64 = 1e-9;
/// A conic whose discriminant, with the squares' coefficients together 1, is no larger is a parabola.
pub(super) const NO_ELLIPSE: f64 = 1e-12;
/// A pivot that is no larger, of rows of size 1, is rounding.
pub(super) const NO_PIVOT: f64 = 1e-14;
/// A derivative that is this part of the largest one vanishes.
pub(super) const VANISHES: f64 = 1e-12;
/// A curvature times the size of the curve that is no larger gives no direction.
pub(super) const STRAIGHT_FRAME: f64 = 1e-10;
/// A curve that turns by no more than this many radians over its extension is extended straight.
pub(super) const STRAIGHT_EXTENSION: f64 = 1e-9;
/// Lengths of parts are integrated to this part of what is asked for.
pub(super) const LENGTH_SHARE: f64 = 1e-13;
/// A length is reached when it lacks no more than this part of it.
pub(super) const LENGTH_DONE: f64 = 1e-12;
/// Rounding of the terms of a polynomial of products of derivatives, as a part of its largest.
pub(super) const BEND_NOISE: f64 = 1e-13;
/// How far beside a root, as a part of the span, it is told whether the sign changes there.
pub(super) const SIGN_STEP: f64 = 1e-5;
/// A bend that is this part of the square of the speed over the range is none.
pub(super) const NO_BEND: f64 = 1e-9;
/// How far inside a span, as a part of it, the side of its bend is told when its end has none.
pub(super) const INSIDE_SPAN: f64 = 1e-4;
/// A root nearer than this part of the span to its end is the end.
pub(super) const LEAST_SIGN_STEP: f64 = 1e-13;
/// A slope that is this part of the terms it is summed from is 0 all along: curvature is constant.
pub(super) const NO_SLOPE: f64 = 1e-11;
/// A determinant that is this part of the product of its columns is none.
pub(super) const SINGULAR: f64 = 1e-14;
/// A ball touches when what it misses is this part of its radius and its place.
pub(super) const FOUND_FIRST: f64 = 1e-13;
/// What it may miss when Newton's method does not come nearer.
pub(super) const FOUND_AT_LEAST: f64 = 1e-9;
/// A ball is not moved on by steps shorter than this part of its radius.
pub(super) const SHORTEST_STEP: f64 = 1e-6;
/// A contact may move by this much, in model units, whatever the step.
pub(super) const BALL_MOVES: f64 = 1e-9;
/// What is left of a curve beside a fillet is more than this part of its domain.
pub(super) const FILLET_ROOM: f64 = 1e-12;
/// A unit tangent whose level part is no longer is upright.
pub(super) const NO_HORIZONTAL: f64 = 1e-12;
/// A sine below this turns nothing.
pub(super) const NO_ROTATION: f64 = 1e-15;
/// Cells of the grid of ends are at least this part of the size of all.
pub(super) const LEAST_CELL: f64 = 1e-9;
/// A place at a length is found to this part of the whole length.
pub(super) const LENGTH_AT: f64 = 5e-14;
/// A step lands within the tolerance when its square, by what is left, is this part of the range.
pub(super) const NEWTON_LANDS: f64 = 1e-9;
/// Lengths are not asked for more exactly than this part: their sums do not give more.
pub(super) const FINEST_LENGTH: f64 = 1e-15;
/// Integrals of moments are found to this part of the size of what they are of.
pub(super) const MOMENT_BOUND: f64 = 1e-14;
/// An area that is this part of the square of the size is none.
pub(super) const NO_AREA: f64 = 1e-15;
/// A stretch within the plane is one, not a point, when it is longer than this many tolerances.
pub(super) const LONG_TOUCH: f64 = 1e3;
/// A tolerance of 0 counts as this, in model units, where lengths are compared with it.
pub(super) const SMALLEST_TOLERANCE: f64 = 1e-12;
/// A part of a span of 0…1 that is no longer is not halved again.
pub(super) const SHORTEST_RANGE: f64 = 1e-12;
/// Between these sizes squares neither vanish nor overflow.
pub(super) const SAFE_SIZE: [f64; 2] = [1e-100, 1e100];
/// Below this half angle an arc is as long as its chord to rounding.
pub(super) const ARC_TURN: f64 = 1e-6;
/// Samples that are no further apart than this part of the gap are one.
pub(super) const CLOSE_SAMPLES: f64 = 1e-3;
/// Samples that turn by more than one turn and this part of it are no arc.
pub(super) const ARC_OVER_TURN: f64 = 1e-6;
