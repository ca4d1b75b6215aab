//! A definition is changed by operations, and changes are taken back.

use std::sync::Arc;

use katydid_definition::document::{Document, Object, Side};
use katydid_session::protocol::{
    AccessView, Connection, Edit, GroupChange, MappingView, ObjectChange, PortChange,
};
use katydid_session::{Editor, Solution, assign_input};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Value, json};
use uuid::Uuid;

use super::{Does, Entry, Reply, components, diff, entry};
use crate::document::{Opened, cut};
use crate::fault::Fault;
use crate::reference::Names;
use crate::store::Store;
use crate::thresholds::MOST_EDITS;

pub(super) fn entries() -> Vec<Entry> {
    vec![
        entry(
            "edit_definition",
            "Edit definition",
            "Changes a definition by operations, one after the other: add, remove, connect, disconnect, rename, set, keep, move, \
             enable, preview, modify, group, ungroup, duplicate, cluster, explode, add_port, remove_port, settings. Objects go \
             by name or id, ports as `Object.Port`. All of them are one step for undo; where one is refused nothing is done. To \
             build many objects at once edit_text is shorter.",
            Does::Edits,
            edit,
        ),
        entry(
            "undo",
            "Undo",
            "Takes the last changes of a definition back, one step a call to an editing tool. In a studio only your own steps.",
            Does::Edits,
            undo,
        ),
        entry("redo", "Redo", "Makes the last changes that were taken back again.", Does::Edits, redo),
    ]
}

