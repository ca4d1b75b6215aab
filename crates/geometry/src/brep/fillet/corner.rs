//! The patch where rounded edges of one radius meet: a part of the ball that touches all of their faces, or a flat facet
//! where edges are cut off straight.

use katydid_elementary::Elementary;

use super::FilletBlend;
use crate::brep::fillet::thresholds::FROM_POLE;
use crate::brep::{Along, Builder, LoopKind, NewEdge, NewVertex, Path};
use crate::thresholds;
use crate::{
    Circle, Curve, Error, Interval, Line, LineCurve, Plane, PlaneSurface, Point3, Result, RevolutionSurface,
    Surface, Tolerance, Vector3,
};

/// A side of the patch.
pub(super) struct Arc {
    pub edge: NewEdge,
    pub space: Curve,
    pub ends: [(NewVertex, Point3); 2],
}

/// Adds the face within three or more arcs of a ball; `outward` says whether its normal points away from the centre.
pub(super) fn add(
    builder: &mut Builder,
    arcs: &[Arc],
    centre: Point3,
    radius: f64,
    outward: bool,
    blend: FilletBlend,
    tolerance: &Tolerance,
) -> Result<()> {
    let walk = in_turn(arcs).ok_or(Error::degenerate("fillet", "its arcs at a corner do not meet"))?;
    let corners: Vec<Point3> = walk.iter().map(|(arc, back)| arc.ends[usize::from(*back)].1).collect();
    let &[a, b, c, ref more @ ..] = corners.as_slice() else {
        return Err(Error::degenerate("fillet", "a corner without three sides"));
    };
    // Seen from outside the ball the corners run counter-clockwise, or the walk goes the other way round.
    let away = newell(&corners).dot(a - centre) > 0.0;
    if blend == FilletBlend::Chamfer {
        let plane = Plane::from_points(a, b, c)?;
        let range = |f: fn([f64; 3]) -> f64| {
            let all = corners.iter().map(|p| f(plane.coordinates(*p)));
            all.fold(Interval::new(0.0, 0.0), Interval::including)
        };
        let surface = PlaneSurface::new(plane, range(|p| p[0]), range(|p| p[1]))?;
        let paths = walk.iter().map(|(arc, back)| {
            let [from, to] = [arc.ends[usize::from(*back)].1, arc.ends[usize::from(!*back)].1];
            let at = |p: Point3| {
                let [u, v] = surface.parameters_of(p);
                Point3::new(u, v, 0.0)
            };
            Path { curve: Line::new(at(from), at(to)).into(), along: Along::Edge(arc.edge, *back) }
        });
        let paths = paths.collect();
        let face = builder.face(surface.into(), away != outward);
        return builder.bound(face, LoopKind::Outer, paths);
    }
    let walk: Vec<(&Arc, bool)> =
        if away { walk } else { walk.into_iter().rev().map(|(arc, back)| (arc, !back)).collect() };
    let starts: Vec<Point3> = walk.iter().map(|(arc, back)| arc.ends[usize::from(*back)].1).collect();
    // Where a corner is square to both others it is the pole, and the side across lies on the equator.
    let arm = |p: Point3| (p - centre) / radius;
    let off = |k: usize| {
        let [p, q, r] = [0, 1, 2].map(|n| arm(starts[(k + n) % 3]));
        p.dot(q).abs().max(p.dot(r).abs())
    };
    let pole = (0..3).find(|k| more.is_empty() && off(*k) <= thresholds::NO_DIRECTION);
    let Some(pole) = pole else { return add_any(builder, &walk, centre, radius, outward, tolerance) };
    // From the pole down to the first, along to the second, up to the pole.
    let sides = [walk[pole], walk[(pole + 1) % 3], walk[(pole + 2) % 3]];
    let [top, first, second] = [starts[pole], starts[(pole + 1) % 3], starts[(pole + 2) % 3]].map(arm);
    let flat = |v: Vector3| (v - top * v.dot(top)).unitized();
    let (Some(x), Some(toward)) = (flat(first), flat(second)) else {
        return Err(Error::degenerate("fillet", "a corner without area"));
    };
    let angle = x.cross(toward).dot(top).arctangent_of(x.dot(toward));
    if !(angle > thresholds::PARALLEL) {
        return Err(Error::degenerate("fillet", "a corner without area"));
    }
    // The meridian through the first corner, turned about the pole; latitudes run along v.
    let half = std::f64::consts::FRAC_PI_2;
    let quarter = Interval::new(0.0, half);
    let arc = crate::Arc::new(Circle::new(Plane::from_axes(centre, x, top)?, radius)?, quarter)?;
    let profile = crate::ArcCurve { arc, domain: quarter };
    let axis = Line::new(centre, centre + top);
    let sphere: Surface = RevolutionSurface::new(profile.into(), axis, Interval::new(0.0, angle))?.into();
    let line = |u0: f64, v0: f64, u1: f64, v1: f64| -> Curve {
        LineCurve::new(Line::new(Point3::new(u0, v0, 0.0), Point3::new(u1, v1, 0.0))).into()
    };
    let pole_vertex = sides[0].0.ends[usize::from(sides[0].1)].0;
    let along = |n: usize| Along::Edge(sides[n].0.edge, sides[n].1);
    let paths = vec![
        Path { curve: line(0.0, half, 0.0, 0.0), along: along(0) },
        Path { curve: line(0.0, 0.0, angle, 0.0), along: along(1) },
        Path { curve: line(angle, 0.0, angle, half), along: along(2) },
        Path { curve: line(angle, half, 0.0, half), along: Along::Point(pole_vertex) },
    ];
    let face = builder.face(sphere, !outward);
    builder.bound(face, LoopKind::Outer, paths)
}

