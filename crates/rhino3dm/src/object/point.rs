//! Class Point (section 8).

use katydid_geometry::Point3;

use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

const WHAT: &str = "point";

pub(super) fn read(body: &mut Reader<'_>) -> Result<Point3> {
    super::major_1(body, WHAT)?;
    let offset = body.offset();
    let point = body.point(WHAT)?;
    if !point.is_finite() {
        return Err(Error::geometry(offset, WHAT, katydid_geometry::Error::NotFinite("point")));
    }
    Ok(point)
}

pub(super) fn write(point: Point3, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 0);
    w.point(point);
    Ok(())
}
