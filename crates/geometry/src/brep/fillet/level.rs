//! Flat faces on surfaces that are singular somewhere, as the walls of a pyramid are at its tip, put on planes: there
//! every rail has its place.

use std::collections::BTreeMap;

use crate::brep::flatten::flattened;
use crate::brep::{Along, Brep, Builder, NewEdge, NewVertex, Path};
use crate::{BoundingBox, Curve, Direction, Error, Interval, Plane, PlaneSurface, Result, Surface};

/// Up to this part of its size a face is flat.
const FLAT: f64 = 1e-12;

/// The brep with those faces on planes; its vertices, edges and faces keep their places.
pub(super) fn levelled(brep: Brep, limit: f64) -> Result<Brep> {
    let mut planes = BTreeMap::new();
    for face in 0..brep.faces().len() {
        crate::cancellation::check()?;
        planes.extend(singular_plane(&brep, face).map(|plane| (face, plane)));
    }
    let whole = !brep.edges().iter().any(|own| own.deleted) && !brep.faces().iter().any(|own| own.deleted);
    if planes.is_empty() || !whole {
        return Ok(brep);
    }
    let none = || Error::degenerate("brep", "an edge or a trim has no curve or no vertex");
    let mut builder = Builder::new();
    let vertices: Vec<NewVertex> = brep.vertices().iter().map(|own| builder.vertex(own.point)).collect();
    let vertex = |place: Option<usize>| place.and_then(|place| vertices.get(place).copied()).ok_or_else(none);
    let mut edges: Vec<NewEdge> = Vec::with_capacity(brep.edges().len());
    for (place, own) in brep.edges().iter().enumerate() {
        let curve = brep.edge_as_curve(place)?.ok_or_else(none)?;
        edges.push(builder.edge(curve, [vertex(own.vertices[0])?, vertex(own.vertices[1])?]));
    }
    for (place, own) in brep.faces().iter().enumerate() {
        crate::cancellation::check()?;
        let mut loops = Vec::with_capacity(own.loops.len());
        let plane = planes.get(&place);
        for chain in own.loops.iter().filter_map(|l| brep.loops().get(*l)) {
            let mut paths = Vec::with_capacity(chain.trims.len());
            for &trim in &chain.trims {
                let old = brep.trims().get(trim).ok_or_else(none)?;
                let along = match old.edge {
                    Some(edge) => Along::Edge(*edges.get(edge).ok_or_else(none)?, old.reversed),
                    None if plane.is_some() => continue,
                    None => Along::Point(vertex(old.vertices[0])?),
                };
                let curve = match (plane, old.edge) {
                    (Some(plane), Some(edge)) => {
                        let flat = flattened(&brep.edge_as_curve(edge)?.ok_or_else(none)?, plane)?;
                        if old.reversed { flat.reversed() } else { flat }
                    }
                    _ => brep.trim_as_curve(trim)?.ok_or_else(none)?,
                };
                paths.push(Path { curve, along });
            }
            loops.push((chain.kind, paths));
        }
        let surface = match plane {
            Some(plane) => {
                on_plane(plane, loops.iter().flat_map(|(_, paths)| paths).map(|path| &path.curve))?
            }
            None => brep.face_surface(place).cloned().ok_or_else(none)?,
        };
        let new = builder.face(surface, own.reversed);
        if let Some(made) = builder.parts.faces.last_mut() {
            (made.material_channel, made.id, made.colour) = (own.material_channel, own.id, own.colour);
        }
        for (kind, paths) in loops {
            builder.bound(new, kind, paths)?;
        }
    }
    let worst = brep.edges().iter().map(|edge| edge.tolerance).fold(0.0, f64::max);
    builder.finish(limit + worst)
}

/// The part of a plane that curves in its coordinates take.
fn on_plane<'a>(plane: &Plane, curves: impl Iterator<Item = &'a Curve>) -> Result<Surface> {
    let boxes = curves.map(Curve::bounding_box);
    let hull = boxes.reduce(|a: BoundingBox, b| a.union(&b));
    let hull = hull.ok_or(Error::degenerate("brep", "a face has no border"))?;
    let range = |a: f64, b: f64| Interval::new(a, b);
    Ok(PlaneSurface::new(*plane, range(hull.min.x, hull.max.x), range(hull.min.y, hull.max.y))?.into())
}

/// The plane of a flat face with a singular trim, its normal being that of the surface.
fn singular_plane(brep: &Brep, face: usize) -> Option<Plane> {
    let own = brep.faces().get(face).filter(|own| !own.deleted)?;
    let trims = own.loops.iter().filter_map(|l| brep.loops().get(*l)).flat_map(|chain| &chain.trims);
    let edges: Vec<Option<usize>> = trims.filter_map(|trim| Some(brep.trims().get(*trim)?.edge)).collect();
    // A seam, as a disc about a pole has one, has no place on a plane.
    let is_seam =
        |edge: &Option<usize>| edge.is_some() && edges.iter().filter(|other| *other == edge).count() > 1;
    if edges.iter().all(Option::is_some) || edges.iter().any(is_seam) {
        return None;
    }
    let surface: &Surface = brep.face_surface(face)?;
    let [u, v] = Direction::BOTH.map(|d| surface.domain(d).middle());
    let size =
        surface.isocurve(Direction::U, v).ok()?.length() + surface.isocurve(Direction::V, u).ok()?.length();
    let plane = surface.plane(FLAT * size)?;
    let along = surface.normal_at(u, v)?.dot(plane.z_axis) > 0.0;
    Some(if along { plane } else { plane.flipped() })
}
