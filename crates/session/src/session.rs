use katydid_definition::document::{Document, Object};
use katydid_solver::{Engine, Options, Summary};
use uuid::Uuid;

use crate::input::{self, InputError};
use crate::report::{Items, Report};

/// One change that can be taken back: an object before and after.
#[derive(Debug, Clone)]
struct Change {
    index: usize,
    before: Box<Object>,
    after: Box<Object>,
}

/// A document with its solution and its history.
#[derive(Debug)]
pub struct Session {
    engine: Engine,
    undo: Vec<Change>,
    redo: Vec<Change>,
    last: Summary,
}

impl Session {
    /// A session on a document; nothing is solved yet.
    pub fn new(document: Document, options: Options) -> Self {
        Self {
            engine: Engine::new(document, options),
            undo: Vec::new(),
            redo: Vec::new(),
            last: Summary::default(),
        }
    }

    /// The document as it stands.
    pub fn document(&self) -> &Document {
        self.engine.document()
    }

    /// The engine with the results.
    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// What a solve may use.
    pub fn options_mut(&mut self) -> &mut Options {
        self.engine.options_mut()
    }

    /// Sets an input by its nickname or id: a slider, panel, toggle, value list, contextual input, parameter, or
    /// the one object in a group that is called `RH_IN:name`. Gives the id of the object.
    ///
    /// # Errors
    /// When there is no such input, or several, or it does not take that value.
    pub fn set(&mut self, name: &str, value: &str) -> Result<Uuid, InputError> {
        let index = input::find(self.document(), name)?;
        let before = self.document().objects.get(index).cloned().map(Box::new);
        let Some(before) = before else {
            return Err(InputError::NotFound { name: name.to_owned(), near: None });
        };
        let mut after = before.clone();
        input::assign(&mut after, value)?;
        let id = after.id;
        self.put(index, &after);
        self.undo.push(Change { index, before, after });
        self.redo.clear();
        Ok(id)
    }

    fn put(&mut self, index: usize, object: &Object) {
        self.engine.edit(index, |slot| *slot = object.clone());
    }

    /// Takes the last change back; `false` when there is none.
    pub fn undo(&mut self) -> bool {
        let Some(change) = self.undo.pop() else { return false };
        self.put(change.index, &change.before);
        self.redo.push(change);
        true
    }

    /// Makes the last change that was taken back again; `false` when there is none.
    pub fn redo(&mut self) -> bool {
        let Some(change) = self.redo.pop() else { return false };
        self.put(change.index, &change.after);
        self.undo.push(change);
        true
    }

    /// Solves what has changed since the last time.
    pub fn solve(&mut self) -> Summary {
        self.last = self.engine.solve();
        self.last
    }

    /// The results with items as a panel shows them.
    pub fn report(&self) -> Report {
        self.report_with(Items::Texts)
    }

    /// The results with items in the given form.
    pub fn report_with(&self, items: Items) -> Report {
        Report::new(&self.engine, self.last, items)
    }
}
