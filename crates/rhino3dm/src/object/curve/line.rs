//! Class LineCurve.

use katydid_geometry::LineCurve;

use super::{check_domain, major_1};
use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

const WHAT: &str = "line curve";

pub(super) fn read(body: &mut Reader<'_>) -> Result<LineCurve> {
    let offset = body.offset();
    major_1(body, WHAT)?;
    let line = body.line(WHAT)?;
    let domain = body.interval(WHAT)?;
    body.i32("dimension")?;
    if !(line.from.is_finite() && line.to.is_finite()) {
        return Err(Error::geometry(offset, WHAT, katydid_geometry::Error::NotFinite("end of the line")));
    }
    check_domain(domain, offset, WHAT)?;
    Ok(LineCurve { line, domain })
}

pub(super) fn write(curve: &LineCurve, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 0);
    w.line(&curve.line);
    w.interval(curve.domain);
    w.i32(3);
    Ok(())
}
