//! Which places of a mesh are joined by an edge.

use super::Mesh;

/// For every place of a mesh the places at the other ends of its edges. Vertices in the same place are one, named by
/// the first of them.
pub(super) struct Neighbours {
    /// The first vertex in the place of each vertex.
    pub(super) merged: Vec<u32>,
    /// Whether a naked edge ends there, by first vertex.
    pub(super) naked: Vec<bool>,
    starts: Vec<usize>,
    others: Vec<u32>,
}

impl Neighbours {
    pub(super) fn new(mesh: &Mesh) -> Self {
        let n = mesh.vertices().len();
        let (edges, merged) = (mesh.edges(), mesh.merged_indices());
        let mut starts = vec![0_usize; n + 2];
        let mut naked = vec![false; n];
        for edge in &edges {
            for end in edge.vertices.map(|v| v as usize) {
                if let Some(count) = starts.get_mut(end + 2) {
                    *count += 1;
                }
                if let Some(place) = naked.get_mut(end) {
                    *place |= edge.faces == 1;
                }
            }
        }
        // Counts become starts, one place late, and move to their own place while the lists are filled.
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        let mut others = vec![0; 2 * edges.len()];
        for edge in &edges {
            let [a, b] = edge.vertices;
            for (from, to) in [(a, b), (b, a)] {
                if let Some(next) = starts.get_mut(from as usize + 1) {
                    if let Some(place) = others.get_mut(*next) {
                        *place = to;
                    }
                    *next += 1;
                }
            }
        }
        Self { merged, naked, starts, others }
    }

    /// The first vertex in the place of a vertex.
    pub(super) fn place(&self, vertex: usize) -> usize {
        self.merged.get(vertex).map_or(vertex, |&m| m as usize)
    }

    /// The places joined to a place, by first vertices.
    pub(super) fn of(&self, place: usize) -> &[u32] {
        match (self.starts.get(place), self.starts.get(place + 1)) {
            (Some(&a), Some(&b)) => self.others.get(a..b).unwrap_or(&[]),
            _ => &[],
        }
    }

    /// A list with an entry a vertex, each that of the first vertex in its place.
    pub(super) fn spread<T: Copy>(&self, mut list: Vec<T>) -> Vec<T> {
        for (i, &m) in self.merged.iter().enumerate() {
            if let Some(value) = list.get(m as usize).copied()
                && let Some(slot) = list.get_mut(i)
            {
                *slot = value;
            }
        }
        list
    }
}
