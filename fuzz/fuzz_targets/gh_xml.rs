//! XML text, read and written.

#![no_main]

use katydid_definition::archive::{self, Limits};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let limits = Limits { max_inflated: 1 << 24, max_nodes: 100_000, ..Limits::default() };
    let Ok(archive) = archive::read(data, &limits) else { return };
    let text = archive::write_ghx(&archive.root).expect("a tree from XML can be written as XML");
    let again = archive::read(text.as_bytes(), &limits).expect("what was written can be read");
    assert!(again.root == archive.root, "equal through XML");
    assert!(again.notes.is_empty());
    let tree = archive::write_binary_tree(&archive.root).expect("a tree from XML can be written as binary");
    let again = archive::read_binary_tree(&tree, &limits).expect("what was written can be read");
    assert!(again.root == archive.root, "equal through binary");
});
