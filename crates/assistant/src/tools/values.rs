//! The data of ports.

use katydid_data::{Tree, text};
use katydid_definition::document::Side;
use katydid_session::protocol::Row;
use katydid_session::{Digits, rows};
use katydid_solver::Inputs;
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Value, json};

use super::{Does, Entry, Reply, entry};
use crate::document::{Opened, Solved};
use crate::fault::Fault;
use crate::reference::Names;
use crate::store::Store;
use crate::thresholds::{MOST_LETTERS, MOST_ROWS, USUAL_ROWS};

pub(super) fn entries() -> Vec<Entry> {
    vec![entry(
        "read_values",
        "Read values",
        "Reads the data of an output or input after the last solve, branch by branch: numbers, texts, and geometry in words. \
         With `exact` numbers, points and vectors have all their digits. Long data is cut, with a note how to go on.",
        Does::Reads,
        read,
    )]
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Read {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// The output: the name or id of an object, with a point and the output's name or number where it has several, as
    /// `Divide Curve.Points`.
    port: String,
    /// Whether the input of that name is read, with all that its wires bring and what it keeps.
    #[serde(default)]
    input: bool,
    /// The first row, from 0; each branch counts as a row, and each of its items.
    from: Option<u32>,
    /// How many rows are given at most; 100 when not given.
    limit: Option<u32>,
    /// Whether numbers, points and vectors have all their digits.
    #[serde(default)]
    exact: bool,
}

/// The data of a port in the last results, and its name.
pub(super) fn data(
    opened: &Opened,
    what: &str,
    port: &str,
    input: bool,
) -> Result<(Solved, String, Tree), Fault> {
    let solved = opened.results(what)?;
    let engine = &solved.engine;
    let document = engine.document();
    let names = Names::new(document);
    let side = if input { Side::Input } else { Side::Output };
    let found = names.port(what, side, port)?;
    let label = names.label(found.object).to_owned();
    let tree = if input {
        Inputs::new(engine).of(found.object).into_iter().nth(found.index)
    } else {
        engine.report(found.object).and_then(|report| report.outputs.get(found.index)).cloned()
    };
    let name = if found.port.name.is_empty() { label } else { format!("{label}.{}", found.port.name) };
    let tree = tree.ok_or_else(|| Fault::new(what, &name, "it is not solved: call solve"))?;
    Ok((solved, name, tree))
}

fn read(store: &Store, given: Read) -> Result<Reply, Fault> {
    const WHAT: &str = "no values were read";
    let opened = store.find(WHAT, given.document.as_deref())?;
    let (solved, name, tree) = data(&opened, WHAT, &given.port, given.input)?;
    let rules = solved.engine.options().rules;
    let style = text::Style { units: rules.units, tolerance: rules.tolerance };
    let from = given.from.unwrap_or(0);
    let most = given.limit.unwrap_or(USUAL_ROWS as u32).clamp(1, MOST_ROWS as u32);
    let page = rows(&tree, [from, most], Digits::of(given.exact), &style);
    let (mut branches, mut letters, mut count) = (Vec::<Value>::new(), 0, 0_u32);
    for row in &page.rows {
        letters += match row {
            Row::Path { path, .. } => path.len() + 30,
            Row::Item { text, .. } => text.len() + 4,
        };
        if letters > MOST_LETTERS && count > 0 {
            break;
        }
        count += 1;
        match row {
            Row::Path { path, items } => {
                branches.push(json!({ "path": path, "items": items, "first": 0, "values": [] }));
            }
            Row::Item { index, text } => {
                if branches.is_empty() {
                    branches.push(json!({ "first": index, "values": [] }));
                }
                let last = branches.last_mut().and_then(|branch| branch["values"].as_array_mut());
                if let Some(values) = last {
                    values.push(json!(text));
                }
            }
        }
    }
    let next = from.saturating_add(count);
    let mut told = json!({
        "document": opened.id,
        "port": name,
        "type": tree.column().kind().name(),
        "branch_count": tree.branch_count(),
        "item_count": tree.item_count(),
        "branches": branches,
        "results": opened.standing(),
    });
    if next < page.total && count > 0 {
        told["next"] = json!(next);
        told["note"] = json!(format!("{} rows more: call again with \"from\": {next}", page.total - next));
    }
    Ok(told.into())
}
