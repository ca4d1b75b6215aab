//! Surfaces that are the same one, whatever way their parameters run.

use super::{SurfaceContact, SurfaceContactKind};
use crate::chart::thresholds::{MET, SAME_PARAMETER};
use crate::trace::Pair;
use crate::{Direction, NurbsSurface};

/// The contact over the whole of both surfaces, if the second is the first with its directions reversed or exchanged, or as it
/// is: what overlaps is all, and its border are the sides.
pub(super) fn equal(pair: &Pair<'_>) -> Option<SurfaceContact> {
    let [a, b] = [0, 1].map(|s| pair.charts[s].nurbs());
    // Copies are dear: corners tell most surfaces apart.
    if a.point_count() != b.point_count() || !same_corners(a, b, MET * pair.noise) {
        return None;
    }
    let is_same = [b.clone(), b.transposed()].iter().any(|exchanged| {
        let across = exchanged.reversed(Direction::U);
        [exchanged, &across]
            .iter()
            .any(|c| matches(a, c, pair) || matches(a, &c.reversed(Direction::V), pair))
    });
    if !is_same {
        return None;
    }
    let range = |k: usize| [pair.domain(k).start, pair.domain(k).end];
    // Reversed or not, the middle of the net is the same place, except where knots are not even.
    let at = [pair.domain(0).middle(), pair.domain(1).middle()];
    let point = a.point_at(at[0], at[1]);
    let near = crate::Surface::from(b.clone()).closest_point(point).ok()?;
    Some(SurfaceContact {
        kind: SurfaceContactKind::Overlap,
        point,
        at: [at, [near.u, near.v]],
        gap: near.distance,
        ranges: std::array::from_fn(range),
        curve: None,
        border: Vec::new(),
    })
}

/// Whether each corner of the net of one surface is one of the other.
fn same_corners(a: &NurbsSurface, b: &NurbsSurface, reach: f64) -> bool {
    let corners = |s: &NurbsSurface| {
        let [n, m] = s.counts().map(|c| c - 1);
        [[0, 0], [0, m], [n, 0], [n, m]].map(|[i, j]| s.control_point(i, j))
    };
    let others = corners(b);
    corners(a).into_iter().flatten().all(|p| others.iter().flatten().any(|q| p.distance_to(*q) <= reach))
}

/// Whether control points and knots agree, the latter as shares of the domains.
fn matches(a: &NurbsSurface, b: &NurbsSurface, pair: &Pair<'_>) -> bool {
    let reach = MET * pair.noise;
    let same_points = a.homogeneous_points().iter().zip(&b.homogeneous_points()).all(|(p, q)| {
        (p[3] - q[3]).abs() <= MET * f64::EPSILON * p[3]
            && (0..3).all(|k| (p[k] - q[k]).abs() <= reach * p[3])
    });
    a.degrees() == b.degrees()
        && same_points
        && Direction::BOTH.iter().all(|&d| {
            let (own, other) = (a.knots(d), b.knots(d));
            let (from, to) = (a.domain(d), b.domain(d));
            let near =
                |(s, t): (&f64, &f64)| (from.normalized(*s) - to.normalized(*t)).abs() <= SAME_PARAMETER;
            own.len() == other.len() && own.iter().zip(other).all(near)
        })
}
