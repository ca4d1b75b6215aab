//! Objects of a script's own language, held by the process that runs the scripts.

use std::any::Any;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use katydid_data::Keeper;

/// The objects that a process holds for wires, and those that it may let go.
#[derive(Debug)]
pub(crate) struct Keepers {
    /// Which process: its number among those that were started.
    process: u64,
    gone: Arc<Mutex<Vec<u64>>>,
    /// Whether the process has ended.
    lost: Arc<AtomicBool>,
}

impl Drop for Keepers {
    /// They go with their process.
    fn drop(&mut self) {
        self.lost.store(true, Ordering::Release);
    }
}

impl Keepers {
    /// Those of a process that was just started.
    pub(crate) fn new(process: u64) -> Self {
        Self { process, gone: Arc::default(), lost: Arc::default() }
    }

    pub(crate) fn process(&self) -> u64 {
        self.process
    }

    /// A token for an object; the process may let go of it when the token's last copy is gone.
    pub(crate) fn kept(&self, number: u64, text: Option<&str>) -> Arc<dyn Keeper> {
        let (gone, lost) = (self.gone.clone(), self.lost.clone());
        Arc::new(Kept { process: self.process, number, text: text.map(Into::into), gone, lost })
    }

    /// The objects that nobody holds any more, once.
    pub(crate) fn take_gone(&self) -> Vec<u64> {
        std::mem::take(&mut *self.gone.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

/// An object of one process.
#[derive(Debug)]
pub(crate) struct Kept {
    process: u64,
    number: u64,
    /// What `str` gave when it came.
    text: Option<Box<str>>,
    gone: Arc<Mutex<Vec<u64>>>,
    lost: Arc<AtomicBool>,
}

impl Kept {
    pub(crate) fn process(&self) -> u64 {
        self.process
    }
}

impl Keeper for Kept {
    fn number(&self) -> u64 {
        self.number
    }

    fn is_lost(&self) -> bool {
        self.lost.load(Ordering::Acquire)
    }

    fn text(&self) -> Option<&str> {
        self.text.as_deref()
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

/// An object of a script that lives no longer than the run: its text is what is left for panels.
#[derive(Debug)]
pub(crate) struct Shown(pub(crate) String);

impl Keeper for Shown {
    fn number(&self) -> u64 {
        0
    }

    fn is_lost(&self) -> bool {
        false
    }

    fn text(&self) -> Option<&str> {
        Some(&self.0)
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

impl Drop for Kept {
    fn drop(&mut self) {
        self.gone.lock().unwrap_or_else(PoisonError::into_inner).push(self.number);
    }
}
