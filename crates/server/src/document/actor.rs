//! The thread that owns a document. Everything that happens to it passes here in turn.

use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::{Duration, Instant};

use katydid_data::text::Style;
use katydid_definition::document::{Object, ids};
use katydid_session::protocol::{Event, Notice, ResultView};
use katydid_session::{Change, Editor, Solution, result_view};
use katydid_solver::{ObjectReport, Options};
use katydid_studio::Finding;
use uuid::Uuid;

use super::clients::Clients;
use super::drawn::Seen;
use super::journal::Keeper;
use super::model::Beside;
use super::outbox::End;
use super::scripts::Scripting;
use super::solving::{Solving, Work};
use super::studies::Studies;
use super::worker::{Ended, Job, News, Worker};
use super::{About, ClientId, Command, Inquiry, Shared, Source};
use crate::geometry::Geometry;

/// Results are gathered for so long before they go out.
const GATHER: Duration = Duration::from_millis(30);

/// The reports of objects by their ids.
pub(super) type Reports = HashMap<Uuid, ObjectReport>;

/// Owns a document.
pub(super) struct Actor {
    pub(super) editor: Editor,
    pub(super) clients: Clients,
    pub(super) solving: Solving,
    pub(super) reports: Reports,
    pub(super) jobs: Sender<Job>,
    pub(super) shared: Arc<Shared>,
    pub(super) keeper: Keeper,
    /// Where the document is kept.
    pub(super) path: Option<PathBuf>,
    /// Whether it is only shown for a while.
    is_passing: bool,
    /// What objects show, as clients know it.
    pub(super) shown: HashMap<Uuid, Arc<Geometry>>,
    /// What of objects could not be shown, as clients know it.
    pub(super) left_out: HashMap<Uuid, Vec<String>>,
    /// The Rhino model beside it.
    pub(super) model: Beside,
    /// What clients see of the form of curves and surfaces.
    pub(super) analysed: HashMap<ClientId, Seen>,
    /// Results that clients have yet to hear of.
    fresh: Vec<(Object, ObjectReport)>,
    gathering: Option<Instant>,
    progress: Progress,
    /// How the last solve ended.
    end: Option<End>,
    /// The same, while clients have yet to hear of it.
    ending: Option<End>,
    /// Whether clients got geometry of the solve that is ending: they draw it before they hear of results.
    is_drawn: bool,
    /// What waits for the results.
    inquiries: Vec<Inquiry>,
    /// Whether scripts run.
    pub(super) scripting: Scripting,
    /// What clients wait for.
    pub(super) studies: Studies,
}

/// How far the solve that is running has come.
#[derive(Debug, Default)]
struct Progress {
    /// Its number.
    solution: u64,
    is_running: bool,
    done: u32,
    total: u32,
    name: String,
}

impl Actor {
    /// Starts the worker and the first solve.
    pub(super) fn new(source: Source, shared: Arc<Shared>, own: Sender<Command>) -> Self {
        let files = shared.trust.files(source.origin());
        let Source {
            document,
            name,
            path,
            copy_of: _,
            hash,
            fingerprint,
            rules,
            model,
            is_locked,
            is_passing,
            id,
        } = source;
        let journals = shared.journals.as_deref().filter(|_| !is_passing);
        let (mut editor, keeper) = Keeper::open(document, rules, journals, &id, path.as_deref(), hash);
        editor.about_mut().name = name;
        editor.about_mut().locked = is_locked;
        editor.about_mut().path = path.as_ref().map(|path| shared.trust.told(path));
        let known = fingerprint.filter(|_| editor.found().is_none());
        let scripting = Scripting::new(shared.scripts.clone().filter(|_| !is_passing), known, path.clone());
        editor.about_mut().scripts = scripting.view(editor.document());
        let scripts = Some(scripting.scripts());
        let beside = Beside::new(model);
        let model = beside.model().map(Arc::clone);
        let kept = Some(Arc::default());
        let options = Options { rules: editor.rules(), files, model, scripts, kept, ..Options::default() };
        let (jobs, inbox) = channel();
        let back = own.clone();
        let worker = Worker::new(editor.document().as_ref().clone(), options, own);
        // Without a thread to solve on, the document can be edited and saved all the same.
        let _ = std::thread::Builder::new().name("solver".to_owned()).spawn(move || worker.run(&inbox));
        let mut actor = Self {
            editor,
            clients: Clients::default(),
            solving: Solving::default(),
            reports: Reports::new(),
            jobs,
            shared,
            keeper,
            path,
            is_passing,
            shown: HashMap::new(),
            left_out: HashMap::new(),
            model: beside,
            analysed: HashMap::new(),
            fresh: Vec::new(),
            gathering: None,
            progress: Progress::default(),
            end: None,
            ending: None,
            is_drawn: false,
            inquiries: Vec::new(),
            scripting,
            studies: Studies::new(back),
        };
        actor.want(Work::Solve);
        actor
    }

