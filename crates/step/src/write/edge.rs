//! Edges, with their curves in the parameter planes of their faces.

use super::beside;
use super::chart::Chart;
use super::curve::{self, Room};
use super::flag;
use super::surface::Put;
use crate::Result;
use crate::part21::{Id, Sheet, list, real};
use katydid_geometry::{Brep, Curve, Interval, Point3, Surface, Tolerance};

/// Places at which a curve on a surface is compared with its edge.
const PLACES: u32 = 16;

/// A face's surface, and how the file has it.
pub(super) struct Support<'a> {
    pub(super) surface: &'a Surface,
    pub(super) put: Put,
}

/// Writes an edge between vertices; `supports` are the surfaces of faces, by face. A trim farther from the edge than
/// `near` is left for the edge itself, pulled to the surface: a curve on a surface says the same as its edge.
pub(super) fn put(
    sheet: &mut Sheet,
    brep: &Brep,
    place: usize,
    vertices: [Id; 2],
    supports: &[Option<Support<'_>>],
    near: f64,
    tolerance: f64,
) -> Result<Option<Id>> {
    let Some(curve) = brep.edge_as_curve(place)? else { return Ok(None) };
    let Some(edge) = brep.edges().get(place) else { return Ok(None) };
    let space: Curve = match curve {
        Curve::Line(_) | Curve::Arc(_) => curve,
        other => other.to_nurbs()?.into(),
    };
    let carrier = curve::carrier(sheet, &space)?;
    let flat: Vec<(Id, usize)> = edge
        .trims
        .iter()
        .filter_map(|trim| on_surface(sheet, brep, *trim, &space, supports, near, tolerance))
        .collect();
    let is_seam = matches!(flat.as_slice(), [(_, a), (_, b)] if a == b);
    let ids = list(flat.iter().map(|(id, _)| id));
    let geometry = match flat.len() {
        0 => carrier,
        2 if is_seam => sheet.put(format_args!("SEAM_CURVE('',{carrier},{ids},.CURVE_3D.)")),
        1 | 2 => sheet.put(format_args!("SURFACE_CURVE('',{carrier},{ids},.CURVE_3D.)")),
        _ => carrier,
    };
    let [a, b] = vertices;
    Ok(Some(sheet.put(format_args!("EDGE_CURVE('',{a},{b},{geometry},{})", flag(true)))))
}

/// The parameters of the carrier at an edge's ends.
fn range(space: &Curve) -> Interval {
    match space {
        Curve::Line(c) => Interval::new(0.0, c.line.length()),
        Curve::Arc(c) => c.arc.angle,
        other => other.domain(),
    }
}

/// The curve of a trim in the parameter plane of its face, at the edge's parameters where the edge is; and the face.
fn on_surface(
    sheet: &mut Sheet,
    brep: &Brep,
    place: usize,
    space: &Curve,
    supports: &[Option<Support<'_>>],
    near: f64,
    tolerance: f64,
) -> Option<(Id, usize)> {
    let trim = brep.trims().get(place)?;
    let face = brep.loops().get(trim.in_loop?)?.face?;
    let support = supports.get(face)?.as_ref().filter(|support| support.put.chart.is_exact)?;
    let flat = brep.trim_as_curve(place).ok()??;
    let flat = if trim.reversed { flat.reversed() } else { flat };
    // The parameters are those of the written form, not of an arc's own.
    let flat: Curve = if let Curve::Line(_) = flat { flat } else { flat.to_nurbs().ok()?.into() };
    let along = |curve: &Curve, x: f64| curve.point_at(curve.domain().at(x));
    let is_near = (0..=PLACES).all(|k| {
        let x = f64::from(k) / f64::from(PLACES);
        let uv = along(&flat, x);
        along(space, x).distance_to(support.surface.point_at(uv.x, uv.y)) <= tolerance
    });
    let allowed = Tolerance { absolute: tolerance.min(near), ..Tolerance::default() };
    let flat = if let Some(pulled) = brep.edge_beside_trim(place, space, &allowed).ok().flatten() {
        pulled
    } else if is_near && !is_joined(&flat) {
        flat
    } else {
        let allowed = brep.edges().get(trim.edge?)?.tolerance.max(tolerance);
        match beside::at_pace(&flat, space, support.surface, allowed) {
            Some(chain) => chain.into(),
            None if is_near => flat,
            None => return None,
        }
    };
    let id = flat_curve(sheet, &flat, &support.put.chart, range(space)).ok()?;
    let context = sheet.put(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(2)PARAMETRIC_REPRESENTATION_CONTEXT()REPRESENTATION_CONTEXT('2D SPACE',''))",
    );
    let representation = sheet.put(format_args!("DEFINITIONAL_REPRESENTATION('',({id}),{context})"));
    let id = sheet.put(format_args!("PCURVE('',{},{representation})", support.put.id));
    Some((id, face))
}

/// Whether a curve is joined of pieces that hold together by their ends only, which programs take for corners.
fn is_joined(flat: &Curve) -> bool {
    let Curve::Nurbs(curve) = flat else { return false };
    let spans = curve.span_parameters();
    let inner = spans.get(1..spans.len().saturating_sub(1)).unwrap_or(&[]);
    curve.degree() > 1 && inner.iter().any(|t| curve.multiplicity(*t) >= curve.degree())
}

/// A curve of the parameter plane over the parameters of the edge's carrier.
fn flat_curve(sheet: &mut Sheet, flat: &Curve, chart: &Chart, range: Interval) -> Result<Id> {
    let flat = chart.image(flat)?;
    if let Curve::Line(c) = &flat {
        let speed = (c.line.to - c.line.from) / range.length();
        if (speed.length() - 1.0).abs() <= 1e-9 {
            let from: Point3 = c.line.from - speed * range.start;
            let point = Room::Plane.point(sheet, from);
            let along = sheet.put(format_args!("DIRECTION('',({},{}))", real(speed.x), real(speed.y)));
            let vector = sheet.put(format_args!("VECTOR('',{along},1.)"));
            return Ok(sheet.put(format_args!("LINE('',{point},{vector})")));
        }
    }
    let spline = flat.with_domain(range)?.to_nurbs()?;
    curve::spline(sheet, &spline, Room::Plane)
}
