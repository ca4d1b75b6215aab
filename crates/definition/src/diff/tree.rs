//! Settings that nobody here knows by name: items of the archive that differ.

use std::collections::BTreeMap;

use crate::archive::{Chunk, ItemValue};
use crate::kd::value_form;

/// An item that differs: its path, what it was, what it is.
pub(super) struct Difference {
    pub(super) path: String,
    pub(super) old: Option<String>,
    pub(super) new: Option<String>,
}

/// No more differences than this are told of one object.
const MOST: usize = 40;

/// The items that differ. A path for which `known` holds is not looked at.
pub(super) fn compare(old: &Chunk, new: &Chunk, known: &dyn Fn(&str) -> bool) -> Vec<Difference> {
    let mut list = Vec::new();
    walk(old, new, "", known, &mut list);
    list
}

fn key(name: &str, index: Option<i32>) -> String {
    index.map_or_else(|| name.to_owned(), |index| format!("{name}[{index}]"))
}

fn walk(old: &Chunk, new: &Chunk, path: &str, known: &dyn Fn(&str) -> bool, list: &mut Vec<Difference>) {
    if old == new {
        return;
    }
    let (before, after) = (items(old), items(new));
    let mut names: Vec<&String> = before.keys().chain(after.keys()).collect();
    names.sort();
    names.dedup();
    for name in names {
        let path = format!("{path}{name}");
        let (a, b) = (before.get(name), after.get(name));
        if a == b || known(&path) || list.len() >= MOST {
            continue;
        }
        let text = |value: Option<&&ItemValue>| value.map(|value| value_form(value));
        list.push(Difference { path, old: text(a), new: text(b) });
    }
    let nothing = Chunk::default();
    let mut names: Vec<(&str, Option<i32>)> =
        old.chunks.iter().chain(&new.chunks).map(|chunk| (chunk.name.as_str(), chunk.index)).collect();
    names.sort_unstable();
    names.dedup();
    for (name, index) in names {
        let path = format!("{path}{}/", key(name, index));
        if known(&path) {
            continue;
        }
        let (a, b) = (find(old, name, index), find(new, name, index));
        walk(a.unwrap_or(&nothing), b.unwrap_or(&nothing), &path, known, list);
    }
}

/// The items by name and index; of several alike the last.
fn items(chunk: &Chunk) -> BTreeMap<String, &ItemValue> {
    chunk.items.iter().map(|item| (key(&item.name, item.index), &item.value)).collect()
}

/// The first chunk of a name and index.
fn find<'a>(chunk: &'a Chunk, name: &str, index: Option<i32>) -> Option<&'a Chunk> {
    chunk.chunks.iter().find(|inner| inner.name == name && inner.index == index)
}
