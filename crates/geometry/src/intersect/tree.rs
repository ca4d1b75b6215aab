//! A curve as a tree of parts with bounds: boxes over runs of pieces, and below them each piece halved as often as the
//! search wants. Every halving is done once, whatever meets the part.

use std::f64::consts::FRAC_PI_2;

use katydid_elementary::Elementary;

use super::thresholds::TOGETHER;
use crate::curve::{Piece, Shape};
use crate::nurbs::{MAX_DEGREE, project};
use crate::{Arc, Interval, Vector3};

/// No such index.
const NONE: u32 = u32::MAX;

/// A part of a curve.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    /// The box that holds it.
    pub(super) min: [f64; 3],
    pub(super) max: [f64; 3],
    /// Its range in the piece's own parameter.
    pub(super) from: f64,
    pub(super) to: f64,
    /// The piece it is a part of, or [`NONE`] for a run of pieces.
    piece: u32,
    /// Where its control points start, and how many there are.
    points: u32,
    count: u32,
    /// Where its homogeneous control points start, if it has weights.
    weighted: u32,
    left: u32,
    right: u32,
}

impl Node {
    /// The index of the piece, `None` for a run of several.
    pub(super) fn piece(&self) -> Option<usize> {
        (self.piece != NONE).then_some(self.piece as usize)
    }

    /// How many pairs of control points there are: what comparing two parts costs.
    pub(super) fn pairs_of_points(&self, other: &Self) -> u32 {
        self.count * other.count
    }

    /// The diagonal of the box, squared.
    pub(super) fn size_squared(&self) -> f64 {
        (0..3).map(|k| (self.max[k] - self.min[k]).powi(2)).sum()
    }

    /// Whether the boxes are further apart than `reach` along an axis.
    #[inline]
    pub(super) fn apart(&self, other: &Self, reach: f64) -> bool {
        (0..3).any(|k| self.min[k] - other.max[k] > reach || other.min[k] - self.max[k] > reach)
    }
}

/// The parts of a curve.
#[derive(Debug)]
pub(super) struct Tree<'a> {
    pub(super) pieces: Vec<Piece<'a>>,
    pub(super) nodes: Vec<Node>,
    points: Vec<Vector3>,
    weighted: Vec<[f64; 4]>,
    pub(super) root: u32,
    /// The largest coordinate, for the noise of rounding.
    pub(super) scale: f64,
}

impl<'a> Tree<'a> {
    pub(super) fn new(pieces: Vec<Piece<'a>>) -> Self {
        let room = 4 * pieces.len() + 64;
        let mut tree = Self {
            pieces,
            nodes: Vec::with_capacity(room),
            points: Vec::with_capacity(4 * room),
            weighted: Vec::new(),
            root: 0,
            scale: 0.0,
        };
        let mut level = Vec::with_capacity(tree.pieces.len());
        let mut points = Vec::new();
        for i in 0..tree.pieces.len() {
            let piece = tree.pieces[i];
            match piece.shape {
                Shape::Segment(a, b) => {
                    tree.points.extend([a.to_vector(), b.to_vector()]);
                    level.push(tree.push(i as u32, 0.0, 1.0, 2, NONE));
                }
                Shape::Arc(arc) => {
                    // A little less than a quarter each, so that the control triangle stays tame.
                    let parts = ((piece.own.length().abs() / FRAC_PI_2).ceil() as u32).clamp(1, 1024);
                    for k in 0..parts {
                        let at = |k: u32| piece.own.at(f64::from(k) / f64::from(parts));
                        tree.points.extend(arc_hull(arc, at(k), at(k + 1)));
                        level.push(tree.push(i as u32, at(k), at(k + 1), 3, NONE));
                    }
                }
                Shape::Span(curve, j) => {
                    points.clear();
                    curve.push_bezier(j, &mut points);
                    let knots = curve.knots().get(j + curve.degree() - 1..=j + curve.degree());
                    if let Some(&[from, to]) = knots {
                        cut(&mut points, piece.own, Interval::new(from, to));
                    }
                    let weighted = if curve.is_rational() {
                        tree.weighted.extend_from_slice(&points);
                        (tree.weighted.len() - points.len()) as u32
                    } else {
                        NONE
                    };
                    tree.points.extend(points.iter().map(|&p| project(p).to_vector()));
                    let count = points.len() as u32;
                    level.push(tree.push(i as u32, piece.own.start, piece.own.end, count, weighted));
                }
            }
        }
        while level.len() > 1 {
            level = level.chunks(2).map(|pair| tree.join(pair)).collect();
        }
        tree.root = level.first().copied().unwrap_or(0);
        let whole = tree.nodes.get(tree.root as usize);
        tree.scale = whole.map_or(0.0, |n| n.min.iter().chain(&n.max).fold(0.0, |m: f64, x| m.max(x.abs())));
        tree
    }

