//! Which regions lie upon each other, and on which side of which operand every region is.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::aside;
use super::operands::Operands;
use super::pieces::{OnFace, Pieces};
use super::refusal::RefusalClass;
use super::regions::Region;
use super::sides::{Inside, Sides};
use super::thresholds::{BESIDE_BOUNDARY, ONE_PLANE};
use crate::{BoundingBox, BoxIndex, Containment, Point3, Result, cancellation};

/// A region and all others that lie upon it.
#[derive(Debug, Clone)]
pub(super) struct Sheet {
    /// The region that stands for all, that of the first operand.
    pub(super) region: usize,
    pub(super) sides: Sides,
}

/// All regions, those upon each other as one, with what is on their sides. `idle` are pieces on faces that
/// divide nothing.
///
/// # Errors
/// Sides of a region are not decided, or a piece should have divided a face.
pub(super) fn sheets(
    all: &Operands,
    pieces: &Pieces,
    regions: &[Region],
    idle: &[OnFace],
) -> Result<(Vec<Sheet>, Vec<Beside>)> {
    let groups = coincident(all, regions)?;
    let asked_again: BTreeSet<usize> =
        idle.iter().filter_map(|i| pieces.list.get(i.piece)).flat_map(|p| &p.solids).copied().collect();
    let (inside, beside) = memberships(all, pieces, regions, &groups, &asked_again)?;
    for &place in idle {
        cancellation::check()?;
        aside::refuse_dividing(all, pieces, place, |uv, solid| {
            let own = |r: usize| regions.get(r).is_some_and(|r| r.face == place.face && r.covers(uv));
            let group = groups.iter().position(|g| own(g.region) || g.twins.iter().any(|t| own(t.0)))?;
            if groups.get(group)?.holds(all, regions, solid) {
                return Some(Containment::On);
            }
            let inside = inside.get(group)?.has(solid);
            Some(if inside { Containment::Inside } else { Containment::Outside })
        })?;
    }
    let mut out = Vec::with_capacity(groups.len());
    for (group, inside) in groups.into_iter().zip(inside) {
        let mut sides = Sides { behind: inside.clone(), before: inside };
        let mut set = |solid: usize, same: bool| {
            sides.behind.set(solid, same);
            sides.before.set(solid, !same);
        };
        set(solid_of(all, regions, group.region), true);
        group.twins.iter().for_each(|(r, same)| set(solid_of(all, regions, *r), *same));
        out.push(Sheet { region: group.region, sides });
    }
    Ok((out, beside))
}

/// A region that lies on one side of an operand's boundary though it is no farther from it than the tolerance.
#[derive(Debug)]
pub(super) struct Beside {
    pub(super) face: usize,
    pub(super) place: Option<Point3>,
    /// No point of it that was asked is farther from the boundary.
    pub(super) distance: f64,
}

struct Group {
    region: usize,
    twins: Vec<(usize, bool)>,
}

impl Group {
    fn holds(&self, all: &Operands, regions: &[Region], solid: usize) -> bool {
        solid_of(all, regions, self.region) == solid
            || self.twins.iter().any(|(r, _)| solid_of(all, regions, *r) == solid)
    }
}

fn solid_of(all: &Operands, regions: &[Region], region: usize) -> usize {
    regions.get(region).and_then(|r| all.faces.get(r.face)).map_or(0, |f| f.solid)
}

/// Regions with one rim, of which a point of one lies in the other, are one.
fn coincident(all: &Operands, regions: &[Region]) -> Result<Vec<Group>> {
    let mut by_rim: HashMap<&[usize], Vec<usize>> = HashMap::new();
    let mut groups: Vec<Group> = Vec::new();
    for (place, region) in regions.iter().enumerate() {
        let mut twin = None;
        let known = by_rim.entry(&region.rim).or_default();
        for &g in known.iter() {
            let Some(group) = groups.get(g) else { continue };
            if group.holds(all, regions, solid_of(all, regions, place)) {
                continue;
            }
            if let Some(other) = regions.get(group.region)
                && let Some(same) = upon(all, region, other)?
            {
                twin = Some((g, same));
                break;
            }
        }
        match twin {
            Some((g, same)) => {
                if let Some(group) = groups.get_mut(g) {
                    group.twins.push((place, same));
                }
            }
            None => {
                known.push(groups.len());
                groups.push(Group { region: place, twins: Vec::new() });
            }
        }
    }
    Ok(groups)
}

/// Whether a region with the rim of another lies upon it, with all its points; then, whether both look the same way. Faces
/// that only cross each other may have a point in common, but not all, and not with one tangent plane.
fn upon(all: &Operands, region: &Region, other: &Region) -> Result<Option<bool>> {
    let Some(face) = all.faces.get(other.face) else { return Ok(None) };
    let mut same: Option<bool> = None;
    for sample in &region.samples {
        let uv = face.parameters(sample.point)?;
        if face.surface.point_at(uv[0], uv[1]).distance_to(sample.point) > 2.0 * all.limit
            || !other.covers(uv)
        {
            return Ok(None);
        }
        let Some(turn) = face.normal(uv).map(|n| n.dot(sample.normal)) else { return Ok(None) };
        if turn.abs() < ONE_PLANE || same.is_some_and(|s| s != (turn > 0.0)) {
            return Ok(None);
        }
        same = Some(turn > 0.0);
    }
    Ok(same)
}

