//! Areas that two surfaces have in common: bounded by the parts of the sides of each that lie on the other one.

use super::sheet::Sheet;
use super::{BranchKind, SurfaceBranch, SurfaceContact, SurfaceContactKind, exact, images};
use crate::chart::thresholds::{EXACT, IMAGE, IMAGE_OF_TOLERANCE, INWARD, MET, ON_CARRIER, SAME_END};
use crate::intersect::{curve_curve, curve_with_surface};
use crate::trace::Pair;
use crate::{Curve, Direction, Interval, Point3, Result, Surface};

/// The common areas of two surfaces, and curves in which their sides lie on each other without one.
pub(super) struct Overlaps {
    pub(super) contacts: Vec<SurfaceContact>,
    /// Whether all borders close.
    pub(super) complete: bool,
}

/// As [`overlaps`], for charts that may lie on each other in parts; `None` also where they have no area in common.
///
/// # Errors
/// The work was stopped, or a number is not finite.
pub(super) fn of_charts(pair: &Pair<'_>, limit: f64) -> Result<Option<Overlaps>> {
    let surfaces = pair.charts.map(|c| Surface::from(c.nurbs().clone()));
    let mut sheets = [Sheet::new(&surfaces[0])?, Sheet::new(&surfaces[1])?];
    let near = (EXACT * pair.size()).max(MET * pair.noise);
    let target = (IMAGE_OF_TOLERANCE * limit).min(IMAGE * pair.size()).max(ON_CARRIER * near);
    let found = overlaps(&mut sheets, near, target)?;
    let has_area = |o: &Overlaps| o.contacts.iter().any(|c| c.kind == SurfaceContactKind::Overlap);
    Ok(found.filter(has_area).map(|mut o| {
        // What only touches is found by the search.
        o.contacts.retain(|c| c.kind == SurfaceContactKind::Overlap);
        o
    }))
}

/// A part of a side that lies on the other surface.
struct Stretch {
    curve: Curve,
    closed: bool,
    /// A common place beside it, when an area is there: on the left, seen against the first surface's normal.
    inside: Option<Inside>,
}

#[derive(Clone, Copy)]
struct Inside {
    point: Point3,
    at: [[f64; 2]; 2],
}

