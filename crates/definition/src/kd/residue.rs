//! What the pretty form does not say: the changes that lead from one tree to another.

use super::ast::{Change, Edit, RawValue, Step};
use crate::archive::{Chunk, Item, ItemValue};

/// Items and chunks by name and index, as Grasshopper writes them. Those that have both alike stay in order.
pub(super) fn sort(chunk: &mut Chunk) {
    chunk.items.sort_by(|a, b| (&a.name, a.index).cmp(&(&b.name, b.index)));
    chunk.chunks.sort_by(|a, b| (&a.name, a.index).cmp(&(&b.name, b.index)));
    chunk.chunks.iter_mut().for_each(sort);
}

/// What an entry of a sorted list is found by: its name, its index, and which of those alike it is.
type Key<'a> = (&'a str, Option<i32>, usize);

/// Each entry of a sorted list with its key.
fn keyed<'a, T>(
    list: &'a [T],
    name: impl Fn(&'a T) -> (&'a str, Option<i32>),
) -> impl Iterator<Item = (Key<'a>, &'a T)> {
    let mut last: Option<Key<'a>> = None;
    list.iter().map(move |entry| {
        let (name, index) = name(entry);
        let nth = match last {
            Some((other, at, nth)) if other == name && at == index => nth + 1,
            _ => 0,
        };
        let key = (name, index, nth);
        last = Some(key);
        (key, entry)
    })
}

/// The changes that make `to` of `from`. Both must be sorted.
pub(super) fn diff(from: &Chunk, to: &Chunk) -> Vec<Edit> {
    let mut edits = Vec::new();
    walk(from, to, &mut Vec::new(), &mut edits);
    edits
}

/// Walks two sorted lists side by side.
fn pairs<'a, T: 'a>(
    from: impl Iterator<Item = (Key<'a>, &'a T)>,
    to: impl Iterator<Item = (Key<'a>, &'a T)>,
    mut each: impl FnMut(Key<'a>, Option<&'a T>, Option<&'a T>),
) {
    let (mut from, mut to) = (from.peekable(), to.peekable());
    loop {
        let side = match (from.peek(), to.peek()) {
            (Some((a, _)), Some((b, _))) => a.cmp(b),
            (Some(_), None) => std::cmp::Ordering::Less,
            (None, Some(_)) => std::cmp::Ordering::Greater,
            (None, None) => return,
        };
        let old = if side.is_le() { from.next() } else { None };
        let new = if side.is_ge() { to.next() } else { None };
        if let Some((key, _)) = new.or(old) {
            each(key, old.map(|(_, entry)| entry), new.map(|(_, entry)| entry));
        }
    }
}

/// The path of an entry: names are written down only where something differs.
fn path_to(parents: &[Key<'_>], last: Key<'_>) -> Vec<Step> {
    let step = |(name, index, nth): &Key<'_>| Step { name: (*name).to_owned(), index: *index, nth: *nth };
    parents.iter().chain([&last]).map(step).collect()
}

fn walk<'a>(from: &'a Chunk, to: &'a Chunk, path: &mut Vec<Key<'a>>, edits: &mut Vec<Edit>) {
    let mut removed = Vec::new();
    pairs(items(from), items(to), |key, old: Option<&Item>, new: Option<&Item>| match (old, new) {
        (Some(old), Some(new)) if old.value == new.value => {}
        (_, Some(new)) => {
            let change = Change::Set(RawValue::Value(new.value.clone()));
            edits.push(Edit::new(path_to(path, key), change));
        }
        (Some(_), None) => removed.push(Edit::new(path_to(path, key), Change::Remove)),
        (None, None) => {}
    });
    pairs(chunks(from), chunks(to), |key, old: Option<&'a Chunk>, new: Option<&'a Chunk>| match (old, new) {
        (None, Some(new)) if new.items.is_empty() && new.chunks.is_empty() => {
            edits.push(Edit::new(path_to(path, key), Change::Add));
        }
        (old, Some(new)) => {
            path.push(key);
            walk(old.unwrap_or(&EMPTY), new, path, edits);
            path.pop();
        }
        (Some(_), None) => removed.push(Edit::new(path_to(path, key), Change::RemoveChunk)),
        (None, None) => {}
    });
    // Backwards: of several alike the last goes first, so that the others keep their numbers.
    edits.extend(removed.into_iter().rev());
}

/// What a chunk that was not there is compared with.
static EMPTY: Chunk = Chunk { name: String::new(), index: None, items: Vec::new(), chunks: Vec::new() };

fn items(chunk: &Chunk) -> impl Iterator<Item = (Key<'_>, &Item)> {
    keyed(&chunk.items, |item| (&item.name, item.index))
}

fn chunks(chunk: &Chunk) -> impl Iterator<Item = (Key<'_>, &Chunk)> {
    keyed(&chunk.chunks, |chunk| (&chunk.name, chunk.index))
}

/// The most chunks that may stand inside each other.
const DEEPEST: usize = crate::archive::DEEPEST - 20;

/// Makes one change. `data` gives the bytes by their number; `Err` is a number that has none, or nothing when the
/// path is too long.
pub(super) fn apply<'d>(
    chunk: &mut Chunk,
    edit: &Edit,
    data: &dyn Fn(u32) -> Option<&'d [u8]>,
) -> Result<(), Option<u32>> {
    if edit.path.len() > DEEPEST {
        return Err(None);
    }
    let bytes = |n: u32| data(n).map(<[u8]>::to_vec).ok_or(Some(n));
    let value = match &edit.change {
        Change::Set(RawValue::Value(value)) => Some(value.clone()),
        Change::Set(RawValue::Bytes(n)) => Some(ItemValue::ByteArray(bytes(*n)?)),
        Change::Set(RawValue::Bitmap(n)) => Some(ItemValue::Bitmap(bytes(*n)?)),
        _ => None,
    };
    let Some((last, parents)) = edit.path.split_last() else { return Ok(()) };
    let create = matches!(edit.change, Change::Set(_) | Change::Add);
    let mut at = chunk;
    for step in parents {
        let Some(next) = child(at, step, create) else { return Ok(()) };
        at = next;
    }
    match (&edit.change, value) {
        (Change::Set(_), Some(value)) => set(at, last, value),
        (Change::Add, _) => {
            child(at, last, true);
        }
        (Change::Remove, _) => {
            if let Some(k) = nth(&at.items, last, |item| (&item.name, item.index)) {
                at.items.remove(k);
            }
        }
        _ => {
            if let Some(k) = nth(&at.chunks, last, |chunk| (&chunk.name, chunk.index)) {
                at.chunks.remove(k);
            }
        }
    }
    Ok(())
}

