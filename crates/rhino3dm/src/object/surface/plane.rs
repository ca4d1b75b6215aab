//! Class PlaneSurface. Before version 1.1 the extents are the domains.

use katydid_geometry::{Interval, Plane};

use super::{SurfaceForm, major_1};
use crate::Result;
use crate::chunk::{Reader, Writer};

const WHAT: &str = "plane surface";

pub(super) fn read(body: &mut Reader<'_>) -> Result<SurfaceForm> {
    let minor = major_1(body, WHAT)?;
    let (plane, offset) = body.plane_and_offset(WHAT)?;
    let domains = [body.interval(WHAT)?, body.interval(WHAT)?];
    let extents = if minor >= 1 { [body.interval(WHAT)?, body.interval(WHAT)?] } else { domains };
    Ok(SurfaceForm::Plane { plane, offset, domains, extents })
}

pub(super) fn write(
    plane: &Plane,
    offset: Option<f64>,
    domains: [Interval; 2],
    extents: [Interval; 2],
    w: &mut Writer,
) {
    w.packed_version(1, 1);
    w.plane_and_offset(plane, offset);
    domains.into_iter().chain(extents).for_each(|range| w.interval(range));
}
