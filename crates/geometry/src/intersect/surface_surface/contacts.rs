//! What surfaces do where nothing could be proved: they touch there, or nearly.

use super::touch::{Bends, bends, touching};
use super::{SurfaceContact, SurfaceContactKind};
use crate::Point3;
use crate::chart::thresholds::{CLUSTER, MOST_DAMPING, NEAREST_DAMPING, POINT};
use crate::trace::{Box4, Four, Pair, on};

/// The contacts that undecided boxes of parameters belong to.
pub(super) fn contacts(pair: &Pair<'_>, undecided: &[Box4], tolerance: f64) -> Vec<SurfaceContact> {
    let grown: Vec<Box4> = undecided.iter().map(|b| pair.grown(*b, 0.1)).collect();
    groups(&grown).iter().filter_map(|group| contact(pair, &grown, group, tolerance)).collect()
}

/// The boxes that hang together, each group in order.
fn groups(boxes: &[Box4]) -> Vec<Vec<usize>> {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by(|i, j| boxes[*i][0][0].total_cmp(&boxes[*j][0][0]));
    let mut parents: Vec<usize> = (0..boxes.len()).collect();
    for (place, &i) in order.iter().enumerate() {
        for &j in &order[place + 1..] {
            if boxes[j][0][0] > boxes[i][0][1] {
                break;
            }
            if (1..4).all(|k| boxes[i][k][0] <= boxes[j][k][1] && boxes[j][k][0] <= boxes[i][k][1]) {
                let (a, b) = (root(&mut parents, i), root(&mut parents, j));
                parents[a.max(b)] = a.min(b);
            }
        }
    }
    let mut out: Vec<Vec<usize>> = vec![Vec::new(); boxes.len()];
    for i in 0..boxes.len() {
        let first = root(&mut parents, i);
        out[first].push(i);
    }
    out.retain(|group| !group.is_empty());
    out
}

/// The first of the boxes that one hangs together with, with the ways there made short.
fn root(parents: &mut [usize], mut i: usize) -> usize {
    while parents[i] != i {
        parents[i] = parents[parents[i]];
        i = parents[i];
    }
    i
}

/// What a group is; `None` when the surfaces keep further apart than the tolerance there.
fn contact(pair: &Pair<'_>, boxes: &[Box4], group: &[usize], tolerance: f64) -> Option<SurfaceContact> {
    let ranges: Box4 =
        group.iter().filter_map(|i| boxes.get(*i)).fold([[f64::INFINITY, f64::NEG_INFINITY]; 4], |all, b| {
            std::array::from_fn(|k| [all[k][0].min(b[k][0]), all[k][1].max(b[k][1])])
        });
    let middle: Four = ranges.map(|[a, b]| 0.5 * (a + b));
    let length = (0..4).map(|k| (ranges[k][1] - ranges[k][0]) / pair.domain(k).length()).fold(0.0, f64::max);
    let starts = if length <= POINT { vec![middle] } else { spread(boxes, group) };
    let nearest: Vec<(f64, Four)> = starts.iter().map(|x| nearest(pair, *x)).collect();
    let (gap, x) = nearest.iter().copied().min_by(|a, b| a.0.total_cmp(&b.0))?;
    if gap > tolerance {
        return None;
    }
    // The distance is flat around a tangent place: the tangent planes tell where it is to all digits.
    let exact = touching(pair, x, None).filter(|y| {
        let jets = pair.jets(*y);
        let there = (jets[0][0] - jets[1][0]).length();
        let moved = (pair.jets(x)[0][0] - jets[0][0]).length();
        pair.beyond(*y).iter().all(Option::is_none) && there <= tolerance && moved <= CLUSTER * pair.size()
    });
    let x = exact.map_or(x, |y| pair.clamped(y));
    let jets = pair.jets(x);
    let gap = (jets[0][0] - jets[1][0]).length();
    let kind = match bends(pair, x) {
        None => SurfaceContactKind::Undecided,
        Some(bends) => kind(&bends, bends.flat(pair.size()), length),
    };
    Some(SurfaceContact {
        kind,
        point: ((jets[0][0] + jets[1][0]) * 0.5).to_point(),
        at: [on(x, 0), on(x, 1)],
        gap,
        ranges,
        curve: None,
        border: Vec::new(),
    })
}

