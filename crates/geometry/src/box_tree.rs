//! A tree of boxes: which of many things may come nearer than the best found.

mod visit;

pub(crate) use visit::boxes_meet;

/// The smallest and the largest coordinates.
pub(crate) type Bounds = [[f64; 3]; 2];

/// No tree is deeper: halving a list of 2³² things ends after 32 steps.
const DEEPEST: usize = 64;
/// Marks a node that holds one thing.
const LEAF: u32 = 1 << 31;

#[derive(Debug, Clone, Copy)]
struct Node {
    bounds: Bounds,
    /// The index of the right child (the left one follows its parent), or of the thing, with `LEAF` set.
    link: u32,
}

/// Things that lie one after another while a tree is built: the first one's number, how many they are, and twice the
/// middle of the box around them.
#[derive(Clone, Copy)]
struct Run {
    middle: [f64; 3],
    first: u32,
    count: u32,
}

impl Run {
    fn new(first: u32, boxes: &[Bounds]) -> Self {
        let bounds =
            boxes.iter().skip(1).fold(boxes.first().copied().unwrap_or_default(), |a, b| union(&a, b));
        Self {
            middle: std::array::from_fn(|c| bounds[0][c] + bounds[1][c]),
            first,
            count: boxes.len() as u32,
        }
    }
}

/// A binary tree over things with boxes.
#[derive(Debug, Clone, Default)]
pub(crate) struct BoxTree {
    nodes: Vec<Node>,
}

/// The bounds of points.
pub(crate) fn bounds_of(points: impl IntoIterator<Item = [f64; 3]>) -> Bounds {
    points.into_iter().fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |b, p| {
        [std::array::from_fn(|c| b[0][c].min(p[c])), std::array::from_fn(|c| b[1][c].max(p[c]))]
    })
}

fn union(a: &Bounds, b: &Bounds) -> Bounds {
    [std::array::from_fn(|c| a[0][c].min(b[0][c])), std::array::from_fn(|c| a[1][c].max(b[1][c]))]
}

/// The squared distance from a point to a box, 0 inside.
#[inline]
pub(crate) fn squared_distance_to(bounds: &Bounds, q: &[f64; 3]) -> f64 {
    let gap = |c: usize| (bounds[0][c] - q[c]).max(q[c] - bounds[1][c]).max(0.0);
    let [x, y, z] = [gap(0), gap(1), gap(2)];
    x * x + y * y + z * z
}

impl BoxTree {
    /// The tree over things that lie one after another, like the parts of a curve: each half of the list is a half of
    /// the tree.
    pub(crate) fn in_order(boxes: &[Bounds]) -> Self {
        Self::in_runs(boxes, boxes.len())
    }

    /// The tree over things that lie anywhere: halved by their middles along the longest side.
    pub(crate) fn by_place(boxes: &[Bounds]) -> Self {
        Self::in_runs(boxes, 1)
    }

    /// The tree over things of which so many at a time lie one after another, like the segments of many curves: the runs
    /// are halved by their middles along the longest side, and each run is halved as it stands.
    pub(crate) fn in_runs(boxes: &[Bounds], run: usize) -> Self {
        let mut tree = Self { nodes: Vec::with_capacity(2 * boxes.len()) };
        if !boxes.is_empty() && boxes.len() < LEAF as usize / 2 {
            let starts = (0_u32..).step_by(run.max(1));
            let mut runs: Vec<Run> =
                starts.zip(boxes.chunks(run.max(1))).map(|(first, boxes)| Run::new(first, boxes)).collect();
            tree.grow(boxes, &mut runs);
        }
        tree
    }

    /// Builds the tree over some runs and gives its bounds. The recursion is as deep as the tree.
    fn grow(&mut self, boxes: &[Bounds], runs: &mut [Run]) -> Bounds {
        if let [only] = runs {
            let first = only.first as usize;
            return self.grow_run(only.first, boxes.get(first..first + only.count as usize).unwrap_or(&[]));
        }
        let spread = bounds_of(runs.iter().map(|run| run.middle));
        let side = |c: usize| spread[1][c] - spread[0][c];
        let longest = (1..3).fold(0, |best, c| if side(c) > side(best) { c } else { best });
        let half = runs.len() / 2;
        runs.select_nth_unstable_by(half, |a, b| a.middle[longest].total_cmp(&b.middle[longest]));
        let (left, right) = runs.split_at_mut(half);
        self.join(|tree| tree.grow(boxes, left), |tree| tree.grow(boxes, right))
    }

