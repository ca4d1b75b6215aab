//! What was edited since the last save, written down as it happens: a session that ends in the middle of a drag is
//! opened again with all of it, and with its history.
//!
//! A journal is a row of records, each with its length and a checksum; one that was cut short at the end counts as far
//! as it goes. It begins with the document as it was, so that nothing but the journal is needed to have it back.

mod difference;
#[cfg(not(target_family = "wasm"))]
mod file;
mod record;
mod replay;
mod writer;

use std::io;

pub use difference::{read_difference, write_difference};
#[cfg(not(target_family = "wasm"))]
pub use file::FileStore;
pub use replay::Found;
pub(crate) use writer::{Journal, Kept};

/// Where a journal is kept.
pub trait Store: Send {
    /// All that is there; nothing where there is no journal yet.
    ///
    /// # Errors
    /// When it cannot be read.
    fn read(&mut self) -> io::Result<Vec<u8>>;

    /// Writes more behind what is there. What was written is safe from the end of this process, not from that of the
    /// machine.
    ///
    /// # Errors
    /// When it cannot be written.
    fn append(&mut self, bytes: &[u8]) -> io::Result<()>;

    /// Puts this in the place of all that is there, whole or not at all.
    ///
    /// # Errors
    /// When it cannot be written.
    fn replace(&mut self, bytes: &[u8]) -> io::Result<()>;
}

/// What a journal belongs to.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Source {
    /// Where the document is kept; none for one that was never saved.
    pub path: Option<String>,
    /// A hash of the file's bytes, of any kind: it is only compared.
    pub hash: String,
}

/// A store in memory, for tests and for pages.
#[derive(Debug, Clone, Default)]
pub struct MemoryStore(pub std::sync::Arc<std::sync::Mutex<Vec<u8>>>);

impl MemoryStore {
    fn locked(&self) -> std::sync::MutexGuard<'_, Vec<u8>> {
        self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}

impl Store for MemoryStore {
    fn read(&mut self) -> io::Result<Vec<u8>> {
        Ok(self.locked().clone())
    }

    fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.locked().extend_from_slice(bytes);
        Ok(())
    }

    fn replace(&mut self, bytes: &[u8]) -> io::Result<()> {
        *self.locked() = bytes.to_vec();
        Ok(())
    }
}
