//! Clusters taken apart.

use std::collections::{HashMap, HashSet};

use katydid_definition::document::{Mapping, Modifiers, Object, Port, Side, ids};
use uuid::Uuid;

use super::clusters::around;
use super::{groups, objects, paste};
use crate::Refusal;
use crate::editor::{self, Draft};
use crate::view::size;

/// Puts the inside of a cluster in its place.
pub(super) fn explode(draft: &mut Draft<'_>, id: Uuid) -> Result<(), Refusal> {
    let Some(at) = draft.place(id) else { return Ok(()) };
    let cluster = draft.at(at)?.clone();
    let inner = editor::content(&cluster)?;
    let hooks = cluster.hooks();
    // Copies of a cluster have the same ids inside.
    let new = paste::renew(&inner.objects, id);
    let renewed = |id: Uuid| new.get(&id).copied().unwrap_or(id);
    let tie = |port: Uuid| hooks.iter().find(|hook| hook.port == port).map(|hook| renewed(hook.object));
    let step = step(&inner.objects, &cluster);
    let mut inside: Vec<Object> = inner.objects.iter().map(|object| paste::renamed(object, &new)).collect();
    for object in &mut inside {
        super::arrange::shift(object, step);
    }
    let mut gone: HashSet<Uuid> = HashSet::new();
    // What an input hook gave now comes from outside.
    for port in &cluster.inputs {
        let Some(hook) = tie(port.id) else { continue };
        if port.modifiers == Modifiers::default() && !port.has_persistent {
            gone.insert(hook);
            replace(&mut inside, hook, &port.sources)?;
        } else {
            to_parameter(&mut inside, hook, &cluster, port)?;
        }
    }
    let mut outer: HashMap<Uuid, Vec<Uuid>> = HashMap::new();
    for port in &cluster.outputs {
        let Some(hook) = tie(port.id) else { continue };
        let Some(object) = inside.iter().find(|object| object.id == hook) else { continue };
        let own = object.inputs.first();
        let plain = own.is_some_and(|port| port.modifiers == Modifiers::default() && !port.has_persistent);
        if plain && port.modifiers == Modifiers::default() {
            outer.insert(port.id, own.map(|port| port.sources.clone()).unwrap_or_default());
            gone.insert(hook);
        } else {
            outer.insert(port.id, vec![hook]);
            to_parameter(&mut inside, hook, &cluster, port)?;
        }
    }
    inside.retain(|object| !gone.contains(&object.id));
    // A hook that nothing ties is a parameter like any other.
    let loose: Vec<Uuid> = inside
        .iter()
        .filter(|object| [ids::CLUSTER_INPUT, ids::CLUSTER_OUTPUT].contains(&object.component))
        .map(|object| object.id)
        .collect();
    for hook in loose {
        to_data(&mut inside, hook);
    }
    for (port, sources) in outer {
        for object in &mut draft.document.objects {
            replace(std::slice::from_mut(object), port, &sources)?;
        }
    }
    let came: Vec<Uuid> = inside.iter().map(|object| object.id).collect();
    let (groups, others): (Vec<Object>, Vec<Object>) =
        inside.into_iter().partition(|object| object.component == ids::GROUP);
    draft.document.objects.splice(0..0, groups);
    draft.document.objects.extend(others);
    draft.stir();
    for group in draft.document.objects.iter_mut().filter(|object| object.component == ids::GROUP) {
        let members: Vec<Uuid> =
            group.container().list("ID").into_iter().filter_map(|(_, id)| id.as_guid()).collect();
        if members.contains(&id) {
            let now: Vec<Uuid> =
                members.into_iter().filter(|member| *member != id).chain(came.iter().copied()).collect();
            groups::put_members(group, &now);
        }
    }
    objects::remove(draft, &[id])
}

/// The step that brings the inside of a cluster to where it stands.
fn step(inner: &[Object], cluster: &Object) -> [f32; 2] {
    let [x, y, w, h] = around(inner);
    let [left, top, width, height] = size::bounds(cluster);
    [left + 0.5 * (width - w) - x, top + 0.5 * (height - h) - y].map(f32::round)
}

/// Puts other outputs in the place of one in every input that reads it.
fn replace(objects: &mut [Object], old: Uuid, new: &[Uuid]) -> Result<(), Refusal> {
    for object in objects {
        for k in 0..object.inputs.len() {
            let sources = object.inputs.get(k).map_or(&[][..], |port| &port.sources);
            if !sources.contains(&old) {
                continue;
            }
            let now: Vec<Uuid> = sources
                .iter()
                .flat_map(|source| if *source == old { new } else { std::slice::from_ref(source) })
                .copied()
                .collect();
            object.set_sources(k, &now)?;
        }
    }
    Ok(())
}

/// Makes a Data parameter of a hook.
fn to_data(objects: &mut [Object], hook: Uuid) {
    let Some(object) = objects.iter_mut().find(|object| object.id == hook) else { return };
    let mut chunk = object.chunk().clone();
    chunk.set("GUID", ids::DATA);
    chunk.set("Name", "Data");
    if let Some(container) = chunk.child_mut("Container") {
        container.set("Name", "Data");
    }
    *object = Object::from_chunk(chunk);
}

/// Makes a parameter of a hook that does what the cluster's port did: it keeps its values, its wires and its modifiers.
fn to_parameter(objects: &mut [Object], hook: Uuid, cluster: &Object, port: &Port) -> Result<(), Refusal> {
    to_data(objects, hook);
    let Some(object) = objects.iter_mut().find(|object| object.id == hook) else { return Ok(()) };
    if let Some(values) = cluster.persistent(port) {
        object.set_persistent(0, Some(&values))?;
    }
    let is_input = cluster.inputs.iter().any(|input| input.id == port.id);
    if is_input {
        object.set_sources(0, &port.sources)?;
    }
    let own = object.inputs.first().map(|port| port.modifiers.clone()).unwrap_or_default();
    let m = &port.modifiers;
    if m.mapping != Mapping::None && own.mapping == Mapping::None {
        object.set_mapping(Side::Input, 0, m.mapping)?;
    }
    let container = object.container_mut();
    for (name, on) in [
        ("ReverseData", m.reverse),
        ("SimplifyData", m.simplify),
        ("Reparameterize", m.reparameterize),
        ("Unitize", m.unitize),
        ("InvertBooleans", m.invert),
        ("UseDegrees", m.degrees),
    ] {
        if on {
            container.set(name, true);
        }
    }
    if let Some(expression) = &m.expression {
        container.set("InternalExpression", expression.as_str());
    }
    object.refresh();
    Ok(())
}
