//! Wires: an input's list of the outputs that it reads.

use std::collections::{HashMap, HashSet};

use katydid_component::registry;
use katydid_data::Kind;
use katydid_definition::document::{Object, PortRef, Side, ids};
use uuid::Uuid;

use super::{make, objects, sound};
use crate::Refusal;
use crate::editor::Draft;
use crate::protocol::Connection;
use crate::view::{kind, size};

/// The most wires that one input may have.
const MOST_WIRES: usize = 100_000;

/// Draws a wire from an output to an input, or takes it away.
pub(super) fn connect(draft: &mut Draft<'_>, from: Uuid, to: Uuid, how: Connection) -> Result<(), Refusal> {
    let input = draft.input(to)?;
    let sources = draft.at(input.object)?.inputs.get(input.port).map(|port| port.sources.clone());
    let mut sources = sources.ok_or(Refusal::NoPort(to))?;
    match how {
        Connection::Remove => sources.retain(|source| *source != from),
        Connection::Replace => sources = vec![from],
        Connection::Add if sources.contains(&from) => {}
        Connection::Add => sources.push(from),
    }
    if how != Connection::Remove {
        if sources.len() > MOST_WIRES {
            return Err(Refusal::Senseless(format!("an input takes at most {MOST_WIRES} wires")));
        }
        let output = draft.lookup().output(from).ok_or(Refusal::NoPort(from))?;
        takes_wires(draft, output, input)?;
        no_loop(draft, output.object, input.object)?;
    }
    set(draft, input, sources)
}

/// Whether a wire can begin and end there at all.
fn takes_wires(draft: &mut Draft<'_>, output: PortRef, input: PortRef) -> Result<(), Refusal> {
    for (at, side) in [(output.object, Side::Output), (input.object, Side::Input)] {
        let object = draft.at(at)?;
        if !size::shows(object, side) {
            let reason = match side {
                Side::Input => "nothing can be wired into it",
                Side::Output => "nothing can be wired out of it",
            };
            return Err(Refusal::Unfit { object: object.title().to_owned(), reason: reason.to_owned() });
        }
    }
    Ok(())
}

/// Gives an input these wires.
fn set(draft: &mut Draft<'_>, input: PortRef, sources: Vec<Uuid>) -> Result<(), Refusal> {
    let object = draft.at(input.object)?;
    if object.inputs.get(input.port).is_some_and(|port| port.sources != sources) {
        object.set_sources(input.port, &sources)?;
    }
    Ok(())
}

/// Refuses a wire from one object to another when the first reads the second already.
fn no_loop(draft: &mut Draft<'_>, from: usize, to: usize) -> Result<(), Refusal> {
    let lookup = draft.lookup();
    let mut came: HashMap<usize, usize> = HashMap::from([(from, from)]);
    let mut stack = vec![from];
    while let Some(at) = stack.pop() {
        if at == to {
            return Err(Refusal::Loop(way(draft, &came, from, to)));
        }
        let Some(object) = draft.document.objects.get(at) else { continue };
        for source in object.inputs.iter().flat_map(|port| &port.sources) {
            if let Some(before) = lookup.output(*source).map(|output| output.object)
                && let std::collections::hash_map::Entry::Vacant(new) = came.entry(before)
            {
                new.insert(at);
                stack.push(before);
            }
        }
    }
    Ok(())
}

/// The objects on the way of a loop, by name.
fn way(draft: &Draft<'_>, came: &HashMap<usize, usize>, from: usize, to: usize) -> String {
    const SHOWN: usize = 6;
    let mut names = Vec::new();
    let mut at = to;
    loop {
        names.push(draft.document.objects.get(at).map_or("?", |object| object.title()).to_owned());
        if at == from || names.len() > SHOWN {
            break;
        }
        at = came.get(&at).copied().unwrap_or(from);
    }
    if at != from {
        names.push("…".to_owned());
    }
    match names.as_slice() {
        [one] => format!("{one} would read itself"),
        _ => format!("{} would read each other", names.join(", ")),
    }
}

