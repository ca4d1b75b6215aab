//! The curves in which faces of different operands meet.

use super::interferences::{common_points, stops};
use super::operands::{Face, Operands, Place};
use super::refusal::RefusalClass;
use super::thresholds::{AT_CROSSING, CAPTURE, EXACT, PARALLEL, PLACES, ROUNDING, TRACED};
use crate::brep::build::with_ends;
use crate::intersect::{
    Carrier, CarrierMeeting, SurfaceBranch, SurfaceContactKind, carrier_carrier, surface_plane,
    surface_surface,
};
use crate::{BoundingBox, BoxIndex, Curve, Interval, Point3, Result, Surface, Tolerance, cancellation};

/// A curve that two faces' surfaces have in common.
#[derive(Debug)]
pub(super) struct Section {
    pub(super) faces: [usize; 2],
    pub(super) curve: Curve,
    pub(super) bounds: BoundingBox,
    /// How near a vertex must be to lie on it.
    pub(super) reach: f64,
}

/// A piece of a section between two vertices that lies inside both faces.
#[derive(Debug)]
pub(super) struct SectionPiece {
    pub(super) faces: [usize; 2],
    pub(super) curve: Curve,
    pub(super) ends: [usize; 2],
}

/// What the surfaces of two faces have in common.
enum Meeting {
    /// They lie on one surface: the borders of each are drawn on the other.
    Coincident,
    /// Curves, points in which curves cross each other, and points in which one goes on in another.
    Parts(Vec<(Curve, bool)>, Vec<Point3>, Vec<Point3>),
}

/// All section curves of the pairs of faces.
pub(super) fn sections(all: &mut Operands, pairs: &[(usize, usize)]) -> Result<Vec<Section>> {
    let mut out = Vec::new();
    let mut joints: Vec<([usize; 2], Point3)> = Vec::new();
    for &(a, b) in pairs {
        cancellation::check()?;
        let (Some(fa), Some(fb)) = (all.faces.get(a), all.faces.get(b)) else { continue };
        let Meeting::Parts(curves, points, ends) = meeting(all, [a, b], [fa, fb])? else {
            let (place, distance) = gap(all, fa, fb)?;
            all.upon.push(([a, b], place, distance));
            continue;
        };
        joints.extend(ends.into_iter().map(|p| ([a, b], p)));
        let mut crossings = Vec::new();
        for p in points {
            if is_on_both(all, [fa, fb], p)? {
                crossings.push(p);
            }
        }
        let common = fa.bounds.inflated(all.limit);
        for (curve, exact) in curves {
            let bounds = curve.bounding_box();
            if bounds.distance_to_box(&common) > 0.0 || bounds.distance_to_box(&fb.bounds) > all.limit {
                continue;
            }
            let reach = if exact { all.limit } else { CAPTURE * all.limit };
            out.push(Section { faces: [a, b], curve, bounds, reach });
        }
        crossings.into_iter().for_each(|p| {
            all.vertices.at(p);
        });
    }
    cross(all, &out)?;
    for ([a, b], p) in joints {
        if all.vertices.known(p).is_none()
            && let (Some(fa), Some(fb)) = (all.faces.get(a), all.faces.get(b))
            && is_on_both(all, [fa, fb], p)?
        {
            all.vertices.at(p);
        }
    }
    Ok(out)
}

