//! The form in which openNURBS objects travel outside archives: Grasshopper files, rhino3dm JSON (section 9).

use super::{Object, Surroundings, restated};
use crate::chunk::{Context, Reader, Writer};
use crate::class_object::{ClassObject, UserData};
use crate::styles::Styles;
use crate::version::Version;
use crate::{Limits, Result};

/// An object with the versions it was written under: the members `archive3dm`, `opennurbs` and `data` of the
/// JSON and .NET forms, whose fourth member `version` is always 10000.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OnData {
    /// The archive version.
    pub archive3dm: i32,
    /// The openNURBS version, as the signed number that the forms carry.
    pub opennurbs: i32,
    /// One class object.
    pub data: Vec<u8>,
}

impl Object {
    /// Reads the object of a JSON or .NET form: archive version, openNURBS version (signed, as the forms carry
    /// it) and bytes. Its user data is not given; [`RawObject::read`](super::RawObject::read) has it.
    ///
    /// # Errors
    /// The bytes are no class object, are broken, or hold numbers that the kernel refuses.
    pub fn from_on_data(archive3dm: i32, opennurbs: i32, data: &[u8]) -> Result<Self> {
        let context = Context::new(&Limits::default());
        let version = Version { archive: archive3dm, opennurbs: opennurbs.cast_unsigned() };
        super::raw::object_version(version.archive, version.opennurbs)?;
        Self::from_class(&ClassObject::read(&mut Reader::new(data, version, &context))?)
    }

    /// The object in the form that travels outside archives, for archive version 4, 50, 60, 70 or 80. A kept
    /// object keeps the version it came under, which the form states.
    ///
    /// # Errors
    /// Another version, one that cannot carry the object, or more data than the format can count.
    pub fn to_on_data(&self, archive3dm: i32) -> Result<OnData> {
        self.on_data_with(archive3dm, &[])
    }

    pub(crate) fn on_data_with(&self, archive3dm: i32, user_data: &[UserData]) -> Result<OnData> {
        if let Self::Kept(raw) = self {
            return Ok(OnData {
                archive3dm: raw.archive_version,
                opennurbs: raw.opennurbs_version.cast_signed(),
                data: raw.bytes.clone(),
            });
        }
        let version = Version::for_writing(archive3dm)?;
        let mut w = Writer::new(version);
        let around = Surroundings { styles: &Styles::default(), in_model: true };
        let (object, user_data) = restated(self, user_data, around, version)?;
        object.write(&mut w, &user_data)?;
        Ok(OnData { archive3dm, opennurbs: version.opennurbs.cast_signed(), data: w.into_bytes() })
    }
}
