//! The surface that takes the place of an edge: the section of the ball carried along it.
//!
//! Where the ball only moves along a line or turns about an axis the surface is exact: a cylinder, a torus, a plane, a
//! cone. Elsewhere the columns of the section (homogeneous control points) are cubics of class C1 through stations,
//! halved until the surface is within the tolerance of the section between them, in place and in direction.

use katydid_elementary::Elementary;

use super::FilletBlend;
use super::section::{bezier, columns, simplest, slopes};
use super::wedge::{Station, Unknowns, Wedge};
use crate::brep::fillet::thresholds::{BEND_STEP, FORWARD, TANGENT_STEP};
use crate::thresholds;
use crate::{
    Circle, Curve, Direction, Interval, Line, LineCurve, NurbsSurface, Plane, PlaneSurface, Point3, Result,
    RevolutionSurface, SumSurface, Surface, Tolerance, Vector3, Xform,
};

/// Places at which an edge is asked whether its ball only moves or turns.
const PROBES: usize = 17;
/// Up to this part of the size what moves alike is the same.
const SAME: f64 = 1e-9;
/// The most stations, and halvings of one stretch.
const MOST_STATIONS: usize = 3000;
const DEEPEST: u32 = 12;

/// How the ball runs, and by what the place along the edge is told.
enum Course {
    /// Along a line, by length.
    Straight(Vector3),
    /// Round the axis of a circle, by angle.
    Turned(Circle),
    /// Anyhow, by the parameter of the edge.
    Free(Vec<(f64, Unknowns)>),
}

/// A rounded edge: a surface over (w, t), w from 0 to 1 across from the first face to the second, t along the edge.
pub(super) struct Strip<'a> {
    pub wedge: Wedge<'a>,
    pub surface: Surface,
    /// Where the edge itself starts and ends.
    pub ends: Interval,
    blend: FilletBlend,
    course: Course,
    first: Station,
    /// The middle of the edge, along it.
    middle: f64,
}

impl<'a> Strip<'a> {
    /// The strip of an edge; where it is fitted it goes on beyond the ends by the given lengths. `closed` says that it
    /// ends where it starts, `points` at which ends its faces touch, so that it ends in a point.
    pub(super) fn new(
        wedge: Wedge<'a>,
        blend: FilletBlend,
        reach: [f64; 2],
        closed: bool,
        points: [bool; 2],
        tolerance: &Tolerance,
    ) -> Result<Self> {
        let first = wedge.first()?;
        let (course, ends, middle) = match exact_course(&wedge, &first) {
            Some(found) => found,
            None => {
                let domain = wedge.curve.domain();
                (Course::Free(Vec::new()), domain, domain.middle())
            }
        };
        let placeholder = PlaneSurface::new(Plane::XY, Interval::new(0.0, 1.0), Interval::new(0.0, 1.0))?;
        let mut strip = Self { wedge, surface: placeholder.into(), ends, blend, course, first, middle };
        strip.surface = match strip.course {
            Course::Free(_) => strip.fitted(reach, closed, points, tolerance)?,
            _ => strip.exact(ends)?,
        };
        if !matches!(strip.course, Course::Free(_)) {
            strip.check(&strip.first, None)?;
        }
        Ok(strip)
    }

    /// The exact surface over a range along the edge.
    fn exact(&self, range: Interval) -> Result<Surface> {
        let unit = Interval::new(0.0, 1.0);
        match &self.course {
            Course::Straight(way) => {
                let back = Xform::translation(*way * -self.middle);
                if self.blend == FilletBlend::Chamfer {
                    let [a, b] = self.first.contacts.map(|p| back.point(p));
                    let plane = Plane::from_axes(a, b - a, *way)?;
                    let extents = [Interval::new(0.0, a.distance_to(b)), range];
                    return Ok(PlaneSurface::with_domains(plane, extents, [unit, range])?.into());
                }
                let section = bezier(&columns(&self.wedge, &self.first, self.blend))?;
                let section = Curve::from(section).transformed(&back)?;
                let along = |t: f64| Point3::ORIGIN + *way * t;
                let line = LineCurve { line: Line::new(along(range.start), along(range.end)), domain: range };
                Ok(SumSurface::new(section, line.into(), Vector3::ZERO)?.into())
            }
            Course::Turned(circle) => {
                let axis = Line::new(circle.center(), circle.center() + circle.plane.z_axis);
                let back = Xform::rotation(-self.middle, circle.plane.z_axis, circle.center())?;
                let section = simplest(&self.wedge, &self.first, self.blend)?.transformed(&back)?;
                Ok(RevolutionSurface::new(section, axis, range)?.into())
            }
            Course::Free(_) => Ok(self.surface.clone()),
        }
    }

