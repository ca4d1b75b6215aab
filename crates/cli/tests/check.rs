//! `katydid check`: what would be missing without what is not supported.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use common::{definitions, katydid, said, shared, text};
use katydid_definition::document::Document;
use serde_json::Value;
use uuid::Uuid;

/// A component that nobody knows, between a slider and a panel, and a panel beside it.
const DEFINITION: &str = "katydid 1\n\
    a = Number Slider(2, 0..10)\n\
    m = Member @11111111-2222-4333-8444-555555555555(x = a) -> out\n\
    through = Panel(m)\n\
    aside = Panel(a)\n";

fn checked(words: &[&str]) -> Vec<Value> {
    let output = katydid(words);
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| panic!("{error}: {}", said(&output)))
}

#[test]
fn it_says_what_would_be_missing() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.kd");
    fs::write(&file, DEFINITION).unwrap();
    let entry = checked(&["check", "--json", text(&file)]).remove(0);
    let outputs = &entry["outputs"];
    assert_eq!((outputs["count"].as_u64(), outputs["whole"].as_u64()), (Some(2), Some(1)), "{entry}");
    assert_eq!(outputs["marked"], false);
    let missing = outputs["missing"].as_array().unwrap();
    assert_eq!(missing.len(), 1);
    assert_eq!((&missing[0]["name"], &missing[0]["component"]), (&"through".into(), &"Panel".into()));
    assert_eq!(missing[0]["needs"], serde_json::json!(["Member"]));
    let unsupported = &entry["unsupported"][0];
    assert_eq!(
        (unsupported["outputs"].as_u64(), unsupported["objects"].as_array().unwrap().len()),
        (Some(1), 1)
    );
    let told = katydid(&["check", text(&file)]);
    assert_eq!(told.status.code(), Some(1));
    let told = String::from_utf8(told.stdout).unwrap();
    assert!(told.contains("without them 1 of 2 outputs"), "{told}");
    assert!(told.contains("through (Panel) needs Member"), "{told}");
    assert!(!told.contains("aside"), "{told}");
}

#[test]
fn what_nothing_hangs_on_does_not_matter() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.kd");
    // The panel beside is the only output that is marked.
    fs::write(&file, format!("{DEFINITION}out = Context Print(aside)\n")).unwrap();
    let told = String::from_utf8(katydid(&["check", text(&file)]).stdout).unwrap();
    assert!(told.contains("runs without them: all 1 marked outputs are whole"), "{told}");
}

/// The ids of the objects that hang on some, by the wires of the document alone.
fn reached(document: &Document, from: &BTreeSet<Uuid>) -> BTreeSet<Uuid> {
    let lookup = document.lookup();
    let mut reached = from.clone();
    loop {
        let before = reached.len();
        for object in document.objects.iter().filter(|object| !object.locked) {
            let mut sources = object.inputs.iter().flat_map(|port| &port.sources);
            let hangs = sources.any(|id| {
                lookup.output(*id).is_some_and(|port| reached.contains(&document.objects[port.object].id))
            });
            if hangs {
                reached.insert(object.id);
            }
        }
        if reached.len() == before {
            return reached;
        }
    }
}

#[test]
fn real_files_hang_on_what_their_wires_say() {
    let Some(root) = shared("data/gh") else { return };
    let files = definitions(&root);
    let mut words = vec!["check", "--json"];
    words.extend(files.iter().map(|path| text(path)));
    let (mut compared, mut partly) = (0, 0);
    for entry in checked(&words).iter().filter(|entry| entry.get("error").is_none()) {
        let file = entry["file"].as_str().unwrap();
        let outputs = &entry["outputs"];
        let missing = outputs["missing"].as_array().unwrap();
        let count = outputs["count"].as_u64().unwrap();
        assert_eq!(outputs["whole"].as_u64().unwrap() + missing.len() as u64, count, "{file}");
        let kinds: BTreeMap<&str, &Value> = entry["unsupported"]
            .as_array()
            .unwrap()
            .iter()
            .map(|kind| (kind["name"].as_str().unwrap(), kind))
            .collect();
        for output in missing {
            let needs = output["needs"].as_array().unwrap();
            assert!(!needs.is_empty(), "{file}: {output}");
            assert!(needs.iter().all(|name| kinds.contains_key(name.as_str().unwrap())), "{file}: {output}");
        }
        if entry["runnable"] == true {
            assert!(missing.is_empty(), "{file}");
        }
        partly += usize::from(!missing.is_empty() && outputs["whole"] != 0);
        // What hangs on it by the wires alone, where no cluster and no loop has more to say.
        let Ok(document) = Document::read(&fs::read(Path::new(file)).unwrap(), &Default::default()) else {
            continue;
        };
        let is_plain = document
            .objects
            .iter()
            .all(|object| object.cluster(&Default::default()).is_none() && !object.name.contains("Loop"));
        if !is_plain {
            continue;
        }
        let ids = |value: &Value| value.as_str().unwrap().parse::<Uuid>().unwrap();
        let from: BTreeSet<Uuid> = kinds
            .values()
            .flat_map(|kind| kind["objects"].as_array().unwrap())
            .map(ids)
            .filter(|id| document.objects.iter().any(|object| object.id == *id && !object.locked))
            .collect();
        let hanging = reached(&document, &from);
        for output in missing {
            assert!(hanging.contains(&ids(&output["id"])), "{file}: {output}");
        }
        compared += 1;
    }
    println!("{compared} files compared, {partly} would give a part of their outputs");
    assert!(compared > 150 && partly > 10, "{compared} {partly}");
}
