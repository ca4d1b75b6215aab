//! Meshes and SubDs.

use base64::Engine;
use katydid_3dm::{MeshObject, MeshParameters, SubDObject};
use katydid_geometry::Interval;
use serde_json::{Value, json};

pub(crate) fn mesh(mesh: &MeshObject) -> Value {
    let domains = |d: &[Interval; 2]| json!([[d[0].start, d[0].end], [d[1].start, d[1].end]]);
    let ngons: Vec<Value> =
        mesh.ngons.iter().map(|n| json!({"vertices": n.vertices, "faces": n.faces})).collect();
    json!({
        "counts": [mesh.vertices.len(), mesh.faces.len()],
        "vertices": singles(mesh.vertices.as_flattened()),
        "double_vertices": doubles(mesh.double_vertices.as_flattened()),
        "faces": packed(mesh.faces.as_flattened().iter().flat_map(|i| i.to_le_bytes())),
        "normals": singles(mesh.normals.as_flattened()),
        "texture_coordinates": singles(mesh.texture_coordinates.as_flattened()),
        "colours": packed(mesh.colours.as_flattened().iter().copied()),
        "curvatures": doubles(mesh.curvatures.as_flattened()),
        "surface_parameters": doubles(mesh.surface_parameters.as_flattened()),
        "ngons": ngons,
        "packed_texture_domain": domains(&mesh.packed_texture_domain),
        "packed_texture_rotated": mesh.packed_texture_rotated,
        "surface_domain": domains(&mesh.surface_domain),
        "surface_scale": mesh.surface_scale,
        "vertex_box": mesh.vertex_box,
        "closed": mesh.closed,
        "flags": [mesh.manifold, mesh.oriented, mesh.solid],
        "parameters": mesh.parameters.as_deref().map(parameters),
        "mapping": mesh.mapping.mapping.to_string(),
        "kernel": mesh.to_mesh().err().map(|e| e.to_string()),
    })
}

fn parameters(p: &MeshParameters) -> Value {
    json!({"grid_aspect_ratio": p.grid_aspect_ratio, "tolerance": p.tolerance, "texture_range": p.texture_range,
        "simple_planes": p.simple_planes, "refine": p.refine, "jagged_seams": p.jagged_seams,
        "grid_counts": p.grid_counts, "relative_tolerance": p.relative_tolerance})
}

/// Many numbers as base64 of their little-endian bytes.
fn packed(bytes: impl Iterator<Item = u8>) -> String {
    base64::engine::general_purpose::STANDARD.encode(bytes.collect::<Vec<u8>>())
}

fn singles(numbers: &[f32]) -> String {
    packed(numbers.iter().flat_map(|x| x.to_le_bytes()))
}

fn doubles(numbers: &[f64]) -> String {
    packed(numbers.iter().flat_map(|x| x.to_le_bytes()))
}

pub(crate) fn subd(subd: &SubDObject) -> Value {
    let levels: Vec<Value> = (subd.levels.iter())
        .map(|level| {
            json!({"counts": [level.vertices.len(), level.edges.len(), level.faces.len()],
                "vertex_ids": level.vertices.iter().map(|v| v.part.id).collect::<Vec<_>>(),
                "edge_ids": level.edges.iter().map(|e| e.part.id).collect::<Vec<_>>(),
                "points": level.vertices.iter().map(|v| v.point).collect::<Vec<_>>(),
                "vertex_tags": level.vertices.iter().map(|v| v.tag).collect::<Vec<_>>(),
                "edge_tags": level.edges.iter().map(|e| e.tag).collect::<Vec<_>>(),
                "sectors": level.edges.iter().map(|e| e.sector_coefficients).collect::<Vec<_>>(),
                "sharpness": level.edges.iter().map(|e| e.sharpness).collect::<Vec<_>>()})
        })
        .collect();
    // Subdivided once: the vertices of the net first, then a point of each edge, all on the limit surface.
    let limit = subd.to_subd().and_then(|subd| subd.limit_mesh(1)).ok();
    json!({"levels": levels, "kernel": subd.to_subd().err().map(|e| e.to_string()),
        "limit": limit.map(|mesh| crate::numbers::points(mesh.vertices()))})
}