    /// The strip over a range along the edge, no longer than what is needed.
    pub(super) fn over(&self, range: Interval) -> Result<Surface> {
        match self.course {
            Course::Free(_) => {
                let whole = self.surface.domain(Direction::V);
                let slack = thresholds::EXACT_PARAMETER * whole.length();
                let near = |t: f64, end: f64| if (t - end).abs() <= slack { end } else { t };
                let range = Interval::new(near(range.start, whole.start), near(range.end, whole.end));
                if !whole.includes(range, false) {
                    return Err(self.wedge.refused("it ends too obliquely to be followed to its end"));
                }
                if range == whole {
                    Ok(self.surface.clone())
                } else {
                    self.surface.trimmed(Direction::V, range)
                }
            }
            Course::Turned(_) if range.length() > std::f64::consts::TAU * (1.0 + thresholds::WHOLE_TURN) => {
                Err(self.wedge.refused("it would meet itself at its ends"))
            }
            _ => self.exact(range),
        }
    }

    /// Whether the edge's place is the surface's u, and across is v.
    pub(super) fn is_turned(&self) -> bool {
        matches!(self.course, Course::Turned(_))
    }

    /// The parameters on the surface.
    pub(super) fn place(&self, w: f64, t: f64) -> Point3 {
        if self.is_turned() { Point3::new(t, w, 0.0) } else { Point3::new(w, t, 0.0) }
    }

    pub(super) fn point(&self, w: f64, t: f64) -> Point3 {
        let p = self.place(w, t);
        self.surface.point_at(p.x, p.y)
    }

    /// The derivatives by w and by t.
    pub(super) fn partials(&self, w: f64, t: f64) -> [Vector3; 2] {
        let p = self.place(w, t);
        let d = self.surface.derivatives(p.x, p.y, 1, self.surface.inner_quadrant(p.x, p.y));
        if self.is_turned() { [d.get(0, 1), d.get(1, 0)] } else { [d.get(1, 0), d.get(0, 1)] }
    }

    /// The direction in which the edge runs along, if it is straight.
    pub(super) fn straight_way(&self) -> Option<Vector3> {
        match self.course {
            Course::Straight(way) => Some(way),
            _ => None,
        }
    }

    /// The homogeneous control points of the section of a straight strip where t is 0.
    pub(super) fn straight_columns(&self) -> Option<Vec<[f64; 4]>> {
        let way = self.straight_way()?;
        let shift = way * self.middle;
        let moved = |c: [f64; 4]| [c[0] - shift.x * c[3], c[1] - shift.y * c[3], c[2] - shift.z * c[3], c[3]];
        Some(columns(&self.wedge, &self.first, self.blend).into_iter().map(moved).collect())
    }

    /// The ball at a place along the edge.
    pub(super) fn ball(&self, t: f64) -> Option<(Point3, f64)> {
        let first = &self.first;
        match &self.course {
            Course::Straight(way) => Some((first.centre + *way * (t - self.middle), first.radius)),
            Course::Turned(circle) => {
                let turn = Xform::rotation(t - self.middle, circle.plane.z_axis, circle.center()).ok()?;
                Some((turn.point(first.centre), first.radius))
            }
            Course::Free(nodes) => {
                let near = nodes.iter().min_by(|a, b| (a.0 - t).abs().total_cmp(&(b.0 - t).abs()))?;
                self.wedge.station(t, &near.1).map(|s| (s.centre, s.radius))
            }
        }
    }

