//! The document as faces see it.

mod control;
mod implied;
mod object;
pub(crate) mod picture;
mod port;
pub(crate) mod size;
mod strip;

use std::collections::{HashMap, HashSet};

use katydid_definition::document::{Difference, Document, Object, Special, ids};
use uuid::Uuid;

pub(crate) use port::{is_removable, is_variable, kind, parameter_kind};

use crate::controls::colour;
use crate::protocol::{
    Colour, DocumentState, DocumentView, Event, ObjectKindView, ObjectView, Problem, Support,
};
use crate::{Change, Editor, Refusal};

/// Around a group's members.
const MARGIN: f32 = 8.0;
/// The most problems that are told.
const MOST_PROBLEMS: usize = 200;

/// Everything a face needs to show a document.
pub(crate) fn state(editor: &Editor, document: &Document, within: &[Uuid]) -> Result<DocumentState, Refusal> {
    let names = implied::names(document);
    let mut objects: Vec<ObjectView> =
        document.objects.iter().map(|object| object::view(document, object, &names)).collect();
    frame_groups(&mut objects);
    Ok(DocumentState {
        revision: editor.revision(),
        within: within.to_vec(),
        document: header(editor),
        problems: problems(editor, document, &objects),
        objects,
        restored: editor.found().map(|found| found.restored.clone()),
    })
}

/// The document's own settings and states.
pub(crate) fn header(editor: &Editor) -> DocumentView {
    let document = editor.document();
    let rules = editor.rules();
    let about = editor.about();
    let shown = |own: Option<katydid_definition::archive::Colour>, usual: Colour| own.map_or(usual, colour);
    DocumentView {
        name: if about.name.is_empty() { document.header.name.clone() } else { about.name.clone() },
        path: about.path.clone(),
        author: document.header.author.clone(),
        description: document.header.description.clone(),
        units: rules.units.name().to_owned(),
        tolerance: rules.tolerance.absolute,
        angle_tolerance: rules.tolerance.angle.to_degrees(),
        preview_normal: shown(document.header.preview_normal, [150, 0, 0, 100]),
        preview_selected: shown(document.header.preview_selected, [0, 150, 0, 100]),
        changed: editor.is_changed(),
        undo: editor.undo_name().map(str::to_owned),
        redo: editor.redo_name().map(str::to_owned),
        locked: about.locked,
        player: crate::edits::published(document),
        scripts: about.scripts,
    }
}

/// What a face has to change after a change of the document.
pub(crate) fn patch(editor: &Editor, change: &Change, within: &[Uuid]) -> Option<Event> {
    if change.is_empty() {
        return None;
    }
    if within.is_empty() {
        return Some(event(editor, change, &change.difference, [&change.before, &change.after], within));
    }
    let inside = |document: &Document| crate::editor::open(document, within);
    let after = inside(&change.after).ok()?;
    let before = inside(&change.before).unwrap_or_default();
    let difference = Difference::between(&before, &after);
    Some(event(editor, change, &difference, [&before, &after], within))
}

fn event(
    editor: &Editor,
    change: &Change,
    difference: &Difference,
    [before, after]: [&Document; 2],
    within: &[Uuid],
) -> Event {
    let names = implied::names(after);
    let changed = difference.put.iter().map(|(_, object)| object);
    let touched = moved_groups(difference, before, after);
    let renamed = implied::renamed(difference, before, after, &names);
    let all = changed.chain(touched).chain(renamed);
    let mut put: Vec<ObjectView> = all.map(|object| object::view(after, object, &names)).collect();
    if put.iter().any(|view| view.kind == ObjectKindView::Group) {
        frame_groups_of(&mut put, after);
    }
    Event::Patch {
        revision: change.revision,
        within: within.to_vec(),
        put,
        removed: difference.gone(before),
        order: (!keeps_order(difference, before))
            .then(|| after.objects.iter().map(|object| object.id).collect()),
        document: Some(header(editor)),
    }
}

/// Whether the order of the objects that stay is as before, and new ones stand at the end: a face knows it then.
fn keeps_order(difference: &Difference, before: &Document) -> bool {
    let stays =
        |(at, object): &(usize, Object)| before.objects.get(*at).is_some_and(|old| old.id == object.id);
    if difference.is_in_place() && difference.put.iter().all(stays) {
        return true;
    }
    let rest = before.objects.len() - difference.removed.len().min(before.objects.len());
    difference.put.iter().enumerate().all(|(k, (at, _))| *at == rest + k)
        && difference.counterparts(before).iter().all(Option::is_none)
}