    /// The node over the last `count` points.
    fn push(&mut self, piece: u32, from: f64, to: f64, count: u32, weighted: u32) -> u32 {
        let first = self.points.len() - count as usize;
        let mut min = [f64::INFINITY; 3];
        let mut max = [f64::NEG_INFINITY; 3];
        for p in &self.points[first..] {
            let p = [p.x, p.y, p.z];
            for k in 0..3 {
                min[k] = min[k].min(p[k]);
                max[k] = max[k].max(p[k]);
            }
        }
        let points = first as u32;
        self.nodes.push(Node { min, max, from, to, piece, points, count, weighted, left: NONE, right: NONE });
        (self.nodes.len() - 1) as u32
    }

    fn join(&mut self, pair: &[u32]) -> u32 {
        let &[left, right] = pair else { return pair.first().copied().unwrap_or(0) };
        let (l, r) = (self.nodes[left as usize], self.nodes[right as usize]);
        let min = std::array::from_fn(|k| l.min[k].min(r.min[k]));
        let max = std::array::from_fn(|k| l.max[k].max(r.max[k]));
        let (from, to) = (0.0, 0.0);
        let node = Node { min, max, from, to, piece: NONE, points: 0, count: 0, weighted: NONE, left, right };
        self.nodes.push(node);
        (self.nodes.len() - 1) as u32
    }

    /// The control points of a part of a piece: their hull holds it.
    #[inline]
    pub(super) fn hull(&self, node: &Node) -> &[Vector3] {
        self.points.get(node.points as usize..(node.points + node.count) as usize).unwrap_or(&[])
    }

    /// The two halves of a part, or the parts of a run; `None` when the numbers have no room for halves.
    pub(super) fn children(&mut self, index: u32) -> Option<(u32, u32)> {
        let node = self.nodes[index as usize];
        if node.left != NONE {
            return Some((node.left, node.right));
        }
        let middle = 0.5 * node.from + 0.5 * node.to;
        let between = node.from.min(node.to) < middle && middle < node.from.max(node.to);
        if node.piece == NONE || !between || self.nodes.len() > (1 << 28) {
            return None;
        }
        let count = node.count as usize;
        let first = node.points as usize;
        let mut weighted = [NONE, NONE];
        let halves = match self.pieces[node.piece as usize].shape {
            Shape::Arc(arc) => {
                let l = arc_hull(arc, node.from, middle);
                let r = arc_hull(arc, middle, node.to);
                [l, r].concat()
            }
            _ if node.weighted != NONE => {
                let at = node.weighted as usize;
                let mut row = [[0.0; 4]; MAX_DEGREE + 1];
                row[..count].copy_from_slice(&self.weighted[at..at + count]);
                weighted = [self.weighted.len() as u32, (self.weighted.len() + count) as u32];
                halve(&mut row[..count], &mut self.weighted, |p, q| {
                    std::array::from_fn(|k| 0.5 * (p[k] + q[k]))
                });
                let new = self.weighted[weighted[0] as usize..].iter();
                new.map(|&p| project(p).to_vector()).collect()
            }
            _ => {
                // The common case, straight into the store.
                let mut row = [Vector3::ZERO; MAX_DEGREE + 1];
                row[..count].copy_from_slice(&self.points[first..first + count]);
                halve(&mut row[..count], &mut self.points, |p, q| (p + q) * 0.5);
                Vec::new()
            }
        };
        if halves.is_empty() {
            // `push` looks at the last points: set the right half aside for a moment.
            let right: [Vector3; MAX_DEGREE + 1] = {
                let mut right = [Vector3::ZERO; MAX_DEGREE + 1];
                let start = self.points.len() - count;
                right[..count].copy_from_slice(&self.points[start..]);
                self.points.truncate(start);
                right
            };
            let l = self.push(node.piece, node.from, middle, node.count, NONE);
            self.points.extend_from_slice(&right[..count]);
            let r = self.push(node.piece, middle, node.to, node.count, NONE);
            return Some(self.adopt(index, l, r));
        }
        let (left, right) = halves.split_at(count);
        self.points.extend_from_slice(left);
        let l = self.push(node.piece, node.from, middle, node.count, weighted[0]);
        self.points.extend_from_slice(right);
        let r = self.push(node.piece, middle, node.to, node.count, weighted[1]);
        Some(self.adopt(index, l, r))
    }

