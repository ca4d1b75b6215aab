//! All thresholds of the booleans, each with its unit and reason. Lengths follow from the tolerance of the call.

/// What is equal to rounding, as a part of the size of a surface: carriers told inside NURBS surfaces are off by 1e-12.
pub(super) const EXACT: f64 = 1e-10;
/// What rounding leaves of lengths of a carrier, as a part of its size.
pub(super) const ROUNDING: f64 = 1e-12;
/// Section curves that have no closed form are followed within this part of the tolerance, so that vertices within the
/// tolerance of their true place are still captured by the curve.
pub(super) const TRACED: f64 = 0.25;
/// Where decisions at the tolerance contradict each other they are made again at these parts of it: what lies that near to
/// each other by chance is as much rarer.
pub(super) const FINER: [f64; 3] = [1.0 / 8.0, 1.0 / 64.0, 1.0 / 512.0];
/// A vertex belongs to a curve that comes nearer to it than so many tolerances: one for the vertex and one for the curve.
pub(super) const CAPTURE: f64 = 2.0;
/// What counts as the border of a face for a curve beside it, in tolerances, from the first that tells: 0 asks exactly.
pub(super) const BESIDE_BORDER: [f64; 3] = [CAPTURE, 1.0, 0.0];
/// A point is told to lie inside or outside of an operand when it is farther from the boundary than so many tolerances,
/// the first at which a point of a region tells: what is cut by curves within the tolerance may be smaller than it.
pub(super) const BESIDE_BOUNDARY: [f64; 4] = [1.0, 1.0 / 8.0, 1.0 / 64.0, 1.0 / 512.0];
/// A curve that is told not to divide a face is looked at from so many tolerances on both of its sides.
pub(super) const ASIDE: f64 = 16.0;
/// Branches that end nearer than so many tolerances to a place where branches cross end there: where two surfaces have one
/// tangent plane they part by the square of the way, and branches are found only so far.
pub(super) const AT_CROSSING: f64 = 64.0;
/// Faces pass through each other where the sine between their normals is larger; others may only touch.
pub(super) const CROSSING: f64 = 1e-2;
/// Two curves with the same ends are one when they come nearer to each other than so many tolerances.
pub(super) const SAME_CURVE: f64 = 4.0;
/// The share of the way to the middle of a piece at which one sees on which side of a seam its end lies.
pub(super) const BESIDE: f64 = 1e-3;
/// Images in the parameter plane are pulled within these parts of the tolerance: the first that can be reached.
pub(super) const PULLED: [f64; 3] = [0.25, 1.0, 4.0];
/// So many times a curve is halved that cannot be pulled as a whole: its quickest bend is looked at 2⁷ times as finely.
pub(super) const MOST_HALVINGS: usize = 7;
/// Two unit directions whose product is shorter are parallel to rounding.
pub(super) const PARALLEL: f64 = 1e-10;
/// The cosine of the angle between normals of faces that lie upon each other: what the tolerance leaves open is far less.
pub(super) const ONE_PLANE: f64 = 0.999;
/// Parameters nearer than this part of a domain are one.
pub(super) const SAME_PARAMETER: f64 = 1e-7;
/// Two distances that part by this part of themselves are one: either place will do.
pub(super) const SAME_DISTANCE: f64 = 1e-9;
/// Two places of one vertex in the parameter plane are on different sides of a seam when they are farther apart than
/// this part of the domain.
pub(super) const ACROSS_SEAM: f64 = 0.25;
/// Edges of results may lie off their faces by so many tolerances: each of curve, image and vertex adds one.
pub(super) const EDGE_OFF_FACE: f64 = 16.0;
/// Shares of a curve at which it is asked where it lies: none of them a likely place of symmetry.
pub(super) const PLACES: [f64; 5] = [0.5, 0.29, 0.73, 0.11, 0.91];
/// Samples of a curve in the parameter plane where its order around a node or the area of a loop is asked.
pub(super) const SAMPLES: usize = 24;
/// The share of a piece at which the faces around it are put in order.
pub(super) const RADIAL_AT: f64 = 0.37;
/// How far into faces one goes for that, as a part of the size of the piece and its faces: what is tangent parts there.
pub(super) const RADIAL_STEP: f64 = 0.05;
/// Faces around a piece that leave it at angles nearer than this, in radians, have no order.
pub(super) const RADIAL_APART: f64 = 1e-5;
/// Halvings until a place on a curve is known to rounding.
pub(super) const HALVINGS: usize = 50;
/// Steps of Newton's method for the parameter of a trim at a point.
pub(super) const NEWTON: usize = 16;
/// The most faces of all operands together.
pub(super) const MOST_FACES: usize = 200_000;
/// The most pairs of faces whose boxes meet.
pub(super) const MOST_PAIRS: usize = 4_000_000;
