//! A definition is changed as text.

use std::sync::Arc;

use katydid_definition::document::{Difference, Document};
use katydid_session::Editor;
use katydid_session::protocol::Edit;
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::json;

use super::files::read_text;
use super::{Does, Entry, Reply, diff, entry};
use crate::document::{Opened, cut};
use crate::fault::Fault;
use crate::store::Store;
use crate::thresholds::{MOST_EDITS, MOST_TEXT};

pub(super) fn entries() -> Vec<Entry> {
    vec![entry(
        "edit_text",
        "Edit as text",
        "Changes a definition as text in .kd (read_text gives it, katydid://kd explains it): replaces passages that occur once \
         each, appends statements, or takes a whole text in its place. All of it is one step for undo, or nothing is done: \
         what is wrong is told with line and column. The quickest way to build: \
         append \"r = Number Slider(5, 0..10)\\nc = Circle(_, r)\".",
        Does::Edits,
        edit,
    )]
}

/// A passage, and what stands in its place.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Passage {
    /// The passage, exactly as read_text gives it; it must occur once.
    old: String,
    /// What stands in its place; empty to take it out.
    new: String,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct EditText {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// Passages that are replaced, one after the other.
    #[serde(default)]
    replace: Vec<Passage>,
    /// Statements that are added.
    append: Option<String>,
    /// The whole text, in place of what there is.
    whole: Option<String>,
    /// The revision that the text was read at: where the definition has changed since, nothing is done.
    revision: Option<u64>,
}

const WHAT: &str = "the text was not changed";

fn edit(store: &Store, given: EditText) -> Result<Reply, Fault> {
    let opened = store.find(WHAT, given.document.as_deref())?;
    if given.whole.is_some() && !(given.replace.is_empty() && given.append.is_none()) {
        return Err(Fault::new(WHAT, "whole", "it cannot be given together with replace or append"));
    }
    if given.whole.is_none() && given.replace.is_empty() && given.append.is_none() {
        return Err(Fault::new(WHAT, "its arguments", "give replace, append or whole"));
    }
    if given.replace.len() > MOST_EDITS {
        return Err(Fault::new(WHAT, "replace", format!("more than {MOST_EDITS} passages are not taken")));
    }
    let old = opened.text();
    if let Some(wanted) = given.revision {
        let editor = opened.editor();
        let revision = editor.revision();
        if wanted != revision || !Arc::ptr_eq(editor.document(), old.document()) {
            let why = format!("the definition is at revision {revision} now: read it again");
            return Err(Fault::new(WHAT, "revision", why));
        }
    }
    let written = old.written().map_err(|why| Fault::new(WHAT, &opened.id, why))?;
    let text = match given.whole {
        Some(text) => text,
        None => patched(written.text.clone(), &given.replace, given.append.as_deref())?,
    };
    // Both texts are read side by side.
    let (read, again) = rayon::join(|| read_text(WHAT, &text), || old.again());
    let (after, units) = read?;
    let after = kept(old.document(), again, after);
    put(&opened, old.document(), after, units)
}

/// The text with its passages replaced and statements added before the blocks at the end.
fn patched(mut text: String, replace: &[Passage], append: Option<&str>) -> Result<String, Fault> {
    for (k, passage) in replace.iter().enumerate() {
        let place = format!("replace {k}, \"{}\"", cut(&passage.old));
        let mut found = text.match_indices(passage.old.as_str());
        match (passage.old.is_empty(), found.next(), found.next()) {
            (true, ..) => return Err(Fault::new(WHAT, place, "the passage is empty")),
            (_, None, _) => {
                return Err(Fault::new(WHAT, place, "the passage does not occur: read_text gives the text"));
            }
            (_, Some(_), Some(_)) => {
                return Err(Fault::new(
                    WHAT,
                    place,
                    "the passage occurs more than once: give more of what stands around it",
                ));
            }
            (_, Some((at, _)), None) => text.replace_range(at..at + passage.old.len(), &passage.new),
        }
        if text.len() > MOST_TEXT {
            return Err(Fault::new(WHAT, place, format!("the text would have more than {MOST_TEXT} bytes")));
        }
    }
    if let Some(more) = append {
        let blocks = ["\nlayout {", "\nids {", "\ndetails {", "\nfile {", "\ndata {"];
        let at =
            blocks.iter().filter_map(|block| text.find(&format!("{block}\n"))).min().unwrap_or(text.len());
        text.insert_str(at, &format!("\n{}\n", more.trim_end()));
    }
    Ok(text)
}

/// The document after, in which what the text did not change is as it was, byte for byte: the text leaves some of an archive
/// out, and that is not lost by a change elsewhere.
fn kept(before: &Document, again: Option<&Document>, after: Document) -> Document {
    let Some(again) = again else { return after };
    let same =
        |(a, b): (&katydid_definition::document::Object, &katydid_definition::document::Object)| a.id == b.id;
    if again.objects.len() != before.objects.len() || !again.objects.iter().zip(&before.objects).all(same) {
        return after;
    }
    let mut whole = before.clone();
    match whole.apply(&Difference::between(again, &after)) {
        Ok(_) => whole,
        Err(_) => after,
    }
}

/// Makes a document the one that counts, and tells what has changed.
fn put(
    opened: &Opened,
    before: &Arc<Document>,
    after: Document,
    units: Option<katydid_geometry::Units>,
) -> Result<Reply, Fault> {
    let mut editor = opened.editor();
    if !Arc::ptr_eq(editor.document(), before) {
        return Err(Fault::new(
            WHAT,
            &opened.id,
            "another call has changed the definition meanwhile: read it again",
        ));
    }
    // Made on a copy, so that it is one step.
    let mut draft = Editor::new(after, editor.rules());
    if let Some(units) = units {
        let edit = Edit::Settings {
            units: Some(units.name().to_owned()),
            tolerance: None,
            angle_tolerance: None,
            preview_normal: None,
            preview_selected: None,
            name: None,
            author: None,
            description: None,
        };
        draft.apply(&edit, None, &[]).map_err(|why| Fault::new(WHAT, "units", why.to_string()))?;
    }
    opened.put(WHAT, &mut editor, Document::clone(draft.document()), "Edit text".to_owned())?;
    let (revision, now) = (editor.revision(), Arc::clone(editor.document()));
    drop(editor);
    let mut told = diff::changes(before, &now, false);
    told["document"] = json!(opened.id);
    told["revision"] = json!(revision);
    Ok(told.into())
}
