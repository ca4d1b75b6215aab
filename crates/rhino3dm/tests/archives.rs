//! Real archives of every version, read, and what they hold written and read again.

mod common;

use std::collections::BTreeMap;

use katydid_3dm::{Error, Limits, Model, Object};

#[test]
fn every_archive_but_version_1_is_read() {
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
            Err(Error::UnsupportedVersion(1)) => *versions.entry(1).or_default() += 1,
            Err(error) => panic!("{}: {error}", path.display()),
        }
    }
    println!("archives by version: {versions:?}\nobjects by class: {classes:?}\nkept with a warning: {kept}");
}

/// What can be written to a version 70 archive comes back equal.
#[test]
fn what_is_written_is_read_back_equal() {
    let (mut written, mut left) = (0, 0);
    for (path, bytes) in common::archives() {
        let Ok(mut model) = Model::read(&bytes, &Limits::default()) else { continue };
        let count = model.objects.len() + model.lights.len();
        let fits = |geometry: &Object| geometry.to_on_data(70).is_ok_and(|o| o.archive3dm >= 50);
        model.objects.retain(|object| fits(&object.geometry) && is_writable(&object.geometry));
        model.lights.retain(|light| fits(&light.geometry));
        let again = Model::read(&model.write(70).unwrap(), &Limits::default()).unwrap();
        let name = path.display();
        assert_eq!(again.warnings.iter().filter(|w| w.message.contains("CRC")).count(), 0, "{name}");
        assert_eq!(
            (again.units, again.tolerance, &again.notes),
            (model.units, model.tolerance, &model.notes)
        );
        if !model.layers.is_empty() {
            assert_eq!(again.layers.len(), model.layers.len(), "{name}");
        }
        for (ours, theirs) in again.layers.iter().zip(&model.layers) {
            assert_eq!((&ours.name, ours.colour, ours.parent), (&theirs.name, theirs.colour, theirs.parent));
        }
        let pairs = |a: &Model| a.objects.iter().chain(&a.lights).cloned().collect::<Vec<_>>();
        let (ours, theirs) = (pairs(&again), pairs(&model));
        assert_eq!(ours.len(), theirs.len(), "{name}");
        for (ours, mut theirs) in ours.into_iter().zip(theirs) {
            // Kept bytes say under which version they were read: now 70.
            match (&ours.geometry, &mut theirs.geometry) {
                (Object::Kept(a), Object::Kept(b)) => assert_eq!(a.bytes, b.bytes, "{name}"),
                (a, b) => assert_eq!(a, b, "{name}"),
            }
            let same_id = ours.attributes.id == theirs.attributes.id;
            theirs.attributes.id = ours.attributes.id;
            assert_eq!(ours.attributes, theirs.attributes, "{name}");
            assert_eq!(ours.user_data, theirs.user_data, "{name}");
            left += usize::from(!same_id);
            written += 1;
        }
        left += count - model.objects.len() - model.lights.len();
    }
    println!("{written} objects written and read back equal; {left} left out or given a new identifier");
}

/// SubD bytes of versions before 70 do not fit later archives.
fn is_writable(geometry: &Object) -> bool {
    !matches!(geometry, Object::Kept(raw) if raw.class_name() == "SubD" && raw.archive_version < 70)
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
