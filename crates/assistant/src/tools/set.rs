//! The inputs of a definition are set.

use std::collections::BTreeMap;

use katydid_definition::document::{Document, Special};
use katydid_session::{assign_input, find_input};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Value, json};

use super::{Does, Entry, Reply, entry};
use crate::document::cut;
use crate::fault::Fault;
use crate::store::Store;
use crate::thresholds::MOST_EDITS;

pub(super) fn entries() -> Vec<Entry> {
    vec![entry(
        "set_inputs",
        "Set inputs",
        "Sets inputs of a definition: sliders, panels, toggles, value lists, calendars, clocks, Get components, parameters and \
         RH_IN groups, by name or id. All of them or none, as one step for undo. A value outside a slider's range is refused. \
         Then call solve.",
        Does::Edits,
        set,
    )]
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Set {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// The values by the names or ids of the inputs: numbers, texts, true or false, a list of them for a parameter; points as
    /// "1,2,3".
    values: BTreeMap<String, Value>,
}

fn set(store: &Store, given: Set) -> Result<Reply, Fault> {
    const WHAT: &str = "no input was set";
    let opened = store.find(WHAT, given.document.as_deref())?;
    if given.values.is_empty() || given.values.len() > MOST_EDITS {
        return Err(Fault::new(WHAT, "values", format!("between 1 and {MOST_EDITS} values are taken")));
    }
    let mut editor = opened.editor();
    let mut after = Document::clone(editor.document());
    let mut rounded = serde_json::Map::new();
    for (name, value) in &given.values {
        let refused = |why: String| Fault::new(WHAT, format!("input \"{}\"", cut(name)), cut(&why));
        let text = match value {
            Value::String(text) => text.clone(),
            Value::Null => return Err(refused("null is no value".to_owned())),
            Value::Object(_) => {
                return Err(refused("an object is no value: give a number, a text, or a list".to_owned()));
            }
            other => other.to_string(),
        };
        let index = find_input(&after, name).map_err(|error| refused(error.to_string()))?;
        let object = after.objects.get_mut(index).ok_or_else(|| refused("it is gone".to_owned()))?;
        assign_input(object, &text).map_err(|error| refused(error.to_string()))?;
        // A slider takes the nearest value that it can have.
        if let Some(Special::Slider(slider)) = object.special()
            && text.trim().parse() != Ok(slider.value)
        {
            rounded.insert(name.clone(), json!(slider.value));
        }
    }
    let names: Vec<&str> = given.values.keys().map(String::as_str).collect();
    let change = opened.put(WHAT, &mut editor, after, cut(&format!("Set {}", names.join(", "))))?;
    let mut told = json!({ "document": opened.id, "set": names, "changed": !change.is_empty(), "revision": editor.revision() });
    if !rounded.is_empty() {
        told["rounded"] = json!(rounded);
        told["note"] = json!("sliders took the nearest values that they can have");
    }
    Ok(told.into())
}
