//! Class PolylineCurve.

use katydid_geometry::PolylineCurve;

use super::major_1;
use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

const WHAT: &str = "polyline curve";

pub(super) fn read(body: &mut Reader<'_>) -> Result<PolylineCurve> {
    let offset = body.offset();
    major_1(body, WHAT)?;
    let points = body.points(WHAT)?;
    let parameters = body.doubles(WHAT)?;
    body.i32("dimension")?;
    PolylineCurve::with_parameters(points, parameters).map_err(|e| Error::geometry(offset, WHAT, e))
}

pub(super) fn write(curve: &PolylineCurve, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 0);
    w.points(curve.points())?;
    w.doubles(curve.parameters())?;
    w.i32(3);
    Ok(())
}
