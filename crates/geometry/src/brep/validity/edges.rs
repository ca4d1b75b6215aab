//! Vertices and edges.

use super::super::{Edge, Parts};
use super::{Faults, Symptom, occurrences};

const VERTEX: &str = "vertex";
const EDGE: &str = "edge";

impl Parts {
    pub(super) fn vertex_faults(&self, faults: &mut Faults) {
        for (i, vertex) in self.vertices.iter().enumerate() {
            if vertex.deleted {
                faults.unless(vertex.edges.is_empty(), VERTEX, i, || "it is deleted, but names edges".into());
                continue;
            }
            faults.unless(vertex.tolerance >= 0.0, VERTEX, i, || "its tolerance is not set".into());
            for &place in &vertex.edges {
                let Some(edge) = self.edges.get(place).filter(|edge| !edge.deleted) else {
                    faults.unless(false, VERTEX, i, || format!("edge {place} is deleted"));
                    continue;
                };
                let ends = edge.vertices.iter().filter(|v| **v == Some(i)).count();
                faults.unless(ends > 0, VERTEX, i, || format!("edge {place} does not end here"));
                let named = occurrences(&vertex.edges, place);
                faults.unless(ends == 0 || named <= ends, VERTEX, i, || {
                    format!("edge {place} is named {named} times")
                });
            }
        }
    }

    pub(super) fn edge_faults(&self, faults: &mut Faults) {
        for (i, edge) in self.edges.iter().enumerate() {
            if edge.deleted {
                let bare =
                    edge.trims.is_empty() && edge.part.curve.is_none() && edge.vertices == [None, None];
                faults.unless(bare, EDGE, i, || "it is deleted, but names other parts".into());
                continue;
            }
            faults.unless(edge.tolerance >= 0.0, EDGE, i, || "its tolerance is not set".into());
            self.edge_curve_faults(i, edge, faults);
            self.edge_end_faults(i, edge, faults);
            for &place in &edge.trims {
                let Some(trim) = self.trims.get(place).filter(|trim| !trim.deleted) else {
                    faults.unless(false, EDGE, i, || format!("trim {place} is deleted"));
                    continue;
                };
                faults
                    .unless(trim.edge == Some(i), EDGE, i, || format!("trim {place} does not run along it"));
                faults.unless(occurrences(&edge.trims, place) == 1, EDGE, i, || {
                    format!("trim {place} is named more than once")
                });
            }
        }
    }

    fn edge_curve_faults(&self, i: usize, edge: &Edge, faults: &mut Faults) {
        let Some(curve) = self.edge_curve(edge) else {
            faults.shown_unless(false, Symptom::Missing, EDGE, i, || "it has no curve".into());
            return;
        };
        let part = &edge.part;
        faults.shown_unless(
            part.range.is_increasing() && part.domain.is_increasing(),
            Symptom::EdgeWithoutLength,
            EDGE,
            i,
            || "its domain does not increase".into(),
        );
        faults.shown_unless(
            curve.domain().includes(part.range, false),
            Symptom::EdgeBeyondCurve,
            EDGE,
            i,
            || "it goes beyond its curve".into(),
        );
        let [start, end] = edge.vertices;
        let closed = self.is_closed_edge(edge);
        let symptom = if closed { Symptom::EdgeWithoutLength } else { Symptom::EdgeToItself };
        faults.shown_unless(closed == (start == end), symptom, EDGE, i, || {
            if closed { "it is closed, but has two vertices" } else { "it is open, but has one vertex" }
                .into()
        });
    }

    fn edge_end_faults(&self, i: usize, edge: &Edge, faults: &mut Faults) {
        for (end, name) in edge.vertices.into_iter().zip(["start", "end"]) {
            let Some(vertex) = end.and_then(|v| self.vertices.get(v)) else {
                faults.unless(false, EDGE, i, || format!("it has no vertex at its {name}"));
                continue;
            };
            faults.unless(!vertex.deleted, EDGE, i, || format!("the vertex at its {name} is deleted"));
            faults.unless(vertex.edges.contains(&i), EDGE, i, || {
                format!("the vertex at its {name} does not name it")
            });
        }
    }
}
