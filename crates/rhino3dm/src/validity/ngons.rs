//! Polygons of faces in meshes.

use std::collections::HashMap;

use super::Verdict;
use super::mesh::corners;
use crate::{MeshObject, Ngon};

/// Whether each polygon has corners and faces that are there, and goes round its faces.
pub(super) fn verdict(mesh: &MeshObject) -> Verdict {
    for (i, ngon) in mesh.ngons.iter().enumerate() {
        one(ngon, mesh).map_err(|why| format!("polygon {i} {why}"))?;
    }
    Ok(())
}

fn one(ngon: &Ngon, mesh: &MeshObject) -> Verdict {
    if ngon.vertices.is_empty() && ngon.faces.is_empty() {
        return Ok(());
    }
    if ngon.vertices.len() < 3 || ngon.faces.is_empty() {
        return Err("has too few corners or faces".into());
    }
    if !ngon.vertices.iter().all(|i| (*i as usize) < mesh.vertices.len()) {
        return Err("names a vertex that is not there".into());
    }
    // An edge on the rim has one face of the polygon.
    let mut edges: HashMap<(u32, u32), usize> = HashMap::new();
    for i in &ngon.faces {
        let face = mesh.faces.get(*i as usize).ok_or("names a face that is not there")?;
        let corners = corners(face);
        for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            *edges.entry((*a.min(b), *a.max(b))).or_default() += 1;
        }
    }
    let rim: Vec<(u32, u32)> =
        edges.into_iter().filter(|(_, faces)| *faces == 1).map(|(edge, _)| edge).collect();
    let on_rim: std::collections::HashSet<u32> = rim.iter().flat_map(|(a, b)| [*a, *b]).collect();
    if rim.len() < ngon.vertices.len() || !ngon.vertices.iter().all(|i| on_rim.contains(i)) {
        return Err("does not go round its faces".into());
    }
    Ok(())
}