/// What the difference of the second fundamental forms says of a contact: it bends the same way in all directions, both ways,
/// in one direction only, or not at all (Dupin's indicatrix of the difference). `length` is that of the group, as a part of
/// the domains.
fn kind(bends: &Bends, flat: f64, length: f64) -> SurfaceContactKind {
    let [low, high] = bends.values;
    match [low, high].map(|x| x.abs() <= flat) {
        [false, false] if length > CLUSTER => SurfaceContactKind::Undecided,
        [false, false] if low * high > 0.0 => SurfaceContactKind::Point,
        [false, false] => SurfaceContactKind::Crossing,
        _ if length <= POINT => SurfaceContactKind::Undecided,
        [true, true] => SurfaceContactKind::Overlap,
        _ => SurfaceContactKind::Curve,
    }
}

/// The middles of some boxes of a group, evenly by their order.
fn spread(boxes: &[Box4], group: &[usize]) -> Vec<Four> {
    let step = group.len().div_ceil(8).max(1);
    group.iter().step_by(step).filter_map(|i| boxes.get(*i)).map(|b| b.map(|[a, b]| 0.5 * (a + b))).collect()
}

/// The place near `x` where the way from one surface to the other is square to both, and the distance there: Gauss and
/// Newton's method on the distance, with a damping term that keeps steps short where the surfaces are parallel.
fn nearest(pair: &Pair<'_>, x: Four) -> (f64, Four) {
    let distance = |x: Four| {
        let jets = pair.jets(x);
        (jets[0][0] - jets[1][0]).length()
    };
    let (mut x, mut best) = (x, distance(x));
    let mut damping = NEAREST_DAMPING;
    for _ in 0..60 {
        let jets = pair.jets(x);
        let away = jets[0][0] - jets[1][0];
        let columns = [jets[0][1], jets[0][2], -jets[1][1], -jets[1][2]];
        let mut m = [[0.0; 5]; 4];
        for i in 0..4 {
            for j in 0..4 {
                m[i][j] = columns[i].dot(columns[j]);
            }
            m[i][i] *= 1.0 + damping;
            m[i][4] = -columns[i].dot(away);
        }
        let Some(step) = crate::trace::solved(m) else { break };
        let next = pair.clamped(std::array::from_fn(|k| x[k] + step[k]));
        let there = distance(next);
        if there < best {
            let gain = best - there;
            (x, best, damping) = (next, there, damping * 0.2);
            if gain <= pair.noise {
                break;
            }
        } else {
            damping *= 8.0;
            if damping > MOST_DAMPING {
                break;
            }
        }
    }
    (best, x)
}

/// Drops what was not decided only because a surface has a pole there that a curve runs into or past.
pub(super) fn drop_poles(contacts: &mut Vec<SurfaceContact>, poles: &[Point3], near: f64) {
    contacts.retain(|c| {
        c.kind != SurfaceContactKind::Undecided || !poles.iter().any(|p| p.distance_to(c.point) <= near)
    });
}

/// Drops points that were found before: one on a line between pieces, or on a seam, lies in several.
pub(super) fn drop_doubles(contacts: &mut Vec<SurfaceContact>, near: f64) {
    let mut kept: Vec<SurfaceContact> = Vec::with_capacity(contacts.len());
    for contact in contacts.drain(..) {
        let is_point = matches!(contact.kind, SurfaceContactKind::Point | SurfaceContactKind::Crossing);
        let known = |k: &SurfaceContact| k.kind == contact.kind && k.point.distance_to(contact.point) <= near;
        if !(is_point && kept.iter().any(known)) {
            kept.push(contact);
        }
    }
    *contacts = kept;
}
