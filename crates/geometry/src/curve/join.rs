//! Curves joined end to end.

use crate::curve::thresholds::LEAST_CELL;
use std::collections::HashMap;

use super::ends::with_ends;
use super::{Curve, PolyCurve, PolylineCurve};
use crate::{Interval, Line, LineCurve, Point3};

/// Ends of curves by the cell of a grid they lie in, to find those near a point.
struct Ends {
    cell: f64,
    cells: HashMap<[i64; 3], Vec<(usize, bool)>>,
}

impl Ends {
    fn key(&self, p: Point3) -> [i64; 3] {
        [p.x, p.y, p.z].map(|x| (x / self.cell).floor() as i64)
    }

    fn add(&mut self, p: Point3, curve: usize, at_end: bool) {
        let key = self.key(p);
        self.cells.entry(key).or_default().push((curve, at_end));
    }

    /// The nearest free end within the tolerance of `p`; of equally near ones the one of the earlier curve.
    fn nearest(
        &self,
        p: Point3,
        tolerance: f64,
        point: impl Fn(usize, bool) -> Point3,
        usable: impl Fn(usize, bool) -> bool,
    ) -> Option<(usize, bool)> {
        let [i, j, k] = self.key(p);
        let mut best: Option<(f64, usize, bool)> = None;
        for x in i.saturating_sub(1)..=i.saturating_add(1) {
            for y in j.saturating_sub(1)..=j.saturating_add(1) {
                for z in k.saturating_sub(1)..=k.saturating_add(1) {
                    for &(curve, at_end) in self.cells.get(&[x, y, z]).into_iter().flatten() {
                        let d = point(curve, at_end).distance_to(p);
                        let better = best.is_none_or(|(b, c, _)| d < b || (d == b && curve < c));
                        if d <= tolerance && usable(curve, at_end) && better {
                            best = Some((d, curve, at_end));
                        }
                    }
                }
            }
        }
        best.map(|(_, curve, at_end)| (curve, at_end))
    }
}

/// Joins curves whose ends lie within `tolerance` of each other, into polylines where all parts are straight and
/// poly-curves otherwise. Each result stands where its first member stood; closed curves and those that meet no other
/// come back as they are. Unless `preserve_direction` is set, curves may be turned round to fit; the first member of
/// a chain gives the direction.
pub fn join_curves(curves: &[Curve], tolerance: f64, preserve_direction: bool) -> Vec<Curve> {
    let tolerance = if tolerance.is_finite() { tolerance.max(0.0) } else { 0.0 };
    let ends: Vec<(Point3, Point3)> = curves.iter().map(|c| (c.start(), c.end())).collect();
    let closed: Vec<bool> = curves.iter().map(Curve::is_closed).collect();
    chains(&ends, &closed, tolerance, preserve_direction)
        .into_iter()
        .map(|chain| {
            let parts: Vec<Curve> = chain
                .iter()
                .map(|&(i, backwards)| if backwards { curves[i].reversed() } else { curves[i].clone() })
                .collect();
            chained(parts, tolerance)
        })
        .collect()
}

