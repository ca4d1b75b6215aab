//! Class RevSurface. From version 2 on the angle's parameter has a domain of its own.

use super::{SurfaceForm, curve};
use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

const WHAT: &str = "surface of revolution";

pub(super) fn read(body: &mut Reader<'_>) -> Result<SurfaceForm> {
    let offset = body.offset();
    let (major, _) = body.packed_version(WHAT)?;
    if !(1..=2).contains(&major) {
        return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
    }
    let axis = body.line(WHAT)?;
    let angle = body.interval(WHAT)?;
    let domain = if major >= 2 { body.interval(WHAT)? } else { angle };
    let bounds = body.bounds("box of the surface of revolution")?;
    let transposed = body.i32(WHAT)? != 0;
    let profile = if body.bool(WHAT)? { Some(Box::new(curve::read_object(body)?)) } else { None };
    Ok(SurfaceForm::Revolution { axis, angle, domain, bounds, transposed, profile })
}

pub(super) fn write(form: &SurfaceForm, w: &mut Writer) -> Result<()> {
    let SurfaceForm::Revolution { axis, angle, domain, bounds, transposed, profile } = form else {
        return Ok(());
    };
    w.packed_version(2, 0);
    w.line(axis);
    w.interval(*angle);
    w.interval(*domain);
    w.bounds(*bounds);
    w.i32(i32::from(*transposed));
    w.bool(profile.is_some());
    profile.as_ref().map_or(Ok(()), |profile| curve::write_object(profile, w))
}
