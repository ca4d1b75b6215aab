//! Faces that lines of sight and curves meet in closed form: parts of planes, spheres, cylinders and cones.

use super::feature::Feature;
use crate::box_tree::{Bounds, bounds_of};
use crate::brep::ClosestOnBrep;
use crate::polynomial::Polynomial;
use crate::region::Outline;
use crate::surface::Round;
use crate::thresholds;
use crate::{Brep, Curve, Plane, Point3, Surface, Vector3};

/// A face with such a surface.
#[derive(Debug)]
pub(super) struct Sheet {
    pub(super) object: usize,
    pub(super) face: usize,
    pub(super) bounds: Bounds,
    carrier: Carrier,
}

#[derive(Debug)]
enum Carrier {
    /// A plane, with the loops of the face in it.
    Flat(Plane, Vec<Outline>),
    /// A part of a sphere, cylinder or cone; the face's place among those prepared where it has trims.
    Round(Box<Round>, Option<usize>),
}

/// Surfaces are flat that are so within this part of their size.
const FLAT: f64 = 1e-10;

impl Sheet {
    /// Of a face, where its surface is such a one.
    pub(super) fn new(search: &ClosestOnBrep, object: usize, face: usize) -> Option<Self> {
        let brep = search.brep();
        let surface = brep.face_surface(face)?;
        let (place, around) = search.sheet(face)?;
        if let Some(round) = Round::of(surface) {
            let trimmed = !brep.is_whole(brep.faces().get(face)?);
            let bounds = [around.min.into(), around.max.into()];
            let carrier = Carrier::Round(Box::new(round), trimmed.then_some(place));
            return Some(Self { object, face, bounds, carrier });
        }
        let plane = match surface {
            Surface::Plane(flat) => *flat.plane(),
            _ => surface.plane(FLAT * around.diagonal().length())?,
        };
        let loops = loops(brep, face)?;
        let bounds = loops.iter().map(Curve::bounding_box).reduce(|a, b| a.union(&b))?;
        let outlines = loops.iter().map(|curve| Outline::new(curve, &plane)).collect();
        let bounds = [bounds.min.into(), bounds.max.into()];
        Some(Self { object, face, bounds, carrier: Carrier::Flat(plane, outlines) })
    }

    /// The distances along a line of sight at which it meets the whole surface. Of a face that the curve lies on, that
    /// place of the curve is left out; `tangent` lines touch it there and meet it nowhere else.
    pub(super) fn line(
        &self,
        from: Point3,
        direction: Vector3,
        own: bool,
        tangent: bool,
    ) -> [Option<f64>; 2] {
        match &self.carrier {
            Carrier::Flat(plane, _) => {
                let slope = direction.dot(plane.z_axis);
                let s = -plane.signed_distance(from) / slope;
                [Some(s).filter(|s| !own && slope.abs() > thresholds::NO_DIRECTION && s.is_finite()), None]
            }
            Carrier::Round(round, _) => match round.line(from, direction) {
                Some([a, b]) if own => {
                    let other = if a.abs() < b.abs() { b } else { a };
                    [(!tangent).then_some(other), None]
                }
                Some([a, b]) => [Some(a), Some(b)],
                None => [None, None],
            },
        }
    }

    /// Whether a point of the surface lies on the face.
    pub(super) fn covers(&self, search: &ClosestOnBrep, p: Point3) -> bool {
        match &self.carrier {
            Carrier::Flat(plane, outlines) => {
                let [x, y, _] = plane.coordinates(p);
                outlines.iter().map(|outline| outline.winding([x, y])).sum::<i32>() != 0
            }
            Carrier::Round(round, trims) => match (round.parameters(p), trims) {
                (None, _) => false,
                (Some(_), None) => true,
                (Some(uv), Some(place)) => search.sheet_covers(*place, uv),
            },
        }
    }

    /// The polynomial that is zero where a Bézier curve meets the whole surface.
    pub(super) fn along_curve(&self, points: &[[f64; 4]]) -> Polynomial {
        match &self.carrier {
            Carrier::Flat(plane, _) => height(points, plane.origin, plane.z_axis),
            Carrier::Round(round, _) => round.along_curve(points),
        }
    }

    /// Whether a curve lies on the face.
    pub(super) fn carries(&self, feature: &Feature) -> bool {
        feature.object == self.object && feature.faces.contains(&self.face)
    }
}

/// How high a Bézier curve with homogeneous control points is above a plane, times its weight.
pub(super) fn height(points: &[[f64; 4]], origin: Point3, normal: Vector3) -> Polynomial {
    let above = |p: &[f64; 4]| (Vector3::new(p[0], p[1], p[2]) - origin.to_vector() * p[3]).dot(normal);
    Polynomial::new(points.iter().map(above).collect())
}

/// The loops of a face in space; `None` where an edge has no curve.
fn loops(brep: &Brep, face: usize) -> Option<Vec<Curve>> {
    let own = brep.faces().get(face)?;
    let mut out = Vec::with_capacity(own.loops.len());
    for chain in own.loops.iter().filter_map(|l| brep.loops().get(*l)) {
        let mut parts = Vec::with_capacity(chain.trims.len());
        for trim in chain.trims.iter().filter_map(|t| brep.trims().get(*t)) {
            let curve = brep.edge_as_curve(trim.edge?).ok()??;
            parts.push(if trim.reversed { curve.reversed() } else { curve });
        }
        if parts.is_empty() {
            return None;
        }
        out.push(crate::curve::chained(parts, 0.0));
    }
    (!out.is_empty()).then_some(out)
}

/// The box of Bézier control points.
pub(super) fn box_of_points(points: &[[f64; 4]]) -> Bounds {
    bounds_of(points.iter().map(|p| [p[0] / p[3], p[1] / p[3], p[2] / p[3]]))
}
