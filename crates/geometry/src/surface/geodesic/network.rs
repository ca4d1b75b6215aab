//! The shortest way through a grid of places.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::Unrolled;
use crate::Point3;

/// Places along a direction.
const SIDE: usize = 48;
/// The ways from a place: as a knight and a king move.
const MOVES: [[i64; 2]; 16] = [
    [1, 0],
    [0, 1],
    [-1, 0],
    [0, -1],
    [1, 1],
    [-1, 1],
    [1, -1],
    [-1, -1],
    [1, 2],
    [2, 1],
    [-1, 2],
    [-2, 1],
    [1, -2],
    [2, -1],
    [-1, -2],
    [-2, -1],
];

#[derive(Debug, Clone, Copy, PartialEq)]
struct Reached {
    length: f64,
    node: usize,
}

impl Eq for Reached {}

impl PartialOrd for Reached {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Reached {
    fn cmp(&self, other: &Self) -> Ordering {
        other.length.total_cmp(&self.length).then(other.node.cmp(&self.node))
    }
}

struct Grid<'a> {
    sheet: &'a Unrolled<'a>,
    /// The number of different places along each direction.
    counts: [usize; 2],
    points: Vec<Point3>,
    /// Where the way begins and ends, in steps of the grid.
    ends: [[f64; 2]; 2],
    end_points: [Point3; 2],
}

impl Grid<'_> {
    /// A place of the grid in steps, for nodes and for the two ends behind them.
    fn at(&self, node: usize) -> [f64; 2] {
        match node.checked_sub(self.points.len()) {
            Some(end) => self.ends[end.min(1)],
            None => [(node / self.counts[1]) as f64, (node % self.counts[1]) as f64],
        }
    }

    fn point(&self, node: usize) -> Point3 {
        match node.checked_sub(self.points.len()) {
            Some(end) => self.end_points[end.min(1)],
            None => self.points[node],
        }
    }

    /// The node at a step of the grid, over seams.
    fn node(&self, step: [i64; 2]) -> Option<usize> {
        let mut index = [0; 2];
        for d in 0..2 {
            let n = self.counts[d] as i64;
            let i = if self.sheet.closed[d] { step[d].rem_euclid(n) } else { step[d] };
            if !(0..n).contains(&i) {
                return None;
            }
            index[d] = i as usize;
        }
        Some(index[0] * self.counts[1] + index[1])
    }

    /// The differences of two places, the short way over seams.
    fn difference(&self, a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|d| {
            let x = b[d] - a[d];
            if self.sheet.closed[d] {
                let n = self.counts[d] as f64;
                x - n * (x / n).round()
            } else {
                x
            }
        })
    }

    /// Visits the nodes that can be reached in one move.
    fn neighbours(&self, node: usize, mut visit: impl FnMut(usize)) {
        let here = self.at(node);
        let grid = self.points.len();
        if node >= grid {
            let base = here.map(|x| x.floor() as i64);
            for i in -1..=2 {
                for j in -1..=2 {
                    if let Some(next) = self.node([base[0] + i, base[1] + j]) {
                        visit(next);
                    }
                }
            }
            let other = if node == grid { grid + 1 } else { grid };
            if self.difference(here, self.at(other)).iter().all(|x| x.abs() <= 2.0) {
                visit(other);
            }
            return;
        }
        let base = here.map(|x| x as i64);
        for [i, j] in MOVES {
            if let Some(next) = self.node([base[0] + i, base[1] + j]) {
                visit(next);
            }
        }
        for end in [0, 1] {
            let x = self.difference(here, self.ends[end]);
            if x.iter().all(|x| x.abs() <= 2.0) {
                visit(grid + end);
            }
        }
    }
}

/// The shortest way through the grid, by parameters that go on over seams.
pub(super) fn way(sheet: &Unrolled<'_>, from: [f64; 2], to: [f64; 2]) -> Vec<[f64; 2]> {
    // The last place of a closed direction is the first again.
    let counts = sheet.closed.map(|closed| if closed { SIDE } else { SIDE + 1 });
    let parameter = |d: usize, x: f64| sheet.domains[d].start + sheet.domains[d].length() * x / SIDE as f64;
    let points = (0..counts[0] * counts[1])
        .map(|k| sheet.point([parameter(0, (k / counts[1]) as f64), parameter(1, (k % counts[1]) as f64)]))
        .collect();
    let steps = |uv: [f64; 2]| {
        std::array::from_fn(|d| (uv[d] - sheet.domains[d].start) / sheet.domains[d].length() * SIDE as f64)
    };
    let grid = Grid {
        sheet,
        counts,
        points,
        ends: [steps(from), steps(to)],
        end_points: [sheet.point(from), sheet.point(to)],
    };
    let (start, goal) = (grid.points.len(), grid.points.len() + 1);
    let mut lengths = vec![f64::INFINITY; goal + 1];
    let mut before = vec![usize::MAX; goal + 1];
    lengths[start] = 0.0;
    let mut heap = BinaryHeap::from([Reached { length: 0.0, node: start }]);
    while let Some(Reached { length, node }) = heap.pop() {
        if node == goal {
            break;
        }
        if length > lengths[node] {
            continue;
        }
        let here = grid.point(node);
        grid.neighbours(node, |next| {
            let there = length + here.distance_to(grid.point(next));
            if there < lengths[next] {
                lengths[next] = there;
                before[next] = node;
                heap.push(Reached { length: there, node: next });
            }
        });
    }
    let mut nodes = vec![goal];
    while let Some(&last) = nodes.last()
        && before[last] != usize::MAX
    {
        nodes.push(before[last]);
    }
    nodes.reverse();
    let mut out = vec![from];
    let mut here = grid.ends[0];
    for w in nodes.windows(2) {
        let step = grid.difference(grid.at(w[0]), grid.at(w[1]));
        here = [here[0] + step[0], here[1] + step[1]];
        out.push([parameter(0, here[0]), parameter(1, here[1])]);
    }
    if out.len() < 2 {
        out.push(to);
    }
    out
}
