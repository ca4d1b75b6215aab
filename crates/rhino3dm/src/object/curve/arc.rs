//! Class ArcCurve.

use std::f64::consts::TAU;

use katydid_geometry::ArcCurve;

use super::{check_domain, major_1};
use crate::chunk::{Reader, Writer};
use crate::object::is_frame;
use crate::{Error, Result};

const WHAT: &str = "arc curve";

pub(super) fn read(body: &mut Reader<'_>) -> Result<ArcCurve> {
    let offset = body.offset();
    major_1(body, WHAT)?;
    let arc = body.arc(WHAT)?;
    let domain = body.interval(WHAT)?;
    body.i32("dimension")?;
    let radius = arc.circle.radius;
    if !(radius.is_finite() && radius > 0.0) {
        return Err(Error::malformed(offset, WHAT, format!("its radius is {radius}")));
    }
    if !is_frame(&arc.circle.plane) {
        return Err(Error::malformed(offset, WHAT, "the axes of its plane are not square"));
    }
    let angle = arc.angle.length();
    if !(arc.angle.start.is_finite() && angle > 0.0 && angle <= TAU + 1e-9) {
        return Err(Error::malformed(offset, WHAT, format!("its angle is {angle}")));
    }
    check_domain(domain, offset, WHAT)?;
    Ok(ArcCurve { arc, domain })
}

pub(super) fn write(curve: &ArcCurve, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 0);
    w.arc(&curve.arc);
    w.interval(curve.domain);
    w.i32(3);
    Ok(())
}