/// One operation.
#[derive(Deserialize, JsonSchema)]
#[serde(tag = "op", rename_all = "snake_case", deny_unknown_fields)]
enum Operation {
    /// Puts a new object on the canvas. Values for its inputs by their names, as texts; a slider, panel or the like is set
    /// with `value`.
    Add {
        component: String,
        name: Option<String>,
        at: Option<[f32; 2]>,
        #[serde(default)]
        values: std::collections::BTreeMap<String, Value>,
        value: Option<Value>,
    },
    /// Takes objects out, with their wires.
    Remove { objects: Vec<String> },
    /// Draws a wire from an output to an input, in place of those that are there, or with `add` beside them.
    Connect {
        from: String,
        to: String,
        #[serde(default)]
        add: bool,
    },
    /// Takes the wires into an input away: all, or the one from an output.
    Disconnect { to: String, from: Option<String> },
    /// Gives an object another name.
    Rename { object: String, name: String },
    /// Gives a slider, panel, toggle, value list or parameter a value.
    Set { object: String, value: Value },
    /// Keeps values in an input, one a line; without any it keeps none.
    Keep { port: String, values: Option<String> },
    /// Moves an object to a place on the canvas.
    Move { object: String, at: [f32; 2] },
    /// Whether objects run.
    Enable { objects: Vec<String>, on: bool },
    /// Whether what objects give is shown.
    Preview { objects: Vec<String>, on: bool },
    /// What a port does to its data: flatten, graft, none, reverse, simplify, reparameterize, invert, degrees, unitize; or an
    /// expression in x. With `on` false it does so no more. With `output` an output is meant.
    Modify {
        port: String,
        does: Option<String>,
        expression: Option<String>,
        on: Option<bool>,
        #[serde(default)]
        output: bool,
    },
    /// Puts objects in a group with a label; RH_IN:name and RH_OUT:name mark inputs and outputs.
    Group { objects: Vec<String>, label: String },
    /// Takes a group away, by label or id, and leaves what is in it.
    Ungroup { group: String },
    /// Copies objects with the wires between and into them, moved by a step.
    Duplicate { objects: Vec<String>, by: [f32; 2] },
    /// Makes a cluster of objects.
    Cluster { objects: Vec<String>, name: Option<String> },
    /// Puts the inside of a cluster in its place.
    Explode { cluster: String },
    /// Adds an input, or with `output` an output, to an object that has any number of them, before the one at `index`.
    AddPort {
        object: String,
        index: Option<u32>,
        #[serde(default)]
        output: bool,
    },
    /// Takes such a port away.
    RemovePort {
        port: String,
        #[serde(default)]
        output: bool,
    },
    /// How much of a tree a script's input takes at once: item, list, tree.
    Access { port: String, access: String },
    /// Keeps the data that an input has now in it, and takes its wires away.
    Internalise { port: String },
    /// The document's units (as Meters), tolerances, name, author, description.
    Settings {
        units: Option<String>,
        tolerance: Option<f64>,
        angle_tolerance: Option<f64>,
        name: Option<String>,
        author: Option<String>,
        description: Option<String>,
    },
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct EditArguments {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// The operations, carried out in this order.
    operations: Vec<Operation>,
}

const WHAT: &str = "nothing was changed";

fn edit(store: &Store, given: EditArguments) -> Result<Reply, Fault> {
    let opened = store.find(WHAT, given.document.as_deref())?;
    if given.operations.is_empty() || given.operations.len() > MOST_EDITS {
        return Err(Fault::new(
            WHAT,
            "operations",
            format!("between 1 and {MOST_EDITS} operations are taken"),
        ));
    }
    let mut editor = opened.editor();
    let before = Arc::clone(editor.document());
    // Made on a copy, so that a call that is refused leaves no trace, and one that is not is one step.
    let mut draft = Editor::new(Document::clone(&before), editor.rules());
    let is_current = opened.solved().revision == Some(editor.revision());
    let mut made = Vec::new();
    for (k, operation) in given.operations.iter().enumerate() {
        carry_out(&mut draft, &opened, operation, is_current, &mut made)
            .map_err(|fault| fault.within(&format!("operation {k}")))?;
    }
    let name = match given.operations.len() {
        1 => draft.undo_name().unwrap_or("Edit").to_owned(),
        count => format!("{count} edits"),
    };
    opened.put(WHAT, &mut editor, Document::clone(draft.document()), name)?;
    let (revision, after) = (editor.revision(), Arc::clone(editor.document()));
    drop(editor);
    let names = Names::new(&after);
    let made: Vec<Value> = made
        .iter()
        .filter_map(|id| {
            let at = after.objects.iter().position(|object| object.id == *id)?;
            Some(json!({ "name": names.label(at), "id": id }))
        })
        .collect();
    let mut told = diff::changes(&before, &after, true);
    told["document"] = json!(opened.id);
    told["revision"] = json!(revision);
    told["made"] = json!(made);
    Ok(told.into())
}

/// The id of an object.
fn object(document: &Document, name: &str) -> Result<Uuid, Fault> {
    let at = Names::new(document).object(WHAT, name)?;
    document.objects.get(at).map(|object| object.id).ok_or_else(|| Fault::new(WHAT, name, "it is gone"))
}

fn objects(document: &Document, names: &[String]) -> Result<Vec<Uuid>, Fault> {
    let known = Names::new(document);
    let id = |name: &String| {
        let at = known.object(WHAT, name)?;
        document.objects.get(at).map(|object| object.id).ok_or_else(|| Fault::new(WHAT, name, "it is gone"))
    };
    names.iter().map(id).collect()
}

fn port(document: &Document, side: Side, name: &str) -> Result<Uuid, Fault> {
    Ok(Names::new(document).port(WHAT, side, name)?.port.id)
}

/// A value as the text that an input reads.
fn text(place: &str, value: &Value) -> Result<String, Fault> {
    match value {
        Value::String(text) => Ok(text.clone()),
        Value::Null | Value::Object(_) => {
            Err(Fault::new(WHAT, place, "the value must be a number, a text, true or false, or a list"))
        }
        other => Ok(other.to_string()),
    }
}

fn carry_out(
    editor: &mut Editor,
    opened: &Opened,
    operation: &Operation,
    is_current: bool,
    made: &mut Vec<Uuid>,
) -> Result<(), Fault> {
    let document = Arc::clone(editor.document());
    let edit = match operation {
        Operation::Add { component, name, at, values, value } => {
            return add(editor, component, name.as_deref(), *at, values, value.as_ref(), made);
        }
        Operation::Set { object: name, value } => {
            let id = object(&document, name)?;
            return set(editor, id, name, value);
        }
        Operation::Remove { objects: names } => Edit::Remove { objects: objects(&document, names)? },
        Operation::Connect { from, to, add } => Edit::Connect {
            from: port(&document, Side::Output, from)?,
            to: port(&document, Side::Input, to)?,
            how: if *add { Connection::Add } else { Connection::Replace },
        },
        Operation::Disconnect { to, from: None } => {
            Edit::Disconnect { port: port(&document, Side::Input, to)? }
        }
        Operation::Disconnect { to, from: Some(from) } => Edit::Connect {
            from: port(&document, Side::Output, from)?,
            to: port(&document, Side::Input, to)?,
            how: Connection::Remove,
        },
        Operation::Rename { object: old, name } => Edit::Change {
            objects: vec![object(&document, old)?],
            change: ObjectChange::Nickname { text: name.clone() },
        },
        Operation::Keep { port: name, values } => {
            Edit::Keep { port: port(&document, Side::Input, name)?, values: values.clone() }
        }
        Operation::Move { object: name, at } => Edit::Move { objects: vec![(object(&document, name)?, *at)] },
        Operation::Enable { objects: names, on } => {
            Edit::Change { objects: objects(&document, names)?, change: ObjectChange::Disabled { on: !on } }
        }
        Operation::Preview { objects: names, on } => {
            Edit::Change { objects: objects(&document, names)?, change: ObjectChange::Hidden { on: !on } }
        }
        Operation::Modify { port: name, does, expression, on, output } => {
            let side = if *output { Side::Output } else { Side::Input };
            let change = modifier(does.as_deref(), expression.as_deref(), on.unwrap_or(true))?;
            Edit::ChangePort { port: port(&document, side, name)?, change }
        }
        Operation::Group { objects: names, label } => {
            let id = Uuid::new_v4();
            apply(editor, opened, &Edit::Group { id, objects: objects(&document, names)? }, made)?;
            made.push(id);
            Edit::ChangeGroup { group: id, change: GroupChange::Label { text: label.clone() } }
        }
        Operation::Ungroup { group } => Edit::Ungroup { groups: vec![self::group(&document, group)?] },
        Operation::Duplicate { objects: names, by } => {
            Edit::Duplicate { objects: objects(&document, names)?, by: *by, seed: Uuid::new_v4() }
        }
        Operation::Cluster { objects: names, name } => {
            let id = Uuid::new_v4();
            let edit = Edit::MakeCluster { id, objects: objects(&document, names)? };
            apply(editor, opened, &edit, made)?;
            made.push(id);
            let Some(name) = name else { return Ok(()) };
            Edit::Change { objects: vec![id], change: ObjectChange::Nickname { text: name.clone() } }
        }
        Operation::Explode { cluster } => Edit::ExplodeCluster { cluster: object(&document, cluster)? },
        Operation::AddPort { object: name, index, output } => {
            let at = Names::new(&document).object(WHAT, name)?;
            let found = document.objects.get(at).ok_or_else(|| Fault::new(WHAT, name, "it is gone"))?;
            let side = if *output { Side::Output } else { Side::Input };
            let count = u32::try_from(found.ports(side).len()).unwrap_or(u32::MAX);
            Edit::AddPort {
                object: found.id,
                input: !output,
                index: index.unwrap_or(count),
                id: Some(Uuid::new_v4()),
            }
        }
        Operation::RemovePort { port: name, output } => {
            let side = if *output { Side::Output } else { Side::Input };
            Edit::RemovePort { port: port(&document, side, name)? }
        }
        Operation::Access { port: name, access } => {
            let access = match access.as_str() {
                "item" => AccessView::Item,
                "list" => AccessView::List,
                "tree" => AccessView::Tree,
                other => {
                    return Err(Fault::new(
                        WHAT,
                        format!("access \"{}\"", cut(other)),
                        "it is item, list or tree",
                    ));
                }
            };
            Edit::ChangePort {
                port: port(&document, Side::Input, name)?,
                change: PortChange::Access { access },
            }
        }
        Operation::Internalise { port: name } => {
            // What an input keeps must be what it has now.
            if !is_current {
                let why = "the results are older than the definition: call solve first";
                return Err(Fault::new(WHAT, "internalise", why));
            }
            Edit::Internalise { port: port(&document, Side::Input, name)? }
        }
        Operation::Settings { units, tolerance, angle_tolerance, name, author, description } => {
            Edit::Settings {
                units: units.clone(),
                tolerance: *tolerance,
                angle_tolerance: *angle_tolerance,
                preview_normal: None,
                preview_selected: None,
                name: name.clone(),
                author: author.clone(),
                description: description.clone(),
            }
        }
    };
    apply(editor, opened, &edit, made)
}

/// Carries an edit out, with the results that some edits keep.
fn apply(editor: &mut Editor, opened: &Opened, edit: &Edit, made: &mut Vec<Uuid>) -> Result<(), Fault> {
    let engine = opened.solved().engine;
    let places: std::collections::HashMap<Uuid, usize> = match edit {
        Edit::Internalise { .. } => {
            engine.document().objects.iter().enumerate().map(|(at, object)| (object.id, at)).collect()
        }
        _ => Default::default(),
    };
    let report = |id: Uuid| engine.report(*places.get(&id)?).cloned();
    let results = Solution::new(engine.document(), &report).beside(engine.options().model.as_deref());
    let change = editor.apply_with(edit, None, &[], &results);
    let change = change.map_err(|refusal| Fault::new(WHAT, "", cut(&refusal.to_string())))?;
    made.extend(change.made);
    Ok(())
}

/// Gives an object a value as part of a call.
fn set(editor: &mut Editor, id: Uuid, name: &str, value: &Value) -> Result<(), Fault> {
    let text = text(name, value)?;
    let mut after = Document::clone(editor.document());
    let Some(object) = after.objects.iter_mut().find(|object| object.id == id) else {
        return Err(Fault::new(WHAT, name, "it is gone"));
    };
    assign_input(object, &text).map_err(|error| Fault::new(WHAT, name, cut(&error.to_string())))?;
    editor.put_document(after, format!("Set {name}"), None);
    Ok(())
}

/// The gap between what is there and what is placed without a place, in canvas units.
const GAP: f32 = 60.0;

fn add(
    editor: &mut Editor,
    component: &str,
    name: Option<&str>,
    at: Option<[f32; 2]>,
    values: &std::collections::BTreeMap<String, Value>,
    value: Option<&Value>,
    made: &mut Vec<Uuid>,
) -> Result<(), Fault> {
    let place = format!("component \"{}\"", cut(component));
    let found = components::component(component).map_err(|why| Fault::new(WHAT, &place, why))?;
    let id = Uuid::new_v4();
    let at = at.unwrap_or_else(|| beside(editor));
    let refused = |refusal: katydid_session::Refusal| Fault::new(WHAT, &place, cut(&refusal.to_string()));
    let placed = Edit::Place { id, component: found.guid, at, with: None };
    editor.apply(&placed, None, &[]).map_err(refused)?;
    if let Some(name) = name {
        let named = ObjectChange::Nickname { text: name.to_owned() };
        editor.apply(&Edit::Change { objects: vec![id], change: named }, None, &[]).map_err(refused)?;
    }
    for (input, value) in values {
        let document = Arc::clone(editor.document());
        let port = port(&document, Side::Input, &format!("{id}.{input}"))?;
        let values = match value {
            Value::Array(list) => {
                list.iter().map(|item| text(input, item)).collect::<Result<Vec<_>, _>>()?.join("\n")
            }
            one => text(input, one)?,
        };
        editor.apply(&Edit::Keep { port, values: Some(values) }, None, &[]).map_err(refused)?;
    }
    if let Some(value) = value {
        set(editor, id, name.unwrap_or(found.name), value)?;
    }
    made.push(id);
    Ok(())
}

/// A place to the right of all that is there.
fn beside(editor: &Editor) -> [f32; 2] {
    let state = editor.state(&[]);
    let bounds = state.iter().flat_map(|state| &state.objects).map(|object| object.bounds);
    bounds.fold([100.0, 100.0], |[x, y], [left, _, width, _]| [x.max(left + width + GAP), y])
}

fn modifier(does: Option<&str>, expression: Option<&str>, on: bool) -> Result<PortChange, Fault> {
    if let (None, Some(text)) = (does, expression) {
        return Ok(PortChange::Expression { text: on.then(|| text.to_owned()) });
    }
    let mapping = |mapping| PortChange::Mapping { mapping: if on { mapping } else { MappingView::None } };
    Ok(match does.unwrap_or_default() {
        "flatten" => mapping(MappingView::Flatten),
        "graft" => mapping(MappingView::Graft),
        "none" => mapping(MappingView::None),
        "reverse" => PortChange::Reverse { on },
        "simplify" => PortChange::Simplify { on },
        "reparameterize" => PortChange::Reparameterize { on },
        "invert" => PortChange::Invert { on },
        "degrees" => PortChange::Degrees { on },
        "unitize" => PortChange::Unitize { on },
        "expression" => PortChange::Expression { text: expression.filter(|_| on).map(str::to_owned) },
        other => {
            let why = "it is flatten, graft, none, reverse, simplify, reparameterize, invert, degrees, unitize or expression";
            return Err(Fault::new(WHAT, format!("does \"{}\"", cut(other)), why));
        }
    })
}

/// The id of a group, by its label or id.
fn group(document: &Document, name: &str) -> Result<Uuid, Fault> {
    let is_it = |object: &&Object| match object.special() {
        Some(katydid_definition::document::Special::Group(group)) => {
            group.label == name || object.id.to_string() == name
        }
        _ => false,
    };
    let found: Vec<&Object> = document.objects.iter().filter(is_it).collect();
    let told = |why: &str| Fault::new(WHAT, format!("group \"{}\"", cut(name)), why);
    match found.as_slice() {
        [one] => Ok(one.id),
        [] => Err(told("there is no such group")),
        _ => Err(told("several groups have that label: use the id")),
    }
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Steps {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// How many steps; 1 when not given.
    steps: Option<usize>,
}

fn undo(store: &Store, given: Steps) -> Result<Reply, Fault> {
    walk(store, &given, "nothing was undone", "there is nothing to undo", false)
}

fn redo(store: &Store, given: Steps) -> Result<Reply, Fault> {
    walk(store, &given, "nothing was done again", "there is nothing to do again", true)
}

/// Takes a step back, or makes it again; what it is called.
fn step(editor: &mut Editor, again: bool) -> Option<String> {
    let name = if again { editor.redo_name() } else { editor.undo_name() }.map(str::to_owned);
    if again { editor.redo() } else { editor.undo() }.and(name)
}

fn walk(store: &Store, given: &Steps, what: &str, none: &str, again: bool) -> Result<Reply, Fault> {
    let opened = store.find(what, given.document.as_deref())?;
    let mut editor = opened.editor();
    let before = Arc::clone(editor.document());
    let wanted = given.steps.unwrap_or(1).clamp(1, MOST_EDITS);
    let steps: Vec<String> = match &opened.original {
        Some(original) => original.walk(what, &mut editor, again, wanted)?,
        None => std::iter::from_fn(|| step(&mut editor, again)).take(wanted).collect(),
    };
    if steps.is_empty() {
        return Err(Fault::new(what, &opened.id, none));
    }
    let mut told = diff::changes(&before, editor.document(), true);
    told["document"] = json!(opened.id);
    told["steps"] = json!(steps);
    told["revision"] = json!(editor.revision());
    if opened.original.is_none() {
        told["undo"] = json!(editor.undo_name());
        told["redo"] = json!(editor.redo_name());
    }
    Ok(told.into())
}
