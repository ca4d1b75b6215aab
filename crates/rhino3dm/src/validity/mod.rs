//! Whether objects are valid, by the rules of openNURBS, and what is merely unlucky about them.
//!
//! The rules are those of the `IsValid` functions of openNURBS, number by number; its names for zero and for "nearly the
//! same" are kept in [`numbers`]. A class with none of its own rules here is [`Validity::Unknown`].

mod brep;
mod curves;
mod extrusion;
mod mesh;
mod ngons;
mod numbers;
mod nurbs;
mod surfaces;

use crate::object::SPACE_DIMENSION;
use crate::{CurveForm, Limits, Object, SurfaceForm};

/// What openNURBS would say of an object.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Validity {
    /// It is valid.
    Valid,
    /// It is not, and why.
    Invalid(String),
    /// Nobody here knows the rules of its class.
    Unknown,
}

/// The first fault found, in words, or nothing.
type Verdict = Result<(), String>;

impl Object {
    /// Whether openNURBS calls the object valid.
    ///
    /// It judges shapes by their own numbers alone: a mesh with faces of no area is valid as long as no face uses one
    /// place twice, a Brep may cross itself. [`Object::remarks`] tells of such things.
    pub fn validity(&self) -> Validity {
        let verdict = match self {
            Self::Point(p) => numbers::point(*p, "the point"),
            Self::PointCloud(cloud) => match cloud.points.is_empty() {
                true => Err("it has no points".into()),
                false => Ok(()),
            },
            Self::Curve(curve) => curves::verdict(&CurveForm::of(curve, SPACE_DIMENSION)),
            Self::CurveForm(form) => curves::verdict(form),
            Self::Surface(surface) => surfaces::verdict(&SurfaceForm::of(surface)),
            Self::SurfaceForm(form) => surfaces::verdict(form),
            Self::Brep(brep) => brep::verdict(brep),
            Self::Extrusion(extrusion) => extrusion::verdict(extrusion),
            Self::Mesh(mesh) => mesh::verdict(mesh),
            Self::TextDot(dot) => numbers::point(dot.point, "its place"),
            Self::BlockReference(reference) => block(reference),
            Self::Kept(raw) => match raw.parse(&Limits::default()) {
                Ok(Self::Kept(_)) => return Validity::Unknown,
                Ok(object) => return object.validity(),
                Err(error) => Err(error.to_string()),
            },
            _ => return Validity::Unknown,
        };
        verdict.map_or_else(Validity::Invalid, |()| Validity::Valid)
    }

    /// What is unlucky about a valid object: other programs may make something else of it than was meant.
    pub fn remarks(&self) -> Vec<String> {
        match self {
            Self::Mesh(mesh) => mesh::remarks(mesh),
            _ => Vec::new(),
        }
    }
}

/// How far the product of a map and its inverse may be from the identity.
const SINGULAR: f64 = 1e-6;

/// A block stands somewhere, and its map can be turned back.
fn block(reference: &crate::BlockReference) -> Verdict {
    if reference.definition.is_nil() {
        return Err("it names no block definition".into());
    }
    let xform = &reference.transform;
    match xform.inverse() {
        Some(inverse) if (inverse * *xform).is_identity(SINGULAR) => Ok(()),
        _ => Err("its transform cannot be turned back".into()),
    }
}
