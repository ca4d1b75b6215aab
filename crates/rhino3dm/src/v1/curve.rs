//! Curves of version 1: splines end to end.

use super::spline::{find, read_spline, read_toolkit_curve, substance};
use super::typecode as code;
use crate::chunk::Reader;
use crate::{CurveForm, Error, Result};

const WHAT: &str = "curve of version 1";

/// Reads the substance of a curve chunk.
pub(super) fn read_substance(body: &mut Reader<'_>) -> Result<CurveForm> {
    let offset = body.offset();
    let dimension = body.u8(WHAT)?;
    if !matches!(dimension, 2 | 3) {
        return Err(Error::malformed(offset, WHAT, format!("dimension {dimension} is not 2 or 3")));
    }
    // Whether it is closed.
    body.u8(WHAT)?;
    let count = body.u16(WHAT)?;
    if !(1..=0x7FFF).contains(&count) {
        return Err(Error::malformed(offset, WHAT, format!("{count} is no count of segments")));
    }
    body.take(16 * usize::from(dimension), WHAT)?;
    Ok(chained((0..count).map(|_| read_spline(body)).collect::<Result<_>>()?))
}

/// Reads the curve chunk that comes next.
pub(super) fn read(chunks: &mut Reader<'_>) -> Result<CurveForm> {
    let mut chunk = find(chunks, code::CURVE, WHAT)?;
    let mut body = substance(&mut chunk, code::CURVE, WHAT)?;
    let curve = read_substance(&mut body)?;
    body.finish();
    Ok(curve)
}

/// Several splines end to end, as breps of the toolkit have them.
pub(super) fn read_toolkit(body: &mut Reader<'_>) -> Result<CurveForm> {
    let offset = body.offset();
    let count = body.count(8, WHAT)?;
    if count == 0 {
        return Err(Error::malformed(offset, WHAT, "it has no segments"));
    }
    let read = |_| read_toolkit_curve(&mut body.expect(code::TOOLKIT_CURVE, WHAT)?);
    Ok(chained((0..count).map(read).collect::<Result<_>>()?))
}

/// Segments end to end; a single one is a curve by itself.
fn chained(mut segments: Vec<CurveForm>) -> CurveForm {
    match segments.pop() {
        Some(only) if segments.is_empty() => only,
        last => {
            segments.extend(last);
            let parameters = joints(&segments);
            CurveForm::Poly { segments, parameters }
        }
    }
}

/// The parameters where segments meet: each keeps the length of its domain.
fn joints(segments: &[CurveForm]) -> Vec<f64> {
    let mut joints: Vec<f64> = Vec::with_capacity(segments.len() + 1);
    for segment in segments {
        let domain = segment.domain();
        match joints.last().copied() {
            None => joints.extend([domain.start, domain.end]),
            #[allow(clippy::float_cmp, reason = "a domain that continues exactly is kept as it is")]
            Some(last) if last == domain.start => joints.push(domain.end),
            Some(last) => joints.push(last + (domain.end - domain.start)),
        }
    }
    joints
}
