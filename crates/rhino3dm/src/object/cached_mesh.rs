//! Meshes that programs keep beside breps and extrusions, so that they need not be made again for display.

use super::Object;
use crate::Result;
use crate::chunk::{Reader, Writer};
use crate::class_object::{ClassObject, UserData};

/// A mesh kept beside another object.
#[derive(Debug, Clone, PartialEq)]
pub struct CachedMesh {
    /// The mesh; as bytes where it could not be taken apart.
    pub mesh: Object,
    /// Its user data.
    pub user_data: Vec<UserData>,
}

impl CachedMesh {
    /// Reads a class object; a null object is no mesh.
    pub(super) fn read(reader: &mut Reader<'_>) -> Result<Option<Self>> {
        let object = ClassObject::read(reader)?;
        if object.class.is_nil() {
            return Ok(None);
        }
        let context = reader.context();
        let mesh = Object::from_class(&object).unwrap_or_else(|error| {
            context.kept(object.offset, "a mesh beside an object", error);
            Object::Kept(object.to_raw())
        });
        let mut user_data = if matches!(mesh, Object::Kept(_)) { Vec::new() } else { object.user_data };
        user_data.retain(|data| !mesh.holds(data));
        Ok(Some(Self { mesh, user_data }))
    }

    /// Writes the class object.
    pub(super) fn write(&self, w: &mut Writer) -> Result<()> {
        self.mesh.write(w, &self.user_data)
    }

    /// Whether an archive of the given version can carry the mesh. One that it cannot is left out: it can be made
    /// again.
    pub(super) fn is_writable(&self, version: i32) -> bool {
        self.mesh.check_writable(version).is_ok()
    }
}

/// Reads a flag for each of `count` places, and a mesh where it is set.
pub(super) fn read_flagged(
    reader: &mut Reader<'_>,
    count: usize,
    what: &'static str,
) -> Result<Vec<Option<CachedMesh>>> {
    reader.check_count(count, 1, what)?;
    (0..count).map(|_| if reader.bool(what)? { CachedMesh::read(reader) } else { Ok(None) }).collect()
}

/// Writes a flag for each of `count` places, and the mesh if there is one.
pub(super) fn write_flagged(meshes: &[Option<CachedMesh>], count: usize, w: &mut Writer) -> Result<()> {
    let version = w.version().archive;
    for place in 0..count {
        let mesh = meshes.get(place).and_then(Option::as_ref).filter(|mesh| mesh.is_writable(version));
        w.bool(mesh.is_some());
        if let Some(mesh) = mesh {
            mesh.write(w)?;
        }
    }
    Ok(())
}