/// Which of many things with two ends follow each other, and whether each is walked backwards: by the rules of
/// [`join_curves`].
pub(crate) fn chains(
    ends: &[(Point3, Point3)],
    closed: &[bool],
    tolerance: f64,
    preserve_direction: bool,
) -> Vec<Vec<(usize, bool)>> {
    let size =
        ends.iter().fold(1.0_f64, |m, (a, b)| m.max(a.to_vector().length()).max(b.to_vector().length()));
    let mut grid = Ends { cell: (2.0 * tolerance).max(LEAST_CELL * size), cells: HashMap::new() };
    let mut used: Vec<bool> = closed.to_vec();
    for (i, &(a, b)) in ends.iter().enumerate() {
        if !used[i] {
            grid.add(a, i, false);
            grid.add(b, i, true);
        }
    }
    let mut out = Vec::new();
    for first in 0..ends.len() {
        // Whoever waits no longer does not look at what is joined either.
        if crate::cancellation::check().is_err() {
            break;
        }
        if used[first] {
            if closed[first] {
                out.push(vec![(first, false)]);
            }
            continue;
        }
        used[first] = true;
        // (curve, whether it is walked backwards)
        let mut chain = std::collections::VecDeque::from([(first, false)]);
        let point = |i: usize, at_end: bool| if at_end { ends[i].1 } else { ends[i].0 };
        for forward in [true, false] {
            while let (Some(&head), Some(&tail)) = (chain.front(), chain.back()) {
                let (start, end) = (point(head.0, head.1), point(tail.0, !tail.1));
                // A chain of two or more whose ends meet is complete.
                if chain.len() > 1 && start.distance_to(end) <= tolerance {
                    break;
                }
                let here = if forward { end } else { start };
                let usable = |i: usize, at_end: bool| !used[i] && (!preserve_direction || at_end != forward);
                let Some((next, at_end)) = grid.nearest(here, tolerance, point, usable) else { break };
                used[next] = true;
                if forward {
                    chain.push_back((next, at_end));
                } else {
                    chain.push_front((next, !at_end));
                }
            }
        }
        out.push(chain.into());
    }
    out
}

/// Points less than this apart are one to openNURBS's eyes, whichever way the axes are turned: √3 · 2⁻³², and a little.
const COINCIDENT: f64 = 5e-10;

/// Whether all of a curve is one place to openNURBS's eyes.
fn is_speck(curve: &Curve) -> bool {
    curve.start().coincides(curve.end()) && !curve.is_closed() && {
        let bounds = curve.bounding_box();
        bounds.min.coincides(bounds.max)
    }
}

/// Corners without those that all but coincide with the one before; the first and the last stay.
fn spaced(points: Vec<Point3>) -> Vec<Point3> {
    let mut out: Vec<Point3> = Vec::with_capacity(points.len());
    let last = points.last().copied();
    for p in points {
        if out.last().is_none_or(|before| before.distance_to(p) > COINCIDENT) {
            out.push(p);
        }
    }
    match (last, out.len()) {
        (Some(last), 2..) => {
            out.pop();
            out.push(last);
        }
        (Some(last), _) => out.push(last),
        (None, _) => {}
    }
    out
}

/// Makes one curve end where the next begins. Straight ones meet their neighbours to the last digit; of others one is
/// bent to the other, an arc only where the other is one too, and only across a gap that openNURBS would see.
fn meet(before: &mut Curve, after: &mut Curve) {
    let (end, start) = (before.end(), after.start());
    if end == start {
        return;
    }
    match (&*before, &*after) {
        (_, Curve::Line(LineCurve { line, domain })) => {
            *after = LineCurve { line: Line::new(end, line.to), domain: *domain }.into();
        }
        (Curve::Line(LineCurve { line, domain }), _) => {
            *before = LineCurve { line: Line::new(line.from, start), domain: *domain }.into();
        }
        _ if end.distance_to(start) <= COINCIDENT => {}
        (other, Curve::Arc(_)) if !matches!(other, Curve::Arc(_)) => {
            if let Ok(moved) = with_ends(other, [other.start(), start]) {
                *before = moved;
            }
        }
        (_, other) => {
            if let Ok(moved) = with_ends(other, [end, other.end()]) {
                *after = moved;
            }
        }
    }
}

