//! The meshes beside an extrusion: a list from version 60 on, before that user data with two places.

use uuid::{Uuid, uuid};

use crate::chunk::{Reader, Writer};
use crate::class_object::{UserData, write_null};
use crate::object::CachedMesh;
use crate::version::Version;
use crate::{Result, class_ids};

const WHAT: &str = "meshes of an extrusion";
/// The mesh for display.
const RENDER: Uuid = uuid!("F5E3BAA9-A7A2-49FD-B8A1-66EB274A5F91");
/// The mesh for analysis.
const ANALYSIS: Uuid = uuid!("AC12F955-A29F-437B-A4C9-06C85B7FF57C");

/// A mesh beside an extrusion.
#[derive(Debug, Clone, PartialEq)]
pub struct ExtrusionMesh {
    /// What it is for, as an identifier.
    pub purpose: Uuid,
    /// The mesh.
    pub mesh: CachedMesh,
}

/// A flag before each item, and a cleared one at the end.
pub(super) fn read(reader: &mut Reader<'_>) -> Result<Vec<ExtrusionMesh>> {
    let (mut list, _) = reader.versioned_1(WHAT)?;
    let mut meshes = Vec::new();
    while list.bool(WHAT)? {
        let (mut item, _) = list.versioned_1(WHAT)?;
        let purpose = item.uuid(WHAT)?;
        if let Some(mesh) = CachedMesh::read(&mut item)? {
            meshes.push(ExtrusionMesh { purpose, mesh });
        }
        item.finish();
    }
    list.finish();
    Ok(meshes)
}

pub(super) fn write(meshes: &[ExtrusionMesh], w: &mut Writer) -> Result<()> {
    let version = w.version().archive;
    w.versioned(1, 0, |w| {
        for item in meshes.iter().filter(|item| item.mesh.is_writable(version)) {
            w.bool(true);
            w.versioned(1, 0, |w| {
                w.uuid(item.purpose);
                item.mesh.write(w)
            })?;
        }
        w.bool(false);
        Ok(())
    })
}

/// Adds the meshes of version 5 user data: for display, for analysis, and one that is always missing.
pub(super) fn add_version_5(meshes: &mut Vec<ExtrusionMesh>, data: &UserData) -> Result<()> {
    data.with_body(|body| {
        for purpose in [RENDER, ANALYSIS] {
            if let Some(mesh) = CachedMesh::read(body)? {
                meshes.push(ExtrusionMesh { purpose, mesh });
            }
        }
        Ok(())
    })
}

pub(super) fn to_version_5(meshes: &[ExtrusionMesh], version: Version) -> Result<Option<UserData>> {
    let [render, analysis] = [RENDER, ANALYSIS].map(|purpose| {
        let found = meshes.iter().find(|item| item.purpose == purpose);
        found.filter(|item| item.mesh.is_writable(version.archive))
    });
    // openNURBS writes none without a mesh for display.
    if render.is_none() {
        return Ok(None);
    }
    let data = UserData::core(class_ids::V5_EXTRUSION_MESHES, 1, version, |w| {
        for item in [render, analysis] {
            match item {
                Some(item) => item.mesh.write(w)?,
                None => write_null(w)?,
            }
        }
        write_null(w)
    })?;
    Ok(Some(UserData { application: class_ids::OPENNURBS_5_APPLICATION, ..data }))
}
