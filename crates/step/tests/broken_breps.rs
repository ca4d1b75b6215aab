//! The writer of STEP files refuses or survives breps that break the rules of validity.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

#[path = "../../geometry/tests/broken/mod.rs"]
mod broken;

use std::sync::Arc;

use broken::{each_at_random, each_way};
use katydid_geometry::brep::Brep;
use katydid_step::{Document, Part, Shape, read, write};

/// Writes a brep, and reads what was written.
fn there_and_back(brep: &Brep) {
    let parts = vec![Part::named("it", Shape::Brep(Arc::new(brep.clone())))];
    let document = Document { parts, ..Document::default() };
    let mut file = Vec::new();
    let left_out = write(&document, &mut file).unwrap();
    let again = read(&file).unwrap();
    // What is neither written nor told of would be lost.
    assert!(!again.parts.is_empty() || !left_out.is_empty() || !again.left_out.is_empty());
}

#[test]
fn broken_breps_are_refused_or_survived() {
    each_way(there_and_back);
    each_at_random(200, there_and_back);
}
