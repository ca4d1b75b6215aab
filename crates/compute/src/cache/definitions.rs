use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock};

use super::lock;
use crate::{Definition, Fault};

/// Definitions by key. What was not used for longest goes first when there are too many bytes: its results, then itself.
#[derive(Debug)]
pub(crate) struct Definitions {
    most: usize,
    kept: Mutex<Kept>,
    /// The definitions that are being read now: whoever asks for one of them waits for it.
    reading: Mutex<HashMap<String, Arc<Flight>>>,
}

/// A definition that is being read.
type Flight = OnceLock<Result<Arc<Definition>, Fault>>;

#[derive(Debug, Default)]
struct Kept {
    entries: HashMap<String, Entry>,
    /// Counts uses.
    clock: u64,
}

#[derive(Debug)]
struct Entry {
    definition: Arc<Definition>,
    /// When it was used last.
    used: u64,
}

impl Definitions {
    /// A store for so many bytes.
    pub(crate) fn new(most: usize) -> Self {
        Self { most, kept: Mutex::default(), reading: Mutex::default() }
    }

    /// The definition with that key.
    pub(crate) fn get(&self, key: &str) -> Option<Arc<Definition>> {
        let kept = &mut *lock(&self.kept);
        let entry = kept.entries.get_mut(key)?;
        kept.clock += 1;
        entry.used = kept.clock;
        Some(entry.definition.clone())
    }

    /// The definition with that key, made when it is not there. Of many who ask at a time one makes it.
    pub(crate) fn get_or_make(
        &self,
        key: &str,
        make: impl FnOnce() -> Result<Definition, Fault>,
    ) -> Result<Arc<Definition>, Fault> {
        if let Some(definition) = self.get(key) {
            return Ok(definition);
        }
        let flight = lock(&self.reading).entry(key.to_owned()).or_default().clone();
        let made = flight.get_or_init(|| {
            // Somebody may have been done between the two looks.
            if let Some(definition) = self.get(key) {
                return Ok(definition);
            }
            let definition = Arc::new(make()?);
            self.put(key, definition.clone());
            Ok(definition)
        });
        let made = made.clone();
        let mut reading = lock(&self.reading);
        if reading.get(key).is_some_and(|known| Arc::ptr_eq(known, &flight)) {
            reading.remove(key);
        }
        made
    }

    /// Keeps a definition in place of the one that was there.
    pub(crate) fn put(&self, key: &str, definition: Arc<Definition>) {
        let kept = &mut *lock(&self.kept);
        kept.clock += 1;
        kept.entries.insert(key.to_owned(), Entry { definition, used: kept.clock });
        kept.trim(self.most);
    }

    /// Makes room: to be called when a definition has become heavier.
    pub(crate) fn trim(&self) {
        lock(&self.kept).trim(self.most);
    }

    /// How many definitions there are, and how many bytes they take by estimate.
    pub(crate) fn size(&self) -> (usize, usize) {
        let kept = lock(&self.kept);
        (kept.entries.len(), kept.weight())
    }
}

impl Kept {
    fn weight(&self) -> usize {
        self.entries.values().map(|entry| entry.definition.weight()).sum()
    }

    fn trim(&mut self, most: usize) {
        let mut total = self.weight();
        if total <= most {
            return;
        }
        let mut by_age: Vec<(u64, String)> =
            self.entries.iter().map(|(key, entry)| (entry.used, key.clone())).collect();
        by_age.sort_unstable();
        for (_, key) in &by_age {
            let Some(entry) = self.entries.get(key).filter(|_| total > most) else { break };
            total -= entry.definition.states().forget();
        }
        for (_, key) in &by_age {
            let Some(entry) = self.entries.get(key).filter(|_| total > most) else { break };
            total = total.saturating_sub(entry.definition.weight());
            self.entries.remove(key);
        }
    }
}
