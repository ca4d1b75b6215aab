//! How a surface of equal height runs through one cell.
//!
//! Corner k of a cell lies at x = bit 0, y = bit 1, z = bit 2 of k. Edge 4a + e runs along axis a, from the corner whose
//! other two coordinates are the bits of e.

use crate::isoline::cell::{highs_joined, is_way, ways_of};

/// The corners of the sides, counter-clockwise seen from outside.
const SIDES: [[usize; 4]; 6] =
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

/// A corner of a patch: an edge of the cell, or the middle of a patch.
const EDGES: u8 = 12;
/// No edge.
const NONE: u8 = u8::MAX;

/// The patches of one kind of cell.
#[derive(Debug, Clone, Default)]
pub(super) struct Pattern {
    /// Corners counter-clockwise seen from the low side: an edge, or 12 + k for the k-th middle.
    pub(super) triangles: Vec<[u8; 3]>,
    /// The patches that need a corner in their middle, by the edges around them.
    pub(super) middles: Vec<Vec<u8>>,
}

/// The two ends of an edge.
pub(super) fn ends(edge: u8) -> [usize; 2] {
    let (axis, rest) = (usize::from(edge / 4), usize::from(edge % 4));
    let [first, second] = [[1, 2], [0, 2], [0, 1]].get(axis).copied().unwrap_or([0, 1]);
    let low = (rest & 1) << first | (rest >> 1) << second;
    [low, low | 1 << axis]
}

/// The edge between two neighbouring corners.
fn edge_between(a: usize, b: usize) -> u8 {
    (0..EDGES).find(|&e| ends(e) == [a.min(b), a.max(b)]).unwrap_or(NONE)
}

/// Whether two edges bound a common side.
fn share_a_side(a: u8, b: u8) -> bool {
    let on = |edge: u8, side: &[usize; 4]| ends(edge).iter().all(|c| side.contains(c));
    SIDES.iter().any(|side| on(a, side) && on(b, side))
}

/// The number of the pattern of a cell: which corners are high, and on which sides two high corners that face each
/// other are joined. A height of 0 counts as high.
#[inline]
pub(super) fn number(high: usize, heights: &[f64; 8]) -> usize {
    SIDES.iter().enumerate().fold(high, |number, (s, side)| {
        let [a, b, c, d] = side.map(|k| high >> k & 1 == 1);
        let faced = a == c && b == d && a != b;
        let joined = faced && highs_joined(side.map(|k| heights.get(k).copied().unwrap_or(0.0)));
        number | usize::from(joined) << (8 + s)
    })
}

/// All patterns met so far.
pub(super) struct Patterns(Vec<Option<Pattern>>);

impl Patterns {
    pub(super) fn new() -> Self {
        Self(vec![None; 1 << 14])
    }

    /// The pattern of a number, made when first asked for.
    #[inline]
    pub(super) fn get(&mut self, number: usize) -> Option<&Pattern> {
        self.0.get_mut(number).map(|p| &*p.get_or_insert_with(|| Pattern::of(number)))
    }
}

impl Pattern {
    fn of(number: usize) -> Self {
        let mut next = [NONE; EDGES as usize];
        for (s, side) in SIDES.iter().enumerate() {
            let case = side.iter().enumerate().fold(0, |case, (k, &c)| case | (number >> c & 1) << k);
            let (first, second) = ways_of(case, number >> (8 + s) & 1 == 1);
            let edge = |k: u8| {
                let k = usize::from(k % 4);
                edge_between(side[k], side[(k + 1) % 4])
            };
            for [from, to] in [Some(first), second].into_iter().flatten().filter(|w| is_way(*w)) {
                // What is high lies to the left of a way: walked backwards, around what is low.
                if let Some(slot) = next.get_mut(usize::from(edge(to))) {
                    *slot = edge(from);
                }
            }
        }
        let mut out = Self::default();
        for start in 0..EDGES {
            let (mut ring, mut at) = (Vec::new(), start);
            while let Some(to) = next.get_mut(usize::from(at)).map(|n| std::mem::replace(n, NONE)) {
                if to == NONE {
                    break;
                }
                ring.push(at);
                at = to;
            }
            if ring.len() >= 3 {
                out.fill(ring);
            }
        }
        out
    }

