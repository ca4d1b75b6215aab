//! Loops cut away.

use super::chain::{Border, Edge, Sets, gather};
use super::restyle::Restyle;
use super::validity::Validity;
use super::{OffsetCorner, Raw, RawPart};
use crate::intersect::{curve_curve, curve_self};
use crate::offset::thresholds::{CUT_OF_SIZE, CUT_PARAMETER, FINE_OF_SIZE, NO_GAP};
use crate::{BoundingBox, Circle, Curve, Error, Interval, Plane, Point3, Result, Tolerance};

/// The most pairs of parts that are looked at.
const MOST_PAIRS: u64 = 400_000;
/// The most pairs of parts of parts: about a second, and more where there are many parts.
const MOST_VISITS: u64 = 1_200_000;
const MORE_VISITS: u64 = 300;

/// Places on a stretch, but one, at which its distance is asked for.
const SAMPLES: u32 = 8;

/// What may still be done, so that it ends.
pub(super) struct Work {
    pairs: u64,
    visits: u64,
}

impl Work {
    pub(super) fn new(parts: usize) -> Self {
        Self { pairs: MOST_PAIRS, visits: MOST_VISITS + MORE_VISITS * parts as u64 }
    }

    pub(super) fn more(&mut self, visits: u64) -> Result<()> {
        match (self.pairs.checked_sub(1), self.visits.checked_sub(visits)) {
            (Some(pairs), Some(visits)) => (self.pairs, self.visits) = (pairs, visits),
            _ => return Err(too_much()),
        }
        Ok(())
    }
}

fn too_much() -> Error {
    let why = "the parts of its offset meet too often to be told apart".into();
    Error::Invalid { what: "curve to offset", why }
}

/// The parts that keep their distance from the curve, joined.
pub(super) fn cleaned(
    curve: &Curve,
    raw: &Raw,
    plane: &Plane,
    distance: f64,
    corner: OffsetCorner,
    tolerance: &Tolerance,
) -> Result<Vec<Curve>> {
    let parts: Vec<&Curve> = raw.parts.iter().map(|p| &p.curve).collect();
    let exact = raw.parts.iter().all(|p| p.source.is_none());
    let size = curve.bounding_box().diagonal().length() + distance.abs();
    let fine = (FINE_OF_SIZE * size).min(0.01 * tolerance.absolute);
    let epsilon = (CUT_OF_SIZE * size).min(0.1 * tolerance.absolute).max(4.0 * fine);
    let mut work = Work::new(parts.len());

    let mut cuts: Vec<Vec<f64>> = vec![Vec::new(); parts.len()];
    // Stretches on which two parts run over each other: in opposite directions they enclose nothing.
    let mut void: Vec<Vec<Interval>> = vec![Vec::new(); parts.len()];
    for (i, part) in parts.iter().enumerate() {
        if !matches!(part, Curve::Line(_) | Curve::Arc(_)) {
            let found = curve_self(part, fine)?;
            work.more(found.visits)?;
            cuts[i].extend(found.crossings.iter().flat_map(|c| [c.a, c.b]));
        }
    }
    let boxes: Vec<BoundingBox> = parts.iter().map(|p| p.bounding_box()).collect();
    for (i, j) in near_pairs(&boxes, None, fine, &work)? {
        let found = curve_curve(parts[i], parts[j], fine)?;
        work.more(found.visits)?;
        for c in &found.crossings {
            cuts[i].push(c.a);
            cuts[j].push(c.b);
        }
        for o in &found.overlaps {
            cuts[i].extend([o.a.start, o.a.end]);
            cuts[j].extend([o.b.start, o.b.end]);
            // In one direction, one of them is enough.
            void[j].push(o.b.ordered());
            if !o.same_direction {
                void[i].push(o.a.ordered());
            }
        }
    }

    // What else bounds the valid stretches.
    let closed = curve.is_closed();
    let mut others: Vec<Curve> = Vec::new();
    let mut round = |distance: f64| -> Result<()> {
        let other = curve.raw_offset(plane, distance, OffsetCorner::Round, tolerance)?;
        others.extend(other.parts.into_iter().map(|p| p.curve));
        Ok(())
    };
    if corner == OffsetCorner::None {
        round(distance)?;
    }
    let simple = closed && curve_self(curve, fine)?.is_empty();
    // Tips may reach over the curve.
    let far_corners = !raw.caps.is_empty();
    if !simple || far_corners {
        round(-distance)?;
    }
    if !closed {
        for end in [curve.start(), curve.end()] {
            others.push(Circle::new(plane.with_origin(end), distance.abs())?.into());
        }
    }
    let other_boxes: Vec<BoundingBox> = others.iter().map(Curve::bounding_box).collect();
    for (i, j) in near_pairs(&boxes, Some(&other_boxes), fine, &work)? {
        let found = curve_curve(parts[i], &others[j], fine)?;
        work.more(found.visits)?;
        cuts[i].extend(found.crossings.iter().map(|c| c.a));
        cuts[i].extend(found.overlaps.iter().flat_map(|o| [o.a.start, o.a.end]));
    }

    // Cuts and ends by place.
    let mut stops: Vec<Vec<(f64, usize)>> = Vec::with_capacity(parts.len());
    let mut places: Vec<Point3> = Vec::new();
    for (part, cuts) in parts.iter().zip(cuts) {
        let domain = part.domain();
        let mut stop: Vec<(f64, usize)> = cuts
            .into_iter()
            .filter(|&t| domain.start < t && t < domain.end)
            .chain([domain.start, domain.end])
            .map(|t| (t, 0))
            .collect();
        stop.sort_by(|x, y| x.0.total_cmp(&y.0));
        for (t, place) in &mut stop {
            *place = places.len();
            places.push(part.point_at(*t));
        }
        stops.push(stop);
    }
    let mut sets = Sets::new(places.len());
    gather(&mut sets, &places, epsilon);

    let validity = Validity::new(curve, &raw.caps, plane, distance, epsilon);
    let blur = if exact { epsilon } else { 2.0 * tolerance.absolute };
    let mut edges = Vec::new();
    for (i, part) in raw.parts.iter().enumerate() {
        let near = CUT_PARAMETER * part.curve.domain().length();
        for w in stops[i].windows(2) {
            let range = Interval::new(w[0].0, w[1].0);
            if range.length() <= near {
                sets.join(w[0].1, w[1].1);
            } else if !void[i].iter().any(|v| v.contains(range.middle())) {
                let ends = [w[0].1, w[1].1];
                valid_stretches(&validity, part, i, (range, ends), (epsilon, blur), &mut sets, &mut edges)?;
            }
        }
    }
    if simple && far_corners {
        let mut own = Vec::with_capacity(edges.len());
        for e in edges {
            if validity.on_own_side(curve, parts[e.part].point_at(e.range.middle()))? {
                own.push(e);
            }
        }
        edges = own;
    }
    let (gap, least) = if exact {
        (2.0 * epsilon, 8.0 * epsilon)
    } else {
        ((2.0 * tolerance.absolute).max(2.0 * epsilon), 3.0 * tolerance.absolute)
    };
    // So far two stretches may run on beyond their crossing before rounding sees it.
    let stub = 4.0 * (0.01 * epsilon * size).sqrt();
    let border = Border { parts: &raw.parts, edges, sets, plane, side: distance.signum(), gap, stub };
    let mut chains = border.chains(least)?;
    if matches!(corner, OffsetCorner::Chamfer | OffsetCorner::Smooth) {
        Restyle { source: curve, raw, distance, tolerance: tolerance.absolute, epsilon, corner }
            .apply(&mut chains)?;
    }
    Ok(chains.into_iter().map(|c| c.into_curve(NO_GAP * gap)).collect())
}

