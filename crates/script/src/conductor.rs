//! One thread that runs all Python components of a document, one after the other, in one process.
//!
//! It is a thread of its own, with a pool of its own for what the kernel does in parallel: a thread of the solver's pool
//! that waited in here could be given another script's turn, and wait for itself.

use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use katydid_component::{Cancel, Limits, Message};
use katydid_definition::document::ScriptLanguage;
use katydid_members::{Host, Value, codec};
use katydid_solver::{ScriptDone, ScriptMaker, ScriptTask, Scripts, Unrun};

use crate::from_script::Outward;
use crate::interpreter::Interpreter;
use crate::keeper::Keepers;
use crate::outputs;
use crate::process::{Bounds, Heard, Process};
use crate::reply::Reply;
use crate::task::Prepared;
use crate::to_script::Inward;

/// How long a script has after it was interrupted, before its process is ended.
const GRACE: Duration = Duration::from_secs(2);
/// How many processes were started: an object that one holds is not taken for another's.
static STARTED: AtomicU64 = AtomicU64::new(0);
/// How often one looks whether a script may go on.
const LOOK: Duration = Duration::from_millis(20);

/// Runs the Python components of one document, in one process that stays warm.
#[derive(Debug)]
pub struct Python {
    interpreter: Result<Interpreter, String>,
    bounds: Bounds,
    /// Where the definition lies, which scripts ask.
    definition: Option<PathBuf>,
    /// How many processes have ended before their time.
    losses: Arc<AtomicU64>,
    /// The way to the thread, which the first script starts.
    jobs: OnceLock<Mutex<Sender<Job>>>,
}

/// A script's turn on its way to the thread.
#[derive(Debug)]
struct Job {
    prepared: Prepared,
    limits: Limits,
    cancel: Cancel,
    end: Option<Instant>,
    done: SyncSender<Result<ScriptDone, Unrun>>,
}

impl Python {
    /// Runs scripts with an interpreter, or says why there is none when the first script comes.
    pub fn new(interpreter: Result<Interpreter, String>, bounds: Bounds) -> Self {
        Self { interpreter, bounds, definition: None, losses: Arc::default(), jobs: OnceLock::new() }
    }

    /// Tells scripts where their definition lies (`ghdoc.Path`).
    #[must_use]
    pub fn of(self, definition: Option<PathBuf>) -> Self {
        Self { definition, ..self }
    }

    fn jobs(&self) -> &Mutex<Sender<Job>> {
        self.jobs.get_or_init(|| {
            let (jobs, waiting) = channel();
            let (interpreter, bounds) = (self.interpreter.clone(), self.bounds.clone());
            let losses = self.losses.clone();
            let conductor = Conductor { interpreter, bounds, losses, running: None };
            thread::spawn(move || conductor.conduct(&waiting));
            Mutex::new(jobs)
        })
    }
}

/// Makes what runs the Python components of each of many documents, a process each.
#[derive(Debug, Clone)]
pub struct PythonMaker {
    /// What they run with, or why there is nothing.
    pub interpreter: Result<Interpreter, String>,
    /// What each process may use.
    pub bounds: Bounds,
    /// Where the one definition lies that it is for; none for those that were sent.
    pub definition: Option<PathBuf>,
}

impl ScriptMaker for PythonMaker {
    fn make(&self) -> Arc<dyn Scripts> {
        let python = Python::new(self.interpreter.clone(), self.bounds.clone());
        Arc::new(python.of(self.definition.clone()))
    }
}

impl Scripts for Python {
    fn runs(&self, language: &ScriptLanguage) -> bool {
        matches!(language, ScriptLanguage::Python3 | ScriptLanguage::IronPython)
    }

    fn losses(&self) -> u64 {
        self.losses.load(Ordering::Acquire)
    }

    fn another(&self) -> Option<Arc<dyn Scripts>> {
        let another = Self::new(self.interpreter.clone(), self.bounds.clone());
        Some(Arc::new(another.of(self.definition.clone())))
    }

