//! Where things meet: lines and planes in closed form, curves and surfaces by subdivision with bounds.

mod lines;

pub use lines::{line_line, line_plane, plane_plane, three_planes};
