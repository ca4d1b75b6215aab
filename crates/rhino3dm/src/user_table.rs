//! User tables (section 5): what plug-ins store beside the model.

use std::borrow::Cow;

use uuid::{Uuid, uuid};

use crate::chunk::{Chunk, Context, Reader, Writer};
use crate::recode::recode;
use crate::version::Version;
use crate::{Error, Result, typecode};

/// What one plug-in stores beside the model, as it was.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UserTable {
    /// The plug-in.
    pub plug_in: Uuid,
    /// Whether the plug-in was absent when the archive was last written.
    pub carried: bool,
    /// The archive version whose rules the body follows.
    pub archive_version: i32,
    /// The openNURBS version that wrote it.
    pub opennurbs_version: u32,
    /// The body, verbatim.
    pub body: Vec<u8>,
}

const WHAT: &str = "user table";
/// The table of the document's user strings. Readers take it apart as part of the archive around it, whatever
/// version the table states; bodies of plug-ins they read by the version that is stated.
const DOCUMENT_STRINGS: Uuid = uuid!("06F3218E-F5EC-4F6C-B74C-14583F0ED7BC");

impl UserTable {
    /// Reads the table.
    pub(crate) fn read(mut table: Reader<'_>) -> Result<Self> {
        let version = table.version();
        let offset = table.offset();
        let mut header = table.expect(typecode::USER_TABLE_HEADER, WHAT)?;
        let mut found = Self {
            plug_in: header.uuid(WHAT)?,
            carried: false,
            archive_version: version.archive,
            opennurbs_version: version.opennurbs,
            body: Vec::new(),
        };
        if !header.is_at_end() {
            let record = header.expect(typecode::USER_TABLE_VERSION, WHAT)?;
            found.read_version(record)?;
        }
        header.finish();
        while !table.is_at_end() {
            let Chunk { typecode, whole, .. } = table.chunk()?;
            match typecode {
                typecode::USER_TABLE_BODY => {
                    found.body = whole.to_vec();
                    return Ok(found);
                }
                typecode::END_OF_TABLE => break,
                _ => {}
            }
        }
        Err(Error::malformed(offset, WHAT, "it has no body"))
    }

    fn read_version(&mut self, mut record: Reader<'_>) -> Result<()> {
        record.i32(WHAT)?;
        record.i32(WHAT)?;
        self.carried = record.bool(WHAT)?;
        self.archive_version = record.i32(WHAT)?;
        self.opennurbs_version = record.u32(WHAT)?;
        record.finish();
        Ok(())
    }

    /// The body for an archive of the given version, and the version it follows; nothing when it cannot be had.
    pub(crate) fn body_for(&self, version: Version) -> Option<(Cow<'_, [u8]>, Version)> {
        let own = self.version();
        if self.plug_in != DOCUMENT_STRINGS || own.is_wide() == version.is_wide() {
            return Some((Cow::Borrowed(&self.body), own));
        }
        let body = recode(typecode::USER_TABLE_BODY, &self.body, own, version)?;
        Some((Cow::Owned(body), version))
    }

    /// Writes the table if it can stand in the archive; the body of a plug-in keeps its own version.
    pub(crate) fn write(&self, w: &mut Writer) -> Result<()> {
        let Some((body, own)) = self.body_for(w.version()) else { return Ok(()) };
        w.chunk(typecode::USER_TABLE, |w| {
            w.chunk(typecode::USER_TABLE_HEADER, |w| {
                w.uuid(self.plug_in);
                w.chunk(typecode::USER_TABLE_VERSION, |w| {
                    w.i32(1);
                    w.i32(0);
                    w.bool(self.carried || own != w.version());
                    w.i32(own.archive);
                    w.u32(own.opennurbs);
                    Ok(())
                })
            })?;
            w.foreign_chunk(typecode::USER_TABLE_BODY, &body)?;
            w.short(typecode::END_OF_TABLE, 0);
            Ok(())
        })
    }

    /// A reader of the body under the rules of its version.
    pub(crate) fn reader<'a>(&'a self, context: &'a Context) -> Reader<'a> {
        Reader::new(&self.body, self.version(), context)
    }

    fn version(&self) -> Version {
        Version { archive: self.archive_version, opennurbs: self.opennurbs_version }
    }
}
