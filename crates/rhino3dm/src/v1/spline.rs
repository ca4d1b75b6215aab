//! NURBS curves and surfaces of version 1.

use katydid_geometry::{Interval, Line, Point3};

use super::typecode as code;
use crate::chunk::Reader;
use crate::{CurveForm, Error, NurbsForm, NurbsSurfaceForm, Result};

const CURVE: &str = "NURBS curve of version 1";
const SURFACE: &str = "NURBS surface of version 1";

/// How rational control points are stored: whether coordinates are multiplied by the weight already.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Weights {
    None,
    Apart,
    Multiplied,
}

impl Weights {
    fn from_code(code: u8) -> Option<Self> {
        Some(match code {
            0 => Self::None,
            1 => Self::Apart,
            2 => Self::Multiplied,
            _ => return None,
        })
    }
}

/// Multiplies the coordinates of each control point by its weight, which stands behind them.
fn multiply_weights(points: &mut [f64], dimension: usize) {
    for point in points.chunks_exact_mut(dimension + 1) {
        if let Some((weight, coordinates)) = point.split_last_mut() {
            coordinates.iter_mut().for_each(|x| *x *= *weight);
        }
    }
}

/// The dimension of curves and surfaces, 2 or 3.
fn dimension(body: &mut Reader<'_>, what: &'static str) -> Result<usize> {
    let offset = body.offset();
    match body.u8(what)? {
        dimension @ (2 | 3) => Ok(usize::from(dimension)),
        other => Err(Error::malformed(offset, what, format!("dimension {other} is not 2 or 3"))),
    }
}

/// A small number as archives have it.
fn int(number: usize) -> i32 {
    i32::try_from(number).unwrap_or(i32::MAX)
}

/// Reads the spline chunk that comes next; its substance is a chunk in it. A spline that is a line is read as one.
pub(super) fn read_spline(segments: &mut Reader<'_>) -> Result<CurveForm> {
    let mut chunk = segments.expect(code::SPLINE, CURVE)?;
    let mut body = substance(&mut chunk, code::SPLINE, CURVE)?;
    let spline = read_curve_substance(&mut body)?;
    body.finish();
    Ok(as_line(&spline).unwrap_or(CurveForm::Nurbs(spline)))
}

fn read_curve_substance(body: &mut Reader<'_>) -> Result<NurbsForm> {
    let offset = body.offset();
    let malformed = |why: String| Error::malformed(offset, CURVE, why);
    let dimension = dimension(body, CURVE)?;
    let weights = body.u8(CURVE)?;
    let Some(weights) = Weights::from_code(weights) else {
        return Err(malformed(format!("{weights} is no kind of weights")));
    };
    let order = usize::from(body.u8(CURVE)?);
    let count = usize::from(body.u16(CURVE)?);
    if !(2..=127).contains(&order) || count < order {
        return Err(malformed(format!("order {order} does not go with {count} control points")));
    }
    // Whether it is closed, its form, and its box.
    body.take(2 + 16 * dimension, CURVE)?;
    let mut knots = read_knots(body, order, count)?;
    let rational = weights != Weights::None;
    let mut numbers = body.doubles_of(count * (dimension + usize::from(rational)), "control points")?;
    // Both kinds of weights are stored apart in curves, whatever their mark says.
    if rational {
        multiply_weights(&mut numbers, dimension);
    }
    // Some lines run backwards in their knots.
    if let [start, end] = knots.as_mut_slice()
        && *start > *end
    {
        (*start, *end) = (-*start, -*end);
    }
    Ok(NurbsForm {
        dimension: int(dimension),
        rational,
        order: int(order),
        knots,
        numbers,
        subd_friendly: false,
    })
}

