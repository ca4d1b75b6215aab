//! A surface as a tree of parts with bounds: boxes over groups of Bézier patches, and below them each patch halved as
//! often as the search wants.

use std::sync::Arc;

use crate::nurbs::{MAX_DEGREE, Nets, project};
use crate::{Interval, NurbsSurface, Result, Vector3, cancellation};

/// No such index.
const NONE: u32 = u32::MAX;

/// A Bézier patch of the surface, for evaluation.
#[derive(Debug)]
pub(super) struct Patch<'a> {
    /// Its part of the surface's domain.
    pub(super) domain: [Interval; 2],
    counts: [usize; 2],
    points: &'a [[f64; 4]],
}

impl Patch<'_> {
    /// The point and the partial derivatives by the surface's own parameters.
    pub(super) fn jet(&self, uv: [f64; 2]) -> [Vector3; 3] {
        let [x, y] = [0, 1].map(|k| {
            let d = self.domain[k];
            (uv[k] - d.start) / d.length()
        });
        let (mut values, mut slopes) = ([[0.0; 4]; MAX_DEGREE + 1], [[0.0; 4]; MAX_DEGREE + 1]);
        for (i, row) in self.points.chunks_exact(self.counts[1]).enumerate().take(MAX_DEGREE + 1) {
            (values[i], slopes[i]) = line(row, y);
        }
        let (s, su) = line(&values[..self.counts[0]], x);
        let (sv, _) = line(&slopes[..self.counts[0]], x);
        let p = project(s).to_vector();
        let by = |d: [f64; 4], width: f64| (Vector3::new(d[0], d[1], d[2]) - p * d[3]) / (s[3] * width);
        [p, by(su, self.domain[0].length()), by(sv, self.domain[1].length())]
    }
}

/// Value and derivative of a Bézier curve, by de Casteljau's algorithm.
fn line(points: &[[f64; 4]], x: f64) -> ([f64; 4], [f64; 4]) {
    let mut row = [[0.0; 4]; MAX_DEGREE + 1];
    let n = points.len().min(MAX_DEGREE + 1);
    row[..n].copy_from_slice(&points[..n]);
    for level in 1..n.saturating_sub(1) {
        for i in 0..n - level {
            row[i] = std::array::from_fn(|k| (1.0 - x) * row[i][k] + x * row[i + 1][k]);
        }
    }
    let (a, b) = if n > 1 { (row[0], row[1]) } else { (row[0], row[0]) };
    let value = std::array::from_fn(|k| (1.0 - x) * a[k] + x * b[k]);
    (value, std::array::from_fn(|k| (n as f64 - 1.0) * (b[k] - a[k])))
}

/// Before so many parts are put in order somebody is asked whether to go on.
const MANY: usize = 1 << 12;

/// A part of the surface.
#[derive(Debug, Clone, Copy)]
pub(super) struct PatchNode {
    pub(super) min: [f64; 3],
    pub(super) max: [f64; 3],
    /// Its ranges of the surface's parameters.
    pub(super) ranges: [[f64; 2]; 2],
    patch: u32,
    /// Where its control points start, or [`NONE`] for a whole patch, whose box holds it but may be larger.
    points: u32,
    left: u32,
    right: u32,
}

impl PatchNode {
    pub(super) fn patch(&self) -> Option<usize> {
        (self.patch != NONE).then_some(self.patch as usize)
    }

    /// Whether the box is not that of the control points of the part.
    pub(super) fn is_loose(&self) -> bool {
        self.points == NONE
    }

    pub(super) fn size_squared(&self) -> f64 {
        (0..3).map(|k| (self.max[k] - self.min[k]).powi(2)).sum()
    }
}

/// The parts of a surface.
#[derive(Debug)]
pub(super) struct PatchTree<'a> {
    surface: &'a NurbsSurface,
    nets: Arc<Nets>,
    pub(super) nodes: Vec<PatchNode>,
    points: Vec<[f64; 4]>,
    pub(super) counts: [usize; 2],
    pub(super) root: u32,
    pub(super) scale: f64,
}

