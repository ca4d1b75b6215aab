//! The wrapping of a class object (section 6): identifier, body, user data, end.

mod user_data;

pub use user_data::UserData;

use uuid::Uuid;

use crate::chunk::{Reader, Writer};
use crate::version::Version;
use crate::{Error, Result, typecode};

/// A class object found in an archive, its body not read yet.
#[derive(Debug)]
pub(crate) struct ClassObject<'a> {
    pub(crate) class: Uuid,
    /// The body; a null object has none.
    pub(crate) data: Option<Reader<'a>>,
    pub(crate) user_data: Vec<UserData>,
    pub(crate) offset: usize,
    pub(crate) version: Version,
    pub(crate) bytes: &'a [u8],
}

impl<'a> ClassObject<'a> {
    /// Reads the class chunk that comes next.
    pub(crate) fn read(reader: &mut Reader<'a>) -> Result<Self> {
        const WHAT: &str = "class object";
        let offset = reader.offset();
        let version = reader.version();
        let mut chunks = reader.expect(typecode::CLASS, WHAT)?;
        let bytes = reader.between(offset, reader.offset());
        let mut id = chunks.expect(typecode::CLASS_UUID, "class identifier")?;
        let class = id.uuid("class identifier")?;
        id.finish();
        let mut object = Self { class, data: None, user_data: Vec::new(), offset, version, bytes };
        while !chunks.is_at_end() {
            let context = chunks.context();
            let chunk = chunks.chunk()?;
            match chunk.typecode {
                typecode::CLASS_DATA if object.data.is_none() => object.data = Some(chunk.body),
                typecode::CLASS_USER_DATA => {
                    let at = chunk.offset;
                    match UserData::read(chunk.body) {
                        Ok(data) => object.user_data.push(data),
                        Err(error) => context.left_out(at, "user data", error),
                    }
                }
                typecode::CLASS_END => break,
                _ => {}
            }
        }
        if object.data.is_none() && !class.is_nil() {
            return Err(Error::malformed(offset, WHAT, "it has no body"));
        }
        Ok(object)
    }
}

/// Writes a class object whose body `body` writes.
pub(crate) fn write_class(
    w: &mut Writer,
    class: Uuid,
    user_data: &[UserData],
    body: impl FnOnce(&mut Writer) -> Result<()>,
) -> Result<()> {
    w.chunk(typecode::CLASS, |w| {
        w.chunk(typecode::CLASS_UUID, |w| {
            w.uuid(class);
            Ok(())
        })?;
        w.chunk(typecode::CLASS_DATA, body)?;
        for data in user_data {
            data.write(w)?;
        }
        w.short(typecode::CLASS_END, 0);
        Ok(())
    })
}

/// Writes the object that is none.
pub(crate) fn write_null(w: &mut Writer) -> Result<()> {
    w.chunk(typecode::CLASS, |w| {
        w.chunk(typecode::CLASS_UUID, |w| {
            w.uuid(Uuid::nil());
            Ok(())
        })
    })
}
