//! A definition that is open: edited at once, solved on a thread of its own.
//!
//! Edits go to the editor, which is never held for long. A solve works on a clone of the engine that has the results
//! before it, and puts its own in their place when it is over; so whoever reads results never waits for a solve.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use katydid_component::Limits;
use katydid_definition::document::{Difference, Document};
use katydid_definition::kd;
use katydid_session::Editor;
use katydid_solver::{Engine, Options, Progress, Status};
use serde_json::{Value, json};

use crate::attached::Original;
use crate::fault::Fault;
use crate::job::{Job, State};
use crate::text::Text;
use crate::thresholds::{LONGEST_LINE, MOST_FAILED};

/// A definition that is open.
pub(crate) struct Opened {
    /// What calls name it by.
    pub(crate) id: String,
    editor: Mutex<Editor>,
    results: Mutex<Solved>,
    job: Mutex<Option<Arc<Job>>>,
    place: Mutex<Place>,
    text: Mutex<Option<Arc<Text>>>,
    /// Whether a thread writes the text ahead.
    writing: AtomicBool,
    /// The document of a studio that this is a copy of.
    pub(crate) original: Option<Original>,
}

/// Results, and of which state of the definition they are.
#[derive(Clone)]
pub(crate) struct Solved {
    /// With all that was solved last.
    pub(crate) engine: Arc<Engine>,
    /// The number of the state; none when nothing was solved yet.
    pub(crate) revision: Option<u64>,
}

/// Where a definition is kept.
#[derive(Debug, Clone)]
pub(crate) struct Place {
    /// The file; none where it is in memory only.
    pub(crate) path: Option<PathBuf>,
    /// The definition as it was opened or saved last.
    pub(crate) kept: Arc<Document>,
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Opened {
    /// Opens a definition. `options` say what its solves may use.
    pub(crate) fn new(
        id: String,
        document: Document,
        mut options: Options,
        path: Option<PathBuf>,
        original: Option<Original>,
    ) -> Self {
        let editor = Editor::new(document, options.rules);
        options.rules = editor.rules();
        let kept = Arc::clone(editor.document());
        let engine = Arc::new(Engine::new(Document::clone(&kept), options));
        Self {
            id,
            editor: Mutex::new(editor),
            results: Mutex::new(Solved { engine, revision: None }),
            job: Mutex::new(None),
            place: Mutex::new(Place { path, kept }),
            text: Mutex::default(),
            writing: AtomicBool::new(false),
            original,
        }
    }

    /// The editor; not to be held over anything long.
    pub(crate) fn editor(&self) -> MutexGuard<'_, Editor> {
        lock(&self.editor)
    }

    /// The document as it stands.
    pub(crate) fn document(&self) -> Arc<Document> {
        Arc::clone(self.editor().document())
    }

    /// The last results, whether they are of the document as it stands or not.
    pub(crate) fn solved(&self) -> Solved {
        lock(&self.results).clone()
    }

    /// The last results.
    ///
    /// # Errors
    /// Nothing was solved yet.
    pub(crate) fn results(&self, what: &str) -> Result<Solved, Fault> {
        let solved = self.solved();
        if solved.revision.is_none() {
            return Err(Fault::new(what, &self.id, "nothing is solved yet: call solve first"));
        }
        Ok(solved)
    }

    /// The results of the document as it stands.
    ///
    /// # Errors
    /// There are none, or edits have been made since.
    pub(crate) fn current(&self, what: &str) -> Result<Solved, Fault> {
        let solved = self.results(what)?;
        let revision = self.editor().revision();
        if solved.revision == Some(revision) && solved.engine.dirty().is_empty() {
            return Ok(solved);
        }
        let why = "the results are older than the definition, or not whole: call solve first";
        Err(Fault::new(what, &self.id, why))
    }

    pub(crate) fn place(&self) -> Place {
        lock(&self.place).clone()
    }

    /// Takes note that the document was saved.
    pub(crate) fn note_saved(&self, path: PathBuf, document: Arc<Document>) {
        let mut editor = self.editor();
        if Arc::ptr_eq(editor.document(), &document) {
            editor.note_saved(None);
        }
        *lock(&self.place) = Place { path: Some(path), kept: document };
    }

