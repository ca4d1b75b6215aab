//! Edits that were never saved, kept on disk: where, and by whom.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use katydid_data::cast::Rules;
use katydid_definition::document::Document;
use katydid_session::Editor;
use katydid_session::journal::{FileStore, Source as Origin, Store};

use super::source::id_of;
use crate::files::private_folder;
use crate::lock::held;

/// What the journal has waiting is written after so long at the latest.
const SOON: Duration = Duration::from_millis(160);
/// The ending of journals.
const ENDING: &str = "journal";
/// The ending of those that cannot be read.
const DAMAGED: &str = "damaged";
/// The ids of documents that were never saved have so many letters; those of files have fewer.
const UNSAVED: usize = 32;

/// Keeps the journal of a document.
#[derive(Debug, Default)]
pub(super) struct Keeper {
    place: Option<Place>,
    due: Option<Instant>,
    /// What is to be said of the journal, once.
    trouble: Option<String>,
}

/// Where a journal is, and the right to write it.
#[derive(Debug)]
struct Place {
    folder: PathBuf,
    file: Arc<Mutex<PathBuf>>,
    /// Held as long as the document is open: two programs must not write one journal.
    lock: File,
}

/// A journal that goes elsewhere when the document is saved under another name.
#[derive(Debug)]
struct Movable {
    file: Arc<Mutex<PathBuf>>,
    store: FileStore,
}

impl Movable {
    fn store(&mut self) -> &mut FileStore {
        let file = held(&self.file).clone();
        if self.store.path() != file {
            self.store = FileStore::new(file);
        }
        &mut self.store
    }
}

impl Store for Movable {
    fn read(&mut self) -> io::Result<Vec<u8>> {
        self.store().read()
    }

    fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.store().append(bytes)
    }

    fn replace(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.store().replace(bytes)
    }
}

fn origin(path: Option<&Path>, hash: Option<blake3::Hash>) -> Origin {
    Origin {
        path: path.map(|path| path.display().to_string()),
        hash: hash.map(|hash| hash.to_hex().to_string()).unwrap_or_default(),
    }
}

fn locked(folder: &Path, id: &str) -> io::Result<File> {
    private_folder(folder)?;
    let lock =
        File::options().create(true).truncate(false).write(true).open(folder.join(format!("{id}.lock")))?;
    lock.try_lock().map_err(|_| io::Error::other("another Katydid has this document open"))?;
    Ok(lock)
}

impl Place {
    fn new(folder: &Path, id: &str) -> io::Result<Self> {
        let lock = locked(folder, id)?;
        let file = Arc::new(Mutex::new(folder.join(id).with_extension(ENDING)));
        Ok(Self { folder: folder.to_path_buf(), file, lock })
    }

    fn store(&self) -> Box<dyn Store> {
        let store = FileStore::new(held(&self.file).clone());
        Box::new(Movable { file: Arc::clone(&self.file), store })
    }

    /// Keeps a journal that cannot be read under another name: it may hold what somebody wants back. Without that it
    /// would be written over.
    fn put_aside(&self) {
        let file = held(&self.file);
        let _ = fs::rename(&*file, file.with_extension(DAMAGED));
    }

    /// The journal of a document goes where it is looked for when its file is opened.
    fn go_to(&mut self, id: &str) -> io::Result<()> {
        let next = self.folder.join(id).with_extension(ENDING);
        let mut file = held(&self.file);
        if *file != next {
            self.lock = locked(&self.folder, id)?;
            let _ = fs::remove_file(&*file);
            *file = next;
        }
        Ok(())
    }
}

impl Keeper {
    /// An editor of a document, with what a session before this one left unsaved.
    pub(super) fn open(
        document: Document,
        rules: Rules,
        folder: Option<&Path>,
        id: &str,
        path: Option<&Path>,
        hash: Option<blake3::Hash>,
    ) -> (Editor, Self) {
        let Some(folder) = folder else { return (Editor::new(document, rules), Self::default()) };
        let opened = Place::new(folder, id).and_then(|place| {
            let editor = Editor::with_journal(document.clone(), rules, origin(path, hash), place.store())?;
            if editor.lost_journal().is_some() {
                place.put_aside();
            }
            Ok((editor, place))
        });
        match opened {
            Ok((editor, place)) => (editor, Self { place: Some(place), ..Self::default() }),
            Err(error) => {
                let trouble = format!("edits are not kept until they are saved: {error}");
                (Editor::new(document, rules), Self { trouble: Some(trouble), ..Self::default() })
            }
        }
    }

    /// When something is to be written.
    pub(super) fn due(&self) -> Option<Instant> {
        self.due
    }

