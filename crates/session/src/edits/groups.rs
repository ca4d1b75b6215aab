//! Groups: frames around objects, which may be groups.

use std::collections::{HashMap, HashSet};

use katydid_definition::archive::Item;
use katydid_definition::document::{Object, Special, ids};
use uuid::Uuid;

use super::{bounded, make};
use crate::Refusal;
use crate::controls::{argb, border};
use crate::editor::Draft;
use crate::protocol::{BorderView, Colour, GroupChange};
use crate::view::inside;

/// Puts objects in a new group. It is drawn behind all others.
pub(super) fn group(draft: &mut Draft<'_>, id: Uuid, objects: &[Uuid]) -> Result<(), Refusal> {
    bounded(objects)?;
    if draft.has(id) {
        return Ok(());
    }
    let mut seen = HashSet::new();
    let members: Vec<Uuid> = objects.iter().copied().filter(|member| seen.insert(*member)).collect();
    if members.is_empty() || id.is_nil() {
        return Err(Refusal::Senseless("a group needs an id and something in it".to_owned()));
    }
    for &member in &members {
        draft.object(member)?;
    }
    let mut group = make::object(ids::GROUP, id)?;
    put_members(&mut group, &members);
    draft.document.objects.insert(0, group);
    draft.stir();
    Ok(())
}

/// Changes a group.
pub(super) fn change(draft: &mut Draft<'_>, id: Uuid, change: &GroupChange) -> Result<(), Refusal> {
    let group = draft.object(id)?;
    let Some(Special::Group(now)) = group.special() else {
        return Err(Refusal::Unfit {
            object: group.title().to_owned(),
            reason: "it is not a group".to_owned(),
        });
    };
    match change {
        GroupChange::Label { text } if *text != now.label => group.set_nickname(text),
        GroupChange::Colour { colour } if now.colour != Some(argb(*colour)) => {
            group.container_mut().set("Colour", argb(*colour));
        }
        GroupChange::Border { border: shape } => {
            let number = border(*shape);
            if group.container().i32("Border") != Some(number) {
                group.container_mut().set("Border", number);
            }
        }
        GroupChange::Members { members } => return set_members(draft, id, members),
        GroupChange::Label { .. } | GroupChange::Colour { .. } => {}
    }
    Ok(())
}

fn set_members(draft: &mut Draft<'_>, id: Uuid, members: &[Uuid]) -> Result<(), Refusal> {
    bounded(members)?;
    let mut seen = HashSet::new();
    let members: Vec<Uuid> = members.iter().copied().filter(|member| seen.insert(*member)).collect();
    for &member in &members {
        draft.object(member)?;
    }
    let mut all: HashMap<Uuid, Vec<Uuid>> = all(draft.document.objects.iter());
    all.insert(id, members.clone());
    if inside(id, &all).contains(&id) {
        return Err(Refusal::Senseless("a group cannot be inside itself".to_owned()));
    }
    put_members(draft.object(id)?, &members);
    Ok(())
}

/// The members of all groups.
fn all<'a>(objects: impl Iterator<Item = &'a Object>) -> HashMap<Uuid, Vec<Uuid>> {
    let groups = objects.filter(|object| object.component == ids::GROUP);
    groups
        .filter_map(|object| match object.special() {
            Some(Special::Group(group)) => Some((object.id, group.members)),
            _ => None,
        })
        .collect()
}

/// Gives a group another face and other members: as a control it knows only itself.
pub(crate) fn shape(
    object: &mut Object,
    label: &str,
    colour: Colour,
    frame: BorderView,
    members: &[Uuid],
) -> Result<(), Refusal> {
    bounded(members)?;
    if members.contains(&object.id) {
        return Err(Refusal::Senseless("a group cannot be inside itself".to_owned()));
    }
    if object.nickname != label {
        object.set_nickname(label);
    }
    let container = object.container_mut();
    container.set("Colour", argb(colour));
    container.set("Border", border(frame));
    put_members(object, members);
    Ok(())
}

/// Writes the members of a group.
pub(super) fn put_members(group: &mut Object, members: &[Uuid]) {
    let old: Vec<Uuid> =
        group.container().list("ID").into_iter().filter_map(|(_, id)| id.as_guid()).collect();
    if old == members {
        return;
    }
    let container = group.container_mut();
    let at = container.items.iter().position(|item| item.name == "ID");
    container.remove("ID");
    let at = at.unwrap_or_else(|| {
        container.items.iter().position(|item| item.name.as_str() > "ID").unwrap_or(container.items.len())
    });
    let items = (0..).zip(members).map(|(k, id)| Item::indexed("ID", k, *id));
    container.items.splice(at..at, items);
    container.set("ID_Count", i32::try_from(members.len()).unwrap_or(i32::MAX));
    group.refresh();
}

/// Takes groups away and leaves what is in them.
pub(super) fn ungroup(draft: &mut Draft<'_>, groups: &[Uuid]) -> Result<(), Refusal> {
    bounded(groups)?;
    let named: HashSet<Uuid> = groups.iter().copied().collect();
    let members = all(draft.document.objects.iter());
    // A group's members go over to the group that it was in.
    for object in draft.document.objects.iter_mut().filter(|object| object.component == ids::GROUP) {
        let Some(own) = members.get(&object.id).filter(|_| !named.contains(&object.id)) else { continue };
        if !own.iter().any(|id| named.contains(id) && members.contains_key(id)) {
            continue;
        }
        let mut seen = HashSet::from([object.id]);
        let mut now = Vec::new();
        let mut stack: Vec<Uuid> = own.iter().rev().copied().collect();
        while let Some(id) = stack.pop() {
            if !seen.insert(id) {
                continue;
            }
            match members.get(&id).filter(|_| named.contains(&id)) {
                Some(inner) => stack.extend(inner.iter().rev()),
                None => now.push(id),
            }
        }
        put_members(object, &now);
    }
    draft.document.objects.retain(|object| object.component != ids::GROUP || !named.contains(&object.id));
    draft.stir();
    Ok(())
}

/// Takes objects that are gone out of all groups. A group that is left empty goes too, as in Grasshopper.
pub(super) fn forget(draft: &mut Draft<'_>, gone: &HashSet<Uuid>) {
    let mut empty = HashSet::new();
    for object in draft.document.objects.iter_mut().filter(|object| object.component == ids::GROUP) {
        let Some(Special::Group(group)) = object.special() else { continue };
        if group.members.iter().any(|id| gone.contains(id)) {
            let rest: Vec<Uuid> = group.members.iter().copied().filter(|id| !gone.contains(id)).collect();
            if rest.is_empty() {
                empty.insert(object.id);
            } else {
                put_members(object, &rest);
            }
        }
    }
    if !empty.is_empty() {
        draft.document.objects.retain(|object| !empty.contains(&object.id));
        draft.stir();
        forget(draft, &empty);
    }
}
