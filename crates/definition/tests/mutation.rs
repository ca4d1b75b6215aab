//! Real files with bytes changed: they open or fail with an error, and never panic.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod shared;

use std::sync::OnceLock;

use katydid_definition::Error;
use katydid_definition::archive::{self, Limits};
use katydid_definition::document::{ClusterContent, Document, Stored};
use proptest::prelude::*;
use uuid::Uuid;

fn open(bytes: &[u8]) -> Result<Document, Error> {
    Document::read(bytes, &Limits::default())
}

/// Looks at all there is in a document, and saves it.
fn touch(document: &Document, depth: usize) {
    let limits = Limits { max_inflated: 1 << 20, ..Limits::default() };
    let _ = (document.problems(), document.wires().count());
    for object in &document.objects {
        let _ = (object.special(), object.script(), object.hooks(), object.title());
        for port in object.inputs.iter().chain(&object.outputs) {
            for item in object.persistent(port).iter().flat_map(|v| &v.branches).flat_map(|b| &b.items) {
                if let Stored::Geometry(geometry) = item {
                    let _ = geometry.decode(&limits);
                }
            }
        }
        if let (Some(Ok(ClusterContent::Open { document, .. })), true) = (object.cluster(&limits), depth < 3)
        {
            touch(&document, depth + 1);
        }
    }
    let archive = document.to_archive();
    let again = open(&document.to_gh().unwrap()).unwrap();
    assert!(again.to_archive().root == archive.root);
    let mut edited = document.clone();
    for object in &mut edited.objects {
        let _ = (object.set_slider(1.0), object.set_panel_text("x"), object.set_toggle(true));
        let _ = (object.select(&[0]), object.set_dial(1.0), object.set_gene(0, 1.0));
        object.move_by(1.0, 2.0);
        let _ = (object.set_persistent(0, None), object.set_sources(0, &[Uuid::nil()]));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn mutated_files_never_panic(
        file in any::<prop::sample::Index>(),
        flips in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..12),
        inside in any::<bool>(),
    ) {
        let small = small();
        if small.is_empty() {
            return Ok(());
        }
        let (whole, tree) = &small[file.index(small.len())];
        let mut bytes = if inside { tree.clone() } else { whole.clone() };
        for (at, byte) in flips {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        let limits = Limits { max_inflated: 16 << 20, ..Limits::default() };
        let archive =
            if inside { archive::read_binary_tree(&bytes, &limits) } else { archive::read(&bytes, &limits) };
        if let Ok(document) = archive.and_then(Document::from_archive) {
            touch(&document, 0);
        }
    }
}

/// Small real files, whole and as a bare tree.
fn small() -> &'static [(Vec<u8>, Vec<u8>)] {
    static SMALL: OnceLock<Vec<(Vec<u8>, Vec<u8>)>> = OnceLock::new();
    SMALL.get_or_init(|| {
        let files = shared::definitions();
        let files = files.iter().filter(|path| std::fs::metadata(path).unwrap().len() < 40_000).step_by(3);
        files
            .map(|path| std::fs::read(path).unwrap())
            .map(|bytes| {
                let root = archive::read(&bytes, &Limits::default()).unwrap().root;
                (bytes, archive::write_binary_tree(&root).unwrap())
            })
            .collect()
    })
}