    /// Builds the tree over things that lie one after another, of which the first has this number.
    fn grow_run(&mut self, first: u32, boxes: &[Bounds]) -> Bounds {
        if let [bounds] = boxes {
            self.nodes.push(Node { bounds: *bounds, link: LEAF | first });
            return *bounds;
        }
        let half = boxes.len() / 2;
        let (left, right) = boxes.split_at(half);
        self.join(|tree| tree.grow_run(first, left), |tree| tree.grow_run(first + half as u32, right))
    }

    /// A node over what two calls build.
    fn join(
        &mut self,
        left: impl FnOnce(&mut Self) -> Bounds,
        right: impl FnOnce(&mut Self) -> Bounds,
    ) -> Bounds {
        let here = self.nodes.len();
        self.nodes.push(Node { bounds: [[0.0; 3]; 2], link: 0 });
        let a = left(self);
        let link = self.nodes.len() as u32;
        let bounds = union(&a, &right(self));
        if let Some(node) = self.nodes.get_mut(here) {
            *node = Node { bounds, link };
        }
        bounds
    }

    /// Visits the things whose boxes are nearer to `q` than `limit`, a squared distance, nearer subtrees first. A
    /// visit gives the limit from there on.
    #[inline]
    pub(crate) fn visit_near(&self, q: &[f64; 3], mut limit: f64, mut visit: impl FnMut(usize) -> f64) {
        let Some(root) = self.nodes.first() else { return };
        let mut stack = [(0.0, 0_u32); DEEPEST];
        stack[0] = (squared_distance_to(&root.bounds, q), 0);
        let mut top = 1;
        while top > 0 {
            top -= 1;
            let (distance, mut here) = stack[top];
            if !(distance < limit) {
                continue;
            }
            // Down to the nearest thing below, with the other ways kept for later.
            while let Some(node) = self.nodes.get(here as usize) {
                if node.link & LEAF != 0 {
                    limit = visit((node.link & !LEAF) as usize);
                    break;
                }
                let (left, right) = (here + 1, node.link);
                let (Some(l), Some(r)) = (self.nodes.get(left as usize), self.nodes.get(right as usize))
                else {
                    break;
                };
                let (a, b) = (squared_distance_to(&l.bounds, q), squared_distance_to(&r.bounds, q));
                let (near, far) = if a <= b { ((a, left), (b, right)) } else { ((b, right), (a, left)) };
                if far.0 < limit && top < DEEPEST {
                    stack[top] = far;
                    top += 1;
                }
                if !(near.0 < limit) {
                    break;
                }
                here = near.1;
            }
        }
    }

    /// Visits the things in boxes that are `wanted`; what is visited may change what is wanted.
    pub(crate) fn visit_wanted<S>(
        &self,
        state: &mut S,
        wanted: impl Fn(&S, &Bounds) -> bool,
        mut visit: impl FnMut(&mut S, usize),
    ) {
        let mut stack = [0_u32; DEEPEST];
        let mut top = 1;
        while top > 0 {
            top -= 1;
            let here = stack[top];
            let Some(node) = self.nodes.get(here as usize) else { continue };
            if !wanted(state, &node.bounds) {
                continue;
            }
            if node.link & LEAF != 0 {
                visit(state, (node.link & !LEAF) as usize);
            } else if top + 2 <= DEEPEST {
                stack[top] = node.link;
                stack[top + 1] = here + 1;
                top += 2;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{BoxTree, squared_distance_to};

    #[test]
    fn finds_the_nearest_box() {
        let boxes: Vec<_> = (0..100)
            .map(f64::from)
            .map(|i| {
                let p = [i.sin() * 10.0, (1.7 * i).cos() * 10.0, (0.3 * i).sin() * 10.0];
                [p, p.map(|x| x + 0.1)]
            })
            .collect();
        for tree in [BoxTree::in_order(&boxes), BoxTree::by_place(&boxes), BoxTree::in_runs(&boxes, 7)] {
            for k in 0..50 {
                let q = [f64::from(k) - 25.0, 3.0, 1.0];
                let (mut best, mut visits) = (f64::INFINITY, 0);
                tree.visit_near(&q, best, |i| {
                    best = best.min(squared_distance_to(&boxes[i], &q));
                    visits += 1;
                    best
                });
                let want = boxes.iter().map(|b| squared_distance_to(b, &q)).fold(f64::INFINITY, f64::min);
                assert_eq!(best, want);
                assert!(visits < 60);
            }
        }
        BoxTree::default().visit_near(&[0.0; 3], 1.0, |_| 0.0);
    }
}