/// For every group and operand whether it lies inside; what lies on the operand is set by the caller. Only faces whose
/// boxes meet that of the operand are asked. Operands that are `asked_again` stay prepared.
fn memberships(
    all: &Operands,
    pieces: &Pieces,
    regions: &[Region],
    groups: &[Group],
    asked_again: &BTreeSet<usize>,
) -> Result<(Vec<Inside>, Vec<Beside>)> {
    let mut out = vec![Inside::default(); groups.len()];
    let mut beside = Vec::new();
    let mut by_face: Vec<Vec<usize>> = vec![Vec::new(); all.faces.len()];
    for (g, group) in groups.iter().enumerate() {
        let face = regions.get(group.region).and_then(|r| by_face.get_mut(r.face));
        face.into_iter().for_each(|list| list.push(g));
    }
    let boxes: Vec<BoundingBox> = all.faces.iter().map(|f| f.bounds).collect();
    let index = BoxIndex::new(&boxes);
    let (borders, count) = borders(all, regions, groups);
    // For every piece of every operand the operand that is looked at and the first that was asked at it.
    let mut at_piece: Vec<(usize, usize)> = vec![(usize::MAX, 0); count];
    for (solid, own) in all.solids.iter().enumerate().filter(|(_, s)| s.closed) {
        let faces = index.near(&own.bounds, all.limit).into_iter();
        let near = faces.filter_map(|f| by_face.get(f)).flatten().copied();
        let asked: Vec<usize> =
            near.filter(|g| groups.get(*g).is_some_and(|group| !group.holds(all, regions, solid))).collect();
        // What hangs together across pieces that are not on the operand's boundary is on one side of it.
        let mut sets: Vec<usize> = (0..asked.len()).collect();
        for (k, g) in asked.iter().enumerate() {
            for &(piece, place) in borders.get(*g).map_or(&[] as &[_], Vec::as_slice) {
                if pieces.list.get(piece).is_some_and(|p| p.solids.contains(&solid)) {
                    continue;
                }
                let Some(first) = at_piece.get_mut(place) else { continue };
                if first.0 != solid {
                    *first = (solid, k);
                }
                let (a, b) = (root(&mut sets, k), root(&mut sets, first.1));
                sets[a.max(b)] = a.min(b);
            }
        }
        let mut known: BTreeMap<usize, bool> = BTreeMap::new();
        for (k, g) in asked.iter().enumerate() {
            cancellation::check()?;
            let set = root(&mut sets, k);
            let inside = match known.get(&set) {
                Some(inside) => *inside,
                None => {
                    let region = groups.get(*g).and_then(|g| regions.get(g.region));
                    let inside = match region {
                        Some(region) => is_inside(all, region, solid, &mut beside)?,
                        None => false,
                    };
                    known.insert(set, inside);
                    inside
                }
            };
            out.get_mut(*g).into_iter().for_each(|own| own.set(solid, inside));
        }
        if !asked_again.contains(&solid) {
            own.forget_search();
        }
    }
    Ok((out, beside))
}

/// A piece, and its place among the pieces of all operands.
type Border = (usize, usize);

/// The pieces around the region of every group, and how many pieces of operands there are: one that lies on several
/// operands counts for each.
fn borders(all: &Operands, regions: &[Region], groups: &[Group]) -> (Vec<Vec<Border>>, usize) {
    let mut places: HashMap<(usize, usize), usize> = HashMap::new();
    let mut out = Vec::with_capacity(groups.len());
    for group in groups {
        let member = solid_of(all, regions, group.region);
        let around = regions.get(group.region).into_iter().flat_map(Region::pieces);
        let own = around.map(|(piece, _)| {
            let next = places.len();
            (piece, *places.entry((member, piece)).or_insert(next))
        });
        out.push(own.collect());
    }
    (out, places.len())
}

fn root(sets: &mut [usize], mut k: usize) -> usize {
    while sets[k] != k {
        sets[k] = sets[sets[k]];
        k = sets[k];
    }
    k
}

/// Whether a region lies inside an operand on whose boundary it is not: all its points that tell agree. A region that is
/// no farther from the boundary than the tolerance, as a corner that just reaches through a face, is asked more finely.
fn is_inside(all: &Operands, region: &Region, solid: usize, beside: &mut Vec<Beside>) -> Result<bool> {
    let Some(own) = all.solids.get(solid) else { return Ok(false) };
    let place = region.samples.first().map(|s| s.point);
    let undecided = || Err(all.refuse(RefusalClass::UndecidedPoint, &[region.face], place));
    let mut asked: Option<f64> = None;
    for share in BESIDE_BOUNDARY {
        let mut verdict: Option<bool> = None;
        for sample in &region.samples {
            let found = if own.bounds.distance_to(sample.point) > all.limit {
                Ok(Containment::Outside)
            } else {
                own.search()?.contains(sample.point, share * all.limit)
            };
            let inside = match found {
                Ok(Containment::Inside) => true,
                Ok(Containment::Outside) => false,
                Ok(Containment::On) => continue,
                Err(crate::Error::Stopped) => return Err(crate::Error::Stopped),
                Err(_) => continue,
            };
            if verdict.is_some_and(|v| v != inside) {
                return undecided();
            }
            verdict = Some(inside);
        }
        if let Some(verdict) = verdict {
            beside.extend(asked.map(|distance| Beside { face: region.face, place, distance }));
            return Ok(verdict);
        }
        asked = Some(share * all.limit);
    }
    undecided()
}
