//! Breps out of shells.

use super::layout::{Along, End, Layout, Outcome, lay_out};
use super::place::Space;
use super::topology::{Topology, no_faces};
use crate::{Error, Result};
use katydid_geometry::brep::{self, Builder, NewEdge, NewVertex, Path};
use katydid_geometry::{BoundingBox, Brep};

/// How far curves on surfaces may be from edges, as a part of the size of the brep.
const FIT: f64 = 1e-7;
/// How far edges may be from their faces at all, as a part of the size of the brep, and the ends of their images from each
/// other, as a part of the size of the loop.
const LOOSEST: f64 = 1e-2;

/// The brep of shells, each turned over or not.
pub(super) fn brep(space: &Space<'_>, id: u64, shells: &[(u64, bool)]) -> Result<Built> {
    let mut topology = Topology::default();
    for (shell, turned) in shells {
        topology.add_shell(space, *shell, *turned)?;
    }
    of_topology(space, id, topology)
}

/// The brep of loose faces.
pub(super) fn of_faces(space: &Space<'_>, id: u64, faces: &[u64]) -> Result<Built> {
    let mut topology = Topology::default();
    for face in faces {
        topology.add_face(space, *face, false, 0)?;
    }
    of_topology(space, id, topology)
}

/// A brep and the entities that its faces were.
pub(super) struct Built {
    pub(super) brep: Brep,
    pub(super) faces: Vec<u64>,
}

fn of_topology(space: &Space<'_>, id: u64, mut topology: Topology) -> Result<Built> {
    if topology.faces.is_empty() {
        return Err(no_faces(id));
    }
    let whole = topology.take_whole();
    let mut faces: Vec<u64> = topology.faces.iter().map(|face| face.id).collect();
    let mut breps = Vec::new();
    if let Some(reversed) = topology.faces.first().map(|face| face.reversed) {
        let brep = bounded(space, id, &mut topology)?;
        // Beside whole spheres it may be the inside of a void.
        let is_turned = brep.faces().first().is_some_and(|face| face.reversed != reversed);
        breps.push(if is_turned && !whole.is_empty() { brep.flipped() } else { brep });
    }
    for face in whole {
        let surface = face.support.whole().ok_or_else(|| Error::entity(face.id, "it has no loops"))??;
        let brep = Brep::from_surface(surface).map_err(|error| Error::entity(face.id, error.to_string()))?;
        breps.push(if face.reversed { brep.flipped() } else { brep });
        faces.push(face.id);
    }
    let brep = if breps.len() == 1 { breps.swap_remove(0) } else { Brep::merged(&breps) };
    Ok(Built { brep: brep.turned_outward(), faces })
}

/// The brep of faces that have loops.
fn bounded(space: &Space<'_>, id: u64, topology: &mut Topology) -> Result<Brep> {
    let hull: Option<BoundingBox> = Option::from(&*topology);
    let size = hull.map_or(1.0, |hull| hull.diagonal().length());
    let tolerance = (FIT * size).min(space.tolerance.max(1e-9 * size));
    let layouts = lay_out_all(topology, tolerance)?;
    let named = |error: katydid_geometry::Error| Error::entity(id, error.to_string());
    build(topology, layouts)?.finish(LOOSEST * size).map_err(named)
}

/// Lays out all faces, dividing edges where seams have to end on them.
fn lay_out_all(topology: &mut Topology, tolerance: f64) -> Result<Vec<Layout>> {
    let count = topology.faces.len();
    let mut layouts: Vec<Option<Layout>> = (0..count).map(|_| None).collect();
    let mut waiting: Vec<usize> = (0..count).rev().collect();
    let mut splits = 0;
    while let Some(place) = waiting.pop() {
        let Some(face) = topology.faces.get(place) else { continue };
        let id = face.id;
        let named = |error: Error| match error {
            Error::Geometry(error) => Error::entity(id, error.to_string()),
            other => other,
        };
        match lay_out(topology, face, tolerance).map_err(named)? {
            Outcome::Done(layout) => layouts[place] = Some(*layout),
            Outcome::Split(edge, point) => {
                splits += 1;
                if splits > 4 * count {
                    return Err(Error::entity(id, "its loops cannot be cut open"));
                }
                for touched in topology.split(edge, point).map_err(named)? {
                    layouts[touched] = None;
                    waiting.retain(|k| *k != touched);
                    waiting.push(touched);
                }
            }
        }
    }
    Ok(layouts.into_iter().flatten().collect())
}

fn build(topology: &Topology, layouts: Vec<Layout>) -> Result<Builder> {
    let mut builder = Builder::new();
    let mut vertices: Vec<Option<NewVertex>> = vec![None; topology.points.len()];
    let mut edges: Vec<Option<NewEdge>> = vec![None; topology.edges.len()];
    for (layout, face) in layouts.into_iter().zip(&topology.faces) {
        let mut vertex = |builder: &mut Builder, place: usize| {
            *vertices[place].get_or_insert_with(|| builder.vertex(topology.points[place]))
        };
        let mut tip = None;
        let seam = layout.seam.map(|seam| {
            let ends = seam.ends.map(|end| match end {
                End::Vertex(place) => vertex(&mut builder, place),
                End::Tip(point) => *tip.get_or_insert_with(|| builder.vertex(point)),
            });
            builder.edge(seam.curve, ends)
        });
        let new = builder.face(layout.surface, face.reversed);
        for (kind, pieces) in layout.loops {
            let mut paths = Vec::with_capacity(pieces.len());
            for piece in pieces {
                let along = match (piece.along, seam, tip) {
                    (Along::Edge(one), _, _) => {
                        let edge = topology.edge(one.edge)?;
                        let ends = edge.vertices.map(|place| vertex(&mut builder, place));
                        let known =
                            edges[one.edge].get_or_insert_with(|| builder.edge(edge.curve.clone(), ends));
                        brep::Along::Edge(*known, one.reversed)
                    }
                    (Along::Seam(reversed), Some(seam), _) => brep::Along::Edge(seam, reversed),
                    (Along::Vertex(place), _, _) => brep::Along::Point(vertex(&mut builder, place)),
                    (Along::Tip, _, Some(tip)) => brep::Along::Point(tip),
                    _ => continue,
                };
                paths.push(Path { curve: piece.curve, along });
            }
            let named = |error: katydid_geometry::Error| Error::entity(face.id, error.to_string());
            builder.bound_closing(new, kind, paths, LOOSEST).map_err(named)?;
        }
    }
    Ok(builder)
}
