//! What Grasshopper puts on the clipboard: an archive as text, like a file, whose definition is called Clipboard.

use std::collections::HashSet;

use katydid_definition::archive::{self, Archive, Chunk, Encoding, Limits};
use katydid_definition::document::{Document, Object};
use katydid_definition::kd;
use uuid::Uuid;

use crate::{Refusal, Registry};

const CLIPBOARD: &str = "Clipboard";
const DEFINITION: &str = "Definition";
/// A text that is larger than this is no definition.
const LARGEST: usize = 256 << 20;

/// The objects of these ids with the wires into them, as text for the clipboard.
pub(crate) fn copy(document: &Document, objects: &[Uuid]) -> Result<String, Refusal> {
    let wanted: HashSet<Uuid> = objects.iter().copied().collect();
    let picked: Vec<Object> =
        document.objects.iter().filter(|object| wanted.contains(&object.id)).cloned().collect();
    if picked.is_empty() {
        return Err(Refusal::Senseless("there is nothing to copy".to_owned()));
    }
    let mut copy = Document::new();
    // The add-ons that the objects come from, so that they are known elsewhere.
    let used: HashSet<Uuid> = picked.iter().filter_map(|object| object.lib).collect();
    if let Some(libraries) = part(document.frame()).child("GHALibraries") {
        let list = libraries.children("Library").into_iter();
        add_libraries(
            copy.tree_mut(),
            list.filter(|chunk| chunk.guid("Id").is_some_and(|id| used.contains(&id))),
        );
    }
    copy.objects = picked;
    let mut root = copy.to_archive().root;
    if let Some(definition) = root.child_mut(DEFINITION) {
        definition.name = CLIPBOARD.to_owned();
    }
    Ok(archive::write_ghx(&root)?)
}

/// The definition's parts; the root itself inside a cluster.
fn part(root: &Chunk) -> &Chunk {
    root.child(DEFINITION).unwrap_or(root)
}

/// Puts add-ons into the list of a document that has not got them.
pub(super) fn add_libraries<'a>(root: &mut Chunk, libraries: impl Iterator<Item = &'a Chunk>) {
    let mut libraries = libraries.peekable();
    if libraries.peek().is_none() {
        return;
    }
    let at = root.chunks.iter().position(|chunk| chunk.name == DEFINITION && chunk.index.is_none());
    let definition = match at {
        Some(at) => &mut root.chunks[at],
        None => root,
    };
    if definition.child("GHALibraries").is_none() {
        let mut list = Chunk::new("GHALibraries");
        list.set("Count", 0);
        definition.set_child(list);
    }
    let Some(list) = definition.child_mut("GHALibraries") else { return };
    for library in libraries {
        let known = list.chunks.iter().any(|chunk| chunk.guid("Id") == library.guid("Id"));
        if !known {
            let next =
                list.chunks.iter().filter_map(|chunk| chunk.index).max().map_or(0, |k| k.saturating_add(1));
            list.set_child(Chunk { index: Some(next), ..library.clone() });
        }
    }
    list.set("Count", i32::try_from(list.chunks.len()).unwrap_or(i32::MAX));
}

/// The document that a text holds: of the clipboard, of a .ghx file or a .kd file.
pub(super) fn read(text: &str) -> Result<Document, Refusal> {
    if text.len() > LARGEST {
        return Err(Refusal::Senseless(format!("more than {LARGEST} bytes are no definition")));
    }
    let begins = text.trim_start_matches(['\u{feff}', ' ', '\t', '\r', '\n']);
    if !begins.starts_with('<') {
        let mut definition = kd::read(text, &Registry).map_err(|problems| {
            Refusal::Senseless(format!("this is neither Grasshopper's nor Katydid's text: {problems}"))
        })?;
        kd::arrange(&mut definition.document);
        return Ok(definition.document);
    }
    let mut read = archive::read(text.as_bytes(), &Limits::default())?;
    if let Some(clipboard) = read.root.child_mut(CLIPBOARD) {
        clipboard.name = DEFINITION.to_owned();
    }
    Ok(Document::from_archive(Archive::new(read.root, Encoding::Xml))?)
}
