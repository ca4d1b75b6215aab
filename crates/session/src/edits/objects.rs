//! Objects come, go and change their names and states.

use std::collections::HashSet;

use katydid_definition::archive::{Chunk, ItemValue};
use katydid_definition::document::{Object, Side, ids};
use uuid::Uuid;

use super::{bounded, controls, keep, make, sound, wires};
use crate::Refusal;
use crate::editor::Draft;
use crate::protocol::{Initial, ObjectChange};
use crate::view::size;

/// Puts a new object on the canvas.
pub(super) fn put(
    draft: &mut Draft<'_>,
    id: Uuid,
    component: Uuid,
    at: [f32; 2],
    with: Option<&Initial>,
) -> Result<(), Refusal> {
    sound(&at)?;
    if id.is_nil() {
        return Err(Refusal::Senseless("a new object needs an id".to_owned()));
    }
    // The same edit again.
    if draft.has(id) {
        return Ok(());
    }
    if [ids::CLUSTER_INPUT, ids::CLUSTER_OUTPUT].contains(&component) && draft.within.is_empty() {
        return Err(Refusal::Senseless("only a cluster has inputs and outputs of this kind".to_owned()));
    }
    let mut object = make::object(component, id)?;
    if let Some(Initial::Control { control }) = with {
        controls::shape(&mut object, control)?;
    }
    if let Some(Initial::Values { values }) = with {
        for (input, text) in values {
            let input = usize::try_from(*input).unwrap_or(usize::MAX);
            keep::put(&mut object, input, Some(text), &draft.rules)?;
        }
    }
    make::place(&mut object, at);
    draft.document.objects.push(object);
    draft.stir();
    if let Some(Initial::Wire { port }) = with {
        wires::first(draft, id, *port)?;
    }
    Ok(())
}

/// Takes objects out: their wires go, and groups forget them. What is not there is gone already.
pub(super) fn remove(draft: &mut Draft<'_>, objects: &[Uuid]) -> Result<(), Refusal> {
    bounded(objects)?;
    let gone: HashSet<Uuid> = objects.iter().copied().collect();
    let mut outputs: HashSet<Uuid> = HashSet::new();
    draft.document.objects.retain(|object| {
        let goes = gone.contains(&object.id);
        if goes {
            outputs.extend(object.outputs.iter().map(|port| port.id));
        }
        !goes
    });
    draft.stir();
    wires::forget(draft, &outputs)?;
    super::groups::forget(draft, &gone);
    Ok(())
}

/// Changes names and states.
pub(super) fn change(draft: &mut Draft<'_>, objects: &[Uuid], change: &ObjectChange) -> Result<(), Refusal> {
    bounded(objects)?;
    for &id in objects {
        let object = draft.object(id)?;
        match change {
            ObjectChange::Nickname { text } if object.nickname != *text => rename(object, text),
            ObjectChange::Disabled { on } if object.locked != *on => object.set_locked(*on),
            ObjectChange::Hidden { on } if object.hidden != *on => object.set_hidden(*on),
            _ => {}
        }
    }
    Ok(())
}

/// Gives an object a nickname; a capsule becomes as wide as it needs.
pub(super) fn rename(object: &mut Object, text: &str) {
    let before = size::natural(object);
    object.set_nickname(text);
    let after = size::natural(object);
    let (Some([x, y, w, h]), true) = (object.bounds, before != after) else { return };
    // Controls keep the size that their author gave them; their names need more or less room.
    let pivot = object.pivot.unwrap_or([x, y]);
    if object.component == ids::PANEL {
        return;
    }
    let wide = w + after[0] - before[0];
    if wide >= 20.0 {
        let dx = if object.is_floating() && object.special().is_none() { 0.5 * (wide - w) } else { 0.0 };
        object.set_place([x, y, wide, h], [pivot[0] + dx, pivot[1]]);
    }
}

/// Gives a Scribble the corners that its text asks for, from the left top one.
pub(super) fn shape_scribble(object: &mut Object, [x, y]: [f32; 2]) {
    let Some(katydid_definition::document::Special::Scribble(scribble)) = object.special() else { return };
    let scale = scribble.size as f32 / 8.0;
    let longest = scribble.text.lines().map(size::text).fold(0.0, f32::max);
    let lines = u16::try_from(scribble.text.lines().count().max(1)).map_or(1e4, f32::from);
    let (w, h) = ((longest * scale + 10.0).round(), (lines * 16.0 * scale + 6.0).round());
    let container = object.container_mut();
    for (name, corner) in [("Ca", [x, y]), ("Cb", [x + w, y]), ("Cc", [x + w, y + h]), ("Cd", [x, y + h])] {
        container.set(name, ItemValue::PointF(corner));
    }
    if container.child("Attributes").is_none() {
        container.set_child(Chunk::new("Attributes"));
    }
    object.refresh();
    object.set_place([x - 5.0, y - 5.0, w + 10.0, h + 10.0], [x, y]);
}

/// The input that a new object reads a wire with, or the output it gives one with: the first of its side.
pub(super) fn first_port(object: &Object, side: Side) -> Option<Uuid> {
    object.ports(side).first().filter(|_| size::shows(object, side)).map(|port| port.id)
}