    fn run(&self, task: &ScriptTask<'_>) -> Result<ScriptDone, Unrun> {
        let prepared = Prepared::of(task, self.definition.as_deref());
        task.budget.fits(prepared.iterations()).map_err(Unrun::Failed)?;
        let (done, result) = sync_channel(1);
        let end = task.limits.time.and_then(|time| Instant::now().checked_add(time));
        let job = Job { prepared, limits: task.limits, cancel: task.cancel.clone(), end, done };
        let gone = || Unrun::Failed(Message::error("What runs scripts has ended"));
        self.jobs().lock().unwrap_or_else(PoisonError::into_inner).send(job).map_err(|_| gone())?;
        // The thread looks at the time and the cancel itself, and always answers.
        result.recv().map_err(|_| gone())?
    }
}

/// A process with what it holds.
#[derive(Debug)]
struct Running {
    process: Process,
    host: Host,
    keepers: Keepers,
}

#[derive(Debug)]
struct Conductor {
    interpreter: Result<Interpreter, String>,
    bounds: Bounds,
    losses: Arc<AtomicU64>,
    running: Option<Running>,
}

impl Conductor {
    fn conduct(mut self, jobs: &Receiver<Job>) {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().ok();
        while let Ok(job) = jobs.recv() {
            let outcome = self.perform(&job, pool.as_ref());
            let _ = job.done.send(outcome);
        }
        if let Some(running) = &mut self.running {
            running.process.kill();
        }
    }

    /// The running process; it is started when there is none.
    fn running(&mut self, job: &Job) -> Result<&mut Running, Unrun> {
        if self.running.is_none() {
            let interpreter = self.interpreter.as_ref().map_err(|why| Unrun::Unsupported(why.clone()))?;
            let process = Process::start(interpreter, &self.bounds).map_err(Unrun::Unsupported)?;
            let keepers = Keepers::new(STARTED.fetch_add(1, Ordering::Relaxed) + 1);
            self.running = Some(Running { process, host: crate::host(job.prepared.rules), keepers });
        }
        self.running.as_mut().ok_or_else(|| Unrun::Unsupported("there is no process".into()))
    }

    fn perform(&mut self, job: &Job, pool: Option<&rayon::ThreadPool>) -> Result<ScriptDone, Unrun> {
        if job.cancel.is_cancelled() {
            return Err(stopped(job));
        }
        if self.running.as_mut().is_some_and(|running| running.process.has_ended()) {
            self.lose();
        }
        let running = self.running(job)?;
        let outcome = running.perform(job, pool);
        if matches!(outcome, Err(Failure::Ended(_))) {
            self.lose();
        }
        outcome.map_err(|failure| match failure {
            Failure::Ended(message) | Failure::Alive(message) => Unrun::Failed(message),
        })
    }
}

impl Conductor {
    /// The process has ended: what it held is lost.
    fn lose(&mut self) {
        self.running = None;
        self.losses.fetch_add(1, Ordering::Release);
    }
}

/// Why a run gave nothing, and whether its process is still there.
#[derive(Debug)]
enum Failure {
    Alive(Message),
    Ended(Message),
}

impl Job {
    fn may_go_on(&self) -> bool {
        !self.cancel.is_cancelled() && self.end.is_none_or(|end| Instant::now() < end)
    }
}

fn stopped(job: &Job) -> Unrun {
    Unrun::Failed(why_stopped(job))
}

fn why_stopped(job: &Job) -> Message {
    Message::error(if job.cancel.is_cancelled() {
        "The script was cancelled"
    } else {
        "The script was ended: the time limit is over"
    })
}

