//! Real archives of every version, read, and what they hold written and read again.

mod common;

use std::collections::BTreeMap;

use katydid_3dm::{Error, Limits, MeshObject, Model, Object};

#[test]
fn every_archive_is_read() {
    let mut versions: BTreeMap<i32, usize> = BTreeMap::new();
    let mut classes: BTreeMap<String, usize> = BTreeMap::new();
    let mut kept = 0;
    for (path, bytes) in common::archives() {
        match Model::read(&bytes, &Limits::default()) {
            Ok(model) => {
                *versions.entry(model.archive_version).or_default() += 1;
                for (class, count) in model.counts() {
                    *classes.entry(class).or_default() += count;
                }
                for warning in &model.warnings {
                    println!("{}: {warning}", path.file_name().unwrap().display());
                    kept += usize::from(warning.message.contains("kept as bytes"));
                    assert!(!warning.message.contains("CRC"), "{}: {warning}", path.display());
                }
            }
            Err(error) => panic!("{}: {error}", path.display()),
        }
    }
    println!("archives by version: {versions:?}\nobjects by class: {classes:?}\nkept with a warning: {kept}");
}

/// What an archive of another version can carry comes back equal.
#[test]
fn what_is_written_is_read_back_equal() {
    for version in [4, 50, 60, 70, 80] {
        let (mut written, mut left) = (0, 0);
        for (path, bytes) in common::archives() {
            let Ok(mut model) = Model::read(&bytes, &Limits::default()) else { continue };
            let count = model.objects.len() + model.lights.len();
            model.objects.retain(|object| object.geometry.check_writable(version).is_ok());
            model.lights.retain(|light| light.geometry.check_writable(version).is_ok());
            left += count - model.objects.len() - model.lights.len();
            let again = Model::read(&model.write(version).unwrap(), &Limits::default()).unwrap();
            compare(&again, &model, &format!("{} as {version}", path.display()));
            written += model.objects.len() + model.lights.len();
        }
        println!("version {version}: {written} objects read back equal, {left} it cannot carry");
    }
}

fn compare(again: &Model, model: &Model, name: &str) {
    assert!(!again.warnings.iter().any(|w| w.message.contains("CRC")), "{name}: {:?}", again.warnings);
    assert_eq!((again.units, &again.unit_scale), (model.units, &model.unit_scale), "{name}");
    assert_eq!((again.tolerance, &again.notes), (model.tolerance, &model.notes), "{name}");
    if !model.layers.is_empty() {
        assert_eq!(again.layers.len(), model.layers.len(), "{name}");
    }
    for (ours, theirs) in again.layers.iter().zip(&model.layers) {
        assert_eq!(
            (&ours.name, ours.colour, ours.parent),
            (&theirs.name, theirs.colour, theirs.parent),
            "{name}"
        );
        assert_eq!((ours.visible, ours.locked), (theirs.visible, theirs.locked), "{name}");
    }
    let all = |m: &Model| m.objects.iter().chain(&m.lights).cloned().collect::<Vec<_>>();
    let (ours, theirs) = (all(again), all(model));
    assert_eq!(ours.len(), theirs.len(), "{name}");
    for (ours, mut theirs) in ours.into_iter().zip(theirs) {
        // Kept bytes say under which version they were read, which is another now.
        match (&ours.geometry, &theirs.geometry) {
            (Object::Kept(a), Object::Kept(b)) => assert_eq!(a.bytes, b.bytes, "{name}"),
            // Before version 60 boxes are in single precision, rounded outward, and n-gons in user data.
            (Object::Mesh(a), Object::Mesh(b)) if again.archive_version < 60 => {
                let ngons: Vec<_> =
                    ours.user_data.iter().filter_map(|data| data.ngons().unwrap()).flatten().collect();
                let all = [ngons.clone(), a.ngons.clone()].concat();
                let old = MeshObject { vertex_box: a.vertex_box, ngons: a.ngons.clone(), ..(**b).clone() };
                assert!(**a == old && (all == b.ngons || b.ngons.is_empty()), "{name}: a mesh");
            }
            (Object::Mesh(a), Object::Mesh(b)) => assert!(a == b, "{name}: a mesh"),
            (a, b) => assert_eq!(a, b, "{name}"),
        }
        // A second object with the same identifier gets another.
        theirs.attributes.id = ours.attributes.id;
        assert_eq!(ours.attributes, theirs.attributes, "{name}");
        // Before version 60 the double-precision vertices of a mesh are such data, made anew.
        if !matches!(ours.geometry, Object::Mesh(_)) {
            assert_eq!(ours.user_data, theirs.user_data, "{name}");
        }
    }
}

#[test]
fn kept_objects_of_another_length_width_are_refused_by_name() {
    let refused = common::archives().into_iter().find_map(|(_, bytes)| {
        let model = Model::read(&bytes, &Limits::default()).ok()?;
        let old = model.archive_version < 50 && model.counts().contains_key("Brep");
        old.then(|| model.write(70).unwrap_err())
    });
    if let Some(error) = refused {
        assert!(matches!(&error, Error::CannotWrite { what, .. } if what.contains("Brep")), "{error}");
    }
}