/// Whether a point near the surfaces of two faces lies on both faces.
fn is_on_both(all: &Operands, faces: [&Face; 2], p: Point3) -> Result<bool> {
    for face in faces {
        if all.place(face, p, CAPTURE * all.limit)? == Place::Outside {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Places vertices where sections on one face cross each other.
fn cross(all: &mut Operands, sections: &[Section]) -> Result<()> {
    let mut by_face: Vec<Vec<usize>> = vec![Vec::new(); all.faces.len()];
    for (k, section) in sections.iter().enumerate() {
        for face in section.faces {
            by_face.get_mut(face).into_iter().for_each(|list| list.push(k));
        }
    }
    let mut points = Vec::new();
    for list in &by_face {
        let boxes: Vec<BoundingBox> =
            list.iter().filter_map(|k| sections.get(*k)).map(|s| s.bounds).collect();
        let index = BoxIndex::new(&boxes);
        for (i, own) in boxes.iter().enumerate() {
            cancellation::check()?;
            for j in index.near(own, all.limit).into_iter().filter(|j| *j > i) {
                let two = [i, j].map(|k| list.get(k).and_then(|k| sections.get(*k)));
                let [Some(a), Some(b)] = two else { continue };
                // A plane meets the faces of a polyhedron in lines that cross beyond them: most end there.
                common_points(&a.curve, &b.curve, all.limit, &mut points)?;
                for p in points.drain(..) {
                    if all.vertices.known(p).is_some() {
                        continue;
                    }
                    let mut on_all = true;
                    for face in a.faces.iter().chain(&b.faces).filter_map(|f| all.faces.get(*f)) {
                        on_all = on_all && all.place(face, p, CAPTURE * all.limit)? != Place::Outside;
                    }
                    if on_all {
                        all.vertices.at(p);
                    }
                }
            }
        }
    }
    Ok(())
}

/// What two faces' surfaces have in common.
fn meeting(all: &Operands, places: [usize; 2], [a, b]: [&Face; 2]) -> Result<Meeting> {
    let limit = all.limit;
    if let (Some(ca), Some(cb)) = (a.carrier(), b.carrier()) {
        if coincident(all, [a, b], [ca, cb])? {
            return Ok(Meeting::Coincident);
        }
        let size = a.size.min(b.size);
        // Directions that part by less than half the tolerance over both faces are one.
        let exact = Tolerance {
            absolute: (ROUNDING * size).max(0.5 * limit),
            angle: EXACT.max(0.5 * limit / a.size.max(b.size)),
        };
        if let Some(met) = carrier_carrier(ca, cb, &exact) {
            let CarrierMeeting::Parts { curves, points } = met else { return Ok(Meeting::Coincident) };
            let around = a.bounds.inflated(limit).intersection(&b.bounds.inflated(limit));
            let Some(around) = around else { return Ok(Meeting::Parts(Vec::new(), Vec::new(), Vec::new())) };
            let mut out = Vec::with_capacity(curves.len());
            for curve in curves {
                out.extend(curve.conic.over(&around)?.map(|c| (c, true)));
            }
            return Ok(Meeting::Parts(out, points, Vec::new()));
        }
    }
    let tolerance = Tolerance { absolute: TRACED * limit, ..Tolerance::default() };
    let flat = match (a.plane(), b.plane()) {
        (_, Some(plane)) => Some((&a.surface, plane)),
        (Some(plane), None) => Some((&b.surface, plane)),
        (None, None) => None,
    };
    if let Some((surface, plane)) = flat
        && !matches!(surface, Surface::Nurbs(_))
    {
        let met = surface_plane(surface, plane, &tolerance)?;
        if !met.complete {
            return Err(all.refuse(RefusalClass::Unfinished, &places, None));
        }
        return Ok(Meeting::Parts(
            met.curves.into_iter().map(|c| (c, false)).collect(),
            Vec::new(),
            Vec::new(),
        ));
    }
    traced(all, places, [a, b], &tolerance)
}

/// The branches of two surfaces without closed form.
fn traced(all: &Operands, places: [usize; 2], [a, b]: [&Face; 2], tolerance: &Tolerance) -> Result<Meeting> {
    let met = surface_surface(&a.surface.to_nurbs()?, &b.surface.to_nurbs()?, tolerance)?;
    let (mut curves, mut points) = (Vec::new(), Vec::new());
    let mut undecided = None;
    for contact in &met.contacts {
        let class = match (contact.kind, &contact.curve) {
            (SurfaceContactKind::Point, _) => continue,
            (SurfaceContactKind::Crossing, _) => {
                points.push(contact.point);
                continue;
            }
            (SurfaceContactKind::Curve, Some(branch)) => {
                curves.push((branch.curve.clone(), false));
                continue;
            }
            (SurfaceContactKind::Overlap, _) if covers_all(contact.ranges, [a, b]) => {
                return Ok(Meeting::Coincident);
            }
            (SurfaceContactKind::Overlap, _) => RefusalClass::NearCoincidence,
            _ => RefusalClass::Tangency,
        };
        undecided = Some((class, contact.point));
    }
    if let Some((class, place)) = undecided {
        return Err(all.refuse(class, &places, Some(place)));
    }
    if !met.complete {
        return Err(all.refuse(RefusalClass::Unfinished, &places, None));
    }
    let joints = joints(&met.branches, all.limit);
    for branch in met.branches {
        curves.push((led_in(branch.curve, &points, AT_CROSSING * all.limit)?, false));
    }
    Ok(Meeting::Parts(curves, points, joints))
}

/// The ends of branches in which another one ends: it goes on there, at another speed of its images.
fn joints(branches: &[SurfaceBranch], limit: f64) -> Vec<Point3> {
    let ends: Vec<(usize, Point3)> = (branches.iter().enumerate())
        .filter(|(_, b)| !b.closed)
        .flat_map(|(k, b)| [(k, b.curve.start()), (k, b.curve.end())])
        .collect();
    let is_joint = |(k, p): &(usize, Point3)| ends.iter().any(|(j, q)| j > k && p.distance_to(*q) <= limit);
    ends.iter().filter(|end| is_joint(end)).map(|end| end.1).collect()
}

/// A branch that ends a little before a place where branches cross is led there. It runs on straight in such a place, and
/// both surfaces have one tangent plane there: moved along itself it stays on both.
fn led_in(curve: Curve, crossings: &[Point3], reach: f64) -> Result<Curve> {
    let ends = [curve.start(), curve.end()];
    let want = ends.map(|end| crossings.iter().copied().find(|p| p.distance_to(end) <= reach).unwrap_or(end));
    if want == ends { Ok(curve) } else { with_ends(&curve, want) }
}

/// Whether ranges of parameters are the whole domains of both surfaces.
fn covers_all(ranges: [[f64; 2]; 4], faces: [&Face; 2]) -> bool {
    faces.iter().enumerate().all(|(k, face)| {
        // The domains of the NURBS form, in which the ranges are, are those of the search.
        let Ok(nurbs) = face.surface.to_nurbs() else { return false };
        crate::Direction::BOTH.iter().all(|d| {
            let [low, high] = ranges[2 * k + d.index()];
            let domain = nurbs.domain(*d);
            let near = EXACT * domain.length();
            low <= domain.start + near && high >= domain.end - near
        })
    })
}

/// Whether two faces lie on one carrier within the tolerance where they are near each other.
fn coincident(all: &Operands, [a, b]: [&Face; 2], [ca, cb]: [&Carrier; 2]) -> Result<bool> {
    let limit = all.limit;
    if let (Carrier::Plane(p), Carrier::Plane(q)) = (ca, cb) {
        if p.z_axis.cross(q.z_axis).length() <= PARALLEL {
            return Ok(p.signed_distance(q.origin).abs() <= limit
                || on_plane(all, a, q, limit)
                || on_plane(all, b, p, limit));
        }
        return Ok(on_plane(all, a, q, limit) || on_plane(all, b, p, limit));
    }
    let size = a.size.max(b.size);
    let near = Tolerance { absolute: limit, angle: limit / size };
    Ok(matches!(carrier_carrier(ca, cb, &near), Some(CarrierMeeting::Same)))
}

/// How far two faces upon each other are apart: the largest distance found between the border of one and the other, and
/// where it is.
fn gap(all: &Operands, a: &Face, b: &Face) -> Result<(Option<Point3>, f64)> {
    let mut out = (None, 0.0);
    for (own, other) in [(a, b), (b, a)] {
        for edge in own.border.iter().filter_map(|e| all.edges.get(*e)) {
            for share in PLACES {
                let p = edge.curve.point_at(edge.curve.domain().at(share));
                let uv = other.parameters(p)?;
                let distance = other.surface.point_at(uv[0], uv[1]).distance_to(p);
                // Where only the one of them is there is no gap.
                if out.1 < distance && distance <= CAPTURE * all.limit {
                    out = (Some(p), distance);
                }
            }
        }
    }
    Ok(out)
}

/// Whether the whole border of a flat face lies within a distance of a plane.
fn on_plane(all: &Operands, face: &Face, plane: &crate::Plane, limit: f64) -> bool {
    face.border.iter().filter_map(|e| all.edges.get(*e)).all(|edge| {
        let domain = edge.curve.domain();
        [0.0, 0.5, 1.0]
            .iter()
            .all(|x| plane.signed_distance(edge.curve.point_at(domain.at(*x))).abs() <= limit)
    })
}

/// Cuts sections at the vertices on them and keeps the pieces inside both faces.
pub(super) fn pieces(all: &mut Operands, sections: Vec<Section>) -> Result<Vec<SectionPiece>> {
    let mut out = Vec::new();
    let index = index_of(all);
    for section in sections {
        cancellation::check()?;
        let Section { faces, curve, bounds, reach } = section;
        let found = stops(all, &index, &curve, &bounds, reach)?;
        let (Some(fa), Some(fb)) = (all.faces.get(faces[0]), all.faces.get(faces[1])) else { continue };
        let closed = curve.is_closed();
        if !closed {
            refuse_loose_ends(all, faces, [fa, fb], &curve, &found, reach)?;
        }
        if found.is_empty() {
            // A curve that meets no border lies inside both faces as a whole, or outside of one.
            if closed && inside_both(all, [fa, fb], &curve, curve.domain(), reach)? {
                let start = all.vertices.at(curve.start());
                out.push(SectionPiece { faces, curve, ends: [start; 2] });
            }
            continue;
        }
        let (curve, found) =
            if closed { rotated(all, &curve, &found, &index, reach)? } else { (curve, found) };
        for pair in found.windows(2) {
            let [(s, a), (t, b)] = [pair[0], pair[1]];
            let range = Interval::new(s, t);
            if !range.is_increasing() || (a == b && !(closed && found.len() == 2)) {
                continue;
            }
            // Two vertices off the end of the curve have their nearest place there.
            let short = a != b && curve.point_at(s).distance_to(curve.point_at(t)) <= ROUNDING * fa.size;
            if short || !inside_both(all, [fa, fb], &curve, range, reach)? {
                continue;
            }
            let domain = curve.domain();
            let whole = s <= domain.start && domain.end <= t;
            let part = if whole { curve.clone() } else { curve.trimmed(range)? };
            out.push(SectionPiece { faces, curve: part, ends: [a, b] });
        }
    }
    Ok(out)
}

/// A section ends on the border of one of its faces, or in a vertex. One that ends inside both was not followed to its
/// end: what it divides is not known.
fn refuse_loose_ends(
    all: &Operands,
    places: [usize; 2],
    faces: [&Face; 2],
    curve: &Curve,
    found: &[(f64, usize)],
    reach: f64,
) -> Result<()> {
    let domain = curve.domain();
    let [first, last] = match (found.first(), found.last()) {
        (Some(first), Some(last)) => {
            [Interval::new(domain.start, first.0), Interval::new(last.0, domain.end)]
        }
        _ => [domain, domain],
    };
    for range in [first, last] {
        let end_to_end = curve.point_at(range.start).distance_to(curve.point_at(range.end));
        if range.is_increasing() && end_to_end > reach && inside_both(all, faces, curve, range, reach)? {
            let place = curve.point_at(range.middle());
            return Err(all.refuse(RefusalClass::UnclosedSplit, &places, Some(place)));
        }
    }
    Ok(())
}

/// The points of all vertices in a tree of boxes.
pub(super) fn index_of(all: &Operands) -> BoxIndex {
    let boxes: Vec<BoundingBox> =
        all.vertices.points().iter().map(|p| BoundingBox { min: *p, max: *p }).collect();
    BoxIndex::new(&boxes)
}

/// A closed curve that starts at its first stop, and its stops, which end where they begin.
fn rotated(
    all: &Operands,
    curve: &Curve,
    found: &[(f64, usize)],
    index: &BoxIndex,
    reach: f64,
) -> Result<(Curve, Vec<(f64, usize)>)> {
    let Some(&(first, vertex)) = found.first() else { return Ok((curve.clone(), Vec::new())) };
    // A stop at the seam but for rounding needs no other seam: the piece before it would have no length.
    let domain = curve.domain();
    let least = ROUNDING * domain.length();
    let at_seam = first - domain.start <= least || domain.end - first <= least;
    let curve = if at_seam { curve.clone() } else { curve.with_seam(first)? };
    let domain = curve.domain();
    let mut out = vec![(domain.start, vertex)];
    let again = stops(all, index, &curve, &curve.bounding_box(), reach)?;
    out.extend(again.into_iter().filter(|(_, v)| *v != vertex));
    out.push((domain.end, vertex));
    Ok((curve, out))
}

/// Whether a piece without a vertex on it lies inside two faces; what runs along a border lies on an edge that is known.
fn inside_both(
    all: &Operands,
    faces: [&Face; 2],
    curve: &Curve,
    range: Interval,
    reach: f64,
) -> Result<bool> {
    for face in faces {
        let mut inside = false;
        for share in PLACES {
            match all.place(face, curve.point_at(range.at(share)), reach)? {
                Place::Inside(_) => {
                    inside = true;
                    break;
                }
                Place::Outside => break,
                Place::Border => {}
            }
        }
        if !inside {
            return Ok(false);
        }
    }
    Ok(true)
}
