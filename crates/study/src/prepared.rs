//! A definition made ready to be solved at many points.

use std::sync::{Arc, Mutex};
use std::time::Duration;

use katydid_component::{Cancel, Level};
use katydid_definition::document::Document;
use katydid_solver::{self as solver, Engine, Options, Scripts};
use web_time::Instant;

use crate::lock::locked;
use crate::{Cell, Output, Variable};

/// How a point came out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Status {
    /// Every object ran.
    Ok = 0,
    /// Some object had a warning.
    Warning = 1,
    /// Some object had an error.
    Error = 2,
    /// An input does not take its value; nothing was solved.
    Refused = 3,
    /// The time of a point was over.
    Time = 4,
    /// The memory of a point was not enough.
    Memory = 5,
    /// An output is NaN or infinite.
    NotFinite = 6,
    /// An output has no data.
    NoData = 7,
    /// The point's picture or geometry could not be made or written.
    NoFile = 8,
    /// What solved it ended or hung each time.
    Lost = 9,
}

impl Status {
    const ALL: [Self; 10] = [
        Self::Ok,
        Self::Warning,
        Self::Error,
        Self::Refused,
        Self::Time,
        Self::Memory,
        Self::NotFinite,
        Self::NoData,
        Self::NoFile,
        Self::Lost,
    ];

    /// The word for it in tables.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Warning => "warning",
            Self::Error => "error",
            Self::Refused => "refused",
            Self::Time => "time",
            Self::Memory => "memory",
            Self::NotFinite => "not-finite",
            Self::NoData => "no-data",
            Self::NoFile => "no-file",
            Self::Lost => "lost",
        }
    }

    /// Whether the row has results that can be used.
    pub const fn is_good(self) -> bool {
        matches!(self, Self::Ok | Self::Warning)
    }

    /// The status of that word.
    pub fn of_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|status| status.word() == word)
    }

    pub(crate) fn of_byte(byte: u8) -> Option<Self> {
        Self::ALL.get(usize::from(byte)).copied()
    }
}

/// What a point gave.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// How it came out.
    pub status: Status,
    /// Why, where it did not come out well.
    pub reason: String,
    /// The outputs.
    pub cells: Vec<Cell>,
    /// How long the solve took.
    pub time: Duration,
}

/// A definition with its variables and outputs found, and everything solved that does not hang on the variables.
#[derive(Debug, Clone)]
pub struct Prepared {
    engine: Engine,
    variables: Vec<Variable>,
    outputs: Vec<Output>,
    /// What runs scripts and has no worker now: processes that are started once, not once for each worker.
    idle: Arc<Mutex<Vec<Arc<dyn Scripts>>>>,
}

impl Prepared {
    /// Prepares a definition. The time and memory of the options are those of each point.
    pub fn new(document: Document, options: Options, variables: Vec<Variable>, outputs: Vec<Output>) -> Self {
        let options = Options { progress: None, finished: None, ..options };
        Self::solved(Engine::new(document, options), variables, outputs)
    }

    /// Prepares a definition that an engine has solved already, so that nothing is solved twice. The time and memory of the
    /// engine's options are those of each point, and `cancel` stops them.
    pub fn of_engine(
        mut engine: Engine,
        cancel: Cancel,
        variables: Vec<Variable>,
        outputs: Vec<Output>,
    ) -> Self {
        let options = engine.options_mut();
        (options.progress, options.finished, options.cancel) = (None, None, cancel);
        Self::solved(engine, variables, outputs)
    }

    fn solved(mut engine: Engine, variables: Vec<Variable>, outputs: Vec<Output>) -> Self {
        engine.solve();
        let idle = Arc::new(Mutex::new(engine.options().scripts.iter().cloned().collect()));
        Self { engine, variables, outputs, idle }
    }

    /// The variables.
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// The outputs.
    pub fn outputs(&self) -> &[Output] {
        &self.outputs
    }

    /// What stops the solves of its workers from outside.
    pub fn set_cancel(&mut self, cancel: Cancel) {
        self.engine.options_mut().cancel = cancel;
    }

    /// The engine with the results at the document's own values.
    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    /// What solves points: a clone that keeps from one point to the next what did not change. Its scripts wait for no other
    /// worker's.
    pub fn worker(&self) -> Worker<'_> {
        self.take_up(None)
    }

    /// A worker that goes on where another left; a new one where none did.
    pub(crate) fn take_up(&self, left: Option<Left>) -> Worker<'_> {
        let Left { engine, scripts, set } = left.unwrap_or_else(|| self.begin());
        Worker { prepared: self, engine, scripts, set }
    }

    fn begin(&self) -> Left {
        let free = locked(&self.idle).pop();
        let known = self.engine.options().scripts.as_ref();
        let own = free.or_else(|| known.and_then(|scripts| scripts.another()));
        let scripts = OwnScripts { own, idle: self.idle.clone() };
        Left { engine: self.fresh(&scripts), scripts, set: vec![None; self.variables.len()] }
    }

    /// A clone of the engine that runs its scripts by these.
    fn fresh(&self, scripts: &OwnScripts) -> Engine {
        let mut engine = self.engine.clone();
        if let Some(own) = &scripts.own {
            engine.run_scripts_by(own.clone());
        }
        engine
    }
}

