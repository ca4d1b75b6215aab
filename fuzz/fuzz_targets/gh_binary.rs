//! A binary tree, read and written.

#![no_main]

use katydid_definition::archive::{self, Limits};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let limits = Limits { max_inflated: 1 << 24, max_nodes: 100_000, ..Limits::default() };
    let _ = archive::read(data, &limits);
    let Ok(archive) = archive::read_binary_tree(data, &limits) else { return };
    let written = archive::write_binary_tree(&archive.root).expect("a tree that was read can be written");
    if archive.notes.is_empty() {
        assert!(written == data, "the same bytes");
    }
    let again = archive::read_binary_tree(&written, &limits).expect("what was written can be read");
    assert!(again.root == archive.root);
});
