//! Trims: what they name, their flags, and how near they run to their edges.

use super::super::iso::iso_of;
use super::super::{Edge, Iso, LoopKind, Parts, Trim, TrimKind};
use super::{Faults, Symptom};
use crate::{Point3, Quadrant, Surface, Vector3};

const TRIM: &str = "trim";
/// What trims may be away from their edges whatever the tolerances say, in model units.
const LEAST_DISTANCE: f64 = 0.01;
/// How often the sum of all tolerances trims may be away from their edges.
const GENEROSITY: f64 = 10.0;

impl Parts {
    pub(super) fn trim_faults(&self, faults: &mut Faults) {
        for (i, trim) in self.trims.iter().enumerate() {
            if trim.deleted {
                let bare = trim.edge.is_none()
                    && trim.in_loop.is_none()
                    && trim.part.curve.is_none()
                    && trim.vertices == [None, None];
                faults.unless(bare, TRIM, i, || "it is deleted, but names other parts".into());
                continue;
            }
            faults.unless(trim.tolerance.iter().all(|t| *t >= 0.0), TRIM, i, || {
                "its tolerances are not set".into()
            });
            self.trim_curve_faults(i, trim, faults);
            self.trim_end_faults(i, trim, faults);
            self.trim_kind_faults(i, trim, faults);
        }
    }

    fn trim_curve_faults(&self, i: usize, trim: &Trim, faults: &mut Faults) {
        let Some(curve) = self.trim_curve(trim) else {
            faults.shown_unless(false, Symptom::Missing, TRIM, i, || "it has no curve".into());
            return;
        };
        let part = &trim.part;
        let domain = curve.domain();
        faults.shown_unless(
            part.range.is_increasing() && part.domain.is_increasing(),
            Symptom::EdgeWithoutLength,
            TRIM,
            i,
            || "its domain does not increase".into(),
        );
        let inside = domain.includes(part.range, false) && domain.includes(part.domain, false);
        faults.shown_unless(inside, Symptom::EdgeBeyondCurve, TRIM, i, || "it goes beyond its curve".into());
        let Some(surface) = self.trim_surface(trim) else { return };
        let iso = iso_of(surface, curve, part.range);
        faults.unless(iso == trim.iso, TRIM, i, || {
            format!("its direction is stated as {:?}, but is {iso:?}", trim.iso)
        });
        if let Some(edge) = trim.edge.and_then(|edge| self.edges.get(edge)) {
            self.distance_faults(i, trim, edge, surface, faults);
        }
    }

    fn trim_end_faults(&self, i: usize, trim: &Trim, faults: &mut Faults) {
        for vertex in trim.vertices {
            let live = vertex.and_then(|v| self.vertices.get(v)).is_some_and(|vertex| !vertex.deleted);
            faults.unless(live, TRIM, i, || "it has no vertex at an end".into());
        }
        let live = trim.in_loop.and_then(|l| self.loops.get(l)).filter(|chain| !chain.deleted);
        faults.unless(live.is_some_and(|chain| chain.trims.contains(&i)), TRIM, i, || {
            "it is in no loop".into()
        });
        let Some(edge) = trim.edge.and_then(|edge| self.edges.get(edge)) else { return };
        faults
            .unless(!edge.deleted && edge.trims.contains(&i), TRIM, i, || "its edge does not name it".into());
        let [start, end] = edge.vertices;
        let ends = if trim.reversed { [end, start] } else { [start, end] };
        faults.unless(ends == trim.vertices, TRIM, i, || "its vertices are not those of its edge".into());
        let whole = self.trim_curve(trim).filter(|curve| curve.domain() == trim.part.domain);
        let closed = whole.is_some_and(|curve| curve.is_closed());
        faults.shown_unless(
            !closed || trim.vertices[0] == trim.vertices[1],
            Symptom::EdgeWithoutLength,
            TRIM,
            i,
            || "it is closed, but has two vertices".into(),
        );
    }

