//! Meshes with vertices of their own at some places, drawn along a direction, cut by others.

use katydid_geometry::{Mesh, MeshFace, Point3, Solid, Vector3};

use super::answer::Outcome;
use super::argument::{Some1, Waiting};
use super::mesh_make::{combined, union};
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("mesh/unweldvertices-mesh_intarray_bool", |m: Mesh, places: Some1<i32>, modify: bool| {
        let unwelded = unwelded_at(&m, &places.0)?;
        Ok((true, if modify { unwelded.with_normals() } else { unwelded }))
    });
    table.add(
        "mesh/offset-mesh_double_bool_vector3d",
        |m: Mesh, distance: f64, solid: bool, direction: Vector3| {
            drawn(&m, distance, solid, direction).map(|(mesh, _)| mesh)
        },
    );
    table.add(
        "mesh/offset-mesh_double_bool_vector3d_intarray",
        |m: Mesh, distance: f64, solid: bool, direction: Vector3| drawn(&m, distance, solid, direction),
    );
    table.add("mesh/createbooleansplit-mesharray_mesharray", |a: Some1<Mesh>, b: Some1<Mesh>, w: Waiting| {
        let cutter = union(&b.0, "meshSplitters")?;
        let mut pieces = Vec::new();
        for (i, mesh) in a.0.iter().enumerate() {
            w.check()?;
            let solid = Solid::new(mesh).map_err(|error| {
                Fault::bad_request(format!("meshesToSplit: mesh {i} cannot be cut: {error}"))
            })?;
            pieces.extend(combined(solid.difference(&cutter)?)?);
            pieces.extend(combined(solid.intersection(&cutter)?)?);
        }
        Ok(pieces)
    });
}

/// The mesh in which no two faces share a vertex at some places, counted in the order in which the vertices name them
/// first. The first face at a vertex keeps it.
fn unwelded_at(mesh: &Mesh, places: &[i32]) -> Outcome<Mesh> {
    let merged = mesh.merged_indices();
    let firsts: Vec<u32> =
        merged.iter().zip(0..).filter(|(own, i)| **own == *i).map(|(own, _)| *own).collect();
    let mut loose = vec![false; mesh.vertices().len()];
    for place in places {
        let first = usize::try_from(*place).ok().and_then(|place| firsts.get(place));
        let first = first.ok_or_else(|| {
            Fault::bad_request(format!(
                "topologyVertexIndices: {place} is not 0 to {}",
                firsts.len().saturating_sub(1)
            ))
        })?;
        if let Some(loose) = loose.get_mut(*first as usize) {
            *loose = true;
        }
    }
    let is_loose = |i: u32| merged.get(i as usize).and_then(|own| loose.get(*own as usize)) == Some(&true);
    let mut taken = vec![false; mesh.vertices().len()];
    let mut copies: Vec<u32> = Vec::new();
    let count = mesh.vertices().len();
    let faces = mesh.faces().iter().map(|face| {
        let mut own = Vec::with_capacity(4);
        for &i in face.indices() {
            let is_new =
                is_loose(i) && taken.get_mut(i as usize).is_some_and(|taken| std::mem::replace(taken, true));
            own.push(if is_new {
                copies.push(i);
                u32::try_from(count + copies.len() - 1).unwrap_or(i)
            } else {
                i
            });
        }
        match *own.as_slice() {
            [a, b, c, d] => MeshFace::Quad([a, b, c, d]),
            [a, b, c] => MeshFace::Triangle([a, b, c]),
            _ => *face,
        }
    });
    let faces: Vec<MeshFace> = faces.collect();
    Ok(Mesh::from_parts(
        with_copies(mesh.vertices(), &copies),
        faces,
        with_copies(mesh.normals(), &copies),
        with_copies(mesh.colours(), &copies),
    )?)
}

/// A list with some of its members once more at its end; an empty list stays empty.
fn with_copies<T: Copy>(list: &[T], copies: &[u32]) -> Vec<T> {
    list.iter().copied().chain(copies.iter().filter_map(|i| list.get(*i as usize).copied())).collect()
}

/// The mesh moved by a distance along a direction; solid, with itself behind and walls between the rims of both, whose
/// faces are listed.
fn drawn(mesh: &Mesh, distance: f64, solid: bool, direction: Vector3) -> Outcome<(Mesh, Vec<i32>)> {
    let way = direction.unitized().ok_or_else(|| Fault::bad_request("direction has no length"))? * distance;
    let moved: Vec<Point3> = mesh.vertices().iter().map(|p| *p + way).collect();
    if !solid {
        return Ok((Mesh::new(moved, mesh.faces().to_vec())?.with_normals(), Vec::new()));
    }
    if distance == 0.0 {
        return Err(Fault::bad_request("distance is 0: nothing lies between"));
    }
    let count = u32::try_from(moved.len()).map_err(|_| Fault::too_large("the mesh has too many vertices"))?;
    let far = |i: u32| i.checked_add(count).ok_or_else(|| Fault::too_large("the mesh has too many vertices"));
    let mut faces: Vec<MeshFace> = mesh.faces().iter().map(|face| face.flipped()).collect();
    far(count)?;
    faces.extend(mesh.faces().iter().map(|face| face.map(|i| i.saturating_add(count))));
    let first_wall = faces.len();
    for edge in mesh.edges().iter().filter(|edge| edge.faces == 1) {
        let [a, b] = edge.vertices;
        faces.push(MeshFace::Quad([far(b)?, far(a)?, a, b]));
    }
    let walls = (first_wall..faces.len()).filter_map(|i| i32::try_from(i).ok()).collect();
    let whole = Mesh::new(mesh.vertices().iter().copied().chain(moved).collect(), faces)?;
    let outwards = if whole.volume() < 0.0 { whole.flipped() } else { whole };
    Ok((outwards.with_normals(), walls))
}
