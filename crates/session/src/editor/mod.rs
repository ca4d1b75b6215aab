//! The document being edited: the only truth, its history and the number of its state.

mod draft;
mod hand;
mod history;
mod inside;
mod kept;
mod words;

use std::sync::{Arc, OnceLock};

use katydid_data::cast::Rules;
use katydid_definition::document::{Difference, Document, Lookup, Object};
use uuid::Uuid;

use history::History;

pub use draft::{NoResults, Results};

pub(crate) use draft::Draft;
pub use inside::{content, edit_inside};

pub(crate) use inside::open;

use crate::journal::{Found, Journal};
use crate::protocol::{DocumentState, Edit, Event, ScriptsView};
use crate::{Change, Refusal, edits, view};

/// A document being edited, with its history.
///
/// ```
/// use katydid_definition::document::Document;
/// use katydid_session::{Editor, protocol::Edit};
/// use uuid::Uuid;
///
/// katydid_components::link();
/// let mut editor = Editor::new(Document::new(), Default::default());
/// let id = Uuid::from_u128(1);
/// let panel = katydid_definition::document::ids::PANEL;
/// let edit = Edit::Place { id, component: panel, at: [100.0, 50.0], with: None };
/// let change = editor.apply(&edit, None, &[])?;
/// assert_eq!(change.difference.put.len(), 1);
/// assert!(editor.apply(&edit, None, &[])?.is_empty());
/// assert!(editor.undo().is_some() && editor.document().objects.is_empty());
/// # Ok::<(), katydid_session::Refusal>(())
/// ```
#[derive(Debug)]
pub struct Editor {
    document: Arc<Document>,
    /// Units and tolerances of a document that names none.
    given_rules: Rules,
    revision: u64,
    history: History,
    /// The number of the state that was saved last; none when it cannot be come back to.
    saved: Option<u64>,
    about: About,
    lookup: OnceLock<Arc<Lookup>>,
    journal: Option<Journal>,
    /// What was restored from the journal, until somebody says whether it shall stay.
    found: Option<Found>,
    /// The document as its file has it, as long as that is asked.
    file: Option<Arc<Document>>,
    /// Why a journal that was there could not be used.
    lost: Option<&'static str>,
}

/// What a client shows of a document besides the document.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct About {
    /// The name that is shown.
    pub name: String,
    /// Where it is kept on this machine.
    pub path: Option<String>,
    /// Whether edits are not solved until somebody says so.
    pub locked: bool,
    /// The scripts that run only where somebody lets them.
    pub scripts: Option<ScriptsView>,
}

impl Editor {
    /// An editor of a document. `rules` are the units and tolerances of one that names none.
    pub fn new(document: Document, rules: Rules) -> Self {
        Self {
            document: Arc::new(document),
            given_rules: rules,
            revision: 0,
            history: History::default(),
            saved: Some(0),
            about: About::default(),
            lookup: OnceLock::new(),
            journal: None,
            found: None,
            file: None,
            lost: None,
        }
    }

    /// The document as it stands.
    pub fn document(&self) -> &Arc<Document> {
        &self.document
    }

    /// The number of changes since the session began.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Its units and tolerances: its own where it names some, else those that were given.
    pub fn rules(&self) -> Rules {
        edits::rules_of(&self.document, self.given_rules)
    }

    /// Name, path, and whether it is locked.
    pub fn about(&self) -> &About {
        &self.about
    }

    /// The same, to be changed.
    pub fn about_mut(&mut self) -> &mut About {
        &mut self.about
    }

    /// Where the ids of the document are.
    pub fn lookup(&self) -> &Arc<Lookup> {
        self.lookup.get_or_init(|| Arc::new(self.document.lookup()))
    }

    /// Whether something is changed since it was saved.
    pub fn is_changed(&self) -> bool {
        Some(self.history.state()) != self.saved
    }

    /// What Undo takes back, in words.
    pub fn undo_name(&self) -> Option<&str> {
        self.history.last_done().map(|step| step.name.as_str())
    }

