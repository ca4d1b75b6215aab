//! SubDs in archives before version 70: a mesh of the same shape, and the SubD in its user data.

use std::borrow::Cow;

use super::{SubDObject, WHAT, read};
use crate::object::{Object, UserData};
use crate::version::Version;
use crate::{MeshObject, class_ids};

/// The first version whose archives have SubDs as objects; their readers take the mesh for no more than one.
const SUBDS: i32 = 70;

/// The object and its user data as an archive of the given version has them.
pub(crate) fn restated<'a>(
    object: &'a Object,
    user_data: &'a [UserData],
    version: Version,
) -> (Cow<'a, Object>, Cow<'a, [UserData]>) {
    let as_it_is = (Cow::Borrowed(object), Cow::Borrowed(user_data));
    let Object::Mesh(mesh) = object else { return as_it_is };
    if version.archive < SUBDS {
        return as_it_is;
    }
    let Some(subd) = user_data.iter().find_map(|data| stood_for(mesh, data)) else { return as_it_is };
    let others = user_data.iter().filter(|data| data.class != class_ids::SUBD_PROXY).cloned();
    (Cow::Owned(Object::SubD(Box::new(subd))), Cow::Owned(others.collect()))
}

/// The SubD that user data says a mesh stands for; none when the mesh is not that of then any more.
fn stood_for(mesh: &MeshObject, data: &UserData) -> Option<SubDObject> {
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
