//! Clusters: objects that stand for a document inside.

use std::collections::{HashMap, HashSet};

use katydid_definition::archive::{self, Archive, Chunk, Encoding, ItemValue};
use katydid_definition::document::{Document, Hook, NewPort, Object, Side, ids};
use katydid_definition::kd;
use uuid::Uuid;

use super::{bounded, keep, make, objects, ports};
use crate::Refusal;
use crate::editor::Draft;
use crate::view::size;

/// A port of a cluster that is being made: the hook inside, and what it is tied to outside.
struct Gate {
    hook: Object,
    port: Uuid,
    /// The outputs outside that an input reads, or the inputs outside that read an output.
    outside: Vec<Uuid>,
}

/// Makes a cluster of objects.
pub(super) fn make(draft: &mut Draft<'_>, id: Uuid, objects: &[Uuid]) -> Result<(), Refusal> {
    bounded(objects)?;
    if draft.has(id) {
        return Ok(());
    }
    let wanted: HashSet<Uuid> = objects.iter().copied().collect();
    for &object in &wanted {
        let object = draft.object(object)?;
        if [ids::CLUSTER_INPUT, ids::CLUSTER_OUTPUT].contains(&object.component) {
            let reason = "it ties the cluster that it is in to the outside".to_owned();
            return Err(Refusal::Unfit { object: object.title().to_owned(), reason });
        }
    }
    let inside: Vec<Object> =
        draft.document.objects.iter().filter(|object| wanted.contains(&object.id)).cloned().collect();
    if id.is_nil() || !inside.iter().any(|object| !object.is_annotation()) {
        return Err(Refusal::Senseless("a cluster needs an id and an object that computes".to_owned()));
    }
    no_loop(draft, &wanted)?;
    let around = around(&inside);
    let (mut inside, inputs, outputs) = cut(draft, id, inside, around)?;
    let mut cluster = Object::new_component(ids::CLUSTER, "Cluster", "Cluster", id);
    cluster.container_mut().set("Description", "Contains a cluster of Grasshopper components");
    for (side, gates) in [(Side::Input, &inputs), (Side::Output, &outputs)] {
        for gate in gates {
            let port = keep::port_for(&gate.hook, gate.port);
            let k = cluster.add_port(side, &NewPort { optional: side == Side::Input, ..port });
            if side == Side::Input {
                cluster.set_sources(k, &gate.outside)?;
            }
        }
    }
    if cluster.container().child("ParameterData").is_none() {
        let mut none = Chunk::new("ParameterData");
        none.set("InputCount", 0);
        none.set("OutputCount", 0);
        cluster.container_mut().set_child(none);
    }
    put_hooks(
        &mut cluster,
        inputs.iter().chain(&outputs).map(|gate| Hook { port: gate.port, object: gate.hook.id }),
    );
    inside.extend(inputs.iter().chain(&outputs).map(|gate| gate.hook.clone()));
    let mut document = empty(id)?;
    document.objects = inside;
    let bytes = archive::write_gh(&document.to_archive().root)?;
    cluster.container_mut().set("ClusterDocument", ItemValue::ByteArray(bytes));
    cluster.refresh();
    let [x, y, w, h] = around;
    make::place(&mut cluster, [x + 0.5 * w, y + 0.5 * h]);
    // Groups keep the cluster in the place of what went into it.
    let groups: Vec<Uuid> = draft
        .document
        .objects
        .iter()
        .filter(|object| object.component == ids::GROUP && !wanted.contains(&object.id))
        .filter(|group| {
            group.container().list("ID").iter().any(|(_, m)| m.as_guid().is_some_and(|m| wanted.contains(&m)))
        })
        .map(|group| group.id)
        .collect();
    draft.document.objects.push(cluster);
    draft.stir();
    for group in groups {
        let group = draft.object(group)?;
        let mut members: Vec<Uuid> =
            group.container().list("ID").into_iter().filter_map(|(_, id)| id.as_guid()).collect();
        members.retain(|member| !wanted.contains(member));
        members.push(id);
        super::groups::put_members(group, &members);
    }
    let readers: Vec<(Uuid, Uuid)> =
        outputs.iter().flat_map(|gate| gate.outside.iter().map(move |reader| (*reader, gate.port))).collect();
    // Readers outside read the cluster; then what is inside can go.
    let from: HashMap<Uuid, Uuid> = outputs
        .iter()
        .filter_map(|gate| Some((*gate.hook.inputs.first()?.sources.first()?, gate.port)))
        .collect();
    for (reader, _) in readers {
        let at = draft.input(reader)?;
        let object = draft.at(at.object)?;
        let sources = object.inputs.get(at.port).map_or(&[][..], |port| &port.sources);
        let now: Vec<Uuid> = sources.iter().map(|source| *from.get(source).unwrap_or(source)).collect();
        if now != sources {
            object.set_sources(at.port, &now)?;
        }
    }
    let gone: Vec<Uuid> = wanted.into_iter().collect();
    objects::remove(draft, &gone)
}

