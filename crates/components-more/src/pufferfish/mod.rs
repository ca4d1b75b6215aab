//! Pufferfish: things between things, averages, grids by parameters, and helpers for numbers.
//!
//! Names and ports are facts from a public list of its components; ids are our own, so that objects are found by name. What a
//! set is blended by is our reading: straight between neighbours, or a cubic of Catmull and Rom through each of its numbers.

mod curves;
mod grids;
mod lists;
mod meshes;
mod mix;
mod numbers;
mod planes;
mod surfaces;
#[cfg(test)]
mod tests;
mod tween;
mod values;
mod weights;

/// More parts than this along one direction would be waited for too long.
const MOST_PARTS: usize = 100_000;
