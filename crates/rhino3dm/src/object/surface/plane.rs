//! Class PlaneSurface: domains, and from version 1.1 the part of the plane that they are mapped to.

use katydid_geometry::{Direction, PlaneSurface};

use super::{is_frame, major_1};
use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

const WHAT: &str = "plane surface";

pub(super) fn read(body: &mut Reader<'_>) -> Result<PlaneSurface> {
    let offset = body.offset();
    let minor = major_1(body, WHAT)?;
    let plane = body.plane(WHAT)?;
    if !is_frame(&plane) {
        return Err(Error::malformed(offset, WHAT, "the axes of its plane are not square"));
    }
    let domains = [body.interval(WHAT)?, body.interval(WHAT)?];
    let extents = if minor >= 1 { [body.interval(WHAT)?, body.interval(WHAT)?] } else { domains };
    PlaneSurface::with_domains(plane, extents, domains).map_err(|e| Error::geometry(offset, WHAT, e))
}

pub(super) fn write(surface: &PlaneSurface, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 1);
    w.plane(surface.plane());
    let domains = Direction::BOTH.map(|d| surface.domain(d));
    for range in domains.into_iter().chain(surface.extents()) {
        w.interval(range);
    }
    Ok(())
}
