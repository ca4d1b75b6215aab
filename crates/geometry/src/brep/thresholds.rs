//! The thresholds of `brep`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// An area that is this part of the square of the size is none.
pub(super) const NO_AREA: f64 = 1e-12;
/// How well a length is known that is only compared with a multiple of the tolerance, as a part of it.
pub(super) const ROUGH_LENGTH: f64 = 1e-3;
/// A ray that tells inside from outside keeps this part of the size from all edges.
pub(super) const AWAY_FROM_EDGES: f64 = 1e-6;
/// Such a ray and a surface meet within this part of the ray's length.
pub(super) const NEAR_RAY: f64 = 1e-9;
/// Two places where it goes through a round surface that are nearer than this part of its length are nearly one touch.
pub(super) const NEARLY_TOUCHES: f64 = 1e-7;
/// Crossings of a trim with a line of constant parameter are found to this part of the domain across.
pub(super) const ISO_CROSSING: f64 = 1e-10;
/// A volume that is this part of the cube of the size is none, and tells no orientation.
pub(super) const NO_VOLUME: f64 = 1e-9;
/// What is looked at beside an end of an edge lies this part of the edge's range inside it.
pub(super) const INSIDE_ENDS: f64 = 1e-6;
/// Vertices and edges are given no smaller tolerance than this, in model units.
pub(super) const LEAST_TOLERANCE: f64 = 1e-9;
/// Integrals are not asked for more exactly than this part of them: summation does not give more.
pub(super) const FINEST_SHARE: f64 = 1e-13;
/// A pulled curve need not be nearer to its surface than this part of the gap that is there.
pub(super) const OF_THE_GAP: f64 = 1e-3;
/// Ends of section curves that are no further apart than this part of the size may be one, if the tolerance does not
/// say less.
pub(super) const SECTION_GAP: f64 = 1e-3;
/// Points are on a cutting plane when they are this part of the size from it: intersections are computed to that.
pub(super) const PLANE_ROUNDING: f64 = 1e-10;
/// How far before and after a place the direction of a trim is told, as a part of its domain.
pub(super) const SIDE_STEP: f64 = 1e-4;
/// What stands for the tolerance in the plane of parameters is no wider than this part of the shorter domain, however
/// slow the surface is.
pub(super) const WIDEST_GAP: f64 = 1e-4;
/// Places on an edge follow each other by at least this part of what one sample stands for.
pub(super) const LEAST_SHARE_OF_EDGE: f64 = 1e-6;
/// Ranges of integration that are shorter than this part of the domain hold nothing.
pub(super) const LEAST_RANGE: f64 = 1e-13;
/// Each part of an integral gets at least this part of the whole tolerance.
pub(super) const LEAST_PART_OF_TOLERANCE: f64 = 1e-3;
/// Pieces on both sides of a seam are one edge when the ends of their ranges differ by no more than this part of the
/// range.
pub(super) const SAME_RANGE: f64 = 1e-8;
/// A trim is a straight line when the curve leaves its image by no more than this part of the tolerance.
pub(super) const STRAIGHT_TRIM: f64 = 1e-6;
/// How far inside a trim it is looked on which side of a plane its face lies, as parts of the way across the domain:
/// the first that tells.
pub(super) const SIDE_STEPS: [f64; 4] = [1e-4, 1e-3, 1e-2, 3e-2];
