//! What differs between two definitions, in words.

use std::path::Path;

use katydid_definition::diff::{Options, compare};
use katydid_definition::document::Document;
use katydid_studio::Form;
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Value, json};

use super::page::Part;
use super::{Does, Entry, Reply, entry};
use crate::document::cut;
use crate::fault::Fault;
use crate::store::Store;

pub(super) fn entries() -> Vec<Entry> {
    vec![entry(
        "diff_definition",
        "Compare definitions",
        "Tells in words what has changed in a definition since it was opened or saved, or what differs from another one that \
         is open or in a file.",
        Does::Reads,
        diff,
    )]
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Diff {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// The id of another definition that is open: what stands there is the old state.
    other: Option<String>,
    /// A file: what stands there is the old state.
    path: Option<String>,
    /// Whether places on the canvas count.
    #[serde(default)]
    layout: bool,
    /// The first of the list that is given, from 0.
    from: Option<usize>,
    /// How many are given at most.
    limit: Option<usize>,
}

fn diff(store: &Store, given: Diff) -> Result<Reply, Fault> {
    const WHAT: &str = "nothing was compared";
    let opened = store.find(WHAT, given.document.as_deref())?;
    let old = match (&given.other, &given.path) {
        (Some(_), Some(_)) => {
            return Err(Fault::new(WHAT, "other, path", "only one of the two can be given"));
        }
        (Some(other), None) => store.find(WHAT, Some(other))?.document(),
        (None, Some(path)) => {
            let form = Form::of(Path::new(path))
                .ok_or_else(|| Fault::new(WHAT, path, "a definition is a .gh, .ghx or .kd file"))?;
            let (_, bytes) = store.folders.read(path)?;
            let (document, _) =
                katydid_studio::read(form, &bytes).map_err(|why| Fault::new(WHAT, path, why))?;
            document.into()
        }
        (None, None) => opened.place().kept,
    };
    let found = compare(&old, &opened.document(), &Options { layout: given.layout });
    Ok(Part::new(given.from, given.limit).of("changes", &found, told).into())
}

fn told(change: &katydid_definition::diff::Change) -> Value {
    let mut told = json!({ "kind": change.kind.name(), "object": change.object, "id": change.id, "text": cut(&change.text) });
    if !change.clusters.is_empty() {
        told["clusters"] = json!(change.clusters);
    }
    told
}

/// What has changed, as the answer to an edit has it.
pub(super) fn changes(before: &Document, after: &Document, layout: bool) -> Value {
    let found = compare(before, after, &Options { layout });
    let words: Vec<String> =
        found.iter().take(super::super::thresholds::USUAL_ROWS).map(|one| cut(&one.to_string())).collect();
    let mut told = json!({ "changes": words, "count": found.len() });
    if words.len() < found.len() {
        told["note"] = json!("diff_definition has the others");
    }
    told
}
