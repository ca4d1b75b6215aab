//! Class Mesh (section 8): faces as indices of 1, 2 or 4 bytes, vertex data plain (major version 1) or in
//! compressed buffers (3), and double-precision vertices beside the single-precision ones.

use katydid_geometry::{Mesh, MeshFace, Point3, Vector3};
use uuid::Uuid;

use super::UserData;
use crate::chunk::{Reader, Writer};
use crate::version::Version;
use crate::{Error, Result, class_ids, colour, typecode};

const WHAT: &str = "mesh";
/// What openNURBS writes for a number that is not set.
const UNSET: f64 = -1.234_321_012_343_21e308;
/// Double vertices count only when they agree with the single ones, relatively, to this.
const AGREEMENT: f64 = 1e-6;
/// Files from this openNURBS version on carry a mapping tag.
const MAPPING_TAG_FROM: u32 = 200_606_010;

pub(super) fn read(body: &mut Reader<'_>, user_data: &[UserData]) -> Result<Mesh> {
    let offset = body.offset();
    let (major, minor) = body.packed_version(WHAT)?;
    if major != 1 && major != 3 {
        return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
    }
    let size = |n: i32, what: &str| {
        usize::try_from(n).map_err(|_| Error::malformed(offset, WHAT, format!("{n} {what}")))
    };
    let vertex_count = size(body.i32(WHAT)?, "vertices")?;
    let face_count = size(body.i32(WHAT)?, "faces")?;
    // Texture packing, surface domains and scale (doubles), three boxes (floats), and whether it is closed.
    body.take(80 + 64 + 4, WHAT)?;
    // Mesh parameters, then four curvature statistics: each a flag and perhaps a chunk.
    for _ in 0..5 {
        if body.bool(WHAT)? {
            body.expect(typecode::ANONYMOUS, "mesh parameters")?;
        }
    }
    let faces = read_faces(body, face_count)?;
    let mut parts = if major == 1 {
        Parts::read_plain(body)?
    } else if vertex_count > 0 {
        Parts::read_compressed(body)?
    } else {
        Parts::default()
    };
    if parts.vertices.len() != vertex_count {
        return Err(Error::malformed(
            offset,
            WHAT,
            format!("{vertex_count} vertices are stated, but {} follow", parts.vertices.len()),
        ));
    }
    let doubles = read_tail(body, major, minor, vertex_count)?
        .or_else(|| user_data.iter().find_map(|data| doubles_in(data, vertex_count)));
    if let Some(doubles) = doubles
        && agree(&doubles, &parts.vertices)
    {
        parts.vertices = doubles;
    }
    if parts.normals.len() != vertex_count || !parts.normals.iter().all(|n| n.is_finite()) {
        parts.normals.clear();
    }
    if parts.colours.len() != vertex_count {
        parts.colours.clear();
    }
    Mesh::from_parts(parts.vertices, faces, parts.normals, parts.colours)
        .map_err(|e| Error::geometry(offset, WHAT, e))
}

/// Four indices a face; a triangle repeats its third.
fn read_faces(body: &mut Reader<'_>, count: usize) -> Result<Vec<MeshFace>> {
    let offset = body.offset();
    let width = body.i32("mesh index size")?;
    if !matches!(width, 1 | 2 | 4) {
        return Err(Error::malformed(offset, WHAT, format!("its indices take {width} bytes")));
    }
    let width = width.unsigned_abs() as usize;
    body.check_count(count, 4 * width, "mesh faces")?;
    let bytes = body.take(count.saturating_mul(4 * width), "mesh faces")?;
    let index = |bytes: &[u8]| bytes.iter().rev().fold(0_u32, |n, byte| n << 8 | u32::from(*byte));
    let faces = bytes.chunks_exact(4 * width).map(|face| {
        let mut corners = face.chunks_exact(width).map(index);
        let [a, b, c, d] = std::array::from_fn(|_| corners.next().unwrap_or_default());
        if c == d { MeshFace::Triangle([a, b, c]) } else { MeshFace::Quad([a, b, c, d]) }
    });
    Ok(faces.collect())
}

/// What is stored once a vertex.
#[derive(Debug, Default)]
struct Parts {
    vertices: Vec<Point3>,
    normals: Vec<Vector3>,
    colours: Vec<[u8; 4]>,
}

