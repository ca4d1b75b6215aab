//! New objects, as Grasshopper writes them.

use katydid_component::{Component, registry};
use katydid_definition::archive::{Chunk, Colour, ItemValue};
use katydid_definition::document::{NewPort, Object, Side, ids};
use katydid_definition::kd::{self, Catalogue, Facts, PortFacts};
use uuid::{Uuid, uuid};

use crate::view::size;
use crate::{Refusal, Registry, controls};

const ENTWINE: Uuid = uuid!("c9785b8e-2f30-4f90-8ee3-cca710f82402");
const SORT_LIST: Uuid = uuid!("6f93d366-919f-4dda-a35e-ba03dd62799b");
const DATA_DAM: Uuid = uuid!("65283518-ad00-49d3-87fb-f76823ebb162");
const SIFT_PATTERN: Uuid = uuid!("3249222f-f536-467a-89f4-f0353fba455a");
const STREAM_GATE: Uuid = uuid!("71fcc052-6add-4d70-8d97-cfb37ea9d169");

/// A new object of a component type, its ports as they begin, without a place.
///
/// # Errors
/// When there is no such component, or it cannot begin empty, as a cluster.
pub fn object(component: Uuid, id: Uuid) -> Result<Object, Refusal> {
    match component {
        ids::GROUP => return Ok(annotation(component, "Group", "", id)),
        ids::SCRIBBLE => return Ok(scribble(id)),
        ids::CLUSTER | ids::SKETCH => {
            return Err(Refusal::Senseless("a cluster or sketch cannot begin empty".to_owned()));
        }
        ids::RELAY => return Ok(relay(id)),
        ids::CLUSTER_INPUT => return Ok(hook(component, "Cluster Input", "In", id)),
        ids::CLUSTER_OUTPUT => return Ok(hook(component, "Cluster Output", "Out", id)),
        _ => {}
    }
    let unknown = || match registry::unsupported(component) {
        Some(known) => Refusal::Senseless(format!("{} is not supported: {}", known.name, known.reason)),
        None => Refusal::Senseless(format!("there is no component with the type id {component}")),
    };
    let known = registry::by_guid(component).ok_or_else(unknown)?;
    let facts = Registry.by_guid(component).ok_or_else(unknown)?;
    let mut object = if known.floating {
        Object::new_parameter(component, known.name, known.nick, id)
    } else {
        Object::new_component(component, known.name, known.nick, id)
    };
    object.container_mut().set("Description", known.help);
    if known.floating {
        floating(&mut object, &facts)?;
    } else {
        for side in [Side::Input, Side::Output] {
            for k in 0..begins_with(known, side) {
                add(&mut object, &facts, side, k, port_id(id, side, k));
            }
        }
    }
    begin(&mut object);
    Ok(object)
}

/// The id of a port that an object begins with.
fn port_id(object: Uuid, side: Side, k: usize) -> Uuid {
    kd::derived_id(object, &format!("{} {k}", if side == Side::Input { "in" } else { "out" }))
}

/// How many ports an object of that type begins with.
fn begins_with(component: &Component, side: Side) -> usize {
    let ports = if side == Side::Input { component.inputs } else { component.outputs };
    let fixed = ports.iter().filter(|port| !port.many).count();
    if fixed == ports.len() {
        return fixed;
    }
    let many_inputs = component.has_variable_inputs();
    fixed
        + match component.guid {
            ENTWINE => 3,
            SORT_LIST | DATA_DAM => 1,
            SIFT_PATTERN | STREAM_GATE => 2,
            _ if side == Side::Input || many_inputs => 2,
            _ => 1,
        }
}

/// The values of a parameter, where it begins with some.
fn floating(object: &mut Object, facts: &Facts) -> Result<(), Refusal> {
    if let Some(values) = facts.inputs.first().and_then(|port| port.default.as_ref()) {
        object.set_persistent(0, Some(values))?;
    }
    Ok(())
}

