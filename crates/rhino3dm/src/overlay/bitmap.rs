//! Images and other files inside an archive (section 5): their paths, and what they hold when somebody asks.

use uuid::{Uuid, uuid};

use crate::chunk::{Context, Reader};
use crate::class_object::ClassObject;
use crate::tables::KeptRecord;
use crate::{Error, Limits, Preview, Result, UserTable};

/// A file or an image inside an archive.
#[derive(Debug, Clone, PartialEq)]
pub struct EmbeddedFile<'a> {
    /// The identifier; nil when there is none.
    pub id: Uuid,
    /// The name; empty when there is none.
    pub name: String,
    /// The path of the file it was made from; empty for an image that was made in memory.
    pub path: String,
    /// In which form it is stored.
    pub form: EmbeddedForm,
    place: Place<'a>,
}

/// Where a file stands.
#[derive(Debug, Clone, PartialEq)]
enum Place<'a> {
    /// In the table of bitmaps.
    Record(&'a KeptRecord),
    /// In the table of the rendering program, from a byte of its body on.
    Table(&'a UserTable, usize),
}

/// In which form a file is stored in an archive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum EmbeddedForm {
    /// Any file, byte for byte (version 8 and later).
    File,
    /// An image file, byte for byte.
    ImageFile,
    /// The pixels of a Windows bitmap.
    Pixels,
}

const WHAT: &str = "embedded file";
/// The table of the rendering program, and the version from which on files stand in it.
pub(crate) const RENDERING: Uuid = uuid!("16592D58-4A2F-401D-BF5E-3B87741C1B1B");
const RENDERING_WITH_FILES: i32 = 4;
/// The size that the header of a Windows bitmap begins with.
const HEADER_SIZE: u32 = 40;
const FILE: Uuid = uuid!("E3BBE02E-F3D5-490D-9719-E21D8BF982EF");
const IMAGE_FILE: Uuid = uuid!("772E6FC1-B17B-4FC4-8F54-5FDA511D76D2");
const BITMAP: Uuid = uuid!("390465EB-3721-11D4-800B-0010830122F0");
const NAMED_BITMAP: Uuid = uuid!("203AFC17-BCC9-44FB-A07B-7F5C31BD5ED9");

impl<'a> EmbeddedFile<'a> {
    pub(crate) fn of(record: &'a KeptRecord) -> Result<Option<Self>> {
        record.with_body(|body| {
            let object = ClassObject::read(body)?;
            let Some(mut body) = object.data else { return Ok(None) };
            let mut file = Self {
                id: Uuid::nil(),
                name: String::new(),
                path: String::new(),
                form: EmbeddedForm::Pixels,
                place: Place::Record(record),
            };
            match object.class {
                FILE => {
                    file.form = EmbeddedForm::File;
                    file.path = body.string(WHAT)?;
                }
                IMAGE_FILE => {
                    file.form = EmbeddedForm::ImageFile;
                    let minor = file.read_header(&mut body)?;
                    // A check sum, and how the bytes are stored.
                    body.take(8, WHAT)?;
                    body.compressed_buffer(WHAT)?;
                    // Identifier and name came with minor version 1.
                    if minor >= 1 {
                        file.id = body.uuid(WHAT)?;
                        file.name = body.string(WHAT)?;
                    }
                }
                BITMAP => {}
                NAMED_BITMAP => {
                    file.read_header(&mut body)?;
                }
                _ => return Ok(None),
            }
            Ok(Some(file))
        })
    }

    /// The files behind the description of the rendering program's settings.
    pub(crate) fn add_of_rendering(table: &'a UserTable, files: &mut Vec<Self>) -> Result<()> {
        let context = Context::new(&Limits::default());
        let mut body = table.reader(&context);
        if body.i32(WHAT)? < RENDERING_WITH_FILES {
            return Ok(());
        }
        let description = body.count(1, WHAT)?;
        body.take(description, WHAT)?;
        // A path and a size at least.
        for _ in 0..body.count(8, WHAT)? {
            let place = Place::Table(table, body.offset());
            let path = body.string(WHAT)?;
            body.compressed_buffer(WHAT)?;
            files.push(Self { id: Uuid::nil(), name: String::new(), path, form: EmbeddedForm::File, place });
        }
        Ok(())
    }

    /// The version and the path.
    fn read_header(&mut self, body: &mut Reader<'_>) -> Result<u8> {
        let offset = body.offset();
        let (major, minor) = body.packed_version(WHAT)?;
        if major != 1 {
            return Err(Error::malformed(offset, WHAT, format!("major version {major} is not known")));
        }
        self.path = body.string(WHAT)?;
        Ok(minor)
    }

    /// What the file holds, inflated now; nothing for pixels, which [`EmbeddedFile::pixels`] gives.
    ///
    /// # Errors
    /// The bytes are broken, or inflate to more than the limits allow.
    pub fn content(&self, limits: &Limits) -> Result<Option<Vec<u8>>> {
        if self.form == EmbeddedForm::Pixels {
            return Ok(None);
        }
        self.with_content(limits, |body| {
            if self.form == EmbeddedForm::ImageFile {
                body.packed_version(WHAT)?;
                body.string(WHAT)?;
                body.take(8, WHAT)?;
            } else {
                body.string(WHAT)?;
            }
            let buffer = body.compressed_buffer(WHAT)?;
            let mut bytes = vec![0; buffer.size()];
            buffer.inflate_into(body.context(), &mut bytes)?;
            Ok(Some(bytes))
        })
    }

    /// The picture, when it is stored as pixels.
    ///
    /// # Errors
    /// The bytes are broken, or inflate to more than the limits allow.
    pub fn pixels(&self, limits: &Limits) -> Result<Option<Preview>> {
        if self.form != EmbeddedForm::Pixels {
            return Ok(None);
        }
        self.with_content(limits, |body| {
            // What has a path begins with its version and that path; the header of a bitmap with its size, 40.
            if body.peek_typecode() != Some(HEADER_SIZE) {
                body.packed_version(WHAT)?;
                body.string(WHAT)?;
            }
            Preview::read(body).map(Some)
        })
    }

    fn with_content<T>(&self, limits: &Limits, read: impl FnOnce(&mut Reader<'_>) -> Result<T>) -> Result<T> {
        let context = Context::new(limits);
        let record = match self.place {
            Place::Record(record) => record,
            Place::Table(table, offset) => {
                let mut body = table.reader(&context);
                body.go_to(offset);
                return read(&mut body);
            }
        };
        record.with_body_in(&context, |body| {
            let offset = body.offset();
            let object = ClassObject::read(body)?;
            let mut body = object.data.ok_or_else(|| Error::malformed(offset, WHAT, "it has no body"))?;
            read(&mut body)
        })
    }
}