/// A spline of two control points as a line.
fn as_line(spline: &NurbsForm) -> Option<CurveForm> {
    let [start, end] = *spline.knots.as_slice() else { return None };
    if spline.order != 2 || spline.rational {
        return None;
    }
    let point = |numbers: &[f64]| {
        let at = |i: usize| numbers.get(i).copied().unwrap_or(0.0);
        Point3::new(at(0), at(1), at(2))
    };
    let (from, to) = spline.numbers.split_at_checked(spline.numbers.len() / 2)?;
    let (line, domain) = (Line::new(point(from), point(to)), Interval::new(start, end));
    Some(CurveForm::Line { line, domain, dimension: spline.dimension })
}

/// The knots of a curve; those that are equal at a clamped end are stored once.
fn read_knots(body: &mut Reader<'_>, order: usize, count: usize) -> Result<Vec<f64>> {
    const WHAT: &str = "knots";
    let total = order + count - 2;
    let clamped = if order > 2 { body.u8(WHAT)? } else { 0 };
    body.check_count(count + 1 - order, 8, WHAT)?;
    let mut knots = vec![body.f64(WHAT)?];
    if clamped % 2 == 1 {
        let first = knots.first().copied().unwrap_or_default();
        knots.resize(order - 1, first);
    }
    while knots.len() < count {
        knots.push(body.f64(WHAT)?);
    }
    if clamped >= 2 {
        let last = knots.last().copied().unwrap_or_default();
        knots.resize(total, last);
    }
    while knots.len() < total {
        knots.push(body.f64(WHAT)?);
    }
    Ok(knots)
}

/// The chunk of a kind's substance: whatever stands before it is passed over.
pub(super) fn substance<'a>(chunk: &mut Reader<'a>, kind: u32, what: &'static str) -> Result<Reader<'a>> {
    find(chunk, kind | code::SUBSTANCE, what)
}

/// The next chunk of a typecode; whatever stands before it is passed over.
pub(super) fn find<'a>(chunks: &mut Reader<'a>, typecode: u32, what: &'static str) -> Result<Reader<'a>> {
    let offset = chunks.offset();
    while chunks.left() >= 8 {
        let chunk = chunks.chunk()?;
        if chunk.typecode == typecode {
            return Ok(chunk.body);
        }
    }
    Err(Error::malformed(offset, what, format!("a chunk {typecode:08X} is missing")))
}

/// Reads the substance of a surface.
pub(super) fn read_surface_substance(body: &mut Reader<'_>) -> Result<NurbsSurfaceForm> {
    let offset = body.offset();
    let malformed = |why: String| Error::malformed(offset, SURFACE, why);
    let dimension = dimension(body, SURFACE)?;
    // Its form.
    body.u8(SURFACE)?;
    let degrees = [usize::from(body.u8(SURFACE)?), usize::from(body.u8(SURFACE)?)];
    let spans = [usize::from(body.u16(SURFACE)?), usize::from(body.u16(SURFACE)?)];
    if !degrees.iter().all(|degree| (1..127).contains(degree)) || spans.contains(&0) {
        return Err(malformed(format!("degrees {degrees:?} do not go with spans {spans:?}")));
    }
    let kinds = [body.u8(SURFACE)?, body.u8(SURFACE)?].map(Weights::from_code);
    // The second direction decides where the two differ.
    let weights = kinds.into_iter().flatten().rfind(|kind| *kind != Weights::None);
    // Whether it is closed or singular, and its box.
    body.take(4 + 16 * dimension, SURFACE)?;
    let ([degree_u, degree_v], [spans_u, spans_v]) = (degrees, spans);
    let counts = [degree_u + spans_u, degree_v + spans_v];
    read_surface_numbers(body, dimension, weights, degrees.map(|degree| degree + 1), counts)
}

