//! The thread that solves a document.
//!
//! It has an engine of its own and follows the editor by differences. What it is told waits in line; of several requests
//! to solve only the last counts. All it finds it tells the document's own thread.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender};
use std::time::{Duration, Instant};

use katydid_component::{Cancel, RhinoModel};
use katydid_definition::document::{Difference, Document, Object, ids};
use katydid_session::Change;
use katydid_session::display::{ModelPreview, Preview, encode_model};
use katydid_session::protocol::{AnalysisView, Probe};
use katydid_solver::{Engine, Finished, ObjectReport, Options, Scripts};
use katydid_studio::{Analyses, Drafts, Finding, touched};
use uuid::Uuid;

use super::{ClientId, Command, Inquiry};

/// What the worker is told.
pub(crate) enum Job {
    /// The document has changed.
    Change(Box<Change>),
    /// A button is held, or was let go.
    Press(Difference),
    /// A particle of a solver is dragged, or was let go.
    Drag(Difference),
    /// The Rhino model that parameters refer to is another, or there is none any more.
    Model(Option<Arc<RhinoModel>>),
    /// What runs scripts from now on; those of the document are solved anew.
    Scripts(Arc<dyn Scripts>),
    /// Everything is to be solved again.
    Forget,
    /// Whether things are being dragged.
    Draft(bool),
    /// What a client wants to see of the form of curves and surfaces.
    Analyse(ClientId, Option<AnalysisView>),
    /// The places that a client asks about, and the number of its question.
    Probe(ClientId, u32, Vec<Probe>),
    /// A client is gone.
    Leave(ClientId),
    /// Something to be done with the results.
    With(Inquiry),
    /// Solve and draw what is due, unless somebody cancels.
    Solve(u64, Cancel),
    /// Only draw what is due.
    Draw(u64, Cancel),
}

/// What the worker tells.
pub(crate) enum News {
    /// A solve begins, of that number: so many objects.
    Began(u64, usize),
    /// An object is done.
    Finished(Box<(Object, ObjectReport)>),
    /// A solve has ended.
    Ended(Ended),
    /// Geometry, and whether it is as coarse as it may be.
    Drawn(u64, bool, Vec<Preview>),
    /// The Rhino model as it is shown.
    Modelled(ModelPreview),
    /// What a client wanted to see.
    Found(u64, ClientId, Finding),
    /// Nothing is left to do.
    Idle,
    /// Something failed that must not.
    Failed(&'static str),
}

/// How a solve ended.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ended {
    pub(crate) cancelled: bool,
    pub(crate) took: Duration,
    /// How many objects are still to be solved.
    pub(crate) unfinished: usize,
}

/// Owns the engine.
pub(super) struct Worker {
    engine: Engine,
    drafts: Drafts,
    /// Whether the Rhino model is yet to be shown.
    is_model_due: bool,
    analyses: Analyses,
    news: Sender<Command>,
    /// Threads of its own: a solve without end must not hold up other documents.
    pool: Option<rayon::ThreadPool>,
}

impl Worker {
    /// For a document as it is now.
    pub(super) fn new(document: Document, options: Options, news: Sender<Command>) -> Self {
        let mut drafts = Drafts::default();
        drafts.touch_all(&document);
        // Where no more threads are to be had, all documents share those that are there.
        let pool = rayon::ThreadPoolBuilder::new().thread_name(|_| "solver".to_owned()).build().ok();
        let analyses = Analyses::default();
        let is_model_due = options.model.is_some();
        Self { engine: Engine::new(document, options), drafts, is_model_due, analyses, news, pool }
    }

    /// Works until nobody can tell it anything any more.
    pub(super) fn run(mut self, jobs: &Receiver<Job>) {
        while let Ok(first) = jobs.recv() {
            let mut work = None;
            for job in std::iter::once(first).chain(std::iter::from_fn(|| jobs.try_recv().ok())) {
                match job {
                    Job::Solve(solution, cancel) => work = Some((solution, cancel, true)),
                    Job::Draw(solution, cancel) => {
                        work = match work {
                            Some((_, _, true)) => work,
                            _ => Some((solution, cancel, false)),
                        };
                    }
                    other => self.prepare(other),
                }
            }
            if let Some((solution, cancel, solves)) = work {
                if solves {
                    self.solve(solution, &cancel);
                }
                self.draw(solution, &cancel);
                self.show_model(&cancel);
                self.look(solution, &cancel);
                self.tell(News::Idle);
            }
        }
    }

    fn tell(&self, news: News) {
        // Who is gone need not be told.
        let _ = self.news.send(Command::Work(news));
    }

