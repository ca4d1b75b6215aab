//! Every real file: it is shown, an object of it moved, and put back to the same bytes.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::path::{Path, PathBuf};

use katydid_component::registry;
use katydid_definition::archive::{Chunk, Limits};
use katydid_definition::document::Document;
use katydid_session::Editor;
use katydid_session::protocol::{Connection, Edit, ObjectKindView};
use uuid::Uuid;

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let path = entry.path();
        if path.is_dir() {
            files(&path, found);
        } else if path
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("gh") || e.eq_ignore_ascii_case("ghx"))
        {
            found.push(path);
        }
    }
}

/// Objects are placed, wired, grouped and moved around what an add-on has put into the file; saved and opened again, that
/// is what it was. Then all is taken back.
fn edits_leave_unknown_objects_alone(editor: &mut Editor, path: &Path) {
    let unknown = |document: &Document| -> Vec<Chunk> {
        let objects = document.objects.iter();
        let unknown =
            objects.filter(|object| registry::by_guid(object.component).is_none() && !object.is_annotation());
        // Numbers among the objects change when some come.
        unknown.map(|object| Chunk { index: None, ..object.chunk().clone() }).collect()
    };
    let before = unknown(editor.document());
    let new = Uuid::from_u128(0xabc);
    let panel = registry::by_name("Panel").unwrap().guid;
    let from = editor.document().objects.iter().find_map(|object| object.outputs.first()).map(|port| port.id);
    let some: Vec<Uuid> = editor.document().objects.iter().take(3).map(|object| object.id).collect();
    let mut edits = vec![Edit::Place { id: new, component: panel, at: [0.0, 0.0], with: None }];
    edits.extend(from.map(|from| Edit::Connect { from, to: new, how: Connection::Replace }));
    edits.push(Edit::Group { id: Uuid::from_u128(0xabd), objects: some.clone() });
    edits.push(Edit::Arrange { objects: some, back: false });
    let made = edits.iter().filter(|edit| editor.apply(edit, None, &[]).is_ok_and(|c| !c.is_empty())).count();
    for bytes in [editor.document().to_gh().unwrap(), editor.document().to_ghx().unwrap().into_bytes()] {
        let again = Document::read(&bytes, &Limits::default()).unwrap();
        let (mut now, mut was) = (unknown(&again), before.clone());
        // Those that were moved to the front stand elsewhere.
        let id = |chunk: &Chunk| chunk.child("Container").and_then(|c| c.guid("InstanceGuid"));
        now.sort_by_key(id);
        was.sort_by_key(id);
        let xml = bytes.starts_with(b"<") || bytes.starts_with(b"\xef\xbb\xbf");
        assert!(xml || now == was, "{}", path.display());
        assert_eq!(now.len(), was.len(), "{}", path.display());
    }
    for _ in 0..made {
        editor.undo();
    }
}

#[test]
fn every_real_file_is_shown_edited_and_put_back() {
    katydid_components::link();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/gh");
    let mut all = Vec::new();
    files(&folder, &mut all);
    all.sort();
    if all.is_empty() {
        assert!(std::env::var_os("KATYDID_REQUIRE_SHARED").is_none(), "{} is absent", folder.display());
        println!("skipped: {} is absent", folder.display());
        return;
    }
    let (mut read, mut clusters) = (0, 0);
    for path in all {
        let bytes = std::fs::read(&path).unwrap();
        let Ok(document) = Document::read(&bytes, &Limits::default()) else { continue };
        read += 1;
        let before = document.to_bytes().unwrap();
        let mut editor = Editor::new(document, Default::default());
        let state = editor.state(&[]).unwrap();
        assert_eq!(state.objects.len(), editor.document().objects.len());
        for view in &state.objects {
            assert!(view.bounds.iter().all(|x| x.is_finite()), "{}: {}", path.display(), view.name);
        }
        serde_json::to_string(&state).unwrap();
        let movable = |kind: ObjectKindView| kind != ObjectKindView::Group;
        let Some(first) = state.objects.iter().find(|view| movable(view.kind)) else { continue };
        let [x, y, ..] = first.bounds;
        let edit = Edit::Move { objects: vec![(first.id, [x + 10.0, y - 3.0])] };
        let change = editor.apply(&edit, None, &[]).unwrap_or_else(|r| panic!("{}: {r}", path.display()));
        assert!(!change.is_empty(), "{}: {}", path.display(), first.name);
        assert_ne!(editor.document().to_bytes().unwrap(), before);
        editor.undo();
        assert!(editor.document().to_bytes().unwrap() == before, "{}", path.display());
        edits_leave_unknown_objects_alone(&mut editor, &path);
        assert!(editor.document().to_bytes().unwrap() == before, "{}", path.display());
        // All of it copied and pasted into nothing.
        let ids: Vec<Uuid> = state.objects.iter().map(|view| view.id).collect();
        let text = editor.copy(&ids, &[]).unwrap();
        let mut other = Editor::new(Document::new(), Default::default());
        let paste = Edit::Paste { text, at: Some([0.0, 0.0]), seed: Uuid::from_u128(9) };
        other.apply(&paste, None, &[]).unwrap_or_else(|r| panic!("{}: {r}", path.display()));
        for view in state.objects.iter().filter(|view| view.kind == ObjectKindView::Cluster) {
            let Ok(inside) = editor.state(&[view.id]) else { continue };
            clusters += 1;
            let Some(object) = inside.objects.iter().find(|view| movable(view.kind)) else { continue };
            let [x, y, ..] = object.bounds;
            let edit = Edit::Move { objects: vec![(object.id, [x + 1.0, y])] };
            editor.apply(&edit, None, &[view.id]).unwrap_or_else(|r| panic!("{}: {r}", path.display()));
            editor.undo();
        }
        assert!(editor.document().to_bytes().unwrap() == before, "{}", path.display());
    }
    println!("{read} files, {clusters} clusters entered");
    assert!(read > 200, "{read}");
}
