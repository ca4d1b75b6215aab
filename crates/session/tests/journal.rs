//! The journal on disk: written soon, restored whole, short, and its own file only.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use katydid_component::registry;
use katydid_definition::document::Document;
use katydid_session::Editor;
use katydid_session::journal::{FileStore, Source};
use katydid_session::protocol::{Edit, Setting};
use uuid::Uuid;

fn open(path: &std::path::Path, document: Document, hash: &str) -> Editor {
    katydid_components::link();
    let source = Source { path: Some("a.gh".to_owned()), hash: hash.to_owned() };
    Editor::with_journal(document, Default::default(), source, Box::new(FileStore::new(path))).unwrap()
}

fn place(editor: &mut Editor, id: u128, name: &str) -> Uuid {
    let id = Uuid::from_u128(id);
    let component = registry::by_name(name).unwrap().guid;
    editor.apply(&Edit::Place { id, component, at: [0.0, 0.0], with: None }, None, &[]).unwrap();
    id
}

#[test]
fn what_was_not_saved_is_restored_with_its_history() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.journal");
    let mut editor = open(&path, Document::new(), "1");
    assert!(!path.exists() && editor.found().is_none());
    let slider = place(&mut editor, 1, "Number Slider");
    place(&mut editor, 2, "Panel");
    editor.undo();
    for k in 0..20 {
        let edit = Edit::Set { object: slider, to: Setting::Number { value: f64::from(k) / 20.0 } };
        editor.apply(&edit, Some(1), &[]).unwrap();
    }
    editor.flush();
    let now = editor.document().to_gh().unwrap();
    // As after kill −9: nothing is closed.
    std::mem::forget(editor);
    let mut again = open(&path, Document::new(), "1");
    assert_eq!(again.document().to_gh().unwrap(), now);
    let found = again.found().unwrap();
    assert_eq!((found.restored.steps, found.file_changed, found.torn), (2, false, false));
    assert!(found.restored.at > 1_600_000_000);
    assert!(again.is_changed());
    assert_eq!(again.state(&[]).unwrap().restored.unwrap().steps, 2);
    // It goes on from there, and is restored once more.
    place(&mut again, 3, "Panel");
    std::mem::forget(again);
    let mut again = open(&path, Document::new(), "2");
    assert_eq!(again.document().objects.len(), 2);
    assert!(again.found().unwrap().file_changed);
    assert!(again.state(&[]).unwrap().problems.iter().any(|p| p.text.contains("saved elsewhere")));
    // Discarded, it is the file again; that can be taken back.
    assert!(!again.settle(false).is_empty());
    assert!(again.document().objects.is_empty() && !again.is_changed() && again.found().is_none());
    again.undo();
    assert_eq!(again.document().objects.len(), 2);
    again.note_saved(Some(Source { path: Some("a.gh".to_owned()), hash: "3".to_owned() }));
    assert!(!path.exists());
    let saved = Document::clone(again.document());
    drop(again);
    let again = open(&path, saved, "3");
    assert!(again.found().is_none() && !again.is_changed());
}

#[test]
fn a_torn_end_is_dropped_and_written_on() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.journal");
    let mut editor = open(&path, Document::new(), "1");
    place(&mut editor, 1, "Panel");
    place(&mut editor, 2, "Panel");
    std::mem::forget(editor);
    let bytes = std::fs::read(&path).unwrap();
    std::fs::write(&path, &bytes[..bytes.len() - 3]).unwrap();
    let mut editor = open(&path, Document::new(), "1");
    assert_eq!(editor.document().objects.len(), 1);
    assert!(editor.found().unwrap().torn);
    place(&mut editor, 3, "Panel");
    std::mem::forget(editor);
    let editor = open(&path, Document::new(), "1");
    assert_eq!(editor.document().objects.len(), 2);
    assert!(!editor.found().unwrap().torn);
    drop(editor);
    // What is no journal at all is left behind, and that is said.
    std::fs::write(&path, b"something else").unwrap();
    let mut editor = open(&path, Document::new(), "1");
    assert!(editor.found().is_none() && editor.document().objects.is_empty());
    assert_eq!(editor.lost_journal(), Some("it is no journal"));
    place(&mut editor, 4, "Panel");
    std::mem::forget(editor);
    assert_eq!(open(&path, Document::new(), "1").document().objects.len(), 1);
}

#[test]
fn a_drag_is_written_while_it_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.journal");
    let mut editor = open(&path, Document::new(), "1");
    let slider = place(&mut editor, 1, "Number Slider");
    let start = std::time::Instant::now();
    let mut value = 0.0;
    let mut last_seen = start;
    while start.elapsed() < std::time::Duration::from_millis(900) {
        value = (value + 0.001) % 1.0;
        let edit = Edit::Set { object: slider, to: Setting::Number { value } };
        editor.apply(&edit, Some(1), &[]).unwrap();
        editor.tick();
        let bytes = std::fs::read(&path).unwrap().len();
        if bytes > 0 {
            last_seen = std::time::Instant::now();
        }
        std::thread::sleep(std::time::Duration::from_millis(4));
    }
    assert!(last_seen > start);
    std::thread::sleep(std::time::Duration::from_millis(160));
    editor.tick();
    let now = editor.document().to_gh().unwrap();
    let long = std::fs::read(&path).unwrap().len();
    std::mem::forget(editor);
    // A few records a second, not hundreds.
    assert!(long < 20_000, "{long}");
    let again = open(&path, Document::new(), "1");
    assert_eq!(again.document().to_gh().unwrap(), now);
    assert_eq!(again.found().unwrap().restored.steps, 2);
}

#[test]
fn a_folder_that_is_not_there_stops_the_journal_and_not_the_editing() {
    let mut editor = open(std::path::Path::new("/nowhere/at/all.journal"), Document::new(), "1");
    place(&mut editor, 1, "Panel");
    place(&mut editor, 2, "Panel");
    assert!(editor.journal_failure().is_some());
    assert_eq!(editor.document().objects.len(), 2);
}

#[test]
fn a_journal_that_cannot_be_read_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.journal");
    let mut editor = open(&path, Document::new(), "1");
    assert!(editor.lost_journal().is_none() && editor.state(&[]).unwrap().problems.is_empty());
    place(&mut editor, 1, "Panel");
    place(&mut editor, 2, "Panel");
    std::mem::forget(editor);
    let good = std::fs::read(&path).unwrap();
    let begin = 16 + u32::from_le_bytes(good[8..12].try_into().unwrap()) as usize;
    let flipped = |at: usize| {
        let mut bytes = good.clone();
        bytes[at] ^= 0xff;
        bytes
    };
    for (bytes, why) in [
        (b"garbage".to_vec(), "it is no journal"),
        (vec![0; 4096], "it is no journal"),
        (good[..20].to_vec(), "its beginning is damaged"),
        (flipped(30), "its beginning is damaged"),
        (flipped(begin + 20), "its edits are damaged"),
    ] {
        std::fs::write(&path, bytes).unwrap();
        let mut editor = open(&path, Document::new(), "1");
        assert_eq!(editor.lost_journal(), Some(why));
        assert!(editor.state(&[]).unwrap().problems.iter().any(|p| p.text.contains(why)), "{why}");
        // Once the document is saved there is nothing to be said any more.
        editor.note_saved(None);
        assert!(editor.lost_journal().is_none());
    }
    // One that ends in the middle of a record is restored up to there.
    std::fs::write(&path, &good[..good.len() - 3]).unwrap();
    let editor = open(&path, Document::new(), "1");
    assert!(editor.state(&[]).unwrap().problems.iter().any(|p| p.text.contains("damaged at its end")));
}
