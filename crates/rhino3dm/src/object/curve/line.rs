//! Class LineCurve.

use katydid_geometry::{Interval, Line};

use super::{CurveForm, major_1};
use crate::Result;
use crate::chunk::{Reader, Writer};

const WHAT: &str = "line curve";

pub(super) fn read(body: &mut Reader<'_>) -> Result<CurveForm> {
    major_1(body, WHAT)?;
    Ok(CurveForm::Line {
        line: body.line(WHAT)?,
        domain: body.interval(WHAT)?,
        dimension: body.i32("dimension")?,
    })
}

pub(super) fn write(line: &Line, domain: Interval, dimension: i32, w: &mut Writer) {
    w.packed_version(1, 0);
    w.line(line);
    w.interval(domain);
    w.i32(dimension);
}