impl Parts {
    /// Five arrays: vertices, normals, texture coordinates, curvatures, colours.
    fn read_plain(body: &mut Reader<'_>) -> Result<Self> {
        let mut array = |item: usize, what: &'static str| {
            let count = body.count(item, what)?;
            body.take(count.saturating_mul(item), what)
        };
        let vertices = array(12, "mesh vertices")?;
        let normals = array(12, "mesh normals")?;
        array(8, "mesh texture coordinates")?;
        array(16, "mesh curvatures")?;
        let colours = array(4, "mesh colours")?;
        Ok(Self::from_bytes(vertices, normals, colours))
    }

    /// The same as five compressed buffers.
    fn read_compressed(body: &mut Reader<'_>) -> Result<Self> {
        let vertices = body.compressed("mesh vertices")?;
        let normals = body.compressed("mesh normals")?;
        body.compressed("mesh texture coordinates")?;
        body.compressed("mesh curvatures")?;
        let colours = body.compressed("mesh colours")?;
        Ok(Self::from_bytes(&vertices, &normals, &colours))
    }

    fn from_bytes(vertices: &[u8], normals: &[u8], colours: &[u8]) -> Self {
        let float = |bytes: &[u8]| bytes.try_into().map_or(f64::NAN, |b| f64::from(f32::from_le_bytes(b)));
        let triple = |bytes: &[u8; 12]| {
            let mut floats = bytes.chunks_exact(4).map(float);
            std::array::from_fn(|_| floats.next().unwrap_or(f64::NAN))
        };
        let vector = |[x, y, z]: [f64; 3]| Vector3::new(x, y, z);
        Self {
            vertices: vertices.as_chunks::<12>().0.iter().map(|b| Point3::from(triple(b))).collect(),
            normals: normals.as_chunks::<12>().0.iter().map(|b| vector(triple(b))).collect(),
            colours: colours.as_chunks::<4>().0.iter().copied().map(colour::from_archive).collect(),
        }
    }
}

/// What later minor versions append; gives the double-precision vertices when there are any.
fn read_tail(
    body: &mut Reader<'_>,
    major: u8,
    minor: u8,
    vertex_count: usize,
) -> Result<Option<Vec<Point3>>> {
    if minor >= 2 {
        body.i32("packed texture rotation")?;
    }
    if major != 3 || minor < 3 {
        return Ok(None);
    }
    body.uuid("mapping identifier")?;
    if vertex_count > 0 {
        body.compressed("mesh surface parameters")?;
    }
    if minor >= 4 && body.version().opennurbs >= MAPPING_TAG_FROM {
        body.expect(typecode::ANONYMOUS, "mapping tag")?;
    }
    if minor >= 5 {
        // Whether it is manifold, oriented, solid.
        body.take(3, WHAT)?;
    }
    if minor >= 6 && body.bool(WHAT)? {
        body.expect(typecode::ANONYMOUS, "n-gons")?;
    }
    let mut doubles = None;
    if minor >= 7 && body.bool(WHAT)? {
        let (mut chunk, _) = body.versioned_1("double vertices")?;
        let count = chunk.u32("double vertices")?;
        let bytes = chunk.compressed("double vertices")?;
        chunk.finish();
        let points: Vec<Point3> = bytes.as_chunks::<24>().0.iter().map(point_from).collect();
        if points.len() == vertex_count && u64::from(count) == vertex_count as u64 {
            doubles = Some(points);
        }
    }
    if minor >= 8 {
        body.take(48, "mesh box")?;
    }
    Ok(doubles)
}

fn point_from(bytes: &[u8; 24]) -> Point3 {
    let mut numbers = bytes.as_chunks::<8>().0.iter().map(|b| f64::from_le_bytes(*b));
    let [x, y, z] = std::array::from_fn(|_| numbers.next().unwrap_or(f64::NAN));
    Point3::new(x, y, z)
}

/// The double-precision vertices that archives before version 60 keep as user data.
fn doubles_in(data: &UserData, vertex_count: usize) -> Option<Vec<Point3>> {
    if data.class != class_ids::DOUBLE_VERTICES {
        return None;
    }
    let read = data.with_body(|body| {
        let (mut body, _) = body.versioned_1("double vertices")?;
        // Two counts and two CRCs; the array's own count decides.
        body.take(16, "double vertices")?;
        body.points("double vertices")
    });
    read.ok().filter(|points| points.len() == vertex_count)
}

/// Whether double-precision vertices are the single-precision ones, only finer.
fn agree(doubles: &[Point3], singles: &[Point3]) -> bool {
    // Numbers too small for single precision have lost more than that, down to nothing.
    let floor = f64::from(f32::MIN_POSITIVE);
    let near = |d: f64, s: f64| (d - s).abs() <= AGREEMENT * d.abs().max(s.abs()) + floor;
    doubles.iter().zip(singles).all(|(d, s)| near(d.x, s.x) && near(d.y, s.y) && near(d.z, s.z))
}

/// A coordinate in single precision.
#[allow(clippy::cast_possible_truncation, reason = "rounding to single precision is the point")]
fn single(x: f64) -> f32 {
    x as f32
}

fn coordinates(p: &Point3) -> [f64; 3] {
    [p.x, p.y, p.z]
}

