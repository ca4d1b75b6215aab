//! An extrusion as a brep: a wall for each smooth piece of its profiles, and caps. Derived: archives before version 50
//! have no extrusions.

use katydid_geometry::brep::{CurvePart, Edge, Face, Loop, LoopKind, Parts, Trim, TrimKind};
use katydid_geometry::{
    Brep, Curve, Interval, NurbsCurve, NurbsSurface, Plane, PlaneSurface, Point3, Vector3,
};

use super::Extrusion;
use crate::object::{BrepObject, CurveForm};

/// Joints of less than a degree are smooth.
const SMOOTH: f64 = 0.999_847_7;

impl Extrusion {
    /// The walls and caps as a brep without meshes; nothing when the numbers make no solid or surface.
    pub fn to_brep(&self) -> Option<BrepObject> {
        let ends = self.ends()?;
        let profiles = self.oriented_profiles()?;
        let closed = profiles.iter().all(Curve::is_closed);
        let mut builder = Builder { parts: Parts::default(), ends, domain: self.path_domain };
        let mut walls = Vec::new();
        for profile in &profiles {
            walls.push(builder.walls(profile)?);
        }
        for (end, capped) in self.caps.into_iter().enumerate() {
            if capped && closed {
                builder.cap(end, &walls)?;
            }
        }
        let mut parts = builder.parts;
        parts.set_kinds();
        parts.set_vertices();
        parts.set_iso();
        parts.vertices.iter_mut().for_each(|vertex| vertex.tolerance = 0.0);
        let brep = Brep::from_parts(parts).ok()?;
        let bounds = brep.bounds_of_faces();
        Some(BrepObject { bounds, ..BrepObject::from(brep) })
    }

    /// The profiles, outer ones counter-clockwise and inner ones clockwise where they are closed.
    fn oriented_profiles(&self) -> Option<Vec<Curve>> {
        let curves = match self.profile.as_ref()? {
            CurveForm::Poly { segments, .. } if self.profile_count > 1 => {
                segments.iter().map(|form| form.to_curve().ok()).collect::<Option<Vec<_>>>()?
            }
            whole => vec![whole.to_curve().ok()?],
        };
        let turned = |(place, curve): (usize, Curve)| {
            let clockwise = curve.is_closed() && curve.signed_area_in(&Plane::XY).0 < 0.0;
            if curve.is_closed() && clockwise == (place == 0) { curve.reversed() } else { curve }
        };
        Some(curves.into_iter().enumerate().map(turned).collect())
    }

    /// How profiles lie in space at the start and the end.
    fn ends(&self) -> Option<[End; 2]> {
        let along = (self.path.to - self.path.from).unitized()?;
        let up = (self.up - along * self.up.dot(along)).unitized()?;
        let across = up.cross(along);
        let end = |place: usize| {
            let mitred = self.is_mitred[place].then_some(self.mitre_normals[place]);
            let slant = mitred.filter(|normal| normal.z > f64::EPSILON);
            // Points move along the path until they meet the cut.
            let [x, y] = slant.map_or([0.0; 2], |normal| [-normal.x / normal.z, -normal.y / normal.z]);
            let part = if place == 0 { self.part.start } else { self.part.end };
            let [x_axis, y_axis] = [across + along * x, up + along * y];
            let frame =
                Plane::from_axes(self.path.from + (self.path.to - self.path.from) * part, x_axis, y_axis);
            Some(End { x_axis, y_axis, frame: frame.ok()? })
        };
        Some([end(0)?, end(1)?])
    }
}

/// How a profile lies in space at one end.
struct End {
    /// Where the axes of the profile's plane come to lie; not at right angles where the end is slanted.
    x_axis: Vector3,
    y_axis: Vector3,
    /// The plane of the end.
    frame: Plane,
}

impl End {
    fn point(&self, p: Point3) -> Point3 {
        self.frame.origin + self.x_axis * p.x + self.y_axis * p.y
    }
}

/// A curve with other control points.
fn moved(curve: &NurbsCurve, to: impl Fn(Point3) -> Point3) -> Option<NurbsCurve> {
    let points: Vec<Point3> = curve.control_points().into_iter().map(to).collect();
    let (degree, knots) = (curve.degree(), curve.knots().to_vec());
    let moved = if curve.is_rational() {
        NurbsCurve::with_weights(degree, &points, &curve.weights(), knots)
    } else {
        NurbsCurve::new(degree, points, knots)
    };
    moved.ok()
}

