//! Loops of strands as curves.

use super::loops::Step;
use super::nodes::{Nodes, excursion};
use super::sources::Sources;
use super::strands::{Member, Strand};
use crate::curve::chained;
use crate::intersect::{ContactKind, Crossing, curve_curve, curve_self};
use crate::thresholds;
use crate::{Arc, ArcCurve, Curve, Interval, Line, LineCurve, NurbsCurve, Point3, Result};

/// How many tolerances before their joint two pieces side by side may cross and be cut there.
const MOST_BESIDE: f64 = 64.0;

/// A stretch of a part, over the seam where the range decreases.
#[derive(Debug, Clone, Copy)]
struct Run {
    part: usize,
    range: Interval,
    /// Whether it is walked as the part runs.
    ahead: bool,
}

/// The closed curve of a loop: pieces of the parts as they are. A source that is walked as a whole comes back whole.
/// Where pieces meet only within the tolerance they are brought together.
pub(super) fn curve(
    sources: &Sources,
    nodes: &Nodes,
    strands: &[Strand],
    steps: &[Step],
    tolerance: f64,
) -> Result<Option<Curve>> {
    let members = chosen(sources, strands, steps);
    if let Some(&(first, ahead)) = members.first() {
        let source = &sources.list[sources.parts[first.part].source];
        let all: usize = source.parts.clone().map(|p| nodes.stops[p].len().saturating_sub(1)).sum();
        let own = |&(m, a): &(Member, bool)| source.parts.contains(&m.part) && a == ahead;
        if source.curve.is_closed() && members.len() == all && members.iter().all(own) {
            return Ok(Some(if ahead { source.curve.clone() } else { source.curve.reversed() }));
        }
    }
    let mut pieces = Vec::new();
    for run in runs(sources, &members) {
        let part = &sources.parts[run.part].curve;
        let piece = if run.range == part.domain() { part.clone() } else { part.sub_curve(run.range)? };
        pieces.push(if run.ahead { piece } else { piece.reversed() });
    }
    let pieces = closed_up(pieces, sources.scale, tolerance)?;
    if pieces.is_empty() {
        return Ok(None);
    }
    Ok(Some(chained(pieces, tolerance)))
}

/// Of the stretches of each strand the one that goes on best from the strand before, else the first.
fn chosen(sources: &Sources, strands: &[Strand], steps: &[Step]) -> Vec<(Member, bool)> {
    let mut before: Option<Member> = None;
    let mut out = Vec::new();
    // Around twice: the first step goes on from the last.
    for _ in 0..2 {
        out.clear();
        for step in steps {
            let members = &strands[step.strand].members;
            let part = |p: Member| members.iter().find(|m| m.part == p.part);
            let source = |p: Member| {
                members.iter().find(|m| sources.parts[m.part].source == sources.parts[p.part].source)
            };
            let best = before.and_then(|p| part(p).or_else(|| source(p)));
            if let Some(&m) = best.or(members.first()) {
                before = Some(m);
                out.push((m, m.along == step.forward));
            }
        }
    }
    out
}

/// Stretches that follow each other on one part as one.
fn runs(sources: &Sources, members: &[(Member, bool)]) -> Vec<Run> {
    let mut out: Vec<Run> = Vec::new();
    for &(m, ahead) in members {
        let new = Run { part: m.part, range: m.range, ahead };
        match out.last_mut() {
            Some(last) => match joined(sources, last, &new) {
                Some(range) => last.range = range,
                None => out.push(new),
            },
            None => out.push(new),
        }
    }
    if out.len() > 1
        && let (Some(&last), Some(&first)) = (out.last(), out.first())
        && let Some(range) = joined(sources, &last, &first)
    {
        out.pop();
        out[0].range = range;
    }
    out
}

/// The range of two runs of which the second follows the first.
fn joined(sources: &Sources, a: &Run, b: &Run) -> Option<Interval> {
    if a.part != b.part || a.ahead != b.ahead {
        return None;
    }
    let curve = &sources.parts[a.part].curve;
    let domain = curve.domain();
    // In the direction of the part.
    let (x, y) = if a.ahead { (a.range, b.range) } else { (b.range, a.range) };
    let over_seam = || x.end == domain.end && y.start == domain.start && curve.is_closed();
    let range = Interval::new(x.start, y.end);
    ((x.end == y.start || over_seam()) && range.start != range.end).then_some(range)
}

/// Pieces that meet exactly. Where ends are apart, by some tolerances at most, the pieces are cut where they cross
/// near there; else the ends are moved together, if that moves nothing else by more, or joined by a segment.
fn closed_up(mut pieces: Vec<Curve>, scale: f64, tolerance: f64) -> Result<Vec<Curve>> {
    let count = pieces.len();
    let mut links: Vec<Option<Curve>> = vec![None; count];
    for i in 0..count {
        let j = (i + 1) % count;
        let (end, start) = (pieces[i].end(), pieces[j].start());
        if end.coincides(start) {
            continue;
        }
        if i == j
            && let Some(range) = crossing_of_ends(&pieces[i], scale, tolerance)?
        {
            pieces[i] = pieces[i].trimmed(range)?;
            continue;
        }
        if i != j
            && let Some((a, b)) = crossing_near_ends(&pieces[i], &pieces[j], scale, tolerance)?
        {
            pieces[i] = pieces[i].trimmed(Interval::new(pieces[i].domain().start, a))?;
            pieces[j] = pieces[j].trimmed(Interval::new(b, pieces[j].domain().end))?;
            continue;
        }
        let target = match (&pieces[i], &pieces[j]) {
            (Curve::Line(_), Curve::Line(_)) => end.lerp(start, 0.5),
            (Curve::Line(_), _) => start,
            (_, Curve::Line(_)) => end,
            _ => end.lerp(start, 0.5),
        };
        let first = with_end(&pieces[i], true, target)?;
        let second = if i == j { None } else { with_end(&pieces[j], false, target)? };
        if let (Some(first), Some(second)) = (first, second) {
            (pieces[i], pieces[j]) = uncrossed(first, second, scale, tolerance)?;
        } else {
            links[i] = Some(Line::new(end, start).into());
        }
    }
    Ok(pieces.into_iter().zip(links).flat_map(|(piece, link)| std::iter::once(piece).chain(link)).collect())
}