/// Refuses objects between which there are others that are to stay outside: these would read the cluster, and the
/// cluster them.
fn no_loop(draft: &Draft<'_>, wanted: &HashSet<Uuid>) -> Result<(), Refusal> {
    let objects = &draft.document.objects;
    let mut readers: HashMap<Uuid, Vec<usize>> = HashMap::new();
    for (at, object) in objects.iter().enumerate() {
        for source in object.inputs.iter().flat_map(|port| &port.sources) {
            readers.entry(*source).or_default().push(at);
        }
    }
    let reading = |at: usize| {
        let outputs = objects.get(at).map_or(&[][..], |object| &object.outputs);
        outputs.iter().filter_map(|port| readers.get(&port.id)).flatten().copied()
    };
    let is_inside = |at: usize| objects.get(at).is_some_and(|object| wanted.contains(&object.id));
    let mut seen: HashSet<usize> = HashSet::new();
    let first = (0..objects.len()).filter(|at| is_inside(*at)).flat_map(reading).filter(|at| !is_inside(*at));
    let mut stack: Vec<usize> = first.collect();
    while let Some(at) = stack.pop() {
        if !seen.insert(at) {
            continue;
        }
        for next in reading(at) {
            if is_inside(next) {
                let title = objects.get(at).map_or("?", |object| object.title());
                return Err(Refusal::Loop(format!("{title} would read the cluster and be read by it")));
            }
            stack.push(next);
        }
    }
    Ok(())
}

/// The rectangle around objects.
pub(super) fn around(objects: &[Object]) -> [f32; 4] {
    let rects = objects.iter().filter(|object| object.component != ids::GROUP).map(size::bounds);
    size::around(rects.flat_map(|[x, y, w, h]| [[x, y], [x + w, y + h]]))
}

/// Cuts objects off from the outside: every output that they read gets a hook, and every one of theirs that is read.
type Cut = (Vec<Object>, Vec<Gate>, Vec<Gate>);

fn cut(draft: &Draft<'_>, id: Uuid, mut inside: Vec<Object>, around: [f32; 4]) -> Result<Cut, Refusal> {
    let own: HashSet<Uuid> =
        inside.iter().flat_map(|object| object.outputs.iter().map(|port| port.id)).collect();
    let [left, top, width, _] = around;
    let mut inputs: Vec<Gate> = Vec::new();
    let mut by_source: HashMap<Uuid, usize> = HashMap::new();
    for object in &mut inside {
        for k in 0..object.inputs.len() {
            let Some(port) = object.inputs.get(k).cloned() else { continue };
            if port.sources.iter().all(|source| own.contains(source)) {
                continue;
            }
            let mut sources = Vec::with_capacity(port.sources.len());
            for source in port.sources {
                if own.contains(&source) {
                    sources.push(source);
                    continue;
                }
                let n = inputs.len();
                let at = *by_source.entry(source).or_insert(n);
                if at == n {
                    let hook_id = kd::derived_id(id, &format!("hook in {n}"));
                    let mut hook = make::object(ids::CLUSTER_INPUT, hook_id)?;
                    hook.set_nickname(if object.is_floating() { object.title() } else { &port.nickname });
                    let row = u16::try_from(n).map_or(0.0, f32::from);
                    make::place(&mut hook, [left - 100.0, top + 15.0 + 30.0 * row]);
                    let port = kd::derived_id(id, &format!("in {n}"));
                    inputs.push(Gate { hook, port, outside: vec![source] });
                }
                if let Some(gate) = inputs.get(at) {
                    sources.push(gate.hook.id);
                }
            }
            object.set_sources(k, &sources)?;
        }
    }
    let mut readers: HashMap<Uuid, Vec<Uuid>> = HashMap::new();
    let members: HashSet<Uuid> = inside.iter().map(|object| object.id).collect();
    for object in draft.document.objects.iter().filter(|object| !members.contains(&object.id)) {
        for port in &object.inputs {
            for source in port.sources.iter().filter(|source| own.contains(source)) {
                readers.entry(*source).or_default().push(port.id);
            }
        }
    }
    let mut outputs: Vec<Gate> = Vec::new();
    for object in &inside {
        for port in &object.outputs {
            let Some(outside) = readers.remove(&port.id) else { continue };
            let n = outputs.len();
            let mut hook = make::object(ids::CLUSTER_OUTPUT, kd::derived_id(id, &format!("hook out {n}")))?;
            hook.set_nickname(if object.is_floating() { object.title() } else { &port.nickname });
            hook.set_sources(0, &[port.id])?;
            let row = u16::try_from(n).map_or(0.0, f32::from);
            make::place(&mut hook, [left + width + 100.0, top + 15.0 + 30.0 * row]);
            outputs.push(Gate { hook, port: kd::derived_id(id, &format!("out {n}")), outside });
        }
    }
    Ok((inside, inputs, outputs))
}

