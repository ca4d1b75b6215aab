//! The writer of .3dm archives refuses or survives breps that break the rules of validity.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

#[path = "../../geometry/tests/broken/mod.rs"]
mod broken;

use std::panic::{AssertUnwindSafe, catch_unwind};

use broken::{Dice, break_at_random, shapes, ways};
use katydid_3dm::{BrepObject, Limits, Model, ModelObject, Object};
use katydid_geometry::brep::Brep;

/// Writes a brep into archives of two versions, and reads them again.
fn there_and_back(name: &str, brep: &Brep) {
    let done = catch_unwind(AssertUnwindSafe(|| {
        for version in [50, 70] {
            let mut model = Model::default();
            let object = Object::Brep(Box::new(BrepObject::from(brep.clone())));
            model.objects.push(ModelObject::from(object));
            let mut file = Vec::new();
            if model.write_to(version, &mut file).is_ok() {
                let again = Model::read(&file, &Limits::default()).unwrap();
                assert_eq!(again.objects.len(), 1);
            }
        }
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
