//! The surface classes (section 8).

mod form;
mod nurbs;
mod plane;
mod revolution;
mod sum;

pub use form::SurfaceForm;
pub use nurbs::NurbsSurfaceForm;

use katydid_geometry::Surface;
use uuid::Uuid;

use super::{curve, major_1};
use crate::chunk::{Reader, Writer};
use crate::class_object::{ClassObject, UserData, write_class};
use crate::{Error, Result, class_ids};

/// Whether a class, by its own identifier, is a surface that the kernel has.
pub(super) fn is_surface(class: Uuid) -> bool {
    matches!(
        class,
        class_ids::PLANE_SURFACE
            | class_ids::SUM_SURFACE
            | class_ids::REVOLUTION_SURFACE
            | class_ids::NURBS_SURFACE
    )
}

/// The class under which a surface is written.
pub(super) fn class_of(surface: &Surface) -> Uuid {
    match surface {
        Surface::Plane(_) => class_ids::PLANE_SURFACE,
        Surface::Sum(_) => class_ids::SUM_SURFACE,
        Surface::Revolution(_) => class_ids::REVOLUTION_SURFACE,
        Surface::Nurbs(_) => class_ids::NURBS_SURFACE,
    }
}

/// The class under which a form is written.
pub(super) fn class_of_form(form: &SurfaceForm) -> Uuid {
    match form {
        SurfaceForm::Plane { .. } => class_ids::PLANE_SURFACE,
        SurfaceForm::Sum { .. } => class_ids::SUM_SURFACE,
        SurfaceForm::Revolution { .. } => class_ids::REVOLUTION_SURFACE,
        SurfaceForm::Nurbs(_) => class_ids::NURBS_SURFACE,
        SurfaceForm::Tagged { surface, .. } => class_of_form(surface),
    }
}

/// Reads the body of a surface class.
pub(super) fn read(class: Uuid, body: &mut Reader<'_>) -> Result<SurfaceForm> {
    match class {
        class_ids::PLANE_SURFACE => plane::read(body),
        class_ids::SUM_SURFACE => sum::read(body),
        class_ids::REVOLUTION_SURFACE => revolution::read(body),
        class_ids::NURBS_SURFACE => read_nurbs(body),
        _ => {
            Err(Error::malformed(body.offset(), "surface", format!("class {class} is no surface read here")))
        }
    }
}

/// Reads the body of a NURBS surface without its class object, as version 2 breps hold them.
pub(super) fn read_nurbs(body: &mut Reader<'_>) -> Result<SurfaceForm> {
    nurbs::read(body).map(SurfaceForm::Nurbs)
}

/// Reads a whole class object that must be a surface.
pub(super) fn read_object(reader: &mut Reader<'_>) -> Result<SurfaceForm> {
    form_of_object(ClassObject::read(reader)?)
}

/// Takes apart a class object that must be a surface.
pub(super) fn form_of_object(object: ClassObject<'_>) -> Result<SurfaceForm> {
    let class = class_ids::canonical(object.class);
    match object.data {
        Some(mut body) if is_surface(class) => {
            let form = read(class, &mut body)?;
            body.finish();
            if object.user_data.is_empty() {
                return Ok(form);
            }
            Ok(SurfaceForm::Tagged { surface: Box::new(form), user_data: object.user_data })
        }
        _ => {
            let name = class_ids::name(class).map_or_else(|| class.to_string(), str::to_owned);
            Err(Error::malformed(object.offset, "surface", format!("class {name} is no surface read here")))
        }
    }
}

/// Writes the body of a surface class.
pub(super) fn write(form: &SurfaceForm, w: &mut Writer) -> Result<()> {
    match form {
        SurfaceForm::Plane { plane, offset, domains, extents } => {
            plane::write(plane, *offset, *domains, *extents, w);
            Ok(())
        }
        SurfaceForm::Sum { .. } => sum::write(form, w),
        SurfaceForm::Revolution { .. } => revolution::write(form, w),
        SurfaceForm::Nurbs(form) => nurbs::write(form, w),
        SurfaceForm::Tagged { surface, .. } => write(surface, w),
    }
}

/// Writes a whole class object.
pub(super) fn write_object(form: &SurfaceForm, w: &mut Writer) -> Result<()> {
    let user_data: &[UserData] =
        if let SurfaceForm::Tagged { user_data, .. } = form { user_data } else { &[] };
    write_class(w, class_of_form(form), user_data, |w| write(form, w))
}