    /// Takes note that something has changed.
    pub(super) fn note(&mut self) {
        if self.place.is_some() {
            self.due.get_or_insert_with(|| Instant::now() + SOON);
        }
    }

    /// Writes what has waited long enough.
    pub(super) fn tick(&mut self, editor: &mut Editor) {
        if self.due.is_some_and(|due| Instant::now() >= due) {
            self.due = None;
            editor.tick();
            if let Some(failure) = editor.journal_failure().filter(|_| self.place.is_some()) {
                self.trouble = Some(format!("edits are not kept until they are saved: {failure}"));
                self.place = None;
            }
        }
    }

    /// What went wrong, once: to be asked when there is somebody to tell.
    pub(super) fn trouble(&mut self) -> Option<String> {
        self.trouble.take()
    }

    /// The document was saved as it stands, in that file.
    pub(super) fn saved(&mut self, editor: &mut Editor, path: &Path, hash: blake3::Hash) {
        if let Some(place) = &mut self.place
            && let Err(error) = place.go_to(&id_of(path))
        {
            self.trouble = Some(format!("edits are not kept until they are saved: {error}"));
        }
        editor.note_saved(Some(origin(Some(path), Some(hash))));
    }
}

/// The ids of documents that were never saved and left something behind, newest first.
pub(crate) fn left_behind(folder: &Path) -> Vec<String> {
    let mut found: Vec<_> = fs::read_dir(folder)
        .into_iter()
        .flatten()
        .filter_map(|entry| {
            let path = entry.ok()?.path();
            let id = path.file_stem()?.to_str()?.to_owned();
            let is_unsaved = id.len() == UNSAVED && path.extension().is_some_and(|ending| ending == ENDING);
            let modified = fs::metadata(&path).ok()?.modified().ok()?;
            is_unsaved.then_some((modified, id))
        })
        .collect();
    found.sort_by_key(|(modified, _)| std::cmp::Reverse(*modified));
    found.into_iter().map(|(_, id)| id).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use katydid_definition::document::ids;
    use katydid_session::protocol::Edit;
    use uuid::Uuid;

    use super::*;

    fn place(id: u128) -> Edit {
        Edit::Place { id: Uuid::from_u128(id), component: ids::PANEL, at: [0.0, 0.0], with: None }
    }

    fn open(folder: &Path, id: &str) -> (Editor, Keeper) {
        Keeper::open(Document::new(), Rules::default(), Some(folder), id, None, None)
    }

    #[test]
    fn what_was_not_saved_comes_back_under_the_name_that_it_was_saved_by() {
        katydid_components::link();
        let folder = tempfile::tempdir().unwrap();
        let id = "a".repeat(UNSAVED);
        let (mut editor, keeper) = open(folder.path(), &id);
        editor.apply(&place(1), None, &[]).unwrap();
        editor.flush();
        drop((editor, keeper));
        assert_eq!(left_behind(folder.path()).as_slice(), std::slice::from_ref(&id));
        let (mut editor, mut keeper) = open(folder.path(), &id);
        assert_eq!(editor.document().objects.len(), 1);
        assert_eq!(editor.found().unwrap().restored.steps, 1);
        let path = folder.path().join("saved.gh");
        keeper.saved(&mut editor, &path, blake3::hash(b"x"));
        editor.apply(&place(2), None, &[]).unwrap();
        editor.flush();
        drop((editor, keeper));
        assert!(left_behind(folder.path()).is_empty());
        let (editor, _) = open(folder.path(), &id_of(&path));
        assert_eq!(editor.document().objects.len(), 2);
    }

    #[test]
    fn a_journal_that_cannot_be_read_is_put_aside() {
        let folder = tempfile::tempdir().unwrap();
        let (file, aside) = (folder.path().join("one.journal"), folder.path().join("one.damaged"));
        fs::write(&file, "garbage").unwrap();
        let (mut editor, keeper) = open(folder.path(), "one");
        assert!(editor.lost_journal().is_some() && keeper.place.is_some());
        editor.apply(&place(1), None, &[]).unwrap();
        editor.flush();
        assert!(file.exists() && fs::read(&aside).unwrap() == b"garbage");
    }

    #[test]
    fn two_programs_do_not_write_one_journal() {
        let folder = tempfile::tempdir().unwrap();
        let (_, first) = open(folder.path(), "one");
        let (_, mut second) = open(folder.path(), "one");
        assert!(first.trouble.is_none() && first.place.is_some() && second.place.is_none());
        second.tick(&mut Editor::new(Document::new(), Rules::default()));
        assert!(second.trouble().is_some() && second.trouble().is_none());
    }
}
