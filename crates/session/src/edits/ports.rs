//! Ports: their names, modifiers and number.

use katydid_component::registry;
use katydid_definition::archive::Chunk;
use katydid_definition::document::{Mapping, NewPort, Object, PortPlace, PortRef, Side, ids};
use katydid_definition::kd::{self, Catalogue};
use uuid::Uuid;

use super::{make, scripts, wires};
use crate::editor::Draft;
use crate::protocol::{MappingView, PortChange, WireView};
use crate::view::{is_removable, is_variable, kind, size};
use crate::{Refusal, Registry};

/// The most ports of one side.
const MOST_PORTS: usize = 1_000;

/// The port of that id: an output, or of a floating parameter, which is both, the input, where its modifiers stand.
fn find(draft: &mut Draft<'_>, id: Uuid) -> Result<PortRef, Refusal> {
    let lookup = draft.lookup();
    lookup.input(id).or_else(|| lookup.output(id)).ok_or(Refusal::NoPort(id))
}

/// Changes a port.
pub(super) fn change(draft: &mut Draft<'_>, port: Uuid, change: &PortChange) -> Result<(), Refusal> {
    let at = find(draft, port)?;
    let object = draft.at(at.object)?;
    if let PortChange::Nickname { text } = change {
        return nickname(object, at, text);
    }
    if let PortChange::Hint { hint } = change {
        return scripts::hint(object, at, hint);
    }
    if let PortChange::Access { access } = change {
        return scripts::access(object, at, *access);
    }
    if let PortChange::Principal { on } = change {
        return principal(object, at, *on);
    }
    if let PortChange::Mapping { mapping } = change {
        let mapping = match mapping {
            MappingView::None => Mapping::None,
            MappingView::Flatten => Mapping::Flatten,
            MappingView::Graft => Mapping::Graft,
        };
        if object.ports(at.side).get(at.port).is_some_and(|port| port.modifiers.mapping != mapping) {
            object.set_mapping(at.side, at.port, mapping)?;
        }
        return Ok(());
    }
    suits(object, at, change)?;
    let Some(chunk) = chunk(object, at) else { return Err(Refusal::NoPort(port)) };
    match change {
        PortChange::Reverse { on } => flag(chunk, "ReverseData", *on),
        PortChange::Simplify { on } => flag(chunk, "SimplifyData", *on),
        PortChange::Reparameterize { on } => flag(chunk, "Reparameterize", *on),
        PortChange::Invert { on } => {
            // The name of Grasshopper 0.8.
            if !on {
                chunk.remove("NegateStream");
            }
            flag(chunk, "InvertBooleans", *on);
        }
        PortChange::Degrees { on } => flag(chunk, "UseDegrees", *on),
        PortChange::Unitize { on } => flag(chunk, "Unitize", *on),
        PortChange::Expression { text } => {
            let text = text.as_deref().map(str::trim).filter(|text| !text.is_empty());
            chunk.remove("ParamExpression");
            match text {
                Some(text) => chunk.set("InternalExpression", text),
                None => {
                    chunk.remove("InternalExpression");
                }
            }
        }
        PortChange::Wire { wire } => match wire {
            WireView::Normal => {
                chunk.remove("WireDisplay");
            }
            WireView::Faint => chunk.set("WireDisplay", 1),
            WireView::Hidden => chunk.set("WireDisplay", 2),
        },
        PortChange::Nickname { .. }
        | PortChange::Mapping { .. }
        | PortChange::Principal { .. }
        | PortChange::Hint { .. }
        | PortChange::Access { .. } => {}
    }
    object.refresh();
    Ok(())
}

/// Refuses modifiers on data that they do nothing to.
fn suits(object: &Object, at: PortRef, change: &PortChange) -> Result<(), Refusal> {
    use katydid_data::Kind;
    let component = registry::by_guid(object.component);
    let declared =
        component.and_then(|c| if at.side == Side::Input { c.input(at.port) } else { c.output(at.port) });
    let Some(port) = object.ports(at.side).get(at.port) else { return Ok(()) };
    let kind = kind(port, declared.map(|d| d.kind));
    let (on, fits, what) = match change {
        PortChange::Reparameterize { on } => {
            let shapes = kind.is_geometry() || kind == Kind::Generic;
            (*on, shapes, "only curves and surfaces have domains")
        }
        PortChange::Invert { on } => {
            (*on, matches!(kind, Kind::Boolean | Kind::Generic), "it takes no booleans")
        }
        PortChange::Degrees { on } => {
            (*on, matches!(kind, Kind::Number | Kind::Generic), "it takes no angles")
        }
        PortChange::Unitize { on } => {
            (*on, matches!(kind, Kind::Vector | Kind::Generic), "it takes no vectors")
        }
        _ => return Ok(()),
    };
    if !on || fits {
        return Ok(());
    }
    Err(Refusal::Unfit { object: format!("{}, {}", object.title(), port.name), reason: what.to_owned() })
}

/// The chunk of a port.
fn chunk(object: &mut Object, at: PortRef) -> Option<&mut Chunk> {
    let place = object.ports(at.side).get(at.port)?.place;
    place.find_mut(object.container_mut())
}

