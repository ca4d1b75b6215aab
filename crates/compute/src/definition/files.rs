//! Definitions that a pointer names by the path of a file.

use std::path::{Path, PathBuf};

use katydid_component::Files;

use crate::Fault;
use crate::request::shown;

/// The folders below which definitions may be named by their paths.
#[derive(Debug)]
pub(crate) struct DefinitionFiles(Vec<Files>);

impl DefinitionFiles {
    pub(crate) fn below(folders: &[PathBuf]) -> Self {
        Self(folders.iter().cloned().map(Files::Inside).collect())
    }

    /// The bytes of the file that a pointer names. A relative path is looked for in each folder in turn. Whoever asks is
    /// told the same of a file outside the folders and of one that is not there.
    ///
    /// # Errors
    /// `Refused` when no folder was named or the file is none of a definition by its name, `NotFound` when there is no
    /// such file below them, or it has more than `most` bytes.
    pub(crate) fn read(&self, pointer: &str, most: usize) -> Result<Vec<u8>, Fault> {
        const WHAT: &str = "Unable to load grasshopper definition";
        if self.0.is_empty() {
            return Err(Fault::refused(format!("{WHAT}: paths of files are not followed")));
        }
        if !is_definition(pointer) {
            let why = "only paths of .gh and .ghx files are followed";
            return Err(Fault::refused(format!("{WHAT}: {why}")));
        }
        let most = u64::try_from(most).unwrap_or(u64::MAX);
        self.0.iter().find_map(|folder| folder.read(pointer, most).ok()).ok_or_else(|| {
            let why = "no such file in the folders of definitions, or it is too large";
            Fault::not_found(format!("{WHAT}: {}: {why}", shown(pointer)))
        })
    }
}

/// Whether a file is one of a definition, by its name.
fn is_definition(pointer: &str) -> bool {
    let extension = Path::new(pointer.trim()).extension().and_then(|extension| extension.to_str());
    extension.is_some_and(|extension| ["gh", "ghx"].iter().any(|own| own.eq_ignore_ascii_case(extension)))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;
    use crate::Cause;

    #[test]
    fn only_definitions_below_the_folders_are_read() {
        let room = tempfile::tempdir().unwrap();
        let (first, second) = (room.path().join("first"), room.path().join("second"));
        std::fs::create_dir_all(first.join("roofs")).unwrap();
        std::fs::create_dir_all(&second).unwrap();
        std::fs::write(first.join("roofs/a.ghx"), "a").unwrap();
        std::fs::write(first.join("notes.txt"), "n").unwrap();
        std::fs::write(second.join("b.GH"), "bb").unwrap();
        std::fs::write(room.path().join("c.gh"), "c").unwrap();
        let files = DefinitionFiles::below(&[first.clone(), second.clone()]);
        let whole = first.join("roofs/a.ghx").display().to_string();
        for (pointer, bytes) in [("roofs/a.ghx", "a"), (whole.as_str(), "a"), (" b.GH ", "bb")] {
            assert_eq!(files.read(pointer, 10).unwrap(), bytes.as_bytes(), "{pointer}");
        }
        let outside = room.path().join("c.gh").display().to_string();
        for pointer in ["../c.gh", "roofs/../../c.gh", outside.as_str(), "none.gh"] {
            let fault = files.read(pointer, 10).unwrap_err();
            assert_eq!(fault.cause, Cause::NotFound, "{pointer}");
            assert!(fault.message.contains(pointer) && !fault.message.contains("first"), "{}", fault.message);
        }
        for pointer in ["notes.txt", "roofs", "", "/etc/passwd", ".gh"] {
            assert_eq!(files.read(pointer, 10).unwrap_err().cause, Cause::Refused, "{pointer}");
        }
        assert_eq!(files.read("b.GH", 1).unwrap_err().cause, Cause::NotFound, "too large");
        assert_eq!(DefinitionFiles::below(&[]).read("b.GH", 10).unwrap_err().cause, Cause::Refused);
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink(room.path().join("c.gh"), first.join("link.gh")).unwrap();
            assert!(files.read("link.gh", 10).is_err(), "a link that leads out");
        }
    }
}
