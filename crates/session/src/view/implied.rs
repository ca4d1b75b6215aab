//! Sliders without a name of their own are called by the input that they feed, as in Grasshopper.

use std::collections::{HashMap, HashSet};

use katydid_definition::document::{Difference, Document, Object, ids};
use uuid::Uuid;

/// The names of sliders that have none of their own, by the sliders' ids.
pub(super) type Names = HashMap<Uuid, String>;

/// Whether an object is called by what it feeds.
fn is_nameless(object: &Object) -> bool {
    object.component == ids::NUMBER_SLIDER && object.nickname.trim().is_empty()
}

/// The names of all such sliders of a document: each by the first input that reads it.
pub(super) fn names(document: &Document) -> Names {
    let nameless: HashSet<Uuid> =
        document.objects.iter().filter(|object| is_nameless(object)).map(|object| object.id).collect();
    let mut names = Names::with_capacity(nameless.len());
    if nameless.is_empty() {
        return names;
    }
    for object in &document.objects {
        for port in &object.inputs {
            for source in port.sources.iter().filter(|source| nameless.contains(source)) {
                let name = if object.is_floating() { object.title() } else { &port.name };
                names.entry(*source).or_insert_with(|| name.to_owned());
            }
        }
    }
    names
}

/// The sliders that a change gave another name, without changing them.
pub(super) fn renamed<'a>(
    difference: &Difference,
    before: &Document,
    after: &'a Document,
    now: &Names,
) -> Vec<&'a Object> {
    if difference.is_in_place() && difference.put.iter().all(|(at, new)| keeps_names(before, *at, new)) {
        return Vec::new();
    }
    let was = names(before);
    let changed: HashSet<Uuid> = difference.put.iter().map(|(_, object)| object.id).collect();
    let others = after.objects.iter().filter(|object| is_nameless(object) && !changed.contains(&object.id));
    others.filter(|object| was.get(&object.id) != now.get(&object.id)).collect()
}

/// Whether an object that is changed reads the same under the same names.
fn keeps_names(before: &Document, at: usize, new: &Object) -> bool {
    before.objects.get(at).is_some_and(|old| {
        let same =
            old.inputs.iter().zip(&new.inputs).all(|(a, b)| a.name == b.name && a.sources == b.sources);
        old.id == new.id && old.nickname == new.nickname && old.inputs.len() == new.inputs.len() && same
    })
}
