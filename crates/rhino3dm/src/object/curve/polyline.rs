//! Class PolylineCurve. Its points have three coordinates in every dimension.

use katydid_geometry::Point3;

use super::{CurveForm, major_1};
use crate::Result;
use crate::chunk::{Reader, Writer};

const WHAT: &str = "polyline curve";

pub(super) fn read(body: &mut Reader<'_>) -> Result<CurveForm> {
    major_1(body, WHAT)?;
    Ok(CurveForm::Polyline {
        points: body.points(WHAT)?,
        parameters: body.doubles(WHAT)?,
        dimension: body.i32("dimension")?,
    })
}

pub(super) fn write(points: &[Point3], parameters: &[f64], dimension: i32, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 0);
    w.points(points)?;
    w.doubles(parameters)?;
    w.i32(dimension);
    Ok(())
}
