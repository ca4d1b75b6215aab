use std::fmt;
use std::sync::Arc;
use std::time::Duration;

use katydid_component::{Account, Cancel, Files, Kept, Limits, Outbox, RhinoModel};
use katydid_data::cast::Rules;
use katydid_definition::document::Object;

use crate::{ObjectReport, Remote, Scripts};

/// How far a solve has come.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Progress {
    /// Objects done.
    pub done: usize,
    /// Objects to do.
    pub total: usize,
    /// The object that was done last.
    pub name: String,
}

/// Called after each object, from whichever thread solved it.
pub type Listener = Arc<dyn Fn(&Progress) + Send + Sync>;

/// An object that is done.
#[derive(Debug, Clone, Copy)]
pub struct Finished<'a> {
    /// Its place among the document's objects.
    pub index: usize,
    /// The object as it was solved.
    pub object: &'a Object,
    /// What it gave.
    pub report: &'a ObjectReport,
}

/// Called with each object's report as soon as it is there, from whichever thread solved it.
pub type ResultListener = Arc<dyn Fn(&Finished<'_>) + Send + Sync>;

/// What a solve may use and how it reads the document.
#[derive(Clone, Default)]
pub struct Options {
    /// Units and tolerances.
    pub rules: Rules,
    /// What each object may put out, and how long all may take.
    pub limits: Limits,
    /// What counts the memory of the solve besides its own account; nothing when there is none.
    pub memory: Option<Arc<Account>>,
    /// Stops the solve from outside.
    pub cancel: Cancel,
    /// Which files the definition may read; none unless said so.
    pub files: Files,
    /// Where files that components write go; none are written unless there is one.
    pub outbox: Option<Arc<Outbox>>,
    /// What components keep from one solve to the next for hands that drag; nothing unless said so.
    pub kept: Option<Arc<Kept>>,
    /// The Rhino model that parameters refer to, when there is one.
    pub model: Option<Arc<RhinoModel>>,
    /// Which other servers Hops components may ask; none unless said so.
    pub remote: Option<Arc<dyn Remote>>,
    /// What runs script components; none run unless said so.
    pub scripts: Option<Arc<dyn Scripts>>,
    /// Leaves out what no wire reads where a component says that it is costly: the transforms of Move, say.
    pub skip_unread: bool,
    /// Told after each object.
    pub progress: Option<Listener>,
    /// Given the report of each object of the document itself, not of those inside clusters.
    pub finished: Option<ResultListener>,
}

impl Options {
    /// The same with a time limit.
    #[must_use]
    pub fn with_time(mut self, time: Duration) -> Self {
        self.limits.time = Some(time);
        self
    }
}

impl fmt::Debug for Options {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Options")
            .field("rules", &self.rules)
            .field("limits", &self.limits)
            .field("cancel", &self.cancel)
            .field("files", &self.files)
            .field("remote", &self.remote)
            .field("scripts", &self.scripts)
            .field("model", &self.model.as_ref().map(|model| model.objects().len()))
            .finish_non_exhaustive()
    }
}