    /// Triangles within a ring of edges. No triangle's side may run along a side of the cell unless the ring does: the
    /// cell beyond could have the same side once more. Where that cannot be, the ring gets a middle.
    fn fill(&mut self, ring: Vec<u8>) {
        if let Some(triangles) = triangulated(&ring) {
            self.triangles.extend(triangles);
            return;
        }
        let middle = EDGES + self.middles.len() as u8;
        for (k, &from) in ring.iter().enumerate() {
            let to = ring[(k + 1) % ring.len()];
            self.triangles.push([from, to, middle]);
        }
        self.middles.push(ring);
    }
}

/// The triangulation of a ring with the shortest diagonals, by their squared lengths between the edges' middles
/// (dynamic programming: G. T. Klincsek, 1980); `None` if each has a diagonal along a side of the cell.
fn triangulated(ring: &[u8]) -> Option<Vec<[u8; 3]>> {
    let n = ring.len();
    let middle = |edge: u8| -> [f64; 3] {
        let [a, b] = ends(edge);
        std::array::from_fn(|c| 0.5 * ((a >> c & 1) + (b >> c & 1)) as f64)
    };
    let cost = |i: usize, j: usize| {
        if j - i == 1 || (i == 0 && j == n - 1) {
            return 0.0;
        }
        if share_a_side(ring[i], ring[j]) {
            return f64::INFINITY;
        }
        let (p, q) = (middle(ring[i]), middle(ring[j]));
        (0..3).map(|c| (p[c] - q[c]).powi(2)).sum()
    };
    // best[i][j]: the least cost of the part from corner i to corner j, and the third corner of the triangle there.
    let mut best = vec![vec![(0.0_f64, 0_usize); n]; n];
    for span in 2..n {
        for i in 0..n - span {
            let j = i + span;
            let by = |k: usize| (best[i][k].0 + best[k][j].0 + cost(i, j), k);
            let first = by(i + 1);
            best[i][j] = (i + 2..j).map(by).fold(first, |a, b| if b.0 < a.0 { b } else { a });
        }
    }
    if !best[0][n - 1].0.is_finite() {
        return None;
    }
    let (mut out, mut parts) = (Vec::with_capacity(n - 2), vec![(0, n - 1)]);
    while let Some((i, j)) = parts.pop() {
        if j - i >= 2 {
            let k = best[i][j].1;
            out.push([ring[i], ring[k], ring[j]]);
            parts.extend([(i, k), (k, j)]);
        }
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    #[test]
    fn every_pattern_is_discs_that_end_on_the_sides() {
        let mut middles = 0;
        for number in 0..1 << 14 {
            let high = number & 255;
            let faced = SIDES.iter().enumerate().all(|(s, side)| {
                let [a, b, c, d] = side.map(|k| high >> k & 1 == 1);
                number >> (8 + s) & 1 == 0 || (a == c && b == d && a != b)
            });
            if !faced {
                continue;
            }
            let pattern = Pattern::of(number);
            middles += pattern.middles.len();
            let mut sides: HashMap<(u8, u8), i32> = HashMap::new();
            for t in &pattern.triangles {
                for k in 0..3 {
                    let (a, b) = (t[k], t[(k + 1) % 3]);
                    assert_ne!(a, b);
                    let count = sides.entry((a, b)).or_default();
                    *count += 1;
                    assert_eq!(*count, 1, "pattern {number:b}");
                }
            }
            // A side without its reverse is a rim, and lies on a side of the cell; one with it does not.
            for &(a, b) in sides.keys() {
                let inner = sides.contains_key(&(b, a));
                let flat = a < EDGES && b < EDGES && share_a_side(a, b);
                assert_eq!(inner, !flat, "pattern {number:b}");
            }
            // Every edge between high and low is used, and no other.
            for e in 0..EDGES {
                let [a, b] = ends(e);
                let crossed = (high >> a ^ high >> b) & 1 == 1;
                assert_eq!(crossed, pattern.triangles.iter().flatten().any(|&x| x == e));
            }
        }
        assert!(middles > 0);
    }

    #[test]
    fn high_lies_behind() {
        // Only the corner at the origin is high: the triangle's normal leads away from it.
        let pattern = Pattern::of(1);
        assert_eq!(pattern.triangles.len(), 1);
        let at = |edge: u8| -> [f64; 3] {
            let [a, b] = ends(edge);
            std::array::from_fn(|c| 0.5 * ((a >> c & 1) + (b >> c & 1)) as f64)
        };
        let [p, q, r] = pattern.triangles[0].map(at);
        let (u, v): ([f64; 3], [f64; 3]) =
            (std::array::from_fn(|c| q[c] - p[c]), std::array::from_fn(|c| r[c] - p[c]));
        let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        assert!(normal.iter().all(|c| *c > 0.0), "{normal:?}");
    }
}
