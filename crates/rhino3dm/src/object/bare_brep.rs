//! A brep that is nothing but one surface: a single face whose only loop runs along the four sides of its surface.

use katydid_geometry::Surface;

use super::brep::read_list;
use super::{ClassObject, RawObject, surface};
use crate::chunk::{Context, Reader};
use crate::{Error, Limits, Result, class_ids, typecode};

const WHAT: &str = "brep";
/// The numbers behind a trim's loop: tolerances, then a domain with its flags or older numbers of the same size.
const TRIM_TAIL: usize = 16 + 48 + 16;
/// The first of the four sides of a surface as a trim names them: W, S, E, N.
const WEST: i32 = 3;

/// What a brep of one untrimmed face consists of.
#[derive(Debug, Clone, PartialEq)]
pub struct BareSurface {
    /// The surface, with the parameters that the face has.
    pub surface: Surface,
    /// Whether the face is turned over: its normal is opposite to the surface's.
    pub is_reversed: bool,
}

impl RawObject {
    /// The surface that a kept brep consists of, when it has one face, not turned over, whose trims run
    /// along the four sides of the surface's domain; nothing for other breps and other classes.
    ///
    /// # Errors
    /// The bytes are broken, are of the layout that version 2 files have, or the kernel refuses the surface.
    pub fn untrimmed_surface(&self) -> Result<Option<Surface>> {
        Ok(self.bare_surface()?.filter(|bare| !bare.is_reversed).map(|bare| bare.surface))
    }

    /// The same for a face that may be turned over.
    ///
    /// # Errors
    /// As above.
    pub fn bare_surface(&self) -> Result<Option<BareSurface>> {
        if class_ids::canonical(self.class) != class_ids::BREP {
            return Ok(None);
        }
        let context = Context::new(&Limits::default());
        self.with_class(&context, |object| match object.data {
            Some(mut body) => read_body(&mut body),
            None => Ok(None),
        })
    }
}

fn read_body(body: &mut Reader<'_>) -> Result<Option<BareSurface>> {
    let offset = body.offset();
    let (major, _) = body.packed_version(WHAT)?;
    if major != 3 {
        return Err(Error::malformed(offset, WHAT, format!("major version {major} is not read yet")));
    }
    body.expect(typecode::ANONYMOUS, "brep parameter curves")?;
    body.expect(typecode::ANONYMOUS, "brep curves")?;
    let surfaces = body.expect(typecode::ANONYMOUS, "brep surfaces")?;
    body.expect(typecode::ANONYMOUS, "brep vertices")?;
    body.expect(typecode::ANONYMOUS, "brep edges")?;
    if !has_four_sides(body)? {
        return Ok(None);
    }
    let (_, loops) = read_list(body, "brep loops")?;
    let (mut faces, count) = read_list(body, "brep faces")?;
    if loops != 1 || count != 1 {
        return Ok(None);
    }
    const FACE: &str = "brep face";
    faces.i32(FACE)?;
    faces.ints(FACE)?;
    let surface = faces.i32(FACE)?;
    let is_reversed = faces.i32(FACE)? != 0;
    let Ok(index) = usize::try_from(surface) else { return Ok(None) };
    Ok(read_surface(surfaces, index)?.map(|surface| BareSurface { surface, is_reversed }))
}

/// Whether all trims run along sides of the surface, and no side is without one. A side may be cut into several.
fn has_four_sides(body: &mut Reader<'_>) -> Result<bool> {
    const WHAT: &str = "brep trims";
    let (mut trims, count) = read_list(body, WHAT)?;
    let mut found = [false; 4];
    for _ in 0..count {
        // Index, parameter curve and its part, edge, two vertices, direction, type.
        trims.take(4 + 4 + 16 + 4 + 8 + 4 + 4, WHAT)?;
        let side = trims.i32(WHAT)?.checked_sub(WEST).and_then(|side| usize::try_from(side).ok());
        let Some(found) = side.and_then(|side| found.get_mut(side)) else { return Ok(false) };
        *found = true;
        trims.take(4 + TRIM_TAIL, WHAT)?;
    }
    Ok(found == [true; 4])
}

/// The surface at one place of the brep's list.
fn read_surface(mut list: Reader<'_>, index: usize) -> Result<Option<Surface>> {
    const WHAT: &str = "brep surfaces";
    list.packed_version(WHAT)?;
    let count = list.count(4, WHAT)?;
    for place in 0..count {
        if list.i32(WHAT)? == 0 {
            continue;
        }
        let object = ClassObject::read(&mut list)?;
        if place != index {
            continue;
        }
        let class = class_ids::canonical(object.class);
        return match object.data {
            Some(mut body) if surface::is_surface(class) => {
                let read = surface::read(class, &mut body)?;
                body.finish();
                Ok(Some(read))
            }
            _ => Ok(None),
        };
    }
    Ok(None)
}
