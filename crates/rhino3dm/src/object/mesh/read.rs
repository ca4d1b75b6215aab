use katydid_geometry::Interval;

use super::{MeshObject, WHAT, double_vertices, ngons, parameters, statistics};
use crate::chunk::Reader;
use crate::class_object::UserData;
use crate::items::Item;
use crate::object::MappingTag;
use crate::{Error, Result, colour};

/// Files from this openNURBS version on carry a mapping tag, and what follows it.
const MAPPING_TAG_FROM: u32 = 200_606_010;
/// Up to this openNURBS version surface parameters may be of a wrong count.
const SURFACE_PARAMETERS_LOOSE_TO: u32 = 201_011_049;

/// What archives call a mesh that is no solid.
const NOT_SOLID: u8 = 3;

/// Reads the body of a mesh; its user data may hold double-precision vertices.
pub(in crate::object) fn read(body: &mut Reader<'_>, user_data: &[UserData]) -> Result<MeshObject> {
    let mut mesh = MeshObject::default();
    let offset = body.offset();
    let (major, minor) = body.packed_version(WHAT)?;
    if major != 1 && major != 3 {
        return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
    }
    // openNURBS reads a mesh with negative counts as one without vertices or faces.
    let vertex_count = usize::try_from(body.i32(WHAT)?).unwrap_or(0);
    let face_count = usize::try_from(body.i32(WHAT)?).unwrap_or(0);
    read_head(body, &mut mesh)?;
    mesh.faces = read_faces(body, face_count)?;
    if major == 1 {
        read_plain(body, &mut mesh)?;
    } else if vertex_count > 0 {
        read_compressed(body, vertex_count, &mut mesh)?;
    }
    if minor >= 2 {
        mesh.packed_texture_rotated = body.i32(WHAT)? != 0;
    }
    if major == 3 && minor >= 3 {
        read_tail(body, minor, vertex_count, &mut mesh)?;
    }
    derive_surface_parameters(&mut mesh);
    take_user_data(user_data, &mut mesh);
    Ok(mesh)
}

/// Domains, boxes, whether it is closed, meshing parameters, curvature statistics.
fn read_head(body: &mut Reader<'_>, mesh: &mut MeshObject) -> Result<()> {
    let intervals =
        |body: &mut Reader<'_>| -> Result<[Interval; 2]> { Ok([body.interval(WHAT)?, body.interval(WHAT)?]) };
    mesh.packed_texture_domain = intervals(body)?;
    mesh.surface_domain = intervals(body)?;
    mesh.surface_scale = [body.f64(WHAT)?, body.f64(WHAT)?];
    let vertex_box: [[f32; 3]; 2] = corners(body)?;
    let [least, greatest] = vertex_box;
    if least.iter().zip(greatest).all(|(a, b)| *a <= b) {
        mesh.vertex_box = vertex_box.map(|corner| corner.map(f64::from));
    }
    mesh.normal_box = corners(body)?;
    mesh.texture_box = corners(body)?;
    mesh.closed = match body.i32(WHAT)? {
        0 => Some(false),
        1 | 2 => Some(true),
        _ => None,
    };
    if mesh.closed == Some(false) {
        // A mesh that is not closed is no solid, whether the archive goes on to say so or not.
        mesh.solid = NOT_SOLID;
    }
    if body.bool(WHAT)? {
        mesh.parameters = Some(Box::new(parameters::read(body)?));
    }
    for slot in &mut mesh.curvature_statistics {
        if body.bool(WHAT)? {
            *slot = Some(Box::new(statistics::read(body)?));
        }
    }
    Ok(())
}

/// The least and the greatest corner of a box in single precision.
fn corners<const N: usize>(body: &mut Reader<'_>) -> Result<[[f32; N]; 2]> {
    let mut corners = [[0.0; N]; 2];
    for x in corners.as_flattened_mut() {
        *x = f32::from_le_bytes(body.array(WHAT)?);
    }
    Ok(corners)
}