    /// The place along the edge where the ball has a given centre, near a place.
    pub(super) fn place_of(&self, centre: Point3, near: f64) -> Option<f64> {
        let mut t = near;
        let step = TANGENT_STEP * self.ends.length();
        for _ in 0..30 {
            let here = self.ball(t)?.0;
            let slope = (self.ball(t + step)?.0 - self.ball(t - step)?.0) / (2.0 * step);
            let by = (centre - here).dot(slope) / slope.length_squared();
            if !by.is_finite() {
                return None;
            }
            t += by;
            if by.abs() <= thresholds::NEWTON_DONE * self.ends.length() {
                break;
            }
        }
        Some(t)
    }

    /// A place along the edge, and where the ball touches a face there, in the face's parameter plane.
    pub(super) fn contact_place(&self, side: usize) -> (f64, Point3) {
        let x = &self.first.unknowns;
        (self.middle, Point3::new(x[2 * side], x[2 * side + 1], 0.0))
    }

    /// The control points of the section at an end of the edge, for estimates.
    pub(super) fn hull_at(
        wedge: &Wedge<'_>,
        blend: FilletBlend,
        at_end: bool,
    ) -> Option<(Vec<Point3>, Vector3, Point3)> {
        let first = wedge.first().ok()?;
        let domain = wedge.curve.domain();
        let t = if at_end { domain.end } else { domain.start };
        let station = walked(wedge, &first, domain.middle(), t)?;
        let points = columns(wedge, &station, blend)
            .iter()
            .map(|c| Point3::new(c[0] / c[3], c[1] / c[3], c[2] / c[3]))
            .collect();
        let tangent = wedge.curve.tangent_at(t)?;
        Some((points, if at_end { tangent } else { -tangent }, wedge.curve.point_at(t)))
    }

    /// That the ball fits at a station, and that the rails run on with the edge.
    fn check(&self, station: &Station, slope: Option<(&Unknowns, f64)>) -> Result<()> {
        let wedge = &self.wedge;
        let mut good = wedge.fits(station);
        match &self.course {
            Course::Turned(circle) => {
                let arm = |p: Point3| {
                    let [x, y, _] = circle.plane.coordinates(p);
                    Vector3::new(x, y, 0.0)
                };
                let own = arm(wedge.curve.point_at(wedge.curve.domain().middle()));
                // A rail that passes the axis would run backwards.
                good &= station.contacts.iter().all(|p| arm(*p).dot(own) > FORWARD * own.length_squared());
            }
            Course::Straight(_) => {}
            Course::Free(_) => {
                if let Some((slope, t)) = slope {
                    let step = BEND_STEP * wedge.curve.domain().length();
                    let moved: Unknowns = std::array::from_fn(|k| station.unknowns[k] + step * slope[k]);
                    let [_, velocity] = wedge.curve.jet_at::<2>(t, false);
                    good &= wedge.of(&moved).is_some_and(|next| {
                        (0..2).all(|k| (next.contacts[k] - station.contacts[k]).dot(velocity) > 0.0)
                    });
                }
            }
        }
        if good { Ok(()) } else { Err(wedge.too_large()) }
    }

