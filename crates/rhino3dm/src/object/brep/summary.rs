//! The skeleton of a brep: curves, vertices, edges, and how many faces there are.

use katydid_geometry::brep::Solidity;
use katydid_geometry::{Curve, Interval, Point3};

use super::{BrepObject, WHAT};
use crate::object::{Object, RawObject};
use crate::{Error, Limits, Result};

/// An edge: a part of one of the brep's curves between two vertices.
#[derive(Debug, Clone, PartialEq)]
pub struct BrepEdge {
    /// Index into [`BrepSummary::curves`]; nothing for an edge without a curve.
    pub curve: Option<usize>,
    /// Whether the edge runs against its curve.
    pub reversed: bool,
    /// The part of the curve's domain that the edge covers.
    pub part: Interval,
    /// The edge's own domain, which `part` maps to (backwards when reversed).
    pub domain: Interval,
    /// Indices of its end vertices, start first.
    pub vertices: [Option<usize>; 2],
    /// How many faces meet at the edge, each trim counted: 1 is naked, 2 an inner edge or a seam.
    pub trims: usize,
    /// Its tolerance in model units.
    pub tolerance: f64,
}

/// The skeleton of a brep.
#[derive(Debug, Clone, PartialEq)]
pub struct BrepSummary {
    /// What the flag in its bytes says. Breps that were never asked have [`Solidity::Unknown`]; see
    /// [`BrepSummary::is_closed`].
    pub solidity: Solidity,
    /// The number of faces.
    pub faces: usize,
    /// The vertices.
    pub vertices: Vec<Point3>,
    /// The curves in space that edges refer to.
    pub curves: Vec<Curve>,
    /// The edges.
    pub edges: Vec<BrepEdge>,
}

impl BrepSummary {
    /// Reads the skeleton out of a kept brep.
    ///
    /// # Errors
    /// The object is no brep, its bytes are broken, or the kernel refuses it.
    pub fn read(raw: &RawObject) -> Result<Self> {
        match raw.parse(&Limits::default())? {
            Object::Brep(object) => Ok(Self::of(&object)),
            _ => Err(Error::malformed(0, WHAT, format!("a {} is no brep", raw.class_name()))),
        }
    }

    /// The skeleton of a brep.
    pub fn of(object: &BrepObject) -> Self {
        let parts = object.brep.parts();
        // Places without a curve are passed over.
        let mut curves = Vec::new();
        let places: Vec<Option<usize>> = (parts.curves_3d.iter())
            .map(|curve| {
                curves.push(curve.clone()?);
                Some(curves.len() - 1)
            })
            .collect();
        let edges = parts.edges.iter().map(|edge| BrepEdge {
            curve: edge.part.curve.and_then(|curve| places.get(curve).copied().flatten()),
            reversed: edge.part.reversed,
            part: edge.part.range,
            domain: edge.part.domain,
            vertices: edge.vertices,
            trims: edge.trims.len(),
            tolerance: edge.tolerance,
        });
        Self {
            solidity: parts.solidity,
            faces: parts.faces.len(),
            vertices: parts.vertices.iter().map(|vertex| vertex.point).collect(),
            edges: edges.collect(),
            curves,
        }
    }

    /// Whether no edge is naked: by the flag if it says so, else by counting the trims at each edge.
    pub fn is_closed(&self) -> bool {
        match self.solidity {
            Solidity::Outward | Solidity::Inward => true,
            Solidity::Unknown => self.faces > 0 && self.edges.iter().all(|edge| edge.trims >= 2),
        }
    }

    /// The point of edge `edge` at parameter `t` of the edge's own domain; nothing when there is no such edge or
    /// it has no curve.
    ///
    /// The edge's domain maps linearly onto its part of the curve's, backwards when the edge runs against it.
    pub fn edge_point(&self, edge: usize, t: f64) -> Option<Point3> {
        let edge = self.edges.get(edge)?;
        let x = edge.domain.normalized(t);
        let x = if edge.reversed { 1.0 - x } else { x };
        Some(self.curves.get(edge.curve?)?.point_at(edge.part.at(x)))
    }
}
