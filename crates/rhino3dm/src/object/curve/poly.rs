//! Class PolyCurve: class objects end to end.

use super::{CurveForm, major_1, read_object};
use crate::Result;
use crate::chunk::{Reader, Writer};

const WHAT: &str = "polycurve";
/// Files written before this openNURBS version nest polycurves where later ones hold the segments in a row.
const NESTED_BEFORE: u32 = 200_304_080;
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
    if body.version().opennurbs < NESTED_BEFORE && parameters.len() == segments.len() + 1 {
        (segments, parameters) = flattened(segments, &parameters);
    }
    Ok(CurveForm::Poly { segments, parameters })
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
