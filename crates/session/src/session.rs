use katydid_definition::document::Document;
use katydid_solver::{Engine, Options, Summary, Ticks};
use uuid::Uuid;

use crate::input::{self, InputError};
use crate::report::{Items, Report};
use crate::{Change, Editor};

/// A document with its solution and its history: an [`Editor`] and an [`Engine`] that follows it.
#[derive(Debug)]
pub struct Session {
    editor: Editor,
    engine: Engine,
    last: Summary,
}

impl Session {
    /// A session on a document; nothing is solved yet.
    pub fn new(document: Document, options: Options) -> Self {
        Self {
            editor: Editor::new(document.clone(), options.rules),
            engine: Engine::new(document, options),
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
        let Some(mut object) = self.document().objects.get(index).cloned() else {
            return Err(InputError::NotFound { name: name.to_owned(), near: None });
        };
        input::assign(&mut object, value)?;
        let id = object.id;
        let change = self.editor.replace(index, object, format!("Set {name}"));
        self.follow(&change);
        Ok(id)
    }

    /// Brings the engine to where the editor is.
    fn follow(&mut self, change: &Change) {
        if change.bring_to(&mut self.engine).is_err() {
            let options = self.engine.options().clone();
            self.engine = Engine::new(Document::clone(&change.after), options);
        }
    }

    /// Takes the last change back; `false` when there is none.
    pub fn undo(&mut self) -> bool {
        let change = self.editor.undo();
        change.inspect(|change| self.follow(change)).is_some()
    }

    /// Makes the last change that was taken back again; `false` when there is none.
    pub fn redo(&mut self) -> bool {
        let change = self.editor.redo();
        change.inspect(|change| self.follow(change)).is_some()
    }

    /// Solves what has changed since the last time.
    pub fn solve(&mut self) -> Summary {
        self.last = self.engine.solve();
        self.last
    }

    /// Solves the definition as it stands, and gets ready to run it in time (see [`Ticks`]).
    pub fn begin_ticks(&mut self) -> Ticks {
        let (ticks, first) = Ticks::begin(&mut self.engine);
        self.last = first;
        ticks
    }

    /// Goes on to the next moment at which a timer fires or a dam lets data through, and solves what hangs on it;
    /// `false` when nothing will happen any more. The document must be the one that the ticks were begun with.
    pub fn tick(&mut self, ticks: &mut Ticks) -> bool {
        let Some(summary) = ticks.tick(&mut self.engine) else { return false };
        self.last.solved += summary.solved;
        self.last.unfinished = summary.unfinished;
        self.last.time += summary.time;
        true
    }

    /// What the last solve did, or all the ticks of a run in time.
    pub fn summary(&self) -> Summary {
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
