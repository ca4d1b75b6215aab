//! Class NurbsCurve. Rational control points are stored homogeneous, (wx, wy, wz, w).

use katydid_geometry::{Error as Refusal, Interval, NurbsCurve, Point3};

use super::major_1;
use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

const WHAT: &str = "NURBS curve";

/// A NURBS curve with all that archives say of it.
#[derive(Debug, Clone, PartialEq)]
pub struct NurbsForm {
    /// The number of coordinates of a control point, the weight not counted.
    pub dimension: i32,
    /// Whether control points carry a weight; they are stored times their weight then, and the weight last.
    pub rational: bool,
    /// The degree + 1.
    pub order: i32,
    /// The knots: as many as control points + order − 2.
    pub knots: Vec<f64>,
    /// The coordinates of the control points, one after another.
    pub numbers: Vec<f64>,
    /// Whether a SubD can be made of it without change.
    pub subd_friendly: bool,
}

impl NurbsForm {
    /// Numbers a control point.
    fn width(&self) -> usize {
        width(self.dimension, self.rational).unwrap_or(1)
    }

    fn point_count(&self) -> usize {
        self.numbers.len() / self.width()
    }

    pub(super) fn of(curve: &NurbsCurve, dimension: i32) -> Self {
        let kept = usize::try_from(dimension).unwrap_or(3).min(3);
        let rational = curve.is_rational();
        let mut numbers = Vec::with_capacity(curve.point_count() * (kept + usize::from(rational)));
        for i in 0..curve.point_count() {
            let point = curve.homogeneous_point(i).unwrap_or_default();
            numbers.extend(point.iter().take(kept));
            numbers.extend(point.last().filter(|_| rational));
        }
        Self {
            dimension,
            rational,
            order: i32::try_from(curve.order()).unwrap_or(i32::MAX),
            knots: curve.knots().to_vec(),
            numbers,
            subd_friendly: false,
        }
    }

    pub(super) fn to_curve(&self) -> katydid_geometry::Result<NurbsCurve> {
        let invalid = |why: String| Refusal::Invalid { what: WHAT, why };
        let dimension = match self.dimension {
            1..=3 => self.dimension.unsigned_abs() as usize,
            other => return Err(invalid(format!("dimension {other} is not 1, 2 or 3"))),
        };
        let Some(degree) = usize::try_from(self.order).ok().and_then(|order| order.checked_sub(1)) else {
            return Err(invalid(format!("order {} is not at least 1", self.order)));
        };
        let coordinates = |point: &[f64]| {
            // Missing coordinates of plane curves are 0.
            let at = |i: usize| if i < dimension { point.get(i).copied().unwrap_or(0.0) } else { 0.0 };
            [at(0), at(1), at(2)]
        };
        let points = self.numbers.chunks_exact(self.width());
        if self.rational {
            let points = points.map(|point| {
                let [x, y, z] = coordinates(point);
                [x, y, z, point.last().copied().unwrap_or(1.0)]
            });
            NurbsCurve::rational(degree, points.collect(), self.knots.clone())
        } else {
            let points = points.map(|point| Point3::from(coordinates(point)));
            NurbsCurve::new(degree, points.collect(), self.knots.clone())
        }
    }

    pub(super) fn domain(&self) -> Interval {
        let at = |i: Option<usize>| i.and_then(|i| self.knots.get(i)).copied().unwrap_or_default();
        let before = usize::try_from(self.order).ok().and_then(|order| order.checked_sub(2));
        Interval::new(at(before), at(before.and_then(|n| self.knots.len().checked_sub(n + 1))))
    }
}

/// Numbers a control point, when that is a sensible number.
fn width(dimension: i32, rational: bool) -> Option<usize> {
    let dimension = usize::try_from(dimension).ok().filter(|n| *n > 0)?;
    dimension.checked_add(usize::from(rational))
}

pub(super) fn read(body: &mut Reader<'_>) -> Result<NurbsForm> {
    let offset = body.offset();
    let malformed = |why: String| Error::malformed(offset, WHAT, why);
    let minor = major_1(body, WHAT)?;
    let dimension = body.i32(WHAT)?;
    let rational = body.i32(WHAT)? != 0;
    let order = body.i32(WHAT)?;
    let stated = body.i32(WHAT)?;
    // Two reserved numbers and a box.
    body.take(8 + 48, WHAT)?;
    let Some(width) = width(dimension, rational) else {
        return Err(malformed(format!("{dimension} is no dimension")));
    };
    let knots = body.doubles("knots")?;
    let count = body.count(width.saturating_mul(8), "control points")?;
    if usize::try_from(stated).ok() != Some(count) {
        return Err(malformed(format!("{stated} control points are stated, but {count} follow")));
    }
    let numbers = body.doubles_of(count.saturating_mul(width), "control points")?;
    let subd_friendly = minor >= 1 && !body.is_at_end() && body.bool(WHAT)?;
    Ok(NurbsForm { dimension, rational, order, knots, numbers, subd_friendly })
}

pub(super) fn write(form: &NurbsForm, w: &mut Writer) -> Result<()> {
    let newer = w.version().archive >= 60;
    w.packed_version(1, u8::from(newer));
    w.i32(form.dimension);
    w.i32(i32::from(form.rational));
    w.i32(form.order);
    w.count(form.point_count(), "control points")?;
    w.i32(0);
    w.i32(0);
    w.empty_box();
    w.doubles(&form.knots)?;
    w.count(form.point_count(), "control points")?;
    form.numbers.iter().for_each(|x| w.f64(*x));
    if newer {
        w.bool(form.subd_friendly);
    }
    Ok(())
}