impl<'a> PatchTree<'a> {
    /// That of a surface.
    ///
    /// # Errors
    /// The work was stopped.
    pub(super) fn new(surface: &'a NurbsSurface) -> Result<Self> {
        Self::over(surface, Arc::new(Nets::new(surface)))
    }

    /// That of a surface whose patches are known.
    ///
    /// # Errors
    /// The work was stopped.
    pub(super) fn over(surface: &'a NurbsSurface, nets: Arc<Nets>) -> Result<Self> {
        let counts = surface.degrees().map(|d| d + 1);
        let many = nets.len();
        cancellation::room::<PatchNode>(2 * many)?;
        let nodes = Vec::with_capacity(2 * many);
        let mut tree = Self { surface, nets, nodes, points: Vec::new(), counts, root: 0, scale: 0.0 };
        let mut leaves = Vec::with_capacity(many);
        for i in 0..many {
            cancellation::check()?;
            let mut min = [f64::INFINITY; 3];
            let mut max = [f64::NEG_INFINITY; 3];
            tree.nets.acting(surface, i, |p| {
                for k in 0..3 {
                    (min[k], max[k]) = (min[k].min(p[k]), max[k].max(p[k]));
                }
            });
            let ranges = tree.nets.ranges(i);
            leaves.push(tree.nodes.len() as u32);
            let patch = i as u32;
            tree.nodes.push(PatchNode { min, max, ranges, patch, points: NONE, left: NONE, right: NONE });
        }
        tree.root = tree.group(&mut leaves)?;
        if let Some(n) = tree.nodes.get(tree.root as usize) {
            tree.scale = n.min.iter().chain(&n.max).fold(0.0, |m: f64, x| m.max(x.abs()));
        }
        Ok(tree)
    }

    /// One without parts, to stand where another was taken away.
    pub(super) fn without_parts(surface: &'a NurbsSurface, nets: Arc<Nets>) -> Self {
        let counts = surface.degrees().map(|d| d + 1);
        Self { surface, nets, nodes: Vec::new(), points: Vec::new(), counts, root: 0, scale: 0.0 }
    }

