//! Seams: the two trims along one edge of a surface that closes.

use super::super::{Face, Iso, LoopKind, Parts, Trim, TrimKind};
use super::{Faults, Symptom};
use crate::{Direction, Interval, Side, Surface};

/// How near ends of two sides of a seam must be, as a fraction of the side, to be taken for the same.
const SAME_PLACE: f64 = 1e-4;

impl Parts {
    pub(super) fn seam_faults(&self, faults: &mut Faults) {
        for (i, trim) in self.trims.iter().enumerate() {
            if trim.deleted || trim.kind != TrimKind::Seam {
                continue;
            }
            let edge = trim.edge.and_then(|edge| self.edges.get(edge));
            let trims = edge.map_or(&[] as &[usize], |edge| &edge.trims);
            let partners: Vec<&Trim> = (trims.iter().filter(|t| **t != i))
                .filter_map(|t| self.trims.get(*t))
                .filter(|t| t.kind == TrimKind::Seam && t.in_loop == trim.in_loop)
                .collect();
            let [partner] = partners.as_slice() else {
                faults.shown_unless(false, Symptom::Seam, "trim", i, || {
                    format!("it is a seam, and its edge has {} more in its loop", partners.len())
                });
                continue;
            };
            let opposite = match (trim.iso, partner.iso) {
                (Iso::Side(a), Iso::Side(b)) => opposite(a) == b,
                _ => false,
            };
            faults.shown_unless(opposite, Symptom::Seam, "trim", i, || {
                "its other side is not across the surface".into()
            });
        }
        for (i, face) in self.faces.iter().enumerate() {
            if let Some(surface) = self.face_surface(face).filter(|_| !face.deleted) {
                self.split_seams(i, face, surface, faults);
            }
        }
    }

    /// Two naked trims along the two sides where a surface closes should have been one seam.
    fn split_seams(&self, i: usize, face: &Face, surface: &Surface, faults: &mut Faults) {
        let outer = face.loops.iter().filter_map(|l| self.loops.get(*l));
        let Some(outer) = outer.clone().find(|chain| chain.kind == LoopKind::Outer) else { return };
        let sides: Vec<(Side, Interval)> = (outer.trims.iter().filter_map(|t| self.trims.get(*t)))
            .filter(|trim| trim.kind == TrimKind::Boundary)
            .filter_map(|trim| self.on_closed_side(trim, surface))
            .collect();
        for (a, range) in &sides {
            // Counter-clockwise the east and the south side are run upwards.
            let upwards = matches!(a, Side::East | Side::South);
            if (range.start < range.end) != upwards || range.is_singleton() {
                continue;
            }
            let split = sides.iter().any(|(b, other)| {
                let near = |t: f64, x: f64| (range.normalized(t) - x).abs() <= SAME_PLACE;
                *b == opposite(*a) && near(other.start, 1.0) && near(other.end, 0.0)
            });
            faults.shown_unless(!split, Symptom::Seam, "face", i, || {
                "its surface closes, but its sides there are not joined to a seam".into()
            });
        }
    }

    /// The side that a trim runs along, if the surface closes there, and the parameters of its ends along it.
    fn on_closed_side(&self, trim: &Trim, surface: &Surface) -> Option<(Side, Interval)> {
        let Iso::Side(side) = trim.iso else { return None };
        let (along, _) = side.along();
        if !surface.is_closed(along.other()) {
            return None;
        }
        let curve = self.trim_curve(trim)?;
        let [start, end] =
            [trim.part.domain.start, trim.part.domain.end].map(|t| trim.part.point_at(curve, t));
        Some(match along {
            Direction::U => (side, Interval::new(start.x, end.x)),
            Direction::V => (side, Interval::new(start.y, end.y)),
        })
    }
}

fn opposite(side: Side) -> Side {
    match side {
        Side::South => Side::North,
        Side::East => Side::West,
        Side::North => Side::South,
        Side::West => Side::East,
    }
}
