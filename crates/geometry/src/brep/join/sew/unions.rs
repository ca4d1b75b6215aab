//! Vertices that become one.

use super::super::super::Parts;

/// Sets of vertices that are one, each with the edges that end there.
pub(super) struct Unions {
    /// For each vertex another one of its set, or itself when it stands for the set: the one with the lowest place.
    same: Vec<usize>,
    /// For each vertex that stands for a set the edges at it.
    edges: Vec<Vec<usize>>,
}

impl Unions {
    /// Each vertex alone.
    pub(super) fn of(parts: &Parts) -> Self {
        let mut edges = vec![Vec::new(); parts.vertices.len()];
        for (place, edge) in parts.edges.iter().enumerate().filter(|(_, edge)| !edge.deleted) {
            for vertex in edge.vertices.into_iter().flatten() {
                edges.get_mut(vertex).into_iter().for_each(|at: &mut Vec<usize>| at.push(place));
            }
        }
        Self { same: (0..parts.vertices.len()).collect(), edges }
    }

    /// The vertex that stands for the set of this one.
    pub(super) fn root(&self, mut vertex: usize) -> usize {
        while let Some(&next) = self.same.get(vertex).filter(|next| **next != vertex) {
            vertex = next;
        }
        vertex
    }

    /// Makes two vertices one.
    pub(super) fn unite(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        let (low, high) = (a.min(b), a.max(b));
        if low == high || high >= self.edges.len() {
            return;
        }
        self.same[high] = low;
        // The shorter list is copied, so that all copies together are no more than n log n.
        let mut long = std::mem::take(&mut self.edges[high]);
        let mut short = std::mem::take(&mut self.edges[low]);
        if long.len() < short.len() {
            std::mem::swap(&mut long, &mut short);
        }
        long.append(&mut short);
        self.edges[low] = long;
    }

    /// Whether an edge between two different vertices would have only one if these pairs became one.
    pub(super) fn would_collapse(&self, parts: &Parts, pairs: [[usize; 2]; 2]) -> bool {
        let [[s, p], [e, q]] = pairs.map(|pair| pair.map(|v| self.root(v)));
        let all_one = s == e || s == q || p == e || p == q;
        let set = |v: usize| match self.root(v) {
            v if v == s || v == p => s,
            v if v == e || v == q => {
                if all_one {
                    s
                } else {
                    e
                }
            }
            v => v,
        };
        // Only an edge between two of these four can lose a vertex.
        [s, p, e, q].iter().filter_map(|v| self.edges.get(*v)).flatten().any(|&edge| {
            let edge = parts.edges.get(edge).filter(|edge| !edge.deleted);
            matches!(edge.map(|edge| edge.vertices), Some([Some(x), Some(y)])
                if x != y && self.root(x) != self.root(y) && set(x) == set(y))
        })
    }
}
