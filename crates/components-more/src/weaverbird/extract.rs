//! Wb Extract: parts of meshes, and meshes joined.

use std::collections::HashMap;
use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::{Curve, Line, Mesh, Point3, PolylineCurve};

use super::{bodies, each, outlines};
use crate::polygons::{Polygons, sides};

/// Joins meshes to one. Stands for Weaverbird's Join Meshes and Weld.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b31",
    name = "Join Meshes and Weld",
    nick = "wbJoin",
    at = "Weaverbird/Wb Extract"
)]
#[output("Mesh", "M", "The mesh.")]
fn join_and_weld(
    context: &Context<'_>,
    /// The meshes.
    #[port("Meshes", "M+")]
    meshes: List<Shared<Mesh>>,
    /// Whether vertices in one place become one.
    #[port("Weld", "W", default = true)]
    weld: bool,
) -> Result<Shared<Mesh>, Message> {
    let meshes: Vec<Mesh> = meshes.present().map(|mesh| (*mesh).clone()).collect();
    let whole = Mesh::join(&meshes)?;
    Ok(Shared::new(if weld { Polygons::of_mesh(&whole).to_mesh(context)? } else { whole }))
}

/// The edges of a mesh as lines. Stands for Weaverbird's Mesh Edges.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b32",
    name = "Mesh Edges",
    nick = "wbEdges",
    at = "Weaverbird/Wb Extract"
)]
#[output("Lines", "L", "The edges, each once.")]
fn mesh_edges(
    context: &Context<'_>,
    /// Meshes, or closed polylines that are the faces of one body.
    #[port("Mesh or Polylines", "G")]
    items: List<Value>,
) -> Result<Vec<Line>, Message> {
    let mut lines = Vec::new();
    for body in bodies(&items)? {
        let edges = body.polygons.edges();
        context.items(edges.list.len())?;
        lines.extend(edges.list.iter().map(|&(a, b)| Line::new(body.polygons.at(a), body.polygons.at(b))));
    }
    Ok(lines)
}

/// The faces of a mesh as closed polylines. Stands for Weaverbird's Face Polylines.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b33",
    name = "Face Polylines",
    nick = "wbFaces",
    at = "Weaverbird/Wb Extract"
)]
#[output("Polygons", "P", "A closed polyline for each face.")]
fn face_polylines(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<Vec<Value>, Message> {
    context.items(mesh.faces().len())?;
    Ok(outlines(&Polygons::of_mesh(mesh)))
}

/// The boundary of a mesh as polylines: closed ones where it goes round. Stands for Weaverbird's Naked boundary.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b34",
    name = "Naked boundary",
    nick = "wbNakedBoundary",
    at = "Weaverbird/Wb Extract"
)]
#[output("Naked curves", "C", "The boundary, piece by piece.")]
fn naked_boundary(
    /// Meshes, or closed polylines that are the faces of one body.
    #[port("Mesh/Closed Polylines", "M")]
    items: List<Value>,
) -> Result<Vec<Value>, Message> {
    let mut curves = Vec::new();
    for body in bodies(&items)? {
        let polygons = body.polygons;
        let edges = polygons.edges();
        let mut next: HashMap<usize, Vec<usize>> = HashMap::new();
        let mut starts = Vec::new();
        for (a, b) in polygons.faces.iter().flat_map(|face| sides(face)) {
            if edges.number(a, b).is_some_and(|e| edges.is_naked(e)) {
                next.entry(a).or_default().push(b);
                starts.push(a);
            }
        }
        for start in starts {
            let mut chain = vec![start];
            let mut at = start;
            while let Some(to) = next.get_mut(&at).and_then(Vec::pop) {
                chain.push(to);
                at = to;
                if to == start {
                    break;
                }
            }
            if chain.len() > 1 {
                let points: Vec<Point3> = chain.into_iter().map(|i| polygons.at(i)).collect();
                curves
                    .extend(PolylineCurve::new(points).ok().map(|curve| Value::from(Curve::Polyline(curve))));
            }
        }
    }
    Ok(curves)
}

/// The vertices of a mesh. Stands for Weaverbird's Vertices.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b35",
    name = "Vertices Component",
    nick = "wbVertices",
    at = "Weaverbird/Wb Extract"
)]
#[output("Points", "P", "The vertices.")]
fn vertices(
    /// Meshes, or closed polylines that are the faces of one body.
    #[port("Mesh/Closed polylines group", "G")]
    items: List<Value>,
    /// Whether vertices in one place are given once.
    #[port("Weld", "W", default = true)]
    weld: bool,
) -> Result<Vec<Point3>, Message> {
    if weld {
        return Ok(bodies(&items)?.into_iter().flat_map(|body| body.polygons.points).collect());
    }
    let mut points = Vec::new();
    for item in items.present() {
        match &item {
            Value::Mesh(mesh) => points.extend(mesh.vertices()),
            Value::Curve(curve) => points.extend(curve.as_polyline().unwrap_or_default()),
            _ => return Err(Message::error("Neither a mesh nor a closed polyline")),
        }
    }
    Ok(points)
}

