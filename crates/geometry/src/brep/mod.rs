//! Boundary representations: faces on surfaces, joined along edges.
//!
//! A [`Brep`] is a list of faces, each a part of a [`Surface`] bounded by loops. A loop is a chain of trims, which
//! are curves in the parameter plane of the surface; trims of neighbouring faces that run along one curve in space
//! share an edge, and edges that end in one point share a vertex. The parts and their names are those of openNURBS.
//!
//! The type holds whatever refers to parts that exist; [`Brep::faults`] says what keeps it from being a sound
//! boundary. Files hold many that are not.

mod assemble;
mod boolean;
mod bounds;
mod build;
mod cap;
mod divide;
mod edge;
mod edges;
mod edit;
mod face;
mod fillet;
pub(crate) mod flatten;
mod has_area;
mod inside;
mod iso;
mod isocurves;
mod join;
mod loop_;
mod meeting;
mod merge_faces;
mod of_mesh;
mod of_surface;
mod orient;
mod outline;
pub(crate) mod parameters;
mod part;
mod parts;
mod pierce;
pub(crate) mod planar;
mod project;
mod properties;
mod pulled;
mod region;
mod section;
mod solid;
mod subset;
#[cfg(test)]
pub(crate) mod testing;
mod thresholds;
mod tolerances;
mod trim;
mod trimmed;
mod unjoin;
mod validity;
mod vertex;

pub use boolean::{
    CommonCurve, Decision, DecisionKind, FaceName, FacePart, Fuse, Made, Refusal, RefusalClass,
};
pub(crate) use build::with_ends;
pub use build::{Along, Builder, NewEdge, NewFace, NewVertex, Path};
pub use edge::Edge;
pub use face::Face;
pub use fillet::{FilletBlend, FilletRail};
pub use flatten::flattened;
pub use inside::{BrepPlace, BrepPoint, ClosestOnBrep};
pub use iso::iso_of;
pub use join::Joined;
pub use loop_::{Loop, LoopKind};
pub use meeting::BrepMeeting;
pub use part::CurvePart;
pub use parts::Parts;
pub use pierce::{BrepCrossing, BrepPiercing};
pub use planar::PlanarFaces;
pub use project::CurveProjection;
pub use region::{FaceSide, Region, RegionKind, Regions};
pub use section::{BrepSection, BrepSections};
pub use solid::Solidity;
pub use trim::{Iso, Trim, TrimKind};
pub use validity::{Fault, Symptom};
pub use vertex::Vertex;

use crate::{Curve, Point3, Result, Surface};

/// Faces on surfaces, joined along edges. All places that its parts name exist.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Brep {
    parts: Parts,
}

impl Brep {
    /// The brep of the given parts.
    ///
    /// # Errors
    /// A part names another that does not exist, or holds a number that is not finite.
    pub fn from_parts(parts: Parts) -> Result<Self> {
        parts.check()?;
        Ok(Self { parts })
    }

    /// All parts, for reading.
    pub fn parts(&self) -> &Parts {
        &self.parts
    }

    /// All parts, for code that takes the brep apart and puts it together again.
    pub fn into_parts(self) -> Parts {
        self.parts
    }

    /// The vertices.
    pub fn vertices(&self) -> &[Vertex] {
        &self.parts.vertices
    }

    /// The edges.
    pub fn edges(&self) -> &[Edge] {
        &self.parts.edges
    }

    /// The trims.
    pub fn trims(&self) -> &[Trim] {
        &self.parts.trims
    }

    /// The loops.
    pub fn loops(&self) -> &[Loop] {
        &self.parts.loops
    }

    /// The faces.
    pub fn faces(&self) -> &[Face] {
        &self.parts.faces
    }

    /// The curve that an edge is a part of; none for an edge without one.
    pub fn edge_curve(&self, edge: usize) -> Option<&Curve> {
        self.parts.edge_curve(self.parts.edges.get(edge)?)
    }

    /// The curve in the parameter plane that a trim is a part of.
    pub fn trim_curve(&self, trim: usize) -> Option<&Curve> {
        self.parts.trim_curve(self.parts.trims.get(trim)?)
    }

    /// The surface of a face.
    pub fn face_surface(&self, face: usize) -> Option<&Surface> {
        self.parts.face_surface(self.parts.faces.get(face)?)
    }

    /// The point of an edge at a parameter of the edge's own domain.
    pub fn edge_point(&self, edge: usize, t: f64) -> Option<Point3> {
        let edge = self.parts.edges.get(edge)?;
        Some(edge.part.point_at(self.parts.edge_curve(edge)?, t))
    }

    /// The point of a trim, in the parameter plane, at a parameter of the trim's own domain.
    pub fn trim_point(&self, trim: usize, t: f64) -> Option<Point3> {
        let trim = self.parts.trims.get(trim)?;
        Some(trim.part.point_at(self.parts.trim_curve(trim)?, t))
    }

    /// The surface of a brep that is nothing but one surface, whole, and whether its face is turned over: one face
    /// whose only loop runs along the four sides of the domain.
    pub fn as_surface(&self) -> Option<(&Surface, bool)> {
        let [face] = self.faces() else { return None };
        let [_] = self.loops() else { return None };
        let mut found = [false; 4];
        for trim in self.trims() {
            let Iso::Side(side) = trim.iso else { return None };
            // A side may be cut into several trims.
            *found.get_mut(side as usize)? = true;
        }
        if found != [true; 4] {
            return None;
        }
        Some((self.parts.face_surface(face)?, face.reversed))
    }
}

impl Parts {
    fn edge_curve(&self, edge: &Edge) -> Option<&Curve> {
        self.curves_3d.get(edge.part.curve?)?.as_ref()
    }

    fn trim_curve(&self, trim: &Trim) -> Option<&Curve> {
        self.curves_2d.get(trim.part.curve?)?.as_ref()
    }

    pub(crate) fn face_surface(&self, face: &Face) -> Option<&Surface> {
        self.surfaces.get(face.surface?)?.as_ref()
    }

    /// The surface in whose parameter plane a trim lies.
    fn trim_surface(&self, trim: &Trim) -> Option<&Surface> {
        let face = self.loops.get(trim.in_loop?)?.face?;
        self.face_surface(self.faces.get(face)?)
    }
}