    /// Does what it is told until it is closed.
    pub(super) fn run(mut self, inbox: &Receiver<Command>) {
        loop {
            let told = match self.next() {
                Some(at) => inbox.recv_timeout(at.saturating_duration_since(Instant::now())),
                None => inbox.recv().map_err(|_| RecvTimeoutError::Disconnected),
            };
            match told {
                Ok(Command::Close(done)) => {
                    self.close();
                    let _ = done.send(());
                    return;
                }
                Ok(command) => self.take(command),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return self.close(),
            }
            self.tick();
        }
    }

    /// When something is due although nobody asks.
    fn next(&self) -> Option<Instant> {
        let gathered = self.gathering.map(|since| since + GATHER);
        [gathered, self.solving.gives_up(), self.keeper.due()].into_iter().flatten().min()
    }

    fn tick(&mut self) {
        if self.gathering.is_some_and(|since| since.elapsed() >= GATHER) {
            self.publish_results();
        }
        self.solving.tick();
        self.keeper.tick(&mut self.editor);
        if self.clients.count() > 0
            && let Some(trouble) = self.keeper.trouble()
        {
            self.notice("warning", trouble);
        }
    }

    fn close(&mut self) {
        self.solving.cancel();
        self.studies.end_all();
        self.editor.flush();
        self.clients.iter().for_each(|client| client.outbox.close());
        for (_, geometry) in self.shown.drain() {
            self.shared.geometries.release(geometry);
        }
        self.model.release(&self.shared.geometries);
    }

    fn take(&mut self, command: Command) {
        match command {
            Command::Join(id, outbox, standing) => {
                self.clients.join(id, outbox, standing);
                self.show_all(id);
            }
            Command::Leave(id) => {
                let held = self.clients.leave(id);
                self.let_go(&held);
                let _ = self.jobs.send(Job::Leave(id));
                self.studies.end(id);
                let seen = self.analysed.remove(&id).unwrap_or_default();
                seen.objects.into_values().for_each(|geometry| self.shared.geometries.release(geometry));
                self.set_draft();
            }
            Command::Refresh(id) => self.show_all(id),
            Command::Ask(id, request) => self.asked(id, *request),
            Command::Bytes(form, answer) => {
                let _ = answer.send(self.bytes(form));
            }
            Command::Model(attached, answer) => {
                let _ = self.jobs.send(Job::Model(Some(Arc::clone(&attached.model))));
                self.model.attach(attached);
                self.want(Work::Solve);
                let _ = answer.send(());
            }
            Command::With(inquiry) => self.inquire(inquiry),
            Command::Picture(name, answer) => {
                let places = self.clients.places();
                let found = places.iter().find_map(|within| self.editor.picture(&name, within).ok()?);
                let _ = answer.send(found);
            }
            Command::About(answer) => {
                let _ = answer.send(self.about());
            }
            Command::Work(news) => self.heard(news),
            Command::Found(found) => self.found(found),
            Command::Assistant(asked) => self.assistant(asked),
            Command::Close(_) => {}
        }
    }

    /// Lets particles go that somebody dragged who is gone.
    fn let_go(&mut self, grabs: &[Uuid]) {
        for grab in grabs {
            if let Ok(difference) = self.editor.grab(*grab, None, &[]) {
                let _ = self.jobs.send(Job::Drag(difference));
                self.want(Work::Solve);
            }
        }
    }

