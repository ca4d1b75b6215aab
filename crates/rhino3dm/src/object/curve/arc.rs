//! Class ArcCurve.

use katydid_geometry::{Arc, Interval};

use super::{CurveForm, major_1};
use crate::Result;
use crate::chunk::{Reader, Writer};

const WHAT: &str = "arc curve";

pub(super) fn read(body: &mut Reader<'_>) -> Result<CurveForm> {
    major_1(body, WHAT)?;
    let (arc, offset) = body.arc(WHAT)?;
    let domain = body.interval(WHAT)?;
    let dimension = match body.i32("dimension")? {
        2 => 2,
        _ => 3,
    };
    Ok(CurveForm::Arc { arc, offset, domain, dimension })
}

pub(super) fn write(arc: &Arc, offset: Option<f64>, domain: Interval, dimension: i32, w: &mut Writer) {
    w.packed_version(1, 0);
    w.arc(arc, offset);
    w.interval(domain);
    w.i32(dimension);
}
