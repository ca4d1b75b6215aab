//! Objects that are put into a document with new ids.

use std::collections::{HashMap, HashSet};

use katydid_definition::archive::{Chunk, ItemValue};
use katydid_definition::document::{Document, Object, ids};
use katydid_definition::kd;
use uuid::Uuid;

use super::{arrange, bounded, clipboard, sound};
use crate::Refusal;
use crate::editor::Draft;
use crate::view::size;

/// The most objects that are pasted at a time.
const MOST_OBJECTS: usize = 100_000;

/// Puts what was copied on the canvas.
pub(super) fn paste(
    draft: &mut Draft<'_>,
    text: &str,
    at: Option<[f32; 2]>,
    seed: Uuid,
) -> Result<(), Refusal> {
    let source = clipboard::read(text)?;
    if let Some(at) = at {
        sound(&at)?;
    }
    if source.objects.len() > MOST_OBJECTS {
        return Err(Refusal::Senseless(format!("more than {MOST_OBJECTS} objects cannot be pasted at once")));
    }
    let place = match at {
        Some([x, y]) => {
            let [left, top, w, h] = around(&source.objects);
            [x - left - 0.5 * w, y - top - 0.5 * h]
        }
        None => [20.0, 20.0],
    };
    let libraries = libraries(&source);
    put(draft, source.objects, place.map(f32::round), seed)?;
    let known: HashSet<Uuid> = draft.document.libraries.iter().map(|library| library.id).collect();
    let mut new =
        libraries.iter().filter(|chunk| chunk.guid("Id").is_some_and(|id| !known.contains(&id))).peekable();
    if new.peek().is_some() {
        clipboard::add_libraries(draft.document.tree_mut(), new);
        let frame = draft.document.frame().clone();
        draft.document.set_frame(frame);
    }
    Ok(())
}

/// The add-ons that a document's objects come from.
fn libraries(source: &Document) -> Vec<Chunk> {
    let used: HashSet<Uuid> = source.objects.iter().filter_map(|object| object.lib).collect();
    let frame = source.frame();
    let list = frame.child("Definition").unwrap_or(frame).child("GHALibraries");
    let chunks = list.map(|list| list.children("Library")).unwrap_or_default();
    let chunks = chunks.into_iter().filter(|chunk| chunk.guid("Id").is_some_and(|id| used.contains(&id)));
    chunks.cloned().collect()
}

/// The rectangle around objects.
fn around(objects: &[Object]) -> [f32; 4] {
    let rects = objects.iter().filter(|object| object.component != ids::GROUP).map(size::bounds);
    size::around(rects.flat_map(|[x, y, w, h]| [[x, y], [x + w, y + h]]))
}

/// Copies objects of the document itself.
pub(super) fn duplicate(
    draft: &mut Draft<'_>,
    objects: &[Uuid],
    by: [f32; 2],
    seed: Uuid,
) -> Result<(), Refusal> {
    bounded(objects)?;
    sound(&by)?;
    let wanted: HashSet<Uuid> = objects.iter().copied().collect();
    let picked: Vec<Object> =
        draft.document.objects.iter().filter(|object| wanted.contains(&object.id)).cloned().collect();
    if picked.is_empty() {
        return Err(Refusal::Senseless("there is nothing to copy".to_owned()));
    }
    if picked.len() > MOST_OBJECTS {
        return Err(Refusal::Senseless(format!("more than {MOST_OBJECTS} objects cannot be copied at once")));
    }
    put(draft, picked, by, seed)
}

/// Puts objects into the document with new ids and moved by a step. Wires between them lead to the new ones, wires from
/// outputs that the document has stay, others go.
fn put(draft: &mut Draft<'_>, objects: Vec<Object>, by: [f32; 2], seed: Uuid) -> Result<(), Refusal> {
    if seed.is_nil() {
        return Err(Refusal::Senseless("a copy needs a seed for its ids".to_owned()));
    }
    let new = renew(&objects, seed);
    // The same edit again.
    if objects.iter().filter_map(|object| new.get(&object.id)).any(|id| draft.has(*id)) {
        draft.made = objects.iter().filter_map(|object| new.get(&object.id).copied()).collect();
        return Ok(());
    }
    let lookup = draft.lookup();
    let made: HashSet<Uuid> = new.values().copied().collect();
    let only_here = [ids::CLUSTER_INPUT, ids::CLUSTER_OUTPUT];
    let outermost = draft.within.is_empty();
    let mut groups = Vec::new();
    for object in objects {
        // A cluster's ports mean nothing outside of one.
        if outermost && only_here.contains(&object.component) {
            continue;
        }
        let mut object = renamed(&object, &new);
        for k in 0..object.inputs.len() {
            let sources = object.inputs.get(k).map_or(&[][..], |port| &port.sources);
            let made = |id: &Uuid| made.contains(id);
            let kept: Vec<Uuid> =
                sources.iter().copied().filter(|id| lookup.output(*id).is_some() || made(id)).collect();
            if kept.len() != sources.len() {
                object.set_sources(k, &kept)?;
            }
        }
        arrange::shift(&mut object, by);
        deselect(&mut object);
        draft.made.push(object.id);
        if object.component == ids::GROUP { groups.push(object) } else { draft.document.objects.push(object) }
    }
    for (at, group) in groups.into_iter().enumerate() {
        draft.document.objects.insert(at, group);
    }
    draft.stir();
    Ok(())
}

/// What is selected is not a matter of the document here.
fn deselect(object: &mut Object) {
    if object.container().child("Attributes").is_some_and(|attributes| attributes.item("Selected").is_some())
        && let Some(attributes) = object.container_mut().child_mut("Attributes")
    {
        attributes.remove("Selected");
        object.refresh();
    }
}

/// New ids for objects and their ports. Of several with the same id all get the same new one, as they had.
pub(super) fn renew(objects: &[Object], seed: Uuid) -> HashMap<Uuid, Uuid> {
    let mut new = HashMap::new();
    for object in objects {
        let ports = object.inputs.iter().chain(&object.outputs).map(|port| port.id);
        for id in std::iter::once(object.id).chain(ports) {
            new.entry(id).or_insert_with(|| kd::derived_id(seed, &id.to_string()));
        }
    }
    new.remove(&Uuid::nil());
    new
}

/// The object with every id in it replaced that has a new one: its own, its ports', those of its wires, members, and of
/// whatever an add-on keeps.
pub(super) fn renamed(object: &Object, new: &HashMap<Uuid, Uuid>) -> Object {
    let mut chunk = object.chunk().clone();
    // The number among the others belongs to where it came from.
    chunk.index = None;
    for inner in &mut chunk.chunks {
        substitute(inner, new);
    }
    Object::from_chunk(chunk)
}

fn substitute(chunk: &mut Chunk, new: &HashMap<Uuid, Uuid>) {
    for item in &mut chunk.items {
        if let ItemValue::Guid(id) = &mut item.value
            && let Some(with) = new.get(id)
        {
            *id = *with;
        }
    }
    for inner in &mut chunk.chunks {
        substitute(inner, new);
    }
}
