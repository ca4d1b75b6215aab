//! Surfaces of equal height: of numbers on a grid in space, and of fields of metaballs.
//!
//! Marching cubes (W. E. Lorensen, H. E. Cline, *Marching cubes*, 1987): each cell of the grid is crossed by patches
//! whose corners lie on its edges. On every side of a cell the asymptotic decider says how corners are joined, and both
//! cells beside it ask the same question, so that patches always meet: the mesh has no cracks, no edge has more than two
//! faces, and all faces look from high to low. Inside a cell each patch is a disc; a tunnel through a single cell, which
//! only the interpolated field between its corners could tell, is not made.

mod balls;
mod grid;
mod march;
mod pattern;

pub use balls::{Metaball, MetaballField};
pub use grid::ScalarGrid;
pub use march::{Isosurfacing, NEAREST_TO_CORNER};
