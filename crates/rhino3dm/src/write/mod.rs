//! Writing an archive (section 10): header, comment, every table a reader asks for, end mark.

mod records;
mod tables;

use std::io::Write;

use crate::chunk::Writer;
use crate::model::Model;
use crate::read::SIGNATURE;
use crate::version::Version;
use crate::{Error, Result, typecode};

impl Model {
    /// The archive of version 4, 50, 60, 70 or 80 as bytes. The same model gives the same bytes: objects and
    /// entries of tables without an identifier, or with one that another has already, get one made from their
    /// place and content. Kept records that the version cannot carry are left out; [`Model::losses`] names them.
    ///
    /// # Errors
    /// Another version, an object on a layer that is not there, a kept object whose bytes do not fit the version,
    /// or more data than the format can count.
    pub fn write(&self, version: i32) -> Result<Vec<u8>> {
        let mut w = Writer::new(Version::for_writing(version)?);
        w.bytes(SIGNATURE);
        w.bytes(format!("{version:>8}").as_bytes());
        w.chunk(typecode::COMMENT, |w| {
            w.bytes(b" Written by Katydid.\x1A\0");
            Ok(())
        })?;
        self.write_tables(&mut w)?;
        let wide = w.version().is_wide();
        // The end mark counts itself.
        let length = w.len() + if wide { 12 + 8 } else { 8 + 4 };
        w.chunk(typecode::END_OF_FILE, |w| {
            if wide {
                w.bytes(&(length as u64).to_le_bytes());
            } else {
                let short = u32::try_from(length).map_err(|_| Error::CannotWrite {
                    what: format!("an archive of {length} bytes"),
                    version,
                    why: "archives of this version end at 4 GiB".into(),
                })?;
                w.u32(short);
            }
            Ok(())
        })?;
        Ok(w.into_bytes())
    }

    /// [`Model::write`] into any destination.
    ///
    /// # Errors
    /// As [`Model::write`], and when the destination fails.
    pub fn write_to(&self, version: i32, destination: &mut impl Write) -> Result<()> {
        destination.write_all(&self.write(version)?)?;
        Ok(())
    }
}
