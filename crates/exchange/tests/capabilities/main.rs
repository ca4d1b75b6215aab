//! What the kernel does with which surface: each operation is run on each kind, its result is held to a law, and the table in
//! docs/capabilities.md must say the same.
//!
//! `KATYDID_REFRESH_PAGES=1 cargo test -p katydid-exchange --test capabilities` writes the page anew.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod operations;
mod page;
mod subjects;

use operations::{Cell, OPERATIONS};

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/capabilities.md");

/// For each operation what came of it, kind by kind.
fn cells() -> Vec<Vec<Cell>> {
    let subjects = subjects::all();
    OPERATIONS
        .iter()
        .map(|(_, _, run)| subjects.iter().map(|subject| Cell::of(run(subject))).collect())
        .collect()
}

#[test]
fn the_page_says_what_each_operation_does() {
    let (names, cells) = (subjects::names(), cells());
    for ((name, _, _), row) in OPERATIONS.iter().zip(&cells) {
        for (kind, cell) in names.iter().zip(row) {
            assert!(!matches!(cell, Cell::Wrong(_)), "{name} of {kind}: {cell:?}");
        }
    }
    let written = page::written(&names, &cells);
    if std::env::var_os("KATYDID_REFRESH_PAGES").is_some() {
        std::fs::write(PAGE, &written).unwrap();
    }
    let page = std::fs::read_to_string(PAGE).unwrap_or_default();
    assert_eq!(
        page, written,
        "docs/capabilities.md is not what the kernel does: KATYDID_REFRESH_PAGES=1 writes it anew"
    );
}

#[test]
fn laws_find_what_is_wrong() {
    assert!(operations::near(1.0, 1.0 + 1e-9, 1e-6, "x").is_ok());
    assert!(matches!(Cell::of(operations::near(1.0, 1.1, 1e-6, "x").map_err(Into::into)), Cell::Wrong(_)));
}
