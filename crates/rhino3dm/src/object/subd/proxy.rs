//! SubDs in archives before version 70: a mesh of the same shape, and the SubD in its user data.

use super::{SubDObject, WHAT, read};
use crate::object::UserData;
use crate::{MeshObject, class_ids};

/// The SubD that user data says a mesh stands for; none when the mesh is not that of then any more.
pub(in crate::object) fn stood_for(mesh: &MeshObject, data: &UserData) -> Option<SubDObject> {
    // Chunks that a SubD keeps as they are cannot change the width of their lengths.
    if data.class != class_ids::SUBD_PROXY || data.archive_version < 50 {
        return None;
    }
    let found = data.with_body(|body| {
        let (mut chunk, _) = body.versioned_1(WHAT)?;
        if !chunk.bool(WHAT)? {
            return Ok(None);
        }
        let subd = read::read(&mut chunk)?;
        let counts = [chunk.i32(WHAT)?, chunk.i32(WHAT)?].map(usize::try_from);
        // Checksums of faces and vertices follow.
        Ok((counts == [Ok(mesh.faces.len()), Ok(mesh.vertices.len())]).then_some(subd))
    });
    found.ok().flatten()
}
