//! Opening definitions.

use std::fs;
use std::path::Path;

use katydid_definition::archive::Limits;
use katydid_definition::document::Document;

/// Files larger than this are not read: no definition comes near.
const LARGEST: u64 = 1 << 30;

/// The bytes of a file.
pub(crate) fn bytes(path: &Path) -> Result<Vec<u8>, String> {
    let size = fs::metadata(path).map_err(|error| format!("{}: {}", path.display(), plain(&error)))?.len();
    if size > LARGEST {
        return Err(format!("{}: {size} bytes are more than any definition has", path.display()));
    }
    fs::read(path).map_err(|error| format!("{}: {}", path.display(), plain(&error)))
}

/// A definition from a file.
pub(crate) fn document(path: &Path) -> Result<Document, String> {
    Document::read(&bytes(path)?, &Limits::default()).map_err(|error| format!("{}: {error}", path.display()))
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