    fn adopt(&mut self, index: u32, left: u32, right: u32) -> (u32, u32) {
        let node = &mut self.nodes[index as usize];
        (node.left, node.right) = (left, right);
        (left, right)
    }
}

/// The control points of the part of a Bézier curve over `all` that lies over `part`: one end or the other is cut off
/// by de Casteljau's algorithm. Cuts are made where the curve stands still; there two control points fall together.
fn cut(points: &mut [[f64; 4]], part: Interval, all: Interval) {
    if part.start != all.start {
        let x = all.normalized(part.start);
        for level in 1..points.len() {
            for i in 0..points.len() - level {
                points[i] = std::array::from_fn(|c| (1.0 - x) * points[i][c] + x * points[i + 1][c]);
            }
        }
    }
    if part.end != all.end {
        let x = Interval::new(part.start, all.end).normalized(part.end);
        for level in 1..points.len() {
            for i in (level..points.len()).rev() {
                points[i] = std::array::from_fn(|c| (1.0 - x) * points[i - 1][c] + x * points[i][c]);
            }
        }
    }
    let last = points.len().saturating_sub(1);
    let size = points.windows(2).map(|w| project(w[0]).distance_to(project(w[1]))).fold(0.0, f64::max);
    let mut snap = |end: usize, next: usize| {
        let Some(&p) = points.get(end) else { return };
        let Some(q) = points.get_mut(next) else { return };
        // What rounding left of the difference leads anywhere.
        if project(p).distance_to(project(*q)) <= TOGETHER * size {
            let share = q[3] / p[3];
            *q = p.map(|x| x * share);
        }
    };
    if part.start != all.start {
        snap(0, 1);
    }
    if part.end != all.end && last > 0 {
        snap(last, last - 1);
    }
}

/// De Casteljau's algorithm at 1/2: the points of the left half, then those of the right, go to `out`.
#[inline]
fn halve<T: Copy>(row: &mut [T], out: &mut Vec<T>, mean: impl Fn(T, T) -> T) {
    let n = row.len();
    for level in 0..n {
        out.push(row[0]);
        for i in 0..n - 1 - level {
            row[i] = mean(row[i], row[i + 1]);
        }
    }
    out.extend_from_slice(row);
}

/// The control triangle of the arc between two angles less than a half turn apart.
fn arc_hull(arc: &Arc, from: f64, to: f64) -> [Vector3; 3] {
    let half = 0.5 * (to - from);
    let middle = arc.circle.at(from + half) - arc.circle.center();
    let corner = arc.circle.center() + middle / half.cosine();
    [arc.circle.at(from), corner, arc.circle.at(to)].map(|p| p.to_vector())
}
