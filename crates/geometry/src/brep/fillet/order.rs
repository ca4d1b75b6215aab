//! Which edges are rounded first where they cannot all be rounded at once.
//!
//! Where three edges meet that are not all convex (or concave) alike, the odd one out is rounded first: its rounding ends
//! in an arc on the third face, and that arc runs on without a kink into both other edges, so that a ball rolls along all
//! three. Where three convex edges have different radii the largest comes first, by the same reason: then the smaller
//! balls fit round the arc that it leaves; two of the largest are mitred, and the small ball runs on along the mitre until
//! it has no room between them any more. Edges of one radius that meet on one ball, or are mitred, go together.
//!
//! Source: the order of mixed convexities and of falling radii as in J. R. Rossignac and A. A. G. Requicha,
//! "Constant-radius blending in solid modeling", *Computers in Mechanical Engineering* 3 (1984), and in the survey of
//! Vida, Martin and Varady (1994).

use crate::brep::fillet::thresholds::EQUAL_RADII;
use std::collections::{BTreeMap, BTreeSet};

use super::FilletBlend;
use super::joint::{Fans, Link, Stub};
use super::strip::at_end;
use super::wedge::Wedge;
use crate::{Result, Tolerance};

/// Radii and lengths that differ by less than this part are equal.
pub(super) const EQUAL: f64 = 1e-9;

/// What has to be kept to, found vertex by vertex.
#[derive(Default)]
struct Rules {
    /// Edges that go in one step, each with one that stands for its group.
    groups: BTreeMap<usize, usize>,
    /// Edges that go before others, and the stubs at their vertex.
    before: Vec<(usize, usize, Vec<Stub>)>,
    /// Stubs that meet on one ball, of which one may go first if it has to.
    balls: Vec<Vec<Stub>>,
    /// Other stubs that go together.
    mates: Vec<Vec<Stub>>,
}

impl Rules {
    fn group(&self, edge: usize) -> usize {
        let mut at = edge;
        while let Some(&next) = self.groups.get(&at).filter(|next| **next != at) {
            at = next;
        }
        at
    }

    fn together(&mut self, stubs: &[Stub]) {
        let Some(first) = stubs.first() else { return };
        for stub in stubs {
            let (a, b) = (self.group(first.0), self.group(stub.0));
            self.groups.insert(a.max(b), a.min(b));
        }
    }

    /// What may go first where every group waits for another one: edges without those that they meet on a ball.
    fn one_by_one(&self, mut free: BTreeSet<usize>) -> BTreeSet<usize> {
        for (_, after, _) in &self.before {
            free.remove(after);
        }
        loop {
            let count = free.len();
            for stubs in &self.mates {
                if stubs.iter().any(|stub| !free.contains(&stub.0)) {
                    free.retain(|edge| stubs.iter().all(|stub| stub.0 != *edge));
                }
            }
            // Of two on a ball one waits with the third: not the one for which others wait.
            for stubs in &self.balls {
                let met: Vec<usize> =
                    stubs.iter().map(|stub| stub.0).filter(|edge| free.contains(edge)).collect();
                if let &[a, b] = met.as_slice() {
                    let awaited = |edge: usize| self.before.iter().any(|(first, ..)| *first == edge);
                    free.remove(if awaited(b) && !awaited(a) { &a } else { &b });
                }
            }
            if free.len() == count {
                return free;
            }
        }
    }

    fn leads(&mut self, first: &[Stub], others: &[Stub]) {
        let all = [first, others].concat();
        let pairs = first.iter().flat_map(|a| others.iter().map(move |b| (a.0, b.0)));
        self.before.extend(pairs.map(|(a, b)| (a, b, all.clone())));
    }
}

