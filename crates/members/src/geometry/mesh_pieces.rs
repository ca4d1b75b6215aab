//! Faces of meshes turned to one side, and meshes taken apart where they are not welded.

use std::collections::{BTreeMap, HashMap};

use katydid_geometry::{Mesh, MeshFace};

use super::answer::Outcome;
use super::table::Endpoints;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("mesh/unifynormals-mesh", |m: Mesh| unified(&m, false));
    table.add("mesh/unifynormals-mesh_bool", |m: Mesh, count_only: bool| unified(&m, count_only));
    table.add("mesh/explodeatunweldededges-mesh", |m: Mesh| unwelded(&m));
}

/// The sides of a face, from corner to corner.
fn sides(face: &MeshFace, place: &[u32]) -> Vec<(u32, u32)> {
    let corner = |i: &u32| place.get(*i as usize).copied().unwrap_or(*i);
    let indices = face.indices();
    indices.iter().zip(indices.iter().cycle().skip(1)).map(|(a, b)| (corner(a), corner(b))).collect()
}

/// The mesh with its faces turned until neighbours look to the same side, and how many were turned; the first face of
/// each piece gives the side. When they are only counted, the mesh stays.
fn unified(mesh: &Mesh, count_only: bool) -> Outcome<(usize, Mesh)> {
    let place = mesh.merged_indices();
    let mut along: HashMap<(u32, u32), Vec<usize>> = HashMap::new();
    for (i, face) in mesh.faces().iter().enumerate() {
        for (a, b) in sides(face, &place) {
            along.entry((a.min(b), a.max(b))).or_default().push(i);
        }
    }
    let mut turned: Vec<Option<bool>> = vec![None; mesh.faces().len()];
    for first in 0..turned.len() {
        let mut todo = vec![(first, false)];
        while let Some((i, turn)) = todo.pop() {
            match turned.get_mut(i) {
                Some(known @ None) => *known = Some(turn),
                _ => continue,
            }
            let Some(face) = mesh.faces().get(i) else { continue };
            for (a, b) in sides(face, &place) {
                let others = along.get(&(a.min(b), a.max(b))).map_or(&[][..], Vec::as_slice);
                // Where more than two meet, no side is the same.
                for &j in others.iter().filter(|&&j| j != i && others.len() == 2) {
                    let Some(other) = mesh.faces().get(j) else { continue };
                    // Those that look to the same side walk the side between them in opposite directions.
                    todo.push((j, turn != sides(other, &place).contains(&(a, b))));
                }
            }
        }
    }
    let turned: Vec<bool> = turned.into_iter().map(Option::unwrap_or_default).collect();
    let count = turned.iter().filter(|turn| **turn).count();
    if count_only || count == 0 {
        return Ok((count, mesh.clone()));
    }
    let faces = mesh.faces().iter().zip(turned).map(|(face, turn)| if turn { face.flipped() } else { *face });
    let (vertices, colours) = (mesh.vertices().to_vec(), mesh.colours().to_vec());
    let whole = Mesh::from_parts(vertices, faces.collect(), Vec::new(), colours)?;
    Ok((count, if mesh.normals().is_empty() { whole } else { whole.with_normals() }))
}

/// The parts that hang together by edges whose two vertices are the same for both faces.
fn unwelded(mesh: &Mesh) -> Outcome<Vec<Mesh>> {
    let mut parent: Vec<usize> = (0..mesh.faces().len()).collect();
    let root = |parent: &mut Vec<usize>, mut at: usize| {
        while let Some(&up) = parent.get(at).filter(|up| **up != at) {
            let next = parent.get(up).copied().unwrap_or(up);
            if let Some(place) = parent.get_mut(at) {
                *place = next;
            }
            at = up;
        }
        at
    };
    let mut edges: HashMap<(u32, u32), usize> = HashMap::new();
    for (i, face) in mesh.faces().iter().enumerate() {
        for (a, b) in sides(face, &[]) {
            let other = *edges.entry((a.min(b), a.max(b))).or_insert(i);
            let (x, y) = (root(&mut parent, i), root(&mut parent, other));
            if let Some(place) = parent.get_mut(x.max(y)) {
                *place = x.min(y);
            }
        }
    }
    let mut parts: BTreeMap<usize, Vec<MeshFace>> = BTreeMap::new();
    for (i, face) in mesh.faces().iter().enumerate() {
        parts.entry(root(&mut parent, i)).or_default().push(*face);
    }
    parts.values().map(|faces| Ok(mesh.part(faces)?)).collect()
}
