//! What a brep is made of, and the check that all of it exists.

use super::{CurvePart, Edge, Face, Loop, Regions, Solidity, Trim, Vertex};
use crate::{Curve, Error, Point3, Result, Surface};

/// What a brep is made of. Everything refers to everything else by its place in these lists.
///
/// A place in a list of curves or surfaces may be empty: where operations left a gap, or where a file holds a curve
/// that is none (a segment without length). [`Brep::faults`](super::Brep::faults) names what depends on such a place.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Parts {
    /// Curves in the parameter planes of the surfaces: x is u, y is v, z is 0.
    pub curves_2d: Vec<Option<Curve>>,
    /// Curves in space.
    pub curves_3d: Vec<Option<Curve>>,
    /// Surfaces.
    pub surfaces: Vec<Option<Surface>>,
    /// Vertices.
    pub vertices: Vec<Vertex>,
    /// Edges.
    pub edges: Vec<Edge>,
    /// Trims.
    pub trims: Vec<Trim>,
    /// Loops.
    pub loops: Vec<Loop>,
    /// Faces.
    pub faces: Vec<Face>,
    /// What is known of its inside.
    pub solidity: Solidity,
    /// The regions that it divides space into, when they were computed.
    pub regions: Option<Regions>,
}

impl Parts {
    /// Refuses places that do not exist and numbers that are none.
    pub(super) fn check(&self) -> Result<()> {
        for (kind, curves) in [("parameter curve", &self.curves_2d), ("space curve", &self.curves_3d)] {
            for (i, curve) in curves.iter().enumerate() {
                let sound = curve.as_ref().map_or(Ok(()), Curve::check_finite);
                sound.map_err(|why| Place(kind, i).refuse(&why.to_string()))?;
            }
        }
        for (i, surface) in self.surfaces.iter().enumerate() {
            let sound = surface.as_ref().map_or(Ok(()), Surface::check_finite);
            sound.map_err(|why| Place("surface", i).refuse(&why.to_string()))?;
        }
        for (i, vertex) in self.vertices.iter().enumerate() {
            let at = Place("vertex", i);
            at.finite([vertex.tolerance])?;
            at.finite_point(vertex.point)?;
            at.all(&vertex.edges, "edge", self.edges.len())?;
        }
        for (i, edge) in self.edges.iter().enumerate() {
            let at = Place("edge", i);
            at.finite([edge.tolerance])?;
            at.part(&edge.part, "space curve", self.curves_3d.len())?;
            at.each(edge.vertices, "vertex", self.vertices.len())?;
            at.all(&edge.trims, "trim", self.trims.len())?;
        }
        for (i, trim) in self.trims.iter().enumerate() {
            let at = Place("trim", i);
            at.finite(trim.tolerance)?;
            at.finite(trim.older_tolerances)?;
            at.part(&trim.part, "parameter curve", self.curves_2d.len())?;
            at.each([trim.edge], "edge", self.edges.len())?;
            at.each(trim.vertices, "vertex", self.vertices.len())?;
            at.each([trim.in_loop], "loop", self.loops.len())?;
        }
        for (i, chain) in self.loops.iter().enumerate() {
            let at = Place("loop", i);
            at.all(&chain.trims, "trim", self.trims.len())?;
            at.each([chain.face], "face", self.faces.len())?;
        }
        for (i, face) in self.faces.iter().enumerate() {
            let at = Place("face", i);
            at.all(&face.loops, "loop", self.loops.len())?;
            at.each([face.surface], "surface", self.surfaces.len())?;
        }
        self.regions.as_ref().map_or(Ok(()), |regions| self.check_regions(regions))
    }

    fn check_regions(&self, regions: &Regions) -> Result<()> {
        for (i, side) in regions.sides.iter().enumerate() {
            let at = Place("side of a face", i);
            at.each([side.face], "face", self.faces.len())?;
            at.each([side.region], "region", regions.regions.len())?;
        }
        for (i, region) in regions.regions.iter().enumerate() {
            Place("region", i).all(&region.sides, "side of a face", regions.sides.len())?;
        }
        Ok(())
    }
}

/// The part that is being checked, by its kind and place.
#[derive(Clone, Copy)]
struct Place(&'static str, usize);

impl Place {
    fn refuse(self, why: &str) -> Error {
        Error::Invalid { what: "brep", why: format!("{} {}: {why}", self.0, self.1) }
    }

    fn finite<const N: usize>(self, numbers: [f64; N]) -> Result<()> {
        let all = numbers.iter().all(|x| x.is_finite());
        if all { Ok(()) } else { Err(self.refuse("it holds a number that is not finite")) }
    }

    fn finite_point(self, p: Point3) -> Result<()> {
        self.finite([p.x, p.y, p.z])
    }

    /// Places that may be empty.
    fn each<const N: usize>(self, places: [Option<usize>; N], what: &str, count: usize) -> Result<()> {
        places.into_iter().flatten().try_for_each(|place| self.exists(place, what, count))
    }

    fn all(self, places: &[usize], what: &str, count: usize) -> Result<()> {
        places.iter().try_for_each(|place| self.exists(*place, what, count))
    }

    fn exists(self, place: usize, what: &str, count: usize) -> Result<()> {
        if place < count {
            return Ok(());
        }
        Err(self.refuse(&format!("it names {what} {place}, but there are {count}")))
    }

    fn part(self, part: &CurvePart, what: &str, count: usize) -> Result<()> {
        let (range, domain) = (part.range, part.domain);
        self.finite([range.start, range.end, domain.start, domain.end])?;
        self.each([part.curve], what, count)
    }
}
