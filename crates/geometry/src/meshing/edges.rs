//! The points along an edge that all its faces share.

use crate::meshing::thresholds::{BOUND_SLACK, SAME_STOP};
use crate::thresholds;
use std::f64::consts::FRAC_PI_2;

use super::grid::Grid;
use super::settings::Limits;
use super::track::Track;
use crate::{Point2, Point3};

/// Most points of an edge.
const MOST: usize = 1_000_000;
/// What an edge may take of the distance where its faces' cells do not keep to it.
const SHARE: f64 = 0.5;

/// A trim that runs along an edge, in the edge's sense.
pub(super) struct Use<'a> {
    /// The trim's place in the brep.
    pub(super) trim: usize,
    /// The trim on its surface; none when the edge has no curve of its own and is this.
    pub(super) track: Track<'a>,
    /// The cells of its face.
    pub(super) grid: &'a Grid,
    /// The direction that stays constant along it, and its value.
    pub(super) aligned: Option<(usize, f64)>,
    /// Places of the trim where its face wants points, with their exact parameters.
    pub(super) wanted: Vec<(f64, Point2)>,
}

/// The points of an edge, its ends among them.
pub(super) struct EdgePoints {
    /// The points there.
    pub(super) points: Vec<Point3>,
    /// For every use its trim and the parameters of the points, in the edge's sense.
    pub(super) uses: Vec<(usize, Vec<Point2>)>,
}

/// A segment of more than this share of an edge may come by one point twice.
const LONG: f64 = 0.1;

/// One point to be.
struct Stop {
    place: f64,
    /// For every use its place and parameters.
    on: Vec<(f64, Point2)>,
}

/// The points along an edge: where its pieces meet, where its faces want some, and as many between as the limits ask
/// for. `finer` halves every segment so many times more.
pub(super) fn points_along(edge: &Track<'_>, uses: &[Use<'_>], limits: &Limits, finer: u32) -> EdgePoints {
    let mut stops = first_stops(edge, uses);
    let mut done: Vec<Stop> = Vec::new();
    // From the front on: what has to be halved gets its middle before it is looked at again.
    stops.reverse();
    let mut depth = vec![0_u32; stops.len()];
    while let Some(stop) = stops.pop() {
        let level = depth.pop().unwrap_or(0);
        if let Some(last) = done.last()
            && level < 40
            && done.len() + stops.len() < MOST
            && (level < finer || is_coarse(edge, uses, last, &stop, limits))
            && let Some(middle) = between(edge, uses, last, &stop)
        {
            stops.extend([stop, middle]);
            depth.extend([level + 1, level + 1]);
            continue;
        }
        done.push(stop);
    }
    let uses = uses
        .iter()
        .enumerate()
        .map(|(k, u)| (u.trim, done.iter().filter_map(|s| s.on.get(k).map(|x| x.1)).collect()))
        .collect();
    EdgePoints { points: done.iter().map(|s| edge.point(s.place)).collect(), uses }
}

/// The ends, the joints and what is wanted.
fn first_stops(edge: &Track<'_>, uses: &[Use<'_>]) -> Vec<Stop> {
    let place = |x: f64| -> Vec<(f64, Point2)> {
        uses.iter()
            .map(|u| {
                let y = if x <= 0.0 || x >= 1.0 { x } else { u.track.nearest(edge.point(x), edge.share(x)) };
                (y, u.snapped(y))
            })
            .collect()
    };
    let mut stops: Vec<Stop> = edge.corners().into_iter().map(|x| Stop { place: x, on: place(x) }).collect();
    for (k, u) in uses.iter().enumerate() {
        for &(y, uv) in &u.wanted {
            let x = edge.nearest(u.track.point(y), u.track.share(y));
            if !(x > thresholds::SAME_PARAMETER && x < 1.0 - thresholds::SAME_PARAMETER) {
                continue;
            }
            let mut on = place(x);
            if let Some(slot) = on.get_mut(k) {
                *slot = (y, uv);
            }
            stops.push(Stop { place: x, on });
        }
    }
    stops.sort_by(|a, b| a.place.total_cmp(&b.place));
    // What two faces, or a joint and a face, want in one place is one stop; a wanted place beats one found.
    let mut out: Vec<Stop> = Vec::with_capacity(stops.len());
    for stop in stops {
        match out.last_mut() {
            Some(last) if stop.place - last.place < SAME_STOP => {
                for (k, u) in uses.iter().enumerate() {
                    let exact = |s: &Stop| s.on.get(k).is_some_and(|on| u.wanted.iter().any(|w| w.1 == on.1));
                    if exact(&stop)
                        && !exact(last)
                        && last.place > 0.0
                        && let (Some(slot), Some(on)) = (last.on.get_mut(k), stop.on.get(k))
                    {
                        *slot = *on;
                    }
                }
            }
            _ => out.push(stop),
        }
    }
    if let Some(last) = out.last_mut()
        && last.place < 1.0
    {
        *last = Stop { place: 1.0, on: place(1.0) };
    }
    // Along every trim in order too: what is not, goes between its neighbours.
    for k in 0..uses.len() {
        for i in 1..out.len().saturating_sub(1) {
            let at = |i: usize| out.get(i).and_then(|s| s.on.get(k)).map_or(0.0, |on| on.0);
            let (before, here) = (at(i - 1), at(i));
            let last = out.len() - 1;
            if here <= before || here >= 1.0 {
                let y = before + (1.0 - before) / (last - i + 1) as f64;
                let uv = uses[k].snapped(y);
                if let Some(slot) = out.get_mut(i).and_then(|s| s.on.get_mut(k)) {
                    *slot = (y, uv);
                }
            }
        }
    }
    out
}

