//! The files of definitions.

use std::path::Path;

use katydid_definition::archive::{self, Limits};
use katydid_definition::document::Document;
use katydid_definition::kd;
use katydid_session::Registry;
use pyo3::prelude::*;

use crate::errors::file;

/// Files larger than this are not read: no definition comes near.
const LARGEST: u64 = 1 << 30;

/// The extension in lower case, without the dot.
pub(crate) fn extension(path: &Path) -> String {
    path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default()
}

/// The bytes of a file that is not too large.
pub(crate) fn bytes(path: &Path, largest: u64) -> PyResult<Vec<u8>> {
    let size = std::fs::metadata(path).map_err(|error| file(path, error))?.len();
    if size > largest {
        return Err(file(path, format!("{size} bytes are more than the {largest} that are read")));
    }
    std::fs::read(path).map_err(|error| file(path, error))
}

/// A definition from a file: .gh, .ghx or .kd.
pub(crate) fn read(path: &Path) -> PyResult<kd::Definition> {
    let bytes = bytes(path, LARGEST)?;
    if extension(path) == "kd" {
        let text = String::from_utf8(bytes).map_err(|_| file(path, "it is no text in UTF-8"))?;
        return kd::read(&text, &Registry).map_err(|problems| file(path, problems));
    }
    let document = Document::read(&bytes, &Limits::default()).map_err(|error| file(path, error))?;
    Ok(kd::Definition { document, units: None })
}

/// The bytes of a definition for a file of that name, and what it cannot hold.
pub(crate) fn write(document: &Document, path: &Path) -> PyResult<(Vec<u8>, Vec<String>)> {
    let failed = |error: katydid_definition::Error| file(path, error);
    match extension(path).as_str() {
        "gh" => Ok((archive::write_gh(&placed(document).to_archive().root).map_err(failed)?, Vec::new())),
        "ghx" => {
            let text = archive::write_ghx(&placed(document).to_archive().root).map_err(failed)?;
            Ok((text.into_bytes(), Vec::new()))
        }
        "kd" => {
            let written = kd::write(document, &Registry).map_err(failed)?;
            Ok((written.text.into_bytes(), written.left_out.iter().map(ToString::to_string).collect()))
        }
        other => Err(file(path, format!("a definition is saved as .gh, .ghx or .kd, not .{other}"))),
    }
}

/// The document with a place on the canvas for each object that has none, as text may leave them.
fn placed(document: &Document) -> Document {
    let mut document = document.clone();
    kd::arrange(&mut document);
    document
}