/// The pairs of boxes that come within reach of each other.
pub(super) fn near_pairs(
    first: &[BoundingBox],
    second: Option<&[BoundingBox]>,
    reach: f64,
    work: &Work,
) -> Result<Vec<(usize, usize)>> {
    let most = usize::try_from(work.pairs).unwrap_or(usize::MAX);
    crate::box_pairs::near_pairs(first, second, reach, most).ok_or_else(too_much)
}

/// A stretch between cuts is valid or not as a whole. Cuts through approximated parts are off by the tolerance, so
/// that samples next to them may say otherwise: then most samples decide, or where the stretch is out of place by
/// more than the blur, the change is found by halving.
fn valid_stretches(
    validity: &Validity<'_>,
    part: &RawPart,
    index: usize,
    (range, ends): (Interval, [usize; 2]),
    (epsilon, blur): (f64, f64),
    sets: &mut Sets,
    edges: &mut Vec<Edge>,
) -> Result<()> {
    let mut samples = [(0.0, 0.0); SAMPLES as usize + 1];
    for (k, sample) in samples.iter_mut().enumerate() {
        let t = range.at((k as f64 + 0.5) / f64::from(SAMPLES + 1));
        *sample = (t, validity.margin(part, t)?);
    }
    let good = |margin: f64| margin >= -0.01 * epsilon;
    let count = samples.iter().filter(|s| good(s.1)).count();
    let worst = samples.iter().map(|s| s.1).fold(0.0, f64::min);
    let mut keep =
        |range: Interval, from: usize, to: usize| edges.push(Edge { part: index, range, from, to });
    if count == 0 {
        return Ok(());
    }
    if worst >= -blur {
        if 2 * count > samples.len() {
            keep(range, ends[0], ends[1]);
        }
        return Ok(());
    }
    let (mut from, mut place) = (range.start, ends[0]);
    for w in samples.windows(2) {
        let (state, next) = (good(w[0].1), good(w[1].1));
        if state == next {
            continue;
        }
        let (mut low, mut high) = (w[0].0, w[1].0);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if good(validity.margin(part, middle)?) == state { low = middle } else { high = middle }
        }
        let cut = sets.add();
        if state && from < low {
            keep(Interval::new(from, low), place, cut);
        }
        (from, place) = (high, cut);
    }
    if samples.last().is_some_and(|s| good(s.1)) && from < range.end {
        keep(Interval::new(from, range.end), place, ends[1]);
    }
    Ok(())
}
