//! Real archives of every version, read, and what they hold written and read again.

mod common;

use std::collections::BTreeMap;

use katydid_3dm::{
    BrepObject, Extrusion, Limits, MeshObject, Model, Object, OutlineContent, OutlineCrc, StoredFace,
    SubDObject, outline,
};

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
            compare(&again, &model, version, &format!("{} as {version}", path.display()));
            written += model.objects.len() + model.lights.len();
        }
        println!("version {version}: {written} objects read back equal, {left} it cannot carry");
    }
}

fn compare(again: &Model, model: &Model, version: i32, name: &str) {
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
            (Object::Brep(a), Object::Brep(b)) => compare_breps(a, b, version, name),
            (Object::Extrusion(a), Object::Extrusion(b)) => {
                let bare = |e: &Extrusion| Extrusion { meshes: Vec::new(), ..e.clone() };
                assert_eq!((bare(a), a.meshes.len()), (bare(b), b.meshes.len()), "{name}");
            }
            // Other forms of what archives before have no class for.
            (Object::Annotation5(a), Object::Annotation(b)) if version < 60 => {
                let words = if a.text.is_empty() { &a.text_formula } else { &a.text };
                let is_text = b.dimension().is_none();
                assert!(if is_text { *words == b.plain_text() } else { words.contains("<>") }, "{name}");
            }
            (Object::Brep(a), Object::Extrusion(b)) if version < 50 => {
                assert_eq!(a.brep.is_solid(), b.caps == [true; 2], "{name}");
            }
            // Archives before version 60 do not say whether a SubD can be made of a curve.
            (a, Object::CurveForm(b)) if version < 60 => {
                assert_eq!(a.curve().as_deref(), b.to_curve().ok().as_ref(), "{name}");
            }
            // Before version 60 boxes are in single precision, rounded outward, and n-gons in user data.
            (Object::Mesh(a), Object::Mesh(b)) if again.archive_version < 60 => {
                let ngons: Vec<_> =
                    ours.user_data.iter().filter_map(|data| data.ngons().ok()?).flatten().collect();
                let all = [ngons.clone(), a.ngons.clone()].concat();
                let old = MeshObject { vertex_box: a.vertex_box, ngons: a.ngons.clone(), ..(**b).clone() };
                assert!(**a == old && (all == b.ngons || b.ngons.is_empty()), "{name}: a mesh");
            }
            (Object::Mesh(a), Object::Mesh(b)) => assert!(a == b, "{name}: a mesh"),
            (Object::SubD(a), Object::SubD(b)) => {
                let mut held = subd_in(b, version);
                // Where nothing is known an archive says so.
                held.symmetry = held.symmetry.or_else(|| a.symmetry.clone());
                held.packing.hash = held.packing.hash.or_else(|| a.packing.hash.clone());
                assert!(**a == held, "{name}: a SubD");
            }
            (a, b) => assert_eq!(a, b, "{name}"),
        }
        // A second object with the same identifier gets another.
        theirs.attributes.id = ours.attributes.id;
        assert_eq!(ours.attributes, theirs.attributes, "{name}");
        // Before version 60 the double-precision vertices of a mesh are such data, made anew.
        if !matches!(ours.geometry, Object::Mesh(_) | Object::Annotation5(_)) {
            assert_eq!(ours.user_data, theirs.user_data, "{name}");
        }
    }
}

/// What an archive of the version holds of a SubD: the points that were saved before version 70, packing, texture and
/// channels from then on, the sharpness of both ends of an edge from version 80 on.
fn subd_in(subd: &SubDObject, version: i32) -> SubDObject {
    let mut held = if version < 70 { SubDObject::default() } else { subd.clone() };
    held.levels = subd.levels.clone();
    for level in &mut held.levels {
        for face in level.faces.iter_mut().filter(|_| version < 70) {
            let (part, edges) = (face.part.clone(), face.edges.clone());
            *face =
                StoredFace { part, edges, level_zero_face: face.level_zero_face, ..StoredFace::default() };
        }
        for edge in level.edges.iter_mut().filter(|_| version < 80) {
            edge.sharpness[1] = edge.sharpness[0];
        }
        let parts = level.vertices.iter_mut().map(|v| &mut v.part);
        let parts = parts.chain(level.edges.iter_mut().map(|e| &mut e.part));
        for part in parts.chain(level.faces.iter_mut().map(|f| &mut f.part)) {
            if version < 70 {
                (part.group, part.symmetry_next) = (0, None);
            } else {
                part.saved_point = None;
            }
        }
    }
    held
}