/// Twice the area within corners, as a vector about which they run counter-clockwise.
fn newell(corners: &[Point3]) -> Vector3 {
    let Some(first) = corners.first() else { return Vector3::ZERO };
    let pairs = corners.windows(2).map(|pair| (pair[0] - *first).cross(pair[1] - *first));
    pairs.fold(Vector3::ZERO, |sum, part| sum + part)
}

/// The face within any arcs of a ball, walked counter-clockwise as seen from outside: the poles lie off it, at right angles
/// to its middle.
fn add_any(
    builder: &mut Builder,
    walk: &[(&Arc, bool)],
    centre: Point3,
    radius: f64,
    outward: bool,
    tolerance: &Tolerance,
) -> Result<()> {
    const LOOKS: u32 = 16;
    let none = || Error::degenerate("fillet", "a corner that is larger than half a ball");
    let arms: Vec<Vector3> = walk
        .iter()
        .flat_map(|(arc, _)| {
            (0..=LOOKS)
                .map(|n| arc.space.domain().at(f64::from(n) / f64::from(LOOKS)))
                .map(|t| (arc.space.point_at(t) - centre) / radius)
        })
        .collect();
    let middle = arms.iter().fold(Vector3::ZERO, |sum, arm| sum + *arm).unitized().ok_or_else(none)?;
    let starts: Vec<Point3> = walk.iter().map(|(arc, back)| arc.ends[usize::from(*back)].1).collect();
    let first = (starts[0] - centre).unitized().ok_or_else(none)?;
    let top = middle.cross(first).unitized().ok_or_else(none)?;
    let side = top.cross(middle);
    let (mut longitudes, mut latitudes): (Option<Interval>, Option<Interval>) = (None, None);
    let place = |arm: Vector3| {
        (arm.dot(side).arctangent_of(arm.dot(middle)), arm.dot(top).clamp(-1.0, 1.0).arcsine())
    };
    for arm in arms {
        let (u, v) = place(arm);
        longitudes = Some(longitudes.map_or(Interval::new(u, u), |all| all.including(u)));
        latitudes = Some(latitudes.map_or(Interval::new(v, v), |all| all.including(v)));
    }
    let (Some(longitudes), Some(latitudes)) = (longitudes, latitudes) else { return Err(none()) };
    let margin = 0.05 * (longitudes.length() + latitudes.length());
    let half = std::f64::consts::FRAC_PI_2;
    let low = (latitudes.start - margin).max(-half);
    let high = (latitudes.end + margin).min(half);
    let from = (longitudes.start - margin).max(-std::f64::consts::PI);
    let to = (longitudes.end + margin).min(std::f64::consts::PI);
    if !(longitudes.length() < std::f64::consts::PI
        && latitudes.start > -half + FROM_POLE
        && latitudes.end < half - FROM_POLE)
    {
        return Err(none());
    }
    let x = middle * from.cosine() + side * from.sine();
    let plane = Plane::from_axes(centre, x, top)?;
    let range = Interval::new(low, high);
    let arc = crate::Arc::new(Circle::new(plane, radius)?, range)?;
    let profile = crate::ArcCurve { arc, domain: range };
    let axis = Line::new(centre, centre + top);
    let sphere: Surface = RevolutionSurface::new(profile.into(), axis, Interval::new(0.0, to - from))?.into();
    let fine = Tolerance { absolute: 0.1 * tolerance.absolute, ..*tolerance };
    let mut paths = Vec::with_capacity(walk.len());
    for (n, (arc, back)) in walk.iter().enumerate() {
        let own = if *back { arc.space.reversed() } else { arc.space.clone() };
        let made = sphere.parameter_curve(&own, &fine)?;
        let ends = [starts[n], starts[(n + 1) % starts.len()]].map(|p| {
            let (u, v) = place((p - centre) / radius);
            Point3::new(u - from, v, 0.0)
        });
        let curve = crate::brep::with_ends(&made, ends)?;
        paths.push(Path { curve, along: Along::Edge(arc.edge, *back) });
    }
    let face = builder.face(sphere, !outward);
    builder.bound(face, LoopKind::Outer, paths)
}

