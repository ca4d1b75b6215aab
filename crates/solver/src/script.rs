//! Components that are scripts: whoever solves a definition decides whether they run, and by what.

use std::fmt;
use std::sync::Arc;

use katydid_component::{Budget, Cancel, Limits, Message};
use katydid_data::cast::Rules;
use katydid_data::{Column, Keeper, Kind, Path, Tree, Value};
use katydid_definition::document::{Object, Port, Script, ScriptLanguage};

use crate::collect;
use crate::object::Turn;
use crate::outside;
use crate::report::{ObjectReport, Status};

/// Said of a text whose language nobody can tell.
const NO_LANGUAGE: &str = "The first line of the script's text names no language that runs here: begin it with \
                           `#! python 3` or `// #! csharp`";

/// Runs scripts.
pub trait Scripts: fmt::Debug + Send + Sync {
    /// Whether scripts of a language are run at all.
    fn runs(&self, language: &ScriptLanguage) -> bool;

    /// How many processes have ended before their time: what they held is lost then, and what made it is solved again.
    fn losses(&self) -> u64 {
        0
    }

    /// What runs the scripts of a copy of the document beside this one, so that a script that takes long holds up no script
    /// of another copy; `None` where one runs all of them at once.
    fn another(&self) -> Option<Arc<dyn Scripts>> {
        None
    }

    /// Runs a script for all of its data: the data of the outputs, in their order.
    ///
    /// # Errors
    /// Why it does not run here.
    fn run(&self, task: &ScriptTask<'_>) -> Result<ScriptDone, Unrun>;
}

/// Makes what runs the scripts of one document: its scripts share a process, and no other document's.
pub trait ScriptMaker: fmt::Debug + Send + Sync {
    /// What runs the scripts of a document.
    fn make(&self) -> Arc<dyn Scripts>;
}

/// Why a script did not run.
#[derive(Debug, Clone, PartialEq)]
pub enum Unrun {
    /// It may not, or there is nothing to run it with; the rest of the definition goes on.
    Unsupported(String),
    /// It was begun, and could not be finished.
    Failed(Message),
}

/// A script component's turn.
#[derive(Debug)]
pub struct ScriptTask<'a> {
    /// The component.
    pub object: &'a Object,
    /// Its script; the text that came over a wire stands in it.
    pub script: &'a Script,
    /// The inputs of the script with their data: none for the text of the script itself.
    pub inputs: Vec<(&'a Port, Tree)>,
    /// Units and tolerances.
    pub rules: Rules,
    /// What may be used: to be asked while one waits.
    pub budget: &'a Budget,
    /// What each call of the script may use, with the time that is left.
    pub limits: Limits,
    /// Stops it.
    pub cancel: &'a Cancel,
}

/// What a script gave.
#[derive(Debug, Default)]
pub struct ScriptDone {
    /// The data of the outputs.
    pub outputs: Vec<Tree>,
    /// What it said.
    pub messages: Vec<Message>,
}

/// Runs a script component; `None` when the object is none, or nobody runs scripts of its language.
pub(crate) fn solve(
    turn: &Turn<'_>,
    object: &Object,
    wired: &[Vec<&Tree>],
    budget: &Budget,
) -> Option<ObjectReport> {
    let scripts = turn.options.scripts.as_ref()?;
    let mut script = object.script()?;
    // A component of any language takes that which the text names that comes over the wire.
    let is_open = script.from_wire && matches!(script.language, ScriptLanguage::Other(_));
    if !is_open && !scripts.runs(&script.language) {
        return None;
    }
    let rules = turn.options.rules;
    let mut messages = Vec::new();
    let mut inputs = Vec::with_capacity(object.inputs.len());
    let mut missing = false;
    for (k, port) in object.inputs.iter().enumerate() {
        let wires = wired.get(k).map_or(&[][..], Vec::as_slice);
        let collected = collect::port(object, port, None, wires, turn.options);
        messages.extend(collected.messages);
        if holds_text(&script, port, k) {
            match text(&collected.tree) {
                Some(text) => {
                    if let Some(named) = ScriptLanguage::named_in(&text).filter(|_| is_open) {
                        script.language = named;
                    }
                    script.text = text;
                }
                None => {
                    messages.push(outside::no_data(port));
                    missing = true;
                }
            }
            continue;
        }
        inputs.push((port, collected.tree));
    }
    if missing {
        return Some(ObjectReport::idle(Status::NoData, messages, object.outputs.len()));
    }
    if !scripts.runs(&script.language) {
        if matches!(script.language, ScriptLanguage::Other(_)) {
            messages.push(Message::warning(NO_LANGUAGE));
            return Some(unsupported(object, messages));
        }
        return None;
    }
    let limits = Limits { time: turn.deadline.left(), ..turn.options.limits };
    let cancel = &turn.options.cancel;
    let task = ScriptTask { object, script: &script, inputs, rules, budget, limits, cancel };
    let begun = budget.check().map_err(Unrun::Failed).and_then(|()| scripts.run(&task));
    let done = match begun {
        Ok(done) => done,
        Err(Unrun::Unsupported(why)) => {
            messages.push(Message::warning(why));
            return Some(unsupported(object, messages));
        }
        Err(Unrun::Failed(message)) => {
            messages.push(message);
            ScriptDone::default()
        }
    };
    messages.extend(done.messages);
    Some(outside::report(turn, object, done.outputs, messages, budget))
}

/// What a component puts out that is not supported.
fn unsupported(object: &Object, messages: Vec<Message>) -> ObjectReport {
    let nulls = vec![Tree::branch_at(Path::zero(), Column::nulls(1)); object.outputs.len()];
    let report = ObjectReport::idle(Status::Unsupported, messages, 0);
    ObjectReport { outputs: nulls, ..report }
}

/// Whether a report has objects in it that went with the process that held them.
pub(crate) fn has_lost(report: &ObjectReport) -> bool {
    has_token(report, |keeper| keeper.is_lost())
}

/// Whether a report has objects in it that a process holds: it numbers them from 1.
pub(crate) fn has_held(report: &ObjectReport) -> bool {
    has_token(report, |keeper| keeper.number() > 0)
}

fn has_token(report: &ObjectReport, is_meant: impl Fn(&dyn Keeper) -> bool) -> bool {
    let is_one = |item: Option<Value>| match item {
        Some(Value::Content(content)) => {
            matches!(&*content, katydid_data::Content::Token(token) if is_meant(&*token.0))
        }
        _ => false,
    };
    // Other columns hold numbers, points and the like alone.
    let columns = report.outputs.iter().map(Tree::column);
    let mut columns = columns.filter(|column| matches!(column.kind(), Kind::Content | Kind::Generic));
    columns.any(|column| column.iter().any(is_one))
}

/// Whether an input brings the text of the script: the first, by its name, where the text comes over a wire.
fn holds_text(script: &Script, port: &Port, place: usize) -> bool {
    script.from_wire && place == 0 && ["code", "script"].contains(&port.name.to_lowercase().as_str())
}

/// The lines of a text that came over a wire.
fn text(tree: &Tree) -> Option<String> {
    if tree.is_empty() {
        return None;
    }
    let line = |item: Option<Value>| match item {
        Some(Value::Text(text)) => text.to_string(),
        _ => String::new(),
    };
    Some(tree.column().iter().map(line).collect::<Vec<_>>().join("\n"))
}