/// Where two pieces cross next to the end of the first and the start of the second.
fn crossing_near_ends(
    first: &Curve,
    second: &Curve,
    scale: f64,
    tolerance: f64,
) -> Result<Option<(f64, f64)>> {
    let (end, start) = (first.end(), second.start());
    let found = curve_curve(first, second, thresholds::ROUNDING * scale)?;
    let away = |p: Point3| p.distance_to(end).max(p.distance_to(start));
    let inside = |c: &&Crossing| {
        let (d, e) = (first.domain(), second.domain());
        away(c.point) <= 8.0 * tolerance && d.start < c.a && c.b < e.end
    };
    let best = found.crossings.iter().filter(inside).min_by(|x, y| away(x.point).total_cmp(&away(y.point)));
    Ok(best.map(|c| (c.a, c.b)))
}

/// Two pieces that meet end to start, cut where they cross shortly before: an end that was moved may tilt one over the
/// other where they run side by side.
fn uncrossed(first: Curve, second: Curve, scale: f64, tolerance: f64) -> Result<(Curve, Curve)> {
    let (joint, d, e) = (first.end(), first.domain(), second.domain());
    let found = curve_curve(&first, &second, thresholds::ROUNDING * scale)?;
    let mut best: Option<(f64, &Crossing)> = None;
    for c in found.crossings.iter().filter(|c| c.kind == ContactKind::Transversal) {
        let away = c.point.distance_to(joint);
        let within = thresholds::SAME_POINT * scale < away
            && away <= MOST_BESIDE * tolerance
            && d.start < c.a
            && c.b < e.end;
        if within && best.is_none_or(|b| b.0 < away) {
            let middle = first.point_at(0.5 * (c.a + d.end));
            if second.closest_point_within(middle, tolerance)?.is_some() {
                best = Some((away, c));
            }
        }
    }
    let Some((_, c)) = best else { return Ok((first, second)) };
    Ok((first.trimmed(Interval::new(d.start, c.a))?, second.trimmed(Interval::new(c.b, e.end))?))
}

/// The part of a piece up to where its end crosses its start, next to both.
fn crossing_of_ends(piece: &Curve, scale: f64, tolerance: f64) -> Result<Option<Interval>> {
    let (start, end) = (piece.start(), piece.end());
    let found = curve_self(piece, thresholds::ROUNDING * scale)?;
    let away = |c: &Crossing| {
        let [p, q] = [c.a, c.b].map(|t| piece.point_at(t));
        let before = excursion(piece, Interval::new(piece.domain().start, c.a));
        let after = excursion(piece, Interval::new(c.b, piece.domain().end));
        p.distance_to(start).max(q.distance_to(end)).max(before).max(after)
    };
    let near = found.crossings.iter().map(|c| (c, away(c))).filter(|(_, d)| *d <= 8.0 * tolerance);
    let best = near.min_by(|x, y| x.1.total_cmp(&y.1));
    Ok(best.map(|(c, _)| Interval::new(c.a, c.b)).filter(|range| range.start < range.end))
}

/// The curve with one end moved. Lines stay lines and arcs arcs. `None` when more than the end would move by more.
fn with_end(curve: &Curve, last: bool, p: Point3) -> Result<Option<Curve>> {
    let gap = (if last { curve.end() } else { curve.start() }).distance_to(p);
    if gap == 0.0 {
        return Ok(Some(curve.clone()));
    }
    match curve {
        Curve::Line(c) => {
            let line = if last { Line::new(c.line.from, p) } else { Line::new(p, c.line.to) };
            return Ok(Some(LineCurve { line, domain: c.domain }.into()));
        }
        Curve::Arc(c) => {
            let (from, to) = if last { (curve.start(), p) } else { (p, curve.end()) };
            let moved = Arc::through(from, c.arc.midpoint(), to).ok().filter(|arc| {
                arc.circle.center().distance_to(c.arc.circle.center()) <= 2.0 * gap
                    && (arc.circle.radius - c.arc.circle.radius).abs() <= 2.0 * gap
            });
            return Ok(moved.map(|arc| ArcCurve { arc, domain: c.domain }.into()));
        }
        _ => {}
    }
    let nurbs = curve.to_nurbs()?.clamped()?;
    let mut points = nurbs.homogeneous_points();
    let leg = |points: &[[f64; 4]]| {
        let [a, b] = if last { [points.len() - 1, points.len() - 2] } else { [0, 1] };
        crate::nurbs::project(points[a]).distance_to(crate::nurbs::project(points[b]))
    };
    if points.len() < 2 || leg(&points) < 20.0 * gap {
        return Ok(None);
    }
    if let Some(end) = if last { points.last_mut() } else { points.first_mut() } {
        *end = [p.x * end[3], p.y * end[3], p.z * end[3], end[3]];
    }
    let knots = nurbs.knots().to_vec();
    if nurbs.is_rational() {
        return Ok(Some(NurbsCurve::rational(nurbs.degree(), points, knots)?.into()));
    }
    let plain = points.iter().map(|&q| crate::nurbs::project(q)).collect();
    Ok(Some(NurbsCurve::new(nurbs.degree(), plain, knots)?.into()))
}
