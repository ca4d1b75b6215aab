//! Why a call was not carried out.

use rmcp::model::{CallToolResult, ContentBlock};
use serde_json::json;

/// Why a call was not carried out: what was asked, where the reason lies, and why. Nothing has changed then.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{what}: {place}{why}", place = if where_.is_empty() { String::new() } else { format!("{where_}: ") })]
pub(crate) struct Fault {
    /// What could not be done: `the definition was not opened`.
    what: String,
    /// The argument, object, file or line; empty where there is none.
    where_: String,
    /// The reason, and what helps.
    why: String,
}

impl Fault {
    /// A fault in three parts.
    pub(crate) fn new(what: impl Into<String>, place: impl Into<String>, why: impl Into<String>) -> Self {
        Self { what: what.into(), where_: place.into(), why: why.into() }
    }

    /// The same fault, of a part of a call: its place stands before the one that is there.
    pub(crate) fn within(mut self, place: &str) -> Self {
        self.where_ =
            if self.where_.is_empty() { place.to_owned() } else { format!("{place}, {}", self.where_) };
        self
    }

    /// As the answer to a call.
    pub(crate) fn answer(&self) -> CallToolResult {
        let mut result = CallToolResult::error(vec![ContentBlock::text(self.to_string())]);
        let Self { what, where_, why } = self;
        result.structured_content = Some(json!({ "error": { "what": what, "where": where_, "why": why } }));
        result
    }
}