    /// Takes the Rhino model away; what refers to it is solved anew.
    pub(super) fn detach_model(&mut self) {
        let _ = self.jobs.send(Job::Model(None));
        self.model.detach(&self.shared.geometries);
        self.clients.iter().for_each(|client| self.model.tell(&client.outbox));
        self.want(Work::Solve);
    }

    fn about(&self) -> About {
        let name = self.editor.about().name.clone();
        let is_passing = self.is_passing;
        let changed = self.editor.is_changed() && !is_passing;
        About { name, changed, is_passing, clients: self.clients.count() }
    }

    /// Asks for work; where edits wait for somebody to say so, for drawing alone.
    pub(super) fn want(&mut self, work: Work) {
        let work = if self.editor.about().locked { Work::Draw } else { work };
        self.solving.want(work, &self.jobs);
    }

    /// Does something with the results, as soon as they are those of the document as it stands.
    pub(super) fn inquire(&mut self, inquiry: Inquiry) {
        if self.solving.is_idle() {
            let _ = self.jobs.send(Job::With(inquiry));
        } else {
            self.inquiries.push(inquiry);
        }
    }

    /// Tells the worker whether something is dragged.
    pub(super) fn set_draft(&mut self) {
        let drags = self.clients.drags();
        let _ = self.jobs.send(Job::Draft(drags));
        if !drags {
            self.solving.want(Work::Draw, &self.jobs);
        }
    }

    fn heard(&mut self, news: News) {
        match news {
            News::Began(solution, total) => {
                // What is still to be told is of the solve before.
                self.publish_end();
                self.is_drawn = false;
                let total = u32::try_from(total).unwrap_or(u32::MAX);
                self.progress = Progress { solution, is_running: total > 0, total, ..Progress::default() };
            }
            News::Finished(done) => {
                let (object, report) = *done;
                self.progress.done += 1;
                object.title().clone_into(&mut self.progress.name);
                if self.editor.lookup().object(object.id).is_some() {
                    self.reports.insert(object.id, report.clone());
                    self.fresh.push((object, report));
                    self.gathering.get_or_insert_with(Instant::now);
                }
            }
            News::Ended(ended) => self.ended(ended),
            News::Drawn(solution, is_draft, previews) => {
                self.is_drawn |= self.publish_previews(solution, is_draft, previews);
                self.gathering = self.gathering.map(|_| Instant::now());
            }
            News::Modelled(preview) => {
                self.model.show(preview, &self.shared.geometries);
                self.clients.iter().for_each(|client| self.model.tell(&client.outbox));
            }
            News::Found(solution, client, Finding::Analysed(found)) => {
                self.publish_analysis(solution, client, found);
            }
            News::Found(solution, client, Finding::Probed(round, probes)) => {
                if let Some(client) = self.clients.get(client) {
                    client.outbox.probed(Event::Probed { solution, round, probes });
                }
            }
            News::Idle => {
                if !self.is_drawn {
                    self.publish_end();
                }
                self.solving.idle(&self.jobs);
                if self.solving.is_idle() {
                    self.inquiries.drain(..).for_each(|inquiry| drop(self.jobs.send(Job::With(inquiry))));
                }
            }
            News::Failed(what) => {
                self.notice("error", format!("{what}: this is a fault of Katydid, please report it"));
            }
        }
    }

    fn ended(&mut self, ended: Ended) {
        if self.progress.is_running {
            self.progress.is_running = false;
            self.solving.ended(&ended);
            let cancelled = ended.cancelled || ended.unfinished > 0;
            self.end = Some(End { cancelled, took: ended.took });
            self.ending = self.end;
            // Who drags looks at the geometry: it comes first, unless it takes long to draw.
            self.gathering = Some(Instant::now());
        }
    }

    /// Tells clients how a solve ended, if they have not heard of it.
    fn publish_end(&mut self) {
        if self.ending.is_some() {
            self.publish_results();
        }
    }

    /// The results of what is shown there.
    fn views(&self, within: &[Uuid], style: &Style) -> Vec<ResultView> {
        let report = |id| self.reports.get(&id).cloned();
        Solution::new(self.editor.document(), &report).views(within, style)
    }

    pub(super) fn style(&self) -> Style {
        let rules = self.editor.rules();
        Style { units: rules.units, tolerance: rules.tolerance }
    }

