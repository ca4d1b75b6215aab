//! Class Hatch (section 8): a region of a plane filled with a pattern.

use katydid_geometry::Point2;
use uuid::Uuid;

use super::curve::{self, CurveForm};
use super::major_1;
use crate::chunk::{Reader, Writer};
use crate::class_object::UserData;
use crate::version::Version;
use crate::{Error, Result, StoredPlane, class_ids};

/// A region of a plane filled with a pattern. A gradient is user data of the object that holds it.
#[derive(Debug, Clone, PartialEq)]
pub struct Hatch {
    /// The plane it lies in.
    pub plane: StoredPlane,
    /// What the pattern's lengths are multiplied by.
    pub scale: f64,
    /// How far the pattern is turned, in radians.
    pub rotation: f64,
    /// The pattern as an index into [`Model::hatch_patterns`](crate::Model::hatch_patterns); one that is not there is none.
    pub pattern: i32,
    /// The curves that bound it.
    pub loops: Vec<HatchLoop>,
    /// Where the pattern begins, in coordinates of the plane. Version 4 archives cannot hold it.
    pub base_point: Point2,
}

/// One boundary of a hatch.
#[derive(Debug, Clone, PartialEq)]
pub struct HatchLoop {
    /// Whether the region lies inside it, not around it.
    pub outer: bool,
    /// The curve, of dimension 2, in coordinates of the hatch's plane.
    pub curve: CurveForm,
}

const WHAT: &str = "hatch";
/// The shorter form of a loop's version, kind and class chunk.
const LEAST_LOOP: usize = 13;

pub(super) fn read(body: &mut Reader<'_>, user_data: &[UserData]) -> Result<Hatch> {
    let minor = major_1(body, WHAT)?;
    let mut hatch = Hatch {
        plane: body.stored_plane(WHAT)?,
        scale: body.f64(WHAT)?,
        rotation: body.f64(WHAT)?,
        pattern: body.i32(WHAT)?,
        loops: Vec::new(),
        base_point: Point2::ORIGIN,
    };
    let count = body.count(LEAST_LOOP, WHAT)?;
    hatch.loops = (0..count).map(|_| read_loop(body)).collect::<Result<_>>()?;
    if minor >= 2 {
        hatch.base_point = body.point2(WHAT)?;
    } else if let Some(data) = user_data.iter().find(|data| data.class == class_ids::V5_HATCH_BASE) {
        hatch.base_point = data.with_body(read_base_point)?;
    }
    Ok(hatch)
}

fn read_loop(body: &mut Reader<'_>) -> Result<HatchLoop> {
    let offset = body.offset();
    major_1(body, WHAT)?;
    let outer = match body.i32(WHAT)? {
        0 => true,
        1 => false,
        other => return Err(Error::malformed(offset, WHAT, format!("a loop is of kind {other}"))),
    };
    Ok(HatchLoop { outer, curve: curve::read_object(body)? })
}

/// The body of the user data that carries the base point in version 5.
fn read_base_point(body: &mut Reader<'_>) -> Result<Point2> {
    let (mut body, _) = body.versioned_1(WHAT)?;
    body.uuid(WHAT)?;
    body.point2(WHAT)
}

/// The user data that carries the base point to version 5 archives.
pub(super) fn own_user_data(hatch: &Hatch, version: Version) -> Result<Option<UserData>> {
    if version.archive != 50 || hatch.base_point == Point2::ORIGIN {
        return Ok(None);
    }
    let data = UserData::core(class_ids::V5_HATCH_BASE, 0, version, |w| {
        w.versioned(1, 0, |w| {
            w.uuid(Uuid::nil());
            w.point2(hatch.base_point);
            Ok(())
        })
    })?;
    Ok(Some(UserData { application: class_ids::OPENNURBS_5_APPLICATION, ..data }))
}

pub(super) fn write(hatch: &Hatch, w: &mut Writer) -> Result<()> {
    let newer = w.version().archive >= 60;
    w.packed_version(1, if newer { 2 } else { 1 });
    w.stored_plane(&hatch.plane);
    w.f64(hatch.scale);
    w.f64(hatch.rotation);
    w.i32(hatch.pattern);
    w.count(hatch.loops.len(), "loops")?;
    for part in &hatch.loops {
        w.packed_version(1, 1);
        w.i32(i32::from(!part.outer));
        curve::write_object(&part.curve, w)?;
    }
    if newer {
        w.point2(hatch.base_point);
    }
    Ok(())
}
