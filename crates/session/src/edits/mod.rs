//! What edits do to a document. Each leaves everything else as it is, byte for byte.

mod arrange;
mod clipboard;
mod clusters;
mod controls;
mod explode;
mod geometry;
mod given;
mod groups;
mod keep;
mod make;
mod objects;
mod panel;
mod paste;
mod player;
mod ports;
mod scripts;
mod settings;
mod transformed;
mod wires;

use crate::Refusal;
use crate::controls::finite;
use crate::editor::Draft;
use crate::protocol::Edit;

pub(crate) use clipboard::copy;
pub(crate) use clusters::tie_ports;
pub(crate) use groups::shape as shape_group;
pub use make::object as new_object;
pub(crate) use panel::property as panel_property;
pub(crate) use player::published;
pub(crate) use settings::rules_of;

/// The most ids that one edit may name.
const MOST_NAMED: usize = 1_000_000;

/// Makes an edit in a draft.
pub(crate) fn carry_out(edit: &Edit, draft: &mut Draft<'_>) -> Result<(), Refusal> {
    match edit {
        Edit::Place { id, component, at, with } => objects::put(draft, *id, *component, *at, with.as_ref()),
        Edit::Paste { text, at, seed } => paste::paste(draft, text, *at, *seed),
        Edit::Duplicate { objects, by, seed } => paste::duplicate(draft, objects, *by, *seed),
        Edit::Remove { objects } => objects::remove(draft, objects),
        Edit::RemoveAndJoin { object } => wires::remove_and_join(draft, *object),
        Edit::Move { objects } => arrange::move_to(draft, objects),
        Edit::Align { objects, how } => arrange::align(draft, objects, *how),
        Edit::Resize { object, bounds } => arrange::resize(draft, *object, *bounds),
        Edit::Arrange { objects, back } => arrange::reorder(draft, objects, *back),
        Edit::Connect { from, to, how } => wires::connect(draft, *from, *to, *how),
        Edit::Rewire { from, to, input } => wires::rewire(draft, *from, *to, *input),
        Edit::InsertRelay { id, from, to, at } => wires::insert_relay(draft, *id, *from, *to, *at),
        Edit::Disconnect { port } => wires::disconnect(draft, *port),
        Edit::Change { objects, change } => objects::change(draft, objects, change),
        Edit::ChangePort { port, change } => ports::change(draft, *port, change),
        Edit::Set { object, to } => controls::set(draft, *object, to),
        Edit::Reshape { object, control } => controls::reshape(draft, *object, control),
        Edit::ChangePanel { object, change } => panel::change(draft, *object, change),
        Edit::Keep { port, values } => keep::keep(draft, *port, values.as_deref()),
        Edit::SetGeometry { port, items } => given::set(draft, *port, items),
        Edit::Transform { ports, map } => transformed::transform(draft, ports, map),
        Edit::Internalise { port } => keep::internalise(draft, *port),
        Edit::Extract { port, id } => keep::extract(draft, *port, *id),
        Edit::AddPort { object, input, index, id } => ports::add(draft, *object, *input, *index, *id),
        Edit::RemovePort { port } => ports::remove(draft, *port),
        Edit::Group { id, objects } => groups::group(draft, *id, objects),
        Edit::ChangeGroup { group, change } => groups::change(draft, *group, change),
        Edit::Ungroup { groups } => groups::ungroup(draft, groups),
        Edit::MakeCluster { id, objects } => clusters::make(draft, *id, objects),
        Edit::ExplodeCluster { cluster } => explode::explode(draft, *cluster),
        Edit::Publish { inputs } => player::publish(draft, inputs.as_deref()),
        Edit::Settings { .. } => settings::change(draft, edit),
    }
}

/// Refuses numbers that no canvas has.
pub(crate) fn sound(numbers: &[f32]) -> Result<(), Refusal> {
    const FARTHEST: f32 = 1e7;
    if numbers.iter().all(|x| x.abs() <= FARTHEST) {
        Ok(())
    } else {
        Err(Refusal::Senseless(
            "a place on the canvas must be finite and within ten million units".to_owned(),
        ))
    }
}

/// Refuses lists that are longer than any document.
fn bounded<T>(list: &[T]) -> Result<(), Refusal> {
    if list.len() <= MOST_NAMED {
        Ok(())
    } else {
        Err(Refusal::Senseless(format!("more than {MOST_NAMED} objects are named")))
    }
}