    /// What Redo makes again, in words.
    pub fn redo_name(&self) -> Option<&str> {
        self.history.last_undone().map(|step| step.name.as_str())
    }

    /// Carries an edit out. Edits of one gesture, one after the other, are one step for Undo; `within` names the
    /// clusters, from the outermost, in which the edit takes place.
    ///
    /// # Errors
    /// When the edit cannot be made: nothing is changed then. Edits that need data refuse: see
    /// [`apply_with`](Self::apply_with).
    pub fn apply(&mut self, edit: &Edit, gesture: Option<u64>, within: &[Uuid]) -> Result<Change, Refusal> {
        self.apply_with(edit, gesture, within, &NoResults)
    }

    /// As [`apply`](Self::apply), with the data that [`Edit::Internalise`] keeps.
    ///
    /// # Errors
    /// As for [`apply`](Self::apply).
    pub fn apply_with(
        &mut self,
        edit: &Edit,
        gesture: Option<u64>,
        within: &[Uuid],
        results: &dyn Results,
    ) -> Result<Change, Refusal> {
        // A map that changes during a gesture is one from where that began: nothing adds up on the way.
        let began = match edit {
            Edit::Transform { .. } => {
                gesture.and_then(|gesture| self.history.before(gesture)).map(Arc::clone)
            }
            _ => None,
        };
        let lookup = (began.is_none() && within.is_empty()).then(|| Arc::clone(self.lookup()));
        let document = inside::open(began.as_ref().unwrap_or(&self.document), within)?;
        let name = words::name(edit, &document);
        let mut draft = Draft::new(document, lookup, within, results, self.rules());
        edits::carry_out(edit, &mut draft)?;
        let Draft { document, made, .. } = draft;
        let after = inside::close(began.as_ref().unwrap_or(&self.document), within, document)?;
        Ok(self.commit(name, gesture, after, made))
    }

    /// Puts another state of the whole document in its place, as a step that is called `name`, or as part of a gesture:
    /// what was made outside, as the document's text that was changed.
    pub fn put_document(&mut self, after: Document, name: String, gesture: Option<u64>) -> Change {
        self.commit(name, gesture, after, Vec::new())
    }

    /// Puts another state of one object in its place, as a step of its own.
    pub(crate) fn replace(&mut self, at: usize, object: Object, name: String) -> Change {
        let mut after = Document::clone(&self.document);
        if let Some(slot) = after.objects.get_mut(at) {
            *slot = object;
        }
        self.commit(name, None, after, Vec::new())
    }

    /// Makes a state of the document the one that counts.
    pub(crate) fn commit(
        &mut self,
        name: String,
        gesture: Option<u64>,
        after: Document,
        made: Vec<Uuid>,
    ) -> Change {
        let difference = Difference::between(&self.document, &after);
        if difference.is_empty() {
            return Change { made, ..self.nothing() };
        }
        let before = Arc::clone(&self.document);
        let back = Difference::between(&after, &before);
        self.history.note(name.clone(), gesture, &before, &after, back);
        let change = self.step(difference, after);
        if let Some(journal) = &mut self.journal {
            journal.step(&name, gesture, &change.difference, &change.before, &change.after);
        }
        Change { made, ..change }
    }

    /// Goes on to the next state of the document.
    fn step(&mut self, difference: Difference, after: Document) -> Change {
        let rules = self.rules();
        let before = std::mem::replace(&mut self.document, Arc::new(after));
        self.revision += 1;
        if !keeps_ids(&difference, &before) {
            self.lookup = OnceLock::new();
        }
        Change {
            revision: self.revision,
            difference: Arc::new(difference),
            rules: Some(self.rules()).filter(|now| *now != rules),
            made: Vec::new(),
            before,
            after: Arc::clone(&self.document),
        }
    }

