//! About how much memory a document takes.

use katydid_definition::archive::{Chunk, ItemValue};
use katydid_definition::document::Document;

/// What an object's fields take besides its chunk, and what a port does.
const OBJECT: usize = 600;
const PORT: usize = 500;

/// A document with its archive.
pub(crate) fn document(document: &Document) -> usize {
    let ports = |object: &katydid_definition::document::Object| object.inputs.len() + object.outputs.len();
    let objects = document.objects.iter();
    chunk(document.tree())
        + objects.map(|object| OBJECT + PORT * ports(object) + chunk(object.chunk())).sum::<usize>()
}

fn chunk(root: &Chunk) -> usize {
    let items = |chunk: &Chunk| -> usize {
        chunk.items.iter().map(|item| size_of_val(item) + item.name.len() + own(&item.value)).sum()
    };
    // Archives nest deeply: no recursion.
    let (mut total, mut stack) = (0, vec![root]);
    while let Some(chunk) = stack.pop() {
        total += size_of::<Chunk>() + chunk.name.len() + items(chunk);
        stack.extend(&chunk.chunks);
    }
    total
}

/// What a value takes besides its place.
fn own(value: &ItemValue) -> usize {
    match value {
        ItemValue::String(text) => text.len(),
        ItemValue::ByteArray(bytes) | ItemValue::Bitmap(bytes) => bytes.len(),
        ItemValue::DoubleArray(numbers) => 8 * numbers.len(),
        _ => 0,
    }
}
