//! Components that another server solves: Hops.

use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

use katydid_component::{Account, Budget, Cancel, Limits, Message};
use katydid_data::cast::Rules;
use katydid_data::{Kind, Tree, Value};
use katydid_definition::archive::{Chunk, ItemValue};
use katydid_definition::document::{Object, Port};
use uuid::{Uuid, uuid};

use crate::collect;
use crate::object::Turn;
use crate::outside;
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
    /// What counts the memory of such a definition: the asking one's account.
    pub memory: &'a Arc<Account>,
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
pub(crate) fn solve(
    turn: &Turn<'_>,
    object: &Object,
    wired: &[Vec<&Tree>],
    budget: &Budget,
) -> Option<ObjectReport> {
    let remote = turn.options.remote.as_ref().filter(|_| object.component == HOPS)?;
    let rules = turn.options.rules;
    let mut messages = Vec::new();
    let steered = match steered(turn, object, wired, &mut messages) {
        Ok(steered) => steered,
        Err(status) => return Some(ObjectReport::idle(status, messages, object.outputs.len())),
    };
    let question = Question {
        component: object.id,
        location: &steered.location,
        kept: steered.kept,
        inputs: steered.inputs,
        outputs: object.outputs.iter().map(|port| port.name.as_str()).collect(),
        rules,
        budget,
        limits: Limits { time: turn.deadline.left(), ..turn.options.limits },
        memory: turn.account,
        cancel: &turn.options.cancel,
    };
    let solved = budget.check().and_then(|()| remote.solve(&question)).unwrap_or_else(|message| {
        messages.push(message);
        Solved::default()
    });
    messages.extend(solved.messages);
    Some(outside::report(turn, object, solved.outputs, messages, budget))
}

/// What the inputs of a component make of what it asks.
struct Steered<'a> {
    location: Cow<'a, str>,
    kept: Option<&'a [u8]>,
    inputs: Vec<(&'a str, Tree)>,
}

/// Collects the inputs: those that are handed on, and those that say how it asks, which count by their first item.
///
/// # Errors
/// How the component comes out when it asks nobody.
fn steered<'a>(
    turn: &Turn<'_>,
    object: &'a Object,
    wired: &[Vec<&Tree>],
    messages: &mut Vec<Message>,
) -> Result<Steered<'a>, Status> {
    let settings = object.container();
    let saved = settings.str("RemoteDefinitionLocation").unwrap_or_default();
    let mut steered = Steered {
        location: Cow::Borrowed(saved),
        kept: settings.item("InternalizeDefinition").and_then(ItemValue::as_bytes),
        inputs: Vec::with_capacity(object.inputs.len()),
    };
    for (k, port) in object.inputs.iter().enumerate() {
        let wires = wired.get(k).map_or(&[][..], Vec::as_slice);
        let collected = collect::port(object, port, None, wires, turn.options);
        messages.extend(collected.messages);
        let steering = Steering::of(port, settings);
        let kind = steering.map_or_else(|| outside::kind(port), Steering::kind);
        let tree = collect::cast_to(collected.tree, kind, &turn.options.rules, messages);
        let Some(steering) = steering else {
            steered.inputs.push((port.name.as_str(), tree));
            continue;
        };
        if tree.is_empty() {
            messages.push(outside::no_data(port));
            return Err(Status::NoData);
        }
        match (steering, tree.column().get(0)) {
            (Steering::Enabled, Some(Value::Boolean(false))) => {
                return Err(ObjectReport::status_of(messages));
            }
            (Steering::Enabled, _) => {}
            (Steering::Path, value) => {
                steered.location = match value {
                    Some(Value::Text(path)) => Cow::Owned(path.to_string()),
                    _ => Cow::Borrowed(""),
                };
                // What the component keeps is what lay where it was saved with.
                steered.kept = steered.kept.filter(|_| steered.location.trim() == saved.trim());
            }
        }
    }
    Ok(steered)
}

/// An input that says how the component asks, and is not handed on: its menu shows it, and it stands before the others.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Steering {
    /// Where the definition is, in place of where it was when the component was saved.
    Path,
    /// Whether anybody is asked at all.
    Enabled,
}

impl Steering {
    fn of(port: &Port, settings: &Chunk) -> Option<Self> {
        let shows = |name: &str| settings.item(name).and_then(ItemValue::as_bool).unwrap_or(false);
        match port.name.as_str() {
            "_Path" if shows("ShowInput_Path") => Some(Self::Path),
            "_Enabled" if shows("ShowInput_Enabled") => Some(Self::Enabled),
            _ => None,
        }
    }

    fn kind(self) -> Kind {
        match self {
            Self::Path => Kind::Text,
            Self::Enabled => Kind::Boolean,
        }
    }
}