    /// The surface through stations, halved until it is within the tolerance.
    fn fitted(
        &mut self,
        reach: [f64; 2],
        closed: bool,
        points: [bool; 2],
        tolerance: &Tolerance,
    ) -> Result<Surface> {
        let limit = 0.1 * tolerance.positive_distance()?;
        let wedge = &self.wedge;
        let domain = wedge.curve.domain();
        let speed = |t: f64| wedge.curve.jet_at::<2>(t, t > domain.middle())[1].length();
        let beyond = |length: f64, t: f64| {
            let by = length / speed(t).max(thresholds::LEAST_DIVISOR);
            if by.is_finite() { by.min(domain.length()) } else { 0.0 }
        };
        let whole = Interval::new(
            domain.start - beyond(reach[0], domain.start),
            domain.end + beyond(reach[1], domain.end),
        );
        let mut breaks = vec![whole.start];
        breaks.extend(wedge.curve.smooth_stretches().iter().map(|s| s.start).filter(|t| *t > domain.start));
        breaks.push(whole.end);
        let mut pieces: Vec<[Node; 2]> = Vec::new();
        // From the middle both ways, so that each station has one nearby.
        let mut near = self.first.unknowns;
        let mut starts = Vec::new();
        let middle = domain.middle();
        let too_large = || wedge.too_large();
        let mut behind = self.first;
        let mut at = middle;
        for t in breaks.iter().rev().filter(|t| **t <= middle) {
            behind = match points[0] && *t == whole.start {
                true => tip(wedge, false).map(|node| node.station),
                false => walked(wedge, &behind, at, *t),
            }
            .ok_or_else(too_large)?;
            at = *t;
            starts.push((*t, behind));
        }
        starts.reverse();
        let (mut ahead, mut at) = (self.first, middle);
        for t in breaks.iter().filter(|t| **t > middle) {
            ahead = match points[1] && *t == whole.end {
                true => tip(wedge, true).map(|node| node.station),
                false => walked(wedge, &ahead, at, *t),
            }
            .ok_or_else(too_large)?;
            at = *t;
            starts.push((*t, ahead));
        }
        for pair in starts.windows(2) {
            let [(s, a), (t, b)] = [pair[0], pair[1]];
            let inner = thresholds::SAME_PARAMETER * (t - s);
            let first = match points[0] && s == whole.start {
                true => tip(wedge, false).ok_or_else(too_large)?,
                false => self.node(s, inner, &a)?,
            };
            let last = match points[1] && t == whole.end {
                true => tip(wedge, true).ok_or_else(too_large)?,
                false => self.node(t, -inner, &b)?,
            };
            let mut stack = vec![(first, last, 0)];
            while let Some((a, b, depth)) = stack.pop() {
                crate::cancellation::check()?;
                near.clone_from(&a.station.unknowns);
                if depth > 0 && self.holds(&a, &b, limit, tolerance.angle) {
                    pieces.push([a, b]);
                    continue;
                }
                if depth >= DEEPEST || pieces.len() + stack.len() > MOST_STATIONS {
                    return Err(wedge.refused("its rounding cannot be followed within the tolerance"));
                }
                let m = 0.5 * (a.t + b.t);
                let station = wedge.station(m, &between(&a, &b, 0.5)).ok_or_else(too_large)?;
                let node = self.node(m, 0.0, &station)?;
                stack.push((node.clone(), b, depth + 1));
                stack.push((a, node, depth + 1));
            }
        }
        if closed && let ([first, ..], Some(end)) = (pieces.as_slice(), pieces.len().checked_sub(1)) {
            let (columns, slopes) = (first[0].columns.clone(), first[0].slopes.clone());
            let last = &mut pieces[end][1];
            let gap = last.station.contacts[0].distance_to(first_contact(&columns));
            if gap > tolerance.absolute {
                return Err(wedge.refused("its rounding does not close"));
            }
            (last.columns, last.slopes) = (columns, slopes);
        }
        let nodes = pieces.iter().map(|p| (p[0].t, p[0].station.unknowns));
        let mut nodes: Vec<(f64, Unknowns)> = nodes.collect();
        nodes.extend(pieces.last().map(|p| (p[1].t, p[1].station.unknowns)));
        let surface = lofted(&pieces)?.into();
        self.course = Course::Free(nodes);
        Ok(surface)
    }

    /// A station with the columns of its section and their derivatives; `inner` moves the question off a break.
    fn node(&self, t: f64, inner: f64, station: &Station) -> Result<Node> {
        let wedge = &self.wedge;
        let found = || {
            let slope = wedge.slope(&station.unknowns, t + inner)?;
            Some((slopes(wedge, &station.unknowns, &slope, self.blend)?, slope))
        };
        let (slopes, slope) = found().ok_or_else(|| wedge.too_large())?;
        if wedge.curve.domain().contains(t) {
            self.check(station, Some((&slope, t)))?;
        }
        let columns = columns(wedge, station, self.blend);
        Ok(Node { t, station: *station, slope, columns, slopes })
    }