/// Takes all wires of a grip to another grip of the same side.
pub(super) fn rewire(
    draft: &mut Draft<'_>,
    from: Uuid,
    to: Uuid,
    input: Option<bool>,
) -> Result<(), Refusal> {
    if from == to {
        return Ok(());
    }
    let lookup = draft.lookup();
    let (inputs, outputs) =
        ((lookup.input(from), lookup.input(to)), (lookup.output(from), lookup.output(to)));
    let are_outputs = outputs.0.is_some() && outputs.1.is_some();
    match (inputs, outputs) {
        ((Some(old), Some(new)), _) if input.unwrap_or(!are_outputs) => take_over(draft, old, new),
        (_, (Some(_), Some(new))) if input != Some(true) => give_over(draft, from, to, new),
        ((None, None), (None, None)) => Err(Refusal::NoPort(from)),
        _ => {
            let reason = "wires go from an input to an input, or from an output to an output";
            Err(Refusal::Senseless(reason.to_owned()))
        }
    }
}

/// Gives the wires into an input to another.
fn take_over(draft: &mut Draft<'_>, old: PortRef, new: PortRef) -> Result<(), Refusal> {
    let wires = |draft: &Draft<'_>, at: PortRef| -> Vec<Uuid> {
        let port = draft.document.objects.get(at.object).and_then(|object| object.inputs.get(at.port));
        port.map_or_else(Vec::new, |port| port.sources.clone())
    };
    let incoming = wires(draft, old);
    let mut sources = wires(draft, new);
    for source in incoming {
        if sources.contains(&source) {
            continue;
        }
        if let Some(output) = draft.lookup().output(source) {
            takes_wires(draft, output, new)?;
            no_loop(draft, output.object, new.object)?;
        }
        sources.push(source);
    }
    set(draft, old, Vec::new())?;
    set(draft, new, sources)
}

/// Lets all that reads an output read another.
fn give_over(draft: &mut Draft<'_>, from: Uuid, to: Uuid, new: PortRef) -> Result<(), Refusal> {
    for (reader, input) in readers(draft, from) {
        takes_wires(draft, new, PortRef { object: reader, side: Side::Input, port: input })?;
        no_loop(draft, new.object, reader)?;
    }
    substitute(draft, from, &[to])
}

/// The inputs that read an output, as object and input.
fn readers(draft: &Draft<'_>, output: Uuid) -> Vec<(usize, usize)> {
    let objects = draft.document.objects.iter().enumerate();
    let inputs =
        objects.flat_map(|(at, object)| object.inputs.iter().enumerate().map(move |(k, port)| (at, k, port)));
    inputs.filter(|(_, _, port)| port.sources.contains(&output)).map(|(at, k, _)| (at, k)).collect()
}

/// Puts other outputs in the place of one, wherever it is read.
fn substitute(draft: &mut Draft<'_>, old: Uuid, new: &[Uuid]) -> Result<(), Refusal> {
    for (at, k) in readers(draft, old) {
        let object = draft.at(at)?;
        let mut sources: Vec<Uuid> = Vec::new();
        for source in object.inputs.get(k).map_or(&[][..], |port| &port.sources) {
            let with = if *source == old { new } else { std::slice::from_ref(source) };
            for id in with {
                if !sources.contains(id) {
                    sources.push(*id);
                }
            }
        }
        object.set_sources(k, &sources)?;
    }
    Ok(())
}

/// Takes the wires from these outputs away.
pub(super) fn forget(draft: &mut Draft<'_>, outputs: &HashSet<Uuid>) -> Result<(), Refusal> {
    if outputs.is_empty() {
        return Ok(());
    }
    for object in &mut draft.document.objects {
        for k in 0..object.inputs.len() {
            let sources = object.inputs.get(k).map_or(&[][..], |port| &port.sources);
            if sources.iter().any(|source| outputs.contains(source)) {
                let rest: Vec<Uuid> = sources.iter().copied().filter(|id| !outputs.contains(id)).collect();
                object.set_sources(k, &rest)?;
            }
        }
    }
    Ok(())
}

