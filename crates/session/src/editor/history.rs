use std::collections::VecDeque;
use std::sync::Arc;

use katydid_definition::document::{Difference, Document};

/// How many steps can be taken back; of more the oldest are forgotten.
const MOST_STEPS: usize = 2_000;

/// One step for Undo.
#[derive(Debug, Clone)]
pub(crate) struct Step {
    /// What it did, in words.
    pub(crate) name: String,
    /// The step back, while it is done; the step forth, while it is undone.
    pub(crate) difference: Arc<Difference>,
    /// The number of the state that it led to: none has the number of another.
    pub(crate) state: u64,
}

/// The gesture that may still go on.
#[derive(Debug, Clone)]
struct Running {
    gesture: u64,
    /// What its first edit did: the step is called so.
    name: String,
    /// The document before its first edit.
    before: Arc<Document>,
    /// Whether the last step is the gesture: one that has come back to where it began is none.
    is_step: bool,
}

/// What was done and undone.
#[derive(Debug, Clone, Default)]
pub(crate) struct History {
    done: VecDeque<Step>,
    undone: Vec<Step>,
    running: Option<Running>,
    /// The number of the next state.
    next: u64,
}

impl History {
    /// Takes note of a change that was made. Changes of one gesture, one after the other, are one step.
    pub(crate) fn note(
        &mut self,
        name: String,
        gesture: Option<u64>,
        before: &Arc<Document>,
        after: &Document,
        back: Difference,
    ) {
        self.undone.clear();
        self.next += 1;
        let state = self.next;
        if let Some(running) = self.running.as_mut().filter(|running| gesture == Some(running.gesture)) {
            let back = Difference::between(after, &running.before);
            if std::mem::replace(&mut running.is_step, !back.is_empty()) {
                self.done.pop_back();
            }
            if running.is_step {
                let name = running.name.clone();
                self.done.push_back(Step { name, difference: Arc::new(back), state });
            }
            return;
        }
        self.running = gesture.map(|gesture| Running {
            gesture,
            name: name.clone(),
            before: Arc::clone(before),
            is_step: true,
        });
        self.done.push_back(Step { name, difference: Arc::new(back), state });
        if self.done.len() > MOST_STEPS {
            self.done.pop_front();
        }
    }

    /// Takes note of edits of a gesture of which nothing came in the end. There is nothing to make again after them.
    pub(crate) fn note_nothing(&mut self, name: String, gesture: Option<u64>, document: &Arc<Document>) {
        self.undone.clear();
        if let Some(gesture) =
            gesture.filter(|gesture| self.running.as_ref().is_none_or(|r| r.gesture != *gesture))
        {
            self.running = Some(Running { gesture, name, before: Arc::clone(document), is_step: false });
        }
    }

    /// Ends the gesture that goes on: what comes next is a step of its own.
    pub(crate) fn rest(&mut self) {
        self.running = None;
    }

    /// The step that Undo takes back.
    pub(crate) fn last_done(&self) -> Option<&Step> {
        self.done.back()
    }

    /// The step that Redo makes again.
    pub(crate) fn last_undone(&self) -> Option<&Step> {
        self.undone.last()
    }

    /// Takes note that the last step was taken back; `forth` makes it again.
    pub(crate) fn undo(&mut self, forth: Difference) {
        self.rest();
        if let Some(step) = self.done.pop_back() {
            self.undone.push(Step { difference: Arc::new(forth), ..step });
        }
    }

    /// Takes note that the last step that was taken back was made again.
    pub(crate) fn redo(&mut self, back: Difference) {
        self.rest();
        if let Some(step) = self.undone.pop() {
            self.done.push_back(Step { difference: Arc::new(back), ..step });
        }
    }

    /// Forgets the last step, which is taken back for good.
    pub(crate) fn abandon(&mut self) {
        self.rest();
        self.done.pop_back();
    }

    /// The number of the state that the document is in: 0 at the beginning.
    pub(crate) fn state(&self) -> u64 {
        self.done.back().map_or(0, |step| step.state)
    }

    /// The steps that can be taken back, oldest first.
    pub(crate) fn done(&self) -> impl DoubleEndedIterator<Item = &Step> + ExactSizeIterator {
        self.done.iter()
    }

    /// The steps that can be made again, the next one first.
    pub(crate) fn undone(&self) -> impl DoubleEndedIterator<Item = &Step> {
        self.undone.iter().rev()
    }

    /// The document before a gesture that goes on.
    pub(crate) fn before(&self, gesture: u64) -> Option<&Arc<Document>> {
        self.running.as_ref().filter(|running| running.gesture == gesture).map(|running| &running.before)
    }

    /// The gesture that goes on, when the last step is of it.
    pub(crate) fn running(&self) -> Option<u64> {
        self.running.as_ref().filter(|running| running.is_step).map(|running| running.gesture)
    }
}
