//! Class RevSurface. From version 2 on the angle's parameter has a domain of its own.

use katydid_geometry::{Direction, RevolutionSurface};

use super::curve;
use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

const WHAT: &str = "surface of revolution";

pub(super) fn read(body: &mut Reader<'_>) -> Result<RevolutionSurface> {
    let offset = body.offset();
    let (major, _) = body.packed_version(WHAT)?;
    if !(1..=2).contains(&major) {
        return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
    }
    let axis = body.line(WHAT)?;
    let angle = body.interval(WHAT)?;
    let domain = if major >= 2 { body.interval(WHAT)? } else { angle };
    body.take(48, "box of the surface of revolution")?;
    let transposed = body.i32(WHAT)? != 0;
    if !body.bool(WHAT)? {
        return Err(Error::malformed(offset, WHAT, "it has no profile"));
    }
    let profile = curve::read_object(body)?;
    let surface = RevolutionSurface::with_domain(profile, axis, angle, domain)
        .map_err(|e| Error::geometry(offset, WHAT, e))?;
    Ok(if transposed { surface.transposed() } else { surface })
}

pub(super) fn write(surface: &RevolutionSurface, w: &mut Writer) -> Result<()> {
    let along = surface.angle_direction();
    w.packed_version(2, 0);
    w.line(&surface.axis());
    w.interval(surface.angle());
    w.interval(surface.domain(along));
    w.empty_box();
    w.i32(i32::from(along == Direction::V));
    w.bool(true);
    curve::write_object(surface.profile(), w)
}