/// A straight curve over a domain.
fn straight(from: Point3, to: Point3, domain: Interval) -> Option<NurbsCurve> {
    NurbsCurve::new(1, vec![from, to], vec![domain.start, domain.end]).ok()
}

/// The smooth pieces of a profile.
fn pieces(curve: &Curve, found: &mut Vec<NurbsCurve>) -> Option<()> {
    match curve {
        Curve::Poly(poly) => poly.segments().iter().enumerate().try_for_each(|(place, segment)| {
            pieces(&segment.with_domain(poly.segment_domain(place)).ok()?, found)
        }),
        Curve::Polyline(polyline) => {
            let ends = polyline.points().windows(2).zip(polyline.parameters().windows(2));
            for (points, domain) in ends {
                if let ([from, to], [start, end]) = (points, domain) {
                    found.push(straight(*from, *to, Interval::new(*start, *end))?);
                }
            }
            Some(())
        }
        other => {
            let whole = other.to_nurbs().ok()?;
            let parts = Curve::Nurbs(whole.clone()).split_at(&kinks(&whole)).ok()?;
            found.extend(parts.iter().filter_map(|part| part.to_nurbs().ok()));
            Some(())
        }
    }
}

/// The parameters at which a curve turns at once.
fn kinks(curve: &NurbsCurve) -> Vec<f64> {
    let domain = curve.domain();
    let mut kinks: Vec<f64> = Vec::new();
    for knots in curve.knots().windows(curve.degree()) {
        let (Some(first), Some(last)) = (knots.first(), knots.last()) else { continue };
        let inside = *first > domain.start && *first < domain.end;
        if first != last || !inside || kinks.last() == Some(first) {
            continue;
        }
        let tangent = |below| curve.derivatives(*first, 1, below).1.first().and_then(|v| v.unitized());
        if let (Some(before), Some(after)) = (tangent(true), tangent(false))
            && before.dot(after) < SMOOTH
        {
            kinks.push(*first);
        }
    }
    kinks
}

/// A wall: its piece of the profile, and its edges at both ends.
struct Wall {
    piece: NurbsCurve,
    edges: [usize; 2],
}

struct Builder {
    parts: Parts,
    ends: [End; 2],
    domain: Interval,
}

impl Builder {
    /// The walls along a profile.
    fn walls(&mut self, profile: &Curve) -> Option<Vec<Wall>> {
        let mut found = Vec::new();
        pieces(profile, &mut found)?;
        let starts: Vec<Point3> = found.iter().map(|piece| piece.point_at(piece.domain().start)).collect();
        let mut sides = starts.into_iter().map(|p| self.side(p)).collect::<Option<Vec<_>>>()?;
        if profile.is_closed() {
            sides.push(*sides.first()?);
        } else {
            let last = found.last()?;
            sides.push(self.side(last.point_at(last.domain().end))?);
        }
        let mut walls = Vec::new();
        for (piece, sides) in found.into_iter().zip(sides.windows(2)) {
            let [before, after] = <[usize; 2]>::try_from(sides).ok()?;
            walls.push(self.wall(piece, before, after)?);
        }
        Some(walls)
    }

    /// The edge that a point of a profile draws.
    fn side(&mut self, p: Point3) -> Option<usize> {
        let [from, to] = [self.ends[0].point(p), self.ends[1].point(p)];
        Some(self.edge(straight(from, to, self.domain)?))
    }

    fn wall(&mut self, piece: NurbsCurve, before: usize, after: usize) -> Option<Wall> {
        let [bottom, top] = [0, 1].map(|end: usize| moved(&piece, |p| self.ends[end].point(p)));
        let surface = self.ruled(&piece)?;
        let edges = [self.edge(bottom?), self.edge(top?)];
        let place = self.face(surface.into(), false);
        let (u, v) = (piece.domain(), self.domain);
        let [a, b, c, d] = [(u.start, v.start), (u.end, v.start), (u.end, v.end), (u.start, v.end)]
            .map(|(u, v)| Point3::new(u, v, 0.0));
        let in_loop = self.loop_of(place, LoopKind::Outer);
        self.trim(in_loop, straight(a, b, u)?, edges[0], false);
        self.trim(in_loop, straight(b, c, v)?, after, false);
        self.trim(in_loop, straight(c, d, u)?, edges[1], true);
        self.trim(in_loop, straight(d, a, v)?, before, true);
        Some(Wall { piece, edges })
    }

