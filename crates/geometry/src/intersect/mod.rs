//! Where things meet: lines and planes in closed form, curves by subdivision with bounds.

mod clusters;
mod curve_curve;
mod judge;
mod lines;
mod result;
mod search;
mod tree;

pub use curve_curve::{curve_curve, curve_self};
pub use lines::{line_line, line_plane, plane_plane, three_planes};
pub use result::{ContactKind, Crossing, CurveIntersections, Overlap};