/// Grasshopper writes these flags only when they are set.
fn flag(chunk: &mut Chunk, name: &str, on: bool) {
    if on {
        chunk.set(name, true);
    } else {
        chunk.remove(name);
    }
}

fn nickname(object: &mut Object, at: PortRef, text: &str) -> Result<(), Refusal> {
    if object.is_floating() {
        super::objects::rename(object, text);
        return Ok(());
    }
    if object.ports(at.side).get(at.port).is_some_and(|port| port.nickname == text) {
        return Ok(());
    }
    let natural = size::natural(object);
    if let Some(chunk) = chunk(object, at) {
        chunk.set("NickName", text);
    }
    object.refresh();
    if size::natural(object) != natural {
        make::fit(object);
    }
    Ok(())
}

fn principal(object: &mut Object, at: PortRef, on: bool) -> Result<(), Refusal> {
    if at.side != Side::Input || object.is_floating() {
        let reason = "only an input of a component can be its principal one".to_owned();
        return Err(Refusal::Unfit { object: object.title().to_owned(), reason });
    }
    let is = object.principal == Some(at.port);
    if on && !is {
        let index = i32::try_from(at.port).unwrap_or(i32::MAX);
        object.container_mut().set("PrincipalIndex", index);
    } else if !on && is {
        object.container_mut().remove("PrincipalIndex");
    }
    object.refresh();
    Ok(())
}

/// Adds a port to an object that has any number of them, before the one at `index`.
pub(super) fn add(
    draft: &mut Draft<'_>,
    object: Uuid,
    input: bool,
    index: u32,
    id: Option<Uuid>,
) -> Result<(), Refusal> {
    let side = if input { Side::Input } else { Side::Output };
    let at = draft.place(object).ok_or(Refusal::NoObject(object))?;
    if id.is_some_and(|id| draft.has(id)) {
        return Ok(());
    }
    let taken = draft.lookup();
    let found = draft.at(at)?;
    let component = registry::by_guid(found.component);
    if !is_variable(found, component, side) {
        let what = if input { "inputs" } else { "outputs" };
        return Err(Refusal::Unfit {
            object: found.title().to_owned(),
            reason: format!("its {what} are fixed"),
        });
    }
    let count = found.ports(side).len();
    if count >= MOST_PORTS {
        let reason = format!("it has {MOST_PORTS} ports already");
        return Err(Refusal::Unfit { object: found.title().to_owned(), reason });
    }
    let id = id.unwrap_or_else(|| {
        let mut ids = (count..).map(|k| kd::derived_id(found.id, &format!("added {side:?} {k}")));
        ids.find(|id| taken.input(*id).is_none() && taken.output(*id).is_none()).unwrap_or_default()
    });
    let fixed = component.map_or(0, |c| {
        let ports = if input { c.inputs } else { c.outputs };
        ports.iter().filter(|port| !port.many).count()
    });
    let index = usize::try_from(index).unwrap_or(count).clamp(fixed.min(count), count);
    match Registry.by_guid(found.component) {
        Some(facts) => make::add(found, &facts, side, count, id),
        None => {
            let name = if input { letters(count) } else { format!("out{count}") };
            found.add_port(
                side,
                &NewPort {
                    id,
                    name: name.clone(),
                    nickname: name,
                    optional: input,
                    type_id: Some(scripts::port_type(found, side)),
                    ..NewPort::default()
                },
            );
            scripts::equip(found, side);
        }
    }
    if let (Some(component), true) = (component, input)
        && !counts_from_place(component)
    {
        name_variable(found, count);
    }
    // It was added as the last.
    let mut order: Vec<usize> = (0..count).collect();
    order.insert(index, count);
    reorder(found, side, &order);
    // A port in the middle has the name that is free, as Grasshopper gives it.
    let facts = Registry.by_guid(found.component);
    if index < count && facts.is_some() {
        renumber(found, side, fixed, component.is_some_and(counts_from_place));
    }
    if let Some(principal) = found.principal.filter(|k| input && *k >= index) {
        found.container_mut().set("PrincipalIndex", i32::try_from(principal + 1).unwrap_or(i32::MAX));
        found.refresh();
    }
    shift_base(found, side, index, 1);
    make::fit(found);
    draft.stir();
    Ok(())
}

/// Whether the names of a component's ports are those of their places: `D1`, `D2`; else each keeps its own.
fn counts_from_place(component: &katydid_component::Component) -> bool {
    component.name != "Expression" && component.name != "Evaluate"
}

/// Gives the variable at `k` the first letter that none has: x, y, z, then a on.
fn name_variable(object: &mut Object, k: usize) {
    let taken: Vec<String> = object.inputs.iter().take(k).map(|port| port.nickname.clone()).collect();
    let mut free = ('x'..='z').chain('a'..='w').map(String::from).filter(|letter| !taken.contains(letter));
    let (Some(letter), Some(place)) = (free.next(), object.inputs.get(k).map(|port| port.place)) else {
        return;
    };
    if let Some(chunk) = place.find_mut(object.container_mut()) {
        chunk.set("Name", format!("Variable {letter}"));
        chunk.set("NickName", letter);
    }
    object.refresh();
}