    fn prepare(&mut self, job: Job) {
        match job {
            Job::Change(change) => self.follow(&change),
            // One that does not fit is of a button that is gone.
            Job::Press(difference) => drop(self.engine.apply(&difference)),
            // Each solve goes on from the one before, though the hand may rest.
            Job::Drag(difference) => {
                if self.engine.apply(&difference).is_ok() {
                    difference.put.iter().for_each(|(at, _)| self.engine.expire(*at));
                }
            }
            Job::Model(model) => {
                self.is_model_due = model.is_some();
                self.engine.options_mut().model = model;
                self.engine.forget();
            }
            Job::Scripts(scripts) => {
                self.engine.options_mut().scripts = Some(scripts);
                let objects = self.engine.document().objects.iter().enumerate();
                // Scripts stand in clusters too.
                let due: Vec<usize> = objects
                    .filter(|(_, object)| object.script().is_some() || object.component == ids::CLUSTER)
                    .map(|(at, _)| at)
                    .collect();
                due.into_iter().for_each(|at| self.engine.expire(at));
            }
            Job::Forget => self.engine.forget(),
            Job::Draft(is_draft) => {
                self.drafts.set_draft(is_draft);
                self.analyses.set_draft(is_draft);
            }
            Job::Analyse(client, analysis) => {
                self.analyses.analyse(client, analysis);
                self.drafts.set_colours(self.analyses.has_colours());
            }
            Job::Probe(client, round, probes) => self.analyses.probe(client, round, probes),
            Job::Leave(client) => {
                self.analyses.leave(client);
                self.drafts.set_colours(self.analyses.has_colours());
            }
            Job::With(inquiry) => {
                if catch_unwind(AssertUnwindSafe(|| inquiry(&self.engine))).is_err() {
                    self.tell(News::Failed("A file could not be made"));
                }
            }
            Job::Solve(..) | Job::Draw(..) => {}
        }
    }

    fn follow(&mut self, change: &Change) {
        let touched = touched(&change.difference, &change.before);
        if change.bring_to(&mut self.engine).is_err() {
            // It cannot have missed a change; if it has, it begins anew.
            let options = self.engine.options().clone();
            self.engine = Engine::new(Document::clone(&change.after), options);
            self.drafts.touch_all(&change.after);
            self.analyses.touch_all();
        }
        self.analyses.touch(&touched);
        self.drafts.touch(touched);
    }

    fn solve(&mut self, solution: u64, cancel: &Cancel) {
        let due: Vec<Uuid> = {
            let objects = &self.engine.document().objects;
            self.engine.dirty().iter().filter_map(|at| objects.get(*at)).map(|object| object.id).collect()
        };
        self.drafts.touch(due.iter().copied());
        self.analyses.touch(&due);
        self.tell(News::Began(solution, due.len()));
        let news = self.news.clone();
        let options = self.engine.options_mut();
        options.cancel = cancel.clone();
        options.finished = Some(Arc::new(move |finished: &Finished<'_>| {
            let done = Box::new((finished.object.clone(), finished.report.clone()));
            let _ = news.send(Command::Work(News::Finished(done)));
        }));
        let start = Instant::now();
        let (pool, engine) = (&self.pool, &mut self.engine);
        let solved = catch_unwind(AssertUnwindSafe(|| inside(pool.as_ref(), || engine.solve())));
        self.engine.options_mut().finished = None;
        if solved.is_err() {
            self.tell(News::Failed("The solution failed"));
            self.engine.forget();
        }
        let unfinished = solved.map_or(0, |summary| summary.unfinished);
        let cancelled = cancel.is_cancelled() && unfinished > 0;
        self.tell(News::Ended(Ended { cancelled, took: start.elapsed(), unfinished }));
    }

    fn draw(&mut self, solution: u64, cancel: &Cancel) {
        if !self.drafts.is_due() {
            return;
        }
        let go_on = || !cancel.is_cancelled();
        let (pool, engine, drafts) = (&self.pool, &self.engine, &mut self.drafts);
        let drawn = catch_unwind(AssertUnwindSafe(|| inside(pool.as_ref(), || drafts.draw(engine, go_on))));
        match drawn {
            Ok(previews) => self.tell(News::Drawn(solution, self.drafts.is_draft(), previews)),
            Err(_) => self.tell(News::Failed("The geometry could not be drawn")),
        }
    }

    /// Shows the Rhino model; where somebody cancels it is due again with the next work.
    fn show_model(&mut self, cancel: &Cancel) {
        let options = self.engine.options();
        let Some(model) = options.model.as_ref().filter(|_| self.is_model_due) else { return };
        let go_on = || !cancel.is_cancelled();
        let shown = catch_unwind(AssertUnwindSafe(|| {
            inside(self.pool.as_ref(), || encode_model(model, &options.rules, go_on))
        }));
        self.is_model_due = matches!(shown, Ok(None));
        match shown {
            Ok(shown) => shown.into_iter().for_each(|preview| self.tell(News::Modelled(preview))),
            Err(_) => self.tell(News::Failed("The model could not be drawn")),
        }
    }

    fn look(&mut self, solution: u64, cancel: &Cancel) {
        if !self.analyses.is_due() {
            return;
        }
        let go_on = || !cancel.is_cancelled();
        let (pool, engine, analyses) = (&self.pool, &self.engine, &mut self.analyses);
        let found = catch_unwind(AssertUnwindSafe(|| inside(pool.as_ref(), || analyses.look(engine, go_on))));
        match found {
            Ok(findings) => {
                findings
                    .into_iter()
                    .for_each(|(client, found)| self.tell(News::Found(solution, client, found)));
            }
            Err(_) => self.tell(News::Failed("The analysis could not be made")),
        }
    }
}

fn inside<T: Send>(pool: Option<&rayon::ThreadPool>, work: impl FnOnce() -> T + Send) -> T {
    match pool {
        Some(pool) => pool.install(work),
        None => work(),
    }
}