    fn ruled(&self, piece: &NurbsCurve) -> Option<NurbsSurface> {
        let ends = |p: Point3| self.ends.each_ref().map(|end| end.point(p));
        let points: Vec<Point3> = piece.control_points().into_iter().flat_map(ends).collect();
        let degrees = [piece.degree(), 1];
        let counts = [piece.point_count(), 2];
        let knots = [piece.knots().to_vec(), vec![self.domain.start, self.domain.end]];
        let surface = if piece.is_rational() {
            let weights: Vec<f64> = piece.weights().into_iter().flat_map(|weight| [weight; 2]).collect();
            NurbsSurface::with_weights(degrees, counts, &points, &weights, knots)
        } else {
            NurbsSurface::new(degrees, counts, points, knots)
        };
        surface.ok()
    }

    /// The cap at an end: a plane, trimmed by each profile.
    fn cap(&mut self, end: usize, profiles: &[Vec<Wall>]) -> Option<()> {
        let frame = self.ends[end].frame;
        let flat = |wall: &Wall| {
            let end = &self.ends[end];
            moved(&wall.piece, |p| {
                let [x, y, _] = frame.coordinates(end.point(p));
                Point3::new(x, y, 0.0)
            })
        };
        let curves = profiles.iter().map(|walls| walls.iter().map(flat).collect::<Option<Vec<_>>>());
        let curves = curves.collect::<Option<Vec<_>>>()?;
        let extents = [|p: &Point3| p.x, |p: &Point3| p.y].map(|along| {
            let all = curves.iter().flatten().flat_map(|curve| curve.control_points());
            all.fold(None, |range: Option<Interval>, p| {
                let x = along(&p);
                Some(range.map_or(Interval::new(x, x), |r| Interval::new(r.start.min(x), r.end.max(x))))
            })
        });
        let [x, y] = extents;
        // The bottom looks the other way.
        let place = self.face(PlaneSurface::new(frame, x?, y?).ok()?.into(), end == 0);
        for (number, (walls, curves)) in profiles.iter().zip(curves).enumerate() {
            let in_loop = self.loop_of(place, if number == 0 { LoopKind::Outer } else { LoopKind::Inner });
            for (wall, curve) in walls.iter().zip(curves) {
                self.trim(in_loop, curve, wall.edges[end], false);
            }
        }
        Some(())
    }

    fn edge(&mut self, curve: NurbsCurve) -> usize {
        let part = CurvePart::whole(self.parts.curves_3d.len(), curve.domain());
        self.parts.curves_3d.push(Some(curve.into()));
        self.parts.edges.push(Edge {
            part,
            vertices: [None; 2],
            trims: Vec::new(),
            tolerance: 0.0,
            deleted: false,
        });
        self.parts.edges.len() - 1
    }

    fn face(&mut self, surface: katydid_geometry::Surface, reversed: bool) -> usize {
        self.parts.surfaces.push(Some(surface));
        self.parts.faces.push(Face::new(self.parts.surfaces.len() - 1, reversed));
        self.parts.faces.len() - 1
    }

    fn loop_of(&mut self, face: usize, kind: LoopKind) -> usize {
        let place = self.parts.loops.len();
        self.parts.loops.push(Loop { trims: Vec::new(), kind, face: Some(face), deleted: false });
        if let Some(face) = self.parts.faces.get_mut(face) {
            face.loops.push(place);
        }
        place
    }

    fn trim(&mut self, in_loop: usize, curve: NurbsCurve, edge: usize, reversed: bool) {
        let place = self.parts.trims.len();
        let part = CurvePart::whole(self.parts.curves_2d.len(), curve.domain());
        self.parts.curves_2d.push(Some(curve.into()));
        self.parts.trims.push(Trim {
            part,
            edge: Some(edge),
            reversed,
            vertices: [None; 2],
            kind: TrimKind::Unknown,
            iso: Default::default(),
            in_loop: Some(in_loop),
            tolerance: [0.0; 2],
            older_tolerances: [0.0; 2],
            deleted: false,
        });
        if let Some(edge) = self.parts.edges.get_mut(edge) {
            edge.trims.push(place);
        }
        if let Some(in_loop) = self.parts.loops.get_mut(in_loop) {
            in_loop.trims.push(place);
        }
    }
}
