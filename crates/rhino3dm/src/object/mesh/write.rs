use super::{MeshObject, double_vertices, ngons, parameters, single, statistics};
use crate::chunk::Writer;
use crate::compressed::{Packed, pack_all};
use crate::items::bytes_of;
use crate::version::Version;
use crate::{Error, Result, colour};

/// Writes the body of a mesh.
pub(in crate::object) fn write(mesh: &MeshObject, w: &mut Writer) -> Result<()> {
    let newer = w.version().archive >= 60;
    check_singles(mesh, w.version())?;
    w.packed_version(3, if newer { 8 } else { 5 });
    w.count(mesh.vertices.len(), "vertices")?;
    w.count(mesh.faces.len(), "faces")?;
    write_head(mesh, w)?;
    write_faces(mesh, w);
    let buffers = pack_buffers(mesh, newer)?;
    if !mesh.vertices.is_empty() {
        buffers.a_vertex.iter().try_for_each(|buffer| w.packed(buffer))?;
    }
    w.i32(i32::from(mesh.packed_texture_rotated));
    w.uuid(mesh.mapping.mapping);
    if !mesh.vertices.is_empty() {
        w.packed(&buffers.surface_parameters)?;
    }
    mesh.mapping.write(w)?;
    w.bytes(&[mesh.manifold, mesh.oriented, mesh.solid]);
    if newer {
        w.bool(!mesh.ngons.is_empty());
        if !mesh.ngons.is_empty() {
            ngons::write(&mesh.ngons, w)?;
        }
        w.bool(mesh.has_double_vertices());
        if mesh.has_double_vertices() {
            double_vertices::write(mesh.double_vertices.len(), &buffers.double_vertices, w)?;
        }
        mesh.vertex_box.as_flattened().iter().for_each(|x| w.f64(*x));
    }
    Ok(())
}

/// Refuses double-precision vertices beyond single precision: without single ones that agree readers drop them.
fn check_singles(mesh: &MeshObject, version: Version) -> Result<()> {
    let beyond =
        |(d, s): (&[f64; 3], &[f32; 3])| d.iter().zip(s).any(|(d, s)| d.is_finite() && !s.is_finite());
    if mesh.has_double_vertices() && mesh.double_vertices.iter().zip(&mesh.vertices).any(beyond) {
        return Err(Error::CannotWrite {
            what: "a mesh".into(),
            version: version.archive,
            why: "a coordinate is beyond single precision".into(),
        });
    }
    Ok(())
}

/// A list when it has an entry a vertex; openNURBS writes no other.
fn one_a_vertex<'a, T>(list: &'a [T], mesh: &MeshObject) -> &'a [T] {
    if list.len() == mesh.vertices.len() { list } else { &[] }
}

/// Domains, boxes, whether it is closed, meshing parameters, curvature statistics.
fn write_head(mesh: &MeshObject, w: &mut Writer) -> Result<()> {
    mesh.packed_texture_domain.iter().chain(&mesh.surface_domain).for_each(|i| w.interval(*i));
    mesh.surface_scale.iter().for_each(|x| w.f64(*x));
    single_box(mesh.vertex_box).as_flattened().iter().for_each(|x| w.f32(*x));
    mesh.normal_box.as_flattened().iter().for_each(|x| w.f32(*x));
    mesh.texture_box.as_flattened().iter().for_each(|x| w.f32(*x));
    w.i32(mesh.closed.map_or(-1, i32::from));
    w.bool(mesh.parameters.is_some());
    if let Some(p) = &mesh.parameters {
        parameters::write(p, w)?;
    }
    for slot in &mesh.curvature_statistics {
        w.bool(slot.is_some());
        if let Some(s) = slot {
            statistics::write(s, w)?;
        }
    }
    Ok(())
}

/// A box in single precision that holds the one in double precision; turned inside out when that is not set.
fn single_box(corners: [[f64; 3]; 2]) -> [[f32; 3]; 2] {
    let is_set = |x: f64| x.is_finite() && x != super::UNSET;
    let [least, greatest] = corners;
    let is_box = least.iter().zip(greatest).all(|(a, b)| is_set(*a) && is_set(b) && *a <= b);
    if is_box { [least.map(floor), greatest.map(ceil)] } else { super::NO_BOX.map(|x| [x; 3]) }
}

/// A single-precision number not above `x`, rounded as openNURBS rounds.
fn floor(x: f64) -> f32 {
    let half = 0.5 * f64::from(f32::EPSILON);
    single(if x < 0.0 { 1.0 + half } else { 1.0 - half } * x)
}

fn ceil(x: f64) -> f32 {
    if x == 0.0 { 0.0 } else { -floor(-x) }
}

fn write_faces(mesh: &MeshObject, w: &mut Writer) {
    let low = |i: u32| i.to_le_bytes();
    match mesh.vertices.len() {
        0..256 => {
            w.i32(1);
            let bytes: Vec<u8> = mesh.faces.as_flattened().iter().map(|i| low(*i)[0]).collect();
            w.bytes(&bytes);
        }
        256..65536 => {
            w.i32(2);
            let pairs: Vec<[u8; 2]> =
                mesh.faces.as_flattened().iter().map(|i| [low(*i)[0], low(*i)[1]]).collect();
            w.bytes(pairs.as_flattened());
        }
        _ => {
            w.i32(4);
            w.items_of(&mesh.faces);
        }
    }
}

/// The compressed buffers of a mesh.
struct Buffers {
    /// Vertices, normals, texture coordinates, curvatures and colours.
    a_vertex: [Packed; 5],
    surface_parameters: Packed,
    double_vertices: Packed,
}

/// Compresses all buffers at once.
fn pack_buffers(mesh: &MeshObject, has_doubles: bool) -> Result<Buffers> {
    let colours: Vec<[u8; 4]> =
        one_a_vertex(&mesh.colours, mesh).iter().map(|c| colour::to_archive(*c)).collect();
    let doubles: &[_] = if has_doubles { one_a_vertex(&mesh.double_vertices, mesh) } else { &[] };
    let packed = pack_all([
        &bytes_of(&mesh.vertices),
        &bytes_of(one_a_vertex(&mesh.normals, mesh)),
        &bytes_of(one_a_vertex(&mesh.texture_coordinates, mesh)),
        &bytes_of(one_a_vertex(&mesh.curvatures, mesh)),
        &bytes_of(&colours),
        &bytes_of(one_a_vertex(&mesh.surface_parameters, mesh)),
        &bytes_of(doubles),
    ])?;
    let [vertices, normals, texture_coordinates, curvatures, colours, surface_parameters, double_vertices] =
        packed;
    let a_vertex = [vertices, normals, texture_coordinates, curvatures, colours];
    Ok(Buffers { a_vertex, surface_parameters, double_vertices })
}
