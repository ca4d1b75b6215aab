//! Curve / Primitive: lines, circles, arcs, ellipses, rectangles, polygons.

pub(super) mod arc;
mod circle;
mod line;
mod rectangle;
