//! Components that another server solves: Hops.

use std::fmt;

use katydid_component::{Budget, Cancel, Limits, Message, registry};
use katydid_data::cast::Rules;
use katydid_data::{Kind, Tree};
use katydid_definition::archive::ItemValue;
use katydid_definition::document::{Object, Port};
use uuid::{Uuid, uuid};

use crate::collect;
use crate::object::{Turn, output};
use crate::report::{ObjectReport, Status};

/// Hops: a component that asks a server for its results.
pub const HOPS: Uuid = uuid!("c69bb52c-88ba-4640-b69f-188d111029e8");

/// Asks other servers. Whoever solves a definition that came from elsewhere decides which may be asked.
pub trait Remote: fmt::Debug + Send + Sync {
    /// The data of the outputs, in the order they are asked for.
    ///
    /// # Errors
    /// The message to show when the server may not be asked, does not answer, or cannot do it.
    fn solve(&self, question: &Question<'_>) -> Result<Solved, Message>;
}

/// What a component asks another server.
#[derive(Debug)]
pub struct Question<'a> {
    /// The component that asks.
    pub component: Uuid,
    /// Where: the URL of a component or of a definition, or the path of one.
    pub location: &'a str,
    /// The bytes of the definition, where the component keeps it itself.
    pub kept: Option<&'a [u8]>,
    /// The inputs by name, with their data.
    pub inputs: Vec<(&'a str, Tree)>,
    /// The outputs by name.
    pub outputs: Vec<&'a str>,
    /// Units and tolerances.
    pub rules: Rules,
    /// What may be used: to be asked while one waits.
    pub budget: &'a Budget,
    /// What a definition that is solved for the component may use, with the time that is left.
    pub limits: Limits,
    /// Stops it.
    pub cancel: &'a Cancel,
}

/// What came back.
#[derive(Debug, Default)]
pub struct Solved {
    /// The data of the outputs.
    pub outputs: Vec<Tree>,
    /// What the server said.
    pub messages: Vec<Message>,
}

/// Solves a Hops component; `None` when the object is none, or no server may be asked at all.
pub(crate) fn solve(turn: &Turn<'_>, object: &Object, wired: &[Vec<&Tree>]) -> Option<ObjectReport> {
    let remote = turn.options.remote.as_ref().filter(|_| object.component == HOPS)?;
    let rules = turn.options.rules;
    let mut messages = Vec::new();
    let mut inputs = Vec::with_capacity(object.inputs.len());
    for (k, port) in object.inputs.iter().enumerate() {
        let wires = wired.get(k).map_or(&[][..], Vec::as_slice);
        let collected = collect::port(object, port, None, wires, turn.options);
        messages.extend(collected.messages);
        inputs
            .push((port.name.as_str(), collect::cast_to(collected.tree, kind(port), &rules, &mut messages)));
    }
    let budget = Budget::new(turn.options.limits, turn.options.cancel.clone(), turn.deadline);
    let settings = object.container();
    let question = Question {
        component: object.id,
        location: settings.str("RemoteDefinitionLocation").unwrap_or_default(),
        kept: settings.item("InternalizeDefinition").and_then(ItemValue::as_bytes),
        inputs,
        outputs: object.outputs.iter().map(|port| port.name.as_str()).collect(),
        rules,
        budget: &budget,
        limits: Limits { time: turn.deadline.left(), ..turn.options.limits },
        cancel: &turn.options.cancel,
    };
    let solved = budget.check().and_then(|()| remote.solve(&question)).unwrap_or_else(|message| {
        messages.push(message);
        Solved::default()
    });
    messages.extend(solved.messages);
    let mut trees = solved.outputs.into_iter();
    let outputs: Vec<Tree> = object
        .outputs
        .iter()
        .enumerate()
        .map(|(k, port)| {
            let tree = trees.next().unwrap_or_default();
            let tree = collect::cast_to(tree, kind(port), &rules, &mut messages);
            output(object, k, tree, turn.options, &mut messages)
        })
        .collect();
    let items = outputs.iter().map(Tree::item_count).sum();
    if let Err(message) = budget.items(items) {
        return Some(ObjectReport::idle(Status::Error, vec![message], object.outputs.len()));
    }
    let status = ObjectReport::status_of(&messages);
    Some(ObjectReport { outputs, ..ObjectReport::idle(status, messages, 0) })
}

/// The type of a port: that of the parameter it is.
fn kind(port: &Port) -> Kind {
    let parameter = port.type_id.and_then(registry::by_guid);
    parameter.and_then(|parameter| parameter.output(0)).map_or(Kind::Generic, |port| port.kind)
}
