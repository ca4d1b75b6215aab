//! What edits are called in Undo and Redo.

use katydid_component::registry;
use katydid_definition::document::{Document, Object, ids};
use uuid::Uuid;

use crate::protocol::{Alignment, Connection, Edit, GroupChange, ObjectChange, PortChange, Setting};

/// The longest name of an object that a step is called by.
const MOST_LETTERS: usize = 40;

/// The edit in a few words; the document is that before it.
pub(super) fn name(edit: &Edit, document: &Document) -> String {
    let find = |id: &Uuid| document.objects.iter().find(|object| object.id == *id);
    let one = |id: &Uuid| find(id).map_or_else(|| "object".to_owned(), called);
    let some = |ids: &[Uuid]| match ids {
        [id] => one(id),
        ids => format!("{} objects", ids.len()),
    };
    match edit {
        Edit::Place { component, .. } => format!("Place {}", kind(*component)),
        Edit::Paste { .. } => "Paste".to_owned(),
        Edit::Duplicate { objects, .. } => format!("Duplicate {}", some(objects)),
        Edit::Remove { objects } => format!("Delete {}", some(objects)),
        Edit::RemoveAndJoin { object } => format!("Delete {} and join its wires", one(object)),
        Edit::Move { objects } => match objects.as_slice() {
            [(id, _)] => format!("Move {}", one(id)),
            all => format!("Move {} objects", all.len()),
        },
        Edit::Align { how: Alignment::SpreadAcross | Alignment::SpreadDown, objects } => {
            format!("Distribute {}", some(objects))
        }
        Edit::Align { objects, .. } => format!("Align {}", some(objects)),
        Edit::Resize { object, .. } => format!("Resize {}", one(object)),
        Edit::Arrange { objects, back: true } => format!("Move {} to the back", some(objects)),
        Edit::Arrange { objects, back: false } => format!("Move {} to the front", some(objects)),
        Edit::Connect { how: Connection::Remove, .. } => "Remove wire".to_owned(),
        Edit::Connect { .. } => "Add wire".to_owned(),
        Edit::Rewire { .. } => "Move wires".to_owned(),
        Edit::InsertRelay { .. } => "Insert relay".to_owned(),
        Edit::Disconnect { .. } => "Disconnect".to_owned(),
        Edit::Change { objects, change } => match change {
            ObjectChange::Nickname { .. } => format!("Rename {}", some(objects)),
            ObjectChange::Disabled { on: true } => format!("Disable {}", some(objects)),
            ObjectChange::Disabled { on: false } => format!("Enable {}", some(objects)),
            ObjectChange::Hidden { on: true } => format!("Hide preview of {}", some(objects)),
            ObjectChange::Hidden { on: false } => format!("Show preview of {}", some(objects)),
        },
        Edit::ChangePort { change, .. } => match change {
            PortChange::Nickname { .. } => "Rename port",
            PortChange::Mapping { .. } => "Change mapping",
            PortChange::Reverse { .. } => "Reverse",
            PortChange::Simplify { .. } => "Simplify",
            PortChange::Reparameterize { .. } => "Reparameterize",
            PortChange::Invert { .. } => "Invert",
            PortChange::Degrees { .. } => "Change degrees",
            PortChange::Unitize { .. } => "Unitize",
            PortChange::Expression { .. } => "Change expression",
            PortChange::Hint { .. } => "Change type hint",
            PortChange::Access { .. } => "Change access",
            PortChange::Wire { .. } => "Change wire display",
            PortChange::Principal { .. } => "Change principal input",
        }
        .to_owned(),
        Edit::Set { object, to: Setting::Text { .. } } => format!("Edit text of {}", one(object)),
        Edit::Set { object, .. } => format!("Set {}", one(object)),
        Edit::Reshape { object, .. } | Edit::ChangePanel { object, .. } => format!("Change {}", one(object)),
        Edit::Keep { values: None, .. } => "Clear values".to_owned(),
        Edit::Keep { .. } => "Set values".to_owned(),
        Edit::SetGeometry { items, .. } => match items.len() {
            1 => "Set one item".to_owned(),
            n => format!("Set {n} items"),
        },
        Edit::Transform { .. } => "Transform geometry".to_owned(),
        Edit::Internalise { .. } => "Internalise data".to_owned(),
        Edit::Extract { .. } => "Extract parameter".to_owned(),
        Edit::AddPort { input: true, .. } => "Add input".to_owned(),
        Edit::AddPort { .. } => "Add output".to_owned(),
        Edit::RemovePort { .. } => "Remove port".to_owned(),
        Edit::Group { objects, .. } => format!("Group {}", some(objects)),
        Edit::ChangeGroup { change, .. } => match change {
            GroupChange::Label { .. } => "Rename group",
            GroupChange::Colour { .. } => "Change colour of group",
            GroupChange::Border { .. } => "Change shape of group",
            GroupChange::Members { .. } => "Change members of group",
        }
        .to_owned(),
        Edit::Ungroup { .. } => "Ungroup".to_owned(),
        Edit::MakeCluster { .. } => "Make cluster".to_owned(),
        Edit::ExplodeCluster { .. } => "Explode cluster".to_owned(),
        Edit::Publish { .. } => "Publish inputs".to_owned(),
        Edit::Settings { .. } => "Change document settings".to_owned(),
    }
}

/// What an object is called by.
fn called(object: &Object) -> String {
    let title = object.title();
    let title = if title.is_empty() { "object" } else { title };
    title.chars().filter(|letter| !letter.is_control()).take(MOST_LETTERS).collect()
}

/// What objects of that kind are called.
fn kind(component: Uuid) -> &'static str {
    match component {
        ids::SCRIBBLE => "Scribble",
        ids::GROUP => "Group",
        other => registry::by_guid(other).map_or("object", |component| component.name),
    }
}
