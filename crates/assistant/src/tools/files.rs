//! Definitions are made, opened, saved and closed.

use std::path::Path;

use katydid_3dm::Model;
use katydid_component::RhinoModel;
use katydid_definition::document::Document;
use katydid_studio::{Form, Gallery};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Value, json};

use super::{Does, Entry, Reply, describe, entry};
use crate::document::Opened;
use crate::fault::Fault;
use crate::folders::Folders;
use crate::store::Store;
use crate::thresholds::{MOST_FILES, MOST_TEXT};

pub(super) fn entries() -> Vec<Entry> {
    vec![
        entry(
            "new_definition",
            "New definition",
            "Makes a definition in memory: empty, from text in .kd (resource katydid://kd explains it), or from one of the \
             examples and definitions of the book. Gives its id, which other tools take as `document`. No file is made.",
            Does::Edits,
            new,
        ),
        entry(
            "open_definition",
            "Open definition",
            "Opens a definition from a file: .gh, .ghx or .kd below the folders that are open; with a Rhino model (.3dm) \
             beside it where it refers to one. Tells its inputs, outputs and groups, and what in it cannot run here.",
            Does::Edits,
            open,
        ),
        entry(
            "list_definitions",
            "List definitions",
            "Tells which definitions are open, and which definitions and models lie in the folders that are open.",
            Does::Reads,
            list,
        ),
        entry(
            "save_definition",
            "Save definition",
            "Saves a definition as .gh, .ghx (both open in Grasshopper) or .kd (text), by the extension of the path. Without \
             a path it is saved where it was opened or saved before. A file that is there is written over only with \
             `overwrite`. Tells what the format leaves out.",
            Does::Writes,
            save,
        ),
        entry(
            "close_definition",
            "Close definition",
            "Closes a definition. One with changes that are not saved is closed only with `discard`: they are gone then.",
            Does::Writes,
            close,
        ),
    ]
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct New {
    /// What it is called.
    name: Option<String>,
    /// The definition as text in .kd.
    kd: Option<String>,
    /// The id of an example or of a definition of the book: what stands behind katydid://definition/ in the list of
    /// resources.
    example: Option<String>,
}

fn new(store: &Store, given: New) -> Result<Reply, Fault> {
    const WHAT: &str = "no definition was made";
    store.must_be_own(WHAT)?;
    let (mut document, units) = match (&given.kd, &given.example) {
        (Some(_), Some(_)) => {
            return Err(Fault::new(WHAT, "kd, example", "only one of the two can be given"));
        }
        (Some(text), None) => read_text(WHAT, text)?,
        (None, Some(id)) => {
            let text = Gallery::find(id).and_then(Gallery::text);
            let place = format!("example \"{}\"", crate::document::cut(id));
            let text = text.ok_or_else(|| Fault::new(WHAT, place.clone(), "there is none of that id"))?;
            katydid_studio::read(Form::Kd, &text).map_err(|why| Fault::new(WHAT, place, why))?
        }
        (None, None) => (Document::new(), None),
    };
    if let Some(name) = given.name {
        document.header.name = name;
    }
    let opened = store.open(document, units, None, None)?;
    Ok(describe::overview(&opened).into())
}

/// A definition from text, if it is not too long.
pub(super) fn read_text(
    what: &str,
    text: &str,
) -> Result<(Document, Option<katydid_geometry::Units>), Fault> {
    if text.len() > MOST_TEXT {
        let why = format!("the text has {} bytes, {MOST_TEXT} are taken at most", text.len());
        return Err(Fault::new(what, "kd", why));
    }
    katydid_studio::read(Form::Kd, text.as_bytes()).map_err(|why| Fault::new(what, "kd", why))
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Open {
    /// The file: absolute, or from one of the folders that are open.
    path: String,
    /// The Rhino model (.3dm) with the objects that the definition refers to; its unit and tolerance count.
    model: Option<String>,
}

fn open(store: &Store, given: Open) -> Result<Reply, Fault> {
    const WHAT: &str = "the definition was not opened";
    store.must_be_own(WHAT)?;
    let form = Form::of(Path::new(&given.path)).ok_or_else(|| {
        Fault::new(WHAT, &given.path, "a definition is a .gh, .ghx or .kd file; models go with `model`")
    })?;
    let (path, bytes) = store.folders.read(&given.path)?;
    let (document, units) =
        katydid_studio::read(form, &bytes).map_err(|why| Fault::new(WHAT, &given.path, why))?;
    let model = given.model.as_deref().map(|model| read_model(store, model)).transpose()?;
    let opened = store.open(document, units, Some(path), model)?;
    Ok(describe::overview(&opened).into())
}

fn read_model(store: &Store, path: &str) -> Result<RhinoModel, Fault> {
    let (_, bytes) = store.folders.read(path)?;
    let model = Model::read_strict(&bytes, &katydid_3dm::Limits::default())
        .map_err(|error| Fault::new("the model was not opened", path, error.to_string()))?;
    Ok(RhinoModel::new(model))
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Nothing {}

fn list(store: &Store, _: Nothing) -> Result<Reply, Fault> {
    store.follow("nothing was listed")?;
    let open: Vec<Value> = store
        .all()
        .iter()
        .map(|one| {
            json!({
                "document": one.id,
                "name": one.name(),
                "path": one.place().path,
                "objects": one.document().objects.len(),
                "unsaved": is_unsaved(one),
            })
        })
        .collect();
    let is_wanted = |path: &Path| {
        let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase());
        matches!(extension.as_deref(), Some("gh" | "ghx" | "kd" | "3dm"))
    };
    let (files, more) = store.folders.list(is_wanted);
    let files: Vec<Value> =
        files.iter().map(|(path, bytes)| json!({ "path": path, "bytes": bytes })).collect();
    let mut told = json!({ "open": open, "folders": store.folders.all(), "files": files });
    if store.folders.all().is_empty() {
        told["note"] = json!("no folder is open: files can be neither read nor written (--folder opens one)");
    } else if more {
        told["note"] = json!(format!("there are more files than the {MOST_FILES} that are listed"));
    }
    Ok(told.into())
}

/// Whether something of it would be lost.
fn is_unsaved(one: &Opened) -> bool {
    // What is open in a studio is there still.
    if one.original.is_some() {
        return false;
    }
    let kept = one.place();
    let document = one.document();
    match kept.path {
        Some(_) => !std::sync::Arc::ptr_eq(&kept.kept, &document) && one.editor().is_changed(),
        None => !document.objects.is_empty(),
    }
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Save {
    /// The definition's id, as d1; may be left out while only one is open.
    document: Option<String>,
    /// The file, ending in .gh, .ghx or .kd: absolute, or from the first folder that is open.
    path: Option<String>,
    /// Whether a file that is there is written over.
    #[serde(default)]
    overwrite: bool,
}

fn save(store: &Store, given: Save) -> Result<Reply, Fault> {
    const WHAT: &str = "the definition was not saved";
    let opened = store.find(WHAT, given.document.as_deref())?;
    let (path, overwrite) = match (&given.path, opened.place().path) {
        (Some(path), _) => (path.clone(), given.overwrite),
        (None, Some(own)) => (own.display().to_string(), true),
        (None, None) if opened.original.is_some() => {
            let why = "the person saves it in the studio: name a path for a copy";
            return Err(Fault::new(WHAT, "path", why));
        }
        (None, None) => return Err(Fault::new(WHAT, "path", "it is in no file yet: name one")),
    };
    let form = Form::of(Path::new(&path))
        .ok_or_else(|| Fault::new(WHAT, &path, "a definition is saved as .gh, .ghx or .kd"))?;
    let place = store.folders.place(&path, overwrite)?;
    let document = opened.document();
    let (bytes, left_out) =
        katydid_studio::write(form, &document).map_err(|why| Fault::new(WHAT, &path, why))?;
    Folders::write(&place, &bytes)?;
    if opened.original.is_none() {
        opened.note_saved(place.clone(), document);
    }
    Ok(json!({ "document": opened.id, "path": place, "bytes": bytes.len(), "left_out": left_out }).into())
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Close {
    /// The definition's id, as d1.
    document: String,
    /// Whether changes that are not saved may be lost.
    #[serde(default)]
    discard: bool,
}

fn close(store: &Store, given: Close) -> Result<Reply, Fault> {
    const WHAT: &str = "the definition was not closed";
    store.must_be_own(WHAT)?;
    let opened = store.find(WHAT, Some(&given.document))?;
    if is_unsaved(&opened) && !given.discard {
        let why = "it has changes that are not saved: save it, or call again with \"discard\": true";
        return Err(Fault::new(WHAT, &opened.id, why));
    }
    store.close(&opened.id);
    Ok(json!({ "closed": opened.id }).into())
}
