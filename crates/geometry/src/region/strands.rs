//! The stretches between nodes, those that coincide as one.

use crate::region::thresholds::INSIDE;
use std::collections::HashMap;

use super::nodes::{Nodes, WITHIN, excursion};
use super::sources::Sources;
use crate::{Interval, Point3, Result, Vector3};

/// A stretch of a part between two nodes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Member {
    pub(super) part: usize,
    pub(super) range: Interval,
    /// Whether it runs as the strand does.
    pub(super) along: bool,
}

/// All stretches that run together from one node to another. The first one gives the direction.
#[derive(Debug)]
pub(super) struct Strand {
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) members: Vec<Member>,
}

/// Places on a stretch where it is compared with another.
const PLACES: [f64; 5] = [0.5, 0.25, 0.75, 0.1, 0.9];

/// The strands, in the order of their first members.
pub(super) fn strands(sources: &Sources, nodes: &Nodes, tolerance: f64) -> Result<Vec<Strand>> {
    let mut out: Vec<Strand> = Vec::new();
    let mut by_ends: HashMap<(usize, usize), Vec<usize>> = HashMap::new();
    for (part, stops) in nodes.stops.iter().enumerate() {
        for w in stops.windows(2) {
            let (from, to) = (w[0].1, w[1].1);
            let range = Interval::new(w[0].0, w[1].0);
            // A curl that does not leave its node.
            if from == to && excursion(&sources.parts[part].curve, range) <= WITHIN * tolerance {
                continue;
            }
            let mut new = Member { part, range, along: true };
            let same_ends = by_ends.entry((from.min(to), from.max(to))).or_default();
            let mut home = None;
            for &k in same_ends.iter() {
                let first = out[k].members[0];
                if coincide(sources, &new, &first, tolerance)? && coincide(sources, &first, &new, tolerance)?
                {
                    new.along =
                        if from == to { runs_with(sources, &new, &first)? } else { from == out[k].from };
                    home = Some(k);
                    break;
                }
            }
            match home {
                Some(k) => out[k].members.push(new),
                None => {
                    same_ends.push(out.len());
                    out.push(Strand { from, to, members: vec![new] });
                }
            }
        }
    }
    Ok(out)
}

/// Whether one stretch stays within the tolerance of another.
fn coincide(sources: &Sources, one: &Member, other: &Member, tolerance: f64) -> Result<bool> {
    let (a, b) = (&sources.parts[one.part], &sources.parts[other.part].curve);
    let reach = 1.01 * tolerance;
    let near = sources.parts[other.part].bounds.inflated(reach);
    let epsilon = INSIDE * other.range.length();
    for x in PLACES {
        let p = a.curve.point_at(one.range.at(x));
        if !near.contains(p) {
            return Ok(false);
        }
        let Some(foot) = b.closest_point_within(p, reach)? else { return Ok(false) };
        let t = foot.parameter;
        // Beyond the ends only what lies in the nodes.
        if t < other.range.start - epsilon || t > other.range.end + epsilon {
            let ends = [other.range.start, other.range.end].map(|t| b.point_at(t));
            if ends.iter().all(|e| e.distance_to(p) > 4.0 * tolerance) {
                return Ok(false);
            }
        }
    }
    Ok(true)
}

fn runs_with(sources: &Sources, one: &Member, other: &Member) -> Result<bool> {
    let (p, u) = place(sources, one, 0.5);
    let foot = sources.parts[other.part].curve.closest_point(p)?;
    let v = sources.parts[other.part].curve.tangent_at(foot.parameter);
    Ok(u.dot(v.unwrap_or(u)) >= 0.0)
}

/// The point at a normalised place of a stretch and the direction there, as its part runs.
pub(super) fn place(sources: &Sources, member: &Member, x: f64) -> (Point3, Vector3) {
    let curve = &sources.parts[member.part].curve;
    let t = member.range.at(x);
    (curve.point_at(t), curve.tangent_at(t).unwrap_or(Vector3::ZERO))
}