/// Takes all wires into an input away.
pub(super) fn disconnect(draft: &mut Draft<'_>, port: Uuid) -> Result<(), Refusal> {
    let input = draft.input(port)?;
    set(draft, input, Vec::new())
}

/// Puts a relay in the middle of a wire.
pub(super) fn insert_relay(
    draft: &mut Draft<'_>,
    id: Uuid,
    from: Uuid,
    to: Uuid,
    at: [f32; 2],
) -> Result<(), Refusal> {
    sound(&at)?;
    if draft.has(id) {
        return Ok(());
    }
    let input = draft.input(to)?;
    let sources = draft.at(input.object)?.inputs.get(input.port).map(|port| port.sources.clone());
    let mut sources = sources.unwrap_or_default();
    let Some(slot) = sources.iter_mut().find(|source| **source == from) else {
        return Err(Refusal::Senseless("there is no such wire".to_owned()));
    };
    *slot = id;
    let mut relay = make::object(ids::RELAY, id)?;
    relay.set_sources(0, &[from])?;
    make::place(&mut relay, at);
    set(draft, input, sources)?;
    draft.document.objects.push(relay);
    draft.stir();
    Ok(())
}

/// Takes an object with one input and one output out, and joins its wires.
pub(super) fn remove_and_join(draft: &mut Draft<'_>, id: Uuid) -> Result<(), Refusal> {
    let Some(at) = draft.place(id) else { return Ok(()) };
    let object = draft.at(at)?;
    let ([input], [output]) = (object.inputs.as_slice(), object.outputs.as_slice()) else {
        return Err(Refusal::Unfit {
            object: object.title().to_owned(),
            reason: "only what has one input and one output leaves its wires behind".to_owned(),
        });
    };
    let (sources, output) = (input.sources.clone(), output.id);
    substitute(draft, output, &sources)?;
    objects::remove(draft, &[id])
}

/// Draws the wire that a new object was made for: from that output to the input that suits it best, or the other way.
pub(super) fn first(draft: &mut Draft<'_>, id: Uuid, port: Uuid) -> Result<(), Refusal> {
    let lookup = draft.lookup();
    let from = lookup.output(port);
    let into = lookup.input(port);
    // Of a parameter, which is both, the output is meant: data flows on.
    let (side, given) = match (from, into) {
        (Some(given), _) => (Side::Input, given),
        (None, Some(given)) => (Side::Output, given),
        (None, None) => return Err(Refusal::NoPort(port)),
    };
    let given = kind_of(draft.at(given.object)?, given);
    let new = draft.object(id)?;
    let all = (0..new.ports(side).len()).map(|k| PortRef { object: 0, side, port: k });
    let suits = |at: &PortRef| match kind_of(new, *at) {
        own if own == given => 0,
        Kind::Generic => 2,
        Kind::Geometry if given.is_geometry() => 1,
        _ => 3,
    };
    let best = all.min_by_key(suits).and_then(|at| new.ports(side).get(at.port)).map(|port| port.id);
    let own = best.or_else(|| objects::first_port(new, side));
    let Some(own) = own else {
        let reason = "it has no port for that wire".to_owned();
        return Err(Refusal::Unfit { object: new.title().to_owned(), reason });
    };
    match side {
        Side::Input => connect(draft, port, own, Connection::Replace),
        Side::Output => connect(draft, own, port, Connection::Replace),
    }
}

/// The type of a port's items.
fn kind_of(object: &Object, at: PortRef) -> Kind {
    let component = registry::by_guid(object.component);
    let declared = component.and_then(|c| match at.side {
        Side::Input => c.input(at.port),
        Side::Output => c.output(at.port),
    });
    object.ports(at.side).get(at.port).map_or(Kind::Generic, |port| kind(port, declared.map(|d| d.kind)))
}
