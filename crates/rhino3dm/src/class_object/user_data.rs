//! User data: what programs hang on objects and attributes (section 6).
//!
//! Its body says under which version it was written and need not be understood to be carried on.

use uuid::Uuid;

use crate::chunk::{Context, Reader, Writer};
use crate::version::Version;
use crate::{Error, Limits, Result, class_ids, typecode};

/// The archive version whose rules new user data follows; what writes an older archive gives it another form.
const NEWEST: i32 = 80;

/// One piece of user data; its body as it was.
#[derive(Debug, Clone, PartialEq)]
pub struct UserData {
    /// The class of the data.
    pub class: Uuid,
    /// Which item of that class it is; mostly the class again.
    pub item: Uuid,
    /// The application that owns it.
    pub application: Uuid,
    /// How often it was copied, as the writer counted.
    pub copy_count: i32,
    /// The transform applied to it since it was attached, row after row.
    pub transform: [f64; 16],
    /// The archive version whose rules its body follows.
    pub archive_version: i32,
    /// The openNURBS version that wrote its body.
    pub opennurbs_version: u32,
    /// The body with its closing CRC, verbatim.
    pub body: Vec<u8>,
}

const WHAT: &str = "user data";

impl UserData {
    /// Reads the body of a user data chunk.
    pub(crate) fn read(mut chunk: Reader<'_>) -> Result<Self> {
        let offset = chunk.offset();
        let file = chunk.version();
        // Without a version of its own the body has 4-byte lengths, whatever the file has.
        let fallback = if file.is_wide() { Version { archive: 5, ..file } } else { file };
        let (major, minor) = chunk.packed_version(WHAT)?;
        let (mut data, version) = match major {
            1 => (Self::header(&mut chunk)?, fallback),
            2 => {
                let mut header = chunk.expect(typecode::USER_DATA_HEADER, "user data header")?;
                let mut data = Self::header(&mut header)?;
                let mut version = fallback;
                if minor >= 1 {
                    data.application = header.uuid(WHAT)?;
                }
                if minor >= 2 {
                    header.bool(WHAT)?;
                    version = Version { archive: header.i32(WHAT)?, opennurbs: header.u32(WHAT)? };
                }
                header.finish();
                (data, version)
            }
            _ => return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known"))),
        };
        data.archive_version = version.archive;
        data.opennurbs_version = version.opennurbs;
        let body = chunk.chunk()?;
        if body.typecode != typecode::ANONYMOUS {
            return Err(Error::malformed(body.offset, WHAT, "it has no body"));
        }
        data.body = body.whole.to_vec();
        Ok(data)
    }

    fn header(reader: &mut Reader<'_>) -> Result<Self> {
        let mut data = Self {
            class: reader.uuid(WHAT)?,
            item: reader.uuid(WHAT)?,
            application: Uuid::nil(),
            copy_count: reader.i32(WHAT)?,
            transform: [0.0; 16],
            archive_version: 0,
            opennurbs_version: 0,
            body: Vec::new(),
        };
        for x in &mut data.transform {
            *x = reader.f64(WHAT)?;
        }
        Ok(data)
    }

    /// Writes the user data chunk; the body keeps its own version.
    pub(crate) fn write(&self, w: &mut Writer) -> Result<()> {
        w.chunk(typecode::CLASS_USER_DATA, |w| {
            w.packed_version(2, 2);
            w.chunk(typecode::USER_DATA_HEADER, |w| {
                w.uuid(self.class);
                w.uuid(self.item);
                w.i32(self.copy_count);
                self.transform.iter().for_each(|x| w.f64(*x));
                w.uuid(self.application);
                // Whether it is passed on by a program that does not know it, or follows other rules than the archive:
                // readers look at its version only then.
                let own = Version { archive: self.archive_version, opennurbs: self.opennurbs_version };
                w.bool(!class_ids::is_opennurbs(self.application) || own != w.version());
                w.i32(self.archive_version);
                w.u32(self.opennurbs_version);
                Ok(())
            })?;
            w.foreign_chunk(typecode::ANONYMOUS, &self.body)
        })
    }

    /// Core openNURBS data of a class, its body written by `body`.
    pub(crate) fn core(
        class: Uuid,
        copy_count: i32,
        version: Version,
        body: impl FnOnce(&mut Writer) -> Result<()>,
    ) -> Result<Self> {
        let mut w = Writer::new(version);
        w.chunk(typecode::ANONYMOUS, body)?;
        let header = if version.is_wide() { 12 } else { 8 };
        let mut identity = [0.0; 16];
        identity.iter_mut().step_by(5).for_each(|x| *x = 1.0);
        Ok(Self {
            class,
            item: class,
            application: class_ids::OPENNURBS_APPLICATION,
            copy_count,
            transform: identity,
            archive_version: version.archive,
            opennurbs_version: version.opennurbs,
            body: w.into_bytes().split_off(header),
        })
    }

    /// Runs `read` over the body, its CRC left out.
    pub(crate) fn with_body<T>(&self, read: impl FnOnce(&mut Reader<'_>) -> Result<T>) -> Result<T> {
        let version = Version { archive: self.archive_version, opennurbs: self.opennurbs_version };
        let context = Context::new(&Limits::default());
        let body = self.body.split_last_chunk::<4>().map_or(&[] as &[u8], |(body, _)| body);
        read(&mut Reader::new(body, version, &context))
    }

    /// The user strings, key and value, when this is user data of that class.
    ///
    /// # Errors
    /// The class is right but the body is broken.
    pub fn strings(&self) -> Result<Option<Vec<(String, String)>>> {
        if self.class != class_ids::USER_STRINGS {
            return Ok(None);
        }
        const WHAT: &str = "user strings";
        self.with_body(|body| {
            let (mut list, _) = body.versioned_1(WHAT)?;
            let count = list.count(8, WHAT)?;
            let mut strings = Vec::with_capacity(count);
            for _ in 0..count {
                let (mut pair, _) = list.versioned_1(WHAT)?;
                strings.push((pair.string("user string key")?, pair.string("user string value")?));
            }
            Ok(Some(strings))
        })
    }

    /// User data that holds user strings, keys first, in the newest form.
    ///
    /// # Errors
    /// There are more than 32 bits can count.
    pub fn of_user_strings(strings: &[(String, String)]) -> Result<Self> {
        Self::from_strings(strings, Version::for_writing(NEWEST)?)
    }

    /// User data that holds user strings, keys first.
    pub(crate) fn from_strings(strings: &[(String, String)], version: Version) -> Result<Self> {
        let copies = i32::try_from(strings.len()).unwrap_or(i32::MAX);
        Self::core(class_ids::USER_STRINGS, copies, version, |w| {
            w.versioned(1, 0, |w| {
                w.count(strings.len(), "user strings")?;
                for (key, value) in strings {
                    w.versioned(1, 0, |w| {
                        w.string(key)?;
                        w.string(value)
                    })?;
                }
                Ok(())
            })
        })
    }
}
