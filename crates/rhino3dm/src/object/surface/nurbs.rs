//! Class NurbsSurface. Control points run fastest in v; rational ones are stored homogeneous, (wx, wy, wz, w).

use katydid_geometry::{Direction, NurbsSurface, Point3};

use super::major_1;
use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

const WHAT: &str = "NURBS surface";

pub(super) fn read(body: &mut Reader<'_>) -> Result<NurbsSurface> {
    let offset = body.offset();
    let malformed = |why: String| Error::malformed(offset, WHAT, why);
    major_1(body, WHAT)?;
    let dimension = body.i32(WHAT)?;
    let rational = body.i32(WHAT)? != 0;
    let orders = [body.i32(WHAT)?, body.i32(WHAT)?];
    let stated = [body.i32(WHAT)?, body.i32(WHAT)?];
    // Two reserved numbers and a box.
    body.take(8 + 48, WHAT)?;
    let dimension = match dimension {
        1..=3 => dimension.unsigned_abs() as usize,
        other => return Err(malformed(format!("dimension {other} is not 1, 2 or 3"))),
    };
    let degree = |order: i32| {
        let degree = usize::try_from(order).ok().and_then(|order| order.checked_sub(1));
        degree.ok_or_else(|| malformed(format!("order {order} is not at least 1")))
    };
    let degrees = [degree(orders[0])?, degree(orders[1])?];
    let knots = [body.doubles("knots in u")?, body.doubles("knots in v")?];
    let width = dimension + usize::from(rational);
    let count = body.count(width * 8, "control points")?;
    let counts = stated.map(|n| usize::try_from(n).unwrap_or(0));
    if counts[0].checked_mul(counts[1]) != Some(count) {
        let [m, n] = stated;
        return Err(malformed(format!("{m} by {n} control points are stated, but {count} follow")));
    }
    let numbers = body.doubles_of(count * width, "control points")?;
    let coordinates = |point: &[f64]| {
        // Missing coordinates are 0.
        let at = |i: usize| if i < dimension { point.get(i).copied().unwrap_or(0.0) } else { 0.0 };
        [at(0), at(1), at(2)]
    };
    let surface = if rational {
        let points = numbers.chunks_exact(width).map(|point| {
            let [x, y, z] = coordinates(point);
            [x, y, z, point.last().copied().unwrap_or(1.0)]
        });
        NurbsSurface::rational(degrees, counts, points.collect(), knots)
    } else {
        let points = numbers.chunks_exact(width).map(|point| Point3::from(coordinates(point)));
        NurbsSurface::new(degrees, counts, points.collect(), knots)
    };
    surface.map_err(|e| Error::geometry(offset, WHAT, e))
}

pub(super) fn write(surface: &NurbsSurface, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 0);
    w.i32(3);
    w.i32(i32::from(surface.is_rational()));
    for d in Direction::BOTH {
        w.count(surface.order(d), "orders")?;
    }
    for d in Direction::BOTH {
        w.count(surface.count(d), "control points")?;
    }
    w.i32(0);
    w.i32(0);
    w.empty_box();
    for d in Direction::BOTH {
        w.doubles(surface.knots(d))?;
    }
    w.count(surface.point_count(), "control points")?;
    if surface.is_rational() {
        surface.homogeneous_points().iter().flatten().for_each(|x| w.f64(*x));
    } else {
        surface.control_points().iter().for_each(|p| w.point(*p));
    }
    Ok(())
}
