//! The thresholds of `mesh`, in one place: of what they are a part, and why they are as large as they are. Those that
//! all of the kernel has in common stand in `thresholds.rs` at its root.

/// A tolerance that is no more than this part of the size is below rounding.
pub(super) const ALIGN_OF_SIZE: f64 = 1e-15;
/// A cut may leave a face by this part of the tolerance at its edges.
pub(super) const EDGE_MARGIN: f64 = 1e-3;
/// Numbers below this have squares that vanish; they are 0.
pub(super) const VANISHING: f64 = 1e-140;
/// A quadric whose determinant is this part of the cube of its trace has no one best place.
pub(super) const NO_QUADRIC: f64 = 1e-7;
/// What the length of an edge costs beside leaving the faces, as a part of their weights: in flat regions, where all
/// else costs nothing, the shortest edges go first.
pub(super) const LENGTH_COST: f64 = 1e-12;
/// Angles that differ by no more radians are equal.
pub(super) const SAME_ANGLE: f64 = 1e-12;
/// Creases as sharp as the angle, but for this many radians, stay sharp.
pub(super) const CREASE: f64 = 1e-9;
/// Vertices that are nearer to the ends of an edge than this part of it are not put into the edge.
pub(super) const BESIDE_ENDS: f64 = 1e-3;
/// Boxes are wider by this part of their coordinates, so that those without height are met.
pub(super) const FLAT_BOX: f64 = 1e-9;
/// A ray with no larger sine to a face runs along it, and two segments with no larger squared sine are parallel.
pub(super) const ALONG_FACE: f64 = 1e-14;
/// A hit may lie this part of a face beyond its edge, and boxes are wider by it, so that nothing is missed between
/// two faces.
pub(super) const HIT_MARGIN: f64 = 1e-12;
/// Vertices that are this part of the size from a plane are on it.
pub(super) const LEVEL_SECTION: f64 = 1e-10;
/// A corner of a section that leaves the straight line by this part of its reach is none.
pub(super) const ALONG_SECTION: f64 = 1e-9;
/// Light whose cosine with the normal of a plane is no larger runs along the plane.
pub(super) const LIGHT_ALONG: f64 = 1e-9;
/// A corner of a shadow that leaves the line through its neighbours by no more is none: a few cells of the grid on
/// which outlines are united.
pub(super) const SHADOW_STRAIGHT: f64 = 1e-7;
/// Colours are smooth when no channel, of 0…255, changes by more in a pass: rounding to whole numbers does not show
/// it.
pub(super) const SMOOTHED: f64 = 1e-6;
/// A triangle is flat when twice its area is no more than this part of the square of its longest side.
pub(super) const NO_FLIP: f64 = 1e-3;
/// A mesh that turns by no more radians over a whole cell is flat everywhere, and has even cells.
pub(super) const FLAT_EVERYWHERE: f64 = 1e-3;
