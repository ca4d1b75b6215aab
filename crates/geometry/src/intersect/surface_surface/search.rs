//! Where two surfaces may meet: pairs of parts, until each is proved to hold no common point, or at most one curve.

use std::collections::BTreeMap;

use super::super::curve_surface::{MOST_VISITS, curve_parts};
use super::super::judge::separated;
use super::super::patch_tree::{PatchNode, PatchTree};
use super::area::{Area, Lies};
use super::overlap::{self, Overlaps};
use crate::chart::thresholds::{AT_BORDER, MET, TINY};
use crate::intersect::SurfaceIntersections;
use crate::trace::{Box4, Pair};
use crate::{Curve, Result, Vector3, cancellation};

/// A pair of parts whose common curve, if there is one, is a graph over a direction.
#[derive(Debug, Clone, Copy)]
pub(super) struct Leaf {
    nodes: [u32; 2],
    /// The parameters of both parts.
    pub(super) bounds: Box4,
    pub(super) along: Vector3,
}

/// All places where the surfaces may meet.
#[derive(Debug, Default)]
pub(super) struct Places {
    pub(super) leaves: Vec<Leaf>,
    /// The parameters of pairs of parts of which nothing could be proved.
    pub(super) undecided: Vec<Box4>,
}

/// More undecided pairs than this of small parts that grow in number, and the surfaces touch along more than points.
const MOST_UNDECIDED: usize = 8_000;
/// What is small for that, as a part of the size.
const SMALL: f64 = 1.0 / 64.0;
/// With more undecided pairs than this common areas are looked for.
const MANY_UNDECIDED: usize = 300;
/// Along a curve the number of pairs doubles in two divisions, over an area it grows fourfold.
const GROWS: f64 = 1.5;
/// More pairs than this of one size are not looked at.
const MOST_PAIRS: usize = 400_000;

/// The search over two surfaces.
pub(super) struct Search<'a> {
    pub(super) pair: Pair<'a>,
    trees: [PatchTree<'a>; 2],
    /// Parts that are smaller are not divided to prove something.
    smallest: f64,
    /// An area that is known to be common.
    area: Option<Area>,
    /// Of parts of a surface opposite to a carrier: the direction over which the common curve is proved to be a graph.
    proved: BTreeMap<u32, Option<Vector3>>,
}

impl<'a> Search<'a> {
    pub(super) fn new(pair: Pair<'a>, smallest: f64) -> Result<Self> {
        let [a, b] = pair.charts;
        Ok(Self {
            pair,
            trees: [PatchTree::over(a.nurbs(), a.nets())?, PatchTree::over(b.nurbs(), b.nets())?],
            smallest,
            area: None,
            proved: BTreeMap::new(),
        })
    }

    /// What a curve has in common with one of the surfaces.
    pub(super) fn meets(&mut self, curve: &Curve, s: usize, tolerance: f64) -> SurfaceIntersections {
        let chart = self.pair.charts[s];
        let empty = PatchTree::without_parts(chart.nurbs(), chart.nets());
        let tree = std::mem::replace(&mut self.trees[s], empty);
        let (found, tree) = curve_parts(curve, chart.nurbs(), tree, tolerance, MOST_VISITS);
        self.trees[s] = tree;
        found
    }

