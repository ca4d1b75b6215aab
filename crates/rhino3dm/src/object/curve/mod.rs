//! The curve classes (section 8).

mod arc;
mod line;
mod nurbs;
mod poly;
mod polyline;

use katydid_geometry::{Curve, Interval};
use uuid::Uuid;

use super::major_1;
use crate::chunk::{Reader, Writer};
use crate::{Error, Result, class_ids};

/// Whether a class, by its own identifier, is a curve that the kernel has.
pub(super) fn is_curve(class: Uuid) -> bool {
    matches!(
        class,
        class_ids::LINE_CURVE
            | class_ids::ARC_CURVE
            | class_ids::POLYLINE_CURVE
            | class_ids::POLY_CURVE
            | class_ids::NURBS_CURVE
    )
}

/// The class under which a curve is written.
pub(super) fn class_of(curve: &Curve) -> Uuid {
    match curve {
        Curve::Line(_) => class_ids::LINE_CURVE,
        Curve::Arc(_) => class_ids::ARC_CURVE,
        Curve::Polyline(_) => class_ids::POLYLINE_CURVE,
        Curve::Poly(_) => class_ids::POLY_CURVE,
        Curve::Nurbs(_) => class_ids::NURBS_CURVE,
    }
}

/// Reads the body of a curve class.
pub(super) fn read(class: Uuid, body: &mut Reader<'_>) -> Result<Curve> {
    match class {
        class_ids::LINE_CURVE => line::read(body).map(Curve::Line),
        class_ids::ARC_CURVE => arc::read(body).map(Curve::Arc),
        class_ids::POLYLINE_CURVE => polyline::read(body).map(Curve::Polyline),
        class_ids::POLY_CURVE => poly::read(body).map(Curve::Poly),
        class_ids::NURBS_CURVE => nurbs::read(body).map(Curve::Nurbs),
        _ => Err(Error::malformed(body.offset(), "curve", format!("class {class} is no curve read here"))),
    }
}

/// Reads an arrow of version 2: its tail and its tip. The official reader makes a line of it, too.
pub(super) fn read_arrow(body: &mut Reader<'_>) -> Result<Curve> {
    const WHAT: &str = "arrow";
    let offset = body.offset();
    major_1(body, WHAT)?;
    let line = body.line(WHAT)?;
    if !(line.from.is_finite() && line.to.is_finite()) {
        return Err(Error::geometry(offset, WHAT, katydid_geometry::Error::NotFinite("end of the arrow")));
    }
    Ok(Curve::from(line))
}

/// Reads a whole class object that must be a curve.
pub(super) fn read_object(reader: &mut Reader<'_>) -> Result<Curve> {
    let object = super::ClassObject::read(reader)?;
    let class = class_ids::canonical(object.class);
    match object.data {
        Some(mut body) if is_curve(class) => {
            let curve = read(class, &mut body)?;
            body.finish();
            Ok(curve)
        }
        _ => {
            let name = class_ids::name(class).map_or_else(|| class.to_string(), str::to_owned);
            Err(Error::malformed(object.offset, "curve", format!("class {name} is no curve read here")))
        }
    }
}

/// Writes the body of a curve class.
pub(super) fn write(curve: &Curve, w: &mut Writer) -> Result<()> {
    match curve {
        Curve::Line(c) => line::write(c, w),
        Curve::Arc(c) => arc::write(c, w),
        Curve::Polyline(c) => polyline::write(c, w),
        Curve::Poly(c) => poly::write(c, w),
        Curve::Nurbs(c) => nurbs::write(c, w),
    }
}

/// Writes a whole class object.
pub(super) fn write_object(curve: &Curve, w: &mut Writer) -> Result<()> {
    super::write_class(w, class_of(curve), &[], |w| write(curve, w))
}

/// A domain must be finite and increase.
fn check_domain(domain: Interval, offset: usize, what: &'static str) -> Result<()> {
    if !(domain.start.is_finite() && domain.end.is_finite()) {
        return Err(Error::geometry(offset, what, katydid_geometry::Error::NotFinite("domain")));
    }
    if domain.start >= domain.end {
        return Err(Error::malformed(
            offset,
            what,
            format!("its domain {}…{} does not increase", domain.start, domain.end),
        ));
    }
    Ok(())
}
