//! The documents that are open.

use std::collections::HashMap;
use std::sync::{Arc, Mutex};

use crate::document::{About, Command, Handle, Shared, Source};
use crate::lock::held;

/// All documents that are open, by id.
#[derive(Debug)]
pub(crate) struct Documents {
    open: Mutex<HashMap<String, Handle>>,
    shared: Arc<Shared>,
    most: usize,
}

impl Documents {
    pub(crate) fn new(shared: Arc<Shared>, most: usize) -> Self {
        Self { open: Mutex::new(HashMap::new()), shared, most }
    }

    /// Opens a document and gives its id. One that is open already stays as it is.
    pub(crate) fn open(&self, source: Source) -> Result<String, String> {
        let mut open = held(&self.open);
        if open.contains_key(&source.id) {
            return Ok(source.id);
        }
        if open.len() >= self.most {
            return Err(format!("{} documents are open already: close some first", self.most));
        }
        if let (Some(recent), Some(path)) = (&self.shared.recent, &source.path) {
            recent.note(path);
        }
        let id = source.id.clone();
        let handle = Handle::open(source, Arc::clone(&self.shared)).map_err(|error| error.to_string())?;
        open.insert(id.clone(), handle);
        Ok(id)
    }

    /// A document by its id.
    pub(crate) fn get(&self, id: &str) -> Option<Handle> {
        held(&self.open).get(id).cloned()
    }

    /// Whether there is room for one more.
    pub(crate) fn is_full(&self) -> bool {
        held(&self.open).len() >= self.most
    }

    fn all(&self) -> Vec<(String, Handle)> {
        held(&self.open).iter().map(|(id, handle)| (id.clone(), handle.clone())).collect()
    }

    /// How they stand, by name.
    pub(crate) async fn about(&self) -> Vec<(String, About)> {
        let mut list = Vec::new();
        for (id, handle) in self.all() {
            if let Some(about) = handle.ask(Command::About).await {
                list.push((id, about));
            }
        }
        list.sort_by(|(_, a), (_, b)| a.name.cmp(&b.name));
        list
    }

    /// A picture that one of them holds, by its name, with its media type.
    pub(crate) async fn picture(&self, name: &str) -> Option<(Vec<u8>, &'static str)> {
        for (_, handle) in self.all() {
            let found = handle.ask(|answer| Command::Picture(name.to_owned(), answer)).await.flatten();
            if found.is_some() {
                return found;
            }
        }
        None
    }

    /// Closes one, unless somebody shows it; gives whether it was there.
    pub(crate) async fn close(&self, id: &str) -> Result<bool, &'static str> {
        let Some(handle) = self.get(id) else { return Ok(false) };
        if handle.ask(Command::About).await.is_some_and(|about| about.clients > 0) {
            return Err("somebody has it open: close that page first");
        }
        held(&self.open).remove(id);
        let _ = handle.ask(Command::Close).await;
        Ok(true)
    }

    /// Closes those that nobody shows and that hold nothing unsaved.
    pub(crate) async fn close_idle(&self) {
        for (id, handle) in self.all() {
            let about = handle.ask(Command::About).await;
            if about.is_none_or(|about| about.clients == 0 && !about.changed) {
                held(&self.open).remove(&id);
                let _ = handle.ask(Command::Close).await;
            }
        }
    }

    /// Closes all.
    pub(crate) async fn close_all(&self) {
        let all: Vec<(String, Handle)> = held(&self.open).drain().collect();
        for (_, handle) in all {
            let _ = handle.ask(Command::Close).await;
        }
    }
}
