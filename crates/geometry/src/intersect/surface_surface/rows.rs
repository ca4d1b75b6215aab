//! Curves that go on across seams and lines between pieces, as one.

use crate::chart::Breaks;
use crate::chart::thresholds::{MET, SAME_END, SAME_PARAMETER, SAME_PLACE, SMOOTH};
use crate::trace::{End, Followed, Four, Pair, Place};

/// The places of a whole curve.
pub(super) struct Row {
    pub(super) places: Vec<Place>,
    pub(super) closed: bool,
}

/// The curves joined where one goes on in another: between surfaces that were cut where their speeds leap only where its
/// images go on at the same speed, since one cubic has one.
pub(super) fn joined(pair: &Pair<'_>, followed: Vec<Followed>, breaks: Breaks) -> Vec<Row> {
    let goes_on = |pair: &Pair<'_>, end: &Place, next: &Place| {
        let shift = goes_on(pair, end, next)?;
        (breaks == Breaks::Turns || keeps_speed(end, next)).then_some(shift)
    };
    let mut out = Vec::new();
    let mut open = Vec::new();
    for curve in followed {
        if curve.ends == [End::Closed; 2] {
            out.push(Row { places: curve.places, closed: true });
        } else {
            open.push(Row { places: curve.places, closed: false });
        }
    }
    // Lines between pieces give a curve that runs along them twice.
    let mut rows: Vec<Row> = Vec::new();
    for row in open {
        if !rows.iter().any(|other| is_same(pair, &row, other)) {
            rows.push(row);
        }
    }
    while let Some(mut row) = rows.pop() {
        while let Some(end) = row.places.last().copied() {
            if let Some(first) = row.places.first()
                && row.places.len() > 2
                && goes_on(pair, &end, first).is_some()
            {
                // What ends where it begins does so exactly.
                let start = first.point;
                if let Some(last) = row.places.last_mut() {
                    last.point = start;
                }
                row.closed = true;
                break;
            }
            let next = rows
                .iter()
                .enumerate()
                .find_map(|(i, other)| Some((i, goes_on(pair, &end, other.places.first()?)?)));
            let Some((i, shift)) = next else { break };
            row.places.extend(shifted(&rows.swap_remove(i).places, shift).into_iter().skip(1));
        }
        // What leads to its beginning.
        while !row.closed {
            let Some(start) = row.places.first().copied() else { break };
            let before = rows
                .iter()
                .enumerate()
                .find_map(|(i, other)| Some((i, goes_on(pair, other.places.last()?, &start)?)));
            let Some((i, shift)) = before else { break };
            let mut places = rows.swap_remove(i).places;
            places.extend(shifted(&row.places, shift).into_iter().skip(1));
            row.places = places;
        }
        out.push(row);
    }
    out
}

fn shifted(places: &[Place], shift: Four) -> Vec<Place> {
    places.iter().map(|p| Place { x: std::array::from_fn(|k| p.x[k] + shift[k]), ..*p }).collect()
}

/// Whether the images of a curve go on at the same speed.
fn keeps_speed(end: &Place, next: &Place) -> bool {
    (0..4).all(|k| {
        let (a, b) = (end.velocity[k], next.velocity[k]);
        (a - b).abs() <= SMOOTH * end.velocity.iter().fold(a.abs().max(b.abs()), |m, v| m.max(v.abs()))
    })
}

/// By what the parameters of a curve that begins at `next` are moved to go on from `end`, if it does so smoothly.
fn goes_on(pair: &Pair<'_>, end: &Place, next: &Place) -> Option<Four> {
    let near = (end.point - next.point).length() <= SAME_END * pair.size() + MET * pair.noise;
    if !near || end.tangent.dot(next.tangent) < 1.0 - SMOOTH {
        return None;
    }
    let mut shift = [0.0; 4];
    for s in 0..2 {
        let own = [next.x[2 * s], next.x[2 * s + 1]];
        let to = [end.x[2 * s], end.x[2 * s + 1]];
        let moved = pair.charts[s].unwrapped(own, to);
        for k in 0..2 {
            shift[2 * s + k] = moved[k] - own[k];
            if (moved[k] - to[k]).abs() > SAME_PARAMETER * pair.domain(2 * s + k).length() {
                return None;
            }
        }
    }
    Some(shift)
}

/// Whether two rows are the same curve, by their ends and a place between.
fn is_same(pair: &Pair<'_>, a: &Row, b: &Row) -> bool {
    let near = SAME_PLACE * pair.size();
    let close = |p: Option<&Place>, q: Option<&Place>| {
        p.zip(q).is_some_and(|(p, q)| (p.point - q.point).length() <= near)
    };
    if !(close(a.places.first(), b.places.first()) && close(a.places.last(), b.places.last())) {
        return false;
    }
    let Some(middle) = a.places.get(a.places.len() / 2) else { return false };
    b.places.windows(2).any(|w| {
        let chord = w[1].point - w[0].point;
        let along = (middle.point - w[0].point).dot(chord) / chord.length_squared().max(f64::MIN_POSITIVE);
        let foot = w[0].point + chord * along.clamp(0.0, 1.0);
        (middle.point - foot).length() <= near + 0.05 * chord.length()
    })
}
