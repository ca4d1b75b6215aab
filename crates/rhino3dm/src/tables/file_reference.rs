//! References to other files (section 8): paths and what the file held.

use uuid::Uuid;

use crate::Result;
use crate::chunk::{Reader, Writer};

/// A file by its paths, and what it held when it was last looked at.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct FileReference {
    /// The full path; empty when only the relative one is known.
    pub full_path: String,
    /// The path from the archive.
    pub relative_path: String,
    /// What the file held.
    pub content: ContentHash,
    /// Whether the file was there, by its number in archives.
    pub status: u32,
    /// The identifier of a copy in the table of bitmaps; nil when there is none.
    pub embedded: Uuid,
}

/// Size, times and hashes of a file; all zeros when it was not looked at.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ContentHash {
    /// The size in bytes.
    pub bytes: u64,
    /// When the hash was made, in seconds since 1970.
    pub hashed: u64,
    /// When the file was last changed, in seconds since 1970.
    pub changed: u64,
    /// The SHA-1 of the name.
    pub name: [u8; 20],
    /// The SHA-1 of the content.
    pub content: [u8; 20],
}

const WHAT: &str = "file reference";

fn read_hash(body: &mut Reader<'_>) -> Result<[u8; 20]> {
    let (mut chunk, _) = body.versioned_1("SHA-1")?;
    let hash = chunk.array("SHA-1")?;
    chunk.finish();
    Ok(hash)
}

fn write_hash(hash: &[u8; 20], w: &mut Writer) -> Result<()> {
    w.versioned(1, 0, |w| {
        w.bytes(hash);
        Ok(())
    })
}

impl FileReference {
    /// A file of which no more than the path is known; a path with a drive or a leading slash is a full one.
    pub fn from_path(path: &str) -> Self {
        let path = path.trim();
        let drive = path.as_bytes().get(1) == Some(&b':');
        let full = drive || path.starts_with(['/', '\\']);
        let mut reference = Self::default();
        *(if full { &mut reference.full_path } else { &mut reference.relative_path }) = path.to_owned();
        reference
    }

    /// The full path, or the relative one when there is none.
    pub fn path(&self) -> &str {
        if self.full_path.is_empty() { &self.relative_path } else { &self.full_path }
    }

    pub(crate) fn read(body: &mut Reader<'_>) -> Result<Self> {
        let (mut chunk, minor) = body.versioned_1(WHAT)?;
        let mut reference = Self {
            full_path: chunk.string("path")?,
            relative_path: chunk.string("relative path")?,
            ..Self::default()
        };
        let (mut hash, _) = chunk.versioned_1("content hash")?;
        let mut number = || hash.array("content hash").map(u64::from_le_bytes);
        let (bytes, hashed, changed) = (number()?, number()?, number()?);
        let (name, content) = (read_hash(&mut hash)?, read_hash(&mut hash)?);
        hash.finish();
        reference.content = ContentHash { bytes, hashed, changed, name, content };
        reference.status = chunk.u32(WHAT)?;
        if minor >= 1 {
            reference.embedded = chunk.uuid(WHAT)?;
        }
        chunk.finish();
        Ok(reference)
    }

    pub(crate) fn write(&self, w: &mut Writer) -> Result<()> {
        let minor = i32::from(w.version().archive >= 60);
        w.versioned(1, minor, |w| {
            w.string(&self.full_path)?;
            w.string(&self.relative_path)?;
            w.versioned(1, 0, |w| {
                for number in [self.content.bytes, self.content.hashed, self.content.changed] {
                    w.bytes(&number.to_le_bytes());
                }
                write_hash(&self.content.name, w)?;
                write_hash(&self.content.content, w)
            })?;
            w.u32(self.status);
            if minor >= 1 {
                w.uuid(self.embedded);
            }
            Ok(())
        })
    }
}
