//! Faces and shells of version 1.
//!
//! A shell is a list of faces. A face holds its surface and its loops, a loop its trims, a trim its curve in the
//! parameter plane and, for one of the two trims at an edge, the curve in space. Which trims share an edge is said
//! afterwards: as pairs among the seams of a face, and among the shared trims of a shell.

use katydid_geometry::Interval;
use katydid_geometry::brep::{CurvePart, Edge, Face, Iso, Loop, LoopKind, Trim, TrimKind};

use super::spline::{find, read_surface_substance, substance};
use super::{UNSET, curve, typecode as code};
use crate::chunk::Reader;
use crate::object::BrepReading;
use crate::{BrepObject, CurveForm, Error, Result, SurfaceForm};

const WHAT: &str = "brep of version 1";

/// Reads the substance of a face that is an object by itself.
pub(super) fn read_face(body: &mut Reader<'_>) -> Result<BrepObject> {
    let offset = body.offset();
    let mut reading = BrepReading::default();
    read_face_substance(body, &mut reading)?;
    finish(reading, offset)
}

/// Reads the substance of a shell.
pub(super) fn read_shell(body: &mut Reader<'_>) -> Result<BrepObject> {
    let offset = body.offset();
    let mut reading = BrepReading::default();
    // Whether it is the outer one.
    body.i32(WHAT)?;
    let count = body.count(16, "faces")?;
    body.take(48, "box of a shell")?;
    let pairs = read_pairs(body)?;
    for _ in 0..count {
        let mut chunk = find(body, code::FACE, "face")?;
        let mut face = substance(&mut chunk, code::FACE, "face")?;
        read_face_substance(&mut face, &mut reading)?;
        face.finish();
    }
    join(&mut reading, 0, TrimKind::Mated, &pairs);
    finish(reading, offset)
}

/// What version 1 does not say follows from the rest.
fn finish(mut reading: BrepReading, offset: usize) -> Result<BrepObject> {
    let parts = &mut reading.parts;
    parts.set_vertices();
    parts.set_iso();
    parts.set_tolerances_from_older();
    reading.finish(offset)
}

/// For each trim of a list the place in that list of the trim that it shares its edge with.
fn read_pairs(body: &mut Reader<'_>) -> Result<Vec<i16>> {
    const WHAT: &str = "pairs of trims";
    let offset = body.offset();
    // No pairs may be stated as fewer than none.
    let Ok(count) = usize::try_from(body.i32(WHAT)?) else { return Ok(Vec::new()) };
    let bytes =
        body.take(count.checked_mul(2).ok_or_else(|| Error::malformed(offset, WHAT, "too many"))?, WHAT)?;
    Ok(bytes.as_chunks::<2>().0.iter().map(|two| i16::from_le_bytes(*two)).collect())
}

/// Lets the trims of a kind, from one on, share the edges that their partners have.
fn join(reading: &mut BrepReading, first: usize, kind: TrimKind, pairs: &[i16]) {
    let parts = &mut reading.parts;
    let of_kind = parts.trims.iter().enumerate().skip(first).filter(|(_, trim)| trim.kind == kind);
    let list: Vec<usize> = of_kind.map(|(place, _)| place).take(pairs.len()).collect();
    if list.len() != pairs.len() {
        return;
    }
    for (one, partner) in list.iter().zip(pairs) {
        let Some(other) = usize::try_from(*partner).ok().and_then(|place| list.get(place)) else { continue };
        let edge_of = |trim: usize| parts.trims.get(trim).and_then(|trim| trim.edge);
        let (edge, joined) = match (edge_of(*one), edge_of(*other)) {
            (None, Some(edge)) => (edge, *one),
            (Some(edge), None) => (edge, *other),
            _ => continue,
        };
        if let (Some(edge_part), Some(trim)) = (parts.edges.get_mut(edge), parts.trims.get_mut(joined)) {
            edge_part.trims.push(joined);
            trim.edge = Some(edge);
        }
    }
}

