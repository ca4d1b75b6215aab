//! A document: everything in it is looked at, some of it is changed, and it is saved.

#![no_main]

use katydid_definition::archive::{self, Limits};
use katydid_definition::document::{ClusterContent, Document, Mapping, Side, Stored};
use libfuzzer_sys::fuzz_target;

const LIMITS: Limits = Limits { max_inflated: 1 << 20, max_depth: 200, max_nodes: 100_000 };

fuzz_target!(|data: &[u8]| {
    let Ok(archive) = archive::read_binary_tree(data, &LIMITS) else { return };
    let root = archive.root.clone();
    let Ok(document) = Document::from_archive(archive) else { return };
    assert!(document.to_archive().root == root, "saved unchanged");
    look(&document, 0);
    change(document);
});

/// Reads all there is to read.
fn look(document: &Document, depth: usize) {
    let _ = (document.problems(), document.wires().count());
    for object in &document.objects {
        let _ = (object.special(), object.script(), object.hooks());
        for port in object.inputs.iter().chain(&object.outputs) {
            let Some(values) = object.persistent(port) else { continue };
            for item in values.branches.iter().flat_map(|branch| &branch.items) {
                if let Stored::Geometry(geometry) = item {
                    let _ = geometry.decode(&LIMITS);
                }
            }
            let _ = values.to_chunk(true);
        }
        if let (Some(Ok(ClusterContent::Open { document, .. })), true) = (object.cluster(&LIMITS), depth < 3)
        {
            look(&document, depth + 1);
        }
    }
}

/// Makes every change to every object, wanted or not.
fn change(mut document: Document) {
    for object in &mut document.objects {
        let _ = (object.set_slider(1.5), object.set_panel_text("x"), object.set_toggle(true));
        let _ = (object.select(&[0]), object.set_dial(1.5), object.set_gene(0, 1.5));
        let _ = (object.set_md_slider([0.5; 3]), object.set_mapping(Side::Input, 0, Mapping::Graft));
        object.move_by(1.0, 2.0);
        let values = object.inputs.first().and_then(|port| object.persistent(port));
        let _ = object.set_persistent(0, values.as_ref());
    }
    document.objects.pop();
    let bytes = document.to_gh().expect("a document can be saved");
    Document::read(&bytes, &Limits::default()).expect("a saved document can be read");
}
