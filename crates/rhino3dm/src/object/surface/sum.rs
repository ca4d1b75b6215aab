//! Class SumSurface: a shift, then two curves as class objects.

use super::{SurfaceForm, curve, major_1};
use crate::Result;
use crate::chunk::{Reader, Writer};

const WHAT: &str = "sum surface";

pub(super) fn read(body: &mut Reader<'_>) -> Result<SurfaceForm> {
    major_1(body, WHAT)?;
    let shift = body.vector(WHAT)?;
    let bounds = body.bounds("box of the sum surface")?;
    let curves = Box::new([curve::read_object(body)?, curve::read_object(body)?]);
    Ok(SurfaceForm::Sum { shift, bounds, curves })
}

pub(super) fn write(form: &SurfaceForm, w: &mut Writer) -> Result<()> {
    let SurfaceForm::Sum { shift, bounds, curves } = form else { return Ok(()) };
    w.packed_version(1, 0);
    w.vector(*shift);
    w.bounds(*bounds);
    curves.iter().try_for_each(|c| curve::write_object(c, w))
}
