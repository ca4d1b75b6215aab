//! The border of a region walked in simple loops.

use crate::region::thresholds::CIRCLE_CROSSING;
use std::collections::HashMap;

use katydid_elementary::Elementary;

use super::nodes::Nodes;
use super::sources::Sources;
use super::strands::{Member, Strand};
use super::winding::flat;
use crate::intersect::curve_curve;
use crate::{Circle, Curve, Point3, Result};

/// A strand walked so that the region lies on the left.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step {
    pub(super) strand: usize,
    pub(super) forward: bool,
}

struct Walk<'a> {
    sources: &'a Sources,
    nodes: &'a Nodes,
    strands: &'a [Strand],
    border: &'a [Step],
}

/// A step as seen from a node.
#[derive(Debug, Clone, Copy)]
struct Spoke {
    step: usize,
    leaves: bool,
    angle: f64,
}

/// The border as loops that visit no node twice, in the order of their first strands. `None` when it does not leave
/// every node as often as it arrives there: then sides were misjudged.
///
/// At a node where more than one loop passes, the walk turns so that it goes around one sector of the inside: the
/// loops of parts that touch in a point stay apart. What then still visits a node twice is cut there.
pub(super) fn loops(
    sources: &Sources,
    nodes: &Nodes,
    strands: &[Strand],
    border: &[Step],
) -> Result<Option<Vec<Vec<Step>>>> {
    let walk = Walk { sources, nodes, strands, border };
    let mut spokes: Vec<Vec<Spoke>> = vec![Vec::new(); nodes.places.len()];
    for k in 0..border.len() {
        spokes[walk.end(k, false)].push(Spoke { step: k, leaves: true, angle: 0.0 });
        spokes[walk.end(k, true)].push(Spoke { step: k, leaves: false, angle: 0.0 });
    }
    let mut next: Vec<usize> = vec![usize::MAX; border.len()];
    for (node, mut here) in spokes.into_iter().enumerate() {
        if 2 * here.iter().filter(|s| s.leaves).count() != here.len() {
            return Ok(None);
        }
        if here.len() > 2 {
            walk.sort(node, &mut here)?;
        }
        walk.pair(&here, &mut next);
    }
    let mut used = vec![false; border.len()];
    let mut out = Vec::new();
    for first in 0..border.len() {
        let (mut round, mut k) = (Vec::new(), first);
        while !used.get(k).copied().unwrap_or(true) {
            used[k] = true;
            round.push(k);
            k = next[k];
        }
        walk.simple(&round, &mut out);
    }
    out.sort_by_key(|l| l.iter().copied().min());
    Ok(Some(out.into_iter().map(|l| l.into_iter().map(|k| border[k]).collect()).collect()))
}

impl Walk<'_> {
    /// The node where a step begins, or ends.
    fn end(&self, k: usize, last: bool) -> usize {
        let step = self.border[k];
        let strand = &self.strands[step.strand];
        if step.forward == last { strand.to } else { strand.from }
    }

    fn member(&self, k: usize) -> Option<&Member> {
        self.strands[self.border[k].strand].members.first()
    }

    /// Counter-clockwise about the node: by where each leaves a circle so large that not all of any lies inside.
    /// Nothing crosses on the way there, so that the order is right also where they leave the node side by side.
    fn sort(&self, node: usize, spokes: &mut [Spoke]) -> Result<()> {
        let center = self.nodes.places[node];
        let reach = |s: &Spoke| {
            let Some(m) = self.member(s.step) else { return 0.0 };
            let curve = &self.sources.parts[m.part].curve;
            (0..=16)
                .map(|i| curve.point_at(m.range.at(f64::from(i) / 16.0)).distance_to(center))
                .fold(0.0, f64::max)
        };
        let radius = 0.5 * spokes.iter().map(reach).fold(f64::INFINITY, f64::min);
        let Ok(circle) = Circle::new(self.sources.plane.with_origin(center), radius) else { return Ok(()) };
        let circle: Curve = circle.into();
        for s in spokes.iter_mut() {
            s.angle = self.way_out(s, center, &circle)?;
        }
        // Of a strand that is walked both ways the arrival bounds the sector clockwise of it.
        spokes.sort_by(|x, y| x.angle.total_cmp(&y.angle).then(x.leaves.cmp(&y.leaves)));
        Ok(())
    }

    /// The direction in which a step first leaves a circle about a node, going from the node.
    fn way_out(&self, spoke: &Spoke, center: Point3, circle: &Curve) -> Result<f64> {
        let Some(m) = self.member(spoke.step) else { return Ok(0.0) };
        let from_start = self.border[spoke.step].forward == spoke.leaves;
        let curve = self.sources.parts[m.part].curve.trimmed(m.range)?;
        let found = curve_curve(&curve, circle, CIRCLE_CROSSING * self.sources.scale)?;
        let places = found.crossings.iter().map(|c| c.a);
        let t = if from_start { places.reduce(f64::min) } else { places.reduce(f64::max) };
        let [x, y] =
            flat(&self.sources.plane.with_origin(center), curve.point_at(t.unwrap_or(m.range.middle())));
        Ok(y.arctangent_of(x))
    }

    /// After each arrival comes the departure next to it clockwise: the other border of the same sector.
    fn pair(&self, spokes: &[Spoke], next: &mut [usize]) {
        let n = spokes.len();
        let mut taken = vec![false; n];
        for (i, s) in spokes.iter().enumerate().filter(|(_, s)| !s.leaves) {
            let other = (1..n).map(|d| (i + n - d) % n).find(|&j| spokes[j].leaves && !taken[j]);
            if let Some(j) = other {
                taken[j] = true;
                next[s.step] = spokes[j].step;
            }
        }
    }

    /// A round cut where it comes to a node again.
    fn simple(&self, round: &[usize], out: &mut Vec<Vec<usize>>) {
        let Some(&first) = round.first() else { return };
        let mut path: Vec<usize> = Vec::new();
        let mut seen = HashMap::from([(self.end(first, false), 0)]);
        for &k in round {
            path.push(k);
            let node = self.end(k, true);
            match seen.get(&node) {
                Some(&at) => {
                    let cut: Vec<usize> = path.drain(at..).collect();
                    for &j in cut.iter().skip(1) {
                        seen.remove(&self.end(j, false));
                    }
                    out.push(cut);
                }
                None => {
                    seen.insert(node, path.len());
                }
            }
        }
    }
}
