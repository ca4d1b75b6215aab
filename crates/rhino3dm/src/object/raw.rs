//! A class object as bytes, for the classes that are not taken apart.

use uuid::Uuid;

use super::Object;
use crate::chunk::{Context, Reader, Writer};
use crate::class_object::{ClassObject, UserData};
use crate::version::Version;
use crate::{Error, Limits, Result, Warning, class_ids};

/// One class object, whole and verbatim.
#[derive(Debug, Clone, PartialEq)]
pub struct RawObject {
    /// The class as the bytes name it, which may be an older name of it.
    pub class: Uuid,
    /// The archive version whose rules the bytes follow: 4-byte chunk lengths before 50, 8-byte ones from 50 on.
    pub archive_version: i32,
    /// The openNURBS version that wrote them.
    pub opennurbs_version: u32,
    /// The class chunk from its typecode to its last byte.
    pub bytes: Vec<u8>,
    /// The user data in those bytes.
    pub user_data: Vec<UserData>,
}

impl ClassObject<'_> {
    /// The object with its bytes, to be kept.
    pub(crate) fn to_raw(&self) -> RawObject {
        RawObject {
            class: self.class,
            archive_version: self.version.archive,
            opennurbs_version: self.version.opennurbs,
            bytes: self.bytes.to_vec(),
            user_data: self.user_data.clone(),
        }
    }
}

impl RawObject {
    /// Reads the wrapping of one class object that `data` begins with, written under the given versions.
    ///
    /// # Errors
    /// The bytes hold no class object, or one that passes a limit.
    pub fn read(
        archive_version: i32,
        opennurbs_version: u32,
        data: &[u8],
        limits: &Limits,
    ) -> Result<(Self, Vec<Warning>)> {
        let context = Context::new(limits);
        let raw = {
            let version = object_version(archive_version, opennurbs_version)?;
            ClassObject::read(&mut Reader::new(data, version, &context))?.to_raw()
        };
        Ok((raw, context.into_warnings()))
    }

    /// The name of the class, or its identifier when that is not known.
    pub fn class_name(&self) -> String {
        if self.class.is_nil() {
            return "null object".into();
        }
        class_ids::name(self.class).map_or_else(|| self.class.to_string(), str::to_owned)
    }

    /// Takes the object apart: the same as when it was read. Bytes that the kernel refused are refused again.
    ///
    /// # Errors
    /// The bytes are broken, or the kernel refuses what they hold.
    pub fn parse(&self, limits: &Limits) -> Result<Object> {
        let context = Context::new(limits);
        self.with_class(&context, |object| Object::from_class(&object))
    }

    /// Takes the object apart without the meshes that programs keep beside a brep: they take most of the time, and who
    /// computes with the shape has no use for them.
    ///
    /// # Errors
    /// As for [`RawObject::parse`].
    pub fn parse_shape(&self, limits: &Limits) -> Result<Object> {
        let context = Context::of_shape(limits);
        self.with_class(&context, |object| Object::from_class(&object))
    }

    /// Runs `read` over the class object.
    pub(crate) fn with_class<T>(
        &self,
        context: &Context,
        read: impl FnOnce(ClassObject<'_>) -> Result<T>,
    ) -> Result<T> {
        let version = object_version(self.archive_version, self.opennurbs_version)?;
        read(ClassObject::read(&mut Reader::new(&self.bytes, version, context))?)
    }

    /// Whether the bytes may stand in an archive of the given version as they are, and if not why.
    fn fits(&self, archive: i32) -> std::result::Result<(), &'static str> {
        let (own, wide) = (self.archive_version, |version: i32| version >= 50);
        if wide(own) != wide(archive) {
            return Err("its chunk lengths are of another width");
        }
        if !wide(own) && own != archive {
            return Err("its layout belongs to another version");
        }
        if own >= 60 && archive < 60 {
            return Err("its layout is newer than version 50");
        }
        let class = class_ids::canonical(self.class);
        if class == class_ids::SUBD && (own >= 70) != (archive >= 70) {
            return Err("SubD layouts differ before and from version 70");
        }
        Ok(())
    }

    /// The object taken apart, for an archive whose rules its bytes do not follow.
    fn refitted(&self, archive: i32, why: &str) -> Result<Object> {
        let refused = |why: String| Error::CannotWrite {
            what: format!("a {} kept from a version {} archive", self.class_name(), self.archive_version),
            version: archive,
            why,
        };
        match self.parse(&Limits::default()) {
            Ok(Object::Kept(_)) => Err(refused(why.into())),
            Ok(object) => Ok(object),
            Err(error) => Err(refused(format!("{why}, and it cannot be taken apart: {error}"))),
        }
    }

    /// Whether an archive of the given version can carry the object: as it is, or taken apart.
    pub(crate) fn check_writable(&self, archive: i32) -> Result<()> {
        match self.fits(archive) {
            Ok(()) => Ok(()),
            Err(why) => self.refitted(archive, why)?.check_writable(archive),
        }
    }

    /// The bytes as they are, where they follow the rules of the archive; else what they say.
    pub(crate) fn write(&self, w: &mut Writer) -> Result<()> {
        match self.fits(w.version().archive) {
            Ok(()) => {
                w.chunks(&self.bytes);
                Ok(())
            }
            Err(why) => {
                let object = self.refitted(w.version().archive, why)?;
                let kept: Vec<UserData> =
                    self.user_data.iter().filter(|data| !object.holds(data)).cloned().collect();
                object.write(w, &kept)
            }
        }
    }
}

/// The version of an object outside an archive.
pub(crate) fn object_version(archive: i32, opennurbs: u32) -> Result<Version> {
    match archive {
        2..=5 | 50 | 60 | 70 | 80 => Ok(Version { archive, opennurbs }),
        newer if newer > 80 && newer % 10 == 0 => Ok(Version { archive, opennurbs }),
        other => Err(Error::UnsupportedVersion(other)),
    }
}
