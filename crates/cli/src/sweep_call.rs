//! What `katydid sweep` is called with, opened.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::Parser;
use katydid_component::Cancel;
use katydid_definition::document::Document;
use katydid_solver::Options;
use katydid_study::thresholds::POINT_TIME;
use katydid_study::{PlanFile, Settings};

use crate::open;
use crate::sweep::{SweepArgs, definition_file, identity};

/// A definition, the plan and the folder of its study, as the words of `katydid sweep` name them: the same study for the command,
/// for Python, and for whoever solves points on another machine.
#[derive(Debug)]
pub struct SweepCall {
    /// The definition with its inputs set.
    pub document: Document,
    /// How it is solved.
    pub options: Options,
    /// The plan, not bound yet.
    pub plan: PlanFile,
    /// The workers, what the results hang on, and what stops the study.
    pub settings: Settings,
    /// The folder of the study.
    pub folder: PathBuf,
    /// The files that it was opened from.
    pub files: CallFiles,
}

/// The files that the words of a sweep name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CallFiles {
    /// The definition.
    pub definition: PathBuf,
    /// The Rhino model.
    pub model: Option<PathBuf>,
    /// The plan.
    pub plan: PathBuf,
}

#[derive(Debug, Parser)]
#[command(name = "katydid sweep")]
struct Words {
    #[command(flatten)]
    sweep: SweepArgs,
}

impl SweepCall {
    /// Opens what the words after `katydid sweep` name; `--ray` is not among them. On another machine `files` says where the
    /// files lie there.
    ///
    /// # Errors
    /// A word is wrong, or a file cannot be read, in words.
    pub fn open(words: Vec<OsString>, files: Option<CallFiles>) -> Result<Self, String> {
        let words = std::iter::once("katydid sweep".into()).chain(words);
        let Words { mut sweep } = Words::try_parse_from(words).map_err(|error| error.to_string())?;
        if sweep.ray.is_some() {
            return Err("--ray: a study that is opened says itself where it is solved".to_owned());
        }
        if let Some(CallFiles { definition, model, plan }) = files {
            (sweep.definition.file, sweep.definition.model, sweep.plan) = (definition, model, plan);
        }
        Self::of(&sweep)
    }

    pub(crate) fn of(args: &SweepArgs) -> Result<Self, String> {
        if args.definition.ticks.is_some() {
            return Err("--ticks: a sweep solves each point once; runs in time are not supported".to_owned());
        }
        if args.workers == Some(0) {
            return Err("--workers must be at least 1".to_owned());
        }
        let plan = PlanFile::read(&args.plan).map_err(|error| error.to_string())?;
        let mut session = open::session(&args.definition)?;
        let options = session.options_mut();
        options.progress = None;
        options.limits.time = options.limits.time.or(Some(POINT_TIME));
        if let Some(bytes) = args.limit_bytes {
            options.limits = options.limits.with_bytes(bytes);
        }
        let options = options.clone();
        let processors = std::thread::available_parallelism().map_or(1, usize::from);
        let settings = Settings {
            workers: args.workers.unwrap_or(processors),
            retry: args.retry,
            identity: identity(&args.definition)?,
            definition: definition_file(&args.definition),
            grace: None,
            cancel: Cancel::default(),
        };
        let files = CallFiles {
            definition: args.definition.file.clone(),
            model: args.definition.model.clone(),
            plan: args.plan.clone(),
        };
        Ok(Self {
            document: session.document().clone(),
            options,
            plan,
            settings,
            folder: args.output.clone(),
            files,
        })
    }
}
