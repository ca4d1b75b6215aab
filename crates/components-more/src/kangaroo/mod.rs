//! Kangaroo 2: goals that pull points, and solvers that bring them to rest.
//!
//! The scheme is that of projective dynamics: each goal moves its own points to where they fulfil it, and a particle goes to
//! the weighted mean of what its goals ask for.

mod anchors;
mod angles;
mod collisions;
mod elder;
mod fits;
mod folds;
mod goal;
mod grab;
mod held;
mod lines;
mod loads;
mod mesh_tools;
mod on;
mod solve;
mod solvers;
mod surfaces;
#[cfg(test)]
mod tests;
mod thresholds;
mod utility;

use goal::{Goal, Pull, Rule};

/// Quads cut into four quads and triangles into four triangles.
pub(crate) fn refined(polygons: &crate::polygons::Polygons) -> crate::polygons::Polygons {
    mesh_tools::refined(polygons).0
}
