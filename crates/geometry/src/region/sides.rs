//! What lies on both sides of a strand.

use super::sources::Sources;
use super::strands::{Member, Strand, place};
use super::winding::{Outline, OutlineIndex, flat};
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

/// The winding numbers beside all strands. Strands that follow each other at a node where nothing else goes on lie
/// between the same two faces: the longest of them is asked.
pub(super) fn all_sides(
    sources: &Sources,
    strands: &[Strand],
    places: usize,
    tolerance: f64,
) -> Result<Vec<Vec<Sides>>> {
    let mut ends: Vec<Vec<(usize, bool)>> = vec![Vec::new(); places];
    for (k, s) in strands.iter().enumerate() {
        ends[s.from].push((k, false));
        ends[s.to].push((k, true));
    }
    let index = OutlineIndex::new(sources.list.iter().map(|source| source.outline.as_ref()));
    let mut out: Vec<Option<Vec<Sides>>> = vec![None; strands.len()];
    let mut seen = vec![false; strands.len()];
    for first in 0..strands.len() {
        if seen[first] {
            continue;
        }
        seen[first] = true;
        // Each with whether it runs against the first.
        let mut chain = vec![(first, false)];
        let mut next = 0;
        while let Some(&(k, against)) = chain.get(next) {
            next += 1;
            for (node, last) in [(strands[k].from, false), (strands[k].to, true)] {
                let &[x, y] = &ends[node][..] else { continue };
                let (other, other_last) = if x == (k, last) { y } else { x };
                if !seen[other] {
                    seen[other] = true;
                    chain.push((other, against != (last == other_last)));
                }
            }
        }
        let longest = chain.iter().copied().max_by(|x, y| {
            let length = |k: usize| strands[k].members.first().map_or(0.0, |m| length(sources, m));
            length(x.0).total_cmp(&length(y.0))
        });
        let Some((longest, turned)) = longest else { continue };
        let found = sides(sources, &index, &strands[longest], tolerance)?;
        for (k, against) in chain {
            let own = found.iter().map(|s| match against == turned {
                true => *s,
                false => Sides { left: s.right, right: s.left, ..*s },
            });
            out[k] = Some(own.collect());
        }
    }
    Ok(out.into_iter().map(Option::unwrap_or_default).collect())
}

/// About the length of a stretch.
fn length(sources: &Sources, member: &Member) -> f64 {
    let curve = &sources.parts[member.part].curve;
    let at = |k: i32| curve.point_at(member.range.at(f64::from(k) / 4.0));
    (0..4).map(|k| at(k).distance_to(at(k + 1))).sum()
}

/// The winding numbers of all sources that have one at the strand.
fn sides(sources: &Sources, index: &OutlineIndex, strand: &Strand, tolerance: f64) -> Result<Vec<Sides>> {
    crate::cancellation::check()?;
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
    // Its own, and those whose boxes it comes into.
    let mut near = index.reaching(&spots);
    near.extend(own.iter().map(|o| o.0));
    near.sort_unstable();
    near.dedup();
    let mut out = Vec::new();
    for k in near {
        let source = &sources.list[k];
        let Some(outline) = &source.outline else { continue };
        if let Some(&(_, step)) = own.iter().find(|o| o.0 == k) {
            let left = beside(sources, strand, k, outline, tolerance);
            out.push(Sides { source: k, left, right: left - step });
            continue;
        }
        let votes = spots.map(|p| outline.winding(p));
        let mut count = votes[0];
        if votes.iter().any(|&v| v != count) {
            // The curve comes as near as the tolerance somewhere: what is farthest from it knows best.
            let mut far = -1.0;
            for x in MORE {
                let p = place(sources, first, x).0;
                let distance = source.curve.closest_point(p)?.distance;
                if distance > far {
                    far = distance;
                    count = outline.winding(flat(&sources.plane, p));
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
fn beside(sources: &Sources, strand: &Strand, source: usize, outline: &Outline, tolerance: f64) -> i32 {
    let mut members = strand.members.iter().filter(|m| sources.parts[m.part].source == source);
    let (Some(member), alone) = (members.next(), members.next().is_none()) else { return 0 };
    // Beside a single stretch very near, beside several farther than they are apart.
    let step = if alone { 0.05 * tolerance } else { 2.0 * tolerance };
    let count = |x: f64| {
        let (p, along) = place(sources, member, x);
        let along = if member.along { along } else { -along };
        let left: Vector3 = sources.plane.z_axis.cross(along);
        outline.winding(flat(&sources.plane, p + left * step))
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
