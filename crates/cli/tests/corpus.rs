//! Real definitions at hand through `check` and `convert`; `real_files.rs` runs all of them.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use common::{definitions, katydid, said, shared, text};
use serde_json::Value;

/// The files that use stock components only.
fn targets(root: &Path) -> Vec<PathBuf> {
    let index = std::fs::read_to_string(root.join("index.csv")).unwrap();
    let mut lines = index.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let column = header.iter().position(|c| *c == "runnable_target").unwrap();
    // File names have no commas; a licence may, so the column is counted from the end.
    let from_end = header.len() - column;
    lines
        .filter(|line| line.rsplit(',').nth(from_end - 1) == Some("yes"))
        .map(|line| root.join(line.split(',').next().unwrap()))
        .collect()
}

#[test]
fn check_knows_most_objects_of_the_stock_files() {
    let Some(root) = shared("data/gh") else { return };
    let targets = targets(&root);
    assert_eq!(targets.len(), 92);
    let mut words = vec!["check", "--json"];
    words.extend(targets.iter().map(|path| text(path)));
    let output = katydid(&words);
    let entries: Vec<Value> = serde_json::from_slice(&output.stdout).unwrap();
    let (mut objects, mut missing, mut whole) = (0, 0, Vec::new());
    let mut wanted: BTreeMap<String, u64> = BTreeMap::new();
    for entry in &entries {
        assert!(entry.get("error").is_none(), "{entry}");
        objects += entry["objects"].as_u64().unwrap();
        for unsupported in entry["unsupported"].as_array().unwrap() {
            let count = unsupported["count"].as_u64().unwrap();
            missing += count;
            *wanted.entry(unsupported["name"].to_string()).or_default() += count;
        }
        if entry["runnable"] == true {
            whole.push(entry["file"].as_str().unwrap().to_owned());
        }
    }
    let share = 100.0 * (objects - missing) as f64 / objects as f64;
    println!(
        "{} of {objects} objects supported ({share:.1} %), {} files whole",
        objects - missing,
        whole.len()
    );
    let mut wanted: Vec<(u64, String)> = wanted.into_iter().map(|(name, n)| (n, name)).collect();
    wanted.sort_by(|a, b| b.cmp(a));
    wanted.iter().take(40).for_each(|(n, name)| println!("  {n:>4} × {name}"));
    assert!(share >= 60.0, "only {share:.1} %");
    assert!(whole.len() >= 12, "only {} files", whole.len());
    let mut failed = Vec::new();
    for file in whole {
        let output = katydid(&["run", &file]);
        // A definition that reads a file which was never handed on with it can only say so.
        let told = said(&output);
        let mut errors = told.lines().filter(|line| line.starts_with("error: "));
        let lacks_only_files =
            told.contains("error: ") && errors.all(|e| e.ends_with("there is no such file"));
        if output.status.code() != Some(0) && !lacks_only_files {
            failed.push(format!("{file}: {:?} {told}", output.status.code()));
        }
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}

#[test]
fn converting_there_and_back_changes_nothing() {
    let Some(root) = shared("data/gh") else { return };
    let folder = tempfile::tempdir().unwrap();
    let (there, back) = (folder.path().join("there.ghx"), folder.path().join("back.gh"));
    let all = definitions(&root);
    for file in all.iter().filter(|f| f.extension().is_some_and(|e| e == "gh")).step_by(9) {
        for (from, to) in [(file, &there), (&there, &back)] {
            let output = katydid(&["convert", text(from), text(to)]);
            assert_eq!(output.status.code(), Some(0), "{}: {}", file.display(), said(&output));
        }
        let tree = |path: &Path| {
            katydid_definition::archive::read(&std::fs::read(path).unwrap(), &Default::default())
                .unwrap()
                .root
        };
        assert_eq!(tree(file), tree(&back), "{}", file.display());
    }
}
