//! The tools: one table, in which each has its words, the form of its arguments, and the function that does it.

mod components;
mod describe;
mod diff;
mod edit;
mod export;
mod files;
mod measure;
mod page;
mod picture;
mod set;
mod solve;
mod text;
mod values;
mod why;

use std::sync::{Arc, LazyLock};
use std::time::Duration;

use rmcp::model::{JsonObject, Tool, ToolAnnotations};
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde_json::Value;

use crate::document::{Opened, cut};
use crate::fault::Fault;
use crate::job::Job;
use crate::store::Store;

pub(crate) use components::help as component_help;

/// What a call comes to.
pub(crate) enum Reply {
    /// An answer.
    Done(Answer),
    /// The end of a job is waited for, so long at most; then it is told of.
    Waits {
        document: Arc<Opened>,
        job: Arc<Job>,
        wait: Duration,
        /// Whether the job ends when the client takes the call back.
        owns: bool,
    },
}

/// An answer: an object in JSON, and files.
#[derive(Debug, Default)]
pub(crate) struct Answer {
    /// What is told.
    pub(crate) value: Value,
    /// Pictures as PNG.
    pub(crate) pictures: Vec<Vec<u8>>,
    /// A file: its name, its media type, its bytes.
    pub(crate) file: Option<(String, &'static str, Vec<u8>)>,
}

impl From<Value> for Reply {
    fn from(value: Value) -> Self {
        Self::Done(Answer { value, ..Answer::default() })
    }
}

/// What a tool does to the world, for clients that ask before some.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Does {
    /// Nothing changes.
    Reads,
    /// An open definition changes, in memory, and Undo takes it back; or one is opened.
    Edits,
    /// A file is written, or something that was in memory only is gone.
    Writes,
}

type Run = Box<dyn Fn(&Store, JsonObject) -> Result<Reply, Fault> + Send + Sync>;

/// A tool.
pub(crate) struct Entry {
    pub(crate) tool: Tool,
    pub(crate) run: Run,
}

fn entry<A: DeserializeOwned + JsonSchema + 'static>(
    name: &'static str,
    title: &'static str,
    help: &'static str,
    does: Does,
    run: fn(&Store, A) -> Result<Reply, Fault>,
) -> Entry {
    let mut schema = schemars::SchemaGenerator::default().into_root_schema_for::<A>();
    let mut object = std::mem::take(schema.ensure_object());
    // The name of a type of ours says nothing.
    object.remove("title");
    object.remove("description");
    object.remove("$schema");
    // A tool without arguments has a form for them all the same.
    object.entry("properties").or_insert_with(|| Value::Object(JsonObject::new()));
    let hints = ToolAnnotations::new()
        .read_only(does == Does::Reads)
        .destructive(does == Does::Writes)
        .open_world(false);
    let tool = Tool::new(name, help, Arc::new(object)).with_title(title).with_annotations(hints);
    let run = move |store: &Store, given: JsonObject| {
        let arguments = serde_json::from_value(Value::Object(given)).map_err(|error| {
            Fault::new(format!("{name} was not called"), "its arguments", cut(&error.to_string()))
        })?;
        run(store, arguments)
    };
    Entry { tool, run: Box::new(run) }
}

/// All tools, in the order in which they are listed.
pub(crate) fn all() -> &'static [Entry] {
    static ALL: LazyLock<Vec<Entry>> = LazyLock::new(|| {
        let groups = [
            files::entries(),
            describe::entries(),
            components::entries(),
            edit::entries(),
            text::entries(),
            set::entries(),
            solve::entries(),
            values::entries(),
            measure::entries(),
            why::entries(),
            picture::entries(),
            diff::entries(),
            export::entries(),
        ];
        groups.into_iter().flatten().collect()
    });
    &ALL
}

/// The tool of that name.
pub(crate) fn find(name: &str) -> Option<&'static Entry> {
    all().iter().find(|entry| entry.tool.name == name)
}
