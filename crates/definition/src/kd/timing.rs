//! What a Trigger, a Data Recorder and a Data Dam keep, as arguments.

use uuid::Uuid;

use super::ast::{Argument, Call, Target, Values};
use super::own::Own;
use super::value::plain;
use crate::archive::Chunk;
use crate::document::ids;

/// The interval of a new trigger, in milliseconds.
const INTERVAL: i32 = 1000;
/// Steps of time in a second, as delays are stored.
const SECOND: f64 = 1e7;

/// `Trigger(one, another, interval = 500)`: the objects that it has solved again. Their ids are put in once all objects
/// have theirs (see [`targets`]).
pub(super) fn trigger(own: &mut Own<'_, '_>, container: &mut Chunk) {
    container.set("Interval", own.number("interval").map_or(INTERVAL, |ms| ms as i32));
    container.set("LockTargets", false);
    own.rest.retain(|argument| !is_target(argument));
}

fn is_target(argument: &Argument) -> bool {
    let given = &argument.given;
    argument.name.is_none()
        && argument.choice.is_none()
        && given.modifiers.is_empty()
        && matches!(given.values, Values::Default)
        && !given.wires.is_empty()
        && given.wires.iter().all(|wire| wire.port.is_none() && !matches!(wire.target, Target::Call(_)))
}

/// What a trigger's statement names as its targets.
pub(super) fn targets(call: &Call) -> impl Iterator<Item = &Target> {
    let named = call.arguments.iter().filter(|argument| is_target(argument));
    named.flat_map(|argument| &argument.given.wires).map(|wire| &wire.target)
}

/// `Data Recorder(wire, limit = 10, record = false)`.
pub(super) fn recorder(own: &mut Own<'_, '_>, container: &mut Chunk) {
    if let Some(limit) = own.number("limit") {
        container.set("DataLimit", limit as i32);
    }
    if let Some(record) = own.boolean("record") {
        container.set("RecordData", record);
    }
}

/// `Data Dam(wire, delay = 0.5)`, in seconds.
pub(super) fn dam(own: &mut Own<'_, '_>, container: &mut Chunk) {
    if let Some(delay) = own.number("delay") {
        container.set("BufferDelay", (delay * SECOND).round() as i64);
    }
}

/// The arguments but a trigger's targets.
pub(super) fn print(component: Uuid, container: &Chunk) -> Vec<String> {
    let mut arguments = Vec::new();
    match component {
        ids::TRIGGER => {
            let interval = container.i32("Interval").filter(|interval| *interval != INTERVAL);
            arguments.extend(interval.map(|ms| format!("interval = {ms}")));
        }
        ids::DATA_RECORDER => {
            arguments.extend(container.i32("DataLimit").map(|limit| format!("limit = {limit}")));
            arguments.extend(container.bool("RecordData").map(|record| format!("record = {record}")));
        }
        _ => {
            let delay = container.i64("BufferDelay").map(|steps| steps as f64 / SECOND);
            arguments.extend(delay.map(|delay| format!("delay = {}", plain(delay))));
        }
    }
    arguments
}