    /// The name that is shown of it.
    pub(crate) fn name(&self) -> String {
        if let Some(original) = self.original.as_ref().filter(|original| !original.name.is_empty()) {
            return original.name.clone();
        }
        let stem = |path: &Path| path.file_stem().map(|name| name.to_string_lossy().into_owned());
        let from_path = self.place().path.as_deref().and_then(stem);
        from_path.unwrap_or_else(|| self.document().header.name.clone())
    }

    /// The solve that runs, or the one that ran last.
    pub(crate) fn job(&self) -> Option<Arc<Job>> {
        lock(&self.job).clone()
    }

    /// Has the document solved as it stands. A solve of that state that runs already is the one; one of an older state is
    /// cancelled, and what it has solved counts.
    pub(crate) fn solve(
        self: &Arc<Self>,
        number: impl FnOnce() -> u64,
        whole: bool,
    ) -> Result<Arc<Job>, Fault> {
        let (document, revision, rules) = {
            let editor = self.editor();
            (Arc::clone(editor.document()), editor.revision(), editor.rules())
        };
        let mut slot = lock(&self.job);
        let before = slot.clone().filter(|job| job.is_running());
        if let Some(job) = &before {
            if job.revision == revision && !whole && !job.cancel.is_cancelled() {
                return Ok(Arc::clone(job));
            }
            job.cancel.cancel();
        }
        let job = Job::new(number(), self.id.clone(), revision);
        *slot = Some(Arc::clone(&job));
        drop(slot);
        let (own, running) = (Arc::clone(self), Arc::clone(&job));
        let begun = std::thread::Builder::new().name("solve".to_owned()).spawn(move || {
            while before.as_ref().is_some_and(|job| job.is_running()) {
                std::thread::sleep(crate::thresholds::LOOK_EVERY);
            }
            let due = Due { document, revision, rules, whole };
            if catch_unwind(AssertUnwindSafe(|| own.run(&running, &due))).is_err() {
                running.end(State::Failed, 0, 0);
            }
        });
        if begun.is_err() {
            job.end(State::Failed, 0, 0);
            return Err(Fault::new("nothing was solved", &self.id, "the system gives no more threads"));
        }
        Ok(job)
    }

    fn run(&self, job: &Arc<Job>, due: &Due) {
        let mut engine = Engine::clone(&self.solved().engine);
        let difference = Difference::between(engine.document(), &due.document);
        if engine.apply(&difference).is_err() {
            let options = engine.options().clone();
            engine = Engine::new(Document::clone(&due.document), options);
        }
        if engine.options().rules != due.rules {
            engine.set_rules(due.rules);
        }
        if due.whole {
            engine.forget();
        }
        let told = Arc::clone(job);
        let options = engine.options_mut();
        options.cancel = job.cancel.clone();
        options.progress = Some(Arc::new(move |progress: &Progress| {
            told.progress(progress.done, progress.total, &progress.name);
        }));
        // Threads of its own: a solve without end must not hold up pictures, or other definitions. Calls go first.
        let pool = rayon::ThreadPoolBuilder::new()
            .thread_name(|_| "solver".to_owned())
            .start_handler(|_| katydid_priority::lower())
            .build();
        let summary = match &pool {
            Ok(pool) => pool.install(|| engine.solve()),
            Err(_) => engine.solve(),
        };
        engine.options_mut().progress = None;
        let cancelled = job.cancel.is_cancelled() && summary.unfinished > 0;
        *lock(&self.results) = Solved { engine: Arc::new(engine), revision: Some(due.revision) };
        let state = if cancelled { State::Cancelled } else { State::Done };
        job.end(state, summary.solved, summary.unfinished);
    }

    /// Gives up the solve that runs.
    pub(crate) fn give_up(&self) {
        if let Some(job) = self.job() {
            job.cancel.cancel();
        }
    }

    /// How far the results are behind the document.
    pub(crate) fn standing(&self) -> Value {
        let solved = self.solved();
        let revision = self.editor().revision();
        let current = solved.revision == Some(revision) && solved.engine.dirty().is_empty();
        let mut told =
            json!({ "revision": revision, "solved_revision": solved.revision, "current": current });
        if let Some(job) = self.job().filter(|job| job.is_running()) {
            told["running_job"] = json!(job.number);
        } else if !current {
            told["note"] = json!("the results are not those of the definition as it stands: call solve");
        }
        told
    }

