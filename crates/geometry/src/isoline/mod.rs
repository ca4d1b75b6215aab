//! Lines of equal height: of a grid of numbers, and of fields of metaballs.

pub(crate) mod cell;
mod far;
mod grid;
mod join;
mod metaballs;
mod thresholds;

pub use grid::isolines;
pub use metaballs::Metaballs;

use crate::Point2;

/// A line of equal height: what is higher lies to its left.
#[derive(Debug, Clone, PartialEq)]
pub struct Isoline {
    /// Its points in order; a closed one does not repeat the first at its end.
    pub points: Vec<Point2>,
    /// Whether it comes back to its start.
    pub closed: bool,
}