    /// Divides all pairs of one size together, the larger part first. Where many cannot be told, common areas are looked for,
    /// with images of their borders within the tolerance `limit`; what lies in one is not divided any more.
    ///
    /// # Errors
    /// The work was stopped, or there are too many pairs.
    pub(super) fn places(&mut self, limit: f64) -> Result<(Places, Option<Overlaps>)> {
        let mut out = Places::default();
        let mut common = None;
        let mut looked = false;
        let mut level = vec![[self.trees[0].root, self.trees[1].root]];
        let mut counts = [usize::MAX; 2];
        while !level.is_empty() {
            cancellation::room::<[u32; 2]>(level.len())?;
            if level.len() > MOST_PAIRS {
                return Err(crate::Error::Unsupported(
                    "surfaces that lie next to each other over many patches",
                ));
            }
            let mut undecided = Vec::new();
            for nodes in level.drain(..) {
                cancellation::check()?;
                if self.is_apart(nodes) {
                    continue;
                }
                match self.leaf(nodes) {
                    Some(leaf) => out.leaves.push(leaf),
                    None => undecided.push(nodes),
                }
            }
            if undecided.len() > MANY_UNDECIDED && !looked {
                looked = true;
                common = overlap::of_charts(&self.pair, limit)?;
                self.area = common.as_ref().and_then(|found| Area::new(&self.pair, found));
            }
            undecided.retain(|n| !self.is_common(*n));
            let fine = |n: &[u32; 2]| self.is_smallest(*n);
            let limit = (SMALL * self.pair.size()).powi(2);
            let small = |n: &[u32; 2]| {
                (0..2).all(|s| self.node(*n, s).patch().is_some() && self.node(*n, s).size_squared() < limit)
            };
            let grows = undecided.len() as f64 > GROWS * counts[0] as f64;
            counts = [counts[1], undecided.len()];
            let spread = undecided.len() > MOST_UNDECIDED && grows && undecided.iter().all(small);
            if spread || (!undecided.is_empty() && undecided.iter().all(fine)) {
                out.undecided.extend(undecided.iter().map(|n| self.bounds(*n)));
                break;
            }
            for nodes in undecided {
                if self.is_smallest(nodes) {
                    out.undecided.push(self.bounds(nodes));
                } else {
                    self.divide(nodes, &mut level);
                }
            }
        }
        Ok((out, common))
    }

    /// Whether what a pair of parts has in common belongs to the known area: one of them lies in it, or both are small and on
    /// its border.
    fn is_common(&self, nodes: [u32; 2]) -> bool {
        let Some(area) = &self.area else { return false };
        if (0..2).any(|s| self.node(nodes, s).patch().is_none()) {
            return false;
        }
        let lies = area.lies(&self.bounds(nodes));
        let limit = (AT_BORDER * self.pair.size()).powi(2);
        lies.contains(&Lies::Inside)
            || (lies == [Lies::Across; 2] && (0..2).all(|s| self.node(nodes, s).size_squared() < limit))
    }

    fn node(&self, nodes: [u32; 2], s: usize) -> &PatchNode {
        &self.trees[s].nodes[nodes[s] as usize]
    }

    fn bounds(&self, nodes: [u32; 2]) -> Box4 {
        let [a, b] = [0, 1].map(|s| self.node(nodes, s).ranges);
        [a[0], a[1], b[0], b[1]]
    }

    fn is_smallest(&self, nodes: [u32; 2]) -> bool {
        (0..2).all(|s| {
            let node = self.node(nodes, s);
            node.patch().is_some() && node.size_squared() < self.smallest * self.smallest
        })
    }

    /// The pairs of the halves of the larger part, of both where they are of about one size.
    pub(super) fn divide(&mut self, nodes: [u32; 2], out: &mut Vec<[u32; 2]>) {
        let sizes = [0, 1].map(|s| self.node(nodes, s).size_squared());
        let mut halves = [[nodes[0]; 2], [nodes[1]; 2]];
        let mut counts = [1, 1];
        for s in 0..2 {
            if sizes[s] * 3.0 >= sizes[1 - s]
                && let Some((left, right)) = self.trees[s].children(nodes[s])
            {
                (halves[s], counts[s]) = ([left, right], 2);
            }
        }
        if counts == [1, 1] {
            for s in 0..2 {
                if let Some((left, right)) = self.trees[s].children(nodes[s]) {
                    (halves[s], counts[s]) = ([left, right], 2);
                }
            }
        }
        if counts == [1, 1] {
            return;
        }
        for a in &halves[0][..counts[0]] {
            for b in &halves[1][..counts[1]] {
                out.push([*a, *b]);
            }
        }
    }

