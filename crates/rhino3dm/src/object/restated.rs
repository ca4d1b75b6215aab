//! Objects in the form that archives of another version have of them.

use std::borrow::Cow;

use super::{Object, annotation, extrusion, subd};
use crate::Result;
use crate::class_object::UserData;
use crate::styles::Styles;
use crate::version::Version;

/// The first version with annotations of today.
const ANNOTATIONS: i32 = 60;

/// What annotations of before version 60 take from around them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Surroundings<'a> {
    /// The styles of the model.
    pub(crate) styles: &'a Styles,
    /// Whether the object lies in the model, not on a page.
    pub(crate) in_model: bool,
}

/// An object and its user data as an archive of the given version has them.
type Restated<'a> = (Cow<'a, Object>, Cow<'a, [UserData]>);

/// The object and its user data as an archive of the given version has them.
pub(crate) fn restated<'a>(
    object: &'a Object,
    user_data: &'a [UserData],
    around: Surroundings<'_>,
    version: Version,
) -> Result<Restated<'a>> {
    let other = restate(object, user_data, around, version)?;
    if other.is_none() && matches!(object, Object::Annotation(_) | Object::Extrusion(_) | Object::SubD(_)) {
        object.check_writable(version.archive)?;
    }
    Ok(other.map_or((Cow::Borrowed(object), Cow::Borrowed(user_data)), |(object, user_data)| {
        (Cow::Owned(object), Cow::Owned(user_data))
    }))
}

/// The other form, when the version has another.
fn restate(
    object: &Object,
    user_data: &[UserData],
    around: Surroundings<'_>,
    version: Version,
) -> Result<Option<(Object, Vec<UserData>)>> {
    let archive = version.archive;
    Ok(match object {
        Object::SubD(subd) => subd::mesh_of(subd, version)?.map(|(mesh, data)| {
            let all = user_data.iter().cloned().chain([data]);
            (Object::Mesh(Box::new(mesh)), all.collect())
        }),
        Object::Extrusion(extrusion) if archive < extrusion::FIRST => {
            extrusion.to_brep().map(|brep| (Object::Brep(Box::new(brep)), user_data.to_vec()))
        }
        Object::Annotation(newer) if archive < ANNOTATIONS => {
            annotation::to_older(newer, around.styles, around.in_model, version)?.map(
                |(older, mut extras)| {
                    extras.extend(user_data.iter().cloned());
                    (Object::Annotation5(Box::new(older)), extras)
                },
            )
        }
        _ => None,
    })
}