    /// The change of an edit of which nothing came.
    fn nothing(&self) -> Change {
        Change {
            revision: self.revision,
            difference: Arc::default(),
            rules: None,
            made: Vec::new(),
            before: Arc::clone(&self.document),
            after: Arc::clone(&self.document),
        }
    }

    /// Takes the last step back; none when there is none.
    pub fn undo(&mut self) -> Option<Change> {
        let difference = Arc::clone(&self.history.last_done()?.difference);
        let (after, forth) = self.walked(&difference)?;
        self.history.undo(forth);
        let change = self.step(Difference::clone(&difference), after);
        if let Some(journal) = &mut self.journal {
            journal.undo(&change.before);
        }
        Some(change)
    }

    /// Makes the last step that was taken back again; none when there is none.
    pub fn redo(&mut self) -> Option<Change> {
        let difference = Arc::clone(&self.history.last_undone()?.difference);
        let (after, back) = self.walked(&difference)?;
        self.history.redo(back);
        let change = self.step(Difference::clone(&difference), after);
        if let Some(journal) = &mut self.journal {
            journal.redo(&change.before);
        }
        Some(change)
    }

    /// Takes the steps of a gesture back that is still going on, for good; nothing happens when it is over.
    pub fn abandon(&mut self, gesture: u64) -> Change {
        if self.history.running() != Some(gesture) {
            return self.nothing();
        }
        let Some(step) = self.history.last_done() else { return self.nothing() };
        let difference = Arc::clone(&step.difference);
        let Some((after, _)) = self.walked(&difference) else { return self.nothing() };
        self.history.abandon();
        let change = self.step(Difference::clone(&difference), after);
        if let Some(journal) = &mut self.journal {
            journal.abandon(&change.before);
        }
        change
    }

    /// The document after a step, and the step back.
    fn walked(&self, difference: &Difference) -> Option<(Document, Difference)> {
        let mut after = Document::clone(&self.document);
        let back = after.apply(difference).ok()?;
        Some((after, back))
    }

    /// Objects with the wires into them, as the text that Grasshopper has on its clipboard.
    ///
    /// # Errors
    /// When none of the objects is there, or `within` leads nowhere.
    pub fn copy(&self, objects: &[Uuid], within: &[Uuid]) -> Result<String, Refusal> {
        edits::copy(&self.open(within)?, objects)
    }

    /// The picture of that name that an Image Sampler keeps in what `within` leads to, with its media type. Names stand
    /// in the [views](crate::protocol::Control::Image) of such objects.
    ///
    /// # Errors
    /// There is no such cluster.
    pub fn picture(&self, name: &str, within: &[Uuid]) -> Result<Option<(Vec<u8>, &'static str)>, Refusal> {
        let find = |document: &Document| crate::view::picture::find(document, name);
        if within.is_empty() { Ok(find(&self.document)) } else { Ok(find(&self.open(within)?)) }
    }

    /// Everything a client needs to show the document, or the inside of the cluster that `within` leads to.
    ///
    /// # Errors
    /// When there is no such cluster, or nobody can look inside.
    pub fn state(&self, within: &[Uuid]) -> Result<DocumentState, Refusal> {
        view::state(self, &self.open(within)?, within)
    }

    /// What a client has to change to show the document, or the inside of the cluster that `within` leads to, after a
    /// change; none when the change was elsewhere or the cluster is gone.
    pub fn patch(&self, change: &Change, within: &[Uuid]) -> Option<Event> {
        view::patch(self, change, within)
    }
}

/// Whether all ids stay where they are.
fn keeps_ids(difference: &Difference, before: &Document) -> bool {
    difference.is_in_place()
        && difference.put.iter().all(|(at, object)| {
            before.objects.get(*at).is_some_and(|old| {
                let ids = |object: &Object| -> Vec<Uuid> {
                    object.inputs.iter().chain(&object.outputs).map(|port| port.id).collect()
                };
                old.id == object.id && old.inputs.len() == object.inputs.len() && ids(old) == ids(object)
            })
        })
}
