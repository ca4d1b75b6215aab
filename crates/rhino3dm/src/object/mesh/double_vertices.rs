//! The double-precision vertices of a mesh: in its body from version 60 on, before in user data.

use super::{MeshObject, single};
use crate::chunk::{Reader, Writer};
use crate::class_object::UserData;
use crate::compressed::Packed;
use crate::items::bytes_of;
use crate::version::Version;
use crate::{Error, Result, class_ids};

const WHAT: &str = "double vertices";
/// Vertices of a body count only when they agree with the single ones, relatively, to this.
const AGREEMENT: f64 = 1e-6;

/// Reads the chunk of a body.
pub(super) fn read(body: &mut Reader<'_>) -> Result<Vec<[f64; 3]>> {
    let offset = body.offset();
    let (mut chunk, _) = body.versioned_1(WHAT)?;
    let count = chunk.u32(WHAT)?;
    if count == 0 {
        return Ok(Vec::new());
    }
    let points: Vec<[f64; 3]> = chunk.compressed_items(WHAT)?;
    chunk.finish();
    if points.len() as u64 != u64::from(count) {
        let why = format!("{count} are stated, but {} follow", points.len());
        return Err(Error::malformed(offset, WHAT, why));
    }
    Ok(points)
}

/// Writes the chunk of a body: so many points, compressed already.
pub(super) fn write(count: usize, packed: &Packed, w: &mut Writer) -> Result<()> {
    w.versioned(1, 0, |w| {
        w.count(count, WHAT)?;
        w.packed(packed)
    })
}

/// Whether double-precision vertices are the single-precision ones, only finer: programs have changed the ones and
/// forgotten the others.
pub(super) fn agree(doubles: &[[f64; 3]], singles: &[[f32; 3]]) -> bool {
    let greatest = |p: [f32; 3]| p.iter().fold(0.0_f32, |most, x| most.max(x.abs()));
    doubles.iter().zip(singles).all(|(d, s)| {
        let rounded = d.map(single);
        let apart = greatest(std::array::from_fn(|i| rounded[i] - s[i]));
        let exact = rounded.iter().zip(s).all(|(a, b)| a == b);
        exact || f64::from(apart) <= f64::from(greatest(*s)) * AGREEMENT
    })
}

/// Whether single-precision vertices are exactly the rounded double-precision ones.
fn are_rounded(doubles: &[[f64; 3]], singles: &[[f32; 3]]) -> bool {
    doubles.iter().zip(singles).all(|(d, s)| d.map(single) == *s)
}

/// The vertices in user data that fit these single-precision ones.
pub(super) fn in_user_data(data: &UserData, singles: &[[f32; 3]]) -> Option<Vec<[f64; 3]>> {
    if data.class != class_ids::DOUBLE_VERTICES {
        return None;
    }
    let read = data.with_body(|body| {
        let (mut body, _) = body.versioned_1(WHAT)?;
        // Two counts and two CRCs; the array's own count decides.
        body.take(16, WHAT)?;
        body.items::<[f64; 3]>(WHAT)
    });
    read.ok().filter(|points| points.len() == singles.len() && are_rounded(points, singles))
}

/// The user data that carries double-precision vertices to archives before version 60.
pub(super) fn to_user_data(mesh: &MeshObject, version: Version) -> Result<Option<UserData>> {
    if !mesh.has_double_vertices() || !are_rounded(&mesh.double_vertices, &mesh.vertices) {
        return Ok(None);
    }
    let data = UserData::core(class_ids::DOUBLE_VERTICES, 1, version, |w| {
        w.versioned(1, 0, |w| {
            w.count(mesh.vertices.len(), "vertices")?;
            w.count(mesh.double_vertices.len(), "vertices")?;
            w.u32(crc32fast::hash(&bytes_of(&mesh.vertices)));
            w.u32(crc32fast::hash(&bytes_of(&mesh.double_vertices)));
            w.items(&mesh.double_vertices, "vertices")
        })
    })?;
    Ok(Some(UserData { application: class_ids::OPENNURBS_5_APPLICATION, ..data }))
}
