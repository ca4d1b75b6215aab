//! Boxes around faces.

use super::iso::hull;
use super::{Brep, Face, LoopKind};
use crate::{BoundingBox, Direction, Interval, Surface};

/// How much of the domain is taken beyond the loop on every side, as a fraction of the loop's size.
const MARGIN: f64 = 0.1;

impl Brep {
    /// A box around all faces: around the part of each surface that its outer loop reaches, a little widened. It
    /// holds the brep, but is not the smallest such box. None when there are no faces with surfaces.
    pub fn bounds_of_faces(&self) -> Option<BoundingBox> {
        let live = self.faces().iter().filter(|face| !face.deleted);
        live.filter_map(|face| self.bounds_of(face)).reduce(|a, b| a.union(&b))
    }

    /// A box around the part of a face's surface that its outer loop reaches, a little widened.
    pub(super) fn bounds_of_face(&self, face: usize) -> Option<BoundingBox> {
        self.bounds_of(self.faces().get(face)?)
    }

    fn bounds_of(&self, face: &Face) -> Option<BoundingBox> {
        let parts = self.parts();
        let surface = parts.face_surface(face)?;
        let reached = self.reach(face).and_then(|reach| {
            let [u, v] = Direction::BOTH.map(|d| surface.domain(d));
            let range = |low: f64, high: f64, domain: Interval| {
                let margin = MARGIN * (high - low);
                Interval::new(low - margin, high + margin).intersection(domain).filter(|r| r.is_increasing())
            };
            let wanted = [range(reach.min.x, reach.max.x, u)?, range(reach.min.y, reach.max.y, v)?];
            let mut part = surface.clone();
            for (direction, (domain, wanted)) in
                Direction::BOTH.into_iter().zip([u, v].into_iter().zip(wanted))
            {
                if domain.includes(wanted, true) {
                    part = part.trimmed(direction, wanted).ok()?;
                }
            }
            bounds_of_surface(&part)
        });
        reached.or_else(|| bounds_of_surface(surface))
    }

    /// The box around the curves of the outer loop in the parameter plane.
    fn reach(&self, face: &Face) -> Option<BoundingBox> {
        let parts = self.parts();
        let mut loops = face.loops.iter().filter_map(|l| parts.loops.get(*l));
        let outer = loops.find(|chain| chain.kind == LoopKind::Outer)?;
        let trims = outer.trims.iter().filter_map(|t| parts.trims.get(*t));
        trims.filter_map(|trim| hull(parts.trim_curve(trim)?)).reduce(|a, b| a.union(&b))
    }
}

/// The box around control points, else the smallest one.
fn bounds_of_surface(surface: &Surface) -> Option<BoundingBox> {
    match surface {
        Surface::Nurbs(nurbs) => BoundingBox::from_points(nurbs.control_points()),
        _ => surface.bounding_box().ok(),
    }
}
