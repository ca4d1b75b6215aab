//! Arcs about corners made chamfers and blends.

use super::corner::Corner;
use super::trim::{Work, near_pairs};
use super::{OffsetCorner, Raw};
use crate::box_tree::{Bounds, BoxTree};
use crate::curve::blend::blend_between;
use crate::curve::chained;
use crate::intersect::{ContactKind, curve_curve, curve_self};
use crate::{BoundingBox, ClosestOnCurve, Curve, Line, Point3, Result};

/// Parts of a chamfer or a blend whose distance is asked for at first, how many times they are halved at least next to
/// curved parts of the source, and how many halves there are at most.
const PARTS: u32 = 16;
const FINER: u32 = 3;
const MOST_HALVES: u32 = 600;

/// One curve of a chain.
#[derive(Debug, Clone)]
pub(super) struct Link {
    pub(super) curve: Curve,
    /// The corner that it goes round.
    pub(super) corner: Option<Corner>,
    /// Whether nothing of it was cut off.
    pub(super) whole: bool,
}

impl Link {
    pub(super) fn plain(curve: Curve) -> Self {
        Self { curve, corner: None, whole: true }
    }
}

/// Curves that follow each other.
#[derive(Debug)]
pub(super) struct Chain {
    pub(super) links: Vec<Link>,
    pub(super) closed: bool,
}

impl Chain {
    pub(super) fn into_curve(self, tolerance: f64) -> Curve {
        chained(self.links.into_iter().map(|l| l.curve).collect(), tolerance)
    }
}

/// What is asked to replace arcs, and of what.
pub(super) struct Restyle<'a> {
    pub(super) source: &'a Curve,
    pub(super) raw: &'a Raw,
    pub(super) distance: f64,
    pub(super) tolerance: f64,
    pub(super) epsilon: f64,
    pub(super) corner: OffsetCorner,
}

/// A curve that may stand for an arc.
struct Candidate {
    chain: usize,
    link: usize,
    curve: Curve,
}

impl Restyle<'_> {
    /// Replaces the arcs of corners where what replaces them comes too near to nothing but such corners and crosses
    /// nothing: so what was closed stays closed. Of an arc that was cut short, a chamfer spans the rest.
    pub(super) fn apply(&self, chains: &mut [Chain]) -> Result<()> {
        let vertices: Vec<Point3> =
            self.raw.parts.iter().filter_map(|p| p.corner.map(|c| c.vertex)).collect();
        let clearance = Clearance::new(self, &vertices);
        let mut candidates: Vec<Candidate> = Vec::new();
        for (i, chain) in chains.iter().enumerate() {
            for (j, link) in chain.links.iter().enumerate() {
                let Some(corner) = link.corner else { continue };
                for curve in self.choices(chain, j, &corner) {
                    if curve_self(&curve, self.epsilon)?.is_empty() && clearance.allows(&curve)? {
                        candidates.push(Candidate { chain: i, link: j, curve });
                        break;
                    }
                }
            }
        }
        let all: Vec<&Curve> = chains.iter().flat_map(|c| &c.links).map(|l| &l.curve).collect();
        let mut firsts = Vec::with_capacity(chains.len());
        let mut count = 0;
        for chain in chains.iter() {
            firsts.push(count);
            count += chain.links.len();
        }
        let boxes: Vec<BoundingBox> = candidates.iter().map(|c| c.curve.bounding_box()).collect();
        let others: Vec<BoundingBox> = all.iter().map(|c| c.bounding_box()).collect();
        let mut work = Work::new(self.raw.parts.len());
        let mut free = vec![true; candidates.len()];
        for (i, j) in near_pairs(&boxes, Some(&others), self.epsilon, &work)? {
            let own = firsts[candidates[i].chain] + candidates[i].link;
            free[i] = free[i] && (j == own || !self.cross(&candidates[i].curve, all[j], &mut work)?);
        }
        for (i, j) in near_pairs(&boxes, None, self.epsilon, &work)? {
            if free[i] && free[j] && self.cross(&candidates[i].curve, &candidates[j].curve, &mut work)? {
                free[j] = false;
            }
        }
        for (candidate, _) in candidates.into_iter().zip(free).filter(|c| c.1) {
            chains[candidate.chain].links[candidate.link].curve = candidate.curve;
        }
        Ok(())
    }

    /// What may stand for an arc, best first.
    fn choices(&self, chain: &Chain, j: usize, corner: &Corner) -> Vec<Curve> {
        let link = &chain.links[j];
        let (a, b) = (link.curve.start(), link.curve.end());
        let size = a.distance_to(b);
        if size <= self.epsilon {
            return Vec::new();
        }
        if self.corner == OffsetCorner::Chamfer {
            return vec![Line::new(a, b).into()];
        }
        if !link.whole {
            return Vec::new();
        }
        let n = chain.links.len();
        let before = if j > 0 { Some(j - 1) } else { chain.closed.then(|| n - 1) };
        let after = if j + 1 < n { Some(j + 1) } else { chain.closed.then_some(0) };
        let mut out = Vec::new();
        // A side that bends too tightly would make the blend swing out.
        let calm = |curve: &Curve, at_end: bool| {
            let t = if at_end { curve.domain().end } else { curve.domain().start };
            curve.curvature_on_side(t, at_end).length() * size <= 1.0
        };
        if let (Some(before), Some(after)) = (before, after)
            && let (before, after) = (&chain.links[before].curve, &chain.links[after].curve)
            && calm(before, true)
            && calm(after, false)
        {
            out.extend(blend_between(before, after, [2, 2], [1.0, 1.0]).ok().map(Curve::from));
        }
        // As between straight sides, otherwise.
        let sides: [Curve; 2] =
            [Line::new(a - corner.arriving * size, a).into(), Line::new(b, b + corner.leaving * size).into()];
        out.extend(blend_between(&sides[0], &sides[1], [2, 2], [1.0, 1.0]).ok().map(Curve::from));
        out
    }

    /// Whether two curves cross elsewhere than at ends that they share.
    fn cross(&self, candidate: &Curve, other: &Curve, work: &mut Work) -> Result<bool> {
        let found = curve_curve(candidate, other, 0.1 * self.epsilon)?;
        work.more(found.visits)?;
        let ends = |c: &Curve| [c.start(), c.end()];
        let shared = |p: Point3| {
            let near = |c: &Curve| ends(c).into_iter().any(|e| e.distance_to(p) <= 4.0 * self.epsilon);
            near(candidate) && near(other)
        };
        Ok(!found.complete
            || found.crossings.iter().any(|c| c.kind == ContactKind::Transversal && !shared(c.point)))
    }
}

