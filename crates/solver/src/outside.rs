//! What components have in common whose results are made outside the solver: by a script, or by another server.

use katydid_component::{Budget, Message, registry};
use katydid_data::{Kind, Tree};
use katydid_definition::document::{Object, Port};

use crate::collect;
use crate::object::{Turn, output};
use crate::report::{ObjectReport, Status};

/// The report of a component that was given trees for its outputs, in their order: they are cast to the types of the
/// outputs, and counted.
pub(crate) fn report(
    turn: &Turn<'_>,
    object: &Object,
    trees: Vec<Tree>,
    mut messages: Vec<Message>,
    budget: &Budget,
) -> ObjectReport {
    let mut trees = trees.into_iter();
    let outputs: Vec<Tree> = object
        .outputs
        .iter()
        .enumerate()
        .map(|(k, port)| {
            let tree = trees.next().unwrap_or_default();
            let tree = collect::cast_to(tree, kind(port), &turn.options.rules, &mut messages);
            output(object, k, tree, turn.options, &mut messages)
        })
        .collect();
    let items = outputs.iter().map(Tree::item_count).sum();
    if let Err(message) = budget.items(items) {
        return ObjectReport::idle(Status::Error, vec![message], object.outputs.len());
    }
    let status = ObjectReport::status_of(&messages);
    ObjectReport { outputs, ..ObjectReport::idle(status, messages, 0) }
}

/// What is said of an input that has no data, and has to have some.
pub(crate) fn no_data(port: &Port) -> Message {
    Message::warning(format!("Input parameter {} failed to collect data", port.nickname))
}

/// The type of a port: that of the parameter it is.
pub(crate) fn kind(port: &Port) -> Kind {
    let parameter = port.type_id.and_then(registry::by_guid);
    parameter.and_then(|parameter| parameter.output(0)).map_or(Kind::Generic, |port| port.kind)
}