/// A document to go into a cluster: its root is the definition itself.
fn empty(id: Uuid) -> Result<Document, Refusal> {
    let mut root = Document::new().to_archive().root.child("Definition").cloned().unwrap_or_default();
    root.name = "Document".to_owned();
    if let Some(header) = root.child_mut("DocumentHeader") {
        header.set("DocumentID", kd::derived_id(id, "document"));
    }
    Ok(Document::from_archive(Archive::new(root, Encoding::Binary))?)
}

/// Writes the ties between a cluster's ports and the objects inside.
fn put_hooks(cluster: &mut Object, hooks: impl Iterator<Item = Hook>) {
    let mut map = Chunk::new("ParamMap");
    let mut count = 0;
    for hook in hooks {
        map.set_at("Key", count, hook.port);
        map.set_at("Value", count, hook.object);
        count += 1;
    }
    map.set("Count", count);
    cluster.container_mut().set_child(map);
    cluster.refresh();
}

/// Brings a cluster's ports in line with what is inside: hooks that are new get ports, ports whose hook is gone go, and
/// a hook's new name is that of its port.
pub(crate) fn tie_ports(cluster: &mut Object, before: &Document, after: &Document) {
    let mut hooks = cluster.hooks();
    let name = |document: &Document, id: Uuid| {
        document.objects.iter().find(|object| object.id == id).map(|object| object.title().to_owned())
    };
    let tied = hooks.clone();
    for (side, component) in [(Side::Input, ids::CLUSTER_INPUT), (Side::Output, ids::CLUSTER_OUTPUT)] {
        let inner: Vec<&Object> = after.objects.iter().filter(|o| o.component == component).collect();
        let gone: Vec<usize> = cluster
            .ports(side)
            .iter()
            .enumerate()
            .filter(|(_, port)| {
                let hook = tied.iter().find(|hook| hook.port == port.id);
                // What was never tied is not ours to take away.
                hook.is_some_and(|hook| !inner.iter().any(|object| object.id == hook.object))
            })
            .map(|(k, _)| k)
            .collect();
        if !gone.is_empty() {
            let order: Vec<usize> = (0..cluster.ports(side).len()).filter(|k| !gone.contains(k)).collect();
            ports::reorder(cluster, side, &order);
        }
        for object in inner {
            match tied.iter().find(|hook| hook.object == object.id) {
                Some(hook) => {
                    if name(before, object.id).is_some_and(|was| was != object.title())
                        && let Some(place) = cluster
                            .ports(side)
                            .iter()
                            .find(|port| port.id == hook.port)
                            .map(|port| port.place)
                        && let Some(chunk) = place.find_mut(cluster.container_mut())
                    {
                        chunk.set("Name", object.title());
                        chunk.set("NickName", object.title());
                    }
                }
                None => {
                    let id = kd::derived_id(cluster.id, &format!("hook {}", object.id));
                    let new = keep::port_for(object, id);
                    cluster.add_port(side, &NewPort { optional: side == Side::Input, ..new });
                    hooks.push(Hook { port: id, object: object.id });
                }
            }
        }
        cluster.refresh();
    }
    let ports: HashSet<Uuid> = cluster.inputs.iter().chain(&cluster.outputs).map(|port| port.id).collect();
    hooks.retain(|hook| ports.contains(&hook.port));
    if hooks != tied {
        put_hooks(cluster, hooks.into_iter());
        make::fit(cluster);
    }
}
