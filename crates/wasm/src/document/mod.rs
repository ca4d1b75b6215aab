//! A document that one client works on: what a server's document thread and its worker do, on one thread.
//!
//! Requests are carried out at once ([`Document::ask`]). What they make due, solving and drawing, waits until the host
//! calls [`Document::work`]: a host that hands over all requests that have come before it does so solves once for all
//! of them, as a drag of a slider wants it.

mod asked;
mod shown;
mod study;
mod work;

use std::collections::HashMap;
use std::sync::Arc;

use katydid_component::RhinoModel;
use katydid_data::text::Style;
use katydid_session::protocol::{Event, ModelView, Notice};
use katydid_session::{Change, Editor, Solution};
use katydid_solver::{Engine, ObjectReport, Options};
use katydid_studio::{Analyses, ClientId, Drafts, Form};
use uuid::Uuid;

use crate::journal::{self, Queue, Queued, Written};
use crate::opening::{self, Opened};
use crate::outgoing::{Message, Named, Outgoing};
use shown::Seen;
use study::Study;
pub use work::Progress;
use work::{End, Work};

/// The one client.
const CLIENT: ClientId = 0;

/// A document with its engine, its history and what its client sees.
#[derive(Debug)]
pub struct Document {
    editor: Editor,
    engine: Engine,
    drafts: Drafts,
    analyses: Analyses,
    /// The clusters that lead to what the client shows.
    within: Vec<Uuid>,
    reports: HashMap<Uuid, ObjectReport>,
    /// What objects show, as the client knows it.
    shown: HashMap<Uuid, Named>,
    /// What of objects could not be shown, as the client knows it.
    left_out: HashMap<Uuid, Vec<String>>,
    seen: Seen,
    /// The Rhino model beside it.
    model: Option<(String, Arc<RhinoModel>)>,
    model_view: Option<ModelView>,
    model_geometry: Vec<Named>,
    is_model_due: bool,
    /// What waits to be done.
    wanted: Option<Work>,
    /// What the client asked about the definition, and waits for.
    study: Option<Study>,
    /// The number of the solve that was begun last.
    number: u64,
    end: Option<End>,
    out: Outgoing,
    queue: Queue,
    trouble: Option<String>,
}

impl Document {
    /// Opens a document: a definition, or an empty one without bytes. `journal` is what a session before this one left
    /// of unsaved edits; it is made again. One that is locked is not solved until somebody says so.
    ///
    /// # Errors
    /// What is wrong with the definition, and where.
    pub fn open(
        name: &str,
        definition: Option<&[u8]>,
        journal: Vec<u8>,
        is_locked: bool,
    ) -> Result<Self, String> {
        let Opened { document, rules } = match definition {
            Some(bytes) => opening::open(opening::form_of(bytes), bytes)?,
            None => {
                katydid_components::link();
                Opened { document: katydid_definition::document::Document::new(), rules: opening::rules() }
            }
        };
        let queue = Queue::default();
        let store = Queued { found: journal, queue: Arc::clone(&queue) };
        let source = katydid_session::journal::Source::default();
        let (mut editor, trouble) =
            match Editor::with_journal(document.clone(), rules, source, Box::new(store)) {
                Ok(editor) => (editor, None),
                Err(error) => (Editor::new(document, rules), Some(format!("edits are not kept: {error}"))),
            };
        name.clone_into(&mut editor.about_mut().name);
        editor.about_mut().locked = is_locked;
        let mut drafts = Drafts::default();
        drafts.touch_all(editor.document());
        let options = Options { kept: Some(Arc::default()), ..opening::options(editor.rules()) };
        let engine = Engine::new(editor.document().as_ref().clone(), options);
        let mut document = Self {
            editor,
            engine,
            drafts,
            analyses: Analyses::default(),
            within: Vec::new(),
            reports: HashMap::new(),
            shown: HashMap::new(),
            left_out: HashMap::new(),
            seen: Seen::default(),
            model: None,
            model_view: None,
            model_geometry: Vec::new(),
            is_model_due: false,
            wanted: None,
            study: None,
            number: 0,
            end: None,
            out: Outgoing::default(),
            queue,
            trouble,
        };
        document.want(Work::Solve);
        Ok(document)
    }

    /// The client joins, or wants everything anew.
    pub fn join(&mut self) {
        self.show_all();
        if let Some(lost) = self.editor.lost_journal() {
            self.notice("warning", format!("edits of an earlier session are lost: {lost}"));
        }
        if let Some(trouble) = self.trouble.take() {
            self.notice("warning", trouble);
        }
    }

    /// What the client is to be told, in order.
    pub fn take(&mut self) -> Vec<Message> {
        self.out.take()
    }

    /// What is to be added to the journal.
    pub fn take_written(&mut self) -> Vec<Written> {
        journal::take(&self.queue)
    }