fn read_surface_numbers(
    body: &mut Reader<'_>,
    dimension: usize,
    weights: Option<Weights>,
    orders: [usize; 2],
    counts: [usize; 2],
) -> Result<NurbsSurfaceForm> {
    let ([order_u, order_v], [count_u, count_v]) = (orders, counts);
    let knots = [
        body.doubles_of((order_u - 2).saturating_add(count_u), "knots")?,
        body.doubles_of((order_v - 2).saturating_add(count_v), "knots")?,
    ];
    let width = dimension + usize::from(weights.is_some());
    let total = count_u.saturating_mul(count_v).saturating_mul(width);
    let mut numbers = body.doubles_of(total, "control points")?;
    if weights == Some(Weights::Apart) {
        multiply_weights(&mut numbers, dimension);
    }
    let (orders, counts) = (orders.map(int), counts.map(int));
    Ok(NurbsSurfaceForm {
        dimension: int(dimension),
        rational: weights.is_some(),
        orders,
        counts,
        knots,
        numbers,
    })
}

/// The toolkit's mark of a layout, with a bit that says nothing.
pub(super) fn toolkit_version(body: &mut Reader<'_>, what: &'static str) -> Result<()> {
    let offset = body.offset();
    match body.i32(what)? & !0x100 {
        100 | 101 => Ok(()),
        other => Err(Error::malformed(offset, what, format!("layout {other} is not known"))),
    }
}

/// A number of the toolkit that is at least `least`.
fn at_least(body: &mut Reader<'_>, least: usize, what: &'static str) -> Result<usize> {
    let offset = body.offset();
    let number = body.i32(what)?;
    usize::try_from(number)
        .ok()
        .filter(|number| *number >= least)
        .ok_or_else(|| Error::malformed(offset, what, format!("{number} is not at least {least}")))
}

/// Whether control points of the toolkit are rational; they are homogeneous then.
fn toolkit_rational(body: &mut Reader<'_>, what: &'static str) -> Result<bool> {
    let offset = body.offset();
    match body.i32(what)? {
        0 => Ok(false),
        1 => Ok(true),
        other => Err(Error::malformed(offset, what, format!("{other} is neither rational nor not"))),
    }
}

/// Reads the data of a curve of the toolkit.
pub(super) fn read_toolkit_curve(chunks: &mut Reader<'_>) -> Result<CurveForm> {
    let mut body = chunks.expect(code::TOOLKIT_DATA, CURVE)?;
    toolkit_version(&mut body, CURVE)?;
    let dimension = at_least(&mut body, 1, CURVE)?;
    let rational = toolkit_rational(&mut body, CURVE)?;
    let order = at_least(&mut body, 2, CURVE)?;
    let count = at_least(&mut body, order, CURVE)?;
    body.i32(CURVE)?;
    let knots = body.doubles_of((order - 2).saturating_add(count), "knots")?;
    let width = dimension.saturating_add(usize::from(rational));
    let numbers = body.doubles_of(count.saturating_mul(width), "control points")?;
    let (dimension, order) = (int(dimension), int(order));
    Ok(CurveForm::Nurbs(NurbsForm { dimension, rational, order, knots, numbers, subd_friendly: false }))
}

/// Reads the data of a surface of the toolkit.
pub(super) fn read_toolkit_surface(chunks: &mut Reader<'_>) -> Result<NurbsSurfaceForm> {
    let mut body = chunks.expect(code::TOOLKIT_DATA, SURFACE)?;
    toolkit_version(&mut body, SURFACE)?;
    let dimension = at_least(&mut body, 1, SURFACE)?;
    let rational = toolkit_rational(&mut body, SURFACE)?;
    let orders = [at_least(&mut body, 2, SURFACE)?, at_least(&mut body, 2, SURFACE)?];
    let [order_u, order_v] = orders;
    let counts = [at_least(&mut body, order_u, SURFACE)?, at_least(&mut body, order_v, SURFACE)?];
    body.i32(SURFACE)?;
    body.check_count(dimension, 8, "control points")?;
    read_surface_numbers(&mut body, dimension, rational.then_some(Weights::Multiplied), orders, counts)
}
