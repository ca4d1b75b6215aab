//! The thresholds of charts, of following curves, and of surfaces with surfaces, all in one place: of what they are a part,
//! and why they are as large as they are.
//!
//! There are four scales. Rounding is known from the size and the place of the surfaces ([`noise`]); a point that Newton's
//! method found is known to some of it ([`MET`]). Parameters are told apart by parts of their domains. Places are told apart
//! by parts of the size of the smaller surface. Directions are told apart by sines.

/// Rounding of an evaluated point as a part of the size: sums over the control points of one patch.
pub(crate) const ROUNDING_OF_SIZE: f64 = 1e-14;
/// Rounding of an evaluated point as a part of its distance from the origin: two units in the last place.
const ROUNDING_OF_PLACE: f64 = 4e-16;

/// Distances below this are rounding, for surfaces of sizes and distances from the origin, in model units.
pub(crate) fn noise(sizes: [f64; 2], far: [f64; 2]) -> f64 {
    ROUNDING_OF_SIZE * (sizes[0] + sizes[1]) + ROUNDING_OF_PLACE * (far[0] + far[1])
}

/// The box in which a step is proved to have one curve has this part of the step's length as room on all sides: more than the
/// curve parts from the cubic between places that were looked at.
pub(crate) const ASIDE: f64 = 0.05;
/// A parameter in which a surface moves less than this part of the size on the way through its domain is slow: at a pole.
pub(crate) const SLOWEST: f64 = 0.05;

/// Points on both surfaces that are this many times the noise apart are one: what is left when Newton's method has
/// converged, where the surfaces meet at small angles.
pub(crate) const MET: f64 = 64.0;
/// Steps and tolerances are no less than this many times the noise, so that rounding does not decide about them.
pub(crate) const ABOVE_NOISE: f64 = 1e3;

/// A parameter beyond its domain by this part of it is on its side.
pub(crate) const ON_SIDE: f64 = 1e-10;
/// Boxes of parameters in proofs reach this part of the domain further, so that what lies on their sides is inside.
pub(crate) const ROOM: f64 = 1e-9;
/// Parameters of one place, told by two ways, agree to this part of the domain.
pub(crate) const SAME_PARAMETER: f64 = 1e-6;
/// The middle of a step may lie beyond a side by this part of the domain.
pub(crate) const BESIDE: f64 = 1e-7;

/// Two derivatives are parallel when the squared sine between them is not above this: half of the digits.
pub(crate) const PARALLEL_SQUARED: f64 = 1e-14;
/// Rows of equations that are this part of the largest have no influence of their own.
pub(crate) const PIVOT: f64 = 1e-14;
/// Surfaces whose normals have no larger sine between them are tangent: the direction of the curve is lost in rounding.
pub(crate) const TANGENT: f64 = 1e-9;
/// A curve whose sine with a line is not above this runs along it.
pub(crate) const ALONG: f64 = 1e-7;
/// Ends that belong together have tangents whose cosine is less than 1 by no more than this (a sine of 1.4e-3).
pub(crate) const SMOOTH: f64 = 1e-6;
/// Legs of a control net that turn by less than this many radians at a knot line are no kink.
pub(crate) const STRAIGHT: f64 = 1e-6;
/// Below this half angle an arc is as long as its chord to rounding.
pub(crate) const FLAT_ARC: f64 = 1e-6;
/// A rate below this, in shares of the domain on the way of one size, does not lead across a side.
pub(crate) const RATE: f64 = 1e-9;

