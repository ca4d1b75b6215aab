//! Class CurveOnSurface: a curve in the parameter plane of a surface. No program is known to write it by itself.

use super::{CurveForm, read_object, write_object};
use crate::Result;
use crate::chunk::{Reader, Writer};
use crate::object::surface::{self, SurfaceForm};

/// A curve in the parameter plane of a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveOnSurface {
    /// The curve in the parameter plane.
    pub flat: CurveForm,
    /// The same in space, nearly, when it was computed.
    pub space: Option<CurveForm>,
    /// The surface.
    pub surface: SurfaceForm,
}

pub(super) fn read(body: &mut Reader<'_>) -> Result<CurveOnSurface> {
    let flat = read_object(body)?;
    let has_space = body.i32("curve on a surface")? != 0;
    let space = if has_space { Some(read_object(body)?) } else { None };
    Ok(CurveOnSurface { flat, space, surface: surface::read_object(body)? })
}

pub(super) fn write(curve: &CurveOnSurface, w: &mut Writer) -> Result<()> {
    write_object(&curve.flat, w)?;
    w.i32(i32::from(curve.space.is_some()));
    if let Some(space) = &curve.space {
        write_object(space, w)?;
    }
    surface::write_object(&curve.surface, w)
}
