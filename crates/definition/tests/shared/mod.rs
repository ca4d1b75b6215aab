//! The real files beside the repository.

use std::path::{Path, PathBuf};

/// All definitions under `shared/data/gh`, sorted; empty, with a line that says so, when there are none. With
/// `KATYDID_REQUIRE_SHARED` set their absence is a failure.
pub(crate) fn definitions() -> Vec<PathBuf> {
    let folder = folder();
    let mut files = Vec::new();
    collect(&folder, &mut files);
    files.sort();
    if files.is_empty() {
        assert!(
            std::env::var_os("KATYDID_REQUIRE_SHARED").is_none(),
            "no definitions under {}",
            folder.display()
        );
        println!("skipped: no definitions under {}", folder.display());
    }
    files
}

/// The folder of the real definitions.
pub(crate) fn folder() -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data/gh")).to_owned()
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let path = entry.path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|e| e == "gh" || e == "ghx" || e == "ghuser") {
            files.push(path);
        }
    }
}
