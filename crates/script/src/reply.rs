//! What a process answers to a run.

use std::collections::HashMap;

use katydid_component::{Level, Message};
use katydid_members::Value;

/// The answer to a run.
#[derive(Debug, Default)]
pub(crate) struct Reply {
    /// The values of the outputs, by iteration.
    pub(crate) iterations: Vec<Vec<Value>>,
    /// What was printed, by iteration.
    pub(crate) prints: Vec<String>,
    /// How the script's language writes the objects of its own that are among the values, by their numbers.
    pub(crate) texts: HashMap<u64, String>,
    /// What the script said, and what went wrong in it.
    pub(crate) messages: Vec<Message>,
    /// Whether it was interrupted.
    pub(crate) was_cancelled: bool,
}

/// The most messages that are told of one run.
const MOST: usize = 200;

impl Reply {
    /// The answer of a message, `["done", {...}]`; none for any other message.
    pub(crate) fn read(message: &Value) -> Option<Self> {
        let Value::List(words) = message else { return None };
        let [Value::Text(name), answer] = words.as_slice() else { return None };
        if name != "done" {
            return None;
        }
        let iterations = answer.get("iterations").and_then(Value::items).unwrap_or_default();
        let rows = iterations.iter().map(|row| row.items().unwrap_or_default());
        let prints = answer.get("out").and_then(Value::items).unwrap_or_default();
        let prints = prints.iter().map(|text| text.as_text().unwrap_or_default().to_owned());
        let said = answer.get("messages").and_then(Value::items).unwrap_or_default();
        let mut messages: Vec<Message> = said.iter().take(MOST).filter_map(message_of).collect();
        let error = answer.get("error").and_then(Value::as_text);
        let was_cancelled = error == Some("cancelled");
        messages.extend(error.filter(|_| !was_cancelled).map(Message::error));
        Some(Self {
            iterations: rows.collect(),
            prints: prints.collect(),
            texts: texts(answer.get("texts")),
            messages,
            was_cancelled,
        })
    }
}

/// Texts by number.
fn texts(map: Option<&Value>) -> HashMap<u64, String> {
    let Some(Value::Map(pairs)) = map else { return HashMap::new() };
    let pair = |(number, text): &(Value, Value)| match (number, text) {
        (Value::Int(number), Value::Text(text)) => Some((u64::try_from(*number).ok()?, text.clone())),
        _ => None,
    };
    pairs.iter().filter_map(pair).collect()
}

/// `[level, text, line]`; a line below 0 is none.
fn message_of(value: &Value) -> Option<Message> {
    let parts = value.items()?;
    let [Value::Text(level), Value::Text(text), rest @ ..] = parts.as_slice() else { return None };
    let level = match level.as_str() {
        "error" => Level::Error,
        "warning" => Level::Warning,
        _ => Level::Remark,
    };
    let text = match rest {
        [Value::Int(line @ 1..)] if !text.contains(&format!("line {line}")) => format!("line {line}: {text}"),
        _ => text.clone(),
    };
    Some(match level {
        Level::Error => Message::error(text),
        Level::Warning => Message::warning(text),
        Level::Remark => Message::remark(text),
    })
}
