//! Polygons of more than four corners: groups of faces with a boundary. From version 60 on they are in the body of
//! a mesh, before in user data, which openNURBS carries on as it is.

use crate::chunk::{Reader, Writer};
use crate::class_object::UserData;
use crate::version::Version;
use crate::{Result, class_ids};

const WHAT: &str = "n-gons";

/// Faces that are seen as one polygon.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Ngon {
    /// Indices of the vertices of its outer boundary, in order.
    pub vertices: Vec<u32>,
    /// Indices of the faces it consists of.
    pub faces: Vec<u32>,
}

impl Ngon {
    /// openNURBS writes no polygon without corners or faces.
    fn is_written(&self) -> bool {
        !self.vertices.is_empty() && !self.faces.is_empty()
    }
}

/// Reads the chunk of a body.
pub(super) fn read(body: &mut Reader<'_>) -> Result<Vec<Ngon>> {
    let (mut chunk, _) = body.versioned_1(WHAT)?;
    let count = chunk.count(4, WHAT)?;
    let mut ngons = Vec::with_capacity(count);
    for _ in 0..count {
        let vertex_count = chunk.count(4, WHAT)?;
        if vertex_count == 0 {
            continue;
        }
        let face_count = chunk.count(4, WHAT)?;
        ngons.push(Ngon {
            vertices: indices(&mut chunk, vertex_count)?,
            faces: indices(&mut chunk, face_count)?,
        });
    }
    chunk.finish();
    Ok(ngons)
}

fn indices(chunk: &mut Reader<'_>, count: usize) -> Result<Vec<u32>> {
    chunk.check_count(count, 4, WHAT)?;
    (0..count).map(|_| chunk.u32(WHAT)).collect()
}

/// Writes the chunk of a body.
pub(super) fn write(ngons: &[Ngon], w: &mut Writer) -> Result<()> {
    w.versioned(1, 0, |w| {
        w.count(ngons.len(), WHAT)?;
        for ngon in ngons {
            if !ngon.is_written() {
                w.i32(0);
                continue;
            }
            w.count(ngon.vertices.len(), WHAT)?;
            w.count(ngon.faces.len(), WHAT)?;
            ngon.vertices.iter().chain(&ngon.faces).for_each(|i| w.u32(*i));
        }
        Ok(())
    })
}

impl UserData {
    /// The polygons of a mesh that came from an archive before version 60, when this is user data of that class.
    ///
    /// # Errors
    /// The class is right but the body is broken.
    pub fn ngons(&self) -> Result<Option<Vec<Ngon>>> {
        if self.class != class_ids::MESH_NGONS {
            return Ok(None);
        }
        self.with_body(read_old).map(Some)
    }
}

/// Lists of corners and faces of one length, the shorter ended by −1. The counts of the mesh behind them, from minor
/// version 1 on, are not needed.
fn read_old(body: &mut Reader<'_>) -> Result<Vec<Ngon>> {
    let (mut chunk, _) = body.versioned_1(WHAT)?;
    let count = chunk.count(4, WHAT)?;
    let mut ngons = Vec::with_capacity(count);
    for _ in 0..count {
        let sides = chunk.count(8, WHAT)?;
        let mut list = || -> Result<Vec<u32>> {
            let all = indices(&mut chunk, sides)?;
            Ok(all.into_iter().take_while(|i| *i != u32::MAX).collect())
        };
        let ngon = Ngon { vertices: list()?, faces: list()? };
        if ngon.is_written() {
            ngons.push(ngon);
        }
    }
    Ok(ngons)
}

/// The user data that carries polygons to archives before version 60.
pub(super) fn to_user_data(
    ngons: &[Ngon],
    vertices: usize,
    faces: usize,
    version: Version,
) -> Result<UserData> {
    UserData::core(class_ids::MESH_NGONS, 1, version, |w| {
        w.versioned(1, 1, |w| {
            w.count(ngons.len(), WHAT)?;
            for ngon in ngons {
                let sides = if ngon.is_written() { ngon.vertices.len().max(ngon.faces.len()) } else { 0 };
                w.count(sides, WHAT)?;
                for list in [&ngon.vertices, &ngon.faces] {
                    let padded = list.iter().copied().chain(std::iter::repeat(u32::MAX));
                    padded.take(sides).for_each(|i| w.u32(i));
                }
            }
            w.count(faces, "faces")?;
            w.count(vertices, "vertices")
        })
    })
}