    /// Whether the cubic columns between two nodes give the section half-way and elsewhere.
    fn holds(&self, a: &Node, b: &Node, limit: f64, angle: f64) -> bool {
        let Ok(piece) = lofted(&[[a.clone(), b.clone()]]).map(Surface::from) else { return false };
        let close = |x: f64| -> Option<bool> {
            let t = a.t + x * (b.t - a.t);
            let exact = self.wedge.station(t, &between(a, b, x))?;
            let section = bezier(&columns(&self.wedge, &exact, self.blend)).ok()?;
            let near = [0.0, 0.25, 0.5, 0.75, 1.0]
                .iter()
                .all(|w| section.point_at(*w).distance_to(piece.point_at(*w, t)) <= limit);
            let tangent = self.blend == FilletBlend::Chamfer
                || [0.0, 1.0].iter().zip(exact.arms()).all(|(w, arm)| {
                    let d = piece.derivatives(*w, t, 1, piece.inner_quadrant(*w, t));
                    let normal = d.get(1, 0).cross(d.get(0, 1)).unitized();
                    normal.is_some_and(|n| n.cross(arm).length() <= 0.2 * angle.min(1.0))
                });
            Some(near && tangent)
        };
        [0.25, 0.5, 0.75].iter().all(|x| close(*x) == Some(true))
    }
}

/// A station of a fitted strip.
#[derive(Clone)]
struct Node {
    t: f64,
    station: Station,
    slope: Unknowns,
    columns: Vec<[f64; 4]>,
    slopes: Vec<[f64; 4]>,
}

fn first_contact(columns: &[[f64; 4]]) -> Point3 {
    columns.first().map_or(Point3::ORIGIN, |c| Point3::new(c[0], c[1], c[2]))
}

/// The unknowns between two nodes, by the cubic through both with their derivatives.
fn between(a: &Node, b: &Node, x: f64) -> Unknowns {
    let h = b.t - a.t;
    let (s, y) = (x * x * (3.0 - 2.0 * x), 1.0 - x);
    std::array::from_fn(|k| {
        let (p, q) = (a.station.unknowns[k], b.station.unknowns[k]);
        p + s * (q - p) + h * (x * y * y * a.slope[k] - x * x * y * b.slope[k])
    })
}

/// The end of an edge where its faces touch each other, and the ball both in the vertex: the slopes are those of the
/// polynomial of degree 4 through stations before it. (Only for arcs.)
fn tip(wedge: &Wedge<'_>, at_end: bool) -> Option<Node> {
    const WEIGHTS: [f64; 5] = [-25.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -0.25];
    let domain = wedge.curve.domain();
    let (t, step) = if at_end { (domain.end, -0.01) } else { (domain.start, 0.01) };
    let step = step * domain.length();
    let station = wedge.touching(t)?;
    let columns = columns(wedge, &station, FilletBlend::Arc);
    let mut slope = station.unknowns.map(|x| x * WEIGHTS[0] / step);
    let mut slopes: Vec<[f64; 4]> = columns.iter().map(|c| c.map(|x| x * WEIGHTS[0] / step)).collect();
    let (mut near, mut at) = (wedge.first().ok()?, domain.middle());
    for n in (1..WEIGHTS.len()).rev() {
        let to = t + step * n as f64;
        near = walked(wedge, &near, at, to)?;
        at = to;
        let weight = WEIGHTS[n] / step;
        (0..slope.len()).for_each(|k| slope[k] += weight * near.unknowns[k]);
        for (sum, column) in slopes.iter_mut().zip(self::columns(wedge, &near, FilletBlend::Arc)) {
            (0..4).for_each(|k| sum[k] += weight * column[k]);
        }
    }
    Some(Node { t, station, slope, columns, slopes })
}

/// The station at an end of an edge.
pub(super) fn at_end(wedge: &Wedge<'_>, at_end: bool) -> Option<Station> {
    let domain = wedge.curve.domain();
    walked(wedge, &wedge.first().ok()?, domain.middle(), if at_end { domain.end } else { domain.start })
}

/// The station at a parameter, walked to from another one.
fn walked(wedge: &Wedge<'_>, from: &Station, s: f64, t: f64) -> Option<Station> {
    const STEPS: u32 = 16;
    let mut here = *from;
    let step = (t - s) / f64::from(STEPS);
    for k in 1..=STEPS {
        let at = if k == STEPS { t } else { s + step * f64::from(k) };
        let guess = match wedge.slope(&here.unknowns, at - step) {
            Some(slope) => std::array::from_fn(|n| here.unknowns[n] + step * slope[n]),
            None => here.unknowns,
        };
        here = wedge.station(at, &guess).or_else(|| wedge.station(at, &here.unknowns))?;
    }
    Some(here)
}

