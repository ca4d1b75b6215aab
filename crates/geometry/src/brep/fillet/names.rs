//! What edges are called in refusals: by their places in the shape that was given, also when some of its edges have
//! been rounded already and the others have moved to other places.

use std::collections::BTreeMap;

use super::joint::Stub;
use crate::Error;

/// What an edge of a shape was before.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Name {
    /// An edge of the shape that was given.
    Edge(usize),
    /// A border of the rounding of an edge.
    Border(usize),
}

/// The names of edges; without any, edges are called by their own places.
#[derive(Debug, Clone, Default)]
pub(super) struct Names(Option<BTreeMap<usize, Name>>);

impl Names {
    /// The names after a step in which edges moved, and roundings of edges got borders.
    pub(super) fn after(&self, kept: &BTreeMap<usize, usize>, borders: &[(usize, usize)]) -> Self {
        let old = |edge: usize| match &self.0 {
            None => Some(Name::Edge(edge)),
            Some(known) => known.get(&edge).copied(),
        };
        let mut names: BTreeMap<usize, Name> =
            kept.iter().filter_map(|(before, now)| Some((*now, old(*before)?))).collect();
        names.extend(borders.iter().filter_map(|(edge, now)| match old(*edge)? {
            Name::Edge(edge) | Name::Border(edge) => Some((*now, Name::Border(edge))),
        }));
        Self(Some(names))
    }

    pub(super) fn of(&self, edge: usize) -> String {
        match self.0.as_ref().map(|known| known.get(&edge)) {
            None => format!("edge {edge}"),
            Some(Some(Name::Edge(place))) => format!("edge {place}"),
            Some(Some(Name::Border(place))) => format!("the rounding of edge {place}"),
            Some(None) => "a new edge".into(),
        }
    }

    /// The refusal of an edge by name.
    pub(super) fn refused(&self, edge: usize, why: &str) -> Error {
        Error::Invalid { what: "fillet", why: format!("{}: {why}", self.of(edge)) }
    }

    /// The refusal of a vertex at which edges meet, by its place while that is the one in the shape that was given.
    pub(super) fn unsupported(&self, stubs: &[Stub], vertex: Option<usize>) -> Error {
        let mut edges: Vec<String> = stubs.iter().map(|stub| self.of(stub.0)).collect();
        edges.dedup();
        let (names, verb) = match edges.as_slice() {
            [only] => (only.clone(), "ends"),
            several => {
                match several.iter().map(|name| name.strip_prefix("edge ")).collect::<Option<Vec<_>>>() {
                    Some(places) => (format!("edges {}", places.join(", ")), "meet"),
                    None => (several.join(", "), "meet"),
                }
            }
        };
        let place = vertex
            .filter(|_| self.0.is_none())
            .map_or(String::new(), |vertex| format!(" at vertex {vertex}"));
        Error::Invalid {
            what: "fillet",
            why: format!("{names} {verb}{place} in a way that is not supported yet"),
        }
    }
}
