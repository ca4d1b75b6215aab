//! Which faces come near each other, and the points that edges have in common with edges and faces.
//!
//! Nothing is cut here. Every witness of a common point asks the one table of vertices, so that the first one places it
//! and the others find it.

use std::collections::BTreeSet;

use super::operands::{Edge, Near, Operands, Place};
use super::refusal::RefusalClass;
use super::thresholds::{CAPTURE, MOST_PAIRS, PARALLEL, ROUNDING, SAME_PARAMETER};
use crate::box_pairs::near_pairs;
use crate::intersect::{curve_curve, curve_with_surface};
use crate::{BoundingBox, Curve, Interval, Line, Point3, Result, cancellation};

/// The pairs of faces of different operands whose boxes meet, in order.
pub(super) fn face_pairs(all: &Operands) -> Result<Vec<(usize, usize)>> {
    let boxes: Vec<BoundingBox> = all.faces.iter().map(|f| f.bounds).collect();
    let pairs = near_pairs(&boxes, None, all.limit, MOST_PAIRS)
        .ok_or_else(|| all.refuse(RefusalClass::TooLarge, &[], None))?;
    let solid = |f: usize| all.faces.get(f).map(|f| f.solid);
    Ok(pairs.into_iter().filter(|&(a, b)| solid(a) != solid(b)).collect())
}

/// Places vertices where edges meet edges and faces of other operands.
pub(super) fn meet_edges(all: &mut Operands, pairs: &[(usize, usize)]) -> Result<()> {
    let mut with_edges: BTreeSet<(usize, usize)> = BTreeSet::new();
    let mut with_faces: BTreeSet<(usize, usize)> = BTreeSet::new();
    for &(a, b) in pairs {
        let (Some(fa), Some(fb)) = (all.faces.get(a), all.faces.get(b)) else { continue };
        let near = |e: usize, bounds: &BoundingBox| {
            all.edges.get(e).is_some_and(|e| e.bounds.distance_to_box(bounds) <= all.limit)
        };
        let ea: Vec<usize> = fa.border.iter().copied().filter(|e| near(*e, &fb.bounds)).collect();
        let eb: Vec<usize> = fb.border.iter().copied().filter(|e| near(*e, &fa.bounds)).collect();
        with_faces.extend(ea.iter().map(|e| (*e, b)));
        with_faces.extend(eb.iter().map(|e| (*e, a)));
        for &i in &ea {
            for &j in &eb {
                let key = (i.min(j), i.max(j));
                if all.edges.get(j).is_some_and(|e| near(i, &e.bounds)) {
                    with_edges.insert(key);
                }
            }
        }
    }
    let mut points: Vec<Point3> = Vec::new();
    for (i, j) in with_edges {
        cancellation::check()?;
        if let (Some(a), Some(b)) = (all.edges.get(i), all.edges.get(j)) {
            common_points(&a.curve, &b.curve, all.limit, &mut points)?;
        }
    }
    // Common points of edges first: what an edge has in common with a face near its border is found again.
    points.drain(..).for_each(|p| {
        all.vertices.at(p);
    });
    for (e, f) in with_faces {
        cancellation::check()?;
        pierce(all, e, f, &mut points)?;
    }
    points.into_iter().for_each(|p| {
        all.vertices.at(p);
    });
    Ok(())
}

/// The points in which two curves cross or touch, and the ends of stretches in which they lie upon each other.
pub(super) fn common_points(a: &Curve, b: &Curve, limit: f64, out: &mut Vec<Point3>) -> Result<()> {
    if let (Curve::Line(p), Curve::Line(q)) = (a, b) {
        out.extend(line_point(&p.line, &q.line, limit));
        return Ok(());
    }
    let met = curve_curve(a, b, limit)?;
    out.extend(met.crossings.iter().map(|c| c.point));
    let ends = [a.start(), a.end(), b.start(), b.end()];
    let other = Near::of(b);
    for overlap in &met.overlaps {
        // Curves upon each other part at an end of one of them, which is a vertex. Others only touch, and keep within the
        // tolerance over a stretch of about the root of it.
        let known = |t: f64| ends.iter().any(|end| end.distance_to(a.point_at(t)) <= CAPTURE * limit);
        if !known(overlap.a.start) && !known(overlap.a.end) {
            let t = nearest_in(overlap.a, |t| {
                let p = a.point_at(t);
                Ok(other
                    .parameter(p, CAPTURE * limit)?
                    .map_or(f64::INFINITY, |s| b.point_at(s).distance_to(p)))
            })?;
            out.push(a.point_at(t));
        }
    }
    Ok(())
}

/// Halvings by the golden section until a place of contact is known to rounding.
const SECTIONS: usize = 48;

