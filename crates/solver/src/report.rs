use std::sync::Arc;
use std::time::Duration;

use katydid_component::{Level, Message};
use katydid_data::Tree;

/// How an object came out of a solve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Status {
    /// It ran and has nothing to say.
    Ok,
    /// It ran, with a warning.
    Warning,
    /// It could not do its work.
    Error,
    /// It is switched off.
    Disabled,
    /// Katydid does not have this component.
    Unsupported,
    /// It did not run: a required input has no data.
    NoData,
}

impl Status {
    /// The word for it in reports.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Warning => "warning",
            Self::Error => "error",
            Self::Disabled => "disabled",
            Self::Unsupported => "unsupported",
            Self::NoData => "no-data",
        }
    }
}

/// What one object gave in a solve.
#[derive(Debug, Clone)]
pub struct ObjectReport {
    /// How it came out.
    pub status: Status,
    /// What it tells its user.
    pub messages: Vec<Message>,
    /// How long it took; zero where there is no clock.
    pub time: Duration,
    /// The data of each output, after its modifiers.
    pub outputs: Vec<Tree>,
    /// Of a cluster: the reports of the objects inside, in their order.
    pub inside: Option<Arc<[ObjectReport]>>,
    /// Of a recorder or tracker in a run in time: what it has recorded by now, before its modifiers.
    pub(crate) recorded: Option<Tree>,
}

impl ObjectReport {
    /// A report of an object that did not run.
    pub(crate) fn idle(status: Status, messages: Vec<Message>, outputs: usize) -> Self {
        let outputs = vec![Tree::empty(); outputs];
        Self { status, messages, time: Duration::ZERO, outputs, inside: None, recorded: None }
    }

    /// Of a Value Tracker in a run in time: its values from solution to solution, branch by branch.
    pub fn history(&self) -> Option<&Tree> {
        self.recorded.as_ref()
    }

    /// The status that the messages speak of.
    pub(crate) fn status_of(messages: &[Message]) -> Status {
        match messages.iter().map(|m| m.level).max() {
            Some(Level::Error) => Status::Error,
            Some(Level::Warning) => Status::Warning,
            _ => Status::Ok,
        }
    }
}