    /// Tells clients the results that are new, and how the solve ended when it has.
    fn publish_results(&mut self) {
        self.gathering = None;
        let end = self.ending.take();
        let fresh = std::mem::take(&mut self.fresh);
        let (solution, style) = (self.progress.solution, self.style());
        let view = |(object, report): &(Object, ObjectReport)| result_view(object, report, &style);
        let outer: Vec<ResultView> = fresh.iter().map(view).collect();
        for within in self.clients.places() {
            let is_fresh = |cluster: &Uuid| fresh.iter().any(|(object, _)| object.id == *cluster);
            let inner = within.first().is_some_and(is_fresh).then(|| self.views(&within, &style));
            let inner = inner.unwrap_or_default();
            let results = if within.is_empty() { &outer } else { &inner };
            for (_, client) in self.clients.at(&within) {
                if end.is_none() {
                    let Progress { done, total, name, .. } = &self.progress;
                    let (done, total, name) = (*done, *total, name.clone());
                    client.outbox.progress(Event::Solving { solution, done, total, name });
                }
                client.outbox.results(solution, &within, results, end);
            }
        }
    }

    /// Tells everybody something.
    pub(super) fn notice(&self, level: &str, text: String) {
        for client in self.clients.iter() {
            client.outbox.put(Event::Notice(Notice { level: level.to_owned(), text: text.clone() }));
        }
    }

    /// Shows a client everything that it looks at.
    pub(super) fn show_all(&mut self, id: ClientId) {
        let Some(within) = self.clients.get(id).map(|client| client.within.clone()) else { return };
        let state = self.editor.state(&within).or_else(|_| {
            // The cluster is gone: what is left is the document.
            self.clients.get_mut(id).into_iter().for_each(|client| client.within.clear());
            self.editor.state(&[])
        });
        let (Ok(state), Some(client)) = (state, self.clients.get(id)) else { return };
        client.outbox.put(Event::Document(state));
        let style = self.style();
        let views = self.views(&client.within, &style);
        let end = self.end.filter(|_| !self.progress.is_running);
        client.outbox.results(self.progress.solution, &client.within, &views, end);
        let shown: Vec<_> =
            self.shown.iter().map(|(id, geometry)| (*id, Some(Arc::clone(geometry)))).collect();
        client.outbox.previews(self.progress.solution, false, &shown);
        self.model.tell(&client.outbox);
        if let Some(seen) = self.analysed.get(&id) {
            let objects: Vec<_> =
                seen.objects.iter().map(|(id, geometry)| (*id, Some(Arc::clone(geometry)))).collect();
            client.outbox.analysed(self.progress.solution, false, &objects, &seen.about);
        }
    }

    /// Lets everybody know of a change: the journal, the worker, the clients.
    pub(super) fn publish(&mut self, change: &Change) {
        if change.is_empty() {
            return;
        }
        self.keeper.note();
        let _ = self.jobs.send(Job::Change(Box::new(change.clone())));
        if !change.difference.is_in_place() {
            let lookup = Arc::clone(self.editor.lookup());
            self.reports.retain(|id, _| lookup.object(*id).is_some());
        }
        let mut lost = Vec::new();
        for within in self.clients.places() {
            match self.editor.patch(change, &within) {
                Some(event) => {
                    self.clients.at(&within).for_each(|(_, client)| client.outbox.put(event.clone()))
                }
                None if self.editor.state(&within).is_err() => {
                    lost.extend(self.clients.at(&within).map(|(id, _)| id));
                }
                None => {}
            }
        }
        lost.into_iter().for_each(|id| self.show_all(id));
        let difference = &change.difference;
        let is_script = |object: &Object| object.script().is_some() || object.component == ids::CLUSTER;
        if !difference.removed.is_empty() || difference.put.iter().any(|(_, object)| is_script(object)) {
            self.show_scripts();
        }
        self.want(Work::Solve);
    }

    /// Lets clients know of the document's own states: saved, locked, named.
    pub(super) fn publish_document(&self) {
        let Ok(state) = self.editor.state(&[]) else { return };
        for client in self.clients.iter() {
            client.outbox.put(Event::Patch {
                revision: state.revision,
                within: client.within.clone(),
                put: Vec::new(),
                removed: Vec::new(),
                order: None,
                document: Some(state.document.clone()),
            });
        }
    }
}