/// The surface whose columns are cubics through nodes with their derivatives, with one point of control less wherever
/// two pieces share a node and its derivative.
fn lofted(pieces: &[[Node; 2]]) -> Result<NurbsSurface> {
    let across = pieces.first().map_or(0, |p| p[0].columns.len());
    let moved = |c: &[f64; 4], s: &[f64; 4], h: f64| -> [f64; 4] { std::array::from_fn(|k| c[k] + h * s[k]) };
    let mut rows: Vec<Vec<[f64; 4]>> = Vec::new();
    let mut knots: Vec<f64> = Vec::new();
    for (n, [a, b]) in pieces.iter().enumerate() {
        let h = (b.t - a.t) / 3.0;
        if n == 0 {
            knots.extend([a.t; 3]);
            rows.push(a.columns.clone());
        }
        let row = |node: &Node, h: f64| -> Vec<[f64; 4]> {
            node.columns.iter().zip(&node.slopes).map(|(c, s)| moved(c, s, h)).collect()
        };
        rows.push(row(a, h));
        rows.push(row(b, -h));
        let smooth = pieces.get(n + 1).is_some_and(|[next, _]| next.slopes == b.slopes);
        if n + 1 == pieces.len() {
            knots.extend([b.t; 3]);
            rows.push(b.columns.clone());
        } else if smooth {
            knots.extend([b.t; 2]);
        } else {
            knots.extend([b.t; 3]);
            rows.push(b.columns.clone());
        }
    }
    let degree = across.saturating_sub(1);
    let counts = [across, rows.len()];
    let points = (0..across).flat_map(|i| rows.iter().map(move |row| row[i]));
    let points: Vec<[f64; 4]> = points.collect();
    let own = [vec![0.0; degree], vec![1.0; degree]].concat();
    if points.iter().all(|p| p[3] == 1.0) {
        let plain: Vec<Point3> = points.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect();
        return NurbsSurface::new([degree, 3], counts, plain, [own, knots]);
    }
    NurbsSurface::rational([degree, 3], counts, points, [own, knots])
}

/// The line or circle along which the ball is carried without change, with the range along the edge and its middle.
fn exact_course(wedge: &Wedge<'_>, first: &Station) -> Option<(Course, Interval, f64)> {
    if !wedge.radius.is_constant() {
        return None;
    }
    let domain = wedge.curve.domain();
    let same = SAME * wedge.size;
    let middle = wedge.curve.point_at(domain.middle());
    let holds = |map: &dyn Fn(Point3) -> Option<Xform>| -> bool {
        let mut near = [first.unknowns; 2];
        (0..PROBES).all(|n| {
            // From the middle outwards, on both sides in turn.
            let x = (n / 2 + 1) as f64 / (PROBES / 2 + 1) as f64;
            let t = domain.at(0.5 + if n % 2 == 0 { 0.5 * x } else { -0.5 * x });
            let Some(map) = map(wedge.curve.point_at(t)) else { return false };
            let Some(station) = wedge.station(t, &near[n % 2]) else { return false };
            near[n % 2] = station.unknowns;
            let carried = |p: Point3, q: Point3| map.point(p).distance_to(q) <= same;
            carried(first.centre, station.centre)
                && (0..2).all(|k| carried(first.contacts[k], station.contacts[k]))
        })
    };
    if let Some(line) = wedge.curve.as_line(same) {
        let way = line.unit_direction()?;
        let length = line.length();
        let by = |p: Point3| Some(Xform::translation(p - middle));
        let at = (middle - line.from).dot(way);
        return holds(&by).then_some((Course::Straight(way), Interval::new(0.0, length), at));
    }
    let arc = wedge.curve.as_arc(same)?;
    let circle = arc.circle;
    let (start, turn) = (arc.angle.start, std::f64::consts::TAU);
    let total = arc.angle.length();
    if !(total > 0.0) {
        return None;
    }
    let angle = |p: Point3| {
        let [x, y, _] = circle.plane.coordinates(p);
        let angle = y.arctangent_of(x) - start;
        angle - (angle / turn).floor() * turn
    };
    let own = angle(middle);
    let by = |p: Point3| Xform::rotation(angle(p) - own, circle.plane.z_axis, circle.center()).ok();
    holds(&by).then_some((Course::Turned(circle), Interval::new(0.0, total), own))
}