    /// Whether the hulls of the control points are proved to be apart.
    fn is_apart(&self, nodes: [u32; 2]) -> bool {
        let reach = MET * self.pair.noise;
        let [a, b] = [0, 1].map(|s| self.node(nodes, s));
        if (0..3).any(|k| a.min[k] > b.max[k] + reach || b.min[k] > a.max[k] + reach) {
            return true;
        }
        if a.patch().is_none() || b.patch().is_none() {
            return false;
        }
        cancellation::worked(self.trees[0].points(a).len() / 2 + 1);
        let hulls = [(0, a), (1, b)].map(|(s, node)| hull(self.trees[s].points(node)));
        if (a.is_loose() || b.is_loose()) && boxes_apart(&hulls, reach) {
            return true;
        }
        let [m, n] = [0, 1].map(|s| corner_normal(&hulls[s], self.trees[s].counts));
        let along = m.cross(n);
        [m, n, along, m.cross(along), n.cross(along)]
            .iter()
            .any(|d| separated(&hulls[0], &hulls[1], *d, reach))
    }

    /// The pair as a leaf, if its common curve is proved to be a graph, also a little beyond the parts.
    fn leaf(&mut self, nodes: [u32; 2]) -> Option<Leaf> {
        if (0..2).any(|s| self.node(nodes, s).patch().is_none()) {
            return None;
        }
        let bounds = self.bounds(nodes);
        let along = match &self.pair.carrier {
            // Which part of the carrier is opposite does not matter.
            Some((s, _)) => {
                let own = nodes[1 - s];
                match self.proved.get(&own) {
                    Some(known) => *known,
                    None => {
                        let found = self.graph_over(bounds);
                        self.proved.insert(own, found);
                        found
                    }
                }
            }
            None => self.graph_over(bounds),
        }?;
        Some(Leaf { nodes, bounds, along })
    }

    /// The direction over which the common curve of both parts is proved to be a graph, also a little beyond them.
    fn graph_over(&self, bounds: Box4) -> Option<Vector3> {
        let along = self.pair.along(bounds)?;
        self.pair.is_graph(self.wide(bounds), along).then_some(along)
    }

    /// A box of parameters with what is beside it.
    pub(super) fn wide(&self, bounds: Box4) -> Box4 {
        self.pair.grown(bounds, 0.5)
    }

    /// The parts of a leaf that may hold a common point; none when it cannot be divided.
    pub(super) fn parts(&mut self, leaf: &Leaf) -> Vec<Leaf> {
        let tiny = TINY * self.smallest;
        if (0..2).all(|s| self.node(leaf.nodes, s).size_squared() < tiny * tiny) {
            return Vec::new();
        }
        let mut pairs = Vec::new();
        self.divide(leaf.nodes, &mut pairs);
        pairs
            .into_iter()
            .filter(|nodes| !self.is_apart(*nodes))
            .map(|nodes| Leaf { nodes, bounds: self.bounds(nodes), along: leaf.along })
            .collect()
    }
}

/// Control points in space.
pub(super) fn hull(points: &[[f64; 4]]) -> Vec<Vector3> {
    points.iter().map(|p| Vector3::new(p[0] / p[3], p[1] / p[3], p[2] / p[3])).collect()
}

/// Whether the boxes of two sets of points are further apart than `reach` along an axis.
pub(super) fn boxes_apart(hulls: &[Vec<Vector3>; 2], reach: f64) -> bool {
    let range = |s: usize, axis: fn(&Vector3) -> f64| {
        hulls[s].iter().map(axis).fold([f64::INFINITY, f64::NEG_INFINITY], |r, x| [r[0].min(x), r[1].max(x)])
    };
    [|p: &Vector3| p.x, |p: &Vector3| p.y, |p: &Vector3| p.z].into_iter().any(|axis| {
        let [a, b] = [range(0, axis), range(1, axis)];
        a[0] > b[1] + reach || b[0] > a[1] + reach
    })
}

/// The normal of a part by its corners.
pub(super) fn corner_normal(points: &[Vector3], counts: [usize; 2]) -> Vector3 {
    let [n, m] = counts;
    let at = |i: usize, j: usize| points.get(i * m + j).copied().unwrap_or(Vector3::ZERO);
    (at(n - 1, m - 1) - at(0, 0)).cross(at(0, m - 1) - at(n - 1, 0)).unitized().unwrap_or(Vector3::ZERO)
}