/// Turns faces round so that all neighbours look to the same side, that of the first face of each piece. Stands for Weaverbird's
/// Unify face windings.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b36",
    name = "Unify face windings",
    nick = "wbUnifyWindings",
    at = "Weaverbird/Wb Extract"
)]
#[output(
    "Output Mesh/Curves",
    "O",
    "The results: meshes from meshes, closed polylines from closed polylines."
)]
fn unify_windings(
    context: &Context<'_>,
    /// Meshes, or closed polylines that are the faces of one body.
    #[port("Mesh/Curves", "M")]
    bodies: List<Value>,
) -> Result<Vec<Value>, Message> {
    each(context, &bodies, |body| {
        let edges = body.edges();
        let mut turned = body.clone();
        let mut seen = vec![false; body.faces.len()];
        for start in 0..body.faces.len() {
            let mut stack = vec![start];
            while let Some(f) = stack.pop() {
                match seen.get_mut(f) {
                    Some(seen) if !*seen => *seen = true,
                    _ => continue,
                }
                for (a, b) in sides(&turned.faces.get(f).cloned().unwrap_or_default()) {
                    let beside = edges.number(a, b).and_then(|e| edges.faces.get(e));
                    for &g in beside.into_iter().flatten().filter(|g| **g != f) {
                        if seen.get(g).is_none_or(|seen| *seen) {
                            continue;
                        }
                        if let Some(face) = turned.faces.get_mut(g)
                            && sides(face).any(|side| side == (a, b))
                        {
                            face.reverse();
                        }
                        stack.push(g);
                    }
                }
            }
        }
        Ok(turned)
    })
}

/// The dual of a mesh: a face for each inner vertex, between the middles of the faces around it. Stands for Weaverbird's Dual
/// graph; that the boundary is left open is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b37",
    name = "Dual graph",
    nick = "wbDual",
    at = "Weaverbird/Wb Extract"
)]
#[output("Polylines", "P", "A closed polyline for each inner vertex.")]
fn dual_graph(
    context: &Context<'_>,
    /// Meshes, or closed polylines that are the faces of one body.
    #[port("Mesh/Curves", "M")]
    items: List<Value>,
) -> Result<Vec<Value>, Message> {
    let mut curves = Vec::new();
    for body in bodies(&items)? {
        let polygons = body.polygons;
        context.items(polygons.points.len())?;
        let edges = polygons.edges();
        let boundary = polygons.naked_vertices();
        let mut dual = Polygons {
            points: polygons.faces.iter().map(|f| polygons.middle(f)).collect(),
            faces: Vec::new(),
        };
        for (i, ring) in polygons.rings().into_iter().enumerate().filter(|(i, _)| !boundary.contains(i)) {
            let n = ring.len();
            let around = (0..n).filter_map(|k| {
                let (a, b) = (*ring.get(k)?, *ring.get((k + 1) % n)?);
                let beside = edges.number(i, a).and_then(|e| edges.faces.get(e))?;
                beside.iter().copied().find(|f| polygons.faces.get(*f).is_some_and(|face| face.contains(&b)))
            });
            let around: Vec<usize> = around.collect();
            if around.len() > 2 {
                dual.faces.push(around);
            }
        }
        curves.extend(outlines(&dual));
    }
    Ok(curves)
}

/// Parts the faces of a mesh by their numbers. Stands for Weaverbird's Reroute Faces.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b38",
    name = "Reroute Faces",
    nick = "wbReroute",
    at = "Weaverbird/Wb Extract"
)]
#[output("Mesh0", "R0", "The faces of those numbers; none where there are none.")]
#[output("Mesh1", "R1", "The other faces.")]
fn reroute_faces(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The numbers of the faces, from 0.
    #[port("Index", "N+")]
    indices: List<i32>,
) -> Result<(Option<Shared<Mesh>>, Option<Shared<Mesh>>), Message> {
    let count = mesh.faces().len();
    context.items(count)?;
    let mut chosen = vec![false; count];
    for index in indices.present() {
        match usize::try_from(index).ok().and_then(|index| chosen.get_mut(index)) {
            Some(slot) => *slot = true,
            None => context.warn(format!("The mesh has no face {index}: there are {count}")),
        }
    }
    parted(mesh, &chosen)
}

/// A mesh as a pair of meshes, or none where it has no faces.
type Parted = Result<(Option<Shared<Mesh>>, Option<Shared<Mesh>>), Message>;

/// The faces of a mesh that are chosen, and the others.
fn parted(mesh: &Mesh, chosen: &[bool]) -> Parted {
    let part = |wanted: bool| -> Result<Option<Shared<Mesh>>, Message> {
        let faces: Vec<_> = mesh
            .faces()
            .iter()
            .zip(chosen)
            .filter(|(_, own)| **own == wanted)
            .map(|(face, _)| *face)
            .collect();
        if faces.is_empty() {
            return Ok(None);
        }
        Ok(Some(Shared::new(mesh.part(&faces)?)))
    };
    Ok((part(true)?, part(false)?))
}

/// Parts the faces of a mesh by a pattern that starts again and again. Null counts as false. Stands for Weaverbird's Reroute Faces by
/// Pattern.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b39",
    name = "Reroute Faces by Pattern",
    nick = "wbReroutePattern",
    at = "Weaverbird/Wb Extract"
)]
#[output(
    "Mesh0, containing 'true' values",
    "T",
    "The faces at whose place is true; none where there are none."
)]
#[output("Mesh1, containing 'false' values", "F", "The other faces.")]
fn reroute_by_pattern(
    context: &Context<'_>,
    /// The mesh, open or closed.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// For each face whether it goes to the first mesh.
    #[port("Index", "P+")]
    pattern: List<bool>,
) -> Result<(Option<Shared<Mesh>>, Option<Shared<Mesh>>), Message> {
    if pattern.is_empty() {
        return Err(Message::error("The pattern is empty"));
    }
    let count = mesh.faces().len();
    context.items(count)?;
    let pattern: Vec<bool> = pattern.iter().map(|own| own.unwrap_or(false)).collect();
    let chosen: Vec<bool> = pattern.iter().copied().cycle().take(count).collect();
    parted(mesh, &chosen)
}