/// Four indices a face. openNURBS reads no faces where their width is not one it knows.
fn read_faces(body: &mut Reader<'_>, count: usize) -> Result<Vec<[u32; 4]>> {
    const FACES: &str = "mesh faces";
    let offset = body.offset();
    let width = body.i32("mesh index size")?;
    match width {
        1 => Ok(as_faces(body.take(count.saturating_mul(4), FACES)?, |[a]| u32::from(a))),
        2 => Ok(as_faces(body.take(count.saturating_mul(8), FACES)?, |index| {
            u32::from(u16::from_le_bytes(index))
        })),
        4 => body.items_of(count, FACES),
        _ => {
            body.context().warn(offset, format!("a mesh without faces: its indices take {width} bytes"));
            Ok(Vec::new())
        }
    }
}

fn as_faces<const WIDTH: usize>(bytes: &[u8], index: impl Fn([u8; WIDTH]) -> u32) -> Vec<[u32; 4]> {
    let (indices, _) = bytes.as_chunks::<WIDTH>();
    let (faces, _) = indices.as_chunks::<4>();
    faces.iter().map(|face| face.map(&index)).collect()
}

/// Five arrays: vertices, normals, texture coordinates, curvatures, colours.
fn read_plain(body: &mut Reader<'_>, mesh: &mut MeshObject) -> Result<()> {
    mesh.vertices = body.items("mesh vertices")?;
    mesh.normals = body.items("mesh normals")?;
    mesh.texture_coordinates = body.items("mesh texture coordinates")?;
    mesh.curvatures = body.items("mesh curvatures")?;
    mesh.colours = body.items("mesh colours")?;
    show_alpha(&mut mesh.colours);
    Ok(())
}

/// The same as five compressed buffers.
fn read_compressed(body: &mut Reader<'_>, count: usize, mesh: &mut MeshObject) -> Result<()> {
    mesh.vertices = read_buffer(body, count, "mesh vertices")?;
    mesh.normals = read_buffer(body, count, "mesh normals")?;
    mesh.texture_coordinates = read_buffer(body, count, "mesh texture coordinates")?;
    mesh.curvatures = read_buffer(body, count, "mesh curvatures")?;
    mesh.colours = read_buffer(body, count, "mesh colours")?;
    show_alpha(&mut mesh.colours);
    Ok(())
}

/// A compressed buffer that has an item a vertex, or none at all.
fn read_buffer<T: Item>(body: &mut Reader<'_>, count: usize, what: &'static str) -> Result<Vec<T>> {
    let offset = body.offset();
    let items: Vec<T> = body.compressed_items(what)?;
    if !items.is_empty() && items.len() != count {
        return Err(Error::malformed(offset, what, format!("{} for {count} vertices", items.len())));
    }
    Ok(items)
}

fn show_alpha(colours: &mut [[u8; 4]]) {
    colours.iter_mut().for_each(|c| *c = colour::from_archive(*c));
}

/// What minor versions from 3 on append.
fn read_tail(body: &mut Reader<'_>, minor: u8, vertex_count: usize, mesh: &mut MeshObject) -> Result<()> {
    let opennurbs = body.version().opennurbs;
    mesh.mapping.mapping = body.uuid("mapping identifier")?;
    if vertex_count > 0 {
        mesh.surface_parameters = read_surface_parameters(body, vertex_count)?;
    }
    if minor < 4 || opennurbs < MAPPING_TAG_FROM {
        return Ok(());
    }
    mesh.mapping = MappingTag::read(body)?;
    if minor >= 5 {
        [mesh.manifold, mesh.oriented, mesh.solid] = body.array(WHAT)?;
    }
    if minor >= 6 && body.bool(WHAT)? {
        mesh.ngons = ngons::read(body)?;
    }
    let mut disagree = false;
    if minor >= 7 && body.bool(WHAT)? {
        mesh.double_vertices = double_vertices::read(body)?;
        if mesh.double_vertices.len() == mesh.vertices.len() {
            disagree = !double_vertices::agree(&mesh.double_vertices, &mesh.vertices);
            if disagree {
                mesh.double_vertices = Vec::new();
            } else if minor == 7 {
                mesh.vertex_box = box_of(mesh.double_vertices.iter().copied());
            }
        }
    }
    if minor >= 8 {
        for x in mesh.vertex_box.as_flattened_mut() {
            *x = body.f64("mesh box")?;
        }
    }
    if disagree {
        mesh.vertex_box = box_of(mesh.vertices.iter().map(|v| v.map(f64::from)));
    }
    Ok(())
}