    /// A patch by its index, for evaluation.
    pub(super) fn patch(&self, index: usize) -> Patch<'_> {
        let domain = self.nets.ranges(index).map(|[a, b]| Interval::new(a, b));
        Patch { domain, counts: self.counts, points: self.nets.net(self.surface, index) }
    }

    /// The patches over parameters, also those beside which they lie by no more than a share of their width.
    pub(super) fn patches_over(&self, uv: [f64; 2], share: f64) -> impl Iterator<Item = usize> {
        self.nets.over(uv, share)
    }

    /// The node over the last points.
    fn push(&mut self, patch: u32, ranges: [[f64; 2]; 2]) -> u32 {
        let first = self.points.len() - self.counts[0] * self.counts[1];
        let mut min = [f64::INFINITY; 3];
        let mut max = [f64::NEG_INFINITY; 3];
        for p in &self.points[first..] {
            for k in 0..3 {
                min[k] = min[k].min(p[k] / p[3]);
                max[k] = max[k].max(p[k] / p[3]);
            }
        }
        let points = first as u32;
        self.nodes.push(PatchNode { min, max, ranges, patch, points, left: NONE, right: NONE });
        (self.nodes.len() - 1) as u32
    }

    /// A tree over patches: halved by place along the longest side of their box.
    ///
    /// # Errors
    /// The work was stopped.
    fn group(&mut self, leaves: &mut [u32]) -> Result<u32> {
        if leaves.len() < 2 {
            return Ok(leaves.first().copied().unwrap_or(0));
        }
        if leaves.len() < MANY {
            cancellation::check()?
        } else {
            cancellation::check_now()?
        }
        cancellation::worked(leaves.len() / 8);
        let mut min = [f64::INFINITY; 3];
        let mut max = [f64::NEG_INFINITY; 3];
        for &l in leaves.iter() {
            let n = &self.nodes[l as usize];
            for k in 0..3 {
                (min[k], max[k]) = (min[k].min(n.min[k]), max[k].max(n.max[k]));
            }
        }
        let axis = (0..3).max_by(|&x, &y| (max[x] - min[x]).total_cmp(&(max[y] - min[y]))).unwrap_or(0);
        let nodes = &self.nodes;
        let middle = |l: &u32| nodes[*l as usize].min[axis] + nodes[*l as usize].max[axis];
        let half = leaves.len() / 2;
        // Those at one place keep their order, so that the tree is always the same one.
        leaves.select_nth_unstable_by(half, |x, y| middle(x).total_cmp(&middle(y)).then(x.cmp(y)));
        let (l, r) = leaves.split_at_mut(half);
        let (left, right) = (self.group(l)?, self.group(r)?);
        self.nodes.push(PatchNode { min, max, ranges: [[0.0; 2]; 2], patch: NONE, points: 0, left, right });
        Ok((self.nodes.len() - 1) as u32)
    }

    /// The homogeneous control points of a part of a patch, v running fastest.
    #[inline]
    pub(super) fn points(&self, node: &PatchNode) -> &[[f64; 4]] {
        if node.is_loose() {
            return self.nets.net(self.surface, node.patch as usize);
        }
        let first = node.points as usize;
        self.points.get(first..first + self.counts[0] * self.counts[1]).unwrap_or(&[])
    }

    /// The halves of a part, across its longer side, or the two groups of a group; `None` when the numbers have no
    /// room for halves.
    pub(super) fn children(&mut self, index: u32) -> Option<(u32, u32)> {
        let node = self.nodes[index as usize];
        if node.left != NONE {
            return Some((node.left, node.right));
        }
        if node.patch == NONE || self.nodes.len() > (1 << 26) {
            return None;
        }
        let [n, m] = self.counts;
        let grid = self.points(&node).to_vec();
        let at = |i: usize, j: usize| project(grid[i * m + j]);
        let along_u: f64 =
            [0, m - 1].map(|j| (1..n).map(|i| at(i, j).distance_to(at(i - 1, j))).sum()).iter().sum();
        let along_v: f64 =
            [0, n - 1].map(|i| (1..m).map(|j| at(i, j).distance_to(at(i, j - 1))).sum()).iter().sum();
        let room = |k: usize| {
            let [a, b] = node.ranges[k];
            let c = 0.5 * a + 0.5 * b;
            a < c && c < b
        };
        let k = match (room(0), room(1)) {
            (true, false) => 0,
            (false, true) => 1,
            (true, true) => usize::from(along_v > along_u),
            _ => return None,
        };
        let (length, step, starts) =
            if k == 0 { (n, m, (0..m).collect()) } else { (m, 1, (0..n).map(|i| i * m).collect::<Vec<_>>()) };
        let (mut low, mut high) = (grid.clone(), grid);
        for start in starts {
            for level in 1..length {
                for i in 0..length - level {
                    let (a, b) = (start + i * step, start + (i + 1) * step);
                    high[a] = std::array::from_fn(|c| 0.5 * (high[a][c] + high[b][c]));
                }
                low[start + level * step] = high[start];
            }
        }
        let [a, b] = node.ranges[k];
        let middle = 0.5 * a + 0.5 * b;
        let mut ranges = [node.ranges; 2];
        (ranges[0][k], ranges[1][k]) = ([a, middle], [middle, b]);
        self.points.extend_from_slice(&low);
        let left = self.push(node.patch, ranges[0]);
        self.points.extend_from_slice(&high);
        let right = self.push(node.patch, ranges[1]);
        let node = &mut self.nodes[index as usize];
        (node.left, node.right) = (left, right);
        Some((left, right))
    }
}