    /// How the objects came out, and the first of those that did not come out well.
    pub(crate) fn outcome(&self) -> Value {
        let solved = self.solved();
        let document = solved.engine.document();
        let labels = kd::labels(document);
        let mut counts = [0_usize; 6];
        let mut failed = Vec::new();
        for (index, object) in document.objects.iter().enumerate() {
            let Some(report) = solved.engine.report(index).filter(|_| !object.is_annotation()) else {
                continue;
            };
            if let Some(count) = counts.get_mut(report.status as usize) {
                *count += 1;
            }
            if matches!(report.status, Status::Error | Status::Warning | Status::Unsupported) {
                let text = report.messages.first().map_or("", |message| message.text.as_str());
                let first = report.status != Status::Warning;
                failed.push((
                    !first,
                    json!({
                        "object": labels.get(index),
                        "id": object.id,
                        "component": object.name,
                        "status": report.status.word(),
                        "message": cut(text),
                    }),
                ));
            }
        }
        // Errors before warnings, each in the order of the document.
        failed.sort_by_key(|(later, _)| *later);
        let total = failed.len();
        let failed: Vec<Value> = failed.into_iter().take(MOST_FAILED).map(|(_, told)| told).collect();
        let [ok, warnings, errors, disabled, unsupported, no_data] = counts;
        let mut told = json!({
            "objects": { "ok": ok, "warning": warnings, "error": errors, "disabled": disabled,
                         "unsupported": unsupported, "no_data": no_data },
            "problems": failed,
        });
        if total > MOST_FAILED {
            told["more_problems"] = json!(total - MOST_FAILED);
        }
        told
    }

    /// The definition as text, as it stands. What is made of it is kept until the definition changes.
    pub(crate) fn text(&self) -> Arc<Text> {
        let document = self.document();
        let mut kept = lock(&self.text);
        if let Some(text) = kept.as_ref().filter(|text| text.is_of(&document)) {
            return Arc::clone(text);
        }
        let text = Arc::new(Text::new(document));
        *kept = Some(Arc::clone(&text));
        text
    }

    /// Has the text of the document as it stands written, on a thread of its own, where nobody has asked for it yet: what was
    /// opened or edited is mostly read or edited as text next. One thread at a time, which goes on to the newest state.
    pub(crate) fn write_ahead(self: &Arc<Self>) {
        let document = self.document();
        if lock(&self.text).as_ref().is_some_and(|text| text.is_of(&document))
            || self.writing.swap(true, Ordering::AcqRel)
        {
            return;
        }
        let own = Arc::clone(self);
        let begun = std::thread::Builder::new().name("text".to_owned()).spawn(move || {
            loop {
                let text = own.text();
                // A text that cannot be written is told to whoever asks for it.
                let made = catch_unwind(AssertUnwindSafe(|| text.again().is_some()));
                own.writing.store(false, Ordering::Release);
                let newest = text.is_of(&own.document());
                if made.is_err() || newest || own.writing.swap(true, Ordering::AcqRel) {
                    return;
                }
            }
        });
        if begun.is_err() {
            // Without a thread the text is written when it is asked for.
            self.writing.store(false, Ordering::Release);
        }
    }
}

/// What is to be solved.
struct Due {
    document: Arc<Document>,
    revision: u64,
    rules: katydid_data::cast::Rules,
    /// Everything, whether it has changed or not.
    whole: bool,
}

/// The limits of a solve that may take so long and so much.
pub(crate) fn limits(seconds: f64, bytes: u64) -> Limits {
    let time = std::time::Duration::try_from_secs_f64(seconds).ok();
    Limits { time, ..Limits::default() }.with_bytes(bytes)
}

/// A text no longer than a line of an answer.
pub(crate) fn cut(text: &str) -> String {
    match text.char_indices().nth(LONGEST_LINE) {
        Some((at, _)) => format!("{}…", text.get(..at).unwrap_or_default()),
        None => text.to_owned(),
    }
}
