//! Meshes of version 1: coordinates in steps of a 65535th of the mesh's box.

use katydid_geometry::Point3;

use super::{UNSET, typecode as code};
use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

const WHAT: &str = "mesh of version 1";
/// The largest number of steps along an edge of the box.
const STEPS: f64 = 65535.0;

/// A mesh, its coordinates in single precision.
#[derive(Debug)]
pub(super) struct PackedMesh {
    vertices: Vec<[f32; 3]>,
    faces: Vec<[u32; 4]>,
    normals: Vec<[f32; 3]>,
    texture: Vec<[f32; 2]>,
}

/// Rounds to single precision.
#[allow(clippy::cast_possible_truncation, reason = "the format's own precision")]
fn single(x: f64) -> f32 {
    x as f32
}

impl PackedMesh {
    /// Reads the geometry chunk of a mesh.
    pub(super) fn read(chunks: &mut Reader<'_>) -> Result<Self> {
        let mut body = chunks.expect(code::MESH_GEOMETRY, WHAT)?;
        let offset = body.offset();
        let vertex_count = body.count(6, "mesh vertices")?;
        let face_count = body.count(8, "mesh faces")?;
        if vertex_count == 0 || face_count == 0 {
            return Err(Error::malformed(offset, WHAT, "it has no vertices or no faces"));
        }
        let (has_normals, has_texture) = (body.i32(WHAT)? != 0, body.i32(WHAT)? != 0);
        let (least, most) = (body.point(WHAT)?, body.point(WHAT)?);
        let vertices = read_vertices(&mut body, vertex_count, least, most)?;
        let faces = read_faces(&mut body, face_count, vertex_count < 65535)?;
        let normals = if has_normals {
            let bytes = body.take(vertex_count.saturating_mul(3), "mesh normals")?;
            let part = |byte: u8| single(f64::from(i8::from_le_bytes([byte])) / 127.0);
            bytes.as_chunks::<3>().0.iter().map(|normal| normal.map(part)).collect()
        } else {
            Vec::new()
        };
        let texture = if has_texture {
            let numbers = shorts(&mut body, vertex_count.saturating_mul(2), "mesh texture")?;
            let part = |step: u16| single(f64::from(step) / STEPS);
            numbers.as_chunks::<2>().0.iter().map(|at| at.map(part)).collect()
        } else {
            Vec::new()
        };
        Ok(Self { vertices, faces, normals, texture })
    }

    /// Writes the body of the class with plain arrays.
    pub(super) fn write(&self, w: &mut Writer) -> Result<()> {
        w.packed_version(1, 2);
        w.count(self.vertices.len(), "vertices")?;
        w.count(self.faces.len(), "faces")?;
        // Packed texture domains, surface domains and surface scale: none.
        (0..8).for_each(|_| w.f64(UNSET));
        (0..2).for_each(|_| w.f64(0.0));
        // Boxes of vertices, normals and texture coordinates: turned inside out, that is to be computed.
        for dimension in [3, 3, 2] {
            (0..dimension).for_each(|_| w.f32(1.0));
            (0..dimension).for_each(|_| w.f32(-1.0));
        }
        w.i32(-1);
        // No mesh parameters and no curvature statistics.
        w.bytes(&[0; 5]);
        w.i32(4);
        self.faces.iter().flatten().for_each(|corner| w.u32(*corner));
        w.count(self.vertices.len(), "vertices")?;
        self.vertices.iter().flatten().for_each(|x| w.f32(*x));
        w.count(self.normals.len(), "normals")?;
        self.normals.iter().flatten().for_each(|x| w.f32(*x));
        w.count(self.texture.len(), "texture coordinates")?;
        self.texture.iter().flatten().for_each(|x| w.f32(*x));
        // No curvatures, no colours, texture not rotated.
        (0..3).for_each(|_| w.i32(0));
        Ok(())
    }
}

fn shorts(body: &mut Reader<'_>, count: usize, what: &'static str) -> Result<Vec<u16>> {
    let bytes = body.take(count.saturating_mul(2), what)?;
    Ok(bytes.as_chunks::<2>().0.iter().map(|two| u16::from_le_bytes(*two)).collect())
}

fn read_vertices(body: &mut Reader<'_>, count: usize, least: Point3, most: Point3) -> Result<Vec<[f32; 3]>> {
    let size = most - least;
    let numbers = shorts(body, count.saturating_mul(3), "mesh vertices")?;
    let at = |[x, y, z]: &[u16; 3]| {
        [
            single(size.x / STEPS * f64::from(*x) + least.x),
            single(size.y / STEPS * f64::from(*y) + least.y),
            single(size.z / STEPS * f64::from(*z) + least.z),
        ]
    };
    Ok(numbers.as_chunks::<3>().0.iter().map(at).collect())
}

fn read_faces(body: &mut Reader<'_>, count: usize, short: bool) -> Result<Vec<[u32; 4]>> {
    const WHAT: &str = "mesh faces";
    if short {
        let numbers = shorts(body, count.saturating_mul(4), WHAT)?;
        return Ok(numbers.as_chunks::<4>().0.iter().map(|corners| corners.map(u32::from)).collect());
    }
    let bytes = body.take(count.saturating_mul(16), WHAT)?;
    let index = |four: [u8; 4]| u32::from_le_bytes(four);
    let corners = |face: &[u8; 16]| {
        let [a, b, c, d] = face.as_chunks::<4>().0 else { return [0; 4] };
        [*a, *b, *c, *d].map(index)
    };
    Ok(bytes.as_chunks::<16>().0.iter().map(corners).collect())
}
