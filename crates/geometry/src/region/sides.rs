//! What lies on both sides of a strand.

use super::sources::Sources;
use super::strands::{Strand, place};
use super::winding::flat;
use crate::{Result, Vector3};

/// The winding numbers of a source left and right of a strand.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sides {
    pub(super) source: usize,
    pub(super) left: i32,
    pub(super) right: i32,
}

/// Places on a strand where winding numbers are counted; more of them when the first ones do not agree.
const FIRST: [f64; 3] = [0.5, 0.21, 0.77];
const MORE: [f64; 7] = [0.5, 0.21, 0.77, 0.08, 0.35, 0.63, 0.92];

/// The winding numbers of all sources that have one at the strand.
pub(super) fn sides(sources: &Sources, strand: &Strand, tolerance: f64) -> Result<Vec<Sides>> {
    let Some(first) = strand.members.first() else { return Ok(Vec::new()) };
    let at = |x: f64| flat(&sources.plane, place(sources, first, x).0);
    let mut own: Vec<(usize, i32)> = Vec::new();
    for m in &strand.members {
        let (source, sign) = (sources.parts[m.part].source, if m.along { 1 } else { -1 });
        match own.iter_mut().find(|o| o.0 == source) {
            Some(known) => known.1 += sign,
            None => own.push((source, sign)),
        }
    }
    let spots = FIRST.map(at);
    let mut out = Vec::new();
    for (k, source) in sources.list.iter().enumerate() {
        if let Some(&(_, step)) = own.iter().find(|o| o.0 == k) {
            let left = beside(sources, strand, k, tolerance);
            out.push(Sides { source: k, left, right: left - step });
            continue;
        }
        if !spots.iter().any(|&p| source.outline.reaches(p)) {
            continue;
        }
        let votes = spots.map(|p| source.outline.winding(p));
        let mut count = votes[0];
        if votes.iter().any(|&v| v != count) {
            // The curve comes as near as the tolerance somewhere: what is farthest from it knows best.
            let mut far = -1.0;
            for x in MORE {
                let p = place(sources, first, x).0;
                let distance = source.curve.closest_point(p)?.distance;
                if distance > far {
                    far = distance;
                    count = source.outline.winding(flat(&sources.plane, p));
                }
            }
        }
        if count != 0 {
            out.push(Sides { source: k, left: count, right: count });
        }
    }
    Ok(out)
}

/// The winding number of a source just left of a strand that is part of it.
fn beside(sources: &Sources, strand: &Strand, source: usize, tolerance: f64) -> i32 {
    let mut members = strand.members.iter().filter(|m| sources.parts[m.part].source == source);
    let (Some(member), alone) = (members.next(), members.next().is_none()) else { return 0 };
    // Beside a single stretch very near, beside several farther than they are apart.
    let step = if alone { 0.05 * tolerance } else { 2.0 * tolerance };
    let count = |x: f64| {
        let (p, along) = place(sources, member, x);
        let along = if member.along { along } else { -along };
        let left: Vector3 = sources.plane.z_axis.cross(along);
        sources.list[source].outline.winding(flat(&sources.plane, p + left * step))
    };
    let votes = FIRST.map(count);
    if votes.iter().all(|&v| v == votes[0]) {
        return votes[0];
    }
    let mut votes = MORE.map(count);
    votes.sort_unstable();
    // The most frequent one.
    let times = |v: i32| votes.iter().filter(|&&w| w == v).count();
    votes.iter().copied().max_by_key(|&v| times(v)).unwrap_or(0)
}