/// How far curves stay from the source, its filled corners left aside.
struct Clearance<'a> {
    whole: ClosestOnCurve<'a>,
    parts: &'a [Curve],
    near_parts: BoxTree,
    vertices: &'a [Point3],
    near_vertices: BoxTree,
    /// No nearer than this is far enough, by more than `fine`.
    least: f64,
    fine: f64,
    epsilon: f64,
}

impl<'a> Clearance<'a> {
    fn new(restyle: &Restyle<'a>, vertices: &'a [Point3]) -> Self {
        let bounds = |b: BoundingBox| -> Bounds { [b.min.into(), b.max.into()] };
        let boxes: Vec<Bounds> = restyle.raw.smooth.iter().map(|c| bounds(c.bounding_box())).collect();
        let points: Vec<Bounds> = vertices.iter().map(|&p| [p.into(), p.into()]).collect();
        Self {
            whole: ClosestOnCurve::new(restyle.source),
            parts: &restyle.raw.smooth,
            near_parts: BoxTree::by_place(&boxes),
            vertices,
            near_vertices: BoxTree::by_place(&points),
            least: restyle.distance.abs() - 0.5 * restyle.tolerance,
            fine: 0.5 * restyle.tolerance,
            epsilon: restyle.epsilon,
        }
    }

    /// Whether a curve comes too near to nothing but filled corners: nowhere is there a place on the source nearer
    /// than the distance, nearest among its neighbours, that is no such corner. Such a place is no nearer to a whole
    /// part of the curve than to its middle, less half its length; but beside a curved part of the source it may be
    /// such a place for the middle only.
    fn allows(&self, curve: &Curve) -> Result<bool> {
        let domain = curve.domain();
        let at = |k: u32| domain.at(f64::from(k) / f64::from(PARTS));
        let mut stack: Vec<(f64, f64, u32)> = (0..PARTS).map(|k| (at(k), at(k + 1), 0)).collect();
        let mut budget = MOST_HALVES;
        while let Some((from, to, depth)) = stack.pop() {
            let middle = 0.5 * (from + to);
            let q = curve.point_at(middle);
            let reach = curve.point_at(from).distance_to(q).max(curve.point_at(to).distance_to(q));
            let (found, curved) = self.nearest(q, self.least + reach)?;
            if found < self.least {
                return Ok(false);
            }
            let near = found < self.least + reach || (curved && depth < FINER);
            if near && reach > 0.1 * self.fine {
                let Some(left) = budget.checked_sub(1) else { return Ok(false) };
                budget = left;
                stack.extend([(from, middle, depth + 1), (middle, to, depth + 1)]);
            }
        }
        Ok(true)
    }

    /// How far the nearest such place is, if nearer than a limit, and whether there are curved parts so near.
    fn nearest(&self, q: Point3, limit: f64) -> Result<(f64, bool)> {
        let (mut least, mut curved) = (f64::INFINITY, false);
        if self.whole.nearest_within(q, limit)?.is_none() {
            return Ok((least, curved));
        }
        let squared = limit * limit;
        let mut hits = Vec::new();
        self.near_parts.visit_near(&q.into(), squared, |i| {
            hits.push(i);
            squared
        });
        for part in hits.into_iter().filter_map(|i| self.parts.get(i)) {
            let feet = match part {
                Curve::Line(_) => vec![part.closest_point(q)?],
                _ => {
                    curved = true;
                    part.local_closest_points(q)?
                }
            };
            let places = feet.iter().filter(|f| !self.is_vertex(f.point)).map(|f| f.distance);
            least = places.fold(least, f64::min);
        }
        Ok((least, curved))
    }

    fn is_vertex(&self, p: Point3) -> bool {
        let limit = self.epsilon * self.epsilon;
        let mut found = false;
        self.near_vertices.visit_near(&p.into(), limit, |i| {
            found = found || self.vertices.get(i).is_some_and(|v| v.distance_to(p) <= self.epsilon);
            limit
        });
        found
    }
}