fn nth<'a, T>(list: &'a [T], step: &Step, key: impl Fn(&'a T) -> (&'a str, Option<i32>)) -> Option<usize> {
    let mut same =
        list.iter().enumerate().filter(|(_, entry)| key(entry) == (step.name.as_str(), step.index));
    same.nth(step.nth).map(|(k, _)| k)
}

/// Where a new entry goes among the sorted ones: behind those that are alike.
fn place<'a, T>(list: &'a [T], step: &Step, key: impl Fn(&'a T) -> (&'a str, Option<i32>)) -> usize {
    list.iter().position(|entry| key(entry) > (step.name.as_str(), step.index)).unwrap_or(list.len())
}

fn child<'a>(chunk: &'a mut Chunk, step: &Step, create: bool) -> Option<&'a mut Chunk> {
    let found = nth(&chunk.chunks, step, |chunk| (&chunk.name, chunk.index));
    let k = match found {
        Some(k) => k,
        None if create => {
            let k = place(&chunk.chunks, step, |chunk| (&chunk.name, chunk.index));
            chunk.chunks.insert(k, Chunk { name: step.name.clone(), index: step.index, ..Chunk::default() });
            k
        }
        None => return None,
    };
    chunk.chunks.get_mut(k)
}

fn set(chunk: &mut Chunk, step: &Step, value: ItemValue) {
    match nth(&chunk.items, step, |item| (&item.name, item.index)).and_then(|k| chunk.items.get_mut(k)) {
        Some(item) => item.value = value,
        None => {
            let k = place(&chunk.items, step, |item| (&item.name, item.index));
            chunk.items.insert(k, Item { name: step.name.clone(), index: step.index, value });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{apply, diff, sort};
    use crate::archive::{Chunk, Item};

    #[test]
    fn the_changes_lead_from_one_tree_to_the_other() {
        let mut from = Chunk::new("a");
        from.items = vec![Item::new("x", 1), Item::new("x", 2), Item::new("y", 3), Item::indexed("y", 4, 5)];
        from.chunks = vec![Chunk::new("gone"), Chunk::indexed("kept", 1), Chunk::indexed("kept", 1)];
        let mut to = Chunk::new("a");
        to.items =
            vec![Item::new("z", 1.5), Item::new("x", 1), Item::new("y", "text"), Item::indexed("w", 1, true)];
        to.chunks = vec![Chunk::indexed("kept", 1), Chunk::new("empty"), Chunk::new("full")];
        to.chunks[2].items.push(Item::new("deep", false));
        sort(&mut from);
        sort(&mut to);
        for (a, b) in [(&from, &to), (&to, &from)] {
            let mut made = a.clone();
            for edit in diff(a, b) {
                apply(&mut made, &edit, &|_| None).unwrap();
            }
            assert_eq!(&made, b);
        }
        assert!(diff(&from, &from).is_empty());
    }
}
