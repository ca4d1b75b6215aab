//! What all real definitions at hand say when they are run.
//!
//! Every warning, error and null is followed to its root: the object that has trouble though nothing upstream has. Each
//! root stands in `real_files.txt` with its reason; a root without a reason fails, and so does a reason without a root.
//! What is unsupported needs no row: `unsupported.rs` and the names of plug-ins say it.
//!
//! `KATYDID_REFRESH_REAL_FILES=1 cargo test -p katydid --test real_files` writes the list anew; new rows have the reason
//! `?`, which is not accepted.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::collections::{BTreeMap, HashMap, HashSet};
use std::time::Duration;

use common::{definitions, said, shared, text, within};
use katydid_definition::document::{Document, Side};
use serde_json::Value;
use uuid::Uuid;

/// The list: a row a root, its columns parted by tabs.
const LIST: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/real_files.txt");

/// The reasons that a row may have: it lies behind a plug-in, a script or a boolean of solids inside a cluster; a Rhino
/// model, a file or a server is missing; nobody gave an input its data; the author's definition says so in Grasshopper
/// too; or nulls are what the component is for.
const REASONS: [&str; 9] =
    ["plug-in", "script", "solids", "model", "file", "server", "input", "author", "design"];

/// What is wrong with an object by itself: its first warning or error, else that it gives nulls.
fn trouble(object: &Value) -> Option<String> {
    let messages = object["messages"].as_array().unwrap();
    if let Some(first) = messages.iter().find(|m| m["level"] == "warning" || m["level"] == "error") {
        return Some(plain(first["text"].as_str().unwrap()));
    }
    let items = items(object);
    items.contains(&"null").then(|| "gives nulls".to_owned())
}

/// The texts of all items that an object gives.
fn items(object: &Value) -> Vec<&str> {
    let outputs = object["outputs"].as_array().unwrap().iter();
    let branches = outputs.flat_map(|output| output["branches"].as_array().unwrap());
    branches.flat_map(|branch| branch["items"].as_array().unwrap()).filter_map(Value::as_str).collect()
}

/// A message up to its first number or id, so that the list does not hang on them.
fn plain(text: &str) -> String {
    let end = text.find(|c: char| c.is_ascii_digit() || c == '\n').unwrap_or(text.len());
    text[..end]
        .split(':')
        .take(2)
        .collect::<Vec<_>>()
        .join(":")
        .trim_end_matches([' ', '{', '(', '-'])
        .to_owned()
}

/// The roots of one file, each as the name of its component and what is wrong.
fn roots(report: &Value, document: &Document) -> Vec<(String, String)> {
    let objects = report["objects"].as_array().unwrap();
    let id = |object: &Value| object["id"].as_str().unwrap().parse::<Uuid>().unwrap();
    let mut owner: HashMap<Uuid, Uuid> = HashMap::new();
    let mut sources: HashMap<Uuid, Vec<Uuid>> = HashMap::new();
    for object in &document.objects {
        owner.insert(object.id, object.id);
        owner.extend(object.ports(Side::Output).iter().map(|port| (port.id, object.id)));
        let wires = object.ports(Side::Input).iter().flat_map(|port| port.sources.iter().copied());
        sources.insert(object.id, wires.collect());
    }
    let troubled: HashSet<Uuid> = objects
        .iter()
        .filter(|o| trouble(o).is_some() || (o["outputs"] != Value::Array(vec![]) && items(o).is_empty()))
        .map(id)
        .collect();
    let mut roots = Vec::new();
    for object in objects.iter().filter(|o| o["kind"] != "annotation" && o["status"] != "unsupported") {
        let Some(what) = trouble(object) else { continue };
        let me = id(object);
        let above = sources.get(&me).into_iter().flatten().filter_map(|source| owner.get(source));
        if !above.into_iter().any(|source| *source != me && troubled.contains(source)) {
            roots.push((object["name"].as_str().unwrap().to_owned(), what));
        }
    }
    roots
}

#[test]
fn every_message_and_null_of_real_files_has_a_reason() {
    let Some(root) = shared("data/gh") else { return };
    let all = definitions(&root);
    assert_eq!(all.len(), 273);
    let mut failed = Vec::new();
    let mut found: BTreeMap<(String, String, String), usize> = BTreeMap::new();
    for file in &all {
        let name = text(file.strip_prefix(&root).unwrap()).to_owned();
        let words = ["run", text(file), "--json", "--limit-seconds", "15"];
        let Some(output) = within(Duration::from_secs(40), &words) else {
            failed.push(format!("{name}: hangs"));
            continue;
        };
        let stderr = said(&output);
        if stderr.contains("Internal error") || stderr.contains("panicked") {
            failed.push(format!("{name}: {stderr}"));
        }
        let Ok(report) = serde_json::from_slice::<Value>(&output.stdout) else {
            failed.push(format!("{name}: no report: {stderr}"));
            continue;
        };
        let document = Document::read(&std::fs::read(file).unwrap(), &Default::default()).unwrap();
        for (component, what) in roots(&report, &document) {
            *found.entry((name.clone(), component, what)).or_default() += 1;
        }
    }
    assert!(failed.is_empty(), "{} files:\n{}", failed.len(), failed.join("\n"));
    let list = std::fs::read_to_string(LIST).unwrap_or_default();
    let known: BTreeMap<(String, String, String), &str> = list
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| match line.split('\t').collect::<Vec<_>>().as_slice() {
            [file, component, what, reason] => {
                (((*file).to_owned(), (*component).to_owned(), (*what).to_owned()), *reason)
            }
            _ => panic!("not four columns: {line}"),
        })
        .collect();
    if std::env::var_os("KATYDID_REFRESH_REAL_FILES").is_some() {
        let head: String = list.lines().filter(|l| l.starts_with('#')).map(|l| format!("{l}\n")).collect();
        let rows: String = found
            .keys()
            .map(|key| format!("{}\t{}\t{}\t{}\n", key.0, key.1, key.2, known.get(key).unwrap_or(&"?")))
            .collect();
        std::fs::write(LIST, head + &rows).unwrap();
        return;
    }
    let new: Vec<_> = found.keys().filter(|key| !known.contains_key(key)).collect();
    let gone: Vec<_> = known.keys().filter(|key| !found.contains_key(key)).collect();
    let unexplained: Vec<_> = known.iter().filter(|(_, reason)| !REASONS.contains(reason)).collect();
    println!("{} roots in {} files", found.values().sum::<usize>(), all.len());
    assert!(new.is_empty(), "without a reason: {new:#?}");
    assert!(gone.is_empty(), "no longer found: {gone:#?}");
    assert!(unexplained.is_empty(), "no known reason: {unexplained:#?}");
}