/// Adds the port that stands at `k` on a side of objects of that type, with an id.
pub(super) fn add(object: &mut Object, facts: &Facts, side: Side, k: usize, id: Uuid) {
    let ports = if side == Side::Input { &facts.inputs } else { &facts.outputs };
    let Some(port) = port(ports, k) else { return };
    let variable = facts.is_variable();
    object.add_port(side, &NewPort { id, type_id: port.type_id.filter(|_| variable), ..port_of(port) });
}

/// What is known of the port that stands at `k`, with its own name where one stands for many.
fn port(ports: &[PortFacts], k: usize) -> Option<PortFacts> {
    let fixed = ports.iter().filter(|port| !port.many).count();
    if k < fixed {
        return ports.get(k).cloned();
    }
    let many = ports.last().filter(|port| port.many)?;
    let name = |first: &str| kd::counted(first, k - fixed);
    Some(PortFacts { name: name(&many.name), nickname: name(&many.nickname), ..many.clone() })
}

/// The port as it is added.
fn port_of(port: PortFacts) -> NewPort {
    NewPort {
        id: Uuid::nil(),
        name: port.name,
        nickname: port.nickname,
        description: port.description,
        access: port.access,
        optional: port.optional,
        type_id: port.type_id,
        persistent: port.default,
    }
}

/// Puts an object on the canvas with its middle at a point, in its natural size.
pub(super) fn place(object: &mut Object, at: [f32; 2]) {
    let [w, h] = size::natural(object);
    let [dx, dy] = size::hang(object, [w, h]);
    let corner = [(at[0] - 0.5 * w).round(), (at[1] - 0.5 * h).round()];
    if object.component == ids::SCRIBBLE {
        super::objects::shape_scribble(object, corner);
        return;
    }
    object.set_place([corner[0], corner[1], w, h], [corner[0] + dx, corner[1] + dy]);
}

/// Gives an object that is on the canvas the size that its names and ports ask for; its left top corner stays.
pub(super) fn fit(object: &mut Object) {
    let (Some([x, y, ..]), false) = (object.bounds, object.is_annotation()) else { return };
    let [w, h] = size::natural(object);
    let [dx, dy] = size::hang(object, [w, h]);
    let places: Vec<_> = object.inputs.iter().chain(&object.outputs).map(|port| port.place).collect();
    if !object.is_floating() {
        // The ports stand elsewhere now; where is plain from the object's own bounds.
        let container = object.container_mut();
        for place in places {
            if let Some(chunk) = place.find_mut(container) {
                chunk.remove_children("Attributes");
            }
        }
    }
    object.set_place([x, y, w, h], [x + dx, y + dy]);
}

fn annotation(component: Uuid, name: &str, nickname: &str, id: Uuid) -> Object {
    let mut object = Object::new_component(component, name, nickname, id);
    object.container_mut().set_child(Chunk::new("Attributes"));
    if component == ids::GROUP {
        let container = object.container_mut();
        container.set("Border", 1);
        container.set("Colour", Colour::new(150, 170, 135, 255));
        container.set("ID_Count", 0);
    }
    object.refresh();
    object
}

fn scribble(id: Uuid) -> Object {
    let mut object = annotation(ids::SCRIBBLE, "Scribble", "Scribble", id);
    let container = object.container_mut();
    container.set("Text", "Doubleclick Me!");
    container.set("Font", "Microsoft Sans Serif");
    container.set("Size", ItemValue::Single(25.0));
    container.set("Bold", false);
    container.set("Italic", false);
    object.refresh();
    object
}

fn relay(id: Uuid) -> Object {
    let mut object = Object::new_parameter(ids::RELAY, "Relay", "", id);
    object.container_mut().set("Description", "A wire relay object");
    object.container_mut().set("Access", 2);
    object.refresh();
    object
}

fn hook(component: Uuid, name: &str, nickname: &str, id: Uuid) -> Object {
    Object::new_parameter(component, name, nickname, id)
}

/// What controls are when they are new.
fn begin(object: &mut Object) {
    if let Some(row) = controls::of(object.component) {
        (row.begin)(object.container_mut());
    }
    object.refresh();
}