fn read_surface_parameters(body: &mut Reader<'_>, vertex_count: usize) -> Result<Vec<[f64; 2]>> {
    const PARAMETERS: &str = "mesh surface parameters";
    let offset = body.offset();
    let parameters: Vec<[f64; 2]> = body.compressed_items(PARAMETERS)?;
    if parameters.is_empty() || parameters.len() == vertex_count {
        return Ok(parameters);
    }
    if body.version().opennurbs <= SURFACE_PARAMETERS_LOOSE_TO {
        return Ok(Vec::new());
    }
    Err(Error::malformed(offset, PARAMETERS, format!("{} for {vertex_count} vertices", parameters.len())))
}

/// The box of points; not a number where there is none.
fn box_of(points: impl Iterator<Item = [f64; 3]>) -> [[f64; 3]; 2] {
    let mut corners: Option<[[f64; 3]; 2]> = None;
    for p in points {
        let [least, greatest] = corners.get_or_insert([p, p]);
        for (i, x) in p.into_iter().enumerate() {
            least[i] = least[i].min(x);
            greatest[i] = greatest[i].max(x);
        }
    }
    corners.unwrap_or([[super::UNSET; 3]; 2])
}

/// Meshes of old files do not store surface parameters, but their texture coordinates follow from them where no
/// mapping is named.
fn derive_surface_parameters(mesh: &mut MeshObject) {
    let is_set = |i: &Interval| i.start.is_finite() && i.end.is_finite() && i.start != super::UNSET;
    let derivable = mesh.surface_parameters.is_empty()
        && !mesh.texture_coordinates.is_empty()
        && mesh.texture_coordinates.len() == mesh.vertices.len()
        && mesh.surface_domain.iter().all(|d| is_set(d) && d.start < d.end)
        && mesh.packed_texture_domain.iter().all(|d| is_set(d) && d.start != d.end)
        && mesh.mapping.crc == 0
        && mesh.mapping.mapping.is_nil();
    if !derivable {
        return;
    }
    let [packed_u, packed_v] = mesh.packed_texture_domain;
    let [u, v] = mesh.surface_domain;
    let rotated = mesh.packed_texture_rotated;
    let derived = mesh.texture_coordinates.iter().map(|uv| {
        let [x, y] = uv.map(f64::from);
        let (s, t) = if rotated {
            (normalised(packed_v, y), 1.0 - normalised(packed_u, x))
        } else {
            (normalised(packed_u, x), normalised(packed_v, y))
        };
        [at(u, s), at(v, t)]
    });
    mesh.surface_parameters = derived.collect();
    mesh.mapping = MappingTag::surface_parameters();
}

/// Where `x` lies in an interval, from 0 at its start to exactly 1 at its end.
fn normalised(interval: Interval, x: f64) -> f64 {
    if x == interval.end { 1.0 } else { (x - interval.start) / (interval.end - interval.start) }
}

fn at(interval: Interval, t: f64) -> f64 {
    (1.0 - t) * interval.start + t * interval.end
}

/// Archives before version 60 hold double-precision vertices in user data.
fn take_user_data(user_data: &[UserData], mesh: &mut MeshObject) {
    if mesh.double_vertices.is_empty() {
        let found = user_data.iter().find_map(|data| double_vertices::in_user_data(data, &mesh.vertices));
        mesh.double_vertices = found.unwrap_or_default();
    }
}
