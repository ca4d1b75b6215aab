//! Curves of version 1: splines end to end.

use super::spline::{Spline, substance};
use super::typecode as code;
use crate::chunk::{Reader, Writer};
use crate::{Error, Result, class_ids, object};

const WHAT: &str = "curve of version 1";

/// A curve; it has at least one segment.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Curve {
    segments: Vec<Spline>,
}

impl From<Spline> for Curve {
    fn from(spline: Spline) -> Self {
        Self { segments: vec![spline] }
    }
}

impl Curve {
    /// Reads the substance of a curve chunk.
    pub(super) fn read_substance(body: &mut Reader<'_>) -> Result<Self> {
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
        let segments = (0..count).map(|_| Spline::read(body)).collect::<Result<_>>()?;
        Ok(Self { segments })
    }

    #[allow(dead_code, reason = "breps, which are read next, hold such curves")]
    /// Reads the curve chunk that comes next, whatever stands before it or around it.
    pub(super) fn read(chunks: &mut Reader<'_>) -> Result<Self> {
        let mut chunk = super::spline::find(chunks, code::CURVE, WHAT)?;
        let mut body = substance(&mut chunk, code::CURVE, WHAT)?;
        let curve = Self::read_substance(&mut body)?;
        body.finish();
        Ok(curve)
    }

    #[allow(dead_code, reason = "breps, which are read next, hold such curves")]
    /// Several splines end to end, as the toolkit has them.
    pub(super) fn read_toolkit(body: &mut Reader<'_>) -> Result<Self> {
        let offset = body.offset();
        let count = body.count(8, WHAT)?;
        if count == 0 {
            return Err(Error::malformed(offset, WHAT, "it has no segments"));
        }
        let mut segments = Vec::with_capacity(count);
        for _ in 0..count {
            let mut chunk = body.expect(code::TOOLKIT_CURVE, WHAT)?;
            segments.push(Spline::read_toolkit(&mut chunk)?);
        }
        Ok(Self { segments })
    }

    /// The class of the curve and its body, written by [`Curve::write`].
    pub(super) fn class(&self) -> uuid::Uuid {
        match self.segments.as_slice() {
            [segment] => class_of(segment),
            _ => class_ids::POLY_CURVE,
        }
    }

    /// Writes the body of the class.
    pub(super) fn write(&self, w: &mut Writer) -> Result<()> {
        if let [segment] = self.segments.as_slice() {
            return write_segment(segment, w);
        }
        w.packed_version(1, 0);
        w.count(self.segments.len(), "segments")?;
        w.i32(0);
        w.i32(0);
        w.empty_box();
        w.doubles(&self.joints())?;
        for segment in &self.segments {
            object::write_class(w, class_of(segment), &[], |w| write_segment(segment, w))?;
        }
        Ok(())
    }

    /// The parameters where segments meet: each keeps the length of its domain.
    fn joints(&self) -> Vec<f64> {
        let mut joints: Vec<f64> = Vec::with_capacity(self.segments.len() + 1);
        for segment in &self.segments {
            let [start, end] = segment.domain();
            match joints.last().copied() {
                None => joints.extend([start, end]),
                #[allow(clippy::float_cmp, reason = "a domain that continues exactly is kept as it is")]
                Some(last) if last == start => joints.push(end),
                Some(last) => joints.push(last + (end - start)),
            }
        }
        joints
    }
}

fn class_of(segment: &Spline) -> uuid::Uuid {
    if segment.is_line() { class_ids::LINE_CURVE } else { class_ids::NURBS_CURVE }
}

fn write_segment(segment: &Spline, w: &mut Writer) -> Result<()> {
    if !segment.is_line() {
        return segment.write(w);
    }
    w.packed_version(1, 0);
    for end in segment.points.chunks_exact(segment.dimension) {
        for i in 0..3 {
            w.f64(end.get(i).copied().unwrap_or(0.0));
        }
    }
    segment.domain().iter().for_each(|t| w.f64(*t));
    w.count(segment.dimension, "dimensions")
}