    fn trim_kind_faults(&self, i: usize, trim: &Trim, faults: &mut Faults) {
        let symptom = if trim.kind == TrimKind::Seam { Symptom::Seam } else { Symptom::Parts };
        let mut wrong = |why: &str| faults.shown_unless(false, symptom, TRIM, i, || why.to_owned());
        let kind = trim.in_loop.and_then(|l| self.loops.get(l)).map_or(LoopKind::Unknown, |chain| chain.kind);
        let sided = matches!(kind, LoopKind::Outer | LoopKind::Inner);
        let edge = trim.edge.and_then(|edge| self.edges.get(edge));
        if trim.kind == TrimKind::Singular {
            if edge.is_some() {
                wrong("it is singular, but has an edge");
            }
            if trim.vertices[0] != trim.vertices[1] {
                wrong("it is singular, but has two vertices");
            }
            if !matches!(trim.iso, Iso::Side(_)) {
                wrong("it is singular, but along no side of the surface");
            }
            if self.trim_curve(trim).is_some_and(|curve| curve.is_closed()) {
                wrong("it is singular, but closed");
            }
            return;
        }
        let Some(edge) = edge else {
            wrong("it has no edge, and is not singular");
            return;
        };
        match trim.kind {
            TrimKind::Unknown => wrong("its kind is not known"),
            TrimKind::Boundary => {
                if edge.trims.len() > 1 {
                    wrong("it is a boundary, but its edge has other trims");
                }
                if !sided {
                    wrong("it is a boundary, but its loop is neither outer nor inner");
                }
            }
            TrimKind::Mated => {
                if edge.trims.len() < 2 {
                    wrong("it is mated, but its edge has no other trim");
                }
                if !sided {
                    wrong("it is mated, but its loop is neither outer nor inner");
                }
            }
            TrimKind::Seam => {
                if kind != LoopKind::Outer && edge.trims.len() <= 2 {
                    wrong("it is a seam, but its loop is not the outer one");
                }
                if !matches!(trim.iso, Iso::Side(_)) {
                    wrong("it is a seam, but along no side of the surface");
                }
            }
            TrimKind::Singular => {}
        }
        if let [a, b] = *edge.trims.as_slice() {
            let other = if a == i { b } else { a };
            let same = other != i && self.trims.get(other).is_some_and(|t| t.in_loop == trim.in_loop);
            faults.shown_unless(!same || trim.kind == TrimKind::Seam, Symptom::Seam, TRIM, i, || {
                "its edge has two trims of one loop, but it is no seam".into()
            });
        }
    }

    /// The images of the trim's ends are where its edge ends, and closed ones run the same way.
    fn distance_faults(&self, i: usize, trim: &Trim, edge: &Edge, surface: &Surface, faults: &mut Faults) {
        let (Some(flat), Some(space)) = (self.trim_curve(trim), self.edge_curve(edge)) else { return };
        let closed = trim.vertices[0] == trim.vertices[1] && edge.vertices == trim.vertices;
        let needs_slopes = closed || trim.tolerance != [0.0; 2];
        let mut sum = edge.tolerance;
        let mut apart = [0.0; 2];
        let mut turned = false;
        for at_end in [false, true] {
            let end = |domain: crate::Interval| if at_end { domain.end } else { domain.start };
            let uv = trim.part.point_at(flat, end(trim.part.domain));
            let (image, [du, dv]) = if needs_slopes {
                image(surface, uv)
            } else {
                (surface.point_at(uv.x, uv.y), [Vector3::ZERO; 2])
            };
            sum += du.length() * trim.tolerance[0] + dv.length() * trim.tolerance[1];
            let edge_end = at_end != trim.reversed;
            let place = if edge_end { edge.part.domain.end } else { edge.part.domain.start };
            if let Some(distance) = apart.get_mut(usize::from(at_end)) {
                *distance = edge.part.point_at(space, place).distance_to(image);
            }
            if closed
                && let (Some(t), Some(e)) =
                    (trim.part.end_tangent(flat, at_end), edge.part.end_tangent(space, edge_end))
            {
                let along = (du * t.x + dv * t.y).dot(e);
                turned |= if trim.reversed { along > 0.0 } else { along < 0.0 };
            }
        }
        let limit = (GENEROSITY * sum).max(LEAST_DISTANCE);
        for (distance, name) in apart.into_iter().zip(["start", "end"]) {
            faults.shown_unless(distance <= limit, Symptom::EdgeOffFace, TRIM, i, || {
                format!("its {name} is {distance} away from that of its edge")
            });
        }
        faults.shown_unless(!(closed && turned), Symptom::EdgeTurned, TRIM, i, || {
            "its edge is closed and runs the other way than stated".into()
        });
    }
}

/// The point of a surface and its first derivatives, at the ends of the domain from inside.
fn image(surface: &Surface, uv: Point3) -> (Point3, [Vector3; 2]) {
    let [u, v] = crate::Direction::BOTH.map(|d| surface.domain(d));
    let side = match (uv.x >= u.end, uv.y >= v.end) {
        (true, true) => Quadrant::SouthWest,
        (true, false) => Quadrant::NorthWest,
        (false, true) => Quadrant::SouthEast,
        (false, false) => Quadrant::NorthEast,
    };
    let d = surface.derivatives(uv.x, uv.y, 1, side);
    (d.point(), [d.get(1, 0), d.get(0, 1)])
}
