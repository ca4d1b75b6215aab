//! Breps of the toolkit that came before openNURBS: lists of parts that name each other by their places.

use katydid_geometry::brep::{CurvePart, Edge, Face, Iso, Loop, LoopKind, Trim, Vertex};

use super::{curve, spline, typecode as code};
use crate::chunk::Reader;
use crate::object::{BrepReading, brep_trim};
use crate::{BrepObject, Error, Result, SurfaceForm};

const WHAT: &str = "brep of the toolkit";

/// Reads the data of a brep.
pub(super) fn read_brep(chunks: &mut Reader<'_>) -> Result<BrepObject> {
    let mut body = chunks.expect(code::TOOLKIT_DATA, WHAT)?;
    let offset = body.offset();
    spline::toolkit_version(&mut body, WHAT)?;
    let mut reading = BrepReading::default();
    for _ in 0..list(&mut body, 12, "parameter curves")? {
        reading.add_curve_2d(Some(curve::read_toolkit(&mut body)?));
    }
    for _ in 0..list(&mut body, 12, "space curves")? {
        reading.add_curve_3d(Some(curve::read_toolkit(&mut body)?));
    }
    for _ in 0..list(&mut body, 8, "surfaces")? {
        let mut chunk = body.expect(code::TOOLKIT_SURFACE, WHAT)?;
        reading.add_surface(Some(SurfaceForm::Nurbs(spline::read_toolkit_surface(&mut chunk)?)));
    }
    let parts = &mut reading.parts;
    parts.vertices =
        (0..list(&mut body, 40, "vertices")?).map(|_| read_vertex(&mut body)).collect::<Result<_>>()?;
    parts.edges = (0..list(&mut body, 44, "edges")?).map(|_| read_edge(&mut body)).collect::<Result<_>>()?;
    parts.trims = (0..list(&mut body, 140, "trims")?).map(|_| read_trim(&mut body)).collect::<Result<_>>()?;
    parts.loops = (0..list(&mut body, 16, "loops")?).map(|_| read_loop(&mut body)).collect::<Result<_>>()?;
    parts.faces = (0..list(&mut body, 16, "faces")?).map(|_| read_face(&mut body)).collect::<Result<_>>()?;
    reading.parts.set_iso();
    reading.finish(offset)
}

/// The length of a list.
fn list(body: &mut Reader<'_>, least: usize, what: &'static str) -> Result<usize> {
    body.count(least, what)
}

/// A place in a list; nothing when it is negative.
fn place(body: &mut Reader<'_>) -> Result<Option<usize>> {
    Ok(usize::try_from(body.i32(WHAT)?).ok())
}

/// Places in a list; negative ones name nothing.
fn places(body: &mut Reader<'_>) -> Result<Vec<usize>> {
    Ok(body.ints(WHAT)?.into_iter().filter_map(|place| usize::try_from(place).ok()).collect())
}

/// The whole of what a part covers of its curve.
fn part(body: &mut Reader<'_>) -> Result<CurvePart> {
    let curve = place(body)?;
    let range = body.interval(WHAT)?;
    Ok(CurvePart { curve, range, reversed: false, domain: range })
}

fn read_vertex(body: &mut Reader<'_>) -> Result<Vertex> {
    body.i32(WHAT)?;
    let point = body.point(WHAT)?;
    let edges = places(body)?;
    let tolerance = body.f64(WHAT)?;
    Ok(Vertex { edges, ..Vertex::new(point, tolerance) })
}

fn read_edge(body: &mut Reader<'_>) -> Result<Edge> {
    body.i32(WHAT)?;
    let part = part(body)?;
    let vertices = [place(body)?, place(body)?];
    Ok(Edge { part, vertices, trims: places(body)?, tolerance: body.f64(WHAT)?, deleted: false })
}

/// A trim as version 2 has it; a flag that is computed anew is passed over.
fn read_trim(body: &mut Reader<'_>) -> Result<Trim> {
    body.i32(WHAT)?;
    Ok(Trim { iso: Iso::None, ..brep_trim(body, false)? })
}

fn read_loop(body: &mut Reader<'_>) -> Result<Loop> {
    body.i32(WHAT)?;
    let trims = places(body)?;
    let kind = match body.i32(WHAT)? {
        1 => LoopKind::Outer,
        2 => LoopKind::Inner,
        3 => LoopKind::Slit,
        _ => LoopKind::Unknown,
    };
    Ok(Loop { trims, kind, face: place(body)?, deleted: false })
}

fn read_face(body: &mut Reader<'_>) -> Result<Face> {
    let offset = body.offset();
    body.i32(WHAT)?;
    let loops = places(body)?;
    let surface = place(body)?.ok_or_else(|| Error::malformed(offset, WHAT, "a face has no surface"))?;
    let reversed = body.i32(WHAT)? != 0;
    Ok(Face { loops, ..Face::new(surface, reversed) })
}
