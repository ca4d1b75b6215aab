//! Whether an object is valid, and why not.

use katydid_3dm::{Limits, Object};

pub(super) enum Validity {
    Valid,
    Invalid(String),
    Unknown,
}

/// Curves, surfaces and point clouds that the kernel does not take are kept as bytes, so those it took are valid.
pub(super) fn validity(object: &Object) -> Validity {
    match object {
        Object::Mesh(mesh) => match mesh.to_mesh().and_then(|mesh| mesh.check()) {
            Ok(()) => Validity::Valid,
            Err(error) => Validity::Invalid(error.to_string()),
        },
        Object::Kept(raw) => match raw.parse(&Limits::default()) {
            Ok(_) => Validity::Unknown,
            Err(error) => Validity::Invalid(error.to_string()),
        },
        Object::Brep(object) => match object.brep.faults().as_slice() {
            [] if object.odd_curves_3d.is_empty() && object.odd_surfaces.is_empty() => Validity::Valid,
            [] => Validity::Invalid("it has curves or surfaces that make no sense".into()),
            [fault] => Validity::Invalid(fault.to_string()),
            [fault, others @ ..] => Validity::Invalid(format!("{fault}; and {} more", others.len())),
        },
        Object::CurveForm(form) => match form.to_curve() {
            Ok(_) => Validity::Valid,
            Err(error) => Validity::Invalid(error.to_string()),
        },
        Object::SurfaceForm(form) => match form.to_surface() {
            Ok(_) => Validity::Valid,
            Err(error) => Validity::Invalid(error.to_string()),
        },
        Object::Point(p) if !p.is_finite() => Validity::Invalid("a coordinate is not a finite number".into()),
        Object::Point(_) | Object::PointCloud(_) | Object::Curve(_) | Object::Surface(_) => Validity::Valid,
        _ => Validity::Unknown,
    }
}