/// Breps but for what an archive of the version does not hold, and for the numbers in meshes beside them.
fn compare_breps(ours: &BrepObject, theirs: &BrepObject, version: i32, name: &str) {
    let mut parts = theirs.brep.clone().into_parts();
    if version < 70 {
        parts.faces.iter_mut().for_each(|face| face.colour = None);
    }
    if version < 50 {
        parts.regions = None;
    }
    assert_eq!(ours.brep.parts(), &parts, "{name}");
    if version >= 60 {
        assert_eq!(ours.odd_curves_2d, theirs.odd_curves_2d, "{name}");
        assert_eq!(ours.odd_curves_3d, theirs.odd_curves_3d, "{name}");
    }
    assert_eq!(ours.odd_surfaces, theirs.odd_surfaces, "{name}");
    let there = |meshes: &[Option<_>]| meshes.iter().map(Option::is_some).collect::<Vec<bool>>();
    assert_eq!(there(&ours.render_meshes), there(&theirs.render_meshes), "{name}");
    assert_eq!(there(&ours.analysis_meshes), there(&theirs.analysis_meshes), "{name}");
}

/// Bytes that an archive of another version cannot hold are taken apart and written anew.
#[test]
fn kept_objects_of_another_length_width_are_rewritten() {
    let mut checked = 0;
    for (path, bytes) in common::archives() {
        let Ok(model) = Model::read(&bytes, &Limits::default()) else { continue };
        for object in model.objects.iter().filter(|o| matches!(o.geometry, Object::Brep(_))).take(3) {
            for (from, to) in [(4, 70), (80, 4), (80, 60)] {
                let raw = object.geometry.to_raw(from, &object.user_data).unwrap();
                let kept = Object::Kept(raw);
                kept.check_writable(to).unwrap();
                let archive = Model { objects: vec![kept.into()], ..Model::default() }.write(to).unwrap();
                let back = Model::read(&archive, &Limits::default()).unwrap();
                let (Object::Brep(ours), Object::Brep(theirs)) =
                    (&back.objects[0].geometry, &object.geometry)
                else {
                    panic!("{}: no brep came back", path.display())
                };
                compare_breps(ours, theirs, from.min(to), &path.display().to_string());
                checked += 1;
            }
        }
    }
    println!("{checked} kept breps rewritten");
}

/// What rhino3dm calls a valid brep is one here, and the other way round, but for what only one of them checks.
#[test]
fn breps_of_real_archives_have_few_faults() {
    let (mut breps, mut faulty) = (0, 0);
    for (path, bytes) in common::archives() {
        let Ok(model) = Model::read(&bytes, &Limits::default()) else { continue };
        for (i, object) in model.objects.iter().enumerate() {
            let Object::Brep(object) = &object.geometry else { continue };
            breps += 1;
            let faults = object.brep.faults();
            if let Some(first) = faults.first() {
                faulty += 1;
                println!("{} object {i}: {} faults, the first: {first}", path.display(), faults.len());
            }
        }
    }
    println!("{breps} breps, {faulty} of them with faults");
    assert!(faulty * 20 <= breps, "{faulty} of {breps}");
}

#[test]
fn no_checksum_of_a_real_archive_is_called_wrong() {
    for (path, bytes) in common::archives() {
        let mut wrong = Vec::new();
        let seen = outline(&bytes, 20, |chunk| {
            if matches!(chunk.content, OutlineContent::Body { crc: OutlineCrc::Wrong, .. }) {
                wrong.push((chunk.offset, chunk.typecode));
            }
        });
        seen.unwrap();
        assert!(wrong.is_empty(), "{}: {wrong:X?}", path.display());
    }
}
