//! How fine a mesh of a surface or brep is.

use crate::meshing::thresholds::{FINEST, SHORT_OF_SIZE};
use std::f64::consts::SQRT_2;

use katydid_elementary::Elementary;

use crate::{Error, Result};

/// What is too short to be divided, as a part of the greatest distance.
const SHORT: f64 = 0.05;

/// How fine the mesh of a surface or brep is. A limit of 0 is off.
///
/// The names are those of Rhino's mesh settings; lengths are in model units and angles in radians.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MeshSettings {
    /// The greatest distance of the mesh from the surface.
    pub max_distance: f64,
    /// A greatest distance in proportion to the size of what is meshed: 0 is off, towards 1 it is finer. It is
    /// 0.5 · 10^(−1 − 3x) of the diagonal of the box around it, so 0.65 is about 0.0005 of the size.
    pub relative_tolerance: f64,
    /// What the distance by size does not go below.
    pub min_distance: f64,
    /// The greatest turn of the normal from one side of a mesh face to the other.
    pub max_angle: f64,
    /// The longest side of a quad of the first grid over its shortest; below √2 it counts as √2.
    pub max_aspect: f64,
    /// Sides are not halved when their halves would be shorter; wins over every other limit but `max_edge`. What turns by
    /// more than 120 degrees is halved all the same.
    pub min_edge: f64,
    /// The longest side of a quad along the parameters, and of every segment of an edge.
    pub max_edge: f64,
    /// The fewest quads of a face's first grid, before it is trimmed.
    pub min_count: usize,
    /// The most quads of a face's first grid; 0 for any number. Refinement may go beyond.
    pub max_count: usize,
    /// Whether the limits hold beyond the first grid.
    pub refine: bool,
    /// Whether flat faces get no vertices but those of their edges.
    pub simple_planes: bool,
    /// Whether every face is meshed for itself, without regard to its neighbours.
    pub jagged_seams: bool,
}

impl Default for MeshSettings {
    /// The quick set that Rhino shades with: a distance of 0.0005 of the size, at least 16 quads a face, flat faces
    /// without inner vertices.
    fn default() -> Self {
        Self {
            max_distance: 0.0,
            relative_tolerance: 0.65,
            min_distance: 0.0,
            max_angle: 0.0,
            max_aspect: 0.0,
            min_edge: 0.0001,
            max_edge: 0.0,
            min_count: 16,
            max_count: 0,
            refine: true,
            simple_planes: true,
            jagged_seams: false,
        }
    }
}

impl MeshSettings {
    /// Within a distance, without any other limit.
    pub fn within(distance: f64) -> Self {
        Self {
            max_distance: distance,
            relative_tolerance: 0.0,
            min_edge: 0.0,
            min_count: 0,
            ..Self::default()
        }
    }

    /// The smooth and slow set that Rhino shades with: a third of the default's distance, and normals that turn by at
    /// most 20 degrees across a mesh face.
    pub fn smooth() -> Self {
        Self { relative_tolerance: 0.8, max_angle: 20_f64.to_radians(), ..Self::default() }
    }

    /// Refuses limits that are no numbers or below 0.
    pub(super) fn check(&self) -> Result<()> {
        for (what, value) in [
            ("greatest distance", self.max_distance),
            ("relative tolerance", self.relative_tolerance),
            ("least distance", self.min_distance),
            ("greatest angle", self.max_angle),
            ("aspect ratio", self.max_aspect),
            ("shortest edge", self.min_edge),
            ("longest edge", self.max_edge),
        ] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(Error::OutOfRange { what, value, must: "finite and not negative" });
            }
        }
        Ok(())
    }

    /// The limits for something of a size (the diagonal of its box).
    pub(super) fn limits(&self, size: f64) -> Limits {
        let off = |x: f64| if x > 0.0 { x } else { f64::INFINITY };
        let share = if self.relative_tolerance > 0.0 {
            (0.5 * 10_f64.raised_to(-1.0 - 3.0 * self.relative_tolerance.min(1.0)) * size)
                .max(self.min_distance)
        } else {
            0.0
        };
        // Nearer than rounding cannot be asked for.
        let distance = off(self.max_distance).min(off(share)).max(FINEST * size);
        Limits {
            distance,
            short: if distance.is_finite() { SHORT * distance } else { SHORT_OF_SIZE * size },
            angle: off(self.max_angle),
            aspect: if self.max_aspect > 0.0 { self.max_aspect.max(SQRT_2) } else { f64::INFINITY },
            min_edge: self.min_edge.min(off(self.max_edge)),
            max_edge: off(self.max_edge),
            min_count: self.min_count,
            max_count: if self.max_count > 0 { self.max_count } else { usize::MAX },
            refine: self.refine,
            simple_planes: self.simple_planes,
        }
    }
}

/// The limits in force: what is off is infinite.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    pub(super) distance: f64,
    /// What is so short is not divided, whatever rounding says of its shape.
    pub(super) short: f64,
    pub(super) angle: f64,
    pub(super) aspect: f64,
    pub(super) min_edge: f64,
    pub(super) max_edge: f64,
    pub(super) min_count: usize,
    pub(super) max_count: usize,
    pub(super) refine: bool,
    pub(super) simple_planes: bool,
}
