//! The chunks of objects, as Grasshopper would write them.

use uuid::Uuid;

use super::ast::{Group, Modifier, Target, Values};
use super::build::{Builder, Insides, Node, What};
use super::problem::Fault;
use super::slot::Slot;
use super::{own, residue, timing, value};
use crate::archive::{self, Chunk, Colour, Item, ItemValue};
use crate::document::{Access, ids};

/// The colour of a new group.
const GROUP_COLOUR: Colour = Colour::new(150, 170, 135, 255);
/// The frames of groups, by their number in the archive.
pub(super) const BORDERS: [&str; 4] = ["none", "box", "blob", "rectangle"];

/// The chunks of all objects in this order, numbered.
pub(super) fn chunks(builder: &mut Builder<'_, '_>, order: &[usize]) -> Vec<Chunk> {
    let mut chunks = Vec::with_capacity(order.len());
    for (number, at) in (0..).zip(order) {
        let sources = sources(builder, *at);
        let members = members(builder, *at);
        let Some(node) = builder.nodes.get(*at) else { continue };
        let (settings, details) = (node.settings, node.details);
        let mut faults = Vec::new();
        let data = |n: u32| builder.data.get(&n).copied();
        let mut chunk = build(node, &sources, &members, builder.insides, &data, &mut faults);
        builder.faults.append(&mut faults);
        chunk.index = Some(number);
        residue::sort(&mut chunk);
        for edits in [settings, details] {
            let (top, inner): (Vec<_>, Vec<_>) = edits.iter().cloned().partition(|edit| edit.top);
            builder.apply(&mut chunk, &top);
            if let Some(container) = chunk.child_mut("Container") {
                builder.apply(container, &inner);
            }
        }
        chunks.push(chunk);
    }
    chunks
}

/// Where the wires of each input come from.
fn sources(builder: &mut Builder<'_, '_>, at: usize) -> Vec<Vec<Uuid>> {
    let Some(node) = builder.nodes.get(at) else { return Vec::new() };
    let wires: Vec<_> =
        node.inputs.iter().map(|slot| slot.given.map_or(&[][..], |given| given.wires.as_slice())).collect();
    wires.into_iter().map(|wires| wires.iter().filter_map(|wire| builder.source(wire)).collect()).collect()
}

/// The ids of a group's members, or of a trigger's targets.
fn members(builder: &mut Builder<'_, '_>, at: usize) -> Vec<Uuid> {
    let referred: Vec<&Target> = match builder.nodes.get(at).map(|node| (node.what, node.component)) {
        Some((What::Group(group), _)) => group.members.iter().collect(),
        Some((What::Call(call), ids::TRIGGER)) => timing::targets(call).collect(),
        _ => return Vec::new(),
    };
    let mut ids = Vec::with_capacity(referred.len());
    for member in referred {
        match member {
            Target::Guid(id) => ids.push(*id),
            Target::Label(label) => {
                let found = builder.find(label).and_then(|at| builder.nodes.get(at));
                ids.extend(found.map(|node| node.id));
            }
            Target::Call(_) => {}
        }
    }
    ids
}

fn build(
    node: &Node<'_>,
    sources: &[Vec<Uuid>],
    members: &[Uuid],
    insides: Insides,
    data: &value::Data<'_>,
    faults: &mut Vec<Fault>,
) -> Chunk {
    let mut chunk = Chunk::new("Object");
    chunk.items = vec![Item::new("GUID", node.component), Item::new("Name", node.name.as_str())];
    let mut container = Chunk { name: "Container".to_owned(), ..node.own.clone() };
    let description = node.facts.as_ref().map_or("", |facts| facts.description.as_str());
    container.set("Description", description);
    container.set("InstanceGuid", node.id);
    container.set("Name", node.name.as_str());
    container.set("NickName", node.nickname.as_str());
    if node.flags.disabled {
        container.set("Locked", true);
    }
    if node.flags.hidden {
        container.set("Hidden", true);
    }
    if let What::Group(group) = node.what {
        frame(&mut container, group, members, faults);
    }
    if node.component == ids::TRIGGER {
        for (k, id) in members.iter().enumerate() {
            container.items.push(Item::indexed("Target", count(k), *id));
        }
        container.set("TargetCount", count(members.len()));
    }
    if let Some(place) = node.place
        && (place.pivot.is_some() || place.bounds.is_some())
    {
        let mut attributes = Chunk::new("Attributes");
        if let Some(bounds) = place.bounds {
            attributes.set("Bounds", ItemValue::RectangleF(bounds));
        }
        if let Some(pivot) = place.pivot {
            attributes.set("Pivot", ItemValue::PointF(pivot));
        }
        if node.component == ids::PANEL {
            for side in ["MarginLeft", "MarginRight", "MarginTop"] {
                attributes.set(side, 0);
            }
        }
        container.set_child(attributes);
    }
    let mut port = |slot: &Slot<'_>, k: usize, chunk: &mut Chunk| {
        let sources = sources.get(k).map_or(&[][..], Vec::as_slice);
        fill(chunk, slot, sources, data, faults);
    };
    if node.floating {
        container.set("Optional", false);
        if let Some(slot) = node.inputs.first() {
            port(slot, 0, &mut container);
        }
    } else if node.variable {
        let mut parameters = Chunk::new("ParameterData");
        parameters.set("InputCount", count(node.inputs.len()));
        parameters.set("OutputCount", count(node.outputs.len()));
        for (name, id, slots, inputs) in
            [("InputParam", "InputId", &node.inputs, true), ("OutputParam", "OutputId", &node.outputs, false)]
        {
            for (k, slot) in slots.iter().enumerate() {
                parameters.set_at(id, count(k), slot.type_id.unwrap_or(ids::DATA));
                let mut chunk = named(Chunk::indexed(name, count(k)), slot);
                port(slot, if inputs { k } else { usize::MAX }, &mut chunk);
                parameters.chunks.push(chunk);
            }
        }
        container.set_child(parameters);
    } else {
        for (name, slots, inputs) in
            [("param_input", &node.inputs, true), ("param_output", &node.outputs, false)]
        {
            for (k, slot) in slots.iter().enumerate() {
                let mut chunk = named(Chunk::indexed(name, count(k)), slot);
                port(slot, if inputs { k } else { usize::MAX }, &mut chunk);
                container.chunks.push(chunk);
            }
        }
    }
    if let Some(inner) = &node.inner {
        hooks(&mut container, node, inner);
        if insides == Insides::Packed {
            match archive::write_gh(inner) {
                Ok(bytes) => container.set("ClusterDocument", ItemValue::ByteArray(bytes)),
                Err(error) => {
                    let span = if let What::Call(call) = node.what { call.span } else { Default::default() };
                    faults.push(Fault::new(span.at, span.len, format!("the cluster {error}")));
                }
            }
        }
    }
    chunk.chunks = vec![container];
    chunk
}