/// What runs the scripts of one worker and of no other; nothing where all share one. It is free for another at its end.
#[derive(Debug)]
struct OwnScripts {
    own: Option<Arc<dyn Scripts>>,
    idle: Arc<Mutex<Vec<Arc<dyn Scripts>>>>,
}

impl Drop for OwnScripts {
    fn drop(&mut self) {
        locked(&self.idle).extend(self.own.take());
    }
}

/// What a worker keeps from one point to the next.
#[derive(Debug)]
pub(crate) struct Left {
    engine: Engine,
    scripts: OwnScripts,
    set: Vec<Option<Cell>>,
}

/// Solves points of a prepared definition, one after another.
#[derive(Debug)]
pub struct Worker<'a> {
    prepared: &'a Prepared,
    engine: Engine,
    scripts: OwnScripts,
    /// What the variables are set to.
    set: Vec<Option<Cell>>,
}

impl Worker<'_> {
    /// Solves a point, which has a cell for each variable.
    pub fn solve(&mut self, point: &[Cell]) -> Outcome {
        let start = Instant::now();
        for ((variable, cell), set) in self.prepared.variables.iter().zip(point).zip(&mut self.set) {
            if set.as_ref() == Some(cell) {
                continue;
            }
            *set = None;
            let mut result = Ok(());
            self.engine.edit(variable.object, |object| result = variable.set(object, cell));
            if let Err(error) = result {
                let cells = vec![Cell::Null; self.prepared.outputs.len()];
                return Outcome {
                    status: Status::Refused,
                    reason: first_line(error.to_string()),
                    cells,
                    time: start.elapsed(),
                };
            }
            *set = Some(cell.clone());
        }
        self.engine.solve();
        self.read(start)
    }

    /// Leaves what it has for another to go on with.
    pub(crate) fn leave(self) -> Left {
        Left { engine: self.engine, scripts: self.scripts, set: self.set }
    }

    /// The engine as the last point left it.
    pub fn engine(&self) -> &Engine {
        &self.engine
    }

    fn read(&mut self, start: Instant) -> Outcome {
        let cells: Vec<Cell> = self.prepared.outputs.iter().map(|output| output.cell(&self.engine)).collect();
        let time = start.elapsed();
        let limits = self.engine.options().limits;
        let (mut status, mut reason) = self.state();
        if status == Status::Error {
            if limits.time.is_some_and(|limit| time >= limit) {
                status = Status::Time;
            } else if reason.contains("raise the memory limit") {
                status = Status::Memory;
            }
        }
        for (output, cell) in self.prepared.outputs.iter().zip(&cells) {
            let found = match cell {
                Cell::Number(x) if !x.is_finite() => (Status::NotFinite, format!("'{}' is {x}", output.name)),
                Cell::Null => {
                    let why = output.message(&self.engine).map(|message| format!(": {}", message.text));
                    (Status::NoData, format!("'{}' has no data{}", output.name, why.unwrap_or_default()))
                }
                _ => continue,
            };
            if status.is_good() {
                (status, reason) = found;
            }
        }
        if matches!(status, Status::Error | Status::Time | Status::Memory) {
            // What was stopped half-way is not kept for the next point.
            self.engine = self.prepared.fresh(&self.scripts);
            self.set.fill(None);
        }
        Outcome { status, reason: first_line(reason), cells, time }
    }

    /// The worst that any object says, and who says it first in the order of the document.
    fn state(&self) -> (Status, String) {
        let mut worst = (Status::Ok, String::new());
        for (index, object) in self.engine.document().objects.iter().enumerate() {
            let Some(report) = self.engine.report(index) else { continue };
            let (status, level) = match report.status {
                solver::Status::Error => (Status::Error, Level::Error),
                solver::Status::Warning | solver::Status::Unsupported | solver::Status::NoData => {
                    (Status::Warning, Level::Warning)
                }
                solver::Status::Ok | solver::Status::Disabled => continue,
            };
            if status as u8 > worst.0 as u8 {
                let said =
                    report.messages.iter().find(|message| message.level == level).or(report.messages.first());
                let text = said.map_or(report.status.word(), |message| &message.text);
                worst = (status, format!("{}: {text}", object.title()));
                if status == Status::Error {
                    break;
                }
            }
        }
        worst
    }
}

/// A row of a table is a line: a message that shows its place in a formula does so below its first line.
fn first_line(mut text: String) -> String {
    if let Some(end) = text.find(['\n', '\r']) {
        text.truncate(end);
    }
    text
}