/// One curve from parts that follow each other.
pub(crate) fn chained(mut parts: Vec<Curve>, tolerance: f64) -> Curve {
    if !parts.iter().all(is_speck) {
        parts.retain(|part| !is_speck(part));
    }
    if parts.len() == 1
        && let Some(only) = parts.pop()
    {
        return only;
    }
    let fallback = parts.first().cloned();
    if let Some(lists) = parts.iter().map(Curve::as_polyline).collect::<Option<Vec<_>>>() {
        let mut points: Vec<Point3> = Vec::new();
        for list in lists {
            let skip = usize::from(!points.is_empty());
            points.extend(list.into_iter().skip(skip));
        }
        // A chain that closes within the tolerance closes exactly.
        if let (Some(first), Some(last)) = (points.first().copied(), points.last_mut())
            && first.distance_to(*last) <= tolerance
        {
            *last = first;
        }
        if let Ok(polyline) = PolylineCurve::new(spaced(points)) {
            return polyline.into();
        }
    }
    let mut segments: Vec<Curve> = Vec::new();
    for part in parts {
        match part {
            Curve::Poly(c) => segments.extend(c.into_parts().0),
            other => segments.push(other),
        }
    }
    for i in 1..segments.len() {
        let (before, after) = segments.split_at_mut(i);
        if let (Some(before), Some(after)) = (before.last_mut(), after.first_mut()) {
            meet(before, after);
        }
    }
    // A chain that closes within the tolerance closes exactly.
    if let [first, .., last] = segments.as_mut_slice()
        && first.start().distance_to(last.end()) <= tolerance
    {
        meet(last, first);
    }
    match (PolyCurve::new(segments), fallback) {
        (Ok(joined), _) => joined.into(),
        (Err(_), Some(first)) => first,
        (Err(_), None) => {
            LineCurve { line: Line::new(Point3::ORIGIN, Point3::ORIGIN), domain: Interval::UNIT }.into()
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "a failing test may panic")]

    use super::*;

    /// Bent curves that are joined across a gap meet exactly, and close where they close within the tolerance.
    #[test]
    fn bent_curves_meet_exactly() {
        let at = |x: f64, y: f64| Point3::new(x, y, 0.0);
        let free = |points: &[Point3]| -> Curve {
            crate::NurbsCurve::new(3, points.to_vec(), vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0]).unwrap().into()
        };
        let arc = |x: f64| -> Curve {
            let circle =
                crate::Circle { plane: crate::Plane { origin: at(x, 0.0), ..crate::Plane::XY }, radius: 1.0 };
            crate::ArcCurve::new(crate::Arc { circle, angle: Interval::new(0.0, std::f64::consts::PI) })
                .into()
        };
        let there = free(&[at(-1.0, 0.0004), at(-1.0, -1.0), at(1.0, -1.0), at(1.0003, 0.0)]);
        let cases: [Vec<Curve>; 2] = [vec![arc(0.0), there], vec![arc(0.0), arc(2.0006), arc(-2.0005)]];
        for parts in cases {
            let count = parts.len();
            let joined = join_curves(&parts, 1e-3, false);
            let [Curve::Poly(chain)] = &joined[..] else { panic!("one curve: {joined:?}") };
            assert_eq!(chain.segments().len(), count);
            for pair in chain.segments().windows(2) {
                assert!(pair[0].end().distance_to(pair[1].start()) < 1e-12);
            }
            assert_eq!(joined[0].is_closed(), count == 2);
        }
    }

    #[test]
    fn corners_that_all_but_coincide_are_one_in_a_chain() {
        let at = |x: f64, y: f64| Point3::new(x, y, 0.0);
        let corners =
            [at(0.0, 0.0), at(1e-10, 0.0), at(3.0, 0.0), at(3.0, 2.0), at(1e-10, 1e-10), at(0.0, 0.0)];
        let parts = corners.windows(2).map(|p| Line::new(p[0], p[1]).into()).collect();
        let chain = chained(parts, 1e-3);
        let found = chain.as_polyline().unwrap();
        assert_eq!(found.len(), 4, "{found:?}");
        assert_eq!(found[0], found[3]);
        assert!(found.iter().zip([0, 2, 3]).all(|(p, k)| p.distance_to(corners[k]) < 1e-9), "{found:?}");
    }
}