/// The parameter in a range at which a distance that first falls and then grows is least.
fn nearest_in(range: Interval, mut distance: impl FnMut(f64) -> Result<f64>) -> Result<f64> {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let [mut low, mut high] = [range.start, range.end];
    let (mut s, mut t) = (high - golden * (high - low), low + golden * (high - low));
    let (mut at_s, mut at_t) = (distance(s)?, distance(t)?);
    for _ in 0..SECTIONS {
        cancellation::check()?;
        if at_s <= at_t {
            (high, t, at_t) = (t, s, at_s);
            s = high - golden * (high - low);
            at_s = distance(s)?;
        } else {
            (low, s, at_s) = (s, t, at_t);
            t = low + golden * (high - low);
            at_t = distance(t)?;
        }
    }
    Ok(0.5 * (low + high))
}

/// The common point of two segments that are not parallel; the ends of parallel ones are vertices already.
fn line_point(p: &Line, q: &Line, limit: f64) -> Option<Point3> {
    let (d, e) = (p.unit_direction()?, q.unit_direction()?);
    let n = d.cross(e);
    let square = n.length_squared();
    if !(square > PARALLEL * PARALLEL) {
        return None;
    }
    let w = q.from - p.from;
    let s = w.cross(e).dot(n) / square;
    let t = w.cross(d).dot(n) / square;
    let clear = |x: f64, length: f64| -limit <= x && x <= length + limit;
    if !(clear(s, p.length()) && clear(t, q.length())) {
        return None;
    }
    let (a, b) = (p.from + d * s, q.from + e * t);
    (a.distance_to(b) <= limit).then(|| a.lerp(b, 0.5))
}

/// The points in which an edge meets a face.
fn pierce(all: &Operands, edge: usize, face: usize, out: &mut Vec<Point3>) -> Result<()> {
    let (Some(own), Some(other)) = (all.edges.get(edge), all.faces.get(face)) else { return Ok(()) };
    let mut found = Vec::new();
    if let (Curve::Line(c), Some(plane)) = (&own.curve, other.plane()) {
        let (a, b) = (plane.signed_distance(c.line.from), plane.signed_distance(c.line.to));
        let within = a.abs() <= all.limit || b.abs() <= all.limit;
        if within || (a > 0.0) == (b > 0.0) {
            // Ends on the plane are vertices; they are asked about below only where they are inside.
            for (end, height) in [(c.line.from, a), (c.line.to, b)] {
                if height.abs() <= all.limit {
                    found.push(end);
                }
            }
        } else {
            found.push(c.line.at(a / (a - b)));
        }
    } else {
        let met = curve_with_surface(&own.curve, &other.surface, all.limit)?;
        if !met.complete {
            return Err(all.refuse(RefusalClass::Unfinished, &[face], Some(own.curve.start())));
        }
        found.extend(met.crossings.iter().map(|c| own.curve.point_at(c.t)));
        let domain = own.curve.domain();
        let least = SAME_PARAMETER * domain.length();
        for overlap in &met.overlaps {
            // As for curves: what only touches does so where it is nearest.
            if overlap.t.start > domain.start + least && overlap.t.end < domain.end - least {
                let t = nearest_in(overlap.t, |t| {
                    let p = own.curve.point_at(t);
                    let uv = other.parameters(p)?;
                    Ok(other.surface.point_at(uv[0], uv[1]).distance_to(p))
                })?;
                found.push(own.curve.point_at(t));
            }
        }
    }
    for p in found {
        if all.vertices.known(p).is_none() && all.place(other, p, all.limit)? != Place::Outside {
            out.push(p);
        }
    }
    Ok(())
}

/// The vertices on a curve: parameters and vertices in order, those at its ends among them when they are vertices.
pub(super) fn stops(
    all: &Operands,
    index: &crate::BoxIndex,
    curve: &Curve,
    bounds: &BoundingBox,
    reach: f64,
) -> Result<Vec<(f64, usize)>> {
    let mut out = Vec::new();
    let search = Near::of(curve);
    for place in index.near(bounds, reach) {
        let p = all.vertices.point(place);
        if let Some(t) = search.parameter(p, reach)? {
            out.push((t, place));
        }
    }
    out.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    Ok(out)
}

/// The stops of an edge: its own vertices at its ends, others between.
pub(super) fn edge_stops(all: &Operands, index: &crate::BoxIndex, edge: &Edge) -> Result<Vec<(f64, usize)>> {
    let domain = edge.curve.domain();
    let mut out = vec![(domain.start, edge.ends[0])];
    let found = stops(all, index, &edge.curve, &edge.bounds, all.limit)?;
    // A vertex beside an end is nearest to that end, and not between the ends.
    let least = ROUNDING * domain.length();
    let between = |t: f64| t > domain.start + least && t < domain.end - least;
    out.extend(found.into_iter().filter(|(t, v)| between(*t) && !edge.ends.contains(v)));
    out.push((domain.end, edge.ends[1]));
    Ok(out)
}