/// Places that are no further apart than this part of the size are one place of a curve.
pub(crate) const SAME_PLACE: f64 = 1e-7;
/// Ends of pieces of one curve agree to this part of the size.
pub(crate) const SAME_END: f64 = 1e-8;
/// The start of a step's range counts as in it by this part of its reach.
pub(crate) const REACH: f64 = 1e-6;
/// Steps are not shorter than this part of the size: the surfaces are tangent there to half of the digits and more.
pub(crate) const SHORTEST: f64 = 1e-6;
/// Steps are not longer than this part of the size.
pub(crate) const LONGEST: f64 = 0.25;
/// A tolerance above this part of the size would not keep the shape of a curve.
pub(crate) const COARSEST: f64 = 1e-2;
/// Parts that are smaller than this part of the size are not divided to prove something.
pub(crate) const SMALLEST: f64 = 1e-5;
/// Leaves that are smaller than this part of the smallest size are not divided to find a point.
pub(crate) const TINY: f64 = 1e-4;
/// What is no further from a pole than this part of the size ends at it.
pub(crate) const AT_POLE: f64 = 1e-3;
/// A curve that ends no further from a contact than this part of the size ends in it.
pub(crate) const AT_CONTACT: f64 = 1e-2;
/// A curve runs into a contact when the cosine between its tangent and the way there is at least this.
pub(crate) const INTO_CONTACT: f64 = 0.9;
/// Around a tangent place where the surfaces bend apart in all directions, what is not decided reaches no further than this
/// part of the domains, or of the size; in longer groups there may be more.
pub(crate) const CLUSTER: f64 = 2e-2;
/// A contact that is no longer than this part of the domains is no curve and no area.
pub(crate) const POINT: f64 = 1e-3;
/// A tangent place that is no further from a tangent curve than this part of the size belongs to it.
pub(crate) const ON_CURVE: f64 = 1e-5;
/// A tangent place is found when Newton's last step was shorter than this part of the size.
pub(crate) const FOUND: f64 = 1e-10;
/// Normals that differ by more than this sine do not belong to one tangent plane.
pub(crate) const ONE_PLANE: f64 = 1e-2;
/// A bend is none when it is smaller than this part of both principal bends together.
pub(crate) const NO_BEND: f64 = 1e-4;
/// Bends are compared with no less than this, times one over the size.
pub(crate) const LEAST_BEND: f64 = 1e-3;

/// What is equal to rounding where surfaces are told by kind, as a part of the size of the smaller surface: lengths and, in
/// radians, directions. The axes of carriers that are told inside NURBS surfaces are off by some 1e-12.
pub(crate) const EXACT: f64 = 1e-10;
/// What is equal to rounding is no less than this many times the noise, far from the origin: a centre is told by second
/// derivatives, which lose more digits than places.
pub(crate) const EXACT_OF_NOISE: f64 = 64.0;
/// A place within this many times [`EXACT`] of a surface is on it, and two as near to each other are one: where the ends of
/// exact curves are told by two ways.
pub(crate) const ON_CARRIER: f64 = 32.0;
/// Images of exact curves keep within this part of the size, or a tenth of the tolerance, if that is less.
pub(crate) const IMAGE: f64 = 1e-7;
/// See [`IMAGE`].
pub(crate) const IMAGE_OF_TOLERANCE: f64 = 0.1;
/// How far a place lies inside a side, as parts of the domain, that tells what lies beside the side: less where the common
/// area is narrow.
pub(crate) const INWARD: [f64; 3] = [1e-2, 1e-4, 1e-6];
/// Beside a pole the image of a curve is looked at this part of its domain away, where it has a direction.
pub(crate) const BESIDE_POLE: f64 = 1e-6;
/// Pairs of parts on the border of a known common area that are smaller than this part of the size belong to it.
pub(crate) const AT_BORDER: f64 = 1.0 / 256.0;
/// Faces that lie in a plane to this part of their size cut others as planes do.
pub(crate) const FLAT_FACE: f64 = 1e-9;
/// Planes of faces whose normals have no larger sine between them are parallel.
pub(crate) const PARALLEL_FACES: f64 = 1e-12;
/// Principal curvatures that differ by no more than this part of the larger are equal, and are 0 beside it: what tells which
/// kind of carrier a surface may have before it is looked at closely.
pub(crate) const SAME_BEND: f64 = 1e-4;

/// The damping of the first step towards the nearest place, as a part of the squared lengths of the derivatives: half of the
/// digits of a length.
pub(crate) const NEAREST_DAMPING: f64 = 1e-3;
/// Steps with more damping than this are too short to help.
pub(crate) const MOST_DAMPING: f64 = 1e8;
/// The damping that is tried first on the way to a tangent place, as a part of the largest of the normal equations' diagonal:
/// above their rounding, below what slows a regular step.
pub(crate) const TOUCH_DAMPING: f64 = 1e-12;
/// A surface whose derivatives span no more than this part of the square of the larger has no area: half of the digits.
pub(crate) const NO_AREA: f64 = 1e-8;
