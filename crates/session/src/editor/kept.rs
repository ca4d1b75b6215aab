//! The editor's side of the journal.

use std::sync::Arc;

use katydid_definition::document::{Difference, Document};

use super::Editor;
use crate::Change;
use crate::journal::{Found, Journal, Kept, Source};

impl Editor {
    /// The same with a journal.
    pub(crate) fn journalled(mut self, journal: Journal) -> Self {
        self.journal = Some(journal);
        self
    }

    /// The same, made again from a journal; `saved` is the document as its file has it.
    pub(crate) fn restored(mut self, found: Found, saved: Document) -> Self {
        self.found = Some(found);
        self.file = Some(Arc::new(saved));
        self
    }

    /// The same, beside a journal that could not be used.
    pub(crate) fn without_journal(mut self, why: &'static str) -> Self {
        self.lost = Some(why);
        self
    }

    /// Why the journal that was there could not be used, if it could not: unsaved edits of an earlier session are lost.
    pub fn lost_journal(&self) -> Option<&'static str> {
        self.lost
    }

    /// What was found in the journal and made again, until it is settled.
    pub fn found(&self) -> Option<&Found> {
        self.found.as_ref()
    }

    /// Says whether what was restored from the journal shall stay, or make way for the document as its file has it. The
    /// latter is a step like any other, and can be taken back.
    pub fn settle(&mut self, keep: bool) -> Change {
        let (Some(_), Some(file)) = (self.found.take(), self.file.take()) else { return self.nothing() };
        if keep {
            return self.nothing();
        }
        let after = Document::clone(&file);
        let change = self.commit("Discard restored edits".to_owned(), None, after, Vec::new());
        self.saved = Some(self.history.state());
        change
    }

    /// Writes what the journal has waiting, if it has waited long enough. To be called some times a second.
    pub fn tick(&mut self) {
        if let Some(journal) = &mut self.journal {
            journal.tick();
        }
        if self.journal.as_ref().is_some_and(Journal::is_long) {
            self.shorten_journal();
        }
    }

    /// Writes all that the journal has waiting.
    pub fn flush(&mut self) {
        if let Some(journal) = &mut self.journal {
            journal.flush();
        }
    }

    /// Why the journal could not be written, if it could not: what is edited from then on is lost with the session.
    pub fn journal_failure(&self) -> Option<&str> {
        self.journal.as_ref()?.failure()
    }

    /// Writes the journal anew: a step for each that can be taken back or made again.
    pub(crate) fn shorten_journal(&mut self) {
        let mut document = Document::clone(&self.document);
        let mut steps = Vec::new();
        for step in self.history.done().rev() {
            let Ok(forth) = document.apply(&step.difference) else { return };
            steps.push(Kept { name: step.name.clone(), forth: Arc::new(forth), undone: false });
        }
        steps.reverse();
        let undone = self.history.undone().map(|step| Kept {
            name: step.name.clone(),
            forth: Arc::clone(&step.difference),
            undone: true,
        });
        steps.extend(undone);
        if let Some(journal) = &mut self.journal {
            journal.shorten(document, &steps);
        }
    }

    /// Takes note that the document was saved as it stands, in a file that is known by `source` from now on. The journal
    /// begins anew.
    pub fn note_saved(&mut self, source: Option<Source>) {
        self.history.rest();
        self.saved = Some(self.history.state());
        self.found = None;
        self.file = None;
        self.lost = None;
        if let Some(journal) = &mut self.journal {
            journal.restart(source);
        }
    }

    /// Takes note that no state of the document is the one that was saved.
    pub(crate) fn note_unsaved(&mut self) {
        self.saved = None;
    }

    /// Does a step again that a journal tells of.
    pub(crate) fn make_again(
        &mut self,
        name: String,
        gesture: Option<u64>,
        difference: &Difference,
    ) -> Option<Change> {
        let mut after = Document::clone(&self.document);
        after.apply(difference).ok()?;
        if difference.is_empty() {
            self.history.note_nothing(name.clone(), gesture, &self.document);
        }
        Some(self.commit(name, gesture, after, Vec::new()))
    }

    /// Takes the last step back for good, as a journal tells of it.
    pub(crate) fn abandon_last(&mut self) {
        if let Some(gesture) = self.history.running() {
            self.abandon(gesture);
        }
    }

    /// Ends the gesture that goes on.
    pub(crate) fn end_gesture(&mut self) {
        self.history.rest();
    }

    /// How many steps can be taken back.
    pub fn steps(&self) -> usize {
        self.history.done().len()
    }
}
