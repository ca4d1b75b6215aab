//! Class NurbsSurface. Control points run fastest in v; rational ones are stored homogeneous, (wx, wy, wz, w).

use katydid_geometry::{Direction, Error as Refusal, NurbsSurface, Point3};

use super::major_1;
use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

const WHAT: &str = "NURBS surface";

/// A NURBS surface with all that archives say of it.
#[derive(Debug, Clone, PartialEq)]
pub struct NurbsSurfaceForm {
    /// The number of coordinates of a control point, the weight not counted.
    pub dimension: i32,
    /// Whether control points carry a weight; they are stored times their weight then, and the weight last.
    pub rational: bool,
    /// The degrees + 1 in u and v.
    pub orders: [i32; 2],
    /// The numbers of control points in u and v.
    pub counts: [i32; 2],
    /// The knots in u and v: as many as control points + order − 2.
    pub knots: [Vec<f64>; 2],
    /// The coordinates of the control points, one after another, v running fastest.
    pub numbers: Vec<f64>,
}

impl NurbsSurfaceForm {
    pub(super) fn of(surface: &NurbsSurface) -> Self {
        let count = |n: usize| i32::try_from(n).unwrap_or(i32::MAX);
        let numbers = if surface.is_rational() {
            surface.homogeneous_points().into_iter().flatten().collect()
        } else {
            surface.control_points().iter().flat_map(|p| [p.x, p.y, p.z]).collect()
        };
        Self {
            dimension: 3,
            rational: surface.is_rational(),
            orders: Direction::BOTH.map(|d| count(surface.order(d))),
            counts: Direction::BOTH.map(|d| count(surface.count(d))),
            knots: Direction::BOTH.map(|d| surface.knots(d).to_vec()),
            numbers,
        }
    }

    pub(super) fn to_surface(&self) -> katydid_geometry::Result<NurbsSurface> {
        let invalid = |why: String| Refusal::Invalid { what: WHAT, why };
        let dimension = match self.dimension {
            1..=3 => self.dimension.unsigned_abs() as usize,
            other => return Err(invalid(format!("dimension {other} is not 1, 2 or 3"))),
        };
        let degree = |order: i32| {
            let degree = usize::try_from(order).ok().and_then(|order| order.checked_sub(1));
            degree.ok_or_else(|| invalid(format!("order {order} is not at least 1")))
        };
        let degrees = [degree(self.orders[0])?, degree(self.orders[1])?];
        let counts = self.counts.map(|n| usize::try_from(n).unwrap_or(0));
        let points = self.numbers.chunks_exact(dimension + usize::from(self.rational));
        let coordinates = |point: &[f64]| {
            // Missing coordinates are 0.
            let at = |i: usize| if i < dimension { point.get(i).copied().unwrap_or(0.0) } else { 0.0 };
            [at(0), at(1), at(2)]
        };
        if self.rational {
            let points = points.map(|point| {
                let [x, y, z] = coordinates(point);
                [x, y, z, point.last().copied().unwrap_or(1.0)]
            });
            NurbsSurface::rational(degrees, counts, points.collect(), self.knots.clone())
        } else {
            let points = points.map(|point| Point3::from(coordinates(point)));
            NurbsSurface::new(degrees, counts, points.collect(), self.knots.clone())
        }
    }
}

pub(super) fn read(body: &mut Reader<'_>) -> Result<NurbsSurfaceForm> {
    let offset = body.offset();
    let malformed = |why: String| Error::malformed(offset, WHAT, why);
    major_1(body, WHAT)?;
    let dimension = body.i32(WHAT)?;
    let rational = body.i32(WHAT)? != 0;
    let orders = [body.i32(WHAT)?, body.i32(WHAT)?];
    let counts = [body.i32(WHAT)?, body.i32(WHAT)?];
    // Two reserved numbers and a box.
    body.take(8 + 48, WHAT)?;
    let Some(width) = usize::try_from(dimension).ok().filter(|n| *n > 0) else {
        return Err(malformed(format!("{dimension} is no dimension")));
    };
    let width = width.saturating_add(usize::from(rational));
    let knots = [body.doubles("knots in u")?, body.doubles("knots in v")?];
    let count = body.count(width.saturating_mul(8), "control points")?;
    let [m, n] = counts.map(|n| usize::try_from(n).unwrap_or(0));
    if m.checked_mul(n) != Some(count) {
        let [m, n] = counts;
        return Err(malformed(format!("{m} by {n} control points are stated, but {count} follow")));
    }
    let numbers = body.doubles_of(count.saturating_mul(width), "control points")?;
    Ok(NurbsSurfaceForm { dimension, rational, orders, counts, knots, numbers })
}

pub(super) fn write(form: &NurbsSurfaceForm, w: &mut Writer) -> Result<()> {
    w.packed_version(1, 0);
    w.i32(form.dimension);
    w.i32(i32::from(form.rational));
    form.orders.iter().for_each(|n| w.i32(*n));
    form.counts.iter().for_each(|n| w.i32(*n));
    w.i32(0);
    w.i32(0);
    w.empty_box();
    form.knots.iter().try_for_each(|knots| w.doubles(knots))?;
    let [m, n] = form.counts.map(|n| usize::try_from(n).unwrap_or(0));
    w.count(m.saturating_mul(n), "control points")?;
    form.numbers.iter().for_each(|x| w.f64(*x));
    Ok(())
}
