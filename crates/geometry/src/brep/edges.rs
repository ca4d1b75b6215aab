//! Edges by what they join, and edges and trims as curves.

use super::{Brep, CurvePart};
use crate::{Curve, Result};

impl Brep {
    fn edges_of_valence(&self, wanted: impl Fn(usize) -> bool) -> Vec<usize> {
        let live = self.edges().iter().enumerate().filter(|(_, edge)| !edge.deleted);
        live.filter(|(_, edge)| wanted(edge.trims.len())).map(|(place, _)| place).collect()
    }

    /// The edges that bound one face only, in order.
    pub fn naked_edges(&self) -> Vec<usize> {
        self.edges_of_valence(|count| count == 1)
    }

    /// The edges between two faces, and the seams of closed ones, in order.
    pub fn interior_edges(&self) -> Vec<usize> {
        self.edges_of_valence(|count| count == 2)
    }

    /// The edges where more than two faces meet, in order.
    pub fn non_manifold_edges(&self) -> Vec<usize> {
        self.edges_of_valence(|count| count > 2)
    }

    /// Whether no edge joins more than two faces.
    pub fn is_manifold(&self) -> bool {
        self.non_manifold_edges().is_empty()
    }

    /// An edge as a curve of its own, over its own domain; `None` for one that does not exist or has no curve.
    ///
    /// # Errors
    /// The edge is too short to be a curve.
    pub fn edge_as_curve(&self, edge: usize) -> Result<Option<Curve>> {
        match (self.edges().get(edge), self.edge_curve(edge)) {
            (Some(edge), Some(curve)) => taken(curve, &edge.part).map(Some),
            _ => Ok(None),
        }
    }

    /// A trim as a curve of its own in the parameter plane, over its own domain; `None` for one that does not exist
    /// or has no curve.
    ///
    /// # Errors
    /// The trim is too short to be a curve.
    pub fn trim_as_curve(&self, trim: usize) -> Result<Option<Curve>> {
        match (self.trims().get(trim), self.trim_curve(trim)) {
            (Some(trim), Some(curve)) => taken(curve, &trim.part).map(Some),
            _ => Ok(None),
        }
    }
}

/// The part of a curve, in its own sense and over its own domain.
pub(super) fn taken(curve: &Curve, part: &CurvePart) -> Result<Curve> {
    let domain = curve.domain();
    let range = part.range.intersection(domain).unwrap_or(domain);
    let cut = if range == domain { curve.clone() } else { curve.trimmed(range)? };
    let turned = if part.reversed { cut.reversed() } else { cut };
    turned.with_domain(part.domain)
}
