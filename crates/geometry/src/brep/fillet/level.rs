//! Flat faces on surfaces that are singular somewhere, as the walls of a pyramid are at its tip, put on planes: there
//! every rail has its place.

use crate::brep::flatten::flattened;
use crate::brep::{Brep, CurvePart};
use crate::{Direction, Interval, Plane, PlaneSurface, Result, Surface};

/// Up to this part of its size a face is flat.
const FLAT: f64 = 1e-12;

/// The brep with those faces on planes; all other parts keep their places.
pub(super) fn levelled(brep: Brep) -> Result<Brep> {
    let mut planes = Vec::new();
    for face in 0..brep.faces().len() {
        crate::patience::check()?;
        planes.extend(singular_plane(&brep, face).map(|plane| (face, plane)));
    }
    if planes.is_empty() {
        return Ok(brep);
    }
    let mut parts = brep.clone().into_parts();
    for (face, plane) in planes {
        let loops = brep.faces().get(face).map(|own| own.loops.as_slice()).unwrap_or_default();
        let mut bounds: Option<[Interval; 2]> = None;
        for &chain in loops {
            let trims = brep.loops().get(chain).map(|own| own.trims.as_slice()).unwrap_or_default();
            let mut kept = Vec::with_capacity(trims.len());
            for &place in trims {
                let (Some(old), Some(trim)) = (brep.trims().get(place), parts.trims.get_mut(place)) else {
                    continue;
                };
                let edge = old.edge.map_or(Ok(None), |edge| brep.edge_as_curve(edge))?;
                let Some(edge) = edge else {
                    (trim.deleted, trim.in_loop) = (true, None);
                    continue;
                };
                let flat = flattened(&edge, &plane)?;
                let flat = if old.reversed { flat.reversed() } else { flat };
                let hull = flat.bounding_box();
                let own = [Interval::new(hull.min.x, hull.max.x), Interval::new(hull.min.y, hull.max.y)];
                bounds = Some(bounds.map_or(own, |all| [all[0].union(own[0]), all[1].union(own[1])]));
                trim.part = CurvePart::whole(parts.curves_2d.len(), flat.domain());
                parts.curves_2d.push(Some(flat));
                kept.push(place);
            }
            if let Some(own) = parts.loops.get_mut(chain) {
                own.trims = kept;
            }
        }
        let (Some([x, y]), Some(own)) = (bounds, parts.faces.get_mut(face)) else { return Ok(brep) };
        own.surface = Some(parts.surfaces.len());
        parts.surfaces.push(Some(PlaneSurface::new(plane, x, y)?.into()));
    }
    parts.set_kinds();
    parts.set_iso();
    parts.measure_tolerances();
    match Brep::from_parts(parts).and_then(Brep::checked) {
        Ok(made) => Ok(made),
        // A shape that cannot be written so is taken as it is.
        Err(_) => Ok(brep),
    }
}

/// The plane of a flat face with a singular trim, its normal being that of the surface.
fn singular_plane(brep: &Brep, face: usize) -> Option<Plane> {
    let own = brep.faces().get(face).filter(|own| !own.deleted)?;
    let trims = own.loops.iter().filter_map(|l| brep.loops().get(*l)).flat_map(|chain| &chain.trims);
    trims.filter_map(|trim| brep.trims().get(*trim)).find(|trim| trim.edge.is_none())?;
    let surface: &Surface = brep.face_surface(face)?;
    let [u, v] = Direction::BOTH.map(|d| surface.domain(d).middle());
    let size =
        surface.isocurve(Direction::U, v).ok()?.length() + surface.isocurve(Direction::V, u).ok()?.length();
    let plane = surface.plane(FLAT * size)?;
    let along = surface.normal_at(u, v)?.dot(plane.z_axis) > 0.0;
    Some(if along { plane } else { plane.flipped() })
}