/// List Item keeps which output is the item at the index itself; Grasshopper numbers the others around it.
fn shift_base(object: &mut Object, side: Side, index: usize, by: i32) {
    let container = object.container_mut();
    let Some(base) = container.i32("BaseOutputIndex").filter(|_| side == Side::Output) else { return };
    if i32::try_from(index).is_ok_and(|index| index <= base) {
        container.set("BaseOutputIndex", base + by);
    }
    object.refresh();
}

/// a, b, … z, then a1 and so on.
fn letters(k: usize) -> String {
    let letter = u8::try_from(k % 26).map_or('x', |k| char::from(b'a' + k));
    if k < 26 { letter.to_string() } else { format!("{letter}{}", k / 26) }
}

/// Puts the variable ports of a side in another order: `order` has the old places in the new order.
pub(super) fn reorder(object: &mut Object, side: Side, order: &[usize]) {
    let places: Vec<PortPlace> = object.ports(side).iter().map(|port| port.place).collect();
    let (port_name, id_name, count_name) = match side {
        Side::Input => ("InputParam", "InputId", "InputCount"),
        Side::Output => ("OutputParam", "OutputId", "OutputCount"),
    };
    let Some(parameters) = object.container_mut().child_mut("ParameterData") else { return };
    let mut taken = Vec::with_capacity(order.len());
    for old in order {
        let Some(PortPlace::Variable(_, k)) = places.get(*old).copied() else { return };
        let type_id = parameters.guid_at(id_name, k).unwrap_or(ids::DATA);
        let Some(chunk) = parameters.child_at(port_name, k).cloned() else { return };
        taken.push((type_id, chunk));
    }
    parameters.remove(id_name);
    parameters.remove_children(port_name);
    parameters.set(count_name, i32::try_from(taken.len()).unwrap_or(i32::MAX));
    for (k, (type_id, mut chunk)) in (0..).zip(taken) {
        chunk.index = Some(k);
        parameters.set_at(id_name, k, type_id);
        parameters.set_child(chunk);
    }
    object.refresh();
}

/// Gives the ports that one stands for the names of their places, but for those that somebody named otherwise.
fn renumber(object: &mut Object, side: Side, fixed: usize, by_place: bool) {
    let Some(facts) = Registry.by_guid(object.component) else { return };
    let ports = if side == Side::Input { &facts.inputs } else { &facts.outputs };
    let Some(many) = ports.last().filter(|port| port.many) else { return };
    let usual = |k: usize| (kd::counted(&many.name, k), kd::counted(&many.nickname, k));
    let count = object.ports(side).len();
    let all: Vec<String> = (0..count.saturating_sub(fixed) + 1).map(|k| usual(k).1).collect();
    if !by_place {
        return;
    }
    for k in fixed..count {
        let Some(port) = object.ports(side).get(k) else { continue };
        if !all.contains(&port.nickname) {
            continue;
        }
        let (name, nickname) = usual(k - fixed);
        let place = port.place;
        if let Some(chunk) = place.find_mut(object.container_mut()) {
            chunk.set("Name", name);
            chunk.set("NickName", nickname);
        }
    }
    object.refresh();
}

/// Takes a port away.
pub(super) fn remove(draft: &mut Draft<'_>, port: Uuid) -> Result<(), Refusal> {
    let lookup = draft.lookup();
    // What is not there is gone already.
    let Some(at) = lookup.input(port).or_else(|| lookup.output(port)) else { return Ok(()) };
    let object = draft.at(at.object)?;
    let component = registry::by_guid(object.component);
    let found = object.ports(at.side).get(at.port).cloned().ok_or(Refusal::NoPort(port))?;
    if !is_removable(object, component, at.side, at.port, &found) {
        let reason = format!("the port {} belongs to it", found.name);
        return Err(Refusal::Unfit { object: object.title().to_owned(), reason });
    }
    let count = object.ports(at.side).len();
    let order: Vec<usize> = (0..count).filter(|k| *k != at.port).collect();
    reorder(object, at.side, &order);
    let fixed = component.map_or(0, |c| {
        let ports = if at.side == Side::Input { c.inputs } else { c.outputs };
        ports.iter().filter(|port| !port.many).count()
    });
    renumber(object, at.side, fixed, component.is_some_and(counts_from_place));
    if at.side == Side::Input {
        match object.principal {
            Some(principal) if principal == at.port => {
                object.container_mut().remove("PrincipalIndex");
            }
            Some(principal) if principal > at.port => {
                object.container_mut().set("PrincipalIndex", i32::try_from(principal - 1).unwrap_or(0));
            }
            _ => {}
        }
        object.refresh();
    }
    shift_base(object, at.side, at.port, -1);
    make::fit(object);
    draft.stir();
    if at.side == Side::Output {
        wires::forget(draft, &std::collections::HashSet::from([port]))?;
    }
    Ok(())
}
