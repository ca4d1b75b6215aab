//! What is in a definition.

use katydid_definition::document::{Side, Special, ids};
use katydid_definition::kd;
use katydid_session::protocol::{Control, DocumentState, MappingView, ObjectView, PortView, Support};
use katydid_session::{check, inputs};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Map, Value, json};

use super::page::Part;
use super::{Does, Entry, Reply, entry};
use crate::document::{Opened, Solved, cut};
use crate::fault::Fault;
use crate::reference::Names;
use crate::store::Store;

pub(super) fn entries() -> Vec<Entry> {
    vec![
        entry(
            "describe_definition",
            "Describe definition",
            "Tells what a definition is: its inputs with their values and ranges, its outputs, its groups, its units, what of \
             it cannot run here, whether its results are those of its state, and how its objects came out.",
            Does::Reads,
            describe,
        ),
        entry(
            "list_objects",
            "List objects",
            "Lists the objects of a definition with their ports, wires, settings and, after a solve, status and messages: \
             all, those that are named, those of a group, or those with a word in their names. The names are those of the \
             text form; other tools take them, or the ids.",
            Does::Reads,
            objects,
        ),
        entry(
            "read_text",
            "Read as text",
            "Gives a definition as text in .kd, or some lines of it, or the lines with a word in them. With `blocks` also the \
             blocks at the end: places on the canvas, ids, and what the statements do not say.",
            Does::Reads,
            text,
        ),
    ]
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Describe {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
}

fn describe(store: &Store, given: Describe) -> Result<Reply, Fault> {
    let opened = store.find("nothing was described", given.document.as_deref())?;
    Ok(overview(&opened).into())
}

/// The most of each list in an overview; list_objects has the rest.
const MOST_LISTED: usize = 100;

/// What a definition is, in one look.
pub(super) fn overview(opened: &Opened) -> Value {
    let (document, state, view) = {
        let editor = opened.editor();
        let document = std::sync::Arc::clone(editor.document());
        (document, editor.state(&[]).ok(), editor.rules())
    };
    let names = Names::new(&document);
    let views = state.as_ref().map(|state: &DocumentState| state.objects.as_slice()).unwrap_or_default();
    let place = |id| document.objects.iter().position(|object| object.id == id);
    let view_of = |id| views.iter().find(|view| view.id == id);
    let all_inputs = inputs(&document);
    let found: Vec<Value> = all_inputs
        .iter()
        .take(MOST_LISTED)
        .filter_map(|(name, id)| {
            let view = view_of(*id)?;
            let mut told = json!({ "name": name, "id": id, "component": view.name });
            match &view.control {
                Some(control) => told["value"] = control_told(control),
                None => told["kept"] = json!(view.inputs.first().map_or(0, |port| port.kept)),
            }
            Some(told)
        })
        .collect();
    let (mut groups, mut outputs) = (Vec::new(), Vec::new());
    for (at, object) in document.objects.iter().enumerate() {
        if let Some(Special::Group(group)) = object.special() {
            let members: Vec<&str> =
                group.members.iter().filter_map(|id| Some(names.label(place(*id)?))).collect();
            if group.marks_output() {
                outputs
                    .extend(members.first().map(|member| json!({ "name": group.label, "object": member })));
            }
            let shown: Vec<&&str> = members.iter().take(MOST_LISTED).collect();
            groups.push(
                json!({ "label": group.label, "id": object.id, "count": members.len(), "members": shown }),
            );
        } else if object.component == ids::CONTEXT_BAKE {
            outputs.push(json!({ "name": names.label(at), "object": names.label(at) }));
        }
    }
    let needs = check(&document);
    let missing: Vec<Value> = needs
        .unsupported
        .iter()
        .take(MOST_LISTED)
        .map(|one| json!({ "component": one.name, "count": one.count, "plugin": one.plugin, "reason": one.reason }))
        .collect();
    let mut told = json!({
        "document": opened.id,
        "name": opened.name(),
        "path": opened.place().path,
        "author": document.header.author,
        "description": cut(&document.header.description),
        "units": view.units.name(),
        "tolerance": view.tolerance.absolute,
        "objects": document.objects.len(),
        "inputs": found,
        "outputs": outputs,
        "groups": groups.len(),
        "group_list": groups.iter().take(MOST_LISTED).collect::<Vec<_>>(),
        "results": opened.standing(),
        "undo": state.as_ref().and_then(|state| state.document.undo.clone()),
        "redo": state.as_ref().and_then(|state| state.document.redo.clone()),
    });
    if let Some(original) = &opened.original {
        told["studio"] = original.told();
        // What the person did is there to be taken back by the person.
        (told["undo"], told["redo"]) = (Value::Null, Value::Null);
    }
    if all_inputs.len() > MOST_LISTED {
        told["note"] = json!(format!("{} inputs in all: list_objects has the others", all_inputs.len()));
    }
    if !missing.is_empty() {
        told["cannot_run"] = json!(missing);
    }
    if !needs.scripts.is_empty() {
        told["scripts"] = json!(needs.scripts.len());
    }
    let problems =
        state.as_ref().map(|state| state.problems.iter().map(|one| cut(&one.text)).collect::<Vec<_>>());
    if problems.as_ref().is_some_and(|problems| !problems.is_empty()) {
        told["remarks"] = json!(problems);
    }
    if opened.solved().revision.is_some() {
        told["outcome"] = opened.outcome();
    }
    told
}

/// A control as an answer has it: what is set, without how it looks.
pub(super) fn control_told(control: &Control) -> Value {
    match control {
        Control::Slider { value, min, max, rounding, digits, .. } => {
            json!({ "is": "slider", "value": value, "min": min, "max": max, "rounding": rounding, "digits": digits })
        }
        Control::Panel { text, multiline, .. } => {
            json!({ "is": "panel", "text": cut(text), "lines_are_items": !multiline })
        }
        Control::Script { language, text, .. } => {
            json!({ "is": "script", "language": language, "text": cut(text) })
        }
        Control::Group { label, members, .. } => {
            json!({ "is": "group", "label": label, "count": members.len() })
        }
        Control::Scribble { text, .. } => json!({ "is": "scribble", "text": cut(text) }),
        Control::Sketch { lines, .. } => json!({ "is": "sketch", "lines": lines.len() }),
        Control::Genes { values, min, max, decimals } => {
            let shown: Vec<&f64> = values.iter().take(MOST_LISTED).collect();
            json!({ "is": "genes", "count": values.len(), "values": shown, "min": min, "max": max, "decimals": decimals })
        }
        other => serde_json::to_value(other).unwrap_or_default(),
    }
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Objects {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// Only these: names or ids.
    objects: Option<Vec<String>>,
    /// Only those with this word in their name, or in that of their component.
    word: Option<String>,
    /// Only those in the group with this label or id.
    group: Option<String>,
    /// Only those with this status after the last solve: ok, warning, error, disabled, unsupported, no-data.
    status: Option<String>,
    /// The first of the list that is given, from 0.
    from: Option<usize>,
    /// How many are given at most.
    limit: Option<usize>,
}

fn objects(store: &Store, given: Objects) -> Result<Reply, Fault> {
    const WHAT: &str = "no objects were listed";
    let opened = store.find(WHAT, given.document.as_deref())?;
    let (document, state) = {
        let editor = opened.editor();
        let state = editor.state(&[]).map_err(|why| Fault::new(WHAT, &opened.id, why.to_string()))?;
        (std::sync::Arc::clone(editor.document()), state)
    };
    let names = Names::new(&document);
    let solved = opened.solved();
    let mut chosen: Vec<usize> = (0..document.objects.len()).collect();
    if let Some(wanted) = &given.objects {
        chosen = wanted.iter().map(|name| names.object(WHAT, name)).collect::<Result<_, _>>()?;
    }
    if let Some(group) = &given.group {
        let of_label = document.objects.iter().find_map(|object| match object.special() {
            Some(Special::Group(found)) if found.label == *group || object.id.to_string() == *group => {
                Some(found)
            }
            _ => None,
        });
        let found = of_label
            .ok_or_else(|| Fault::new(WHAT, format!("group \"{}\"", cut(group)), "there is no such group"))?;
        chosen
            .retain(|at| document.objects.get(*at).is_some_and(|object| found.members.contains(&object.id)));
    }
    if let Some(word) = given.word.as_deref().map(str::to_lowercase) {
        chosen.retain(|at| {
            let component = document.objects.get(*at).map(|object| object.name.to_lowercase());
            names.label(*at).to_lowercase().contains(&word)
                || component.is_some_and(|name| name.contains(&word))
        });
    }
    if let Some(status) = &given.status {
        chosen.retain(|at| {
            let id = document.objects.get(*at).map(|object| object.id);
            id.and_then(|id| status_of(&solved, id)).is_some_and(|(word, _)| word == status)
        });
    }
    let lookup = document.lookup();
    let mut told = Part::new(given.from, given.limit).of("objects", &chosen, |at| {
        let Some(view) = state.objects.get(*at) else { return Value::Null };
        object_told(&names, *at, view, &lookup, &solved)
    });
    told["results"] = opened.standing();
    Ok(told.into())
}

/// The status and messages of an object in the last results.
fn status_of(solved: &Solved, id: uuid::Uuid) -> Option<(&'static str, Vec<Value>)> {
    let engine = &solved.engine;
    let index = engine.document().objects.iter().position(|object| object.id == id)?;
    let report = engine.report(index)?;
    let messages = report.messages.iter().take(10);
    let messages =
        messages.map(|message| json!(format!("{}: {}", message.level, cut(&message.text)))).collect();
    Some((report.status.word(), messages))
}

fn object_told(
    names: &Names<'_>,
    at: usize,
    view: &ObjectView,
    lookup: &katydid_definition::document::Lookup,
    solved: &Solved,
) -> Value {
    let mut told = Map::new();
    let mut put = |key: &str, value: Value| told.insert(key.to_owned(), value);
    put("name", json!(names.label(at)));
    put("id", json!(view.id));
    put("component", json!(view.name));
    put("at", json!([view.bounds[0], view.bounds[1]]));
    let port = |port: &PortView, side: Side| port_told(names, port, side, lookup);
    if !view.inputs.is_empty() {
        put("inputs", view.inputs.iter().map(|one| port(one, Side::Input)).collect());
    }
    if !view.outputs.is_empty() {
        put("outputs", view.outputs.iter().map(|one| port(one, Side::Output)).collect());
    }
    if let Some(control) = &view.control {
        put("control", control_told(control));
    }
    for (key, on) in [("disabled", view.disabled), ("preview_off", view.previews && view.hidden)] {
        if on {
            put(key, json!(true));
        }
    }
    if let Support::No { plugin, reason } = &view.support {
        put("cannot_run", json!({ "plugin": plugin, "reason": reason }));
    }
    if let Some((status, messages)) = status_of(solved, view.id) {
        put("status", json!(status));
        if !messages.is_empty() {
            put("messages", json!(messages));
        }
    }
    Value::Object(told)
}

fn port_told(
    names: &Names<'_>,
    port: &PortView,
    side: Side,
    lookup: &katydid_definition::document::Lookup,
) -> Value {
    let mut told =
        json!({ "name": port.name, "nickname": port.nickname, "type": port.kind, "access": port.access });
    if side == Side::Input {
        if !port.sources.is_empty() {
            told["from"] = port.sources.iter().map(|id| json!(names.output(*id, lookup))).collect();
        }
        if port.kept > 0 {
            told["kept"] = json!(port.kept);
        }
        if port.optional {
            told["optional"] = json!(true);
        }
    }
    let mut does: Vec<&str> = [
        (port.reverse, "reverse"),
        (port.simplify, "simplify"),
        (port.reparameterize, "reparameterize"),
        (port.invert, "invert"),
        (port.degrees, "degrees"),
        (port.unitize, "unitize"),
    ]
    .iter()
    .filter(|(on, _)| *on)
    .map(|(_, word)| *word)
    .collect();
    match port.mapping {
        MappingView::None => {}
        MappingView::Flatten => does.push("flatten"),
        MappingView::Graft => does.push("graft"),
    }
    if !does.is_empty() {
        told["does"] = json!(does);
    }
    if let Some(expression) = &port.expression {
        told["expression"] = json!(expression);
    }
    told
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Text {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// The first line that is given, from 1.
    from_line: Option<usize>,
    /// How many lines are given at most.
    lines: Option<usize>,
    /// Only lines with this in them.
    find: Option<String>,
    /// Whether the blocks at the end are given too: layout, ids, details, file, data.
    #[serde(default)]
    blocks: bool,
}

fn text(store: &Store, given: Text) -> Result<Reply, Fault> {
    const WHAT: &str = "no text was given";
    let opened = store.find(WHAT, given.document.as_deref())?;
    let revision = opened.editor().revision();
    let made = opened.text();
    let kd::Written { text, left_out } = made.written().map_err(|why| Fault::new(WHAT, &opened.id, why))?;
    let is_block = |line: &str| ["layout {", "ids {", "details {", "file {", "data {"].contains(&line);
    let all: Vec<(usize, &str)> = (1..).zip(text.lines()).collect();
    let end = if given.blocks { None } else { all.iter().position(|(_, line)| is_block(line)) };
    let shown = all.get(..end.unwrap_or(all.len())).unwrap_or_default();
    let lines: Vec<(usize, &str)> = match &given.find {
        Some(word) => shown.iter().filter(|(_, line)| line.contains(word.as_str())).copied().collect(),
        None => shown.to_vec(),
    };
    let from = given.from_line.unwrap_or(1);
    let (mut out, mut letters, mut next) = (String::new(), 0, None);
    let most = given.lines.unwrap_or(usize::MAX).max(1);
    for (count, (number, line)) in lines.iter().filter(|(number, _)| *number >= from).enumerate() {
        letters += line.len() + 1;
        if count == most || (letters > crate::thresholds::MOST_LETTERS && count > 0) {
            next = Some(*number);
            break;
        }
        match given.find {
            Some(_) => out.push_str(&format!("{number}: {}\n", cut(line))),
            // A line that is longer than an answer may be is of data.
            None if line.len() > crate::thresholds::MOST_LETTERS => out.push_str(&format!("{}\n", cut(line))),
            None => out.push_str(&format!("{line}\n")),
        }
    }
    let mut told = json!({ "document": opened.id, "revision": revision, "lines": all.len(), "text": out });
    if !left_out.is_empty() {
        told["left_out"] = json!(left_out);
    }
    if let Some(next) = next {
        told["next"] = json!(next);
        told["note"] = json!(format!("there is more: call again with \"from_line\": {next}"));
    } else if end.is_some() {
        told["note"] = json!("the blocks at the end are left out: call with \"blocks\": true for them");
    }
    Ok(told.into())
}
