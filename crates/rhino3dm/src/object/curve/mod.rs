//! The curve classes (section 8).

mod arc;
mod form;
mod line;
mod nurbs;
mod on_surface;
mod poly;
mod polyline;

pub use form::CurveForm;
pub use nurbs::NurbsForm;
pub use on_surface::CurveOnSurface;

use katydid_geometry::Curve;
use uuid::Uuid;

use super::major_1;
use crate::chunk::{Reader, Writer};
use crate::class_object::{ClassObject, UserData, write_class};
use crate::{Error, Result, class_ids};

/// The dimension of curves in space.
pub(super) const SPACE: i32 = 3;
/// The dimension of curves in a parameter plane.
pub(super) const FLAT: i32 = 2;

/// Whether a class, by its own identifier, is a curve.
pub(super) fn is_curve(class: Uuid) -> bool {
    matches!(
        class,
        class_ids::LINE_CURVE
            | class_ids::ARC_CURVE
            | class_ids::POLYLINE_CURVE
            | class_ids::POLY_CURVE
            | class_ids::NURBS_CURVE
            | class_ids::CURVE_ON_SURFACE
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

/// The class under which a form is written.
pub(super) fn class_of_form(form: &CurveForm) -> Uuid {
    match form {
        CurveForm::Line { .. } => class_ids::LINE_CURVE,
        CurveForm::Arc { .. } => class_ids::ARC_CURVE,
        CurveForm::Polyline { .. } => class_ids::POLYLINE_CURVE,
        CurveForm::Poly { .. } => class_ids::POLY_CURVE,
        CurveForm::Nurbs(_) => class_ids::NURBS_CURVE,
        CurveForm::OnSurface(_) => class_ids::CURVE_ON_SURFACE,
        CurveForm::Tagged { curve, .. } => class_of_form(curve),
    }
}

/// Reads the body of a curve class.
pub(super) fn read(class: Uuid, body: &mut Reader<'_>) -> Result<CurveForm> {
    match class {
        class_ids::LINE_CURVE => line::read(body),
        class_ids::ARC_CURVE => arc::read(body),
        class_ids::POLYLINE_CURVE => polyline::read(body),
        class_ids::POLY_CURVE => poly::read(body),
        class_ids::NURBS_CURVE => nurbs::read(body).map(CurveForm::Nurbs),
        class_ids::CURVE_ON_SURFACE => on_surface::read(body).map(Box::new).map(CurveForm::OnSurface),
        _ => Err(Error::malformed(body.offset(), "curve", format!("class {class} is no curve read here"))),
    }
}

/// Reads the body of a polycurve without its class object, as version 2 breps hold them.
pub(super) fn read_poly(body: &mut Reader<'_>) -> Result<CurveForm> {
    poly::read(body)
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
pub(super) fn read_object(reader: &mut Reader<'_>) -> Result<CurveForm> {
    form_of_object(ClassObject::read(reader)?)
}

/// Takes apart a class object that must be a curve.
pub(super) fn form_of_object(object: ClassObject<'_>) -> Result<CurveForm> {
    let class = class_ids::canonical(object.class);
    match object.data {
        Some(mut body) if is_curve(class) => {
            let form = read(class, &mut body)?;
            body.finish();
            if object.user_data.is_empty() {
                return Ok(form);
            }
            Ok(CurveForm::Tagged { curve: Box::new(form), user_data: object.user_data })
        }
        _ => {
            let name = class_ids::name(class).map_or_else(|| class.to_string(), str::to_owned);
            Err(Error::malformed(object.offset, "curve", format!("class {name} is no curve read here")))
        }
    }
}

/// Writes the body of a curve class.
pub(super) fn write(form: &CurveForm, w: &mut Writer) -> Result<()> {
    match form {
        CurveForm::Line { line, domain, dimension } => line::write(line, *domain, *dimension, w),
        CurveForm::Arc { arc, offset, domain, dimension } => {
            arc::write(arc, *offset, *domain, *dimension, w);
        }
        CurveForm::Polyline { points, parameters, dimension } => {
            return polyline::write(points, parameters, *dimension, w);
        }
        CurveForm::Nurbs(form) => return nurbs::write(form, w),
        CurveForm::Poly { segments, parameters } => return poly::write(segments, parameters, w),
        CurveForm::OnSurface(curve) => return on_surface::write(curve, w),
        CurveForm::Tagged { curve, .. } => return write(curve, w),
    }
    Ok(())
}

/// Writes a whole class object.
pub(super) fn write_object(form: &CurveForm, w: &mut Writer) -> Result<()> {
    let user_data: &[UserData] = if let CurveForm::Tagged { user_data, .. } = form { user_data } else { &[] };
    write_class(w, class_of_form(form), user_data, |w| write(form, w))
}