/// The common areas of two surfaces that lie on each other within `near`; `None` when an image of a border cannot be made.
///
/// The border of a common area consists of parts of sides: a side of one that lies on the other one bounds an area when also
/// places a little inside it lie there. Surfaces that are analytic and agree on an area agree as far as both reach.
///
/// # Errors
/// The work was stopped, or a number is not finite.
pub(super) fn overlaps(sheets: &mut [Sheet<'_>; 2], near: f64, target: f64) -> Result<Option<Overlaps>> {
    let mut out = Overlaps { contacts: Vec::new(), complete: true };
    let mut stretches: Vec<Stretch> = Vec::new();
    for s in 0..2 {
        for i in 0..sheets[s].borders.len() {
            let curve = sheets[s].borders[i].curve.clone();
            let met = curve_with_surface(&curve, sheets[1 - s].surface, near)?;
            out.complete &= met.complete;
            let ends = crossings(&curve, &sheets[1 - s], near)?;
            let ranges = met.overlaps.iter().map(|o| snapped(&curve, o.t, &ends, near)).collect();
            for range in joined(&curve, ranges) {
                let part = curve.sub_curve(range)?;
                if stretches.iter().any(|k| lies_on(&part, &k.curve, near).unwrap_or(false)) {
                    continue;
                }
                let closed = range == curve.domain() && curve.is_closed();
                stretches.push(stretch(part, closed, sheets, [s, i], near)?);
            }
        }
    }
    let (areas, lines): (Vec<_>, Vec<_>) = stretches.into_iter().partition(|s| s.inside.is_some());
    let mut inside = areas.iter().find_map(|s| s.inside);
    if inside.is_none() {
        inside = whole(sheets, near)?;
    }
    let mut pieces = Vec::with_capacity(areas.len());
    for area in areas {
        let Some(branch) = branch(area, sheets, target)? else { return Ok(None) };
        pieces.push(branch);
    }
    if let Some(Inside { point, at }) = inside {
        let size = sheets.iter().map(|s| s.surface.bounding_box().map_or(0.0, |b| b.diagonal().length()));
        let reach = (SAME_END * size.fold(f64::INFINITY, f64::min)).max(near);
        let (border, closes) = loops(pieces, reach);
        out.complete &= closes;
        let mut ranges = exact::ranges(border.iter().flatten());
        for (k, range) in ranges.iter_mut().enumerate() {
            // Around a closed surface, and where a pole lies inside, the border does not tell how far it reaches.
            let d = Direction::BOTH[k % 2];
            let surface = sheets[k / 2].surface;
            if !(range[0] < range[1]) || surface.is_closed(d) || !sheets[k / 2].poles.is_empty() {
                *range = [surface.domain(d).start, surface.domain(d).end];
            }
        }
        let kind = SurfaceContactKind::Overlap;
        out.contacts.push(SurfaceContact { kind, point, at, gap: 0.0, ranges, curve: None, border });
    }
    for line in lines {
        let Some(branch) = branch(line, sheets, target)? else { return Ok(None) };
        out.contacts.push(exact::along(branch));
    }
    Ok(Some(out))
}

fn branch(stretch: Stretch, sheets: &mut [Sheet<'_>; 2], target: f64) -> Result<Option<SurfaceBranch>> {
    let kind = match &stretch.curve {
        Curve::Line(_) => BranchKind::Line,
        Curve::Arc(_) => BranchKind::Circle,
        _ => BranchKind::Side,
    };
    images::branch(stretch.curve, kind, stretch.closed, sheets, target)
}

/// Where a curve crosses the borders of a surface on which it lies: the ends of what it has in common with it, exactly.
fn crossings(curve: &Curve, other: &Sheet<'_>, near: f64) -> Result<Vec<f64>> {
    let bounds = curve.bounding_box();
    let mut out = Vec::new();
    for border in &other.borders {
        if border.bounds.distance_to_box(&bounds) <= near {
            let met = curve_curve(curve, &border.curve, near)?;
            out.extend(met.crossings.iter().map(|c| c.a));
            out.extend(met.overlaps.iter().flat_map(|o| [o.a.start, o.a.end]));
        }
    }
    Ok(out)
}

/// A range with its ends at crossings near them: by distance alone it reaches further, the more so the flatter the angle.
fn snapped(curve: &Curve, range: Interval, ends: &[f64], near: f64) -> Interval {
    let snap = |t: f64| {
        let p = curve.point_at(t);
        let off = |c: f64| curve.point_at(c).distance_to(p);
        let best = ends.iter().copied().min_by(|a, b| off(*a).total_cmp(&off(*b)));
        best.filter(|c| off(*c) <= SNAP * near).unwrap_or(t)
    };
    let (start, end) = (snap(range.start), snap(range.end));
    if start < end { Interval::new(start, end) } else { range }
}

/// Ends within this many times the distance within which curves lie on surfaces are one.
const SNAP: f64 = 256.0;

/// Ranges that follow each other as one, also through the seam of a closed curve (then decreasing).
fn joined(curve: &Curve, ranges: Vec<Interval>) -> Vec<Interval> {
    let domain = curve.domain();
    let near = SAME_END * domain.length();
    let mut out: Vec<Interval> = Vec::new();
    for range in ranges {
        match out.last_mut() {
            Some(last) if range.start - last.end <= near => last.end = last.end.max(range.end),
            _ => out.push(range),
        }
    }
    if curve.is_closed()
        && out.len() > 1
        && out.first().is_some_and(|r| r.start - domain.start <= near)
        && out.last().is_some_and(|r| domain.end - r.end <= near)
    {
        let first = out.remove(0);
        if let Some(last) = out.last_mut() {
            last.end = first.end;
        }
    }
    if let [only] = &mut out[..]
        && only.start - domain.start <= near
        && domain.end - only.end <= near
    {
        *only = domain;
    }
    out.retain(|r| (r.end - r.start).abs() > near);
    out
}

/// Whether a curve lies on another one, by places of it.
fn lies_on(part: &Curve, other: &Curve, near: f64) -> Result<bool> {
    for share in [0.12, images::MIDDLE, 0.81] {
        let p = part.point_at(part.domain().at(share));
        if other.closest_point_within(p, near)?.is_none() {
            return Ok(false);
        }
    }
    Ok(true)
}

/// A part of border `i` of surface `s`, turned so that the common area, if there is one beside it, is on its left.
fn stretch(
    curve: Curve,
    closed: bool,
    sheets: &mut [Sheet<'_>; 2],
    [s, i]: [usize; 2],
    near: f64,
) -> Result<Stretch> {
    let t = curve.domain().at(images::MIDDLE);
    let p = curve.point_at(t);
    let (own, _) = sheets[s].nearest(p, None)?;
    for part in INWARD {
        let inner = sheets[s].inward(&sheets[s].borders[i], own, part);
        let q = sheets[s].point(inner);
        let (other, off) = sheets[1 - s].nearest(q, None)?;
        if off <= near {
            let at = if s == 0 { [inner, other] } else { [other, inner] };
            let (uv, _) = sheets[0].nearest(p, None)?;
            let left = sheets[0].normal(uv).map(|n| n.cross(images::velocity(&curve, t)));
            let turned = left.is_some_and(|left| left.dot(q - p) < 0.0);
            let curve = if turned { images::reversed(&curve)? } else { curve };
            return Ok(Stretch { curve, closed, inside: Some(Inside { point: q, at }) });
        }
    }
    Ok(Stretch { curve, closed, inside: None })
}

/// A common place of surfaces without sides on each other: they are closed and the same, or have nothing in common.
fn whole(sheets: &mut [Sheet<'_>; 2], near: f64) -> Result<Option<Inside>> {
    let middle = Direction::BOTH.map(|d| sheets[0].surface.domain(d).at(images::MIDDLE));
    let point = sheets[0].point(middle);
    let (other, off) = sheets[1].nearest(point, None)?;
    Ok((off <= near).then_some(Inside { point, at: [middle, other] }))
}

/// The pieces in loops, each going on where the one before it ends, and whether all loops close.
fn loops(mut pieces: Vec<SurfaceBranch>, reach: f64) -> (Vec<Vec<SurfaceBranch>>, bool) {
    let mut out = Vec::new();
    let mut closes = true;
    pieces.reverse();
    while let Some(first) = pieces.pop() {
        let start = first.curve.start();
        let mut end = first.curve.end();
        let mut row = vec![first];
        while end.distance_to(start) > reach {
            let next = pieces.iter().position(|p| p.curve.start().distance_to(end) <= reach);
            let Some(next) = next else { break };
            let piece = pieces.remove(next);
            end = piece.curve.end();
            row.push(piece);
        }
        closes &= end.distance_to(start) <= reach;
        out.push(row);
    }
    (out, closes)
}