/// Adds the flat face within straight sides, each walked backwards or not; false if they do not lie in one plane.
pub(super) fn add_facet(builder: &mut Builder, sides: &[(Arc, bool)], limit: f64) -> Result<bool> {
    let start = |(arc, back): &(Arc, bool)| arc.ends[usize::from(*back)];
    let end = |(arc, back): &(Arc, bool)| arc.ends[usize::from(!*back)];
    let Some(mut at) = sides.first() else { return Ok(false) };
    let mut walk = vec![at];
    while walk.len() < sides.len() {
        let Some(next) = sides.iter().find(|side| start(side).0 == end(at).0) else { return Ok(false) };
        walk.push(next);
        at = next;
    }
    if walk.first().is_none_or(|first| start(first).0 != end(at).0) {
        return Ok(false);
    }
    let corners: Vec<Point3> = walk.iter().map(|side| start(side).1).collect();
    let Ok(plane) = Plane::from_normal(corners[0], newell(&corners)) else { return Ok(false) };
    if corners.iter().any(|p| plane.coordinates(*p)[2].abs() > 0.5 * limit) {
        return Ok(false);
    }
    let range = |k: usize| {
        let all = corners.iter().map(|p| plane.coordinates(*p)[k]);
        all.fold(Interval::new(0.0, 0.0), Interval::including)
    };
    let surface = PlaneSurface::new(plane, range(0), range(1))?;
    let flat = |p: Point3| {
        let [u, v] = surface.parameters_of(p);
        Point3::new(u, v, 0.0)
    };
    let path = |side: &&(Arc, bool)| Path {
        curve: Line::new(flat(start(side).1), flat(end(side).1)).into(),
        along: Along::Edge(side.0.edge, side.1),
    };
    let paths = walk.iter().map(path).collect();
    let face = builder.face(surface.into(), false);
    builder.bound(face, LoopKind::Outer, paths)?;
    Ok(true)
}

/// The arcs one after the other, and whether each is walked backwards.
fn in_turn(arcs: &[Arc]) -> Option<Vec<(&Arc, bool)>> {
    let first = arcs.first()?;
    let mut out = vec![(first, false)];
    let mut at = first.ends[1].0;
    while out.len() < arcs.len() {
        let next = arcs.iter().find_map(|arc| {
            if out.iter().any(|(used, _)| used.edge == arc.edge) {
                return None;
            }
            if arc.ends[0].0 == at {
                return Some((arc, false));
            }
            (arc.ends[1].0 == at).then_some((arc, true))
        })?;
        at = next.0.ends[usize::from(!next.1)].0;
        out.push(next);
    }
    (at == first.ends[0].0).then_some(out)
}
