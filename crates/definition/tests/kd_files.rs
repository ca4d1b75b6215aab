//! All real definitions through the text form and back.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod shared;

use std::collections::BTreeMap;

use katydid_definition::archive::{self, Chunk, ItemValue, Limits};
use katydid_definition::document::Document;
use katydid_definition::kd::{self, NoCatalogue};

/// Takes away what the text form says it leaves out, and what is compressed anew.
fn bare(chunk: &mut Chunk, parent: &str) {
    chunk.remove_children("Thumbnail");
    if ["param_input", "param_output", "InputParam", "OutputParam"].contains(&chunk.name.as_str()) {
        chunk.remove_children("Attributes");
    }
    if chunk.name == "Attributes" && parent == "Container" {
        chunk.remove("Selected");
    }
    if chunk.name == "Object" {
        chunk.index = None;
    }
    let open = chunk.bytes("ClusterDocument").and_then(|bytes| archive::read(bytes, &Limits::default()).ok());
    if let Some(mut inner) = open {
        chunk.set("ClusterDocument", ItemValue::ByteArray(Vec::new()));
        bare(&mut inner.root, "");
        chunk.chunks.push(inner.root);
    }
    let name = chunk.name.clone();
    chunk.chunks.iter_mut().for_each(|inner| bare(inner, &name));
    chunk.items.sort_by(|a, b| (&a.name, a.index).cmp(&(&b.name, b.index)));
    if chunk.name != "DefinitionObjects" {
        chunk.chunks.sort_by(|a, b| (&a.name, a.index).cmp(&(&b.name, b.index)));
    }
}

/// The first difference.
fn differ(a: &Chunk, b: &Chunk, path: &str) -> Option<String> {
    let path = format!("{path}/{}{:?}", a.name, a.index);
    for (x, y) in a.items.iter().zip(&b.items) {
        if x != y {
            return Some(format!("{path}: {x:?} became {y:?}"));
        }
    }
    if a.items.len() != b.items.len()
        || a.chunks.len() != b.chunks.len()
        || a.name != b.name
        || a.index != b.index
    {
        return Some(format!(
            "{path}: {} items, {} chunks became {}, {}",
            a.items.len(),
            a.chunks.len(),
            b.items.len(),
            b.chunks.len()
        ));
    }
    a.chunks.iter().zip(&b.chunks).find_map(|(x, y)| differ(x, y, &path))
}

#[test]
fn every_file_comes_back_whole() {
    let (mut files, mut objects, mut wires) = (0, 0, 0);
    let mut failed = Vec::new();
    let mut residue: BTreeMap<String, usize> = BTreeMap::new();
    let mut bytes = 0;
    for path in shared::definitions() {
        let Ok(document) = Document::read(&std::fs::read(&path).unwrap(), &Limits::default()) else {
            continue;
        };
        files += 1;
        objects += document.objects.len();
        wires += document.wires().count();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let written = match kd::write(&document, &NoCatalogue) {
            Ok(written) => written,
            Err(error) => {
                failed.push(format!("{name}: {error}"));
                continue;
            }
        };
        bytes += written.text.len();
        if let Some(folder) = std::env::var_os("KATYDID_KD_OUT") {
            let file = std::path::Path::new(&folder).join(format!("{files:03}-{name}.kd"));
            std::fs::write(file, &written.text).unwrap();
        }
        for line in written.text.lines().filter(|line| line.contains(" = ") && line.starts_with("        ")) {
            let key = line.trim().split(" = ").next().unwrap().to_owned();
            let key: String = key.chars().filter(|c| !c.is_ascii_digit()).collect();
            *residue.entry(key).or_default() += 1;
        }
        let again = match kd::read(&written.text, &NoCatalogue) {
            Ok(read) => read.document,
            Err(problems) => {
                let text = problems.to_string();
                failed.push(format!("{name}: {}", text.lines().take(6).collect::<Vec<_>>().join("\n")));
                continue;
            }
        };
        let tidy = kd::format(&written.text).unwrap();
        if tidy != written.text {
            failed.push(format!("{name}: not tidy"));
        }
        let (mut a, mut b) = (document.to_archive().root, again.to_archive().root);
        if a.child("Definition").is_none() {
            // A document that was a cluster stands in a file's tree now.
            assert_eq!(document.objects.len(), again.objects.len());
            continue;
        }
        bare(&mut a, "");
        bare(&mut b, "");
        failed.extend(differ(&a, &b, "").map(|what| format!("{name}: {what}")));
        let same = |a: &Document, b: &Document| {
            a.objects.iter().zip(&b.objects).all(|(x, y)| x.id == y.id) && a.wires().eq(b.wires())
        };
        assert!(same(&document, &again) || !failed.is_empty(), "{name}");
    }
    let mut residue: Vec<_> = residue.into_iter().collect();
    residue.sort_by_key(|(_, n)| std::cmp::Reverse(*n));
    for (key, n) in residue.iter().take(if std::env::var_os("KATYDID_KD_OUT").is_some() { 60 } else { 0 }) {
        println!("{n:>7} {key}");
    }
    println!("{files} files, {objects} objects, {wires} wires, {bytes} bytes of text");
    assert!(failed.is_empty(), "{} failed:\n{}", failed.len(), failed.join("\n"));
}
