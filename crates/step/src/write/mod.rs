//! Documents as files.

mod beside;
mod brep;
mod chart;
mod curve;
mod edge;
mod product;
mod sheets;
mod style;
mod surface;
mod unit;

use std::io::Write;

use katydid_geometry::{Plane, Point3, Vector3};

use crate::part21::{Id, Sheet, list, quoted, real};
use crate::{Document, LeftOut, Part, Result, Shape};

/// The entities that a part became, by the kind of representation that holds them.
#[derive(Default)]
struct Written {
    solids: Vec<Id>,
    sheets: Vec<Id>,
    curves: Vec<Id>,
    /// What a colour and a layer are given to, and the part that it belongs to.
    styled: Vec<(Id, usize)>,
}

/// Writes a document as a STEP file; gives what could not be written.
///
/// # Errors
/// The destination fails.
pub fn write(document: &Document, out: &mut dyn Write) -> Result<Vec<LeftOut>> {
    let mut sheet = Sheet::default();
    let context = product::Context::put(&mut sheet, document);
    let mut written = Written::default();
    let mut left_out = Vec::new();
    for (place, part) in document.parts.iter().enumerate() {
        let mark = sheet.mark();
        if let Err(error) = put_part(&mut sheet, document, (place, part), &mut written) {
            sheet.back_to(mark);
            left_out.push(LeftOut::new(part.shape.kind(), error.to_string()));
        }
    }
    product::put(&mut sheet, document, &context, &written);
    style::put(&mut sheet, document, &context, &written.styled);
    out.write_all(product::header(document).as_bytes())?;
    out.write_all(sheet.into_text().as_bytes())?;
    out.write_all(b"ENDSEC;\nEND-ISO-10303-21;\n")?;
    out.flush()?;
    Ok(left_out)
}

fn put_part(
    sheet: &mut Sheet,
    document: &Document,
    (place, part): (usize, &Part),
    written: &mut Written,
) -> Result<()> {
    match &part.shape {
        Shape::Points(points) => {
            if !points.iter().all(|p| p.is_finite()) {
                return Err(katydid_geometry::Error::NotFinite("coordinate of a point").into());
            }
            let ids: Vec<Id> = points.iter().map(|p| point(sheet, *p)).collect();
            put_set(sheet, part, place, &ids, written);
        }
        Shape::Curve(curve) => {
            let id = curve::bounded(sheet, curve)?;
            put_set(sheet, part, place, &[id], written);
        }
        Shape::Brep(brep) => {
            let items = brep::put(sheet, brep, &part.name, document.tolerance)?;
            let all = items.solids.iter().chain(&items.sheets);
            written.styled.extend(all.map(|id| (*id, place)));
            written.solids.extend(items.solids);
            written.sheets.extend(items.sheets);
        }
    }
    Ok(())
}

/// Points or curves of one part.
fn put_set(sheet: &mut Sheet, part: &Part, place: usize, items: &[Id], written: &mut Written) {
    let set = sheet.put(format_args!("GEOMETRIC_CURVE_SET({},{})", quoted(&part.name), list(items)));
    written.curves.push(set);
    written.styled.extend(items.iter().map(|id| (*id, place)));
}

fn point(sheet: &mut Sheet, p: Point3) -> Id {
    sheet.put(format_args!("CARTESIAN_POINT('',({},{},{}))", real(p.x), real(p.y), real(p.z)))
}

fn direction(sheet: &mut Sheet, d: Vector3) -> Id {
    sheet.put(format_args!("DIRECTION('',({},{},{}))", real(d.x), real(d.y), real(d.z)))
}

/// A place with its z and x axes.
fn frame(sheet: &mut Sheet, plane: &Plane) -> Id {
    let origin = point(sheet, plane.origin);
    let z = direction(sheet, plane.z_axis);
    let x = direction(sheet, plane.x_axis);
    sheet.put(format_args!("AXIS2_PLACEMENT_3D('',{origin},{z},{x})"))
}

/// `.T.` or `.F.`.
fn flag(yes: bool) -> &'static str {
    if yes { ".T." } else { ".F." }
}
