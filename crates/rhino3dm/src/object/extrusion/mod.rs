//! Class Extrusion: curves in a plane moved along a segment, with flat or mitred ends and perhaps caps.

mod brep_form;
mod meshes;

pub use meshes::ExtrusionMesh;

use katydid_geometry::{Interval, Line, Vector3};

use super::{CurveForm, curve};
use crate::chunk::{Reader, Writer};
use crate::class_object::UserData;
use crate::version::Version;
use crate::{Error, Result, class_ids};

const WHAT: &str = "extrusion";
/// The first version whose archives have extrusions.
pub(super) const FIRST: i32 = 50;

/// Curves in a plane moved along a segment.
///
/// Profiles are curves in the plane through a point of the path whose y axis is `up` and whose normal is the
/// path's direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Extrusion {
    /// The profile, of dimension 2; several closed ones are the segments of a polycurve, the outer one first.
    pub profile: Option<CurveForm>,
    /// How many profiles there are.
    pub profile_count: i32,
    /// The line along which the profile is moved.
    pub path: Line,
    /// The part of the path that is used, 0 its start and 1 its end.
    pub part: Interval,
    /// The direction of the profile plane's y axis.
    pub up: Vector3,
    /// At the start and the end, whether the extrusion is cut at a slant.
    pub is_mitred: [bool; 2],
    /// At the start and the end, the normal of the cut in the profile plane's coordinates.
    pub mitre_normals: [Vector3; 2],
    /// The parameters along the path.
    pub path_domain: Interval,
    /// Whether the path runs along u and the profile along v.
    pub transposed: bool,
    /// At the start and the end, whether a closed profile is capped.
    pub caps: [bool; 2],
    /// Meshes for display and analysis.
    pub meshes: Vec<ExtrusionMesh>,
}

/// Reads the body; version 5 archives have the meshes in user data.
pub(super) fn read(body: &mut Reader<'_>, user_data: &[UserData]) -> Result<Extrusion> {
    let (mut chunk, minor) = body.versioned_1(WHAT)?;
    let reader = &mut chunk;
    let profile = curve::read_object(reader)?;
    let mut extrusion = Extrusion {
        profile_count: 1,
        path: reader.line(WHAT)?,
        part: reader.interval(WHAT)?,
        up: reader.vector(WHAT)?,
        is_mitred: [reader.bool(WHAT)?, reader.bool(WHAT)?],
        mitre_normals: [reader.vector(WHAT)?, reader.vector(WHAT)?],
        path_domain: reader.interval(WHAT)?,
        transposed: reader.bool(WHAT)?,
        caps: [false; 2],
        meshes: Vec::new(),
        profile: None,
    };
    if minor >= 1 {
        extrusion.profile_count = reader.i32(WHAT)?;
    }
    if minor >= 2 {
        extrusion.caps = [reader.bool(WHAT)?, reader.bool(WHAT)?];
    } else {
        // Older extrusions of closed profiles are capped.
        extrusion.caps = [outer_is_closed(&profile, extrusion.profile_count); 2];
    }
    if minor >= 3 {
        extrusion.meshes = meshes::read(reader)?;
    }
    extrusion.profile = Some(profile);
    chunk.finish();
    if let Some(data) = user_data.iter().find(|data| data.class == class_ids::V5_EXTRUSION_MESHES) {
        meshes::add_version_5(&mut extrusion.meshes, data)?;
    }
    Ok(extrusion)
}

fn outer_is_closed(profile: &CurveForm, count: i32) -> bool {
    let outer = match profile {
        CurveForm::Poly { segments, .. } if count > 1 => segments.first(),
        whole => Some(whole),
    };
    outer.and_then(|form| form.to_curve().ok()).is_some_and(|curve| curve.is_closed())
}

/// The user data that carries the meshes to version 50 archives.
pub(super) fn own_user_data(extrusion: &Extrusion, version: Version) -> Result<Option<UserData>> {
    if version.archive == 50 { meshes::to_version_5(&extrusion.meshes, version) } else { Ok(None) }
}

/// Whether an archive of the given version can carry an extrusion, as a brep if need be.
pub(super) fn check_writable(extrusion: &Extrusion, version: i32) -> Result<()> {
    if version >= FIRST || extrusion.to_brep().is_some() {
        return Ok(());
    }
    Err(Error::CannotWrite {
        what: "an extrusion".into(),
        version,
        why: "the class is not known there, and this one cannot be made a brep".into(),
    })
}

pub(super) fn write(extrusion: &Extrusion, w: &mut Writer) -> Result<()> {
    let version = w.version().archive;
    let has_meshes = version >= 60;
    w.versioned(1, if has_meshes { 3 } else { 2 }, |w| {
        match &extrusion.profile {
            Some(profile) => curve::write_object(profile, w)?,
            None => crate::class_object::write_null(w)?,
        }
        w.line(&extrusion.path);
        w.interval(extrusion.part);
        w.vector(extrusion.up);
        extrusion.is_mitred.iter().for_each(|mitred| w.bool(*mitred));
        extrusion.mitre_normals.iter().for_each(|normal| w.vector(*normal));
        w.interval(extrusion.path_domain);
        w.bool(extrusion.transposed);
        w.i32(extrusion.profile_count);
        extrusion.caps.iter().for_each(|capped| w.bool(*capped));
        if has_meshes { meshes::write(&extrusion.meshes, w) } else { Ok(()) }
    })
}
