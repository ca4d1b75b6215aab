//! One object's turn: collect, run, modify.

use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use katydid_component::{
    Access, Account, Budget, Call, Deadline, Message, PortNames, StandIn, plugin_of_library, registry,
    stand_in,
};
use katydid_data::{Column, Kind, Path, Tree};
use katydid_definition::document::{Document, Object, Side, Special, ids};

use crate::report::{ObjectReport, Status};
use crate::{Options, cluster, collect, modifiers, recorder, remote, script};

/// What an object needs to run besides its inputs.
pub(crate) struct Turn<'a> {
    pub(crate) document: &'a Document,
    pub(crate) options: &'a Options,
    /// What the whole solve takes.
    pub(crate) account: &'a Arc<Account>,
    pub(crate) deadline: Deadline,
    /// How many clusters the object is inside of.
    pub(crate) depth: usize,
    /// Data that comes from outside, by object: what a cluster's inputs bring in.
    pub(crate) given: &'a HashMap<usize, Tree>,
    /// What inputs read in place of their wires and of what they keep, by object and input.
    pub(crate) brought: &'a HashMap<(usize, usize), Tree>,
    /// What recorders have recorded, when the definition runs in time.
    pub(crate) memory: Option<&'a HashMap<usize, Tree>>,
    pub(crate) wanted: &'a [bool],
}

/// Solves object `index`, whose wires bring `wired`: for each input, the trees in wire order.
pub(crate) fn solve(turn: &Turn<'_>, index: usize, wired: &[Vec<&Tree>], budget: &Budget) -> ObjectReport {
    let Some(object) = turn.document.objects.get(index) else {
        return ObjectReport::idle(Status::Ok, Vec::new(), 0);
    };
    if object.is_annotation() || is_note(turn.document, object) {
        return ObjectReport::idle(Status::Ok, Vec::new(), object.outputs.len());
    }
    if object.locked {
        return ObjectReport::idle(Status::Disabled, Vec::new(), object.outputs.len());
    }
    if let Some(tree) = turn.given.get(&index) {
        let mut messages = Vec::new();
        let outputs = vec![output(object, 0, tree.clone(), turn.options, &mut messages)];
        return ObjectReport { outputs, ..ObjectReport::idle(Status::Ok, messages, 0) };
    }
    if let Some(report) = brought(turn, index, object) {
        return report;
    }
    if let Some(report) = cluster::solve(turn, object, wired) {
        return report;
    }
    if let Some(report) = remote::solve(turn, object, wired, budget) {
        return report;
    }
    if let Some(report) = script::solve(turn, object, wired, budget) {
        return report;
    }
    match of_object(turn.document, object) {
        Some(found) => run(turn, index, object, &found, wired, budget),
        None => unsupported(turn.document, object),
    }
}

/// Whether an object is of a plug-in whose objects are there for the reader of the canvas only.
pub fn is_note(document: &Document, object: &Object) -> bool {
    let library = object.lib.and_then(|lib| document.library(lib));
    library.and_then(|library| plugin_of_library(&library.name)).is_some_and(|plugin| plugin.only_notes)
}

/// The component that runs an object: Grasshopper's own, or one that stands for a plug-in's.
pub fn of_object(document: &Document, object: &Object) -> Option<StandIn> {
    if let Some(component) = registry::by_guid(object.component) {
        return Some(StandIn::from(component));
    }
    let library = document.library(object.lib?)?;
    let names = |side: Side| -> Vec<PortNames<'_>> {
        object.ports(side).iter().map(|port| (port.name.as_str(), port.nickname.as_str())).collect()
    };
    let (inputs, outputs) = (names(Side::Input), names(Side::Output));
    stand_in(object.component, Some(&library.name), &object.name, &inputs, &outputs)
}

/// An object of a type that Katydid does not have gives a null on each output.
fn unsupported(document: &Document, object: &Object) -> ObjectReport {
    let plugin = object
        .lib
        .and_then(|lib| document.library(lib))
        .map(|library| format!(" of the plug-in {}", library.name))
        .unwrap_or_default();
    let reason = registry::unsupported(object.component).map(|known| format!(": {}", known.reason));
    let text = format!("{}{plugin} is not supported{}", object.name, reason.unwrap_or_default());
    let mut report = ObjectReport::idle(Status::Unsupported, vec![Message::warning(text)], 0);
    report.outputs = vec![Tree::branch_at(Path::zero(), Column::nulls(1)); object.outputs.len()];
    report
}

/// The report of an object that hands nothing on, a slider say: it gives what was brought in place of what it keeps.
fn brought(turn: &Turn<'_>, index: usize, object: &Object) -> Option<ObjectReport> {
    let tree = turn.brought.get(&(index, 0))?;
    let component = registry::by_guid(object.component);
    let hands_on = match object.special() {
        // A slider, toggle or list gives what it keeps, whatever comes over a wire.
        None
        | Some(Special::Contextual(_) | Special::Panel(_) | Special::DataRecorder(_) | Special::DataDam(_)) => {
            component.is_some_and(|component| !component.inputs.is_empty())
        }
        Some(_) => false,
    };
    if hands_on {
        return None;
    }
    let mut messages = Vec::new();
    let kind = component.and_then(|component| component.output(0)).map_or(Kind::Generic, |port| port.kind);
    let tree = collect::cast_to(tree.clone(), kind, &turn.options.rules, &mut messages);
    let outputs = vec![output(object, 0, tree, turn.options, &mut messages)];
    let status = ObjectReport::status_of(&messages);
    Some(ObjectReport { outputs, ..ObjectReport::idle(status, messages, 0) })
}