    /// Writes what the journal has waiting long enough. To be called some times a second while there are edits.
    pub fn tick(&mut self) {
        self.editor.tick();
    }

    /// Writes all that the journal has waiting: before the page goes.
    pub fn flush(&mut self) {
        self.editor.flush();
    }

    /// The name that is shown.
    pub fn name(&self) -> &str {
        &self.editor.about().name
    }

    /// Whether it is as it was saved.
    pub fn is_changed(&self) -> bool {
        self.editor.is_changed()
    }

    /// The engine with the results.
    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// The document in a form.
    ///
    /// # Errors
    /// When it cannot be written in it.
    pub fn bytes(&self, form: Form) -> Result<Vec<u8>, String> {
        katydid_studio::write(form, self.editor.document()).map(|(bytes, _)| bytes)
    }

    /// Takes note that it was saved as it stands, in a file of that name.
    pub fn saved(&mut self, name: &str) {
        name.clone_into(&mut self.editor.about_mut().name);
        self.editor.about_mut().path = Some(name.to_owned());
        self.editor.note_saved(None);
        self.publish_document();
    }

    /// Where it is kept, as the client is told: a file that it can be saved to again.
    pub fn is_kept_in(&mut self, name: &str) {
        self.editor.about_mut().path = Some(name.to_owned());
    }

    /// What was restored from the journal stays: the client knows of it, since it made those edits itself.
    pub fn keep_restored(&mut self) {
        let _ = self.editor.settle(true);
    }

    /// Puts a Rhino model beside it, or takes it away; what refers to it is solved anew.
    ///
    /// # Errors
    /// When it is no .3dm file.
    pub fn attach(&mut self, name: &str, bytes: &[u8]) -> Result<(), String> {
        let model = RhinoModel::read(bytes).map_err(|error| format!("{name}: {error}"))?;
        let model = Arc::new(model);
        self.engine.options_mut().model = Some(Arc::clone(&model));
        self.engine.forget();
        self.model = Some((name.to_owned(), model));
        self.is_model_due = true;
        self.want(Work::Solve);
        Ok(())
    }

    /// A picture that it holds, by its name, with its media type.
    pub fn picture(&self, name: &str) -> Option<(Vec<u8>, &'static str)> {
        self.editor.picture(name, &self.within).ok().flatten()
    }

    /// Geometry by its hash, as long as it is shown.
    pub fn geometry(&self, hash: &str) -> Option<&[u8]> {
        let all = self.shown.values().chain(self.seen.objects.values()).chain(&self.model_geometry);
        all.into_iter().find(|geometry| geometry.hash == hash).map(|geometry| geometry.bytes.as_slice())
    }

    fn style(&self) -> Style {
        let rules = self.editor.rules();
        Style { units: rules.units, tolerance: rules.tolerance }
    }

    fn notice(&mut self, level: &str, text: String) {
        self.out.say(&Event::Notice(Notice { level: level.to_owned(), text }));
    }

    /// Lets all know of a change: the engine, the client.
    fn publish(&mut self, change: &Change) {
        if change.is_empty() {
            return;
        }
        self.follow(change);
        if !change.difference.is_in_place() {
            let lookup = Arc::clone(self.editor.lookup());
            self.reports.retain(|id, _| lookup.object(*id).is_some());
        }
        match self.editor.patch(change, &self.within) {
            Some(event) => self.out.say(&event),
            None if self.editor.state(&self.within).is_err() => self.show_all(),
            None => {}
        }
        self.want(Work::Solve);
    }

    /// Brings the engine to where the editor is.
    fn follow(&mut self, change: &Change) {
        let touched = katydid_studio::touched(&change.difference, &change.before);
        if change.bring_to(&mut self.engine).is_err() {
            // It cannot have missed a change; if it has, it begins anew.
            let options = self.engine.options().clone();
            self.engine = Engine::new(change.after.as_ref().clone(), options);
            self.drafts.touch_all(&change.after);
            self.analyses.touch_all();
        }
        self.analyses.touch(&touched);
        self.drafts.touch(touched);
    }

    /// Lets the client know of the document's own states: saved, locked, named.
    fn publish_document(&mut self) {
        let Ok(state) = self.editor.state(&[]) else { return };
        self.out.say(&Event::Patch {
            revision: state.revision,
            within: self.within.clone(),
            put: Vec::new(),
            removed: Vec::new(),
            order: None,
            document: Some(state.document),
        });
    }

    /// The results where `within` leads to.
    fn views(&self, within: &[Uuid]) -> Vec<katydid_session::protocol::ResultView> {
        let report = |id| self.reports.get(&id).cloned();
        Solution::new(self.editor.document(), &report).views(within, &self.style())
    }
}
