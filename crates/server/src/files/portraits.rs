//! Small pictures of definitions for the start page: what they make, or their canvas where they make nothing to see.
//!
//! A picture is made once: it is kept by the hash of the definition's bytes, in a folder where there is one.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::SystemTime;

use katydid_component::Trust;
use katydid_solver::Options;
use katydid_studio::portrait;

use crate::document::Source;
use crate::lock::held;

/// So many pictures are kept.
const MOST: usize = 300;
/// Raised when pictures are drawn otherwise, so that old ones are not shown.
const VERSION: u8 = 1;

/// The pictures that were made, by the hash of what they are of.
#[derive(Debug, Default)]
pub(crate) struct Portraits {
    folder: Option<PathBuf>,
    /// Those that were made or read since the server began; none where no picture can be made. Held while one is made:
    /// one at a time, so that documents that are open are solved all the while.
    known: Mutex<HashMap<blake3::Hash, Option<Vec<u8>>>>,
}

impl Portraits {
    /// Kept in a folder of its own in `state`, where that is given.
    pub(crate) fn new(state: Option<&Path>) -> Self {
        Self { folder: state.map(|state| state.join("pictures")), ..Self::default() }
    }

    /// The picture of a definition as PNG, from the bytes of it that `source` is read from.
    pub(crate) fn of(
        &self,
        bytes: &[u8],
        trust: &Trust,
        source: impl FnOnce() -> Result<Source, String>,
    ) -> Option<Vec<u8>> {
        let key = blake3::Hasher::new().update(&[VERSION]).update(bytes).finalize();
        let mut known = held(&self.known);
        if let Some(picture) = known.get(&key) {
            return picture.clone();
        }
        let picture = self.read(&key).or_else(|| {
            let made = source().ok().and_then(|source| made(source, trust))?;
            self.keep(&key, &made);
            Some(made)
        });
        if known.len() >= MOST {
            known.clear();
        }
        known.insert(key, picture.clone());
        picture
    }

    fn file(&self, key: &blake3::Hash) -> Option<PathBuf> {
        Some(self.folder.as_ref()?.join(format!("{}.png", key.to_hex())))
    }

    fn read(&self, key: &blake3::Hash) -> Option<Vec<u8>> {
        let bytes = std::fs::read(self.file(key)?).ok()?;
        bytes.starts_with(b"\x89PNG").then_some(bytes)
    }

    /// Keeps a picture in the folder. One that cannot be kept is made again another time.
    fn keep(&self, key: &blake3::Hash, picture: &[u8]) {
        let (Some(folder), Some(file)) = (&self.folder, self.file(key)) else { return };
        if super::private_folder(folder).is_ok() && katydid_session::write_file(&file, picture).is_ok() {
            forget_oldest(folder);
        }
    }
}

/// Takes the oldest pictures out of the folder where there are too many.
fn forget_oldest(folder: &Path) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    let mut files: Vec<(SystemTime, PathBuf)> = entries
        .flatten()
        .filter(|entry| entry.path().extension().is_some_and(|extension| extension == "png"))
        .filter_map(|entry| Some((entry.metadata().ok()?.modified().ok()?, entry.path())))
        .collect();
    files.sort();
    let beyond = files.len().saturating_sub(MOST);
    for (_, path) in files.into_iter().take(beyond) {
        let _ = std::fs::remove_file(path);
    }
}

/// Solves a definition and draws it.
fn made(source: Source, trust: &Trust) -> Option<Vec<u8>> {
    let files = trust.files(source.origin());
    let drawn = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
        portrait(source.document, Options { rules: source.rules, files, ..Options::default() })
    }));
    drawn.ok().flatten()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;
    use crate::files::{Form, Gallery};

    fn size_of(png: &[u8]) -> (u32, u32) {
        let picture = image::load_from_memory(png).unwrap();
        (picture.width(), picture.height())
    }

    #[test]
    fn a_picture_is_made_once_and_kept_in_the_folder() {
        katydid_components::link();
        let state = tempfile::tempdir().unwrap();
        let trust = Trust::shared(Vec::new());
        let text = Gallery::find("V2").unwrap().text().unwrap();
        let source = || Source::sent("V2.kd", Form::Kd, &text);
        let first = Portraits::new(Some(state.path())).of(&text, &trust, source).unwrap();
        assert_eq!(size_of(&first), (640, 400));
        // Another server finds it there, and asks for no definition.
        let again = Portraits::new(Some(state.path())).of(&text, &trust, || Err("not asked".to_owned()));
        assert_eq!(again.as_ref(), Some(&first));
        // Where nothing is kept it would have to be made.
        assert!(Portraits::new(None).of(&text, &trust, || Err("asked".to_owned())).is_none());
    }

    #[test]
    fn what_shows_nothing_is_shown_as_its_canvas() {
        katydid_components::link();
        let text = b"katydid 1\n".to_vec();
        let trust = Trust::shared(Vec::new());
        let empty = Portraits::new(None).of(&text, &trust, || Ok(Source::empty()));
        // An empty canvas is a picture too, no larger than a tile's.
        assert!(empty.is_none_or(|png| size_of(&png).0 <= 640));
    }

    #[test]
    fn what_is_very_much_gets_no_picture() {
        katydid_components::link();
        let trust = Trust::shared(Vec::new());
        let text = b"katydid 1\nmany = Series(0, 1, 60000)\n".to_vec();
        let source = || Source::sent("many.kd", Form::Kd, &text);
        assert!(source().is_ok() && Portraits::new(None).of(&text, &trust, source).is_none());
    }

    #[test]
    fn the_folder_holds_so_many_and_no_more() {
        let folder = tempfile::tempdir().unwrap();
        for k in 0..MOST + 5 {
            std::fs::write(folder.path().join(format!("{k}.png")), "").unwrap();
        }
        forget_oldest(folder.path());
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), MOST);
    }
}