impl Use<'_> {
    /// The parameters at a place, exactly on the line that the trim runs along.
    fn snapped(&self, y: f64) -> Point2 {
        let mut uv = self.track.flat(y);
        match self.aligned {
            Some((0, value)) => uv.x = value,
            Some((_, value)) => uv.y = value,
            None => {}
        }
        uv
    }
}

/// The stop half-way between two; none when they are too near to each other.
fn between(edge: &Track<'_>, uses: &[Use<'_>], a: &Stop, b: &Stop) -> Option<Stop> {
    let place = 0.5 * (a.place + b.place);
    if !(place > a.place && place < b.place) {
        return None;
    }
    let p = edge.point(place);
    let share = edge.share(place);
    let is_long = edge.share(b.place) - edge.share(a.place) > LONG;
    let on = uses
        .iter()
        .zip(a.on.iter().zip(&b.on))
        .map(|(u, (a, b))| {
            let wide = b.0 - a.0;
            let y = if is_long {
                u.track.nearest_within(p, share, [a.0, b.0])
            } else {
                u.track.nearest_between(p, a.0 + 0.5 * wide, [a.0, b.0])
            };
            let y = y.clamp(a.0 + 0.05 * wide, b.0 - 0.05 * wide);
            (y, u.snapped(y))
        })
        .collect();
    Some(Stop { place, on })
}

/// Whether the segment between two stops passes a limit.
fn is_coarse(edge: &Track<'_>, uses: &[Use<'_>], a: &Stop, b: &Stop, limits: &Limits) -> bool {
    let jets = edge.jets_between(a.place, b.place);
    let (Some(first), Some(last)) = (jets.first(), jets.last()) else { return false };
    let chord = last[0] - first[0];
    let length = chord.length();
    let legs: f64 = jets.windows(2).map(|w| (w[1][0] - w[0][0]).length()).sum();
    if length.max(legs) > limits.max_edge * (1.0 + thresholds::OVER_LIMIT) {
        return true;
    }
    if legs < 2.0 * limits.short {
        return false;
    }
    let turned = jets.windows(2).filter_map(|w| w[0][1].angle_to(w[1][1])).sum::<f64>();
    // A closed edge in one or two segments encloses nothing.
    if turned > FRAC_PI_2 * 1.01 || length < 0.5 * legs {
        return true;
    }
    if legs < 2.0 * limits.min_edge {
        return false;
    }
    let along = chord.unitized().unwrap_or(first[1]);
    let away = |v: crate::Vector3| (v - along * v.dot(along)).length();
    let wide = b.place - a.place;
    let bent = jets.iter().map(|j| away(j[2])).fold(0.0, f64::max);
    let seen = jets.iter().map(|j| away(j[0] - first[0])).fold(0.0, f64::max);
    if (0.131 * bent * wide * wide).min(4.0 * seen).max(seen) > limits.distance * (1.0 + BOUND_SLACK) {
        return true;
    }
    if turned > limits.angle * (1.0 + BOUND_SLACK) {
        return true;
    }
    uses.iter().zip(a.on.iter().zip(&b.on)).any(|(u, (a, b))| {
        let (p, q) = (a.1, b.1);
        let box_of = |x: f64, y: f64| [x.min(y), x.max(y)];
        let bend = u.grid.bend([box_of(p.x, q.x), box_of(p.y, q.y)]);
        let share = if u.aligned.is_some() { 1.0 + BOUND_SLACK } else { SHARE };
        bend.distance([(q.x - p.x).abs(), (q.y - p.y).abs()]) > share * limits.distance
    })
}
