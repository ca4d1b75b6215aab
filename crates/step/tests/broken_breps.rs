//! The writer of STEP files refuses or survives breps that break the rules of validity.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

#[path = "../../geometry/tests/broken/mod.rs"]
mod broken;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use broken::{Dice, break_at_random, shapes, ways};
use katydid_geometry::brep::Brep;
use katydid_step::{Document, Part, Shape, read, write};

/// Writes a brep, and reads what was written.
fn there_and_back(name: &str, brep: &Brep) {
    let done = catch_unwind(AssertUnwindSafe(|| {
        let parts = vec![Part::named("it", Shape::Brep(Arc::new(brep.clone())))];
        let document = Document { parts, ..Document::default() };
        let mut file = Vec::new();
        let left_out = write(&document, &mut file).unwrap();
        let again = read(&file).unwrap();
        // What is neither written nor told of would be lost.
        assert!(!again.parts.is_empty() || !left_out.is_empty() || !again.left_out.is_empty());
    }));
    assert!(done.is_ok(), "{name}");
}

#[test]
fn broken_breps_are_refused_or_survived() {
    for (k, way) in ways().into_iter().enumerate() {
        for (name, brep) in shapes() {
            let mut parts = brep.into_parts();
            let changed = catch_unwind(AssertUnwindSafe(|| (way.change)(&mut parts)));
            let Ok(brep) = Brep::from_parts(parts) else { continue };
            if changed.is_ok() {
                there_and_back(&format!("{name} with way {k} ({}: {})", way.part, way.why), &brep);
            }
        }
    }
    let cases: u64 = std::env::var("KATYDID_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(200);
    for (name, brep) in shapes() {
        for seed in 0..cases {
            let mut parts = brep.clone().into_parts();
            break_at_random(&mut parts, &mut Dice(seed));
            if let Ok(brep) = Brep::from_parts(parts) {
                there_and_back(&format!("{name} broken by seed {seed}"), &brep);
            }
        }
    }
}
