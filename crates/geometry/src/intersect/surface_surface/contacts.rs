//! What surfaces do where nothing could be proved: they touch there, or nearly.

use super::{SurfaceContact, SurfaceContactKind};
use crate::trace::{Box4, Four, Pair, on};
use crate::{Point3, Vector3};

/// A group of more boxes than this along its longest side is no point.
const POINT: f64 = 1e-3;

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
    let small = (0..4).all(|k| ranges[k][1] - ranges[k][0] <= POINT * pair.domain(k).length());
    let starts = if small { vec![middle] } else { spread(boxes, group) };
    let nearest: Vec<(f64, Four)> = starts.iter().map(|x| nearest(pair, *x)).collect();
    let (gap, x) = nearest.iter().copied().min_by(|a, b| a.0.total_cmp(&b.0))?;
    let jets = pair.jets(x);
    if gap > tolerance {
        return None;
    }
    let kind = match bends(pair, x) {
        None => SurfaceContactKind::Undecided,
        Some([low, high]) => {
            let flat = 1e-4 * (low.abs() + high.abs()).max(1e-3 / pair.size());
            match (small, low.abs() <= flat, high.abs() <= flat) {
                (true, false, false) if low * high > 0.0 => SurfaceContactKind::Point,
                (true, false, false) => SurfaceContactKind::Crossing,
                (false, true, true) => SurfaceContactKind::Overlap,
                (false, true, false) | (false, false, true) => SurfaceContactKind::Curve,
                _ => SurfaceContactKind::Undecided,
            }
        }
    };
    Some(SurfaceContact {
        kind,
        point: ((jets[0][0] + jets[1][0]) * 0.5).to_point(),
        at: [on(x, 0), on(x, 1)],
        gap,
        ranges,
    })
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
    let mut damping = 1e-3;
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
            if damping > 1e8 {
                break;
            }
        }
    }
    (best, x)
}

/// The two principal values of the difference of both second fundamental forms, in the tangent plane that the surfaces
/// have in common; `None` where they have none.
fn bends(pair: &Pair<'_>, x: Four) -> Option<[f64; 2]> {
    let forms = [0, 1].map(|s| {
        let [_, su, sv, suu, suv, svv] = pair.charts[s].second_jet(on(x, s));
        (su, sv, su.cross(sv).unitized(), [suu, suv, svv])
    });
    let normal = forms[0].2?;
    let other = forms[1].2?;
    if normal.cross(other).length() > 1e-2 {
        return None;
    }
    let e = forms[0].0.unitized()?;
    let f = normal.cross(e);
    let mut difference = [0.0; 3];
    for (s, (su, sv, _, [suu, suv, svv])) in forms.iter().enumerate() {
        let jet = [Vector3::ZERO, *su, *sv];
        let [p, q] = [crate::chart::Chart::lifted(&jet, e)?, crate::chart::Chart::lifted(&jet, f)?];
        let bend = |a: [f64; 2], b: [f64; 2]| {
            (*suu * (a[0] * b[0]) + *suv * (a[0] * b[1] + a[1] * b[0]) + *svv * (a[1] * b[1])).dot(normal)
        };
        let sign = if s == 0 { 1.0 } else { -1.0 };
        for (slot, value) in difference.iter_mut().zip([bend(p, p), bend(p, q), bend(q, q)]) {
            *slot += sign * value;
        }
    }
    let [a, b, c] = difference;
    let (mean, half) = (0.5 * (a + c), (0.5 * (a - c)).hypot(b));
    Some([mean - half, mean + half])
}

/// Drops what was not decided only because a surface has a pole there that a curve runs into or past.
pub(super) fn drop_poles(contacts: &mut Vec<SurfaceContact>, poles: &[Point3], near: f64) {
    contacts.retain(|c| {
        c.kind != SurfaceContactKind::Undecided || !poles.iter().any(|p| p.distance_to(c.point) <= near)
    });
}