/// The groups that are not changed themselves, but whose members are.
fn moved_groups<'a>(difference: &Difference, before: &Document, after: &'a Document) -> Vec<&'a Object> {
    let mut touched: HashSet<Uuid> = difference.put.iter().map(|(_, object)| object.id).collect();
    touched.extend(difference.gone(before));
    let changed: HashSet<Uuid> = difference.put.iter().map(|(_, object)| object.id).collect();
    let groups: Vec<(&Object, Vec<Uuid>)> = groups(after).collect();
    // A group of a group is touched as well: as often as groups can stand in each other.
    loop {
        let mut more = false;
        for (group, members) in &groups {
            more |= members.iter().any(|id| touched.contains(id)) && touched.insert(group.id);
        }
        if !more {
            break;
        }
    }
    let moved =
        groups.iter().filter(|(group, _)| touched.contains(&group.id) && !changed.contains(&group.id));
    moved.map(|(group, _)| *group).collect()
}

/// The groups of a document with their members.
fn groups(document: &Document) -> impl Iterator<Item = (&Object, Vec<Uuid>)> {
    let groups = document.objects.iter().filter(|object| object.component == ids::GROUP);
    groups.filter_map(|object| match object.special() {
        Some(Special::Group(group)) => Some((object, group.members)),
        _ => None,
    })
}

/// Gives groups the bounds of their members.
fn frame_groups(views: &mut [ObjectView]) {
    let bounds: HashMap<Uuid, [f32; 4]> = views.iter().map(|view| (view.id, view.bounds)).collect();
    let members: HashMap<Uuid, Vec<Uuid>> = views
        .iter()
        .filter_map(|view| match &view.control {
            Some(crate::protocol::Control::Group { members, .. }) => Some((view.id, members.clone())),
            _ => None,
        })
        .collect();
    for view in views.iter_mut().filter(|view| view.kind == ObjectKindView::Group) {
        view.bounds = frame(view.id, &bounds, &members);
    }
}

/// The same where only some objects have views.
fn frame_groups_of(views: &mut [ObjectView], document: &Document) {
    let members: HashMap<Uuid, Vec<Uuid>> =
        groups(document).map(|(group, members)| (group.id, members)).collect();
    let mut wanted: HashSet<Uuid> = HashSet::new();
    for view in views.iter().filter(|view| view.kind == ObjectKindView::Group) {
        wanted.extend(inside(view.id, &members));
    }
    let bounds: HashMap<Uuid, [f32; 4]> = document
        .objects
        .iter()
        .filter(|object| wanted.contains(&object.id))
        .map(|object| (object.id, size::bounds(object)))
        .collect();
    for view in views.iter_mut().filter(|view| view.kind == ObjectKindView::Group) {
        view.bounds = frame(view.id, &bounds, &members);
    }
}

/// All that is in a group, and in the groups in it; a ring of groups ends where it began.
pub(crate) fn inside(group: Uuid, members: &HashMap<Uuid, Vec<Uuid>>) -> HashSet<Uuid> {
    let mut found = HashSet::new();
    let mut stack = vec![group];
    while let Some(group) = stack.pop() {
        for &member in members.get(&group).into_iter().flatten() {
            if found.insert(member) {
                stack.push(member);
            }
        }
    }
    found
}

fn frame(group: Uuid, bounds: &HashMap<Uuid, [f32; 4]>, members: &HashMap<Uuid, Vec<Uuid>>) -> [f32; 4] {
    let inner = inside(group, members);
    let rects = inner.iter().filter(|id| !members.contains_key(id)).filter_map(|id| bounds.get(id));
    let corners: Vec<[f32; 2]> = rects.flat_map(|[x, y, w, h]| [[*x, *y], [x + w, y + h]]).collect();
    if corners.is_empty() {
        return [0.0; 4];
    }
    let [x, y, w, h] = size::around(corners);
    [x - MARGIN, y - MARGIN, w + 2.0 * MARGIN, h + 2.0 * MARGIN]
}

/// What is odd about a file: what its reader noticed, and what of it cannot run.
fn problems(editor: &Editor, document: &Document, views: &[ObjectView]) -> Vec<Problem> {
    let changed = editor.found().filter(|found| found.file_changed).map(|_| Problem {
        text: "the file was saved elsewhere since these edits were made".to_owned(),
        object: None,
    });
    let torn = editor.found().filter(|found| found.torn).map(|_| Problem {
        text: "the journal of unsaved edits is damaged at its end: the last of them may be missing"
            .to_owned(),
        object: None,
    });
    let lost = editor.lost_journal().map(|why| Problem {
        text: format!(
            "unsaved edits of an earlier session could not be restored: their journal cannot be read, {why}"
        ),
        object: None,
    });
    let notes = document.notes.iter().map(|text| Problem { text: text.clone(), object: None });
    let unsupported = views.iter().filter_map(|view| match &view.support {
        Support::Yes => None,
        Support::No { reason, .. } => Some(Problem {
            text: format!(
                "{} cannot run: {reason}",
                if view.name.is_empty() { "An object" } else { &view.name }
            ),
            object: Some(view.id),
        }),
    });
    let odd = document.problems().into_iter().map(|text| Problem { text, object: None });
    let journal = changed.into_iter().chain(torn).chain(lost);
    journal.chain(notes).chain(unsupported).chain(odd).take(MOST_PROBLEMS).collect()
}