/// Whether single precision would lose something of the vertices.
fn needs_doubles(mesh: &Mesh) -> bool {
    mesh.vertices().iter().flat_map(coordinates).any(|x| f64::from(single(x)) != x)
}

fn single_bytes(numbers: impl Iterator<Item = f64>) -> Vec<u8> {
    numbers.flat_map(|x| single(x).to_le_bytes()).collect()
}

fn double_bytes(mesh: &Mesh) -> Vec<u8> {
    mesh.vertices().iter().flat_map(coordinates).flat_map(f64::to_le_bytes).collect()
}

/// The user data that carries double-precision vertices to archives before version 60, where it is needed.
pub(super) fn double_vertices(mesh: &Mesh, version: Version) -> Result<Option<UserData>> {
    if version.archive >= 60 || !needs_doubles(mesh) {
        return Ok(None);
    }
    let singles = single_bytes(mesh.vertices().iter().flat_map(coordinates));
    let doubles = double_bytes(mesh);
    UserData::core(class_ids::DOUBLE_VERTICES, 1, version, |w| {
        w.versioned(1, 0, |w| {
            w.count(mesh.vertices().len(), "vertices")?;
            w.count(mesh.vertices().len(), "vertices")?;
            w.u32(crc32fast::hash(&singles));
            w.u32(crc32fast::hash(&doubles));
            w.points(mesh.vertices())
        })
    })
    .map(Some)
}

pub(super) fn write(mesh: &Mesh, w: &mut Writer) -> Result<()> {
    let newer = w.version().archive >= 60;
    if mesh.vertices().iter().flat_map(coordinates).any(|x| !single(x).is_finite()) {
        return Err(Error::CannotWrite {
            what: "a mesh".into(),
            version: w.version().archive,
            why: "a coordinate is beyond single precision".into(),
        });
    }
    w.packed_version(3, if newer { 8 } else { 5 });
    w.count(mesh.vertices().len(), "vertices")?;
    w.count(mesh.faces().len(), "faces")?;
    // Packed texture domains, surface domains and surface scale: none.
    for _ in 0..8 {
        w.f64(UNSET);
    }
    for _ in 0..2 {
        w.f64(0.0);
    }
    // Boxes of vertices, normals and texture coordinates: turned inside out, that is to be computed.
    for dimension in [3, 3, 2] {
        (0..dimension).for_each(|_| w.f32(1.0));
        (0..dimension).for_each(|_| w.f32(-1.0));
    }
    w.i32(-1);
    // No mesh parameters and no curvature statistics.
    w.bytes(&[0; 5]);
    write_faces(mesh, w)?;
    if !mesh.vertices().is_empty() {
        w.compressed(&single_bytes(mesh.vertices().iter().flat_map(coordinates)))?;
        w.compressed(&single_bytes(mesh.normals().iter().flat_map(|n| [n.x, n.y, n.z])))?;
        w.compressed(&[])?;
        w.compressed(&[])?;
        let colours = mesh.colours().iter().copied().flat_map(colour::to_archive);
        w.compressed(&colours.collect::<Vec<u8>>())?;
    }
    w.i32(0);
    w.uuid(Uuid::nil());
    if !mesh.vertices().is_empty() {
        w.compressed(&[])?;
    }
    write_empty_mapping_tag(w)?;
    w.bytes(&[0; 3]);
    if newer {
        w.bool(false);
        let doubles = needs_doubles(mesh);
        w.bool(doubles);
        if doubles {
            w.versioned(1, 0, |w| {
                w.count(mesh.vertices().len(), "vertices")?;
                w.compressed(&double_bytes(mesh))
            })?;
        }
        (0..6).for_each(|_| w.f64(UNSET));
    }
    Ok(())
}

fn write_faces(mesh: &Mesh, w: &mut Writer) -> Result<()> {
    let width = match mesh.vertices().len() {
        0..256 => 1,
        256..65536 => 2,
        _ => 4,
    };
    w.i32(width);
    let width = width.unsigned_abs() as usize;
    for face in mesh.faces() {
        let corners = match *face {
            MeshFace::Triangle([a, b, c]) => [a, b, c, c],
            MeshFace::Quad(corners) => corners,
        };
        for corner in corners {
            w.bytes(corner.to_le_bytes().get(..width).unwrap_or_default());
        }
    }
    Ok(())
}

/// The mapping tag that says there is no texture mapping.
fn write_empty_mapping_tag(w: &mut Writer) -> Result<()> {
    w.versioned(1, 1, |w| {
        w.uuid(Uuid::nil());
        w.u32(0);
        for i in 0..16 {
            w.f64(if i % 5 == 0 { 1.0 } else { 0.0 });
        }
        w.u32(0);
        Ok(())
    })
}