/// The edges that are rounded in the next step, of those that are to be rounded.
///
/// # Errors
/// None can be the first: each waits for another one.
pub(super) fn first(
    fans: &Fans<'_>,
    wedges: &BTreeMap<usize, Wedge<'_>>,
    blend: FilletBlend,
    tolerance: &Tolerance,
) -> Result<BTreeSet<usize>> {
    let mut at: BTreeMap<usize, Vec<Stub>> = BTreeMap::new();
    for &edge in wedges.keys() {
        for stub in [(edge, false), (edge, true)] {
            if let Some(vertex) = fans.vertex(stub) {
                at.entry(vertex).or_default().push(stub);
            }
        }
    }
    let mut rules = Rules::default();
    for stubs in at.values() {
        crate::cancellation::check()?;
        let first = leaders(fans, wedges, stubs, blend, tolerance)?;
        match first.is_empty() {
            false => {
                let others: Vec<Stub> = stubs.iter().copied().filter(|stub| !first.contains(stub)).collect();
                rules.leads(&first, &others);
                for mates in [first, others] {
                    rules.together(&mates);
                    rules.mates.push(mates);
                }
            }
            true => {
                rules.together(stubs);
                let several = stubs.windows(2).all(|pair| pair[0].0 != pair[1].0);
                let ball = blend == FilletBlend::Arc && stubs.len() == 3 && several;
                if ball { &mut rules.balls } else { &mut rules.mates }.push(stubs.clone());
            }
        }
    }
    let waiting: BTreeSet<usize> = rules.before.iter().map(|(_, after, _)| rules.group(*after)).collect();
    let mut free: BTreeSet<usize> =
        wedges.keys().copied().filter(|edge| !waiting.contains(&rules.group(*edge))).collect();
    if free.is_empty() {
        free = rules.one_by_one(wedges.keys().copied().collect());
    }
    match rules.before.first() {
        Some((_, _, stubs)) if free.is_empty() => Err(fans.unsupported(stubs)),
        _ => Ok(free),
    }
}

/// The stubs at a vertex that go before the others, which then go together; none if all go together.
fn leaders(
    fans: &Fans<'_>,
    wedges: &BTreeMap<usize, Wedge<'_>>,
    stubs: &[Stub],
    blend: FilletBlend,
    tolerance: &Tolerance,
) -> Result<Vec<Stub>> {
    let all: Vec<&Wedge<'_>> = stubs.iter().filter_map(|stub| wedges.get(&stub.0)).collect();
    let several = stubs.windows(2).all(|pair| pair[0].0 != pair[1].0);
    let vertex = stubs.first().and_then(|stub| fans.vertex(*stub));
    let edges = vertex.map_or(0, |vertex| fans.count(vertex));
    if edges != 3 || !several {
        return Ok(Vec::new());
    }
    match (stubs, all.as_slice()) {
        (&[a, b], &[p, q]) => {
            if fans.runs_through([a, b], tolerance.angle) {
                return Ok(Vec::new());
            }
            if p.is_convex(fans.brep) != q.is_convex(fans.brep) {
                return Ok(Vec::new());
            }
            let reaches = [foot(fans, p, a, b)?, foot(fans, q, b, a)?];
            Ok(match reaches {
                [Some(s), Some(t)] if (s - t).abs() <= EQUAL_RADII * s.max(t) => Vec::new(),
                [Some(s), Some(t)] => vec![if s > t { a } else { b }],
                _ => Vec::new(),
            })
        }
        (&[_, _, _], [p, q, r]) if blend != FilletBlend::Chamfer => {
            let convex = [p, q, r].map(|wedge| wedge.is_convex(fans.brep));
            let count = convex.iter().filter(|c| **c).count();
            if count == 1 || count == 2 {
                let odd = convex.iter().position(|c| *c == (count == 1));
                return Ok(odd.map(|odd| stubs[odd]).into_iter().collect());
            }
            let mut radii = Vec::with_capacity(3);
            for (stub, wedge) in stubs.iter().zip([p, q, r]) {
                radii.push((wedge.first()?.radius, *stub));
            }
            radii.sort_by(|a, b| b.0.total_cmp(&a.0));
            let falls = |k: usize| radii[k].0 - radii[k + 1].0 > EQUAL * radii[k].0;
            let first = match (falls(0), falls(1)) {
                (true, _) => 1,
                // Two large ones are mitred, and the small ball runs up between them.
                (false, true) if blend == FilletBlend::Arc => 2,
                _ => 0,
            };
            Ok(radii[..first].iter().map(|(_, stub)| *stub).collect())
        }
        _ => Ok(Vec::new()),
    }
}

/// How far from the vertex the rounding of a stub ends on the third edge, by the tangents at the vertex.
fn foot(fans: &Fans<'_>, wedge: &Wedge<'_>, stub: Stub, other: Stub) -> Result<Option<f64>> {
    let over = (0..2).find_map(|side| match fans.link(stub, side, other) {
        Some(Link::Over(over, _)) => Some((side, over)),
        _ => None,
    });
    let Some((side, over)) = over else { return Ok(None) };
    let domain = wedge.curve.domain();
    let end = if stub.1 { domain.end } else { domain.start };
    let station = at_end(wedge, stub.1).ok_or_else(|| wedge.too_large())?;
    let turn = fans.way(stub).zip(fans.way(over)).map_or(0.0, |(a, b)| a.cross(b).length());
    Ok((turn > 0.0).then(|| station.contacts[side].distance_to(wedge.curve.point_at(end)) / turn))
}
