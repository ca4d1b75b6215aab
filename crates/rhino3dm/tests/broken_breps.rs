//! The writer of .3dm archives refuses or survives breps that break the rules of validity.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

#[path = "../../geometry/tests/broken/mod.rs"]
mod broken;

use broken::{each_at_random, each_way};
use katydid_3dm::{BrepObject, Limits, Model, ModelObject, Object};
use katydid_geometry::brep::Brep;

/// Writes a brep into archives of two versions, and reads them again.
fn there_and_back(brep: &Brep) {
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
}

#[test]
fn broken_breps_are_refused_or_survived() {
    each_way(there_and_back);
    each_at_random(200, there_and_back);
}
