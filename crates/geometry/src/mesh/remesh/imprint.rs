//! Curves laid into a net of triangles, so that edges lie on them.

use super::net::Net;
use crate::box_tree::{BoxTree, bounds_of};
use crate::cancellation::check;
use crate::{Line, Point3, Result, Vector3};

/// Vertices nearer to a curve than this part of an edge come to lie on it.
const SNAP: f64 = 0.3;
/// Vertices on edges that stay only where they are as near as this: they do not move.
const THERE: f64 = 0.02;
/// So far from a vertex, in edges, a curve matters to it.
const REACH: f64 = 2.0;
/// A vertex on a curve is joined to one of so many that follow it there.
const AHEAD: usize = 4;

/// A polyline near a net, with its length up to each segment.
pub(super) struct Course {
    lines: Vec<Line>,
    starts: Vec<f64>,
    tree: BoxTree,
    closed: bool,
}

/// The place of a course nearest to a point.
pub(super) struct Foot {
    pub(super) place: Point3,
    /// The length of the course up to there.
    pub(super) at: f64,
    /// The direction there, not unitized.
    pub(super) along: Vector3,
    /// Whether the course ends there.
    pub(super) end: bool,
}

impl Course {
    /// The course through points; none where they are all in one place.
    pub(super) fn new(points: &[Point3]) -> Option<Self> {
        let lines: Vec<Line> =
            points.windows(2).map(|w| Line::new(w[0], w[1])).filter(|l| l.length() > 0.0).collect();
        let (first, last) = (lines.first()?, lines.last()?);
        let closed = lines.len() > 2 && first.from.coincides(last.to);
        let mut starts = Vec::with_capacity(lines.len() + 1);
        starts.push(0.0);
        for line in &lines {
            starts.push(starts.last().copied().unwrap_or(0.0) + line.length());
        }
        let boxes: Vec<_> = lines.iter().map(|l| bounds_of([l.from, l.to].map(Into::into))).collect();
        Some(Self { tree: BoxTree::by_place(&boxes), lines, starts, closed })
    }

    pub(super) fn lines(&self) -> &[Line] {
        &self.lines
    }

    fn length(&self) -> f64 {
        self.starts.last().copied().unwrap_or(0.0)
    }

    /// How far two places are apart along the course.
    pub(super) fn apart(&self, a: f64, b: f64) -> f64 {
        let d = (a - b).abs();
        if self.closed { d.min(self.length() - d) } else { d }
    }

    /// The nearest place within a distance.
    pub(super) fn foot(&self, p: Point3, within: f64) -> Option<Foot> {
        let mut best: (f64, Option<(usize, f64)>) = (within * within, None);
        self.tree.visit_near(&p.into(), within * within, |i| {
            if let Some(line) = self.lines.get(i) {
                let t = line.closest_parameter(p).clamp(0.0, 1.0);
                let d = (line.at(t) - p).length_squared();
                if d < best.0 {
                    best = (d, Some((i, t)));
                }
            }
            best.0
        });
        let (i, t) = best.1?;
        let (line, start) = (self.lines.get(i)?, self.starts.get(i)?);
        let own = line.direction();
        // At a corner the side that a point lies on is told by the mean direction.
        let beside = match (t <= 0.0, t >= 1.0) {
            (true, _) => self.neighbour(i, false),
            (_, true) => self.neighbour(i, true),
            _ => Some(own),
        };
        let unit = |v: Vector3| v.unitized().unwrap_or(v);
        let along = beside.map_or(own, |other| unit(own) + unit(other));
        Some(Foot { place: line.at(t), at: start + t * line.length(), along, end: beside.is_none() })
    }

    /// The direction of the segment before or after one.
    fn neighbour(&self, i: usize, after: bool) -> Option<Vector3> {
        let n = self.lines.len();
        let other = match (after, i) {
            (true, i) if i + 1 < n => i + 1,
            (false, i) if i > 0 => i - 1,
            (true, _) if self.closed => 0,
            (false, _) if self.closed => n - 1,
            _ => return None,
        };
        self.lines.get(other).map(Line::direction)
    }
}

/// What a course is to a vertex.
#[derive(Clone, Copy)]
enum Side {
    /// It lies on it, so far along.
    On(f64),
    /// It lies so far to the left, beside a place so far along.
    Left(f64, f64),
}

/// Lays a course into a net: vertices near it are moved onto it, edges that cross it are split there, and the edges
/// along it stay from then on. `length` is that of the edges.
///
/// # Errors
/// Nobody waits any more.
pub(super) fn imprint(net: &mut Net, course: &Course, length: impl Fn(Point3) -> f64) -> Result<()> {
    let mut sides: Vec<Option<Side>> = vec![None; net.vertex_count()];
    for v in net.vertices() {
        check()?;
        let p = net.at(v);
        let edge = length(p);
        let Some(foot) = course.foot(p, REACH * edge) else { continue };
        let distance = foot.place.distance_to(p);
        let free = net.kept_neighbours(v).is_empty();
        let near = distance <= if free { SNAP } else { THERE } * edge;
        let side = if near && (!free || net.move_to(v, foot.place)) {
            Some(Side::On(foot.at))
        } else {
            let left = net.normal_at(v).cross(foot.along).unitized();
            left.filter(|_| !foot.end).map(|left| Side::Left(left.dot(p - foot.place), foot.at))
        };
        if let Some(slot) = sides.get_mut(v as usize) {
            *slot = side;
        }
    }
    for [a, b] in net.edges() {
        check()?;
        let side = |v: u32| sides.get(v as usize).copied().flatten();
        let (Some(Side::Left(d, s)), Some(Side::Left(e, t))) = (side(a), side(b)) else { continue };
        let edge = length(net.at(a));
        if d * e >= 0.0 || course.apart(s, t) > 2.0 * REACH * edge {
            continue;
        }
        let between = net.at(a).lerp(net.at(b), d / (d - e));
        let Some(foot) = course.foot(between, edge) else { continue };
        // A border or crease keeps its course.
        let place = if net.is_kept(a, b) { between } else { foot.place };
        net.split_at(a, b, place);
        sides.resize(net.vertex_count(), None);
        if let Some(slot) = sides.last_mut() {
            *slot = Some(Side::On(foot.at));
        }
    }
    let mut on: Vec<(f64, u32)> = (sides.iter().zip(0..))
        .filter_map(|(side, v)| match side {
            Some(Side::On(at)) => Some((*at, v)),
            _ => None,
        })
        .collect();
    on.sort_by(|a, b| a.0.total_cmp(&b.0));
    let n = on.len();
    let mut k = 0;
    while k < n {
        let follows = |ahead: usize| {
            let next = k + ahead;
            if next < n { on.get(next) } else { on.get(next - n).filter(|_| course.closed) }
        };
        let found = (1..=AHEAD.min(n.saturating_sub(1))).find(|&ahead| {
            let (Some(a), Some(b)) = (on.get(k), follows(ahead)) else { return false };
            !net.sides(a.1, b.1).is_empty()
        });
        if let Some((a, b)) = found.and_then(|ahead| Some((on.get(k)?.1, follows(ahead)?.1))) {
            net.keep(a, b);
        }
        k += found.unwrap_or(1);
    }
    Ok(())
}
