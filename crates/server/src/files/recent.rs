//! The files that were open last.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::UNIX_EPOCH;

use serde::Serialize;

use crate::lock::held;

/// So many are remembered.
const MOST: usize = 20;
/// A longer list is none of ours.
const LONGEST: u64 = 1 << 20;

/// The list of recent files, newest first. Without a folder to keep it in it lasts as long as the server.
#[derive(Debug)]
pub(crate) struct Recent {
    list: Mutex<Vec<PathBuf>>,
    file: Option<PathBuf>,
}

/// A recent file for the start page.
#[derive(Debug, Serialize)]
pub(crate) struct Entry {
    path: String,
    name: String,
    /// In seconds since 1970.
    modified: u64,
}

impl Recent {
    /// The list in that folder; empty where there is none yet, or it cannot be read.
    pub(crate) fn new(state: Option<&Path>) -> Self {
        let file = state.map(|state| state.join("recent.json"));
        let list = file.as_deref().and_then(|file| {
            fs::metadata(file).ok().filter(|told| told.len() <= LONGEST)?;
            serde_json::from_slice(&fs::read(file).ok()?).ok()
        });
        Self { list: Mutex::new(list.unwrap_or_default()), file }
    }

    /// Puts a file at the top.
    pub(crate) fn note(&self, path: &Path) {
        let mut list = held(&self.list);
        list.retain(|known| known != path);
        list.insert(0, path.to_path_buf());
        list.truncate(MOST);
        let Some(file) = &self.file else { return };
        // A list that cannot be kept is no reason to stop.
        let made = file.parent().map(super::private_folder);
        if let (Some(Ok(())), Ok(text)) = (made, serde_json::to_vec(&*list)) {
            let _ = katydid_session::write_file(file, &text);
        }
    }

    /// The files that are still there.
    pub(crate) fn entries(&self) -> Vec<Entry> {
        let list = held(&self.list).clone();
        list.iter().filter_map(|path| entry(path)).collect()
    }

    /// The file whose document has that id, where it is one of these.
    pub(crate) fn find(&self, matches: impl Fn(&Path) -> bool) -> Option<PathBuf> {
        held(&self.list).iter().find(|path| matches(path)).cloned()
    }
}

fn entry(path: &Path) -> Option<Entry> {
    let told = fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
    let modified = told.modified().ok()?.duration_since(UNIX_EPOCH).ok()?.as_secs();
    let name = path.file_name()?.to_string_lossy().into_owned();
    Some(Entry { path: path.to_str()?.to_owned(), name, modified })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;

    #[test]
    fn the_list_is_kept_newest_first() {
        let folder = tempfile::tempdir().unwrap();
        let state = folder.path().join("state");
        let recent = Recent::new(Some(&state));
        for k in (0..30).chain([3]) {
            let path = folder.path().join(format!("{k}.kd"));
            fs::write(&path, "").unwrap();
            recent.note(&path);
        }
        let again = Recent::new(Some(&state)).entries();
        assert_eq!((again.len(), again[0].name.as_str(), again[1].name.as_str()), (MOST, "3.kd", "29.kd"));
        fs::remove_file(folder.path().join("3.kd")).unwrap();
        assert_eq!(recent.entries()[0].name, "29.kd");
    }
}
