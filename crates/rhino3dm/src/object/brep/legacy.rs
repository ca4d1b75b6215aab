//! The trimmed surfaces of version 2 archives: faces, loops and trims in one run, without vertices and flags.

use katydid_geometry::brep::{CurvePart, Edge, Face, Iso, Loop, LoopKind, Solidity, Trim, TrimKind};

use katydid_geometry::{Brep, Interval};

use super::{BrepObject, Reading, WHAT};
use crate::chunk::Reader;
use crate::object::{CurveForm, cached_mesh, curve, surface};
use crate::{Error, Result};

/// What stands for a number that was never computed.
const UNSET: f64 = -1.234_321_012_343_21e308;
/// The least that a curve, a surface and a trim take.
const LEAST_CURVE: usize = 64;

pub(super) fn read(body: &mut Reader<'_>, minor: u8) -> Result<BrepObject> {
    let offset = body.offset();
    let mut counts = [0; 4];
    for count in &mut counts {
        *count = body.count(LEAST_CURVE, WHAT)?;
    }
    if counts.contains(&0) {
        return Err(Error::malformed(offset, WHAT, "it has no faces, edges, loops or trims"));
    }
    let [faces, edges, _, trims] = counts;
    let is_outward = body.i32(WHAT)? == 1;
    // openNURBS drops the box when it makes faces.
    body.take(48, WHAT)?;
    let mut reading = Reading::default();
    for _ in 0..trims {
        let form = only_segment(curve::read_poly(body)?);
        reading.add_curve_2d(Some(form));
    }
    for place in 0..edges {
        let form = only_segment(curve::read_poly(body)?);
        let domain = form.domain();
        reading.add_curve_3d(Some(form));
        reading.parts.edges.push(Edge {
            part: CurvePart::whole(place, domain),
            vertices: [None; 2],
            trims: Vec::new(),
            tolerance: UNSET,
            deleted: false,
        });
    }
    for _ in 0..faces {
        reading.add_surface(Some(surface::read_nurbs(body)?));
    }
    for face in 0..faces {
        read_face(body, face, &mut reading)?;
    }
    let parts = &mut reading.parts;
    parts.set_iso();
    parts.set_kinds();
    parts.set_vertices();
    parts.set_tolerances_from_older();
    let mut object = reading.finish(offset)?;
    object.render_meshes = cached_mesh::read_flagged(body, faces, "brep render meshes")?;
    if minor >= 1 {
        object.analysis_meshes = cached_mesh::read_flagged(body, faces, "brep analysis meshes")?;
    }
    for meshes in [&mut object.render_meshes, &mut object.analysis_meshes] {
        if meshes.iter().all(Option::is_none) {
            meshes.clear();
        }
    }
    if is_outward && object.brep.is_solid() {
        let mut parts = object.brep.into_parts();
        parts.solidity = Solidity::Outward;
        object.brep = Brep::from_parts(parts).map_err(|e| Error::geometry(offset, WHAT, e))?;
    }
    Ok(object)
}

/// Chains of one curve stand for that curve.
fn only_segment(form: CurveForm) -> CurveForm {
    match form {
        CurveForm::Poly { mut segments, parameters } => match segments.pop() {
            Some(only) if segments.is_empty() => only,
            last => {
                segments.extend(last);
                CurveForm::Poly { segments, parameters }
            }
        },
        other => other,
    }
}

fn read_face(body: &mut Reader<'_>, place: usize, reading: &mut Reading) -> Result<()> {
    const WHAT: &str = "brep face";
    // Its own place and a material.
    body.take(8, WHAT)?;
    let reversed = body.i32(WHAT)? != 0;
    // A type and a box.
    body.take(4 + 48, WHAT)?;
    let count = body.count(44, WHAT)?;
    reading.parts.faces.push(Face::new(place, reversed));
    for _ in 0..count {
        read_loop(body, place, reading)?;
    }
    Ok(())
}

fn read_loop(body: &mut Reader<'_>, face: usize, reading: &mut Reading) -> Result<()> {
    const WHAT: &str = "brep loop";
    body.i32(WHAT)?;
    let kind = match body.i32(WHAT)? {
        0 => LoopKind::Outer,
        1 => LoopKind::Inner,
        -1 => LoopKind::Slit,
        _ => LoopKind::Unknown,
    };
    // A box in the parameter plane.
    body.take(32, WHAT)?;
    let count = body.count(41, WHAT)?;
    let place = reading.parts.loops.len();
    if let Some(face) = reading.parts.faces.get_mut(face) {
        let at = if kind == LoopKind::Outer { 0 } else { face.loops.len() };
        face.loops.insert(at, place);
    }
    let first = reading.parts.trims.len();
    for _ in 0..count {
        read_trim(body, place, reading)?;
    }
    let trims = (first..reading.parts.trims.len()).collect();
    reading.parts.loops.push(Loop { trims, kind, face: Some(face), deleted: false });
    Ok(())
}

fn read_trim(body: &mut Reader<'_>, in_loop: usize, reading: &mut Reading) -> Result<()> {
    const WHAT: &str = "brep trim";
    let offset = body.offset();
    let parts = &mut reading.parts;
    let place = parts.trims.len();
    if place >= parts.curves_2d.len() {
        return Err(Error::malformed(offset, WHAT, "there are more trims than parameter curves"));
    }
    // Its own place and its twin on the neighbouring face.
    body.take(8, WHAT)?;
    let owns_edge = body.bool(WHAT)?;
    let edge = usize::try_from(body.i32(WHAT)?).ok().filter(|edge| *edge < parts.edges.len());
    if owns_edge && edge.is_none() {
        return Err(Error::malformed(offset, WHAT, "it names an edge that does not exist"));
    }
    let reversed = body.i32(WHAT)? != 0;
    // How smoothly it goes on, and whether it is monotonic.
    body.take(8, WHAT)?;
    let [space, flat] = [body.f64(WHAT)?, body.f64(WHAT)?];
    if let Some(edge) = edge.and_then(|edge| parts.edges.get_mut(edge)) {
        edge.trims.push(place);
    }
    let curve = parts.curves_2d.get(place).and_then(Option::as_ref);
    let odd = reading.odd_curves_2d.get(&place);
    let domain = odd.map(CurveForm::domain).or(curve.map(|curve| curve.domain())).unwrap_or(Interval::UNIT);
    parts.trims.push(Trim {
        part: CurvePart::whole(place, domain),
        edge,
        reversed,
        vertices: [None; 2],
        kind: TrimKind::Unknown,
        iso: Iso::None,
        in_loop: Some(in_loop),
        tolerance: [UNSET; 2],
        older_tolerances: [flat, space],
        deleted: false,
    });
    Ok(())
}