fn count(n: usize) -> i32 {
    i32::try_from(n).unwrap_or(i32::MAX)
}

/// What a port has that is not a floating parameter.
fn named(mut chunk: Chunk, slot: &Slot<'_>) -> Chunk {
    chunk.items = vec![
        Item::new("Description", slot.description.as_str()),
        Item::new("InstanceGuid", slot.id),
        Item::new("Name", slot.name.as_str()),
        Item::new("NickName", slot.nickname.as_str()),
        Item::new("Optional", slot.optional),
    ];
    match slot.access {
        Access::Item => {}
        Access::List => chunk.set("Access", 1),
        Access::Tree => chunk.set("Access", 2),
    }
    chunk
}

/// Wires, values and modifiers.
fn fill(
    chunk: &mut Chunk,
    slot: &Slot<'_>,
    sources: &[Uuid],
    data: &value::Data<'_>,
    faults: &mut Vec<Fault>,
) {
    for (k, source) in sources.iter().enumerate() {
        chunk.items.push(Item::indexed("Source", count(k), *source));
    }
    chunk.set("SourceCount", count(sources.len()));
    let kept = match slot.given.map(|given| &given.values) {
        None | Some(Values::Default) => slot.default.clone(),
        Some(values) => value::persistent(values, slot.expect, data, faults),
    };
    if let Some(kept) = kept {
        let several = slot.type_id.is_some_and(|id| [ids::DATA, ids::GEOMETRY].contains(&id));
        chunk.set_child(kept.to_chunk(several));
    }
    let given: &[Modifier] = slot.given.map_or(&[], |given| &given.modifiers);
    for modifier in given.iter().chain(slot.modifiers) {
        let (name, value) = modifier.kind.item();
        chunk.set(name, value);
    }
}

fn frame(container: &mut Chunk, group: &Group, members: &[Uuid], faults: &mut Vec<Fault>) {
    let (mut colour, mut border) = (GROUP_COLOUR, 1);
    for argument in &group.attributes {
        if let Values::One(lit) = &argument.given.values {
            match value::colour(lit) {
                Ok(found) => colour = found,
                Err(fault) => faults.push(fault),
            }
        } else if let Some(found) = own::word_of(argument, &BORDERS) {
            border = found;
        } else {
            let message = "a colour such as rgb(255, 0, 0), or box, blob, rectangle should stand here";
            faults.push(Fault::new(argument.span.at, argument.span.len, message));
        }
    }
    container.set("Border", border);
    container.set("Colour", colour);
    for (k, id) in members.iter().enumerate() {
        container.items.push(Item::indexed("ID", count(k), *id));
    }
    container.set("ID_Count", count(members.len()));
    container.set_child(Chunk::new("Attributes"));
}

/// The attributes of a group that are not those of a new one.
pub(super) fn print_frame(container: &Chunk) -> Vec<String> {
    let mut attributes = Vec::new();
    if let Some(colour) = container.colour("Colour").filter(|colour| *colour != GROUP_COLOUR) {
        attributes.push(super::raw_value::colour_form(colour));
    }
    let border = container.i32("Border").filter(|border| *border != 1);
    let word = border.and_then(|border| BORDERS.get(usize::try_from(border).ok()?));
    // `none` means something else in the language.
    attributes.extend(word.filter(|word| **word != "none").map(|word| (*word).to_owned()));
    attributes
}

/// The ties between a cluster's ports and the objects inside, in the order of both.
fn hooks(container: &mut Chunk, node: &Node<'_>, inner: &Chunk) {
    let objects = inner.child("DefinitionObjects").map(|list| list.chunks.as_slice()).unwrap_or_default();
    let inside = |component: Uuid| {
        objects
            .iter()
            .filter(move |object| object.guid("GUID") == Some(component))
            .filter_map(|object| object.child("Container")?.guid("InstanceGuid"))
    };
    let inputs = node.inputs.iter().map(|slot| slot.id).zip(inside(ids::CLUSTER_INPUT));
    let outputs = node.outputs.iter().map(|slot| slot.id).zip(inside(ids::CLUSTER_OUTPUT));
    let pairs: Vec<(Uuid, Uuid)> = inputs.chain(outputs).collect();
    let mut map = Chunk::new("ParamMap");
    map.set("Count", count(pairs.len()));
    for (k, (port, object)) in pairs.into_iter().enumerate() {
        map.set_at("Key", count(k), port);
        map.set_at("Value", count(k), object);
    }
    container.set_child(map);
}
