//! Class SumSurface: a shift, then two curves as class objects.

use katydid_geometry::SumSurface;

use super::{curve, major_1};
use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

const WHAT: &str = "sum surface";

pub(super) fn read(body: &mut Reader<'_>) -> Result<SumSurface> {
    let offset = body.offset();
    major_1(body, WHAT)?;
    let shift = body.vector(WHAT)?;
    body.take(48, "box of the sum surface")?;
    let first = curve::read_object(body)?;
    let second = curve::read_object(body)?;
    SumSurface::new(first, second, shift).map_err(|e| Error::geometry(offset, WHAT, e))
}

pub(super) fn write(surface: &SumSurface, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 0);
    w.vector(surface.shift());
    w.empty_box();
    let [first, second] = surface.curves();
    curve::write_object(first, w)?;
    curve::write_object(second, w)
}
