//! The journal of a document as its host keeps it.

use std::io;
use std::sync::{Arc, Mutex, PoisonError};

use katydid_session::journal::Store;

/// What is to be written down.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Written {
    /// Behind what is there.
    More(Vec<u8>),
    /// Instead of what is there; nothing where it is empty.
    Instead(Vec<u8>),
}

/// What waits to be written down.
pub(crate) type Queue = Arc<Mutex<Vec<Written>>>;

/// A journal that was read, and whose writes wait in a row for the host.
#[derive(Debug)]
pub(crate) struct Queued {
    pub(crate) found: Vec<u8>,
    pub(crate) queue: Queue,
}

impl Queued {
    fn put(&self, written: Written) {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner).push(written);
    }
}

impl Store for Queued {
    fn read(&mut self) -> io::Result<Vec<u8>> {
        Ok(self.found.clone())
    }

    fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.put(Written::More(bytes.to_vec()));
        Ok(())
    }

    fn replace(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.put(Written::Instead(bytes.to_vec()));
        Ok(())
    }
}

/// Takes what waits.
pub(crate) fn take(queue: &Queue) -> Vec<Written> {
    std::mem::take(&mut *queue.lock().unwrap_or_else(PoisonError::into_inner))
}

/// A journal after some writes, for hosts that keep it in one piece.
pub fn written(mut journal: Vec<u8>, writes: &[Written]) -> Vec<u8> {
    for write in writes {
        match write {
            Written::More(bytes) => journal.extend_from_slice(bytes),
            Written::Instead(bytes) => bytes.clone_into(&mut journal),
        }
    }
    journal
}
