//! Where the shared data lies.
#![allow(dead_code, reason = "each test file uses its own part")]
#![allow(clippy::unwrap_used, reason = "a helper of tests only")]

use std::path::PathBuf;

/// The .3dm files of the shared data, smallest first, or nothing (with a line that says so) when they are not
/// there. With `KATYDID_REQUIRE_SHARED` set their absence fails the test.
pub(crate) fn archives() -> Vec<(PathBuf, Vec<u8>)> {
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data/3dm"));
    let Ok(entries) = std::fs::read_dir(&folder) else {
        assert!(std::env::var_os("KATYDID_REQUIRE_SHARED").is_none(), "{} is missing", folder.display());
        println!("skipped: {} is missing", folder.display());
        return Vec::new();
    };
    let mut files: Vec<(PathBuf, Vec<u8>)> = entries
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "3dm"))
        .map(|path| (path.clone(), std::fs::read(path).unwrap()))
        .collect();
    files.sort_by_key(|(path, bytes)| (bytes.len(), path.clone()));
    files
}
