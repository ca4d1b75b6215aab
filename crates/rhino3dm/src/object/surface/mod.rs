//! The surface classes (section 8).

mod nurbs;
mod plane;
mod revolution;
mod sum;

use katydid_geometry::Surface;
use uuid::Uuid;

use super::{curve, is_frame, major_1};
use crate::chunk::{Reader, Writer};
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

/// Reads the body of a surface class.
pub(super) fn read(class: Uuid, body: &mut Reader<'_>) -> Result<Surface> {
    match class {
        class_ids::PLANE_SURFACE => plane::read(body).map(Surface::Plane),
        class_ids::SUM_SURFACE => sum::read(body).map(Surface::Sum),
        class_ids::REVOLUTION_SURFACE => revolution::read(body).map(Surface::Revolution),
        class_ids::NURBS_SURFACE => nurbs::read(body).map(Surface::Nurbs),
        _ => {
            Err(Error::malformed(body.offset(), "surface", format!("class {class} is no surface read here")))
        }
    }
}

/// Writes the body of a surface class.
pub(super) fn write(surface: &Surface, w: &mut Writer) -> Result<()> {
    match surface {
        Surface::Plane(s) => plane::write(s, w),
        Surface::Sum(s) => sum::write(s, w),
        Surface::Revolution(s) => revolution::write(s, w),
        Surface::Nurbs(s) => nurbs::write(s, w),
    }
}