impl Running {
    fn perform(&mut self, job: &Job, pool: Option<&rayon::ThreadPool>) -> Result<ScriptDone, Failure> {
        let gone = self.keepers.take_gone();
        if !gone.is_empty() {
            let gone = gone.iter().filter_map(|number| i64::try_from(*number).ok()).collect();
            self.say(job, &Value::map([("forget", Value::Ints(gone))]))?;
        }
        let mut inward =
            Inward { rules: &job.prepared.rules, process: self.keepers.process(), lost: Vec::new() };
        let message = job.prepared.message(&mut inward);
        let mut lost = inward.lost;
        self.say(job, &message)?;
        let reply = self.listen(job, pool)?;
        if reply.was_cancelled {
            return Err(Failure::Alive(why_stopped(job)));
        }
        let mut outward = Outward { keepers: &self.keepers, texts: &reply.texts, lost: Vec::new() };
        let outputs = outputs::trees(&job.prepared, &reply, &mut outward);
        lost.extend(outward.lost);
        let warnings = lost.into_iter().map(Message::warning);
        let messages = warnings.chain(reply.messages).collect();
        Ok(ScriptDone { outputs, messages })
    }

    fn say(&mut self, job: &Job, value: &Value) -> Result<(), Failure> {
        let bytes = self.host.encode(value).map_err(|fault| Failure::Alive(Message::error(fault.message)))?;
        if bytes.len() > codec::LARGEST {
            let text = format!("{} bytes are more than a script can be given", bytes.len());
            return Err(Failure::Alive(Message::error(text)));
        }
        if self.process.send(bytes, || job.may_go_on()) {
            return Ok(());
        }
        if !job.may_go_on() {
            self.process.kill();
            return Err(Failure::Ended(why_stopped(job)));
        }
        Err(self.lost())
    }

    /// Answers what the script calls until it is done.
    fn listen(&mut self, job: &Job, pool: Option<&rayon::ThreadPool>) -> Result<Reply, Failure> {
        let mut interrupted: Option<Instant> = None;
        loop {
            match self.process.hear(LOOK) {
                Heard::Ended(_) if interrupted.is_some() => return Err(Failure::Ended(why_stopped(job))),
                Heard::Ended(how) => return Err(ended(&how)),
                Heard::Nothing => {}
                Heard::Message(bytes) => {
                    let message = match self.host.decode(&bytes) {
                        Ok(message) => message,
                        Err(error) => Value::Error("argument".into(), error.to_string()),
                    };
                    if let Some(reply) = Reply::read(&message) {
                        return Ok(reply);
                    }
                    self.answer(job, message, pool)?;
                }
            }
            match interrupted {
                None if !job.may_go_on() => {
                    self.process.interrupt();
                    interrupted = Some(Instant::now());
                }
                Some(since) if since.elapsed() > GRACE => {
                    self.process.kill();
                    return Err(Failure::Ended(why_stopped(job)));
                }
                _ => {}
            }
        }
    }

    fn answer(&mut self, job: &Job, message: Value, pool: Option<&rayon::ThreadPool>) -> Result<(), Failure> {
        let time = job.end.map(|end| end.saturating_duration_since(Instant::now()));
        self.host.bound(Limits { time, ..job.limits }, job.cancel.clone());
        let host = &mut self.host;
        let answer = match pool {
            Some(pool) => pool.install(|| host.respond_to(message)),
            None => host.respond_to(message),
        };
        let Some(answer) = answer else { return Ok(()) };
        // An answer that nobody reads must not keep one here: a script that was stopped is interrupted next.
        if self.process.send(answer, || job.may_go_on()) || !job.may_go_on() {
            return Ok(());
        }
        Err(self.lost())
    }

    /// The process took nothing more: how it ended.
    fn lost(&mut self) -> Failure {
        match self.process.hear(GRACE) {
            Heard::Ended(how) => ended(&how),
            _ => ended("it reads nothing"),
        }
    }
}

fn ended(how: &str) -> Failure {
    let text =
        format!("The Python process ended while this script ran ({how}); the next script starts another one");
    Failure::Ended(Message::error(text))
}
