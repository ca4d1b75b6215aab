//! Statistics of the curvatures at the vertices of a mesh.

use katydid_geometry::Interval;

use crate::chunk::{Reader, Writer};
use crate::{Error, Result, typecode};

const WHAT: &str = "curvature statistics";

/// How the curvatures of one kind are spread over a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct CurvatureStatistics {
    /// Which curvature: 1 Gaussian, 2 mean, 3 the least radius, 4 the greatest radius.
    pub style: i32,
    /// The value from which on a curvature counts as infinite.
    pub infinity: f64,
    /// How many values are infinite.
    pub infinite_count: i32,
    /// How many values are finite.
    pub finite_count: i32,
    /// The most frequent value.
    pub mode: f64,
    /// The average of the finite values.
    pub average: f64,
    /// The average deviation from it.
    pub deviation: f64,
    /// The least and the greatest finite value.
    pub range: Interval,
}

/// Reads the anonymous chunk that holds the body.
pub(super) fn read(body: &mut Reader<'_>) -> Result<CurvatureStatistics> {
    let mut body = body.expect(typecode::ANONYMOUS, WHAT)?;
    let offset = body.offset();
    let (major, minor) = body.packed_version(WHAT)?;
    if major != 1 {
        return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
    }
    let style = body.i32(WHAT)?;
    // The first writers left the value of infinity out.
    let infinity = if minor >= 1 { body.f64(WHAT)? } else { 0.0 };
    let statistics = CurvatureStatistics {
        style,
        infinity,
        infinite_count: body.i32(WHAT)?,
        finite_count: body.i32(WHAT)?,
        mode: body.f64(WHAT)?,
        average: body.f64(WHAT)?,
        deviation: body.f64(WHAT)?,
        range: body.interval(WHAT)?,
    };
    body.finish();
    Ok(statistics)
}

/// Writes the anonymous chunk.
pub(super) fn write(statistics: &CurvatureStatistics, w: &mut Writer) -> Result<()> {
    w.chunk(typecode::ANONYMOUS, |w| {
        w.packed_version(1, 1);
        w.i32(statistics.style);
        w.f64(statistics.infinity);
        w.i32(statistics.infinite_count);
        w.i32(statistics.finite_count);
        w.f64(statistics.mode);
        w.f64(statistics.average);
        w.f64(statistics.deviation);
        w.interval(statistics.range);
        Ok(())
    })
}
