//! A step between two states of a document as bytes: what a journal keeps of it, and what one program sends another.

use std::sync::Arc;

use katydid_definition::archive::{self, Chunk, Item, Limits};
use katydid_definition::document::{Difference, Object};

/// A difference as bytes: an archive with one chunk.
///
/// # Errors
/// Something in it cannot be written in a .gh archive, as a text of more than 2 GiB.
pub fn write_difference(difference: &Difference) -> Result<Vec<u8>, katydid_definition::Error> {
    let mut chunk = Chunk::new("Difference");
    write(difference, &mut chunk);
    archive::write_gh(&chunk)
}

/// A difference from the bytes that [`write_difference`] made; none where they are anything else. Whether it fits a document
/// is seen when that takes it.
pub fn read_difference(bytes: &[u8]) -> Option<Difference> {
    let chunk = archive::read(bytes, &Limits::default()).ok()?.root;
    if chunk.name == "Difference" { read(&chunk) } else { None }
}

fn count(n: usize) -> i32 {
    i32::try_from(n).unwrap_or(i32::MAX)
}

/// Adds a difference to what a chunk holds.
pub(super) fn write(difference: &Difference, chunk: &mut Chunk) {
    let items = (0..).zip(&difference.removed).map(|(k, at)| Item::indexed("Removed", k, count(*at)));
    chunk.items.extend(items);
    for (at, object) in &difference.put {
        let mut put = Chunk::indexed("Put", count(*at));
        put.chunks.push(object.chunk().clone());
        chunk.chunks.push(put);
    }
    if let Some(frame) = &difference.frame {
        let mut around = Chunk::new("Frame");
        around.chunks.push(Chunk::clone(frame));
        chunk.chunks.push(around);
    }
}

/// The difference that a chunk holds.
pub(super) fn read(chunk: &Chunk) -> Option<Difference> {
    let place = |k: i32| usize::try_from(k).ok();
    let removed = chunk.list("Removed").into_iter().map(|(_, at)| at.as_i32().and_then(place));
    let mut put = Vec::new();
    for chunk in chunk.chunks.iter().filter(|chunk| chunk.name == "Put") {
        put.push((place(chunk.index?)?, Object::from_chunk(chunk.chunks.first()?.clone())));
    }
    let frame = chunk.child("Frame").and_then(|around| around.chunks.first()).cloned();
    Some(Difference { removed: removed.collect::<Option<_>>()?, put, frame: frame.map(Arc::new) })
}
