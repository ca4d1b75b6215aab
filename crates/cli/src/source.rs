//! Opening definitions.

use std::fs;
use std::path::Path;

use katydid_definition::archive::Limits;
use katydid_definition::document::Document;
use katydid_definition::kd::{self, Definition, Problems};

use crate::output::extension;
use katydid_session::Registry;

/// Files larger than this are not read: no definition comes near.
const LARGEST: u64 = 1 << 30;

/// The bytes of a file.
pub(crate) fn bytes(path: &Path) -> Result<Vec<u8>, String> {
    let size = fs::metadata(path).map_err(|error| format!("{}: {}", path.display(), plain(&error)))?.len();
    if size > LARGEST {
        return Err(format!(
            "{}: {size} bytes are more than any definition or model that can be read has",
            path.display()
        ));
    }
    fs::read(path).map_err(|error| format!("{}: {}", path.display(), plain(&error)))
}

/// A definition from a file.
pub(crate) fn document(path: &Path) -> Result<Document, String> {
    Ok(definition(path)?.document)
}

/// A definition from a file, with its unit where the file names one.
pub(crate) fn definition(path: &Path) -> Result<Definition, String> {
    let bytes = bytes(path)?;
    if extension(path) == "kd" {
        return kd::read(&text(path, bytes)?, &Registry).map_err(|problems| pointed(path, &problems));
    }
    match Document::read(&bytes, &Limits::default()) {
        Ok(document) => Ok(Definition { document, units: None }),
        Err(error) => Err(format!("{}: {error}", path.display())),
    }
}

/// The bytes of a file as text.
pub(crate) fn text(path: &Path, bytes: Vec<u8>) -> Result<String, String> {
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        format!("{}: byte {at} is no UTF-8: this is no text", path.display())
    })
}

/// All that is wrong with a text, each line with the file's name as editors and terminals find it.
pub(crate) fn pointed(path: &Path, problems: &Problems) -> String {
    let of = |n: usize| if n == 1 { "1 thing is wrong".to_owned() } else { format!("{n} things are wrong") };
    format!("{}: {}\n{problems}", path.display(), of(problems.list.len()))
}

/// What went wrong, without the number of the error.
pub(crate) fn plain(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        std::io::ErrorKind::PermissionDenied => "it may not be read".to_owned(),
        std::io::ErrorKind::IsADirectory => "it is a folder".to_owned(),
        _ => error.to_string(),
    }
}
