//! Pipes around networks of lines, with smooth joints.
//!
//! Around every node where struts meet, rings of four points, one about each strut, lie on one sphere, so far out that
//! the caps they cut off do not overlap: then each ring is a face of the convex hull of all of them, and what is left of
//! the hull joins the rings (after V. Srinivasan, E. Mandal and E. Akleman, *Solidifying wireframes*, 2005). Tubes of
//! quads run from ring to ring.

mod build;
mod chain;
mod cube;
mod network;
mod node;

pub use network::MultiPipeNetwork;

use super::SubDNet;
use crate::{Error, Point3, Result};

/// How the ends of a pipe are that meet no other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum MultiPipeCap {
    /// Open.
    #[default]
    Open,
    /// Rounded, beyond the end by the radius.
    Round,
    /// Flat, with a sharp rim.
    Flat,
}

/// How a pipe around a network is made.
#[derive(Debug, Clone, PartialEq)]
pub struct MultiPipe {
    /// The radii in model units: one for all nodes, or one for each of `size_points`.
    pub radii: Vec<f64>,
    /// The places whose nearest nodes get the radii. Radii of other nodes go over evenly from node to node.
    pub size_points: Vec<Point3>,
    /// How far from a node the first loop of edges lies at least, in radii of the node; 0 for as near as it can.
    pub end_offset: f64,
    /// The size of struts between their ends, as a factor: below 1 they are thinner there, above 1 thicker.
    pub strut_size: f64,
    /// About how far loops of edges along a strut are from each other; 0 for none beside those of the nodes.
    pub segment: f64,
    /// Whether nodes become cubes: 0 never, 1 wherever no two struts want one side of the cube; between them where every
    /// strut is within that part of 54.7 degrees (from the middle of a side of a cube to its corner) of an axis.
    pub cube_fit: f64,
    /// How open ends are closed.
    pub caps: MultiPipeCap,
}

impl Default for MultiPipe {
    fn default() -> Self {
        Self {
            radii: vec![0.5],
            size_points: Vec::new(),
            end_offset: 1.0,
            strut_size: 1.0,
            segment: 0.0,
            cube_fit: 0.0,
            caps: MultiPipeCap::Open,
        }
    }
}

/// The corners of a ring about a strut, counter-clockwise seen along the strut's direction, from its far end back.
type Ring = [usize; 4];

/// How much larger the ring of a cage is than the surface: a closed cubic spline with four control points on a circle
/// passes at two thirds of its radius (P&T, *The NURBS Book*, §12: (1 + 4 + 1) / 6 of opposite points).
const CAGE: f64 = 1.5;

impl MultiPipe {
    /// The control net of a branching pipe around a network: a closed surface of the radius around the struts, but for
    /// open ends. Two struts that meet at less than a right angle's turn share a ring; where more meet, or they turn more
    /// sharply, there is a joint. Where struts are short or meet at small angles the pipe is thinner.
    ///
    /// # Errors
    /// A network without struts; a radius that is not finite and above 0, or fewer radii than points; an offset, size,
    /// segment or fit below 0; struts that run along each other from a node; or more than a million faces.
    pub fn around(&self, network: &MultiPipeNetwork) -> Result<SubDNet> {
        self.check()?;
        build::built(self, network)
    }

    fn check(&self) -> Result<()> {
        for (what, value) in [
            ("end offset of a pipe", self.end_offset),
            ("segment of a pipe", self.segment),
            ("cube fit of a pipe", self.cube_fit),
        ] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(Error::OutOfRange { what, value, must: "finite and not below 0" });
            }
        }
        for value in self.radii.iter().chain([&self.strut_size]).copied() {
            if !(value > 0.0 && value.is_finite()) {
                let what = "radius or strut size of a pipe";
                return Err(Error::OutOfRange { what, value, must: "finite and greater than 0" });
            }
        }
        if self.radii.is_empty() || (self.radii.len() > 1 && self.radii.len() != self.size_points.len()) {
            return Err(Error::Invalid {
                what: "radii of a pipe",
                why: format!(
                    "there must be one, or one for each point: {} for {} points",
                    self.radii.len(),
                    self.size_points.len()
                ),
            });
        }
        if !self.size_points.iter().all(|p| p.is_finite()) {
            return Err(Error::NotFinite("point of a radius"));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
