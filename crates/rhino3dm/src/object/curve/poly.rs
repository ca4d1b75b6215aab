//! Class PolyCurve: class objects end to end.

use katydid_geometry::{Interval, PolyCurve};

use super::{CurveForm, major_1, read_object};
use crate::Result;
use crate::chunk::{Reader, Writer};

const WHAT: &str = "polycurve";
/// Files written before this openNURBS version nest polycurves where later ones hold the segments in a row.
const NESTED_BEFORE: u32 = 200_304_080;
/// How far joints may be from the ends of segments to be taken for them, as a fraction of the shorter segment: the
/// square root of the machine epsilon.
const FUZZ: f64 = 1.490_116_119_385e-8;
/// A class chunk's header in its shorter form.
const LEAST_SEGMENT: usize = 8;

pub(super) fn read(body: &mut Reader<'_>) -> Result<CurveForm> {
    major_1(body, WHAT)?;
    let count = body.count(LEAST_SEGMENT, WHAT)?;
    // Two reserved numbers and a box.
    body.take(8 + 48, WHAT)?;
    let mut parameters = body.doubles(WHAT)?;
    body.check_count(count, LEAST_SEGMENT, WHAT)?;
    let mut segments = (0..count).map(|_| read_object(body)).collect::<Result<Vec<CurveForm>>>()?;
    settle(&segments, &mut parameters);
    if body.version().opennurbs < NESTED_BEFORE && parameters.len() == segments.len() + 1 {
        (segments, parameters) = flattened(segments, &parameters);
    }
    Ok(CurveForm::Poly { segments, parameters })
}

/// The form of a polycurve. Segments that end at their joints but for rounding are made to end there: what reads the
/// file would move the joints instead, and with the last of them the domain of the whole, on which others rest.
pub(super) fn form_of(curve: &PolyCurve, dimension: i32) -> CurveForm {
    let parameters = curve.parameters().to_vec();
    let mut segments: Vec<CurveForm> =
        curve.segments().iter().map(|segment| CurveForm::of(segment, dimension)).collect();
    let mut settled = parameters.clone();
    settle(&segments, &mut settled);
    if settled != parameters {
        for (i, segment) in curve.segments().iter().enumerate() {
            let own = curve.segment_domain(i);
            let moved = segment.with_domain(own).ok().filter(|moved| moved.domain() == own);
            if let (Some(moved), Some(place)) = (moved, segments.get_mut(i)) {
                *place = CurveForm::of(&moved, dimension);
            }
        }
    }
    CurveForm::Poly { segments, parameters }
}

/// Joints that are the ends of segments but for rounding are those ends: some programs stored them inexactly, and
/// openNURBS mends that when it reads.
fn settle(segments: &[CurveForm], parameters: &mut [f64]) {
    if parameters.len() != segments.len() + 1 {
        return;
    }
    let domains: Vec<Interval> = segments.iter().map(CurveForm::domain).collect();
    let near = |a: f64, b: f64, length: f64| a != b && (a - b).abs() <= length * FUZZ;
    for (pair, joint) in domains.windows(2).zip(parameters.iter_mut().skip(1)) {
        let &[before, after] = pair else { continue };
        let inside = *joint > before.start && *joint < after.end;
        if inside
            && before.end == after.start
            && near(before.end, *joint, before.length().min(after.length()))
        {
            *joint = before.end;
        }
    }
    if let (Some(domain), Some(last)) = (domains.last(), parameters.last_mut())
        && *last > domain.start
        && near(domain.end, *last, domain.length())
    {
        *last = domain.end;
    }
}

/// The segments of nested polycurves in place of those, their joints mapped into the outer parameters. One level
/// is enough: inner polycurves were read by the same rule.
fn flattened(segments: Vec<CurveForm>, parameters: &[f64]) -> (Vec<CurveForm>, Vec<f64>) {
    let mut flat = Vec::with_capacity(segments.len());
    let mut joints: Vec<f64> = parameters.first().copied().into_iter().collect();
    for (segment, ends) in segments.into_iter().zip(parameters.windows(2)) {
        let &[start, end] = ends else { continue };
        let domain = segment.domain();
        match segment {
            CurveForm::Poly { segments: parts, parameters } if parameters.len() == parts.len() + 1 => {
                let inside = parameters.iter().skip(1).take(parts.len().saturating_sub(1));
                joints.extend(inside.map(|t| start + (end - start) * domain.normalized(*t)));
                flat.extend(parts);
            }
            other => flat.push(other),
        }
        joints.push(end);
    }
    (flat, joints)
}

pub(super) fn write(segments: &[CurveForm], parameters: &[f64], w: &mut Writer) -> Result<()> {
    w.packed_version(1, 0);
    w.count(segments.len(), "segments")?;
    w.i32(0);
    w.i32(0);
    w.empty_box();
    w.doubles(parameters)?;
    segments.iter().try_for_each(|segment| super::write_object(segment, w))
}
