//! Class NurbsCurve. Rational control points are stored homogeneous, (wx, wy, wz, w).

use katydid_geometry::{NurbsCurve, Point3};

use super::major_1;
use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

const WHAT: &str = "NURBS curve";

pub(super) fn read(body: &mut Reader<'_>) -> Result<NurbsCurve> {
    let offset = body.offset();
    let malformed = |why: String| Error::malformed(offset, WHAT, why);
    let minor = major_1(body, WHAT)?;
    let dimension = body.i32(WHAT)?;
    let rational = body.i32(WHAT)? != 0;
    let order = body.i32(WHAT)?;
    let stated = body.i32(WHAT)?;
    // Two reserved numbers and a box.
    body.take(8 + 48, WHAT)?;
    let dimension = match dimension {
        1..=3 => dimension.unsigned_abs() as usize,
        other => return Err(malformed(format!("dimension {other} is not 1, 2 or 3"))),
    };
    let Some(degree) = usize::try_from(order).ok().and_then(|order| order.checked_sub(1)) else {
        return Err(malformed(format!("order {order} is not at least 1")));
    };
    let knots = body.doubles("knots")?;
    let width = dimension + usize::from(rational);
    let count = body.count(width * 8, "control points")?;
    if usize::try_from(stated).ok() != Some(count) {
        return Err(malformed(format!("{stated} control points are stated, but {count} follow")));
    }
    let numbers = body.doubles_of(count * width, "control points")?;
    if minor >= 1 && !body.is_at_end() {
        body.bool(WHAT)?;
    }
    let coordinates = |point: &[f64]| {
        // Missing coordinates of plane curves are 0.
        let at = |i: usize| if i < dimension { point.get(i).copied().unwrap_or(0.0) } else { 0.0 };
        [at(0), at(1), at(2)]
    };
    let curve = if rational {
        let points = numbers.chunks_exact(width).map(|point| {
            let [x, y, z] = coordinates(point);
            [x, y, z, point.last().copied().unwrap_or(1.0)]
        });
        NurbsCurve::rational(degree, points.collect(), knots)
    } else {
        let points = numbers.chunks_exact(width).map(|point| Point3::from(coordinates(point)));
        NurbsCurve::new(degree, points.collect(), knots)
    };
    curve.map_err(|e| Error::geometry(offset, WHAT, e))
}

pub(super) fn write(curve: &NurbsCurve, w: &mut Writer) -> Result<()> {
    let newer = w.version().archive >= 60;
    w.packed_version(1, u8::from(newer));
    w.i32(3);
    w.i32(i32::from(curve.is_rational()));
    w.count(curve.order(), "orders")?;
    w.count(curve.point_count(), "control points")?;
    w.i32(0);
    w.i32(0);
    w.empty_box();
    w.doubles(curve.knots())?;
    w.count(curve.point_count(), "control points")?;
    if curve.is_rational() {
        curve.homogeneous_points().iter().flatten().for_each(|x| w.f64(*x));
    } else {
        curve.control_points().iter().for_each(|p| w.point(*p));
    }
    if newer {
        // Whether the curve came from a SubD.
        w.bool(false);
    }
    Ok(())
}
