//! Lists of curves and surfaces: a flag and perhaps a class object a place.

use std::collections::BTreeMap;

use katydid_geometry::{Curve, Surface};

use crate::chunk::{Reader, Writer};
use crate::object::{CurveForm, SurfaceForm, curve, surface};
use crate::{Result, typecode};

/// A chunk that begins with version 1.0 and a count of items of at least `least` bytes.
pub(super) fn read_list<'a>(
    body: &mut Reader<'a>,
    least: usize,
    what: &'static str,
) -> Result<(Reader<'a>, u8, usize)> {
    let mut list = body.expect(typecode::ANONYMOUS, what)?;
    let (_, minor) = list.packed_version(what)?;
    let count = list.count(least, what)?;
    Ok((list, minor, count))
}

/// The same to write; `items` writes what stands behind the count.
pub(super) fn write_list(
    minor: u8,
    count: usize,
    w: &mut Writer,
    items: impl FnOnce(&mut Writer) -> Result<()>,
) -> Result<()> {
    w.chunk(typecode::ANONYMOUS, |w| {
        w.packed_version(1, minor);
        w.count(count, "parts of a brep")?;
        items(w)
    })
}

pub(super) fn read_curves(body: &mut Reader<'_>, mut add: impl FnMut(Option<CurveForm>)) -> Result<()> {
    const WHAT: &str = "brep curves";
    let (mut list, _, count) = read_list(body, 4, WHAT)?;
    for _ in 0..count {
        let present = list.i32(WHAT)? != 0;
        add(if present { Some(curve::read_object(&mut list)?) } else { None });
    }
    list.finish();
    Ok(())
}

pub(super) fn read_surfaces(body: &mut Reader<'_>, mut add: impl FnMut(Option<SurfaceForm>)) -> Result<()> {
    const WHAT: &str = "brep surfaces";
    let (mut list, _, count) = read_list(body, 4, WHAT)?;
    for _ in 0..count {
        let present = list.i32(WHAT)? != 0;
        add(if present { Some(surface::read_object(&mut list)?) } else { None });
    }
    list.finish();
    Ok(())
}

pub(super) fn write_curves(
    curves: &[Option<Curve>],
    odd: &BTreeMap<usize, CurveForm>,
    dimension: i32,
    w: &mut Writer,
) -> Result<()> {
    write_list(0, curves.len(), w, |w| {
        for (place, curve) in curves.iter().enumerate() {
            let made = curve.as_ref().map(|curve| CurveForm::of(curve, dimension));
            let form = odd.get(&place).or(made.as_ref());
            w.i32(i32::from(form.is_some()));
            if let Some(form) = form {
                curve::write_object(form, w)?;
            }
        }
        Ok(())
    })
}

pub(super) fn write_surfaces(
    surfaces: &[Option<Surface>],
    odd: &BTreeMap<usize, SurfaceForm>,
    w: &mut Writer,
) -> Result<()> {
    write_list(0, surfaces.len(), w, |w| {
        for (place, surface) in surfaces.iter().enumerate() {
            let made = surface.as_ref().filter(|_| !odd.contains_key(&place)).map(SurfaceForm::of);
            let form = odd.get(&place).or(made.as_ref());
            w.i32(i32::from(form.is_some()));
            if let Some(form) = form {
                surface::write_object(form, w)?;
            }
        }
        Ok(())
    })
}
