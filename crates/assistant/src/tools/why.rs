//! Why an object failed.

use std::collections::HashSet;

use katydid_component::registry;
use katydid_definition::document::{Document, Lookup};
use katydid_solver::{Engine, Inputs, Status};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Value, json};

use super::{Does, Entry, Reply, entry};
use crate::document::cut;
use crate::fault::Fault;
use crate::reference::Names;
use crate::store::Store;
use crate::thresholds::USUAL_ROWS;

pub(super) fn entries() -> Vec<Entry> {
    vec![entry(
        "why",
        "Why did it fail",
        "Tells why an object did not come out well in the last solve: its messages, what each of its inputs has and wants, and \
         the objects before it where the trouble begins. Without an object, the objects where all trouble of the definition \
         begins.",
        Does::Reads,
        why,
    )]
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Why {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// The name or id of the object.
    object: Option<String>,
}

fn why(store: &Store, given: Why) -> Result<Reply, Fault> {
    const WHAT: &str = "nothing was explained";
    let opened = store.find(WHAT, given.document.as_deref())?;
    let solved = opened.results(WHAT)?;
    let engine = &solved.engine;
    let document = engine.document();
    let (names, lookup) = (Names::new(document), document.lookup());
    let mut told = match &given.object {
        Some(name) => {
            let at = names.object(WHAT, name)?;
            let roots = begins(engine, document, &lookup, at);
            let mut told = object(engine, document, &names, &lookup, at);
            let roots: Vec<Value> = roots
                .iter()
                .filter(|root| **root != at)
                .map(|root| object(engine, document, &names, &lookup, *root))
                .collect();
            told["begins_at"] = json!(roots);
            told
        }
        None => {
            let all: Vec<usize> = (0..document.objects.len()).filter(|at| is_bad(engine, *at)).collect();
            let mut roots: Vec<usize> =
                all.iter().flat_map(|at| begins(engine, document, &lookup, *at)).collect();
            roots.sort_unstable();
            roots.dedup();
            let shown =
                roots.iter().take(USUAL_ROWS).map(|at| object(engine, document, &names, &lookup, *at));
            json!({ "not_well": all.len(), "begins_at": shown.collect::<Vec<_>>(), "count": roots.len() })
        }
    };
    told["document"] = json!(opened.id);
    told["results"] = opened.standing();
    Ok(told.into())
}

/// Whether an object did not come out well: for what has no data, that is only where it gives nothing although it should.
fn is_bad(engine: &Engine, at: usize) -> bool {
    engine.report(at).is_some_and(|report| matches!(report.status, Status::Error | Status::Unsupported))
}

/// Whether an object gave nothing, for whatever reason.
fn gave_nothing(engine: &Engine, at: usize) -> bool {
    engine.report(at).is_none_or(|report| match report.status {
        Status::Error | Status::Unsupported | Status::NoData | Status::Disabled => true,
        Status::Ok | Status::Warning => {
            !report.outputs.is_empty() && report.outputs.iter().all(|tree| tree.item_count() == 0)
        }
    })
}

/// The objects at which the trouble of an object begins: going back along wires, those that gave nothing while all that they
/// read gave something.
fn begins(engine: &Engine, document: &Document, lookup: &Lookup, at: usize) -> Vec<usize> {
    let (mut waiting, mut seen, mut roots) = (vec![at], HashSet::from([at]), Vec::new());
    while let Some(at) = waiting.pop() {
        let Some(object) = document.objects.get(at) else { continue };
        let sources = object.inputs.iter().flat_map(|port| &port.sources).filter_map(|id| lookup.output(*id));
        let before: Vec<usize> =
            sources.map(|port| port.object).filter(|source| gave_nothing(engine, *source)).collect();
        if before.is_empty() {
            roots.push(at);
        }
        waiting.extend(before.into_iter().filter(|source| seen.insert(*source)));
    }
    roots.sort_unstable();
    roots
}

/// An object with its messages, and what its inputs have and want.
fn object(engine: &Engine, document: &Document, names: &Names<'_>, lookup: &Lookup, at: usize) -> Value {
    let Some(object) = document.objects.get(at) else { return Value::Null };
    let mut told = json!({ "object": names.label(at), "id": object.id, "component": object.name });
    match engine.report(at) {
        Some(report) => {
            told["status"] = json!(report.status.word());
            let messages = report.messages.iter().take(20);
            told["messages"] =
                messages.map(|message| json!(format!("{}: {}", message.level, cut(&message.text)))).collect();
        }
        None => told["status"] = json!("not solved: the solve was cancelled before it"),
    }
    if let Some(known) = registry::unsupported(object.component) {
        told["cannot_run"] = json!(known.reason);
    }
    let component = registry::by_guid(object.component);
    let trees = Inputs::new(engine).of(at);
    let inputs = object.inputs.iter().enumerate().map(|(k, port)| {
        let tree = trees.get(k);
        let wants = component.and_then(|component| component.input(k));
        let from: Vec<String> = port.sources.iter().take(20).map(|id| names.output(*id, lookup)).collect();
        let items = tree.map_or(0, katydid_data::Tree::item_count);
        let nulls = tree.map_or(0, |tree| {
            tree.branches().map(|branch| branch.iter().filter(Option::is_none).count()).sum::<usize>()
        });
        let mut told = json!({ "input": port.name, "items": items, "from": from });
        if let Some(tree) = tree.filter(|_| items > 0) {
            told["has"] = json!(tree.column().kind().name());
            told["branches"] = json!(tree.branch_count());
        }
        if nulls > 0 {
            told["nulls"] = json!(nulls);
        }
        if let Some(wants) = wants {
            told["wants"] = json!(wants.kind.name());
            told["help"] = json!(wants.help);
            if items == 0 && !wants.optional && !port.optional {
                told["lacks"] = json!("it needs data and has none");
            }
        }
        told
    });
    told["inputs"] = inputs.collect();
    told
}