fn run(
    turn: &Turn<'_>,
    index: usize,
    object: &Object,
    found: &StandIn,
    wired: &[Vec<&Tree>],
    budget: &Budget,
) -> ObjectReport {
    let rules = turn.options.rules;
    let component = found.component;
    let mut messages = Vec::new();
    let mut inputs = Vec::with_capacity(object.inputs.len());
    let mut missing = false;
    let records = object.component == ids::DATA_RECORDER;
    let memory = turn.memory.filter(|_| records || object.component == ids::VALUE_TRACKER);
    for (k, port) in object.inputs.iter().enumerate() {
        let declared = found.input(k);
        let wires = wired.get(k).map_or(&[][..], Vec::as_slice);
        let collected = match turn.brought.get(&(index, k)) {
            Some(tree) => collect::brought(object, port, declared, tree, turn.options),
            None => collect::port(object, port, declared, wires, turn.options),
        };
        messages.extend(collected.messages);
        let optional = declared.is_none_or(|d| d.optional || d.many && d.access != Access::Item);
        // A recorder still has what it has recorded.
        if collected.tree.is_empty() && !optional && !(records && memory.is_some()) {
            missing = true;
            let name = if port.nickname.is_empty() { &port.name } else { &port.nickname };
            messages.push(Message::warning(if object.is_floating() {
                format!("Floating parameter {} failed to collect data", object.title())
            } else {
                format!("Input parameter {name} failed to collect data")
            }));
        }
        inputs.push(collected.tree);
    }
    missing |= found.is_short_of_inputs(object.inputs.len());
    let mut inputs = found.arranged(inputs);
    // An old file may know fewer inputs than the component has today: those have their defaults.
    for declared in component.inputs.iter().skip(inputs.len()).filter(|d| !d.many) {
        inputs.push(declared.default.map_or_else(Tree::empty, |default| default()));
    }
    if missing {
        return ObjectReport::idle(Status::NoData, messages, object.outputs.len());
    }
    let names: Vec<String> = object.inputs.iter().map(|port| port.nickname.clone()).collect();
    let by_name = found.is_by_name();
    let call = Call {
        inputs: &inputs,
        input_names: &names,
        output_count: if by_name { component.outputs.len() } else { object.outputs.len() },
        wanted: if by_name { &[] } else { turn.wanted },
        settings: object.container(),
        rules,
        budget,
        files: &turn.options.files,
        outbox: turn.options.outbox.as_deref(),
        kept: turn.options.kept.as_deref(),
        model: turn.options.model.as_deref(),
    };
    let outcome = catch_unwind(AssertUnwindSafe(|| (component.run)(&call)));
    let Ok(outcome) = outcome else {
        messages.push(Message::error("Internal error: this component failed on its data; please report it"));
        return ObjectReport::idle(Status::Error, messages, object.outputs.len());
    };
    messages.extend(outcome.messages);
    let recorded = memory.map(|memory| {
        let new = outcome.outputs.first().cloned().unwrap_or_default();
        recorder::record(object, memory.get(&index), new, &turn.options.limits, &mut messages)
    });
    // A tracker hands on what came, a recorder what it has recorded.
    let given = recorded.clone().filter(|_| records);
    let trees = given.map_or(outcome.outputs, |tree| vec![tree]);
    let given = |k: usize| found.output_place(k).and_then(|j| trees.get(j)).cloned().unwrap_or_default();
    let outputs: Vec<Tree> =
        (0..object.outputs.len()).map(|k| output(object, k, given(k), turn.options, &mut messages)).collect();
    let mut status = ObjectReport::status_of(&messages);
    if status == Status::Ok && object.is_floating() && outputs.iter().all(Tree::is_empty) {
        let text = format!("Floating parameter {} failed to collect data", object.title());
        messages.push(Message::warning(text));
        status = Status::NoData;
    }
    ObjectReport { outputs, recorded, ..ObjectReport::idle(status, messages, 0) }
}

/// What output `k` shows: its data after its own modifiers. A floating parameter is one port, whose modifiers stand
/// with its input; they work on what it gives, be it wired, kept or, as with a slider, stored.
pub(crate) fn output(
    object: &Object,
    k: usize,
    tree: Tree,
    options: &Options,
    messages: &mut Vec<Message>,
) -> Tree {
    let (port, side) = if object.is_floating() {
        (object.inputs.get(k), Side::Input)
    } else {
        (object.outputs.get(k), Side::Output)
    };
    match port {
        Some(port) => modifiers::apply(tree, port, side, &options.rules, messages),
        None => tree,
    }
}