fn read_face_substance(body: &mut Reader<'_>, reading: &mut BrepReading) -> Result<()> {
    let offset = body.offset();
    let reversed = match body.i32(WHAT)? {
        0 => false,
        1 => true,
        other => {
            return Err(Error::malformed(offset, "face", format!("{other} is neither turned over nor not")));
        }
    };
    // Its type.
    body.i32(WHAT)?;
    // Twice the number of loops, and one more when the outer one is among them, which it is.
    let loops = usize::try_from(body.i32(WHAT)?).unwrap_or(0) / 2;
    body.take(48, "box of a face")?;
    let pairs = read_pairs(body)?;
    let first = reading.parts.trims.len();
    let mut chunk = find(body, code::SURFACE, "surface")?;
    let mut surface = substance(&mut chunk, code::SURFACE, "surface")?;
    let place = reading.parts.surfaces.len();
    reading.add_surface(Some(SurfaceForm::Nurbs(read_surface_substance(&mut surface)?)));
    surface.finish();
    let face = reading.parts.faces.len();
    reading.parts.faces.push(Face::new(place, reversed));
    body.check_count(loops, 16, "loops")?;
    for _ in 0..loops {
        let mut chunk = find(body, code::LOOP, "loop")?;
        let mut substance = substance(&mut chunk, code::LOOP, "loop")?;
        read_loop(&mut substance, face, reading)?;
        substance.finish();
    }
    join(reading, first, TrimKind::Seam, &pairs);
    Ok(())
}

fn read_loop(body: &mut Reader<'_>, face: usize, reading: &mut BrepReading) -> Result<()> {
    const WHAT: &str = "loop";
    let offset = body.offset();
    let count = body.count(16, "trims")?;
    if count == 0 {
        return Err(Error::malformed(offset, WHAT, "it has no trims"));
    }
    let kind = match body.i32(WHAT)? {
        -1 => LoopKind::Slit,
        0 => LoopKind::Outer,
        1 => LoopKind::Inner,
        other => return Err(Error::malformed(offset, WHAT, format!("{other} is no kind of loop"))),
    };
    // A box in the parameter plane.
    body.take(32, WHAT)?;
    let place = reading.parts.loops.len();
    reading.parts.loops.push(Loop { trims: Vec::new(), kind, face: Some(face), deleted: false });
    if let Some(face) = reading.parts.faces.get_mut(face) {
        let at = if kind == LoopKind::Outer { 0 } else { face.loops.len() };
        face.loops.insert(at, place);
    }
    for _ in 0..count {
        let mut chunk = find(body, code::TRIM, "trim")?;
        let mut substance = substance(&mut chunk, code::TRIM, "trim")?;
        read_trim(&mut substance, place, reading)?;
        substance.finish();
    }
    Ok(())
}

fn read_trim(body: &mut Reader<'_>, in_loop: usize, reading: &mut BrepReading) -> Result<()> {
    const WHAT: &str = "trim";
    let flags = body.u8(WHAT)?;
    let has_edge = flags & 1 != 0;
    let kind = match flags {
        flags if flags & 2 != 0 => TrimKind::Seam,
        flags if flags & 4 != 0 => TrimKind::Mated,
        _ if has_edge => TrimKind::Boundary,
        _ => TrimKind::Singular,
    };
    let reversed = body.i32(WHAT)? != 0;
    // How smoothly it goes on, and whether it is monotonic.
    body.take(8, WHAT)?;
    let [space, flat] = [body.f64(WHAT)?, body.f64(WHAT)?];
    let part =
        add_curve(curve::read(body)?, reading.parts.curves_2d.len(), |form| reading.add_curve_2d(form));
    let place = reading.parts.trims.len();
    let mut edge = None;
    if has_edge {
        let form = curve::read(body)?;
        let part = add_curve(form, reading.parts.curves_3d.len(), |form| reading.add_curve_3d(form));
        edge = Some(reading.parts.edges.len());
        let (vertices, trims) = ([None; 2], vec![place]);
        reading.parts.edges.push(Edge { part, vertices, trims, tolerance: UNSET, deleted: false });
    }
    reading.parts.trims.push(Trim {
        part,
        edge,
        reversed,
        vertices: [None; 2],
        kind,
        iso: Iso::None,
        in_loop: Some(in_loop),
        tolerance: [UNSET; 2],
        older_tolerances: [flat, space],
        deleted: false,
    });
    if let Some(chain) = reading.parts.loops.get_mut(in_loop) {
        chain.trims.push(place);
    }
    Ok(())
}

/// Adds a curve to a list that has so many; gives the whole of it.
fn add_curve(form: CurveForm, place: usize, add: impl FnOnce(Option<CurveForm>)) -> CurvePart {
    let domain: Interval = form.domain();
    add(Some(form));
    CurvePart::whole(place, domain)
}
